//! Whether load cases pass: tolerances of the part and of points, lift-off, and `--check`.

use clench_testkit::assert_close;
use clench_testkit::cases::{Value, list, number, numbers};

use crate::run::{Folder, assert_says};

/// A square of side 20 on four springs of 2000, each 3 off the middle of its side, with preloads
/// of 10: to first order 4000 along both axes, and 72000 about its middle (10, 10).
const SQUARE: &str = "[part.planar]\noutline = [[0, 0], [20, 0], [20, 20], [0, 20]]\n\
    stiffness = 2000\n\
    [[contacts]]\npoint = [7, 0]\npreload = 10\n[[contacts]]\npoint = [20, 13]\npreload = 10\n\
    [[contacts]]\npoint = [13, 20]\npreload = 10\n[[contacts]]\npoint = [0, 7]\npreload = 10\n";

/// 4 along x and 8 along y through the middle: (0.001, 0.002) everywhere.
const PUSH: &str = "[[load_cases]]\nname = \"push\"\nforce = [4, 8]\npoint = [10, 10]\n";

fn point(name: &str, fields: &str) -> String {
    format!("[[points]]\nname = \"{name}\"\npoint = [12, 14]\n{fields}\n")
}

fn report(name: &str, file: &str) -> Value {
    let folder = Folder::new(&format!("verdict-{name}"));
    folder.write("grasp.toml", format!("{SQUARE}{file}"));
    folder.json("analyze grasp.toml --order first")
}

/// Of a displacement (0.001, 0.002), along a direction of any length.
#[test]
fn a_point_passes_by_what_it_moves_or_moves_along_a_direction() {
    let length = 0.001_f64.hypot(0.002);
    for (name, fields, found, allowed) in [
        ("any", "tolerance = 0.003", length, 0.003),
        ("too-far", "tolerance = 0.002", length, 0.002),
        ("along-x", "tolerance = 0.0015\ndirection = [7, 0]", 0.001, 0.0015),
        ("against-y", "tolerance = 0.0015\ndirection = [0, -0.1]", 0.002, 0.0015),
        ("aslant", "tolerance = 0.002\ndirection = [3, 4]", 0.0022, 0.002),
    ] {
        let report = report(name, &format!("{}{PUSH}", point("bore", fields)));
        let case = &report["load_cases"][0];
        let of = &case["points"][0];
        assert_eq!(of["tolerance"], allowed);
        assert_close(number(&of["room"]), allowed - found, 1e-13, allowed, "room");
        assert_close(number(&of["margin"]), allowed / found, 1e-12, 1.0, "margin");
        let passes = Value::Bool(found < allowed);
        let overall = [&of["passes"], &case["verdict"]["passes"], &report["verdict"]["passes"]];
        assert_eq!(overall, [&passes; 3], "{name}");
        assert_eq!(case["verdict"]["valid"], true);
        assert_eq!(of.get("along").is_some(), fields.contains("direction"));
        if let Some(along) = of.get("along") {
            let direction = numbers(&of["direction"]);
            assert_close(direction[0].hypot(direction[1]), 1.0, 1e-15, 1.0, "unit");
            let dot = 0.001 * direction[0] + 0.002 * direction[1];
            assert_close(number(along), dot, 1e-12, 0.001, "along");
        }
    }
}

/// In a frame that is turned by a quarter the direction is turned too, the verdict stays.
#[test]
fn a_direction_is_written_in_the_frame_of_the_report() {
    let folder = Folder::new("verdict-frame");
    let file = point("bore", "tolerance = 0.003\ndirection = [0, 1]");
    folder.write("grasp.toml", format!("{SQUARE}{file}{PUSH}"));
    let report = folder.json("analyze grasp.toml --order first --frame 0,0,1.5707963267948966");
    let of = &report["load_cases"][0]["points"][0];
    let direction = numbers(&of["direction"]);
    assert_close(direction[0], 1.0, 1e-15, 1.0, "along the new x");
    assert_close(number(&of["along"]), 0.002, 1e-12, 0.002, "along");
}

/// At (7, 0) and so on: the sum of forces and couple is that of one equivalent force.
#[test]
fn several_forces_act_like_their_sum() {
    let several = "[[load_cases]]\nforce = [1, 0]\npoint = [3, 4]\ntorque = 2\n\
                   \
                   forces = [{ force = [0, -2], point = [20, 0] }, \
                   { force = [3, 1], point = [1, 9] }]\n";
    // Moments about the origin: -4 + 2 - 40 + (1 - 27).
    let one = "[[load_cases]]\nforce = [4, -1]\ntorque = -68\n";
    let report = report("several", &format!("{several}{one}"));
    let [several, one] = [0, 1].map(|i| &report["load_cases"][i]);
    assert_eq!(several["torque"], -68.0);
    assert_eq!(numbers(&several["force"]), [4.0, -1.0]);
    assert_eq!((list(&several["forces"]).len(), several.get("point")), (3, None));
    assert_eq!(numbers(&several["forces"][2]["point"]), [1.0, 9.0]);
    assert_eq!((one.get("forces"), several["couple"].as_f64()), (None, Some(2.0)));
    let [there, here] = [several, one].map(|case| number(&case["largest"]["distance"]));
    assert_close(there, here, 1e-13, here, "distance");
    let folder = Folder::new("verdict-several-text");
    let couple_free = "[[load_cases]]\nforces = [{ force = [0, -2], point = [20, 0] }, \
                       { force = [3, 1], point = [1, 9] }]\n";
    folder.write("grasp.toml", format!("{SQUARE}{couple_free}"));
    let text = folder.run("analyze grasp.toml").out;
    assert_says(&text, &["force (0, -2) F at (20, 0) L, force (3, 1) F at (1, 9) L\n"]);
}

/// 48 along y through the middle takes 24 from a preload of 10.
#[test]
fn a_load_that_lifts_a_contact_off_does_not_pass_however_large_the_tolerance() {
    let lifting = "[[load_cases]]\nforce = [0, 48]\npoint = [10, 10]\ntolerance = 5\n";
    let file = format!("{}{PUSH}{lifting}", point("bore", "tolerance = 5"));
    let report = report("lifting", &file);
    let [push, lifted] = [0, 1].map(|i| &report["load_cases"][i]);
    assert_eq!(
        (&push["verdict"]["passes"], &push["points"][0]["passes"]),
        (&true.into(), &true.into())
    );
    let verdict = &lifted["verdict"];
    assert_eq!((&verdict["passes"], &verdict["valid"]), (&false.into(), &false.into()));
    assert_eq!(lifted["points"][0]["passes"], false);
    let reason = "not valid: contact 0 lifts off at 0.416667 times the load";
    assert_eq!(list(&verdict["reasons"]), [Value::from(reason)]);
    assert_eq!(
        list(&report["verdict"]["reasons"]),
        [Value::from(format!("load case 1: {reason}"))]
    );
    let folder = Folder::new("verdict-lifting-text");
    folder.write("grasp.toml", format!("{SQUARE}{file}"));
    let text = folder.run("analyze grasp.toml --order first").out;
    let pieces = [
        "verdict   FAIL: 1 of 2 load cases fails\n",
        "0 (push)   the part  0.00223607",
        "2.5 (contact 0 off)       holds\n",
        "           bore      0.00223607  5            2.5 (contact 0 off)       pass\n",
        "1          the part  0.012",
        "not valid: contact 0 lifts off at 0.416667 times the load\n",
        "           bore      0.012       5            0.416667 (contact 0 off)  not valid\n",
    ];
    assert_says(&text, &pieces);
}

#[test]
fn a_check_ends_with_its_own_code_and_the_reasons() {
    let folder = Folder::new("verdict-check");
    let exact = "tolerance = 0.0018\ndirection = [0, 1]";
    for (name, file, code, reason) in [
        ("good", PUSH.to_owned() + "tolerance = 0.003\n", 0, ""),
        (
            "part",
            PUSH.to_owned() + "tolerance = 0.002\n",
            3,
            "clench: the check failed: load case 0 (push): the part moves by 0.00223607 L, beyond \
             the tolerance of 0.002 L\n",
        ),
        (
            "point",
            point("bore", exact) + PUSH,
            3,
            "clench: the check failed: load case 0 (push): bore moves along (0, 1) by 0.002 L, \
             beyond the tolerance of 0.0018 L\n",
        ),
        (
            "lift-off",
            PUSH.replace("[4, 8]", "[0, 48]"),
            3,
            "clench: the check failed: load case 0 (push): not valid: contact 0 lifts off at \
             0.416667 times the load\n",
        ),
    ] {
        folder.write("grasp.toml", format!("{SQUARE}{file}"));
        let plain = folder.run("analyze grasp.toml --order first");
        assert_eq!((plain.code, plain.err.as_str()), (Some(0), ""), "{name}");
        let checked = folder.run("analyze grasp.toml --order first --check");
        assert_eq!((checked.code, checked.err.as_str()), (Some(code), reason), "{name}");
        assert_eq!(checked.out, plain.out, "{name}: the report is the same");
    }
    folder.write("grasp.toml", SQUARE);
    let nothing = folder.run("analyze grasp.toml --check");
    assert_eq!((nothing.code, nothing.out.as_str()), (Some(2), ""));
    assert_says(&nothing.err, &["--check: grasp.toml has no load cases", "[[load_cases]]"]);
}

/// What is not held is not checked, but fails.
#[test]
fn load_cases_of_a_part_that_is_not_held_do_not_pass() {
    let folder = Folder::new("verdict-unheld");
    let two = SQUARE.split("[[contacts]]").take(2).collect::<Vec<_>>().join("[[contacts]]");
    folder.write("grasp.toml", format!("{two}{PUSH}"));
    let ran = folder.run("analyze grasp.toml --check --format json");
    assert_eq!(ran.code, Some(3));
    assert_eq!(ran.json()["verdict"]["passes"], false);
    assert_says(&ran.json()["verdict"]["reasons"].to_string(), &["the part"]);
    let text = folder.run("analyze grasp.toml").out;
    assert_says(&text, &["verdict   FAIL: no load case passes: the part is not held\n"]);
}

#[test]
fn verdicts_have_a_color_where_it_is_asked_for_and_never_in_a_pipe() {
    let folder = Folder::new("verdict-color");
    folder.write("grasp.toml", format!("{SQUARE}{PUSH}tolerance = 0.003\n"));
    let plain = folder.run("analyze grasp.toml").out;
    assert!(!plain.contains('\u{1b}'));
    assert_eq!(folder.run("analyze grasp.toml --color never").out, plain);
    assert_eq!(folder.run("analyze grasp.toml --color auto").out, plain);
    let colored = folder.run("analyze grasp.toml --color always").out;
    assert_says(&colored, &["\u{1b}[32mPASS\u{1b}[0m: the load", "\u{1b}[32mpass\u{1b}[0m\n"]);
    let bare = colored.replace("\u{1b}[32m", "").replace("\u{1b}[0m", "");
    assert_eq!(bare, plain, "columns stand where they stood");
    let json = folder.run("analyze grasp.toml --color always --format json").out;
    assert!(!json.contains('\u{1b}'));
    folder.write("grasp.toml", format!("{SQUARE}{PUSH}tolerance = 0.001\n"));
    let colored = folder.run("analyze grasp.toml --color always").out;
    assert_says(&colored, &["\u{1b}[1;31mFAIL\u{1b}[0m: the load case fails", "FAIL\u{1b}[0m\n"]);
}

#[test]
fn tolerances_and_forces_that_are_none_are_refused() {
    let folder = Folder::new("verdict-refused");
    let case = |fields: &str| format!("[[load_cases]]\n{fields}\n");
    for (file, pieces) in [
        (point("a", "tolerance = 0"), ["points[0].tolerance: ", "is 0, but has to be a positive"]),
        (point("a", "tolerance = -1e-3"), ["points[0].tolerance: ", "is -0.001, but"]),
        (point("a", "tolerance = nan"), ["points[0].tolerance: ", "found NaN, expected a finite"]),
        (point("a", "tolerance = \"1\""), ["points[0].tolerance: ", "found text `1`"]),
        (
            point("a", "direction = [0, 1]"),
            ["points[0].direction: ", "without a `tolerance`, expected the largest"],
        ),
        (
            point("a", "tolerance = 1\ndirection = [0, 0]"),
            ["points[0].direction: ", "of length 0, expected one that points"],
        ),
        (
            point("a", "tolerance = 1\ndirection = [0, 0, 1]"),
            ["points[0].direction: ", "found 3 numbers, expected two numbers [x, y]"],
        ),
        (point("a", "direktion = [0, 1]"), ["points[0].direktion: ", "unknown field"]),
        (case("forces = []"), ["load_cases[0]: ", "found neither `force`, `forces` nor"]),
        (
            case("forces = [{ force = [1, 0] }]"),
            ["load_cases[0].forces[0]: ", "missing field `point`, expected two numbers"],
        ),
        (
            case("forces = [{ point = [1, 0] }]"),
            ["load_cases[0].forces[0]: ", "missing field `force`, expected two numbers"],
        ),
        (
            case("forces = [{ force = [1, 0], point = [1, 2, 3] }]"),
            ["load_cases[0].forces[0].point: ", "found 3 numbers, expected two"],
        ),
        (
            case("forces = [{ force = [1, inf], point = [1, 2] }]"),
            ["load_cases[0].forces[0].force[1]: ", "found inf, expected a finite number"],
        ),
        (
            case("forces = [{ force = [1, 0], point = [1, 2], torque = 1 }]"),
            ["load_cases[0].forces[0].torque: ", "unknown field `torque`"],
        ),
        (
            case("point = [1, 1]\nforces = [{ force = [1, 0], point = [1, 2] }]"),
            ["load_cases[0].point: ", "without a `force`, expected both"],
        ),
        (
            case("forces = { force = [1, 0], point = [1, 2] }"),
            ["load_cases[0].forces: ", "found a table, expected a list"],
        ),
        (
            case("forces = [{ force = [1e306, 0], point = [0, 9] }]"),
            ["load_cases[0]: ", "out of range"],
        ),
    ] {
        folder.write("grasp.toml", format!("{SQUARE}{file}"));
        let ran = folder.run("analyze grasp.toml");
        assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{file}: {}", ran.err);
        assert_says(&ran.err, &pieces);
    }
}
