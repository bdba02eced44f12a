//! Load cases: what they do to a part, and what is wrong with some.

use clench_testkit::cases::{Value, list, number, numbers};
use clench_testkit::{assert_all_close, assert_close};

use crate::measures::symmetric_cube;
use crate::run::{Folder, Ran, assert_says};

/// A few dozen products of small numbers.
const ROUNDING: f64 = 1e-13;

/// A square on four springs of 2000, each 3 off the middle of its side, with preloads of 10.
const SQUARE: &str = "[part.planar]\noutline = [[0, 0], [20, 0], [20, 20], [0, 20]]\n\
    stiffness = 2000\n\
    [[contacts]]\npoint = [7, 0]\npreload = 10\n[[contacts]]\npoint = [20, 13]\npreload = 10\n\
    [[contacts]]\npoint = [13, 20]\npreload = 10\n[[contacts]]\npoint = [0, 7]\npreload = 10\n";

const BORE: &str = "[[points]]\nname = \"bore\"\npoint = [12, 14]\n";

const MILLING: &str = "[[load_cases]]\nname = \"milling\"\nforce = [-4, 1]\npoint = [20, 16]\n\
                       torque = 15\ntolerance = 0.02\n";

fn run(name: &str, file: &str, arguments: &str) -> Ran {
    let folder = Folder::new(&format!("load-case-{name}"));
    folder.write("grasp.toml", file);
    folder.run(&format!("analyze grasp.toml{arguments}"))
}

fn report(name: &str, file: &str, arguments: &str) -> Value {
    let ran = run(name, file, &format!(" --format json{arguments}"));
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{name}");
    ran.json()
}

/// To first order the square has 4000 along both axes, and 4 * 2000 * 3^2 about its middle.
#[test]
fn a_planar_load_case_has_the_answer_that_is_computed_by_hand() {
    let report = report("by-hand", &format!("{SQUARE}{BORE}{MILLING}"), " --order first");
    let case = &report["load_cases"][0];
    assert_eq!((&case["name"], &case["tolerance"]), (&"milling".into(), &0.02.into()));
    assert_eq!(numbers(&case["force"]), [-4.0, 1.0]);
    assert_eq!((numbers(&case["point"]), &case["couple"]), (vec![20.0, 16.0], &15.0.into()));
    // About the origin 20 * 1 + 16 * 4 + 15, about the middle 10 * 1 + 6 * 4 + 15.
    assert_eq!(case["torque"], 99.0);
    let turn = 49.0 / 72e3;
    let moved = |[x, y]: [f64; 2]| [-1e-3 - turn * (y - 10.0), 0.25e-3 + turn * (x - 10.0)];
    assert_close(number(&case["displacement"]["rotation"]), turn, ROUNDING, turn, "rotation");
    let found = [
        (&case["displacement"]["translation"], [0.0, 0.0]),
        (&case["points"][0]["displacement"], [12.0, 14.0]),
        (&case["largest"]["displacement"], [20.0, 20.0]),
    ];
    for (found, point) in found {
        assert_all_close(&numbers(found), &moved(point), ROUNDING, format!("{point:?}"));
    }
    assert_eq!(
        (&case["points"][0]["name"], &case["largest"]["corner"]),
        (&"bore".into(), &2.into())
    );
    let [x, y] = moved([20.0, 20.0]);
    let largest = x.hypot(y);
    assert_close(number(&case["largest"]["distance"]), largest, ROUNDING, largest, "distance");
    assert_close(number(&case["margin"]), 0.02 / largest, ROUNDING, 2.0, "margin");
    // A finger is pressed by what the part moves against its inward normal.
    let changes = [
        -2e3 * moved([7.0, 0.0])[1],
        2e3 * moved([20.0, 13.0])[0],
        2e3 * moved([13.0, 20.0])[1],
        -2e3 * moved([0.0, 7.0])[0],
    ];
    for (found, change) in list(&case["contact_forces"]).iter().zip(changes) {
        assert_close(number(&found["change"]), change, ROUNDING, 10.0, "change");
        assert_close(number(&found["force"]), 10.0 + change, ROUNDING, 10.0, "force");
    }
    // The changes are 3.6, -6.1, 4.6 and -2.1.
    assert_eq!(case["first_to_lift_off"]["contact"], 1);
    let factor = number(&case["first_to_lift_off"]["load_factor"]);
    assert_close(factor, -10.0 / changes[1], ROUNDING, factor, "load factor");
    assert_eq!(case["valid_to"], factor);
    assert_eq!(list(&report["warnings"]).len(), 0);
}

#[test]
fn a_frame_changes_the_coordinates_of_load_cases_only() {
    let file = format!("{SQUARE}{BORE}{MILLING}");
    // A quarter turn about (3, 5): (x, y) becomes (y - 5, 3 - x).
    let frame = " --frame 3,5,1.5707963267948966";
    let [here, there] = [("frame-here", ""), ("frame-there", frame)]
        .map(|(name, frame)| report(name, &file, frame)["load_cases"][0].clone());
    for key in ["margin", "contact_forces", "first_to_lift_off", "tolerance", "name"] {
        assert_eq!(here[key], there[key], "{key}");
    }
    assert_eq!(here["displacement"]["rotation"], there["displacement"]["rotation"]);
    assert_all_close(&numbers(&there["force"]), &[1.0, 4.0], ROUNDING, "force");
    // About (3, 5): 17 * 1 + 11 * 4 + 15.
    assert_close(number(&there["torque"]), 76.0, ROUNDING, 76.0, "torque");
    assert_all_close(&numbers(&there["point"]), &[11.0, -17.0], ROUNDING, "where it acts");
    assert_eq!(there["couple"], 15.0);
    assert_all_close(&numbers(&there["points"][0]["point"]), &[9.0, -9.0], ROUNDING, "point");
    for key in ["points", "largest"] {
        let [old, new] = [&here, &there].map(|case| match &case[key] {
            Value::Array(points) => numbers(&points[0]["displacement"]),
            point => numbers(&point["displacement"]),
        });
        assert_all_close(&new, &[old[1], -old[0]], ROUNDING, key);
    }
    let old = numbers(&here["displacement"]["translation"]);
    let turn = number(&here["displacement"]["rotation"]);
    let moved = [old[1] + turn * 3.0, -(old[0] - turn * 5.0)];
    let new = numbers(&there["displacement"]["translation"]);
    assert_all_close(&new, &moved, ROUNDING, "translation");
}

#[test]
fn a_torque_of_space_turns_a_cube_about_its_middle() {
    let file = symmetric_cube(0.5) + "[[load_cases]]\ntorque = [0, 0, 0.3]\n";
    let report = report("torque", &file, " --order first");
    let case = &report["load_cases"][0];
    // Four fingers resist a turn about z, with an arm of 1/2 each: 4 * 3 / 4.
    let turn = 0.1;
    let rotation = numbers(&case["displacement"]["rotation"]);
    assert_all_close(&rotation, &[0.0, 0.0, turn], ROUNDING, "rotation");
    let translation = numbers(&case["displacement"]["translation"]);
    assert_all_close(&translation, &[turn, -turn, 0.0], ROUNDING, "of the origin");
    let distance = number(&case["largest"]["distance"]);
    assert_close(distance, turn * 2.0_f64.sqrt(), ROUNDING, distance, "distance");
    let changes: Vec<f64> =
        list(&case["contact_forces"]).iter().map(|contact| number(&contact["change"])).collect();
    let expected = [&[0.0; 8][..], &[0.15, -0.15, -0.15, 0.15]].concat();
    assert_all_close(&changes, &expected, ROUNDING, "changes");
    let factor = number(&case["first_to_lift_off"]["load_factor"]);
    assert_close(factor, 0.5 / 0.15, ROUNDING, factor, "load factor");
    assert_eq!(numbers(&case["couple"]), [0.0, 0.0, 0.3]);
    for key in ["name", "margin", "tolerance", "point"] {
        assert_eq!(case.get(key), None, "{key}");
    }
    assert_eq!((list(&case["points"]).len(), &report["warnings"]), (0, &Value::Array(vec![])));
}

#[test]
fn a_load_of_nothing_moves_nothing() {
    let case = "[[load_cases]]\nforce = [0, 0]\ntolerance = 1\n";
    let report = report("nothing", &format!("{SQUARE}{case}"), "");
    let case = &report["load_cases"][0];
    assert_eq!((&case["largest"]["distance"], &case["tolerance"]), (&0.0.into(), &1.0.into()));
    for key in ["margin", "first_to_lift_off", "valid_to", "couple"] {
        assert_eq!(case.get(key), None, "{key}");
    }
}

/// Coordinates are whole numbers at both places, and so the same from the part.
#[test]
fn a_grasp_far_from_the_origin_is_answered_alike() {
    let square = |off: f64, along: f64| {
        let at = |x: f64, y: f64| format!("[{}, {}]", x + off, y + along);
        let corners = [at(0.0, 0.0), at(20.0, 0.0), at(20.0, 20.0), at(0.0, 20.0)].join(", ");
        let contacts = [at(7.0, 0.0), at(20.0, 13.0), at(13.0, 20.0), at(0.0, 7.0)];
        let contacts =
            contacts.map(|point| format!("[[contacts]]\npoint = {point}\npreload = 10\n"));
        format!(
            "[part.planar]\noutline = [{corners}]\nstiffness = 2000\n{}\
             [[points]]\nname = \"bore\"\npoint = {}\n\
             [[load_cases]]\nforce = [-4, 1]\npoint = {}\ntorque = 15\n",
            contacts.concat(),
            at(12.0, 14.0),
            at(20.0, 16.0)
        )
    };
    let [here, there] = [("here", 0.0, 0.0), ("there", 2e7, -1.5e7)].map(|(name, off, along)| {
        let name = format!("far-{name}");
        report(&name, &square(off, along), " --order second")["load_cases"][0].clone()
    });
    let far = 1e-9;
    for key in ["largest", "points"] {
        let [old, new] = [&here, &there].map(|case| match &case[key] {
            Value::Array(points) => points[0].clone(),
            point => point.clone(),
        });
        let [distance, moved] = [&old, &new].map(|point| number(&point["distance"]));
        assert_close(moved, distance, far, distance, key);
        let [wanted, found] = [&old, &new].map(|point| numbers(&point["displacement"]));
        assert_all_close(&found, &wanted, far * distance, key);
    }
    let changes = |case: &Value| -> Vec<f64> {
        list(&case["contact_forces"]).iter().map(|contact| number(&contact["change"])).collect()
    };
    assert_all_close(&changes(&there), &changes(&here), far, "changes");
    let [old, new] = [&here, &there].map(|case| number(&case["valid_to"]));
    assert_close(new, old, far, old, "load factor");
}

/// A finger that has let go resists no more, so that a margin beyond that is none.
#[test]
fn a_margin_beyond_the_lift_off_is_not_promised() {
    // The largest displacement is 0.0105, and contact 1 lifts off at 1.64 times the load.
    for (tolerance, wanted) in [
        ("0.017", "within the tolerance of 0.017 L, which allows 1.6157 times this load"),
        (
            "0.018",
            "the tolerance of 0.018 L is kept at least until contact 1 lifts off, at 1.64384 times",
        ),
    ] {
        let case = MILLING.replace("tolerance = 0.02", &format!("tolerance = {tolerance}"));
        let file = format!("{SQUARE}{case}");
        let ran = run(&format!("margin-{tolerance}"), &file, " --order first");
        assert_says(&ran.out, &[wanted]);
        assert_eq!(ran.out.matches("allows").count(), usize::from(tolerance == "0.017"));
        let name = format!("margin-json-{tolerance}");
        let report = report(&name, &file, " --order first");
        let case = &report["load_cases"][0];
        assert_eq!(case["valid_to"], case["first_to_lift_off"]["load_factor"]);
        let margin = number(&case["margin"]);
        assert_eq!(margin > number(&case["valid_to"]), tolerance == "0.018");
    }
}

#[test]
fn text_and_warnings_say_what_a_load_case_does() {
    let huge = MILLING.replace("[-4, 1]", "[-8, 2]").replace("torque = 15", "torque = 30");
    let unnamed = huge.replace("name = \"milling\"\n", "");
    let file = format!("{SQUARE}{BORE}{MILLING}{unnamed}");
    let ran = run("text", &file, " --order first");
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert_says(
        &ran.out,
        &[
            "limited by rotation\nverdict   FAIL: 1 of 2 load cases fails\n",
            "load case 0 (milling): on top of the state at rest, force (-4, 1) F at (20, 16) L, \
             couple 15 F L\n",
            "the part turns by 0.000680556 rad\n",
            "corner 2, the largest  (20, 20)  (-0.00780556, 0.00705556)  0.0105218",
            "bore                   (12, 14)  (-0.00372222, 0.00161111)  0.00405594",
            "contact  change [F]  force [F]\n0        3.58333     13.5833\n",
            "contact 1 lifts off first, at 1.64384 times this load",
            "the tolerance of 0.02 L is kept at least until contact 1 lifts off, at 1.64384 times",
            "load case 1: on top",
            "1        -12.1667    off\n",
            "the tolerance of 0.02 L is kept at least until contact 1 lifts off, at 0.821918 times",
            "warning   under load case 1 contact 1 lifts off at 0.821918 times the load: a finger",
            "warning   under load case 1 the part moves by 0.0210435 L, beyond the tolerance",
        ],
    );
    assert_eq!(ran.out.matches("warning").count(), 2, "{}", ran.out);
    let nothing = "[[load_cases]]\ntorque = 0\ntolerance = 0.02\n";
    let ran = run("text-nothing", &format!("{SQUARE}{nothing}"), "");
    let pieces = [
        "verdict   PASS: the load case passes\n",
        "0          the part  0          0.02         any     pass\n",
        "on top of the state at rest, couple 0 F L\n",
        "the part turns by 0 rad\n",
        "no contact loses force under this load",
        "within the tolerance of 0.02 L: nothing moves",
    ];
    assert_says(&ran.out, &pieces);
}

/// What moves a part that nothing holds is no question.
#[test]
fn a_part_that_is_not_held_has_no_load_cases() {
    let two = SQUARE.split("[[contacts]]").take(2).collect::<Vec<_>>().join("[[contacts]]");
    let ran = run("not-held", &format!("{two}{MILLING}"), " --format json");
    assert_eq!((ran.code, ran.json().get("load_cases")), (Some(3), None));
}

/// The part of a grasp file is a part file too, and a report of `optimize` has no load cases.
#[test]
fn optimize_reads_over_points_and_load_cases() {
    let folder = Folder::new("load-case-optimize");
    folder.write("grasp.toml", format!("{SQUARE}{BORE}{MILLING}"));
    let optimum = folder.run("optimize grasp.toml --fingers 4 --format json");
    folder.write("optimum.json", &optimum.out);
    assert_eq!(folder.json("analyze optimum.json").get("load_cases"), None);
}

fn refused(name: &str, part: &str, lines: &str, pieces: &[&str]) {
    let ran = run(&format!("refused-{name}"), &format!("{part}{lines}\n"), "");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{name}: {}", ran.err);
    assert_says(&ran.err, pieces);
}

#[test]
fn load_cases_that_are_none_are_refused() {
    for (name, fields, pieces) in [
        (
            "nothing",
            "",
            ["load_cases[0]: ", "neither `force`, `forces` nor `torque`", "at least one"],
        ),
        (
            "where",
            "point = [1, 2]",
            ["load_cases[0]: ", "neither `force`, `forces` nor `torque`", "at least one"],
        ),
        ("nan", "force = [nan, 1]", ["load_cases[0].force[0]: ", "found NaN", "a finite number"]),
        ("inf", "torque = inf", ["load_cases[0].torque: ", "found inf", "a finite number"]),
        ("one", "force = [1]", ["load_cases[0].force: ", "found a list of 1", "[x, y]"]),
        ("space", "force = [1, 2, 3]", ["load_cases[0].force: ", "found 3 numbers", "[x, y]"]),
        (
            "place",
            "force = [1, 2]\npoint = [1, 2, 3]",
            ["load_cases[0].point: ", "found 3 numbers", "two numbers [x, y], as the part has"],
        ),
        (
            "torque",
            "torque = [0, 0, 1]",
            [
                "load_cases[0].torque: ",
                "a list of three",
                "expected one number: the part is planar",
            ],
        ),
        ("short", "torque = [1]", ["load_cases[0].torque: ", "a list of 1", "three numbers"]),
        (
            "word",
            "torque = \"big\"",
            ["load_cases[0].torque: ", "text `big`", "a finite number, or three"],
        ),
        (
            "negative",
            "torque = 1\ntolerance = -0.1",
            ["load_cases[0].tolerance: ", "is -0.1", "a positive number"],
        ),
        ("zero", "torque = 1\ntolerance = 0", ["load_cases[0].tolerance: ", "is 0", "positive"]),
        (
            "tolerance",
            "torque = 1\ntolerance = nan",
            ["load_cases[0].tolerance: ", "NaN", "finite number"],
        ),
        ("name", "torque = 1\nname = \" \"", ["load_cases[0].name: ", "text ` `", "a name"]),
        ("number", "torque = 1\nname = 7", ["load_cases[0].name: ", "a number", "a name"]),
        ("field", "moment = 1", ["load_cases[0].moment: ", "unknown field `moment`", "`torque`"]),
        ("huge", "force = [1e306, 0]", ["load_cases[0]: ", "out of range", "nearer to 1"]),
    ] {
        refused(name, SQUARE, &format!("[[load_cases]]\n{fields}"), &pieces);
    }
    let pieces = ["load_cases: ", "found a table", "expected a list"];
    refused("table", SQUARE, "[load_cases]\nforce = [1, 0]", &pieces);
    let cube = symmetric_cube(0.0);
    for (name, fields, pieces) in [
        ("flat", "torque = 1", ["load_cases[0].torque: ", "found one number", "[x, y, z]"]),
        ("pair", "force = [1, 2]", ["load_cases[0].force: ", "found 2 numbers", "[x, y, z]"]),
    ] {
        refused(name, &cube, &format!("[[load_cases]]\n{fields}"), &pieces);
    }
}

#[test]
fn points_that_are_none_are_refused() {
    let other = BORE.replace("[12, 14]", "[1, 1]");
    for (name, lines, pieces) in [
        (
            "twice",
            format!("{BORE}{other}"),
            ["points[1].name: ", "found the name of points[0] again", "another one"],
        ),
        (
            "nameless",
            "[[points]]\npoint = [1, 2]".to_owned(),
            ["points[0]: ", "missing field `name`", "a name"],
        ),
        (
            "empty",
            "[[points]]\nname = \"\"\npoint = [1, 2]".to_owned(),
            ["points[0].name: ", "text ``", "at least one letter"],
        ),
        (
            "lines",
            "[[points]]\nname = \"a\\nb\"\npoint = [1, 2]".to_owned(),
            ["points[0].name: ", "text `a\\nb`", "on one line"],
        ),
        (
            "nowhere",
            "[[points]]\nname = \"a\"".to_owned(),
            ["points[0]: ", "missing field `point`", "two numbers [x, y], or"],
        ),
        (
            "spatial",
            "[[points]]\nname = \"a\"\npoint = [1, 2, 3]".to_owned(),
            ["points[0].point: ", "found 3 numbers", "two numbers [x, y], as the part has"],
        ),
        (
            "infinite",
            "[[points]]\nname = \"a\"\npoint = [1, inf]".to_owned(),
            ["points[0].point[1]: ", "inf", "finite number"],
        ),
        ("radius", format!("{BORE}radius = 1"), ["points[0].radius: ", "unknown field", "`point`"]),
    ] {
        refused(&format!("point-{name}"), SQUARE, &lines, &pieces);
    }
    // So far away that it moves out of range.
    let far = BORE.replace("[12, 14]", "[1e306, 0]");
    refused(
        "far",
        SQUARE,
        &format!("{far}{MILLING}"),
        &["points[0]: ", "load_cases[0] moves the point out"],
    );
}

/// A soft grasp under a load that would turn the part by half a radian.
#[test]
fn a_displacement_that_is_not_small_is_a_warning() {
    let folder = Folder::new("not-small");
    let parts = concat!(env!("CARGO_MANIFEST_DIR"), "/../../parts/ellipsoid-grasp.toml");
    let grasp = std::fs::read_to_string(parts).unwrap();
    let file = format!("{grasp}\n[[load_cases]]\ntorque = [500, 0, 0]\n");
    folder.write("grasp.toml", &file);
    let result = folder.run("analyze grasp.toml");
    assert_eq!(result.code, Some(0));
    assert!(result.out.contains("that is not small"), "{}", result.out);
    folder.write("grasp.toml", file.replace("[500, 0, 0]", "[5, 0, 0]"));
    assert!(!folder.run("analyze grasp.toml").out.contains("not small"));
}

/// Two fingers hold nothing: a load case has no answer, and the report says so.
#[test]
fn load_cases_of_a_part_that_is_not_held_are_named_as_unanswered() {
    let folder = Folder::new("unanswered-cases");
    folder.write(
        "grasp.toml",
        "part.planar = { outline = [[0, 0], [4, 0], [4, 4], [0, 4]], stiffness = 1 }\n\
         [[contacts]]\npoint = [2, 0]\n[[contacts]]\npoint = [2, 4]\n\
         [[load_cases]]\nforce = [1, 0]\n",
    );
    let result = folder.run("analyze grasp.toml");
    assert_eq!(result.code, Some(3));
    assert!(result.out.contains("1 load case not answered"), "{}", result.out);
}

/// Coordinates whose products overflow would leave entries that are no numbers.
#[test]
fn a_frame_out_of_range_is_wrong_usage() {
    let folder = Folder::new("far-frame");
    let result = folder.run("analyze grasp.toml --frame 1e200,0,0");
    assert_eq!(result.code, Some(2));
    assert!(result.err.contains("1e200") && result.err.contains("1e90"), "{}", result.err);
}
