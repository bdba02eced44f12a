//! Preloads that keep all contacts on: suggested, typed into the file, and analyzed again.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use clench_testkit::assert_close;
use clench_testkit::cases::{Value, list, number, numbers};

use crate::run::{Folder, assert_says};

/// Two contacts below, one at each other side: two ways to balance. One load lifts, one pushes
/// aside.
fn clamped(law: &str, preloads: [f64; 5]) -> String {
    let points = ["[4, 0]", "[17, 0]", "[20, 8]", "[11, 20]", "[0, 12]"];
    let contact = |(point, preload): (&str, f64)| {
        format!("[[contacts]]\npoint = {point}\npreload = {preload:?}\n{law}\n")
    };
    let contacts: String = points.into_iter().zip(preloads).map(contact).collect();
    format!(
        "part.planar = {{ outline = [[0, 0], [20, 0], [20, 20], [0, 20]], stiffness = 2000 }}\n\
         {contacts}[[load_cases]]\nname = \"lift\"\nforce = [3, 12]\npoint = [9, 20]\n\
         [[load_cases]]\nname = \"push\"\nforce = [-9, 2]\npoint = [20, 15]\ntorque = 6\n"
    )
}

/// c = e turns the part by 4 c: 13 b = 7 d + 4 c, and a is the rest.
fn balanced(sides: f64, top: f64) -> [f64; 5] {
    let right = (7.0 * top + 4.0 * sides) / 13.0;
    [top - right, right, sides, top, sides]
}

const STIFFENING: &str = "law = { kind = \"power\", coefficient = 3e4, exponent = 1.5 }";

fn needed(folder: &Folder, file: &str, options: &str) -> Value {
    folder.write("grasp.toml", file);
    folder.json(&format!("analyze grasp.toml{options}"))["needed_preloads"].clone()
}

/// The least load factor at which a contact lifts off, and whether the load cases are valid.
fn analyzed(folder: &Folder, file: &str, options: &str) -> (f64, bool) {
    folder.write("again.toml", file);
    let report = folder.json(&format!("analyze again.toml{options}"));
    let cases = list(&report["load_cases"]);
    let factor = |case: &Value| case.get("valid_to").map_or(f64::INFINITY, number);
    let valid = cases.iter().all(|case| case["verdict"]["valid"] == true);
    (cases.iter().map(factor).fold(f64::INFINITY, f64::min), valid)
}

fn preloads(remedy: &Value) -> [f64; 5] {
    numbers(&remedy["preloads"]).try_into().unwrap()
}

#[test]
fn with_the_preloads_of_the_report_no_contact_lifts_off_and_with_less_one_does() {
    let folder = Folder::new("needed");
    for (law, options) in [("", ""), ("", " --order first"), (STIFFENING, "")] {
        let needed = needed(&folder, &clamped(law, balanced(2.0, 3.0)), options);
        let totals = ["least", "scaled"].map(|remedy| {
            let remedy = &needed[remedy];
            assert_eq!(remedy["basis"], "needed");
            let found = preloads(remedy);
            let (factor, valid) = analyzed(&folder, &clamped(law, found), options);
            assert_close(factor, 1.0, 1e-8, 1.0, "load factor");
            assert!(valid);
            let less = found.map(|preload| 0.999 * preload);
            let (factor, valid) = analyzed(&folder, &clamped(law, less), options);
            assert!(factor < 0.9995 && !valid, "{factor}");
            let least = numbers(&remedy["least_forces"]).into_iter().fold(f64::INFINITY, f64::min);
            assert_close(least, 0.0, 1e-9, 10.0, "used up");
            let forces = list(&remedy["contact_forces"]);
            assert_eq!((forces.len(), numbers(&forces[1]).len()), (2, 5));
            number(&remedy["total"])
        });
        assert!(totals[0] < 0.99 * totals[1], "{totals:?}");
        let factor = number(&needed["scaled"]["factor"]);
        let present: f64 = balanced(2.0, 3.0).iter().sum();
        assert_close(factor, totals[1] / present, 1e-12, factor, "factor");
    }
}

/// Of steel balls, without any number in common with the preloads of the file.
#[test]
fn the_cube_of_the_examples_keeps_its_balls_with_less() {
    let folder = Folder::new("needed-cube");
    let parts = concat!(env!("CARGO_MANIFEST_DIR"), "/../../parts/cube-grasp.toml");
    let file = std::fs::read_to_string(parts).unwrap();
    let needed = needed(&folder, &file, "");
    // Seven contacts balance in one way only: the least are the scaled ones.
    let [least, scaled] = ["least", "scaled"].map(|remedy| numbers(&needed[remedy]["preloads"]));
    for (least, scaled) in least.iter().zip(&scaled) {
        assert_close(*least, *scaled, 1e-8, *scaled, "preload");
    }
    let factor = number(&needed["scaled"]["factor"]);
    assert!(factor < 1.0, "{factor}");
    let scaled_by = |s: f64| {
        let file = file.replace("preload = 100", &format!("preload = {:?}", 100.0 * factor * s));
        file.replace("preload = 200", &format!("preload = {:?}", 200.0 * factor * s))
    };
    assert!(analyzed(&folder, &scaled_by(1.0), "").1);
    assert!(!analyzed(&folder, &scaled_by(0.999), "").1);
}

#[test]
fn a_reserve_is_kept_of_each_preload() {
    let folder = Folder::new("needed-reserve");
    let file = clamped("", balanced(2.0, 3.0));
    let options = " --order first --reserve 0.25";
    let needed = needed(&folder, &file, options);
    assert_eq!(needed["reserve"], 0.25);
    for remedy in ["least", "scaled"] {
        let found = preloads(&needed[remedy]);
        let forces = numbers(&needed[remedy]["least_forces"]);
        let left = found.iter().zip(&forces).filter(|(preload, _)| **preload > 0.0);
        let least = left.map(|(preload, force)| force / preload).fold(f64::INFINITY, f64::min);
        assert_close(least, 0.25, 1e-9, 1.0, remedy);
        let (factor, _) = analyzed(&folder, &clamped("", found), " --order first");
        assert_close(factor, 4.0 / 3.0, 1e-8, 1.0, "load factor");
    }
    for (reserve, found) in [("1", "found 1,"), ("-0.1", "found -0.1,"), ("nan", "found `nan`,")] {
        let ran = folder.run(&format!("analyze grasp.toml --reserve {reserve}"));
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
        assert_says(&ran.err, &[found, "--reserve <R>"]);
    }
}

/// Typed from the text, with nine digits.
#[test]
fn the_digits_of_the_text_are_enough() {
    let folder = Folder::new("needed-text");
    folder.write("grasp.toml", clamped("", balanced(2.0, 3.0)));
    let text = folder.run("analyze grasp.toml").out;
    let pieces = [
        "preloads under which no contact lifts off, whatever load case acts\n",
        "contact  present [F]  least total [F]  least total, under load [F]  all times ",
        "under load: the least force of the contact under any load case\n",
    ];
    assert_says(&text, &pieces);
    let rows = text.split("whatever load case acts\n").nth(1).unwrap().lines();
    let column = |column: usize| -> [f64; 5] {
        let cell = |row: &str| row.split_whitespace().nth(column).unwrap().parse().unwrap();
        rows.clone().skip(1).take(5).map(cell).collect::<Vec<f64>>().try_into().unwrap()
    };
    for remedy in [2, 4] {
        let (factor, valid) = analyzed(&folder, &clamped("", column(remedy)), "");
        assert!(valid && factor < 1.0 + 1e-6, "{factor}");
    }
}

#[test]
fn what_no_preload_prevents_is_said() {
    let folder = Folder::new("needed-none");
    // Nothing presses from above; to first order three springs hold the part all the same.
    let three = "[part.planar]\noutline = [[0, 0], [20, 0], [20, 20], [0, 20]]\nstiffness = 2000\n\
                 [[contacts]]\npoint = [4, 0]\n[[contacts]]\npoint = [17, 0]\n\
                 [[contacts]]\npoint = [0, 12]\n";
    let lift = "[[load_cases]]\nname = \"lift\"\nforce = [0, 2]\npoint = [10, 20]\n";
    folder.write("grasp.toml", format!("{three}{lift}"));
    let ran = folder.run("analyze grasp.toml --format json");
    assert_eq!(ran.code, Some(3), "the fingers do not hold the part");
    let needed = &ran.json()["needed_preloads"];
    let reason = "contact 0 loses force under load case 0 (lift), and no preloads that balance \
                  press it: no force closure";
    assert_eq!(needed["least"]["reason"], reason);
    let text = folder.run("analyze grasp.toml").out;
    assert_says(&text, &[&format!("no preloads do: {reason}\n")]);
    // A weight between two contacts needs just these preloads.
    let weight = "[[loads]]\npoint = [10.5, 10]\nforce = [0, -6]\n";
    let pressed = three.replace("[4, 0]", "[4, 0]\npreload = 3");
    let pressed = pressed.replace("[17, 0]", "[17, 0]\npreload = 3");
    let sides = "[0, 12]\npreload = 2\n[[contacts]]\npoint = [20, 12]\npreload = 2";
    let pressed = pressed.replace("[0, 12]", sides);
    for (force, enough) in [("2", true), ("9", false)] {
        let lift = lift.replace("[0, 2]", &format!("[0, {force}]"));
        folder.write("grasp.toml", format!("{pressed}{weight}{lift}"));
        let report = folder.json("analyze grasp.toml --order first");
        let needed = &report["needed_preloads"];
        assert_eq!(needed["least"].get("preloads").is_some(), enough);
        assert_eq!(report["load_cases"][0]["verdict"]["valid"], enough);
        assert_says(&needed["scaled"]["reason"].to_string(), &["the loads need these preloads"]);
        if !enough {
            let reason = needed["least"]["reason"].to_string();
            assert_says(&reason, &["contact 0 loses force", "balance the loads press it so much"]);
        }
    }
}

/// A contact that just stays on has no force left, and not the rounding of none.
#[test]
fn a_force_that_is_rounding_beside_the_total_is_zero() {
    let parts = concat!(env!("CARGO_MANIFEST_DIR"), "/../../parts");
    let folder = Folder::new("needed-zero");
    let text = folder.run(&format!("analyze {parts}/cube-grasp.toml")).out;
    let table = text.split("whatever load case acts\n").nth(1).unwrap();
    let table = table.split("\nunder load:").next().unwrap();
    let head = table.lines().next().unwrap();
    let mut columns: Vec<&str> = head.split("  ").filter(|name| !name.is_empty()).collect();
    columns.sort_unstable();
    assert!(columns.windows(2).all(|pair| pair[0] != pair[1]), "{head}");
    let cells = || table.lines().skip(1).flat_map(str::split_whitespace);
    assert!(cells().any(|cell| cell == "0") && cells().all(|cell| !cell.contains('e')), "{table}");
}
