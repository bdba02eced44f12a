//! Robustness: what the contacts' tolerances do to the measures, against the command itself.

use clench_testkit::assert_close;
use clench_testkit::cases::{Value, list, number, numbers};

use crate::measures::symmetric_cube;
use crate::run::{Folder, assert_says};

const QUADRILATERAL: &str = "[part.planar]\noutline = [[0, 0], [13, 0], [9, 8], [2, 6]]\n\
                             stiffness = 1\n";

const MEASURES: [&str; 3] = ["quality", "quality_rotational", "worst_point_stiffness"];

/// Four fingers, those on the first edge at `x`, the first with a law of its own.
fn quadrilateral(x: [f64; 2], stiffness: f64) -> String {
    let [a, b] = x;
    format!(
        "{QUADRILATERAL}[[contacts]]\npoint = [{a}, 0]\n\
         law = {{ kind = \"linear\", stiffness = {stiffness} }}\n\
         [[contacts]]\npoint = [{b}, 0]\n[[contacts]]\npoint = [11, 4]\n\
         [[contacts]]\npoint = [1.175, 3.525]\n"
    )
}

fn report(name: &str, file: &str, arguments: &str) -> Value {
    let folder = Folder::new(&format!("robustness-{name}"));
    folder.write("grasp.toml", file);
    folder.json(&format!("analyze grasp.toml{arguments}"))
}

/// Central differences over 1e-4 of a part of size 10: off by 1e-8 times a third derivative of
/// size 1e-2 and by the rounding over the step, 1e-11.
#[test]
fn derivatives_are_those_of_the_reports_of_moved_contacts() {
    let found = report("derivatives", &quadrilateral([1.3, 11.7], 1.2), " --robustness");
    let h = 1e-4;
    let at = |name: &str, x: f64, k: f64| report(name, &quadrilateral([x, 11.7], k), "");
    let places = [at("right", 1.3 + h, 1.2), at("left", 1.3 - h, 1.2)];
    let laws = [at("stiff", 1.3, 1.2 * (1.0 + h)), at("soft", 1.3, 1.2 * (1.0 - h))];
    for measure in MEASURES {
        let derivatives = &found["robustness"][measure]["derivatives"][0];
        for (pair, [above, below]) in
            [(&derivatives["placement"][0], &places), (&derivatives["stiffness"], &laws)]
        {
            let [along, against] = [number(&pair[0]), number(&pair[1])];
            let difference = (number(&above[measure]) - number(&below[measure])) / (2.0 * h);
            assert_close(along, difference, 1e-8, 1.0, measure);
            assert_close(along, -against, 0.0, 1.0, measure);
            assert!(along.abs() > 1e-4);
        }
        assert_eq!(found["robustness"][measure]["smooth"], true);
        assert!(found["robustness"][measure].get("worst_case").is_none());
    }
    let contact = &found["robustness"]["contacts"][0];
    assert_eq!(numbers(&contact["directions"][0]), [1.0, 0.0]);
    assert!(contact.get("tolerance").is_none());
    assert!(report("without", &quadrilateral([1.3, 11.7], 1.2), "").get("robustness").is_none());
}

/// The worst corner is that of a file with the contacts there, and no corner next to it is worse;
/// the estimate is off by the squares.
#[test]
fn the_worst_case_is_the_report_of_its_contacts() {
    let tolerances = "contact_tolerances = { placement = 0.01, stiffness = 0.02 }\n";
    let file = quadrilateral([1.3, 11.7], 1.2)
        .replace("point = [11, 4]", "point = [11, 4]\ntolerance = { placement = 0 }");
    let found = report("worst", &format!("{tolerances}{file}"), "");
    let own = &found["robustness"]["contacts"][2]["tolerance"];
    assert_eq!((&own["placement"], &own["stiffness"]), (&0.0.into(), &0.02.into()));
    for measure in MEASURES {
        let worst = &found["robustness"][measure]["worst_case"];
        let contacts: Vec<(Vec<f64>, f64)> = list(&worst["contacts"])
            .iter()
            .map(|contact| (numbers(&contact["point"]), number(&contact["stiffness_factor"])))
            .collect();
        let anew = |contacts: &[(Vec<f64>, f64)]| {
            let own = [1.2, 1.0, 1.0, 1.0];
            let contact = |((point, factor), k): (&(Vec<f64>, f64), f64)| {
                let law = format!("law = {{ kind = \"linear\", stiffness = {} }}", factor * k);
                format!("[[contacts]]\npoint = {point:?}\n{law}\n")
            };
            let moved: String = contacts.iter().zip(own).map(contact).collect();
            let moved = report(&format!("anew-{measure}"), &format!("{QUADRILATERAL}{moved}"), "");
            number(&moved[measure])
        };
        let value = number(&worst["anew"]);
        assert_close(anew(&contacts), value, 1e-12, value, measure);
        let nominal = [[1.3, 0.0], [11.7, 0.0], [11.0, 4.0], [1.175, 3.525]];
        for (i, nominal) in nominal.into_iter().enumerate() {
            let mut one = contacts.clone();
            one[i].0 = (0..2).map(|x| 2.0 * nominal[x] - one[i].0[x]).collect();
            assert!(anew(&one) >= value, "{measure}: contact {i} on the other side");
            let mut one = contacts.clone();
            one[i].1 = 2.0 - one[i].1;
            assert!(anew(&one) > value, "{measure}: contact {i} with the other stiffness");
        }
        let linear = number(&worst["linear"]);
        // Tolerances of 2 % or less, whose squares count with factors of a few.
        assert_close(linear, value, 2e-3, value, measure);
        assert!(linear < 0.99 * number(&found[measure]), "{measure}");
        assert!(number(&found["robustness"][measure]["best_move"]["gain"]) > 0.0);
    }
}

/// On an ellipsoid normal and curvature change with the place, and all is looked at.
#[test]
fn spatial_grasps_have_two_directions_and_a_worst_case() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../parts/ellipsoid-grasp.toml");
    let file = std::fs::read_to_string(path).expect("an example");
    let file = file.replacen(
        "[part.spatial]",
        "[contact_tolerances]\nplacement = 1e-4\npreload = 1e-4\n[part.spatial]",
        1,
    );
    let found = report("ellipsoid", &file, " --order second");
    let robustness = &found["robustness"];
    for contact in list(&robustness["contacts"]) {
        assert_eq!(list(&contact["directions"]).len(), 2);
    }
    for measure in MEASURES {
        let measured = &robustness[measure];
        let Some(worst) = measured.get("worst_case") else { panic!("{measure}: {measured}") };
        let (value, linear) = (number(&found[measure]), number(&worst["linear"]));
        // What is lost is small, and known to its square.
        assert!(linear < value);
        let lost = value - linear;
        assert_close(number(&worst["anew"]), linear, 0.05, lost, measure);
    }
}

#[test]
fn the_text_has_a_row_for_each_change_and_the_worst_case() {
    let folder = Folder::new("robustness-text");
    let file = quadrilateral([1.3, 11.7], 1.2);
    folder.write("grasp.toml", format!("contact_tolerances = {{ placement = 0.1 }}\n{file}"));
    let ran = folder.run("analyze grasp.toml");
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert_says(
        &ran.out,
        &[
            "robustness: change of the measures per L",
            "along (1, 0)",
            "Q_pt gains most when contact",
            "worst, linear estimate [F/L]",
            "place 0.1 L, stiffness 0 %",
        ],
    );
    // A square held at its middle: a kink, and fingers that gain nothing.
    folder.write(
        "square.toml",
        "[part.planar]\noutline = [[0, 0], [20, 0], [20, 20], [0, 20]]\nstiffness = 2000\n\
         [[contacts]]\npoint = [7, 0]\n[[contacts]]\npoint = [20, 13]\n\
         [[contacts]]\npoint = [13, 20]\n[[contacts]]\npoint = [0, 7]\n",
    );
    let ran = folder.run("analyze square.toml --robustness");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert_says(&ran.out, &["two numbers: the change along and against"]);
}

#[test]
fn tolerances_that_are_none_are_refused() {
    let file = quadrilateral([1.3, 11.7], 1.2);
    let folder = Folder::new("robustness-refused");
    for (tolerances, pieces) in [
        ("{ placement = -1 }", ["contact_tolerances.placement", "is -1", "zero or positive"]),
        ("{ stiffness = 1 }", ["contact_tolerances.stiffness", "is 1", "it is relative"]),
        ("{ preload = -0.1 }", ["contact_tolerances.preload", "is -0.1", "from 0 up to"]),
        ("{ place = 1 }", ["contact_tolerances", "unknown field `place`", "`placement`"]),
        ("3", ["contact_tolerances", "found a number", "a table with `placement`"]),
    ] {
        folder.write("grasp.toml", format!("contact_tolerances = {tolerances}\n{file}"));
        let ran = folder.run("analyze grasp.toml");
        assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{tolerances}");
        assert_says(&ran.err, &pieces);
    }
    let own = file.replacen("point = [11, 4]", "point = [11, 4]\ntolerance = { preload = 2 }", 1);
    folder.write("grasp.toml", own);
    let ran = folder.run("analyze grasp.toml");
    assert_eq!(ran.code, Some(1));
    assert_says(&ran.err, &["contacts[2].tolerance.preload", "is 2"]);
}

/// A cube held alike from all sides: Q jumps, and says so, where the others have derivatives.
#[test]
fn a_measure_without_a_derivative_says_why() {
    let found = symmetric_cube(0.0);
    let folder = Folder::new("robustness-cube");
    folder.write("cube.toml", found);
    let report = folder.json("analyze cube.toml --robustness");
    let quality = &report["robustness"]["quality"];
    let missing = quality["missing"].as_str().expect("a reason");
    assert_says(missing, &["principal rotational stiffnesses are the same", "jumps"]);
    assert!(quality.get("derivatives").is_none());
    assert_eq!(report["robustness"]["worst_point_stiffness"]["smooth"], false);
    let ran = folder.run("analyze cube.toml --robustness");
    assert_says(&ran.out, &["Q: the quality has no derivative"]);
}

/// A linear estimate holds for small changes only.
#[test]
fn tolerances_too_large_for_the_linear_estimate_are_a_warning() {
    let file = quadrilateral([1.3, 11.7], 1.0);
    let said = |tolerances: &str| {
        let name = format!("large-{}", tolerances.len());
        let found = report(&name, &format!("contact_tolerances = {{ {tolerances} }}\n{file}"), "");
        let negative = MEASURES
            .map(|measure| number(&found["robustness"][measure]["worst_case"]["linear"]) <= 0.0);
        (found["warnings"].to_string(), negative.contains(&true))
    };
    let words = "tolerances of contacts are too large for the linear estimate: ";
    let (warnings, negative) = said("placement = 0.1");
    assert!(!negative && !warnings.contains(words), "{warnings}");
    let (warnings, negative) = said("placement = 6.4");
    assert!(negative, "{warnings}");
    assert_says(&warnings, &[&format!("{words}by it the worst of Q"), "is not positive"]);
    let (warnings, _) = said("placement = 1000");
    assert_says(&warnings, &[&format!("{words}a contact may be off by 1000 L, but the part's")]);
}
