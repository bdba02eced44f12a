//! Preloads that balance the rest: what each contact carries, and where balance does not say.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use crate::run::{Folder, Ran, assert_says};

/// A square of side 20 on two pins below and one at its left, with these preloads; `rest` follows.
fn on_three_pins(name: &str, preloads: [&str; 3], rest: &str) -> Ran {
    let folder = Folder::new(&format!("balanced-{name}"));
    let points = ["[4, 0]", "[16, 0]", "[0, 5]"];
    let contacts = points
        .iter()
        .zip(preloads)
        .map(|(point, preload)| format!("[[contacts]]\npoint = {point}\npreload = {preload}\n"));
    let outline = "[[0, 0], [20, 0], [20, 20], [0, 20]]";
    let file = crate::run::part(outline, "2000") + &contacts.collect::<String>() + rest;
    folder.write("grasp.toml", file);
    folder.run("analyze grasp.toml --format json")
}

const BALANCED: &str = "\"balanced\"";
const WEIGHT: &str = "[[loads]]\npoint = [7, 10]\nforce = [0, -12]\n";

#[test]
fn pins_carry_what_presses_on_them() {
    // The weight is a quarter of the way from pin 0 to pin 1. A clamp at the right, 3 above the
    // stop, presses with 8: pin 2 takes it, and its couple of 24 loads pin 0 by 24 / 12 = 2.
    let clamp = "[[contacts]]\npoint = [20, 8]\npreload = 8\n";
    let held = on_three_pins("carry", [BALANCED; 3], &format!("{clamp}{WEIGHT}"));
    assert_eq!((held.code, held.err.as_str()), (Some(0), ""));
    let report = held.json();
    assert_eq!(report["equilibrium"]["holds"], true);
    let preloads = report["contacts"].as_array().unwrap().iter().map(|c| c["preload"].as_f64());
    for (found, expected) in preloads.zip([11.0, 1.0, 8.0, 8.0]) {
        // A few dozen products, each rounded.
        assert!((found.unwrap() - expected).abs() < 1e-13 * 20.0, "{found:?}, not {expected}");
    }
}

/// A contact that carries nothing is one without preload.
#[test]
fn a_pin_that_nothing_presses_on_carries_nothing() {
    let held = on_three_pins("idle", [BALANCED; 3], WEIGHT);
    assert_eq!(held.json()["contacts"][2]["preload"], 0.0);
}

#[test]
fn pins_that_would_have_to_pull_are_named() {
    let push = "[[loads]]\npoint = [20, 9]\nforce = [5, -1]\n";
    let pulled = on_three_pins("pull", [BALANCED; 3], push);
    assert_eq!(pulled.code, Some(1));
    // Pin 2 takes the push; about pin 1, at x = 16, pin 0 takes -(4 + 5 (9 - 5)) / 12.
    assert_says(
        &pulled.err,
        &[
            "grasp.toml:6:11: contacts[0].preload",
            "contact 0 pulls with 2 F and contact 2 pulls with 5 F, but fingers push",
        ],
    );
}

#[test]
fn preloads_that_balance_does_not_decide_are_refused() {
    let fourth = format!("[[contacts]]\npoint = [20, 8]\npreload = \"balanced\"\n{WEIGHT}");
    let many = on_three_pins("many", [BALANCED; 3], &fourth);
    assert_eq!(many.code, Some(1));
    assert_says(
        &many.err,
        &["4 preloads are `balanced`", "3 independent lines", "give 1 of them as numbers"],
    );
    let sliding = on_three_pins("slide", [BALANCED, BALANCED, "1"], WEIGHT);
    assert_eq!(sliding.code, Some(1));
    assert_says(&sliding.err, &["no forces of these contacts balance the rest", "slides or turns"]);
}

#[test]
fn a_word_that_is_not_balanced_is_refused() {
    let wrong = on_three_pins("word", ["\"most\"", "0", "0"], WEIGHT);
    assert_says(&wrong.err, &["found text `most`, expected a finite number, or "]);
    let infinite = on_three_pins("infinite", ["inf", "0", "0"], WEIGHT);
    assert_says(&infinite.err, &["found inf, expected a finite number, or "]);
}

/// `optimize` shares the preload itself.
#[test]
fn optimize_takes_no_balanced_preloads() {
    let folder = Folder::new("balanced-optimize");
    let cube = "[part.spatial]\nvertices = [[0,0,0],[9,0,0],[9,9,0],[0,9,0],[0,0,9],[9,0,9],\
                [9,9,9],[0,9,9]]\nfaces = [[0,3,2,1],[4,5,6,7],[0,1,5,4],[2,3,7,6],[0,4,7,3],\
                [1,2,6,5]]\nstiffness = 1\n";
    folder.write("cube.toml", cube);
    folder.write("pins.toml", "[[contacts]]\npoint = [4, 4, 0]\npreload = \"balanced\"\n");
    let ran = folder.run("optimize cube.toml --fix pins.toml --fingers 6");
    assert_eq!(ran.code, Some(1));
    assert_says(&ran.err, &["pins.toml:3:11", "found `balanced`, expected a number"]);
}
