//! What is asked of a placement: objectives, conditions, and where fingers may not touch.

use std::fs;

use clench_testkit::assert_close;
use clench_testkit::cases::{Value, list, number, numbers};

use crate::run::{Folder, QUADRILATERAL, assert_says, part};

/// The search and what is made of its placements round some hundred times.
const ROUNDING: f64 = 1e-12;

fn quadrilateral(name: &str) -> Folder {
    let folder = Folder::new(&format!("conditions-{name}"));
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    folder
}

/// The x of the fingers on edge 0 of the quadrilateral: how far along it they are.
fn on_edge_0(report: &Value) -> Vec<f64> {
    let contacts = list(&report["contacts"]).iter();
    let fingers = contacts.filter(|contact| contact["edge"] == 0);
    let mut places: Vec<f64> = fingers.map(|contact| numbers(&contact["point"])[0]).collect();
    places.sort_by(f64::total_cmp);
    places
}

#[test]
fn more_fingers_hold_better() {
    let folder = quadrilateral("count");
    let mut last = 0.0;
    for (count, word) in [(4, "four"), (5, "five"), (6, "six"), (7, "seven"), (8, "eight")] {
        let question = format!("optimize part.toml --fingers {count} --gap 0.05");
        let report = folder.json(&question);
        assert_eq!(list(&report["contacts"]).len(), count);
        let quality = number(&report["quality"]);
        assert!(quality > last, "{count}: {quality} after {last}");
        last = quality;
        let text = folder.run(&question).out;
        assert_says(&text, &[&format!("fingers   {word}, frictionless")]);
    }
}

#[test]
fn rotation_is_maximized_with_the_translation_that_is_asked_for() {
    let folder = Folder::new("conditions-rotation");
    let bracket = concat!(env!("CARGO_MANIFEST_DIR"), "/../../parts/bracket.toml");
    folder.write("part.toml", fs::read(bracket).unwrap_or_default());
    let question = "optimize part.toml --fingers 4 --objective rotation";
    let free = folder.json(question);
    assert_eq!((&free["objective"], &free["least_translation"]), (&"rotation".into(), &0.0.into()));
    let best = folder.json("optimize part.toml --fingers 4");
    assert!(number(&free["mu_eq"]) > number(&best["mu_eq"]));
    assert!(number(&free["sigma_min"]) < 6e4, "{}", free["sigma_min"]);
    let bound = number(&free["certificate"]["upper_bound"]);
    assert_close(bound, number(&free["mu_eq"]), ROUNDING, bound, "the bound is of mu_eq");

    let held = format!("{question} --least-translation 6e4");
    let report = folder.json(&held);
    assert!(number(&report["sigma_min"]) >= 6e4 && report["least_translation"] == 6e4);
    assert!(number(&report["mu_eq"]) < number(&free["mu_eq"]));
    let text = folder.run(&held).out;
    let value = " N/mm, the equivalent rotational stiffness\n";
    assert_says(&text, &["maximized mu_eq = ", value, "asked for sigma_min at least 60000 N/mm\n"]);
    assert!(!text.contains("ties"), "{text}");
    let top = folder.run(&format!("{question} --top 2")).out;
    assert_says(&top, &["place  mu_eq [N/mm]  Q [N/mm]  limited by"]);

    let ran = folder.run(&format!("{question} --least-translation 1e5"));
    assert_eq!((ran.code, ran.out.as_str()), (Some(3), ""));
    assert_says(&ran.err, &["no placement of 4", "fulfills the conditions"]);
}

#[test]
fn the_worst_point_is_maximized() {
    let folder = quadrilateral("worst-point");
    let question = "optimize part.toml --fingers 4 --objective worst-point --gap 1";
    let report = folder.json(question);
    assert_eq!(
        (&report["objective"], &report["limited_by"]),
        (&"worst_point".into(), &report["limited_by"])
    );
    let found = number(&report["worst_point_stiffness"]);
    // Of best quality is a placement with 0.889533.
    assert!(found > 0.89, "{found}");
    let certificate = &report["certificate"];
    let (bound, gap) = (number(&certificate["upper_bound"]), number(&certificate["gap"]));
    assert_close(gap, bound / found - 1.0, ROUNDING, 1.0, "the gap is of Q_pt");
    let text = folder.run(question).out;
    assert_says(&text, &["maximized Q_pt = 0.9", "the least force per deflection"]);
}

#[test]
fn fingers_keep_their_distance() {
    let folder = quadrilateral("distance");
    let question = "optimize part.toml --fingers 4";
    // The best two on edge 0 are at its ends; a distance that they have changes nothing.
    let free = folder.json(question);
    assert_eq!(on_edge_0(&free), [0.0, 13.0]);
    let near = folder.json(&format!("{question} --clearance 3"));
    assert_eq!((&near["contacts"], &near["clearance"]), (&free["contacts"], &3.0.into()));
    let far = folder.json(&format!("{question} --clearance 6.5"));
    assert!(number(&far["quality"]) < number(&free["quality"]));
    // Two discs are as far apart as their radii.
    let discs = folder.json(&format!("{question} --finger-radius 3.25"));
    assert!(number(&discs["quality"]) > 0.0);
    let text = folder.run(&format!("{question} --finger-radius 2 --clearance 0.5")).out;
    assert_says(&text, &["asked for 0.5 L or more between tips\n"]);
    let text = folder.run(&format!("{question} --finger-radius 2")).out;
    assert_says(&text, &["asked for tips that do not overlap\n"]);
}

#[test]
fn each_finger_has_its_share() {
    let folder = quadrilateral("share");
    for question in ["--fingers 4 --least-share 0.16", "--fingers 3 --preload 1 --least-share 0.27"]
    {
        let least: f64 =
            question.rsplit(' ').next().and_then(|word| word.parse().ok()).unwrap_or(0.0);
        let report = folder.json(&format!("optimize part.toml {question}"));
        let found = number(&report["preload_margin"]);
        assert!(found >= least - ROUNDING, "{question}: {found}");
        assert_eq!(number(&report["least_share"]).to_bits(), least.to_bits());
    }
    // Without, the least is 0.139.
    let ran = folder.run("optimize part.toml --fingers 4 --least-share 0.16");
    assert_says(&ran.out, &["asked for 0.16 or more of the preload each\n"]);
    let ran = folder.run("optimize part.toml --fingers 3 --preload 1 --least-share 0.28");
    assert_eq!((ran.code, ran.out.as_str()), (Some(3), ""));
    assert_says(&ran.err, &["no answer: no placement of 3 ", "fulfills the conditions"]);
}

#[test]
fn fingers_stay_away_from_corners_and_forbidden_stretches() {
    let folder = quadrilateral("margin");
    let question = "optimize part.toml --fingers 4";
    let margin = folder.json(&format!("{question} --margin 1.5"));
    assert_eq!(on_edge_0(&margin), [1.5, 11.5]);
    assert_eq!(margin["part"]["planar"]["margin"], 1.5);
    let stretch = folder.json(&format!("{question} --forbid 0:-1-2.5 --forbid 0:1.2e1-1e2"));
    assert_eq!(on_edge_0(&stretch), [2.5, 12.0]);
    let edge = folder.json(&format!("{question} --forbid 2"));
    assert!(list(&edge["contacts"]).iter().all(|contact| contact["edge"] != 2), "{edge:?}");
    let text = folder.run(&format!("{question} --margin 1 --forbid 2 --forbid 0:6-7")).out;
    assert_says(&text, &["asked for 1 L or more from each corner; none on 2, 0:6-7\n"]);
    assert_says(&text, &["combinations of stretches of edges, "]);

    // The file says the same as the command line.
    let planar = part(QUADRILATERAL, "1");
    let forbidden = "[{ edge = 0, from = -1, to = 2.5 }, { edge = 0, from = 12, to = 100 }]";
    folder.write("file.toml", format!("{planar}margin = 1\nforbidden = {forbidden}\n"));
    let both = folder.json("optimize file.toml --fingers 4 --margin 0.5");
    let told = format!("{question} --margin 1 --forbid 0:-1-2.5 --forbid 0:12-100");
    assert_eq!(folder.json(&told), both);
    folder.write("edge.toml", format!("{planar}forbidden = [2]\n"));
    assert_eq!(folder.json("optimize edge.toml --fingers 4"), edge);
    // What analyzes it asks where fingers are, not where they may be.
    let contact = "[[contacts]]\npoint = [1, 0]\nedge = 0\n";
    folder.write("grasp.toml", format!("{planar}margin = 3\nforbidden = [0]\n{contact}"));
    assert_eq!(folder.run("analyze grasp.toml").code, Some(3));
}

#[test]
fn the_picture_shows_where_no_finger_goes() {
    let folder = quadrilateral("picture");
    let shaded = |options: &str| {
        let ran = folder.run(&format!("optimize part.toml --fingers 4{options} --svg part.svg"));
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        let svg = fs::read_to_string(folder.path("part.svg")).unwrap_or_default();
        (svg.contains("shaded: no finger"), svg.matches("fill-opacity=\"0.11\"").count())
    };
    assert_eq!(shaded(""), (false, 0));
    // Two ends of four edges, with the stretch at an end of one of them.
    assert_eq!(shaded(" --margin 0.5 --forbid 2:0-1"), (true, 8));
    assert_eq!(shaded(" --forbid 0:5-6 --forbid 2"), (true, 2));
}

/// A report has the whole question: its part with the options that it names gives it again.
#[test]
fn a_report_repeats_the_question() {
    let folder = quadrilateral("round-trip");
    let options = "--objective rotation --least-translation 1.2 --clearance 1 \
                   --least-share 0.03 --gap 0.001 --nodes 100000 --time 3600 --top 2 --preload 0.1";
    let restricted = "--margin 0.25 --forbid 2 --forbid 1:3-4";
    let question = format!("--fingers 4 {options} --format json");
    let first = folder.run(&format!("optimize part.toml {restricted} {question}"));
    assert_eq!((first.code, first.err.as_str()), (Some(0), ""));
    let report = first.json();
    let effort = &report["effort"];
    assert_eq!((&effort["top"], &effort["gap"]), (&2.into(), &0.001.into()));
    assert_eq!((&effort["nodes"], &effort["time"]), (&100_000.into(), &3600.0.into()));
    assert_eq!((&report["clearance"], &report["least_share"]), (&1.0.into(), &0.03.into()));
    folder.write("report.json", &first.out);
    assert!(folder.run(&format!("optimize report.json {question}")).out == first.out);
    assert!(folder.run(&format!("optimize report.json {restricted} {question}")).out == first.out);
    let analyzed = folder.json("analyze report.json --order first");
    for name in ["quality", "sigma_min", "mu_eq", "worst_point_stiffness"] {
        let (a, b) = (number(&analyzed[name]), number(&report[name]));
        assert_close(a, b, ROUNDING, b, name);
    }
    let three = folder.json("optimize part.toml --fingers 3 --preload 1");
    assert_eq!(three["least_translation"], Value::Null);
    assert_eq!((&three["effort"]["gap"], &three["effort"]["time"]), (&0.0.into(), &Value::Null));
}

#[test]
fn restrictions_that_are_none_are_refused_with_their_place() {
    let folder = Folder::new("conditions-refused");
    let outline = part(QUADRILATERAL, "1");
    let ellipse = "[part.planar]\nellipse = [4, 2]\nstiffness = 1\n";
    let stretch = |fields: &str| format!("forbidden = [0, {{ {fields} }}]");
    for (part, fields, pieces) in [
        (
            &*outline,
            "margin = -1".to_owned(),
            ["part.planar.margin", "the margin is -1", "positive"],
        ),
        (&outline, "margin = nan".to_owned(), ["part.planar.margin", "NaN", "a finite number"]),
        (&outline, "forbidden = 3".to_owned(), ["part.planar.forbidden", "a number", "a list"]),
        (&outline, "forbidden = [0, 4]".to_owned(), ["forbidden[1]", "edge 4 ", "0 to 3"]),
        (&outline, "forbidden = [0.5]".to_owned(), ["forbidden[0]", "0.5", "whole number"]),
        (&outline, "forbidden = [\"a\"]".to_owned(), ["forbidden[0]", "`a`", "number of an edge"]),
        (&outline, "forbidden = [[0]]".to_owned(), ["forbidden[0]", "a list", "number of an edge"]),
        (&outline, stretch("edge = 9, from = 0, to = 1"), ["forbidden[1]", "edge 9 ", "0 to 3"]),
        (&outline, stretch("edge = 1, from = 2, to = 1"), ["forbidden[1]", "from 2 to 1", "end"]),
        (&outline, stretch("edge = 1, from = inf, to = 1"), ["forbidden[1].from", "inf", "finite"]),
        (&outline, stretch("edge = 1, from = 0"), ["forbidden[1]", "missing field `to`", "along"]),
        (&outline, stretch("edge = 1, at = 0"), ["forbidden[1].at", "unknown field", "`from`"]),
        (ellipse, "margin = 1".to_owned(), ["part.planar.margin", "`margin`", "an `outline`"]),
        (ellipse, "forbidden = [0]".to_owned(), ["part.planar.forbidden", "`forbidden`", ""]),
    ] {
        folder.write("part.toml", format!("{part}{fields}\n[[contacts]]\npoint = [4, 0]\n"));
        for command in ["optimize part.toml --fingers 4", "analyze part.toml"] {
            if part == ellipse && command.starts_with("optimize") {
                continue;
            }
            let ran = folder.run(command);
            assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{fields}: {}", ran.err);
            assert_says(&ran.err, &["part.toml:"]);
            assert_says(&ran.err, &pieces);
        }
    }
    folder.write("part.toml", format!("margin = 2\n{outline}"));
    let ran = folder.run("optimize part.toml --fingers 4");
    assert_says(&ran.err, &["unknown field `margin`", "put it under [part.planar]"]);
}

/// A grasp file is a part file too, but for its contacts and what acts on it.
#[test]
fn what_has_no_say_in_the_placement_is_named() {
    let folder = quadrilateral("left-aside");
    let contact = "[[contacts]]\npoint = [1, 0]\n[[loads]]\npoint = [1, 1]\nforce = [0, -1]\n";
    folder.write("grasp.toml", part(QUADRILATERAL, "1") + contact);
    let report = folder.json("optimize grasp.toml --fingers 4");
    let words = "`contacts`, `loads` of the file have no say in where fingers go";
    assert_says(&report["warnings"].to_string(), &[words]);
    let text = folder.run("optimize grasp.toml --fingers 4 --report page.html").out;
    assert!(text.contains(&format!("warning   {words}: `analyze` takes them\n")), "{text}");
    let page = fs::read_to_string(folder.path("page.html")).unwrap_or_default();
    assert_says(&page, &["have no say in where fingers go"]);
    // The contacts of a report are results.
    folder.write("report.json", report.to_string());
    assert!(folder.json("optimize report.json --fingers 4").get("warnings").is_none());
}
