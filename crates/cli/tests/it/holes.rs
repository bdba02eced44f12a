//! Outlines with holes, from file to report and picture.

use clench_testkit::assert_close;
use clench_testkit::cases::{Value, list, number};

use crate::run::{Folder, assert_says};

/// A square plate with a square hole, in the corners' order of the file.
const FRAME: &str = "[part.planar]\n\
    outline = [[0, 0], [8, 0], [8, 8], [0, 8]]\n\
    holes = [[[3, 3], [5, 3], [5, 5], [3, 5]]]\n\
    stiffness = 1\n";

#[test]
fn fingers_are_placed_in_holes_where_nothing_else_may_be_touched() {
    let folder = Folder::new("holes-inside");
    folder.write("part.toml", FRAME.to_owned() + "forbidden = [0, 1, 2, 3]\n");
    let report = folder.json("optimize part.toml --fingers 4 --svg part.svg");
    // Four unit springs on a square of side 2, as levers at its corners: mu = 4 * 1^2, on a part
    // whose corners are 4 sqrt(2) from the center.
    assert_close(number(&report["mu_eq"]), 4.0 / 32.0, 1e-12, 1.0, "mu_eq");
    for contact in list(&report["contacts"]) {
        let (edge, normal) = (number(&contact["edge"]), list(&contact["inward_normal"]));
        let [nx, ny] = [0, 1].map(|i| number(&normal[i]));
        let expected = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];
        let place = expected.iter().position(|e| e[0] * nx + e[1] * ny > 0.99).unwrap();
        assert_close(edge, 4.0 + place as f64, 0.0, 1.0, "edge");
    }
    let drawn = std::fs::read_to_string(folder.path("part.svg")).unwrap();
    assert_eq!(drawn.matches("fill-rule=\"evenodd\"").count(), 2);
    // The report is a grasp file with the hole.
    folder.write("grasp.json", report.to_string());
    let grasp: Value = folder.json("analyze grasp.json --order first");
    assert_close(number(&grasp["quality"]), 0.125, 1e-12, 1.0, "quality");
}

#[test]
fn faults_of_holes_are_told_with_their_place() {
    let folder = Folder::new("holes-faults");
    for (holes, pieces) in [
        ("[[[3, 3], [5, 3]]]", ["part.planar.holes[0]", "found 2 corners, expected at least 3"]),
        ("[[[3, 3], [5, 3], [nan, 5]]]", ["part.planar.holes[0]", "nan"]),
        (
            "[[[3, 3], [5, 3], [5, 5]], [[1, 1], [2, 1], [2, 1]]]",
            ["part.planar.holes[1][2]", "the same point"],
        ),
        ("[[[3, 3], [5, 3], [5, 5]], []]", ["part.planar.holes[1]", "found 0 corners"]),
        ("[[[6, 6], [9, 6], [6, 9]]]", ["part.planar.holes[0]", "cross or touch"]),
        ("[[[9, 9], [10, 9], [9, 10]]]", ["part.planar.holes[0]", "outside the outline"]),
        (
            "[[[1, 1], [7, 1], [7, 7], [1, 7]], [[3, 3], [5, 3], [5, 5]]]",
            ["part.planar.holes[1]", "within hole 0"],
        ),
        ("[[[1, 1], [2, 2], [3, 3]]]", ["part.planar.holes[0]", "on one line"]),
    ] {
        let part = FRAME.replace("[[[3, 3], [5, 3], [5, 5], [3, 5]]]", holes);
        folder.write("part.toml", part);
        let ran = folder.run("optimize part.toml --fingers 4");
        assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{holes}");
        assert_says(&ran.err, &pieces);
    }
    let ellipse = "[part.planar]\nellipse = [2, 1]\nholes = [[[0, 0], [0.1, 0], [0, 0.1]]]\n\
        [[contacts]]\npoint = [2, 0]\nlaw = { kind = \"linear\", stiffness = 1 }\n";
    folder.write("grasp.toml", ellipse);
    assert_says(&folder.run("analyze grasp.toml").err, &["found `holes`", "only an `outline` has"]);
}
