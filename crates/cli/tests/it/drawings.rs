//! Parts from drawings through the command: units, layers, reports. What is read of a drawing is
//! tested in `clench-drawing`.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fmt::Write as _;

use clench_testkit::assert_close;
use clench_testkit::cases::{Value, list, number, numbers};
use clench_testkit::drawings::{dxf, loop_of};

use crate::run::{Folder, assert_says};
use crate::sketch::{contours, read};

const MM: Option<u8> = Some(4);
const RECTANGLE: [[f64; 2]; 4] = [[0.0, 0.0], [80.0, 0.0], [80.0, 60.0], [0.0, 60.0]];

/// What was closed, flattened and left aside, in both reports.
#[test]
fn reports_say_what_was_read() {
    let folder = Folder::new("drawing-said");
    let plate = "LINE A 10 0 20 0 11 80.002 21 0\nLINE A 10 80 20 0 11 80 21 60\n\
                 LINE A 10 80 20 60 11 0 21 60\nLINE WALL 10 0 20 60 11 0 21 0\n\
                 CIRCLE A 10 40 20 30 40 5\nTEXT NOTES 10 5 20 5 40 3 1 7\n\
                 TEXT NOTES 10 5 20 5 40 3 1 8\nLINE A 60 1 10 1 20 1 11 9 21 9";
    folder.write("plate.dxf", dxf(MM, plate));
    let (plate, report) = contours(&folder, "plate.dxf --chord 0.25");
    assert_eq!(plate.len(), 2);
    let drawing = &report["drawing"];
    assert_close(number(&drawing["chord"]), 0.25, 0.0, 1.0, "chord");
    assert_close(number(&drawing["largest_gap"]), 0.002, 1e-11, 1.0, "largest gap");
    assert_close(number(&drawing["curves"]), 5.0, 0.0, 1.0, "curves");
    let layers: Vec<&str> =
        list(&drawing["layers"]).iter().map(|layer| layer.as_str().unwrap()).collect();
    assert_eq!(layers, ["A", "WALL"]);
    let aside: Vec<String> = list(&drawing["left_aside"])
        .iter()
        .map(|aside| {
            let word = |key: &str| aside[key].as_str().unwrap().to_owned();
            let words = [word("kind"), word("layer"), word("reason")].join(", ");
            format!("{} {words}", number(&aside["count"]))
        })
        .collect();
    assert_eq!(aside, ["1 LINE, A, hidden", "2 TEXT, NOTES, no curve"]);
    let text = folder.run("optimize plate.dxf --stiffness 1 --fingers 4 --chord 0.25").out;
    let pieces = [
        "5 curves on layers A, WALL",
        "edges are within 0.25 mm of its curves; gaps up to 0.002 mm are closed",
        "aside     1 LINE on layer `A`: hidden",
        "2 TEXT on layer `NOTES`: no curve",
    ];
    assert_says(&text, &pieces);
}

/// What a style sheet hides is read all the same, and all reports say so; of straight lines no
/// chord is told.
#[test]
fn reports_say_that_style_sheets_are_not_read() {
    let folder = Folder::new("drawing-styled");
    let page = |style: &str| {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"80mm\" height=\"60mm\" \
             viewBox=\"0 0 80 60\">{style}<rect width=\"80\" height=\"60\"/>\
             <path class=\"gone\" d=\"M20 20 h10 v10 h-10 Z\"/></svg>"
        )
    };
    folder.write("plate.svg", page("<style>.gone { display: none }</style>"));
    let arguments = "plate.svg --stiffness 1 --fingers 4 --report page.html";
    let text = folder.run(&format!("optimize {arguments}")).out;
    let said = "style sheets are not read: what they hide or change, such as 1 shape with a \
                class, is taken as it is without them";
    assert_says(&text, &[&format!("warning   {said}"), "1 style on no layer: style sheets"]);
    assert!(!text.contains("edges are within"), "{text}");
    let html = std::fs::read_to_string(folder.path("page.html")).unwrap();
    assert_says(&html, &[said, "1 style on no layer", "plate.svg, in mm; 2 curves on no layer"]);
    let report = read(&folder, "plate.svg --stiffness 1");
    let aside = list(&report["drawing"]["left_aside"]);
    let kinds: Vec<&str> = aside.iter().map(|aside| aside["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["class", "style"]);
    let reasons = ["classes are not read", "style sheets are not read"];
    for (aside, reason) in aside.iter().zip(reasons) {
        assert_eq!(aside["reason"].as_str(), Some(reason));
    }
    assert_close(number(&report["drawing"]["chord"]), 0.0, 0.0, 1.0, "chord");
    folder.write("plate.svg", page(""));
    assert!(!folder.run(&format!("optimize {arguments}")).out.contains("style sheets"));
}

/// A page of an SVG drawing, and its curves with y upwards.
#[test]
fn svg_drawings_are_parts_too() {
    let folder = Folder::new("drawing-svg");
    let page = |size: &str| {
        let page = format!("xmlns=\"http://www.w3.org/2000/svg\" {size} viewBox=\"0 0 40 20\"");
        format!("<svg {page}>\n<path d=\"M10 5 H40 V20 H10 Z\"/>\n</svg>\n")
    };
    for (size, option, unit, corner) in [
        ("width=\"4in\"", "", "in", [1.0, 1.5]),
        ("width=\"4in\"", " --units mm", "mm", [25.4, 38.1]),
        ("width=\"4in\"", " --units mil", "mil", [1000.0, 1500.0]),
        ("width=\"4in\"", " --units yd", "yd", [1.0 / 36.0, 1.5 / 36.0]),
        ("", " --units cm", "cm", [10.0, 15.0]),
    ] {
        folder.write("part.svg", page(size));
        let (part, report) = contours(&folder, &format!("part.svg{option}"));
        for (found, expected) in part[0][0].into_iter().zip(corner) {
            assert_close(found, expected, 1e-14, 40.0, size);
        }
        assert_eq!(report["units"]["length"].as_str(), Some(unit), "{size}{option}");
    }
    folder.write("part.svg", page(""));
    let ran = folder.run("optimize part.svg --stiffness 1 --fingers 4");
    assert_eq!(ran.code, Some(1));
    assert_says(&ran.err, &["part.svg: the drawing does not name its unit", "--units mm"]);
}

#[test]
fn units_of_the_drawing_are_converted_into_those_of_the_file() {
    let folder = Folder::new("drawing-units");
    let plate = |unit| dxf(unit, &loop_of("0", &RECTANGLE.map(|p| p.map(|x| x / 10.0))));
    folder.write("inch.dxf", plate(Some(1))).write("none.dxf", plate(None));
    let file = "units = { length = \"mm\", force = \"N\" }\n[part.planar]\n\
                drawing = \"inch.dxf\"\nstiffness = 1\n";
    folder.write("part.toml", file);
    let report = read(&folder, "part.toml");
    assert_eq!(numbers(&list(&report["part"]["planar"]["outline"])[1]), [8.0 * 25.4, 0.0]);
    assert_eq!(report["drawing"]["unit"].as_str(), Some("in"));
    assert_close(number(&report["drawing"]["scale"]), 25.4, 0.0, 1.0, "scale");
    let text = folder.run("optimize part.toml --fingers 4 --nodes 1").out;
    assert_says(&text, &["drawing   inch.dxf, in in: lengths times 25.4; 4 curves on layer `0`"]);
    // Nothing is converted unless it has to be.
    for (arguments, length, force, right) in [
        ("inch.dxf --stiffness 1", "in", "N", 8.0),
        ("inch.dxf --stiffness 1 --units in,lbf", "in", "lbf", 8.0),
        ("inch.dxf --stiffness 1 --units cm", "cm", "N", 20.32),
        ("none.dxf --stiffness 1 --units mm", "mm", "N", 8.0),
        ("none.dxf --stiffness 1 --units cubit", "cubit", "N", 8.0),
    ] {
        let report = read(&folder, arguments);
        let unit = |key: &str| report["units"][key].as_str().unwrap().to_owned();
        assert_eq!([unit("length"), unit("force")], [length, force], "{arguments}");
        let corner = numbers(&list(&report["part"]["planar"]["outline"])[1]);
        assert_close(corner[0], right, 1e-15, 20.0, arguments);
    }
}

#[test]
fn layers_have_their_own_stiffness_and_may_be_forbidden() {
    let folder = Folder::new("drawing-layers");
    let square = [[30.0, 20.0], [50.0, 20.0], [50.0, 40.0], [30.0, 40.0]];
    let both = loop_of("OUTLINE", &RECTANGLE) + &loop_of("POCKET", &square);
    folder.write("plate.dxf", dxf(MM, &both));
    let file = "[part.planar]\ndrawing = \"plate.dxf\"\nstiffness = { OUTLINE = 4, pocket = 2 }\n\
                forbidden = [{ layer = \"OUTLINE\" }]\nlayers = [\"OUTLINE\", \"POCKET\"]\n";
    folder.write("part.toml", file);
    let of_file = read(&folder, "part.toml");
    let planar = &of_file["part"]["planar"];
    assert_eq!(numbers(&planar["stiffness"]), [4.0, 4.0, 4.0, 4.0, 2.0, 2.0, 2.0, 2.0]);
    assert_eq!(numbers(&planar["forbidden"]), [0.0, 1.0, 2.0, 3.0]);
    for contact in list(&of_file["contacts"]) {
        assert!(number(&contact["edge"]) >= 4.0);
        assert_close(number(&contact["law"]["stiffness"]), 2.0, 0.0, 1.0, "stiffness");
    }
    // The command line says the same.
    let options = "--stiffness OUTLINE=4 --stiffness POCKET=2 --forbid layer:outline";
    let of_options = read(&folder, &format!("plate.dxf {options}"));
    assert_eq!(of_options["part"], *planar_of(&of_file));
}

fn planar_of(report: &Value) -> &Value {
    &report["part"]
}

/// A report has the corners of the drawing, and is a grasp file as it stands.
#[test]
fn reports_on_drawings_are_grasp_files() {
    let folder = Folder::new("drawing-report");
    let bore = "CIRCLE 0 10 20 20 20 40 6";
    folder.write("plate.dxf", dxf(MM, &(loop_of("0", &RECTANGLE) + bore)));
    let report = folder.json("optimize plate.dxf --stiffness 5e4 --fingers 4");
    folder.write("grasp.json", report.to_string());
    std::fs::remove_file(folder.path("plate.dxf")).unwrap();
    let grasp = folder.json("analyze grasp.json");
    let quality = number(&report["quality"]);
    assert_close(number(&grasp["quality"]), quality, 1e-12, quality, "quality");
    // And `analyze` reads a drawing itself.
    folder.write("plate.dxf", dxf(MM, &(loop_of("0", &RECTANGLE) + bore)));
    let mut grasp = "[part.planar]\ndrawing = \"plate.dxf\"\nstiffness = 5e4\n".to_owned();
    for contact in list(&report["contacts"]) {
        let (point, edge) = (numbers(&contact["point"]), number(&contact["edge"]));
        write!(grasp, "[[contacts]]\npoint = {point:?}\nedge = {edge}\n").unwrap();
    }
    folder.write("grasp.toml", grasp);
    let ran = folder.run("analyze grasp.toml");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert_says(&ran.out, &["drawing   plate.dxf, in mm; 5 curves on layer `0`", "Q = "]);
    let report = folder.json("analyze grasp.toml");
    assert_close(number(&report["drawing"]["curves"]), 5.0, 0.0, 1.0, "curves");
    assert_close(number(&report["quality"]), quality, 1e-12, quality, "quality");
}

/// A mesh needs no part file either.
#[test]
fn meshes_are_parts_by_themselves() {
    let folder = Folder::new("mesh-alone");
    let cube = "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 0 0 9\nv 9 0 9\nv 9 9 9\nv 0 9 9\n\
                f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    folder.write("cube.obj", cube);
    let arguments = "--fingers 7 --nodes 20 --objective worst-point --format json";
    let alone = folder.run(&format!("optimize cube.obj --stiffness 5 --units mm,kN {arguments}"));
    folder.write(
        "cube.toml",
        "units = { length = \"mm\", force = \"kN\" }\n[part.spatial]\nmesh = \"cube.obj\"\n\
         stiffness = 5\n",
    );
    let file = folder.run(&format!("optimize cube.toml {arguments}"));
    assert!(matches!(alone.code, Some(0 | 3)), "{}", alone.err);
    assert_eq!(alone.out, file.out);
}
