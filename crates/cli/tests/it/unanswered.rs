//! Sound questions without an answer: exit code 3, with the reason.

use clench_testkit::cases::{Value, list, number, numbers};
use clench_testkit::{assert_all_close, assert_close};

use crate::run::{Folder, QUADRILATERAL, Ran, grasp, part};

const SQUARE: &str = "[[0, 0], [2, 0], [2, 2], [0, 2]]";

fn square(name: &str, contacts: &[&str]) -> (Folder, Ran) {
    let contacts = contacts.iter().map(|contact| format!("[[contacts]]\n{contact}\n"));
    let folder = Folder::new(name);
    folder.write("grasp.toml", part(SQUARE, "1") + &contacts.collect::<String>());
    let ran = folder.run("analyze grasp.toml --format json");
    (folder, ran)
}

fn assert_unanswered(ran: &Ran, pieces: &[&str]) -> Value {
    assert_eq!(ran.code, Some(3), "{}", ran.err);
    for piece in pieces {
        assert!(ran.err.contains(piece), "`{piece}` is missing in: {}", ran.err);
    }
    ran.json()
}

#[test]
fn three_frictionless_fingers_do_not_hold_a_rectangle() {
    let folder = Folder::new("rectangle");
    folder.write("part.toml", part("[[0, 0], [4, 0], [4, 3], [0, 3]]", "1"));
    let ran = folder.run("optimize part.toml --fingers 3 --preload 1 --svg part.svg");
    assert_eq!((ran.code, ran.out.as_str()), (Some(3), ""));
    assert!(ran.err.contains("no placement of 3 frictionless fingers"), "{}", ran.err);
    assert_eq!(folder.names(), ["part.toml"]);
    let report = folder.run("optimize part.toml --fingers 3 --preload 1 --format json").json();
    assert!(report["reason"].as_str().is_some_and(|reason| reason.contains("pushed away")));
    assert_eq!(report["quality"], Value::Null);
}

#[test]
fn two_opposite_fingers_leave_the_part_free_to_slide() {
    let (folder, ran) = square("opposite", &["point = [1, 0]", "point = [1, 2]"]);
    let report = assert_unanswered(&ran, &["not stable", "free to slide along (1, 0)"]);
    assert_eq!(report["quality"], Value::Null);
    assert_eq!(report["stability"], "marginal");
    assert_all_close(&numbers(&report["free_motion"]["direction"]), &[1.0, 0.0], 0.0, "free");
    // What exists is there.
    let expected = [0.0, 0.0, 0.0, 0.0, 2.0, 2.0, 0.0, 2.0, 2.0];
    assert_all_close(&numbers(&report["stiffness"]), &expected, 0.0, "stiffness");
    assert_eq!(report["equilibrium"]["holds"], true);
    let text = folder.run("analyze grasp.toml --svg grasp.svg");
    assert_eq!(text.code, Some(3));
    assert!(text.out.contains("no answer the grasp is not stable"), "{}", text.out);
    assert!(folder.path("grasp.svg").exists());
}

#[test]
fn a_preload_that_pushes_the_part_away_is_named() {
    let finger = |point: &str| format!("point = {point}\npreload = 0.01");
    let fingers = ["[1, 0]", "[2, 1]", "[1, 2]", "[0, 1]"].map(finger);
    let fingers: Vec<&str> = fingers.iter().map(String::as_str).collect();
    // Their lines of action meet in the middle: preload alone resists rotation.
    let (folder, ran) = square("concurrent", &fingers);
    assert_eq!((ran.code, ran.json()["stability"].as_str()), (Some(0), Some("second_order")));
    let first = folder.run("analyze grasp.toml --order first --format json");
    let reason =
        "to first order the part is free to turn about (1, 1) L; the preloads hold it to second";
    let report = assert_unanswered(&first, &[reason]);
    let motion = &report["free_motion"];
    assert_all_close(&numbers(&motion["axis_point"]), &[1.0, 1.0], 1e-15, "center");
    assert_eq!(
        (numbers(&motion["direction"]), &motion["pitch"]),
        (vec![0.0, 0.0, 1.0], &0.0.into())
    );
}

/// A grasp of an ellipse, each finger by its point, its curvature and its preload.
fn ellipse(name: &str, semi_axes: [f64; 2], fingers: &[([f64; 2], &str, f64)]) -> (Folder, Ran) {
    let contacts = fingers.iter().map(|(point, finger, preload)| {
        format!("[[contacts]]\npoint = {point:?}\nfinger = {{ {finger} }}\npreload = {preload}\n")
    });
    let part = format!("[part.planar]\nellipse = {semi_axes:?}\nstiffness = 100\n");
    let folder = Folder::new(name);
    folder.write("grasp.toml", part + &contacts.collect::<String>());
    let ran = folder.run("analyze grasp.toml --format json");
    (folder, ran)
}

/// All lines of action meet in the middle, whatever the preload: what is left of the rotational
/// stiffness, and of what it is compared to, is rounding.
#[test]
fn a_disc_is_free_to_turn_and_has_no_numbers() {
    let (x, y) = (10.0 * 0.75_f64.sqrt(), 5.0);
    let fingers = [[0.0, 10.0], [-x, -y], [x, -y]].map(|point| (point, "radius = 0", 1.0));
    let (folder, ran) = ellipse("disc", [10.0, 10.0], &fingers);
    for order in ["second", "first"] {
        let again = folder.run(&format!("analyze grasp.toml --order {order} --format json"));
        assert_eq!(again.err, ran.err);
        let report =
            assert_unanswered(&again, &["not stable: the part is free to turn about (0, 0)"]);
        assert_eq!((&report["order"], &report["stability"]), (&order.into(), &"marginal".into()));
        assert_eq!((&report["rotational"], &report["sigma_min"]), (&Value::Null, &Value::Null));
    }
}

/// Straight jaws push at the ends of the longer axis, and hold at those of the shorter one.
#[test]
fn a_part_that_is_pushed_away_turns_away_by_itself() {
    let jaws = |long: f64, short: f64| {
        let [a, b] = [[10.0, 0.0], [-10.0, 0.0]].map(|point| (point, "curvature = 0", long));
        let [c, d] = [[0.0, 5.0], [0.0, -5.0]].map(|point| (point, "curvature = 0", short));
        [a, b, c, d]
    };
    // 2 f (b^2 - a^2) / a each, so that twice as much at the longer axis balances.
    let (_, ran) = ellipse("jaws-hold", [10.0, 5.0], &jaws(1.0, 1.0));
    assert_eq!((ran.code, ran.json()["stability"].as_str()), (Some(0), Some("second_order")));
    let (folder, ran) = ellipse("jaws-push", [10.0, 5.0], &jaws(3.0, 1.0));
    let report = assert_unanswered(&ran, &["not stable: the part turns away about (0, 0) L"]);
    assert_eq!((&report["stability"], &report["rotational"]), (&"unstable".into(), &Value::Null));
    // Without the preload, nothing turns it.
    let ran = folder.run("analyze grasp.toml --order first");
    assert!(ran.err.contains("the part is free to turn about (0, 0) L"), "{}", ran.err);
}

/// A load high above the fingers that carry it.
#[test]
fn what_holds_to_first_order_may_be_pushed_away() {
    let folder = Folder::new("top-heavy");
    let contacts = [
        "point = [0.5, 0]\npreload = 10",
        "point = [1.5, 0]\npreload = 10",
        "point = [0, 1]",
        "point = [2, 1]",
    ];
    let contacts = contacts.map(|contact| format!("[[contacts]]\n{contact}\n")).concat();
    let load = |height: f64| format!("[[loads]]\npoint = [1, {height}]\nforce = [0, -20]\n");
    let part = part(SQUARE, "1000");
    // Two springs of 1000 at 0.5 resist a turn by 500, and the load adds 20 times its height.
    folder.write("grasp.toml", format!("{part}{contacts}{}", load(20.0)));
    assert_eq!(folder.json("analyze grasp.toml")["stability"], "first_order");
    folder.write("grasp.toml", format!("{part}{contacts}{}", load(30.0)));
    let held =
        "to first order the contacts hold the part, but the preloads and loads push it away: ";
    let ran = folder.run("analyze grasp.toml --format json");
    let report = assert_unanswered(&ran, &[held, "the part turns away about (1, "]);
    assert_eq!((&report["stability"], &report["quality"]), (&"unstable".into(), &Value::Null));
    let ran = folder.run("analyze grasp.toml --order first --format json");
    let report = assert_unanswered(&ran, &[held, "some motion releases energy"]);
    assert!(number(&report["quality"]) > 0.0);
}

#[test]
fn a_finger_that_would_have_to_pull_is_named() {
    // Of three normals that all point to the right or up and down, one has to pull.
    let contacts = ["point = [6.5, 0]", "point = [11, 4]", "point = [9.5, 7]"];
    let folder = Folder::new("pulling");
    folder.write("grasp.toml", grasp(&contacts));
    let ran = folder.run("analyze grasp.toml --format json");
    let report = assert_unanswered(&ran, &["no_answer"]);
    assert_eq!(report["force_closure"], false);

    let (_, ran) = square(
        "pulled-out",
        &["point = [0.5, 0]", "point = [1.5, 0]", "point = [0, 1]", "point = [1, 0]"],
    );
    let report = assert_unanswered(&ran, &["can only push"]);
    // The springs alone would hold the part, so its numbers are there.
    assert_eq!(report["stability"], "first_order");
    assert!(number(&report["quality"]) > 0.0);
}

#[test]
fn preloads_that_do_not_balance_are_reported() {
    let contacts = [
        "point = [0.5, 0]\npreload = 1",
        "point = [2, 1.5]",
        "point = [1.5, 2]",
        "point = [0, 0.5]",
    ];
    let (folder, ran) = square("unbalanced", &contacts);
    let report = ran.json();
    assert_eq!((ran.code, &report["equilibrium"]["holds"]), (Some(0), &Value::Bool(false)));
    assert_eq!(report["order"], "first");
    assert_all_close(&numbers(&report["equilibrium"]["residual_force"]), &[0.0, 1.0], 0.0, "f");
    assert_close(number(&report["equilibrium"]["residual_torque"]), 0.5, 0.0, 1.0, "tau");
    let text = folder.run("analyze grasp.toml --order second");
    assert!(text.out.contains("depend on the frame"), "{}", text.out);
    // So much force on one finger that the part would turn away, were it at rest.
    let jaws = [([10.0, 0.0], "curvature = 0", 3.0), ([0.0, 5.0], "curvature = 0", 0.0)];
    let (folder, _) = ellipse("unbalanced-jaws", [10.0, 5.0], &jaws);
    let ran = folder.run("analyze grasp.toml --order second --format json");
    let pieces =
        ["the preloads do not balance, and to second order", "the part turns away about ("];
    assert_unanswered(&ran, &pieces);
}

/// The grasp that the text of `optimize --fingers 3` shows, its preloads typed with `digits`.
fn typed(folder: &Folder, digits: usize) -> Ran {
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    let report = folder.json("optimize part.toml --fingers 3 --preload 0.8");
    let contacts = list(&report["contacts"]).iter().map(|contact| {
        let ([point, preload], edge) =
            (["point", "preload"].map(|name| contact[name].clone()), &contact["edge"]);
        let decimals = digits - 1;
        format!("point = {point}\nedge = {edge}\npreload = {:.decimals$e}", number(&preload))
    });
    let contacts: Vec<String> = contacts.collect();
    folder.write("typed.toml", grasp(&contacts.iter().map(String::as_str).collect::<Vec<_>>()));
    folder.run("analyze typed.toml")
}

#[test]
fn preloads_of_too_few_digits_are_named_as_the_reason() {
    let folder = Folder::new("few-digits");
    let ran = typed(&folder, 4);
    assert_eq!(ran.code, Some(3), "{}", ran.err);
    for piece in [
        "to first order the part is free to turn about (6.5, 1.75) L",
        "the preloads would hold it, but are out of balance by ",
        "at most 1.5e-8 is allowed",
        "--order second",
    ] {
        assert!(ran.err.contains(piece), "`{piece}` is missing in: {}", ran.err);
    }
    assert!(!ran.err.contains("not stable"), "{}", ran.err);
    assert!(ran.out.contains(" of the total preload\n"), "{}", ran.out);
    assert!(ran.out.contains(" of the total preload times the grasp's length\n"), "{}", ran.out);
    // Three lines of action through one point: no force answers a torque about it.
    assert!(ran.out.contains("but some load cannot be balanced by any forces"), "{}", ran.out);
    assert_eq!(folder.run("analyze typed.toml --order second").code, Some(0));
}

#[test]
fn the_digits_of_a_text_report_are_enough_to_balance() {
    let folder = Folder::new("nine-digits");
    let ran = typed(&folder, 9);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let text = folder.run("optimize part.toml --fingers 3 --preload 0.8").out;
    let report = folder.json("optimize part.toml --fingers 3 --preload 0.8");
    for contact in list(&report["contacts"]) {
        let preload = format!("{:.9}", number(&contact["preload"]));
        assert!(text.contains(preload.trim_end_matches('0')), "{preload}: {text}");
    }
}

/// The limit that the message names is the one that decides.
#[test]
fn a_residual_is_compared_to_the_limit_that_the_reason_names() {
    for (excess, holds) in [(1.4e-8, true), (1.6e-8, false)] {
        let contacts = [
            "point = [1, 0]\npreload = 1".to_owned(),
            format!("point = [1, 2]\npreload = {}", 1.0 + 2.0 * excess),
        ];
        let (folder, ran) = square("limit", &contacts.each_ref().map(String::as_str));
        let report = ran.json();
        let equilibrium = &report["equilibrium"];
        assert_eq!(equilibrium["holds"], holds, "{excess}");
        // Differences of numbers near 1, so to a rounding of those.
        let found = number(&equilibrium["relative_force"]);
        assert_close(found, excess / (1.0 + excess), f64::EPSILON, 1.0, "relative force");
        let text = folder.run("analyze grasp.toml").out;
        let share = "left: torque -3.2e-8 F L; about the contacts' centroid 0 of the total preload";
        assert_eq!(text.contains(share), !holds, "{text}");
    }
}

/// Springs hold the part, but fingers can only push: one that nothing opposes holds nothing.
#[test]
fn a_finger_that_nothing_presses_holds_nothing() {
    let sides = ["[0.6, 0]", "[1.4, 0]", "[0.6, 2]", "[1.4, 2]"];
    let pressed =
        sides.map(|point| format!("[[contacts]]\npoint = {point}\npreload = 1\n")).concat();
    let aside = "[[contacts]]\npoint = [0, 1]\n";
    let folder = Folder::new("slack");
    let part = part(SQUARE, "1");
    folder.write("grasp.toml", format!("{part}{pressed}{aside}"));
    let ran = folder.run("analyze grasp.toml --format json");
    let slides = "no preload can press contact 4 on the part";
    let report = assert_unanswered(&ran, &[slides, "the part is free to slide along (1, 0)"]);
    assert_eq!(report["stability"], "first_order");
    assert_eq!(report["free_motion"]["kind"], "translation");

    // One opposite catches it, and the preload balances without either.
    let opposite = "[[contacts]]\npoint = [2, 1]\n";
    folder.write("grasp.toml", format!("{part}{pressed}{aside}{opposite}"));
    assert_eq!(folder.run("analyze grasp.toml").code, Some(0));

    // A load presses what it presses, and nothing else.
    let standing = "[[contacts]]\npoint = [0.5, 0]\npreload = 0.5\n\
                    [[contacts]]\npoint = [1.5, 0]\npreload = 0.5\n";
    let weight = "[[loads]]\npoint = [1, 0.25]\nforce = [0, -1]\n";
    folder.write("grasp.toml", format!("{part}{standing}{aside}{weight}"));
    let ran = folder.run("analyze grasp.toml --format json");
    assert_unanswered(&ran, &["nothing presses contact 2 on the part", "slide along (1, 0)"]);
    folder.write("grasp.toml", format!("{part}{standing}{aside}{opposite}{weight}"));
    let ran = folder.run("analyze grasp.toml");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(ran.out.contains("only the loads keep the part on its fingers"), "{}", ran.out);

    // A load of nothing presses nothing.
    let nothing = "[[loads]]\npoint = [1, 1]\nforce = [0, 0]\n";
    let loose = ["[0.5, 0]", "[1.5, 0]", "[0, 1]"];
    let loose = loose.map(|point| format!("[[contacts]]\npoint = {point}\n")).concat();
    for loads in ["", nothing] {
        folder.write("grasp.toml", format!("{part}{loose}{loads}"));
        let ran = folder.run("analyze grasp.toml --format json");
        assert_unanswered(&ran, &["no preload of these contacts balances"]);
    }
}
