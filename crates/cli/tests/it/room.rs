//! Round fingers on outlines, through the command: where they have room, and what is kept out of.

use clench_testkit::assert_close;
use clench_testkit::cases::{Value, list, number};

use crate::run::{Folder, assert_says};

/// A plate with a notch from above, 2 wide and 3 deep, and a bore 4 wide.
const NOTCHED: &str = "units = { length = \"mm\", force = \"N\" }\n[part.planar]\n\
    outline = [[0, 0], [16, 0], [16, 8], [12, 8], [12, 5], [10, 5], [10, 8], [0, 8]]\n\
    holes = [[[3, 2], [7, 2], [7, 6], [3, 6]]]\n\
    stiffness = 1000\n";

const EDGES: [[[f64; 2]; 2]; 12] = [
    [[0.0, 0.0], [16.0, 0.0]],
    [[16.0, 0.0], [16.0, 8.0]],
    [[16.0, 8.0], [12.0, 8.0]],
    [[12.0, 8.0], [12.0, 5.0]],
    [[12.0, 5.0], [10.0, 5.0]],
    [[10.0, 5.0], [10.0, 8.0]],
    [[10.0, 8.0], [0.0, 8.0]],
    [[0.0, 8.0], [0.0, 0.0]],
    [[3.0, 2.0], [7.0, 2.0]],
    [[7.0, 2.0], [7.0, 6.0]],
    [[7.0, 6.0], [3.0, 6.0]],
    [[3.0, 6.0], [3.0, 2.0]],
];

fn point(value: &Value) -> [f64; 2] {
    [0, 1].map(|i| number(&list(value)[i]))
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// From a point to a segment along an axis.
fn to_segment(p: [f64; 2], [a, b]: [[f64; 2]; 2]) -> f64 {
    let nearest = [0, 1].map(|i| p[i].clamp(a[i].min(b[i]), a[i].max(b[i])));
    distance(p, nearest)
}

/// The centers of the tips of a report's fingers.
fn centers(report: &Value, radius: f64) -> Vec<[f64; 2]> {
    let contacts = list(&report["contacts"]).iter();
    contacts
        .map(|contact| {
            let (p, n) = (point(&contact["point"]), point(&contact["inward_normal"]));
            [p[0] - radius * n[0], p[1] - radius * n[1]]
        })
        .collect()
}

#[test]
fn fingers_of_a_report_overlap_neither_the_part_nor_each_other() {
    let folder = Folder::new("room-fingers");
    folder.write("part.toml", NOTCHED);
    for (options, radius, clearance) in [
        ("4", 0.5, 0.0),
        ("4", 1.5, 1.0),
        ("4", 3.0, 0.0),
        ("5", 1.0, 0.5),
        ("6 --gap 0.01", 1.5, 0.0),
    ] {
        let report = folder.json(&format!(
            "optimize part.toml --fingers {options} --finger-radius {radius} \
             --clearance {clearance}"
        ));
        let centers = centers(&report, radius);
        for (i, &center) in centers.iter().enumerate() {
            for edge in EDGES {
                assert!(
                    to_segment(center, edge) >= radius - 1e-9,
                    "{options} {radius}: {center:?}"
                );
            }
            for &other in &centers[..i] {
                let apart = distance(center, other) - 2.0 * radius;
                assert!(apart >= clearance - 1e-9, "{options} {radius}: {apart}");
            }
        }
        assert!(number(&report["certificate"]["gap"]) <= 0.01);
    }
}

/// In a nook the best four would overlap: what is found is proved to a gap of its own, and so said.
#[test]
fn tips_that_touch_are_bounded_to_a_millionth() {
    let folder = Folder::new("room-nook");
    let nook = "[part.planar]\nstiffness = 1\n\
        outline = [[0, 0], [6, 0], [6, 2], [2, 2], [2, 6], [0, 6]]\n";
    folder.write("part.toml", nook);
    let ran = folder.run("optimize part.toml --fingers 4 --finger-radius 1");
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert_says(
        &ran.out,
        &["bounded   no placement", "1e-6 is, where tips touch each other, allowed"],
    );
}

#[test]
fn what_is_kept_out_of_and_the_plate_are_repeated_and_drawn() {
    let folder = Folder::new("room-kept");
    let kept = "keep_out = [[[-3, -3], [6, -3], [6, 0.5], [-3, 0.5]]]\n\
        plate = { pitch = [4, 4], offset = [1, -2], travel = 1.5 }\n";
    folder.write("part.toml", NOTCHED.to_owned() + kept);
    let question = "--fingers 4 --finger-radius 1";
    let report = folder.json(&format!("optimize part.toml {question} --svg part.svg"));
    for center in centers(&report, 1.0) {
        // The region is the box from (-3, -3) to (6, 0.5).
        let from = [0, 1].map(|i| center[i].clamp(-3.0, [6.0, 0.5][i]));
        assert!(distance(center, from) >= 1.0 - 1e-9, "{center:?}");
        let off = [(0, 1.0), (1, -2.0)].map(|(i, offset)| {
            let steps = (center[i] - offset) / 4.0;
            4.0 * (steps - f64::round(steps))
        });
        assert!(off[0].hypot(off[1]) <= 1.5 + 1e-9, "{center:?}");
    }
    assert_eq!(list(&report["part"]["planar"]["keep_out"]).len(), 1);
    assert_close(number(&report["part"]["planar"]["plate"]["travel"]), 1.5, 0.0, 1.0, "travel");
    folder.write("report.json", report.to_string());
    assert_eq!(folder.json(&format!("optimize report.json {question}")), report);
    assert_says(
        &folder.run(&format!("optimize part.toml {question}")).out,
        &["tips that do not overlap", "out of 1 region", "over a hole of the plate"],
    );
    assert_says(&std::fs::read_to_string(folder.path("part.svg")).unwrap(), &["kept out of"]);
}

#[test]
fn rooms_that_are_none_are_refused_with_their_place() {
    let folder = Folder::new("room-refused");
    for (fields, pieces) in [
        ("keep_out = [[[0, 0], [1, 1]]]", ["part.planar.keep_out[0]", "2 corners"]),
        ("keep_out = [[[0, 0], [1, nan], [0, 1]]]", ["part.planar.keep_out[0]", "nan"]),
        (
            "plate = { pitch = [0, 1], travel = 1 }",
            ["part.planar.plate", "pitch of the plate is 0"],
        ),
        ("plate = { pitch = [1, 1], travel = 0 }", ["part.planar.plate", "travel over the plate"]),
        (
            "plate = { pitch = [1, 1] }",
            ["part.planar.plate", "missing field `travel`, expected a positive length"],
        ),
        (
            "plate = { travel = 1 }",
            ["missing field `pitch`, expected the distances [x, y] of holes", "positive"],
        ),
        ("plate = { pitch = [1e-7, 1], travel = 1 }", ["holes of the plate", "edge 0"]),
    ] {
        folder.write("part.toml", format!("{NOTCHED}{fields}\n"));
        let ran = folder.run("optimize part.toml --fingers 4 --finger-radius 1");
        assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{fields}: {}", ran.err);
        assert_says(&ran.err, &pieces);
    }
}

/// That nothing is left to touch is an answer to a sound question, whoever asked for what.
#[test]
fn outlines_without_room_have_no_answer() {
    let folder = Folder::new("room-none");
    let all = "keep_out = [[[-99, -99], [99, -99], [99, 99], [-99, 99]]]";
    // 0.5 around the part there is room for fingers, but not for these.
    let frame = "keep_out = [[[-9, -9], [25, -9], [25, -0.5], [-9, -0.5]], \
        [[-9, 8.5], [25, 8.5], [25, 17], [-9, 17]], [[-9, -9], [-0.5, -9], [-0.5, 17], [-9, 17]], \
        [[16.5, -9], [25, -9], [25, 17], [16.5, 17]]]";
    for (fields, options) in [
        (all, ""),
        (frame, " --margin 0.1 --finger-radius 2.5"),
        ("margin = 50", ""),
        ("", " --margin 50"),
        ("forbidden = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]", ""),
        ("plate = { pitch = [100, 100], offset = [50, 50], travel = 1 }", ""),
    ] {
        folder.write("part.toml", format!("{NOTCHED}{fields}\n"));
        let ran = folder.run(&format!("optimize part.toml --fingers 4{options}"));
        assert_eq!(ran.code, Some(3), "{fields} {options}: {}", ran.err);
        assert_says(&ran.err, &["no answer: no stretch of any edge may be touched"]);
        let contact = "[[contacts]]\npoint = [4, 0]\n";
        folder.write("grasp.toml", format!("{NOTCHED}{fields}\n{contact}"));
        // Where fingers may be is no matter to a grasp that is given.
        let given = folder.run("analyze grasp.toml");
        assert_says(&given.err, &["not stable"]);
    }
}

/// By hand: of the perimeter, 54, and the bore, 16, a margin takes two ends of each of 12 edges; a
/// finger of radius 1.5 does not fit into the notch, 2 wide, and keeps 1.5 off the ends of edges
/// in the bore.
#[test]
fn the_share_of_the_outline_where_fingers_have_room_is_reported() {
    let folder = Folder::new("room-share");
    folder.write("part.toml", NOTCHED);
    let access = |options: &str| {
        let report = folder.json(&format!("optimize part.toml --fingers 4 {options}"));
        let outline = &report["accessible"]["outline"];
        let closed: Vec<f64> = list(&outline["closed_edges"]).iter().map(number).collect();
        (number(&outline["share"]), closed)
    };
    let (share, closed) = access("--margin 0.5");
    assert_close(share, 58.0 / 70.0, 1e-12, 1.0, "margin");
    assert!(closed.is_empty(), "{closed:?}");
    let (share, closed) = access("--finger-radius 1.5");
    assert_close(share, 50.0 / 70.0, 1e-12, 1.0, "radius");
    assert_eq!(closed, [3.0, 4.0, 5.0]);
    let whole = folder.json("optimize part.toml --fingers 4");
    assert!(whole.get("accessible").is_none());
    assert_says(
        &folder.run("optimize part.toml --fingers 4 --finger-radius 1.5").out,
        &["room      71.4 % of the outline is accessible; 3 edges not at all: 3, 4, 5\n"],
    );
}
