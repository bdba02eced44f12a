//! How far a search goes: gaps, budgets and Ctrl-C, and the bounds that hold however it ends.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use clench_testkit::assert_close;
use clench_testkit::cases::{Value, list, number};

use crate::run::{Folder, Ran, assert_says, part};

/// A few roundings: the certificate is made of the report's own numbers.
const ROUNDING: f64 = 1e-14;

const OVAL: [f64; 2] = [12.0, 11.0];

/// A part with corners on an ellipse: the rounder it is, the longer the search.
fn round_part(corners: usize, [a, b]: [f64; 2]) -> String {
    let corner = |i: usize| {
        let angle = std::f64::consts::TAU * i as f64 / corners as f64;
        [a * angle.cos(), b * angle.sin()]
    };
    let outline: Vec<[f64; 2]> = (0..corners).map(corner).collect();
    part(&format!("{outline:?}"), "1")
}

fn round(name: &str, corners: usize, semi_axes: [f64; 2]) -> Folder {
    let folder = Folder::new(&format!("searches-{name}"));
    folder.write("part.toml", round_part(corners, semi_axes));
    folder
}

/// The best, the bound and the gap of a report, which have to agree.
fn certificate(report: &Value, proved: bool, ended: &str) -> (f64, f64) {
    let certificate = &report["certificate"];
    let found = (&certificate["proved"], &certificate["ended"]);
    assert_eq!(found, (&proved.into(), &ended.into()), "{certificate}");
    let (quality, bound) = (number(&report["quality"]), number(&certificate["upper_bound"]));
    assert!(bound >= quality, "{quality} above its bound {bound}");
    assert_close(number(&certificate["gap"]), bound / quality - 1.0, ROUNDING, 1.0, "gap");
    (quality, bound)
}

#[test]
fn a_search_that_is_stopped_has_a_bound_that_holds() {
    let folder = round("stopped", 25, OVAL);
    let full = folder.json("optimize part.toml --fingers 4");
    let (best, least_bound) = certificate(&full, true, "proved");
    assert_close(best, least_bound, ROUNDING, best, "a proof leaves no gap");
    let total = &full["combinations"]["total"];
    // Four of 25 edges, repetition allowed: 28 over 4.
    assert_eq!(total, &Value::from(20_475));
    for nodes in [1, 100] {
        let question = format!("optimize part.toml --fingers 4 --nodes {nodes}");
        let stopped = folder.json(&question);
        let (quality, bound) = certificate(&stopped, false, "nodes");
        assert!(quality <= best * (1.0 + ROUNDING), "{quality} above the best, {best}");
        assert!(bound >= best * (1.0 - ROUNDING), "{bound} below the best, {best}");
        assert!(number(&stopped["combinations"]["nodes"]) < number(&full["combinations"]["nodes"]));
        assert_eq!(&stopped["combinations"]["total"], total);
        assert_eq!(folder.json(&question), stopped);
    }
    let ran = folder.run("optimize part.toml --fingers 4 --nodes 1 --top 2");
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert_says(
        &ran.out,
        &[
            "stopped   after 1 node, the limit: no placement of four fingers on this outline ",
            " has Q above ",
            " F/L, a gap of ",
            "search    20475 combinations of edges; 1 set of them bounded",
            "stopped: other combinations may have better placements than these",
        ],
    );
    assert!(!ran.out.contains("proved"), "{}", ran.out);
}

#[test]
fn a_gap_is_what_others_may_be_better_by() {
    let folder = round("gap", 25, [12.0, 8.0]);
    let (best, _) = certificate(&folder.json("optimize part.toml --fingers 4"), true, "proved");
    let question = "optimize part.toml --fingers 4 --gap 0.2";
    let report = folder.json(question);
    let (quality, bound) = certificate(&report, false, "gap");
    assert!(bound <= 1.2 * quality * (1.0 + ROUNDING), "{bound} beside {quality}");
    assert!(bound >= best * (1.0 - ROUNDING) && quality <= best * (1.0 + ROUNDING));
    let text = folder.run(&format!("{question} --top 2")).out;
    assert_says(
        &text,
        &["bounded   no placement of four", "; 0.2 was allowed\n", "are within the gap\n"],
    );
    // What only closes in on a placement has a gap unless told otherwise.
    for (fingers, gap) in [("3 --preload 1", 0.0), ("4", 0.0), ("5 --nodes 1", 1e-4)] {
        let report = folder.json(&format!("optimize part.toml --fingers {fingers}"));
        assert_eq!(number(&report["effort"]["gap"]).to_bits(), f64::to_bits(gap), "{fingers}");
    }
    let worst = "optimize part.toml --fingers 4 --objective worst-point --nodes 1";
    assert_eq!(folder.json(worst)["effort"]["gap"], 1e-4);
}

#[test]
fn a_time_ends_a_search_that_takes_longer() {
    let folder = round("time", 500, [10.0, 10.0]);
    let question = "optimize part.toml --fingers 4 --gap 0 --time 0.25";
    certificate(&folder.json(question), false, "time");
    let text = folder.run(question).out;
    assert_says(&text, &["stopped   after 0.25 s, the limit: no placement of four fingers"]);
}

#[test]
fn a_search_without_a_placement_so_far_has_no_answer() {
    let folder = Folder::new("searches-nothing");
    folder.write("part.toml", part(crate::run::QUADRILATERAL, "1"));
    let question = "optimize part.toml --fingers 4 --objective rotation --least-translation 1.68 \
                    --least-share 0.22 --nodes 1";
    let ran = folder.run(question);
    assert_eq!((ran.code, ran.out.as_str()), (Some(3), ""));
    let reason = "the search for 4 fingers was stopped before it found a placement";
    assert_says(&ran.err, &["clench: no answer: ", reason, "none is better than 3.7"]);
    assert!(ran.err.ends_with(" F/L\n"), "{}", ran.err);
    let ran = folder.run(&format!("{question} --format json"));
    assert_eq!(ran.code, Some(3));
    let report = ran.json();
    assert_says(&report["reason"].to_string(), &[reason]);
    assert_eq!((&report["quality"], &report["effort"]["nodes"]), (&Value::Null, &1.into()));
}

#[test]
fn every_combination_that_is_asked_for_is_listed() {
    let folder = round("top", 12, OVAL);
    let report = folder.json("optimize part.toml --fingers 4 --top 7");
    certificate(&report, true, "proved");
    let top: Vec<f64> = list(&report["top"]).iter().map(|p| number(&p["quality"])).collect();
    assert_eq!(top.len(), 7);
    let text = folder.run("optimize part.toml --fingers 4 --top 7").out;
    assert_says(&text, &["proved: on no other combination is a placement better than the last\n"]);
}

#[test]
fn options_that_do_not_go_together_are_wrong_usage() {
    let folder = round("usage", 12, OVAL);
    for (options, pieces) in [
        ("3 --preload 1 --objective rotation", ["--fingers 3", "--objective quality only"]),
        ("3 --preload 1 --objective worst-point", ["--fingers 3", "--objective quality only"]),
        ("3 --preload 1 --least-share 0.34", ["--least-share is 0.34", "less than 1/3"]),
        ("4 --least-share 0.25", ["--least-share is 0.25", "less than 1/4"]),
        ("4 --least-share -0.1", ["--least-share <P>", "expected 0 or more"]),
        ("4 --objective size", ["--objective", "quality, worst-point, rotation"]),
        ("4 --least-translation 1", ["--least-translation", "--objective rotation only"]),
        ("4 --objective worst-point --least-translation 1", ["--least-translation", "rotation"]),
        ("4 --objective rotation --least-translation -1", ["found -1", "expected 0 or more"]),
        ("4 --clearance inf", ["--clearance <C>", "expected a finite number"]),
        ("4 --margin -2", ["--margin <M>", "expected 0 or more"]),
        ("4 --gap -1e-3", ["--gap <G>", "expected 0 or more"]),
        ("4 --gap nan", ["--gap <G>", "expected a finite number"]),
        ("4 --time 0", ["--time <SECONDS>", "expected more than 0"]),
        ("4 --time 1e300", ["--time <SECONDS>", "expected fewer"]),
        ("4 --nodes 0", ["--nodes <N>", "expected 1 or more"]),
        ("4 --nodes 1.5", ["--nodes <N>", "expected 1 or more"]),
        ("4 --forbid -1", ["found `-1`", "EDGE:FROM-TO"]),
        ("4 --forbid 1:2", ["found `1:2`", "FROM below TO"]),
        ("4 --forbid 1:3-2", ["found `1:3-2`", "FROM below TO"]),
        // Only the file says how many edges there are, and how long they are.
        ("4 --forbid 12", ["--forbid 12: edge 12 does not exist", "0 to 11"]),
        ("4 --forbid 99:0-1", ["--forbid 99:0-1: edge 99 does not exist", "0 to 11"]),
        ("4 --finger-radius 1e308", ["--finger-radius: ", "the finger radius is 1"]),
    ] {
        let ran = folder.run(&format!("optimize part.toml --fingers {options}"));
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""), "{options}: {}", ran.err);
        assert_says(&ran.err, &pieces);
    }
}

/// Ctrl-C before the search began ends the program; after that, the search.
#[cfg(unix)]
#[test]
fn ctrl_c_ends_a_search_with_what_it_has() {
    use std::process::{Command, Stdio};
    use std::thread::sleep;
    use std::time::Duration;

    use crate::run::command;

    let folder = round("interrupted", 500, [10.0, 10.0]);
    // The time is for a search that Ctrl-C does not end.
    let question = "optimize part.toml --fingers 4 --gap 0 --format json --time 300";
    let interrupted = |after: Duration| {
        let mut child = command(question.split(' '));
        let child = child.current_dir(folder.path("")).stdout(Stdio::piped());
        let child = child.stderr(Stdio::piped()).spawn().unwrap();
        sleep(after);
        let kill = format!("kill -INT {}", child.id());
        assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
        Ran::new(&child.wait_with_output().unwrap())
    };
    let waits = [0.5, 2.0, 8.0, 30.0].map(Duration::from_secs_f64);
    let ran = waits.into_iter().map(interrupted).find(|ran| ran.code == Some(0)).unwrap();
    assert_eq!(ran.err, "");
    let report = ran.json();
    certificate(&report, false, "interrupted");
    assert_eq!(list(&report["contacts"]).len(), 4);
    folder.write("grasp.json", &ran.out);
    assert_eq!(folder.run("analyze grasp.json").code, Some(0));
}

/// Preloads far beyond the stiffness push the part away: that is said as a reader wants it.
#[test]
fn numbers_of_a_preload_that_is_too_large_are_rounded() {
    let folder = Folder::new("searches-preload");
    folder.write("part.toml", part(crate::run::QUADRILATERAL, "1"));
    let ran = folder.run("optimize part.toml --fingers 4 --preload 1000");
    let reason = ran.out.lines().find(|line| line.starts_with("second order")).unwrap_or_default();
    assert_says(
        reason,
        &["none", "the part turns away about (", ") L: the stiffness is -", " F L"],
    );
    assert!(reason.matches(", ").count() == 1, "two numbers in the plane: {reason}");
    let digits = |word: &str| word.chars().filter(char::is_ascii_digit).count();
    assert!(reason.split(' ').all(|word| digits(word) <= 8), "{reason}");
    let ran = folder.run("optimize part.toml --fingers 4 --preload 1e300");
    assert_eq!(ran.err.matches("choose units").count(), usize::from(ran.code == Some(1)));
    assert_eq!(ran.code, Some(1), "{}{}", ran.out, ran.err);
}
