//! Sound parts in unusual forms, and the example files.

use std::path::Path;

use clench_testkit::assert_close;
use clench_testkit::cases::{Value, list, number};

use crate::run::{Folder, QUADRILATERAL, Ran, command, part};

/// The search and a change of units round some hundred times.
const ROUNDING: f64 = 1e-12;

fn optimum(name: &str, content: &str) -> Value {
    let folder = Folder::new(name);
    folder.write("part.toml", content);
    folder.json("optimize part.toml --fingers 4")
}

#[test]
fn a_clockwise_outline_has_the_same_optimum_on_its_own_edge_numbers() {
    let report = optimum("clockwise", &part("[[0, 0], [2, 6], [9, 8], [13, 0]]", "1"));
    assert_close(number(&report["quality"]), 2.0 - 0.1_f64.sqrt(), ROUNDING, 1.0, "Q");
    let edges: Vec<f64> = list(&report["contacts"]).iter().map(|c| number(&c["edge"])).collect();
    assert_eq!(edges, [0.0, 2.0, 3.0, 3.0]);
}

#[test]
fn a_corner_within_a_straight_side_changes_nothing() {
    let report = optimum("collinear", &part("[[0, 0], [6.5, 0], [13, 0], [9, 8], [2, 6]]", "1"));
    assert_close(number(&report["quality"]), 2.0 - 0.1_f64.sqrt(), ROUNDING, 1.0, "Q");
    assert_close(number(&report["mu_eq"]), 84.5 / 45.3125, ROUNDING, 1.0, "mu_eq");
}

#[test]
fn quality_does_not_change_with_the_size_and_scales_with_the_stiffness() {
    for (size, name) in [(1e-9, "tiny"), (1e9, "huge")] {
        let corners = [[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]];
        let outline = corners.map(|corner| corner.map(|v: f64| v * size));
        let report = optimum(name, &part(&format!("{outline:?}"), "1"));
        assert_close(number(&report["quality"]), 2.0 - 0.1_f64.sqrt(), ROUNDING, 1.0, name);
        let reach = number(&report["reach"]["distance"]);
        assert_close(reach, 45.3125_f64.sqrt() * size, ROUNDING, reach, name);
    }
    // A power of two is exact in every step.
    let report = optimum("stiff", &part(QUADRILATERAL, "4096"));
    let soft = optimum("soft", &part(QUADRILATERAL, "1"));
    let expected = 4096.0 * number(&soft["quality"]);
    assert_close(number(&report["quality"]), expected, 0.0, 1.0, "4096 times as stiff");
}

#[test]
fn one_stiffness_per_edge_is_the_same_as_one_for_all_when_they_are_equal() {
    let each = optimum("each", &part(QUADRILATERAL, "[1, 1, 1, 1]"));
    let all = optimum("all", &part(QUADRILATERAL, "1"));
    assert_eq!(each["contacts"], all["contacts"]);
    assert_eq!(each["part"]["planar"]["stiffness"].as_array().map(Vec::len), Some(4));
}

#[test]
fn byte_order_marks_line_ends_and_json_are_all_read() {
    let plain = "version = 1\nunits = { length = \"mm\", force = \"N\" }\n".to_owned()
        + &part(QUADRILATERAL, "1");
    let expected = optimum("plain", &plain);
    let windows = format!("\u{feff}{}", plain.replace('\n', "\r\n"));
    assert_eq!(optimum("windows", &windows), expected);
    let json = format!(
        "\u{feff}{{\"version\": 1, \"units\": {{\"length\": \"mm\", \"force\": \"N\"}},\r\n \
         \"part\": {{\"planar\": {{\"outline\": {QUADRILATERAL}, \"stiffness\": 1}}}}}}"
    );
    let folder = Folder::new("json");
    for name in ["part.json", "part"] {
        folder.write(name, &json);
        assert_eq!(folder.json(&format!("optimize {name} --fingers 4")), expected, "{name}");
    }
}

#[test]
fn the_example_files_have_answers() {
    let parts = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../parts");
    for (arguments, answer) in [
        ("optimize bracket.toml --fingers 4", "Q = 69865.7 N/mm, limited by translation"),
        ("optimize bracket.toml --fingers 3 --preload 400", "Q = 3.53882 N/mm"),
        ("optimize quadrilateral.toml --fingers 4", "Q = 1.68377 F/L"),
        ("analyze quadrilateral-grasp.toml", "Q = 1.1138 F/L"),
        // Six flat jaws, by hand: 2 f (b^2 - c^2) (1 / c - 1 / b) about the longest axis.
        (
            "analyze ellipsoid-grasp.toml",
            "mu_min    233.333           (1, 0, 0)  (0, 0, 0)     0           20",
        ),
        ("analyze cube-grasp.toml", "force closure         yes"),
        ("analyze cube-grasp.toml", "contact 1 lifts off first, at 5.23414 times this load"),
    ] {
        let ran = command(arguments.split(' ')).current_dir(&parts).output().unwrap();
        let ran = Ran::new(&ran);
        assert_eq!(ran.code, Some(0), "{arguments}: {}", ran.err);
        assert!(ran.out.contains(answer), "{arguments}: {}", ran.out);
    }
}
