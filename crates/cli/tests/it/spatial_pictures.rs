//! Pictures of solids with what holds them.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fs;

use crate::run::{Folder, assert_says};
use crate::spatial_optima::{LOCATORS, PLACES, contacts, cube, located};

const CHOSEN: &str = "optimize cube.toml --fix fix.toml --candidates places.toml --fingers 3";

fn drawn(folder: &Folder, question: &str, code: i32) -> String {
    let ran = folder.run(&format!("{question} --svg picture.svg"));
    assert_eq!(ran.code, Some(code), "{}", ran.err);
    fs::read_to_string(folder.path("picture.svg")).unwrap()
}

#[test]
fn the_picture_of_a_solid_shows_fingers_axes_and_numbers() {
    let folder = located("picture");
    let svg = drawn(&folder, CHOSEN, 0);
    assert_says(&svg, &[">F0<", ">F8<", "Q = ", " F/L", "limited by ", " at most ", "gap "]);
    let json = folder.run(&format!("{CHOSEN} --format json")).out;
    folder.write("report.json", json);
    let svg = drawn(&folder, "analyze report.json --frame 1,2,3,0,0,1", 0);
    assert_says(&svg, &[">F8<", "Q = ", "σ", "at w"]);
    // What is not held is drawn without axes.
    folder.write("grasp.toml", cube(2.0) + &contacts(&LOCATORS[..4], ""));
    assert_says(&drawn(&folder, "analyze grasp.toml", 3), &[">F3<", "not held"]);
    // What was drawn before is kept where no placement holds the part.
    folder.write("places.toml", contacts(&PLACES[..4], ""));
    assert_says(&drawn(&folder, CHOSEN, 3), &[">F3<", "not held"]);
}

#[test]
fn ellipsoids_are_drawn() {
    let folder = Folder::new("spatial-ellipsoid");
    let part = "[part.spatial]\nellipsoid = [3, 2, 1]\ncenter = [5, 5, 5]\nstiffness = 1\n";
    folder.write("grasp.toml", part.to_owned() + &contacts(&[[8.0, 5.0, 5.0]], ""));
    assert_says(&drawn(&folder, "analyze grasp.toml", 3), &[">F0<", "not held"]);
}

#[test]
fn a_picture_does_not_overwrite_what_was_read() {
    let folder = located("overwrite");
    for name in ["cube.toml", "fix.toml", "places.toml"] {
        let ran = folder.run(&format!("{CHOSEN} --svg {name}"));
        assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{name}");
        assert_says(&ran.err, &[&format!("{name}: is the input file")]);
    }
}
