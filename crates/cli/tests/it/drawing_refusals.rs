//! Drawings that are none of a part: exit code 1, what is wrong and where, nothing written.

use clench_testkit::drawings::{dxf, loop_of};

use crate::run::{Folder, assert_says};

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

/// What a drawing itself can have wrong is tested in `clench-drawing`: here the name of the file
/// before it, and the help after it.
#[test]
fn drawings_that_are_none_are_told_with_help() {
    let square = dxf(MM, &loop_of("A", &SQUARE));
    let open = "LINE A 5 1F 10 0 20 0 11 9 21 0\nLINE A 10 9 20 0 11 9 21 9\n\
                ARC B 10 0 20 0 40 9 50 91 51 180\nTEXT N 1 X";
    let other = dxf(MM, &(loop_of("A", &SQUARE) + "LINE C 10 0 20 0 11 5 21 5"));
    let no_unit = dxf(None, &loop_of("A", &SQUARE));
    for (name, file, content, options, pieces) in [
        (
            "open",
            "a.dxf",
            dxf(MM, open).as_str(),
            "",
            [
                "a.dxf: the LINE `1F` at line 28, on layer `A` ends at (0, 0), where nothing goes",
                "left aside: 1 TEXT on layer `N` (no curve)",
                "help: `layers`, or --layer, takes",
            ],
        ),
        ("branch", "a.dxf", &other, "", ["a.dxf: three ends meet at (0, 0)", "--layer", "`C`"]),
        (
            "layer",
            "a.dxf",
            &square,
            " --layer WALL",
            ["a.dxf: the drawing has nothing on layer `WALL`", "one of its layers: `A`", ""],
        ),
        (
            "chord",
            "a.dxf",
            &dxf(MM, "CIRCLE A 10 0 20 0 40 5"),
            " --chord 1e-13",
            ["a.dxf: the CIRCLE at line 28", "beyond 100000", "chord of 1e-13"],
        ),
        (
            "binary",
            "a.dxf",
            "AutoCAD Binary DXF\r\n\x1a\0",
            "",
            ["a.dxf: the file is a binary DXF file", "help: ", "text DXF or SVG"],
        ),
        ("xml", "a.svg", "<svg><g></svg>", "", ["a.svg: the file is not valid XML", "", ""]),
        ("no-unit", "a.dxf", &no_unit, "", ["a.dxf: ", "does not name its unit", "--units mm"]),
        (
            "unitless",
            "a.dxf",
            &dxf(Some(0), &loop_of("A", &SQUARE)),
            "",
            ["does not name its unit of length", "help: give `units`", "--units mm"],
        ),
        (
            "unknown-unit",
            "a.dxf",
            &square,
            " --units cubit",
            [
                "the drawing is in mm, which cannot be converted into `cubit`",
                "in, ft, mi, mm, cm, m, km",
                "us-mi",
            ],
        ),
    ] {
        assert_says(&refused(name, file, content, options), &pieces);
    }
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
            "drawing = \"plate.dxf\"\nstiffness = { a = 1, A = 2 }",
            ["part.toml:3:19: part.planar.stiffness.a: ", "for layer `A` and one for layer `a`"],
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
        ("plate.dxf --stiffness A=1 --stiffness 2", "found several"),
        ("plate.dxf --stiffness A=1 --stiffness A=2", "for layer `A` and one for layer `A`"),
        ("plate.dxf --stiffness a=1 --stiffness A=2", "for layer `a` and one for layer `A`"),
        ("plate.dxf --stiffness 0", "expected more than 0"),
        ("plate.dxf --stiffness =2", "expected that of a layer"),
        ("plate.dxf --stiffness 1 --units ,N", "expected the name of a unit"),
        ("plate.dxf --stiffness 1 --units mm,N,s", "expected one unit of length and one of force"),
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
