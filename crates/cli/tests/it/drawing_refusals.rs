//! Drawings that are none of a part: exit code 1, what is wrong and where, nothing written.

use crate::run::{Folder, assert_says};
use crate::sketch::{dxf, loop_of, with_tables};

const MM: Option<u8> = Some(4);
const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];

/// Runs `optimize` on a bad drawing; returns the message.
fn refused(name: &str, file: &str, content: &str, options: &str) -> String {
    let folder = Folder::new(&format!("drawing-refused-{name}"));
    folder.write(file, content);
    let ran =
        folder.run(&format!("optimize {file} --fingers 4 --stiffness 1 --svg p.svg{options}"));
    assert_eq!(folder.names(), [file], "{name}");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{name}: {}", ran.err);
    ran.err
}

#[test]
fn contours_that_are_none() {
    let square = || loop_of("A", &SQUARE);
    let at = |d: f64| loop_of("B", &SQUARE.map(|[x, y]| [x / 4.0 + d, y / 4.0 + d]));
    let open = "LINE A 5 1F 10 0 20 0 11 9 21 0\nLINE A 10 9 20 0 11 9 21 9\n\
                ARC B 10 0 20 0 40 9 50 91 51 180\nTEXT N 1 X";
    for (name, entities, pieces) in [
        (
            "open",
            open.to_owned(),
            &[
                "the LINE `1F` at line 28, on layer `A` ends at (0, 0), where nothing goes on",
                "the nearest other end is 9 away, that of the ARC at line 54, on layer `B`",
                "left aside: 1 TEXT on layer `N` (no curve)",
                "--layer",
            ][..],
        ),
        (
            "branch",
            square() + "LINE C 10 0 20 0 11 5 21 5",
            &["three ends meet at (0, 0)", "the LINE at line 28, on layer `A`", "on layer `C`"],
        ),
        (
            "short",
            square() + "LINE C 10 5 20 5 11 5 21 5",
            &["layer `C` is not longer than 0.00141"],
        ),
        ("second", square() + &at(20.0), &["two parts, expected one", "layer `B` is not inside"]),
        (
            "island",
            square() + &at(2.0) + &loop_of("C", &[[3.0, 3.0], [4.0, 3.0], [3.0, 4.0]]),
            &["layer `C` is inside the hole with the LINE", "on layer `B`"],
        ),
        (
            "crossing",
            square() + &at(9.0),
            &["on layer `A` and the LINE", "on layer `B` cross or touch near"],
        ),
        (
            "bow",
            loop_of("A", &[[0.0, 0.0], [9.0, 9.0], [9.0, 0.0], [0.0, 8.0]]),
            &["cross or touch near"],
        ),
        (
            "text",
            "TEXT N 1 X".to_owned(),
            &["no curves that could be the outline, only 1 TEXT on layer `N` (no curve)"],
        ),
        ("nothing", String::new(), &["no curves that could be the outline"]),
        (
            "flat",
            "LINE A 10 0 20 0 11 9 21 0\nLINE A 10 9 20 0 11 5 21 0\nLINE A 10 5 20 0 11 0 21 0"
                .to_owned(),
            &["lie on one line"],
        ),
        ("layer", square(), &["nothing on layer `WALL`, expected one of its layers: `A`"]),
        (
            "tiny-chord",
            "CIRCLE A 10 0 20 0 40 5".to_owned(),
            &["the CIRCLE at line 28", "beyond 100000", "chord of 1e-13"],
        ),
    ] {
        let options = match name {
            "layer" => " --layer WALL",
            "tiny-chord" => " --chord 1e-13",
            _ => "",
        };
        let message = refused(name, "part.dxf", &dxf(MM, &entities), options);
        assert_says(&message, &["part.dxf: "]);
        assert_says(&message, pieces);
    }
}

#[test]
fn entities_that_are_none() {
    for (name, entities, piece) in [
        ("nan", "CIRCLE A 10 nan 20 0 40 5", "line 32: found `nan`, expected a number up to 1e100"),
        ("huge", "CIRCLE A 10 0 20 0 40 1e300", "line 36: found `1e300`, expected a number"),
        (
            "missing",
            "CIRCLE A 10 0 20 0",
            "line 28: the CIRCLE has no value with the group code 40",
        ),
        ("radius", "CIRCLE A 10 0 20 0 40 -5", "line 28: the CIRCLE has the radius -5"),
        ("length", "LWPOLYLINE A 90 2 70 1 10 4 20 4 10 4 20 4", "the LWPOLYLINE has no length"),
        ("degree", "SPLINE A 71 0 10 0 20 0", "the SPLINE has the degree 0, expected one from 1"),
        ("few", "SPLINE A 71 3 10 0 20 0 10 1 20 1", "has 2 control points, expected at least 4"),
        ("knots", "SPLINE A 71 1 40 0 40 1 10 0 20 0 10 1 20 1", "2 knots, expected 4 knots"),
        (
            "down",
            "SPLINE A 71 1 40 0 40 0 40 1 40 0 10 0 20 0 10 1 20 1",
            "do not ascend, at number 3",
        ),
        (
            "weight",
            "SPLINE A 71 1 40 0 40 0 40 1 40 1 41 1 41 0 10 0 20 0 10 1 20 1",
            "has the weight 0",
        ),
        (
            "weights",
            "SPLINE A 71 1 40 0 40 0 40 1 40 1 41 1 10 0 20 0 10 1 20 1",
            "1 weights for 2",
        ),
        (
            "torn",
            "SPLINE A 71 1 40 0 40 0 40 1 40 1 40 2 40 2 10 0 20 0 10 1 20 1 10 2 20 2 10 3 20 0",
            "is torn at knot 3",
        ),
        (
            "fit",
            "SPLINE A 71 3 11 5 21 5 11 5 21 5",
            "has 2 points to go through, expected at least 2",
        ),
        ("block", "INSERT A 2 NUT 10 0 20 0", "line 28: there is no block `NUT`"),
        ("rows", "INSERT A 2 A 10 0 20 0 70 30000 71 30000", "more than 100000 entities"),
        ("within", "INSERT A 2 B 10 0 20 0", "line 26: the block `B` is within itself"),
    ] {
        let blocks = "BLOCK - 2 A\nINSERT 0 2 B\nENDBLK -\nBLOCK - 2 B\nINSERT 0 2 A\nENDBLK -";
        let blocks = if matches!(name, "rows" | "within") { blocks } else { "" };
        let message = refused(name, "part.dxf", &with_tables(MM, "", blocks, entities), "");
        assert_says(&message, &["part.dxf: ", piece]);
    }
}

#[test]
fn files_that_are_no_drawings() {
    let square = dxf(MM, &loop_of("A", &SQUARE));
    let cut = square.replace("0\nEOF\n", "");
    for (name, file, content, piece) in [
        ("cut", "a.dxf", cut.as_str(), "the file ends here without `EOF`: is it cut off?"),
        ("words", "a.dxf", "a drawing\n", "line 1: found `a drawing`, expected a group code"),
        ("empty", "a.dxf", " \n", "is empty, expected a drawing"),
        ("dwg", "a.dxf", "AC1015\0\0", "is a DWG file, expected DXF in text form"),
        ("binary", "a.dxf", "AutoCAD Binary DXF\r\n\x1a\0", "is a binary DXF file"),
        ("xml", "a.svg", "<svg><g></svg>", "is not valid XML"),
        ("html", "a.svg", "<html/>", "has the root element `html`, expected svg"),
        (
            "no-unit",
            "a.dxf",
            &dxf(None, &loop_of("A", &SQUARE)),
            "does not name its unit of length",
        ),
        ("unitless", "a.dxf", &dxf(Some(0), &loop_of("A", &SQUARE)), "--units mm"),
    ] {
        assert_says(&refused(name, file, content, ""), &[file, piece]);
    }
    let message = refused("unknown-unit", "a.dxf", &square, " --units cubit");
    assert_says(&message, &["is in mm, which cannot be converted into `cubit`"]);
}

/// What a part file says of a drawing that is not there, or not as it says.
#[test]
fn part_files_that_do_not_fit_their_drawing() {
    let folder = Folder::new("drawing-files");
    folder.write("plate.dxf", dxf(MM, &loop_of("A", &SQUARE)));
    let outline = "outline = [[0, 0], [4, 0], [0, 3]]\nstiffness = 1";
    for (fields, pieces) in [
        (
            "drawing = \"other.dxf\"\nstiffness = 1",
            ["part.toml:2:11: part.planar.drawing", "cannot be read"],
        ),
        ("drawing = \"part.toml\"\nstiffness = 1", ["is not known by its ending", ".dxf or .svg"]),
        (
            "drawing = \"plate.dxf\"\nstiffness = { B = 1 }",
            ["part.toml:3:19: part.planar.stiffness.B", "layer `B` has no edge"],
        ),
        (
            "drawing = \"plate.dxf\"\nstiffness = { A = -1 }",
            ["stiffness.A: ", "has to be a positive"],
        ),
        (
            "drawing = \"plate.dxf\"\nstiffness = {}",
            ["part.planar.stiffness: ", "no stiffness for layer `A`"],
        ),
        (
            "drawing = \"plate.dxf\"\nstiffness = 1\nforbidden = [{ layer = \"B\" }]",
            ["forbidden[0]: ", "layer `B` has no edge"],
        ),
        (
            "drawing = \"plate.dxf\"\nstiffness = 1\nforbidden = [{ layer = \"A\" }]",
            ["forbidden: ", "no stretch of any edge is left"],
        ),
        (
            "drawing = \"plate.dxf\"\nstiffness = 1\nforbidden = [{ layer = \"A\", edge = 1 }]",
            ["forbidden[0]: ", "beside a stretch"],
        ),
        (
            "drawing = \"plate.dxf\"\nstiffness = 1\nchord = 0",
            ["part.planar.chord: ", "the chord is 0"],
        ),
        (
            "drawing = \"plate.dxf\"\noutline = []\nstiffness = 1",
            ["part.planar: ", "a `drawing` and another shape"],
        ),
        (&format!("{outline}\nchord = 1"), ["part.planar.chord: ", "goes with a `drawing` only"]),
        (
            &format!("{outline}\nlayers = [\"A\"]"),
            ["part.planar.layers: ", "goes with a `drawing` only"],
        ),
        (
            &format!("{outline}\nforbidden = [{{ layer = \"A\" }}]"),
            ["part.planar.forbidden: ", "goes with a `drawing` only"],
        ),
        (
            &outline.replace("= 1", "= { A = 1 }"),
            ["part.planar.stiffness: ", "goes with a `drawing` only"],
        ),
    ] {
        folder.write("part.toml", format!("[part.planar]\n{fields}\n"));
        let ran = folder.run("optimize part.toml --fingers 4");
        assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{fields}: {}", ran.err);
        assert_says(&ran.err, &pieces);
    }
}

#[test]
fn options_that_do_not_go_with_the_part() {
    let folder = Folder::new("drawing-options");
    folder.write("plate.dxf", dxf(MM, &loop_of("A", &SQUARE))).write("a.stl", "");
    folder.write("part.toml", "[part.planar]\noutline = [[0, 0], [4, 0], [0, 3]]\nstiffness = 1\n");
    for (arguments, piece) in [
        ("plate.dxf", "needs --stiffness <K>"),
        ("plate.dxf --stiffness 1 --stiffness 2", "found several, expected one number, or LAYER=K"),
        ("plate.dxf --stiffness A=1 --stiffness A=2", "found several"),
        ("plate.dxf --stiffness 0", "expected more than 0"),
        ("plate.dxf --stiffness =2", "expected that of a layer"),
        ("plate.dxf --stiffness 1 --units ,N", "expected the name of a unit"),
        ("plate.dxf --stiffness 1 --chord 0", "expected more than 0"),
        ("a.stl --stiffness A=1", "found several"),
        ("a.stl --stiffness 1 --layer A", "--layer goes with a drawing only"),
        ("part.toml --stiffness 1", "--stiffness goes with a drawing or a mesh in place of"),
        ("part.toml --units mm", "--units goes with a drawing or a mesh in place of"),
        ("part.toml --layer A", "--layer goes with a drawing or a mesh in place of"),
        ("part.toml --chord 1", "--chord goes with a drawing only"),
        ("part.toml --forbid layer:A", "--forbid layer:NAME goes with a drawing only"),
    ] {
        let ran = folder.run(&format!("optimize {arguments} --fingers 4"));
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""), "{arguments}: {}", ran.err);
        assert_says(&ran.err, &[piece]);
    }
}

/// A curve that is there twice is left out, and told.
#[test]
fn repeated_curves_are_left_out_with_a_warning() {
    let folder = Folder::new("drawing-repeated");
    let again = loop_of("A", &SQUARE)
        + "LINE B 10 10 20 0 11 0 21 0\nCIRCLE A 10 5 20 5 40 1\nCIRCLE A 10 5 20 5 40 1";
    folder.write("plate.dxf", dxf(MM, &again));
    let ran = folder.run("optimize plate.dxf --stiffness 1 --fingers 4");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let warning = "warning   the LINE at line 76, on layer `B` repeats the LINE at line 28, on \
                   layer `A`: left out";
    assert_says(&ran.out, &[warning, "the CIRCLE at line 98, on layer `A` repeats the CIRCLE"]);
}
