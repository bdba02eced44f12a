//! What `optimize` refuses of solids, of what is given on them, and of options beside them.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![allow(clippy::cast_possible_truncation, reason = "STL files have single precision")]

use clench_testkit::Random;
use clench_testkit::cases::{list, number};
use clench_testkit::solids::rough_ball;

use crate::meshes::{Triangle, binary, obj, triangles};
use crate::run::{Folder, QUADRILATERAL, assert_says, part};
use crate::spatial_optima::{LOCATORS, PLACES, contacts, cube, located};

/// The message about a question with bad input or wrong usage.
fn refused(folder: &Folder, question: &str, code: i32, pieces: &[&str]) {
    let ran = folder.run(&format!("optimize {question}"));
    assert_eq!((ran.code, ran.out.as_str()), (Some(code), ""), "{question}: {}", ran.err);
    assert!(!ran.err.contains("panicked"), "{question}: {}", ran.err);
    assert_says(&ran.err, pieces);
}

#[test]
fn options_that_do_not_go_with_a_solid_are_wrong_usage() {
    let folder = located("usage");
    for (options, pieces) in [
        ("--fingers 3 --forbid 1", ["--forbid goes with an outline", "a solid"]),
        ("--fingers 0", ["found 0", "on a solid from 1 to 12"]),
        ("--fingers 13", ["found 13", "on a solid from 1 to 12"]),
        ("--fingers 6", ["--fingers and --fix: 6 fingers and 0 given", "it takes 7 frictionless"]),
        ("--fingers 11 --fix fix.toml", ["--fingers and --fix: 17 contacts", "at most 16"]),
        (
            "--fingers 3 --fix fix.toml --least-share 0.2",
            ["--least-share: ", "from 0 to below 0.1"],
        ),
        (
            "--fingers 7 --candidates places.toml",
            ["--candidates: found 6 candidates", "for 7 fingers"],
        ),
        ("--fingers 7 --least-translation 1", ["--least-translation goes with", "rotation only"]),
    ] {
        refused(&folder, &format!("cube.toml {options}"), 2, &pieces);
    }
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    for option in ["--fix", "--candidates"] {
        let words = format!("{option} goes with a solid, but the part is an outline");
        refused(&folder, &format!("part.toml --fingers 4 {option} fix.toml"), 2, &[&words]);
    }
    for option in ["--most-on-face 3", "--roundness 0.1"] {
        let name = option.split(' ').next().unwrap_or_default();
        let words = format!("{name} goes with a solid, but the part is an outline");
        refused(&folder, &format!("part.toml --fingers 4 {option}"), 2, &[&words]);
    }
    let words = ["--fingers: found 9, expected from 3 to 8 on an outline"];
    refused(&folder, "part.toml --fingers 9", 2, &words);
}

#[test]
fn given_contacts_that_do_not_fit_are_refused() {
    let folder = located("given");
    let (all, law) = (contacts(&LOCATORS, ""), "law = { kind = \"power\", coefficient = 1");
    let units = "units = { length = \"mm\", force = \"N\" }\n";
    let planar = part(QUADRILATERAL, "1");
    for (name, content, pieces) in [
        ("units", format!("{units}{all}"), [":1:9: units: found the units mm and N", "L and F"]),
        ("part", format!("{}{all}", cube(3.0)), ["part: found another part than that of", "cube"]),
        (
            "softer",
            format!("{}{all}", cube(2.0).replace("stiffness = 3", "stiffness = 2")),
            ["part: found another part", "expected the same, or none"],
        ),
        ("planar", format!("{planar}{all}"), ["part: found another part", "cube.toml"]),
        (
            "nan",
            contacts(&[[f64::NAN, 0.0, 0.0]], "").replace("NaN", "nan"),
            ["contacts[0].point", "finite number"],
        ),
        ("inside", contacts(&[[1.0; 3]], ""), ["contacts[0].point: contact 0 is off", "inside"]),
        ("off", contacts(&[[1.0, 1.0, 2.1]], ""), ["is off the boundary", "outside the part"]),
        ("edge", contacts(&[[1.0, 0.0, 0.0]], ""), ["where faces 0 and 2 meet", "`face`"]),
        (
            "normal",
            contacts(&[LOCATORS[0]], "inward_normal = [0, 1, 0]"),
            ["found the inward normal [0, 1, 0]", "expected [0, 0, 1]"],
        ),
        (
            "no-slope",
            contacts(&[LOCATORS[0]], &format!("{law}, exponent = 1.5 }}")),
            ["contacts[0].law: ", "needs a positive preload"],
        ),
        (
            "steep",
            contacts(&[LOCATORS[0]], &format!("{law}, exponent = 0.5 }}")),
            ["contacts[0].law: ", "needs a positive preload"],
        ),
        ("flat", contacts(&[[1.0, 1.0, 0.0]], "").replace(", 0.0]", "]"), ["found 2 numbers", ""]),
        ("unknown", format!("{all}pressure = 1\n"), ["contacts[5].pressure", "unknown field"]),
        ("none", "version = 1\n".to_owned(), ["contacts: found no contacts", ""]),
        ("version", format!("version = 2\n{all}"), ["found schema version 2", "expected 1"]),
        (
            "loads",
            format!("{all}[[loads]]\npoint = [1, 1, 1]\nforce = [0, 0, -1]\n"),
            ["loads: found loads", "does not take into account"],
        ),
    ] {
        let file = format!("{name}.toml");
        folder.write(&file, content);
        let place = format!("{file}:");
        for option in ["--fingers 3 --fix", "--fix fix.toml --fingers 3 --candidates"] {
            let question = format!("cube.toml {option} {file}");
            refused(&folder, &question, 1, &[&place, pieces[0], pieces[1]]);
        }
    }
    refused(&folder, "cube.toml --fingers 3 --fix gone.toml", 1, &["gone.toml: cannot be read"]);
    folder.write("same.toml", cube(2.0) + &contacts(&LOCATORS, ""));
    let ran = folder.run("optimize cube.toml --fix same.toml --fingers 3 --nodes 1");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
}

#[test]
fn parts_that_fingers_cannot_be_placed_on_are_refused() {
    let folder = Folder::new("spatial-parts");
    let two = "[0, 2, 3], [0, 3, 1], [4, 5, 7, 6]";
    let cut = cube(2.0).replace("[0, 2, 3, 1], [4, 5, 7, 6]", two);
    let unlike = cut.replace("stiffness = 3", "stiffness = [1, 2, 1, 1, 1, 1, 1]");
    let spread = "stiffness = [1, 1e9, 1e-9, 1, 1, 1]";
    for (name, content, pieces) in [
        (
            "ellipsoid",
            "[part.spatial]\nellipsoid = [3, 2, 1]\nstiffness = 1\n".to_owned(),
            ["part.spatial.ellipsoid: ", "has no faces", "solids of plane faces"],
        ),
        (
            "stiffness",
            cube(2.0).replace("stiffness = 3\n", ""),
            ["part.spatial: ", "missing field `stiffness`", "one per face"],
        ),
        ("unlike", unlike, ["part.spatial.stiffness[1]: ", "faces 0 and 1 are in one plane", ""]),
        (
            "spread",
            cube(2.0).replace("stiffness = 3", spread),
            ["part.spatial.stiffness: ", "from 1e-9 to 1e9", "their ratio"],
        ),
        (
            "open",
            cube(2.0).replace(", \n", "").replace("[0, 4, 6, 2], ", ""),
            ["part.spatial.faces[", "the surface is open", ""],
        ),
    ] {
        folder.write("part.toml", content);
        let ran = folder.run("optimize part.toml --fingers 7 --nodes 1");
        assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{name}: {}", ran.err);
        assert_says(&ran.err, &pieces);
    }
}

fn mesh(name: &str, file: &str, content: impl AsRef<[u8]>) -> Folder {
    let folder = Folder::new(&format!("spatial-mesh-{name}"));
    folder.write(file, content);
    folder.write("part.toml", format!("[part.spatial]\nmesh = \"{file}\"\nstiffness = 3\n"));
    folder.write("fix.toml", contacts(&LOCATORS, ""));
    folder.write("places.toml", contacts(&PLACES, ""));
    folder
}

#[test]
fn meshes_have_planes_up_to_their_precision() {
    let question = "optimize part.toml --fix fix.toml --fingers 3 --nodes 30";
    for (name, file, content, flatness) in [
        ("stl", "cube.stl", binary("a cube", &triangles()), 2e-6),
        ("obj", "cube.obj", obj().into_bytes(), 0.0),
    ] {
        let folder = mesh(name, file, content);
        let report = folder.json(question);
        assert_eq!(number(&report["flatness"]).to_bits(), f64::to_bits(flatness), "{name}");
        let text = folder.run(question).out;
        assert_says(&text, &["in 6 planes", "off a plane its vertices may be"]);
        // From the folder that the report names the mesh from.
        folder.write("report.json", report.to_string());
        let analysis = folder.json("analyze report.json");
        assert_eq!(list(&analysis["contacts"]).len(), 9);
        let ran = folder.run(&format!("{question} --svg {file}"));
        assert_eq!(ran.code, Some(1), "{}", ran.err);
        assert_says(&ran.err, &["is the input file"]);
    }
}

/// The mesh of a ball, on which no frictionless finger resists any turn.
#[test]
fn a_ball_can_always_turn() {
    let single = |corners: [[f64; 3]; 3]| corners.map(|corner| corner.map(|x| x as f32));
    let ball = rough_ball(&mut Random::new(1), 4, 1.0);
    let ball: Vec<Triangle> = ball.into_iter().map(single).collect();
    let folder = mesh("ball", "ball.stl", binary("a ball", &ball));
    let question = "optimize part.toml --fingers 7";
    let ran = folder.run(&format!("{question} --svg ball.svg"));
    assert_eq!((ran.code, ran.out.as_str()), (Some(3), ""), "{}", ran.err);
    assert_says(&ran.err, &["no answer: one motion of the part counts as free: a turn about"]);
    assert!(!folder.path("ball.svg").exists());
    let ran = folder.run(&format!("{question} --format json"));
    assert_eq!(ran.code, Some(3));
    assert!(ran.json()["reason"].as_str().unwrap().contains("has a lever"));
}

#[test]
fn what_holds_no_solid_has_no_answer() {
    let folder = located("unheld");
    // Nothing presses the cube on its locator on the left.
    folder.write("places.toml", contacts(&PLACES[..4], ""));
    let question = "optimize cube.toml --fix fix.toml --candidates places.toml --fingers 2";
    let ran = folder.run(question);
    assert_eq!((ran.code, ran.out.as_str()), (Some(3), ""), "{}", ran.err);
    assert_says(&ran.err, &["no answer: no placement of 2 frictionless fingers holds the part"]);
    // Two fingers are too few for three directions, wherever they are.
    let ran = folder.run("optimize cube.toml --fix fix.toml --fingers 2");
    assert_eq!(ran.code, Some(3), "{}", ran.err);
}

#[test]
fn meshes_that_are_no_solid_are_bad_input() {
    let whole = binary("a cube", &triangles());
    for (name, file, content, piece) in [
        ("cut", "cube.stl", whole[..300].to_vec(), "is it cut off"),
        ("open", "cube.stl", binary("open", &triangles()[..11]), "the surface is open"),
        (
            "index",
            "cube.obj",
            obj().replace("f 1 4", "f 99 4").into_bytes(),
            "line 9: found `99`, expected",
        ),
    ] {
        let folder = mesh(name, file, content);
        let place = "part.toml:2:8: part.spatial.mesh: ";
        refused(&folder, "part.toml --fingers 7", 1, &[place, piece]);
    }
}
