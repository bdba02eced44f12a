//! Fingers on solids whose tips need room: options, fields of the part file, and what is reported.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use clench_testkit::cases::{list, number, numbers};
use clench_testkit::solids::angle;

use crate::run::{Folder, assert_says};

/// An L from z = -1 to 1, with this beside its shape.
fn part(more: &str) -> String {
    let (vertices, faces) = angle();
    let head = "units = { length = \"mm\", force = \"N\" }\n[part.spatial]\nstiffness = 1000.0\n";
    format!("{head}vertices = {vertices:?}\nfaces = {faces:?}\n{more}")
}

/// Six locators and a clamp, with tips of radius 0.2.
fn fixed() -> String {
    let places: [([f64; 3], [f64; 3]); 7] = [
        ([0.3, 0.3, -1.0], [0.0, 0.0, 1.0]),
        ([3.7, 0.5, -1.0], [0.0, 0.0, 1.0]),
        ([0.5, 2.7, -1.0], [0.0, 0.0, 1.0]),
        ([0.5, 0.0, 0.0], [0.0, 1.0, 0.0]),
        ([3.5, 0.0, 0.2], [0.0, 1.0, 0.0]),
        ([0.0, 2.5, 0.1], [1.0, 0.0, 0.0]),
        ([2.0, 0.5, 1.0], [0.0, 0.0, -1.0]),
    ];
    let contact = |(point, normal): ([f64; 3], [f64; 3])| {
        let finger = "finger = { radius = 0.2 }";
        format!("[[contacts]]\npoint = {point:?}\ninward_normal = {normal:?}\n{finger}\n")
    };
    format!("units = {{ length = \"mm\", force = \"N\" }}\n{}", places.map(contact).concat())
}

fn folder(name: &str, more: &str) -> Folder {
    let folder = Folder::new(&format!("spatial_tips_{name}"));
    folder.write("part.toml", part(more)).write("fixed.toml", fixed());
    folder
}

const ASKED: &str = "optimize part.toml --fingers 2 --fix fixed.toml --gap 0.02 --nodes 20000";

#[test]
fn tips_keep_out_of_the_corner_of_an_l_and_apart() {
    let folder = folder("room", "");
    let free = folder.json(ASKED);
    assert!(free.get("accessible").is_none());
    let found = folder.json(&format!("{ASKED} --finger-radius 0.5 --clearance 0.3"));
    let surface = &found["accessible"]["surface"];
    // Two strips of 2 by 0.5 beside the hollow edge, of a surface of 2 (6 + 14): an L of area 6
    // with a border of 14, 2 high.
    let share = 1.0 - 2.0 / 40.0;
    assert!((number(&surface["share"]) - share).abs() < 1e-9, "{}", found["accessible"]);
    assert_eq!(list(&surface["closed_faces"]).len(), 0);
    assert!((number(&found["clearance"]) - 0.3).abs() < 1e-12);
    let centers = list(&found["contacts"]).iter().map(|contact| {
        let (point, normal) = (numbers(&contact["point"]), numbers(&contact["inward_normal"]));
        let radius = number(&contact["finger"]["radius"]);
        let center: Vec<f64> = point.iter().zip(&normal).map(|(p, n)| p - n * radius).collect();
        (center, radius, contact.get("fixed").is_some())
    });
    let centers: Vec<_> = centers.collect();
    for (i, (one, radius, is_fixed)) in centers.iter().enumerate() {
        if !is_fixed && one[0] > 0.999 && one[1] > 0.999 && one[2].abs() < 1.0 {
            assert!(one[0] - 1.0 >= radius - 1e-9 && one[1] - 1.0 >= radius - 1e-9, "{one:?}");
        }
        for (other, beside, is_other_fixed) in &centers[..i] {
            let distance = one.iter().zip(other).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
            let least = radius + beside + 0.3;
            assert!(distance >= least - 1e-9 || (*is_fixed && *is_other_fixed), "{distance}");
        }
    }
    let most = number(&free["certificate"]["upper_bound"]);
    assert!(number(&found["worst_point_stiffness"]) <= most);
    let text = folder.run(&format!("{ASKED} --finger-radius 0.5")).out;
    assert_says(&text, &["room      95.0 % of the surface is accessible, to 0.000269"]);
    // A report is a grasp file.
    let report = folder.run(&format!("{ASKED} --finger-radius 0.5 --preload 10 --format json")).out;
    folder.write("report.json", report);
    let again = folder.run("analyze report.json");
    assert_eq!((again.code, again.err.as_str()), (Some(0), ""));
}

#[test]
fn boxes_plates_and_margins_of_the_file_hold() {
    let more = "margin = 0.1\n\
                keep_out = [{ from = [-1, -1, 1], to = [5, 4, 3] }]\n\
                plate = { pitch = [1, 1], offset = [0.5, 0.5], travel = 0.3 }\n";
    let folder = folder("fields", more);
    let found = folder.json(&format!("{ASKED} --finger-radius 0.25 --margin 0.2"));
    assert!((number(&found["part"]["spatial"]["margin"]) - 0.2).abs() < 1e-12);
    // The top is under the box.
    assert_eq!(numbers(&found["accessible"]["surface"]["closed_faces"]), [1.0]);
    for contact in list(&found["contacts"]).iter().filter(|c| c.get("fixed").is_none()) {
        let (point, normal) = (numbers(&contact["point"]), numbers(&contact["inward_normal"]));
        let off = |i: usize| {
            let along = (point[i] - 0.25 * normal[i] - 0.5).rem_euclid(1.0);
            along.min(1.0 - along)
        };
        assert!(off(0).hypot(off(1)) <= 0.3 + 1e-9, "{point:?}");
        assert!(point[2] <= 0.75 + 1e-9 && point[2] >= -1.0);
    }
}

#[test]
fn candidates_without_room_are_left_out_and_overlaps_of_given_contacts_told() {
    let folder = folder("candidates", "");
    let places = [
        ([1.0, 1.1, 0.0], [-1.0, 0.0, 0.0]),
        ([1.0, 2.5, 0.0], [-1.0, 0.0, 0.0]),
        ([2.5, 1.0, 0.3], [0.0, -1.0, 0.0]),
        ([3.0, 1.0, -0.3], [0.0, -1.0, 0.0]),
        ([0.5, 3.0, 0.0], [0.0, -1.0, 0.0]),
        ([1.0, 2.0, 0.5], [-1.0, 0.0, 0.0]),
    ];
    let units = "units = { length = \"mm\", force = \"N\" }\n";
    let all = places.map(|(point, normal)| {
        format!("[[contacts]]\npoint = {point:?}\ninward_normal = {normal:?}\n")
    });
    folder.write("places.toml", format!("{units}{}", all.concat()));
    let asked = "optimize part.toml --fingers 2 --fix fixed.toml --candidates places.toml";
    let found = folder.json(&format!("{asked} --finger-radius 0.4"));
    let out = list(&found["accessible"]["left_out"]);
    assert_eq!((out.len(), number(&out[0]["contact"])), (1, 0.0));
    assert_eq!(out[0]["meets"].as_str(), Some("the part"));
    let chosen = list(&found["contacts"]).iter().filter_map(|contact| contact.get("candidate"));
    assert!(chosen.into_iter().all(|candidate| number(candidate) > 0.5));
    // A given contact in the corner, with a tip that is too large for it.
    let wide = fixed().replace("[0.5, 2.7, -1.0]", "[0.4, 0.4, -1.0]");
    folder.write("wide.toml", wide);
    let told = folder.run("optimize part.toml --fingers 2 --fix wide.toml --nodes 500");
    assert_says(&told.out, &["overlap", "fixed contact 2 meets fixed contact 0"]);
    let none = folder.run(&format!("{asked} --finger-radius 40"));
    assert_eq!(none.code, Some(3), "{}", none.err);
    assert_says(&none.err, &["candidates meet something", "2 fingers need as many"]);
}

#[test]
fn what_is_no_room_is_refused_with_its_place() {
    for (name, more, option, code, pieces) in [
        (
            "box",
            "keep_out = [{ from = [0, 0, 0], to = [1, 0, 1] }]",
            "",
            1,
            vec!["along y", "keep_out"],
        ),
        ("pitch", "plate = { pitch = [0, 1], travel = 1 }", "", 1, vec!["pitch", "positive"]),
        ("travel", "plate = { pitch = [1, 1], travel = 0 }", "", 1, vec!["travel", "candidates"]),
        (
            "to",
            "keep_out = [{ from = [0, 0, 0] }]",
            "",
            1,
            vec!["keep_out[0]", "missing field `to`, expected three numbers [x, y, z]"],
        ),
        ("margin", "margin = -1", "", 1, vec!["margin is -1"]),
        ("field", "plate = { pitch = [1, 1], travle = 0 }", "", 1, vec!["travle"]),
        (
            "all",
            "keep_out = [{ from = [-9, -9, -9], to = [9, 9, 9] }]",
            " --finger-radius 1",
            3,
            vec!["nothing of the part can be touched", "radius 1", "1 keep-outs"],
        ),
        ("wide", "", " --margin 3", 3, vec!["nothing of the part can be touched", "at least 3"]),
        ("radius", "", " --finger-radius nan", 2, vec!["--finger-radius"]),
        ("clearance", "", " --clearance -1", 2, vec!["--clearance"]),
    ] {
        let folder = folder(&format!("refused_{name}"), more);
        let ran = folder.run(&format!("{ASKED}{option}"));
        assert_eq!(ran.code, Some(code), "{name}: {}", ran.err);
        assert_says(&ran.err, &pieces);
    }
}
