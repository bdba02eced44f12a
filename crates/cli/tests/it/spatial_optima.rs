//! The best placements on solids: beside locators, on faces and among candidates.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use clench_testkit::cases::{Value, list, number, numbers};
use clench_testkit::{assert_all_close, assert_close};

use crate::run::{Folder, assert_says};

/// A report is written with all digits: what is computed twice differs by the order of sums.
const ROUNDING: f64 = 1e-9;

/// The locators of a cube of side 2: three below, two in front, one on the left.
pub(crate) const LOCATORS: [[f64; 3]; 6] = [
    [0.5, 0.5, 0.0],
    [1.5, 0.5, 0.0],
    [1.0, 1.5, 0.0],
    [0.5, 0.0, 1.0],
    [1.5, 0.0, 1.0],
    [0.0, 1.0, 1.0],
];

/// Two places for clamps on each of the opposite faces.
pub(crate) const PLACES: [[f64; 3]; 6] = [
    [1.0, 0.9, 2.0],
    [1.2, 1.4, 2.0],
    [0.8, 2.0, 0.7],
    [1.1, 2.0, 1.6],
    [2.0, 0.6, 1.0],
    [2.0, 1.3, 1.2],
];

/// A cube with its corner at the origin.
pub(crate) fn cube(side: f64) -> String {
    let corner = |i: usize| [i & 1, i >> 1 & 1, i >> 2].map(|bit| side * bit as f64);
    let vertices: Vec<[f64; 3]> = (0..8).map(corner).collect();
    let faces = "[[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], \
                 [1, 3, 7, 5]]";
    format!("[part.spatial]\nvertices = {vertices:?}\nfaces = {faces}\nstiffness = 3\n")
}

/// A file with contacts at these points, each with the fields of `more`.
pub(crate) fn contacts(points: &[[f64; 3]], more: &str) -> String {
    let contact = |point: &[f64; 3]| format!("[[contacts]]\npoint = {point:?}\n{more}\n");
    points.iter().map(contact).collect()
}

/// A cube of side 2 with its locators and places for clamps.
pub(crate) fn located(name: &str) -> Folder {
    let folder = Folder::new(&format!("spatial-{name}"));
    folder.write("cube.toml", cube(2.0));
    folder.write("fix.toml", contacts(&LOCATORS, ""));
    folder.write("places.toml", contacts(&PLACES, ""));
    folder
}

const ON_FACES: &str = "optimize cube.toml --fix fix.toml --fingers 3 --nodes 100";
const CHOSEN: &str = "optimize cube.toml --fix fix.toml --candidates places.toml --fingers 3";

/// Asserts that `analyze` says the same of the report.
fn assert_analyzed_alike(folder: &Folder, report: &Value) -> Value {
    folder.write("report.json", report.to_string());
    let analysis = folder.json("analyze report.json");
    for key in ["quality", "quality_rotational", "worst_point_stiffness", "sigma_min", "mu_eq"] {
        let expected = number(&report[key]);
        assert_close(number(&analysis[key]), expected, ROUNDING, expected, key);
    }
    for key in ["center", "worst_point"] {
        let [found, expected] = [&analysis[key], &report[key]].map(numbers);
        assert_all_close(&found, &expected, ROUNDING, key);
    }
    assert_eq!(analysis["true_center_exists"], report["true_center_exists"]);
    analysis
}

#[test]
fn a_report_on_a_solid_is_read_by_analyze() {
    let folder = located("round-trip");
    let report = folder.json(ON_FACES);
    assert_eq!(folder.json(ON_FACES), report);
    assert_eq!((&report["dimension"], &report["fingers"]), (&3.into(), &3.into()));
    let (flatness, gap) = (number(&report["flatness"]), number(&report["effort"]["gap"]));
    assert_eq!((flatness.to_bits(), gap.to_bits()), (0.0_f64.to_bits(), 0.05_f64.to_bits()));
    // With --nodes there is no time unless it is asked for.
    assert_eq!(report["effort"]["time"], Value::Null);
    let found = list(&report["contacts"]);
    assert_eq!(found.len(), 9);
    for (i, contact) in found.iter().enumerate() {
        assert_eq!(contact.get("fixed").is_some(), i < 6, "{contact}");
        assert_eq!(contact["law"]["stiffness"], 3.0);
        if let Some(locator) = LOCATORS.get(i) {
            assert_all_close(&numbers(&contact["point"]), locator, 0.0, "locator");
        }
    }
    let faces: Vec<f64> = found.iter().map(|contact| number(&contact["face"])).collect();
    assert_eq!(faces[..6], [0.0, 0.0, 0.0, 2.0, 2.0, 4.0]);
    let shares: f64 = found.iter().map(|contact| number(&contact["share"])).sum();
    assert_close(shares, 1.0, ROUNDING, 1.0, "shares");
    assert_eq!(report["objective"], "worst_point");
    let certificate = &report["certificate"];
    let best = number(&report["worst_point_stiffness"]);
    let bound = number(&certificate["upper_bound"]);
    assert!(bound >= best, "{bound} below {best}");
    assert_close(number(&certificate["gap"]), bound / best - 1.0, ROUNDING, 1.0, "gap");
    let analysis = assert_analyzed_alike(&folder, &report);
    assert_eq!(analysis["force_closure"], true);
}

#[test]
fn a_preload_is_shared_by_all_contacts() {
    let folder = located("preload");
    let question = format!("{CHOSEN} --preload 0.1 --finger-radius 0.25");
    let report = folder.json(&question);
    let found = list(&report["contacts"]);
    let total: f64 = found.iter().map(|contact| number(&contact["preload"])).sum();
    assert_close(total, 0.1, ROUNDING, 1.0, "preload");
    let radii: Vec<f64> = found.iter().map(|c| number(&c["finger"]["radius"])).collect();
    assert_eq!(radii, [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.25, 0.25, 0.25]);
    folder.write("report.json", report.to_string());
    let analysis = folder.json("analyze report.json");
    let second = number(&report["quality_second_order"]);
    assert_eq!(analysis["order"], "second");
    assert_close(number(&analysis["quality"]), second, ROUNDING, second, "second order");
    let text = folder.run(&question).out;
    assert_says(&text, &["preload [F]", "total preload 0.1 F", "second order"]);
}

/// All choices of three of six, each analyzed by itself.
#[test]
fn the_best_choice_is_that_of_all_choices() {
    let folder = located("brute-force");
    let report = folder.json(&format!("{CHOSEN} --gap 0 --objective quality"));
    assert_eq!(report["certificate"]["proved"], true);
    assert_eq!(report["combinations"]["total"], 20);
    let part = cube(2.0);
    let mut best: Option<(f64, [usize; 3])> = None;
    for [i, j, k] in (0..216).map(|code| [code / 36, code / 6 % 6, code % 6]) {
        if i >= j || j >= k {
            continue;
        }
        let clamps = [i, j, k].map(|place| PLACES[place]);
        let all = format!("{part}{}{}", contacts(&LOCATORS, ""), contacts(&clamps, ""));
        folder.write("grasp.toml", all);
        let ran = folder.run("analyze grasp.toml --format json");
        if ran.code == Some(0) && best.is_none_or(|(q, _)| number(&ran.json()["quality"]) > q) {
            best = Some((number(&ran.json()["quality"]), [i, j, k]));
        }
    }
    let (quality, chosen) = best.unwrap();
    assert_close(number(&report["quality"]), quality, ROUNDING, quality, "the best of all");
    let placed = &list(&report["contacts"])[6..];
    let found: Vec<f64> = placed.iter().map(|contact| number(&contact["candidate"])).collect();
    assert_eq!(found, chosen.map(|place| place as f64));
    assert!(placed.iter().all(|contact| contact.get("face").is_none()));
    assert_analyzed_alike(&folder, &report);
}

#[test]
fn every_objective_is_that_of_the_report() {
    let folder = located("objectives");
    for (objective, key, symbol) in [
        ("quality", "quality", "Q"),
        ("rotation", "quality_rotational", "Q_V"),
        ("worst-point", "worst_point_stiffness", "Q_pt"),
    ] {
        let question = format!("{CHOSEN} --gap 0 --objective {objective}");
        let report = folder.json(&question);
        assert_eq!(report["objective"], objective.replace('-', "_"));
        let (found, bound) = (&report[key], &report["certificate"]["upper_bound"]);
        let best = number(found);
        assert_close(number(bound), best, ROUNDING, best, symbol);
        let text = folder.run(&question).out;
        assert_says(&text, &["proved    no placement of three fingers on these candidates"]);
        assert_eq!(text.contains(&format!("maximized {symbol} = ")), objective != "quality");
    }
    let question = format!("{CHOSEN} --objective rotation --least-translation");
    let report = folder.json(&format!("{question} 5"));
    assert!(number(&report["sigma_min"]) >= 5.0);
    let ran = folder.run(&format!("{question} 100"));
    assert_eq!(ran.code, Some(3), "{}", ran.err);
}

#[test]
fn a_given_law_counts_by_its_slope_at_the_preload() {
    let folder = located("laws");
    // f = 4 d^2 has the slope 2 sqrt(4 f): 3 at 9/16.
    let law = "law = { kind = \"power\", coefficient = 4, exponent = 2 }";
    let expected = folder.json(CHOSEN);
    folder.write("fix.toml", contacts(&LOCATORS, &format!("{law}\npreload = 0.5625")));
    let report = folder.json(CHOSEN);
    for key in ["quality", "quality_rotational", "worst_point_stiffness"] {
        let value = number(&expected[key]);
        assert_close(number(&report[key]), value, ROUNDING, value, key);
    }
    assert_eq!(report["contacts"][0]["law"]["kind"], "linear");
    assert_analyzed_alike(&folder, &report);
    // Candidates may all have laws: the part needs no stiffness then.
    let linear = "law = { kind = \"linear\", stiffness = 3 }";
    folder.write("cube.toml", cube(2.0).replace("stiffness = 3\n", ""));
    folder.write("places.toml", contacts(&PLACES, linear));
    let report = folder.json(CHOSEN);
    assert_close(number(&report["quality"]), number(&expected["quality"]), ROUNDING, 1.0, "laws");
}

#[test]
fn a_report_may_be_what_is_given() {
    let folder = located("chain");
    let report = folder.json(CHOSEN);
    folder.write("report.json", report.to_string());
    let question = "optimize cube.toml --fix report.json --candidates places.toml --fingers 1";
    let more = folder.json(question);
    assert_eq!(list(&more["contacts"]).len(), 10);
    assert!(number(&more["sigma_min"]) >= number(&report["sigma_min"]) * (1.0 - ROUNDING));
    assert_says(&folder.run(question).out, &["one beside 9 fixed contacts, frictionless"]);
}

#[test]
fn twins_are_contacts_too() {
    let folder = located("twins");
    folder.write("fix.toml", contacts(&[LOCATORS, LOCATORS].concat(), ""));
    folder.write("places.toml", contacts(&[PLACES, PLACES].concat(), ""));
    let report = folder.json(CHOSEN);
    assert_eq!(list(&report["contacts"]).len(), 15);
    assert_analyzed_alike(&folder, &report);
}

/// Force per deflection does not depend on how large a part is.
#[test]
fn sizes_from_tiny_to_huge_have_the_same_answer() {
    let expected = located("size").json(CHOSEN);
    for (name, size) in [("tiny", 1e-9), ("huge", 1e9)] {
        let folder = located(name);
        let scaled = |points: &[[f64; 3]]| {
            let points: Vec<_> = points.iter().map(|point| point.map(|x| x * size)).collect();
            contacts(&points, "")
        };
        folder.write("cube.toml", cube(2.0 * size));
        folder.write("fix.toml", scaled(&LOCATORS)).write("places.toml", scaled(&PLACES));
        let report = folder.json(CHOSEN);
        for key in ["quality", "quality_rotational", "worst_point_stiffness"] {
            let value = number(&expected[key]);
            assert_close(number(&report[key]), value, ROUNDING, value, name);
        }
        folder.json(ON_FACES);
    }
}

#[test]
fn many_candidates_are_read_at_once() {
    let folder = located("many");
    let place = |i: usize| {
        let [u, v] = [i % 100, i / 100].map(|step| 0.01 + 0.0198 * step as f64);
        [[u, v, 2.0], [u, 2.0, v], [2.0, u, v]][i % 3]
    };
    folder.write("places.toml", contacts(&(0..10_000).map(place).collect::<Vec<_>>(), ""));
    let ran = folder.run(&format!("{CHOSEN} --nodes 1"));
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert_says(&ran.out, &["8 vertices, 6 faces, 10000 candidates", "stopped   after 1 node"]);
}

#[test]
fn the_text_of_a_solid_says_what_is_fixed() {
    let folder = located("text");
    let text =
        folder.run(&format!("{ON_FACES} --top 2 --least-share 0.02").replace("3 -", "4 -")).out;
    for piece in [
        "part      cube.toml, 8 vertices, 6 faces in 6 planes\n",
        "flatness  0 L, how far off a plane its vertices may be\n",
        "fingers   four beside 6 fixed contacts, frictionless, pointed; no preload given\n",
        "asked for 0.02 or more of the preload each; at most 3 on one plane\n",
        "bound     no placement of four fingers on this solid has Q_pt above ",
        " combinations of planes; ",
        "finger  is      on      point [L]",
        "5       fixed   face 4  (0, 1, 1)",
        "\n6       placed  face ",
        "least mu_eq of all rotations that need no force\n",
        "\nplace  Q_pt [F/L]",
    ] {
        assert!(text.contains(piece), "`{piece}` is missing in: {text}");
    }
    assert!(text.lines().all(|line| line.chars().count() <= 120), "{text}");
}
