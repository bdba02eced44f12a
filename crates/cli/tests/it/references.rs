//! Grasps of every kind against the reference cases, through the command.

use clench::screw::{Vector, planar, spatial};
use clench_testkit::assert_close;
use clench_testkit::cases::{Value, array, list, matching, number, numbers};
use serde_json::json;

use crate::reference_numbers::{assert_near, check_load, check_principal, check_quality};
use crate::run::Folder;

/// Force laws, an elliptic integral and sums of up to twelve contacts: a few hundred roundings.
/// Points go through a search for the nearest point of the boundary.
const ROUNDING: f64 = 1e-11;

#[test]
fn outlines_are_analyzed_as_in_the_reference_cases() {
    for prefix in ["planar_", "offeq_", "paper_"] {
        check_all(
            prefix,
            |case| json!({ "planar": { "outline": case["input"]["object"]["vertices"] } }),
        );
    }
}

#[test]
fn ellipses_are_analyzed_as_in_the_reference_cases() {
    check_all("ellipse_", |case| {
        let part = &case["input"]["object"];
        json!({ "planar": { "ellipse": part["axes"], "center": part["centre"] } })
    });
}

#[test]
fn ellipsoids_are_analyzed_as_in_the_reference_cases() {
    check_all("ellipsoid_", |case| {
        let part = &case["input"]["object"];
        json!({ "spatial": { "ellipsoid": part["axes"], "center": part["centre"] } })
    });
}

#[test]
fn polyhedra_are_analyzed_as_in_the_reference_cases() {
    for prefix in ["spatial_", "degenerate_"] {
        check_all(prefix, |case| {
            let part = &case["input"]["object"];
            json!({ "spatial": { "vertices": part["vertices"], "faces": part["faces"] } })
        });
    }
}

/// Analyzes each case in the frame of its body, and asks for it along the axes of the world.
fn check_all(prefix: &str, part: impl Fn(&Value) -> Value) {
    for (name, case) in matching(prefix) {
        let turn = numbers(&case["input"]["frame"]["theta"]);
        let back: Vec<f64> = turn.iter().map(|angle| -angle).collect();
        let dimension = if turn.len() == 1 { 2 } else { 3 };
        let frame: Vec<String> =
            vec![0.0; dimension].iter().chain(&back).map(ToString::to_string).collect();
        let file = json!({
            "part": part(&case),
            "contacts": contacts(&case),
            "load_cases": load_cases(&case),
        });
        let folder = Folder::new(&format!("reference-{name}"));
        folder.write("grasp.json", file.to_string());
        let first = case["input"]["second_order"] == false;
        let order = if first { "first" } else { "second" };
        let command = format!("analyze grasp.json --order {order} --frame {}", frame.join(","));
        let ran = folder.run(&format!("{command} --format json"));
        assert!(ran.code == Some(0) || ran.code == Some(3), "{name}: {}", ran.err);
        check(&name, &ran.json(), &case["output"]);
    }
}

/// The load of a case, along the axes of the body; none if nothing holds it.
fn load_cases(case: &Value) -> Vec<Value> {
    let (turn, load) = (&case["input"]["frame"]["theta"], &case["output"]["load"]);
    if load.is_null() {
        return Vec::new();
    }
    let load = numbers(&load["wrench"]);
    let [force, torque] = if load.len() == 3 {
        let frame = planar::Frame::new([0.0; 2], number(turn));
        let force = frame.direction_in_frame(Vector::from_fn(|i| load[i]));
        [json!(force.to_array()), json!(load[2])]
    } else {
        let frame = spatial::Frame::new([0.0; 3], array(turn));
        let parts = [0, 3].map(|start| Vector::<3>::from_fn(|i| load[start + i]));
        parts.map(|part| json!(frame.direction_in_frame(part).to_array()))
    };
    vec![json!({ "force": force, "torque": torque })]
}

fn contacts(case: &Value) -> Vec<Value> {
    let given = list(&case["input"]["contacts"]).iter().zip(list(&case["output"]["contacts"]));
    given
        .map(|(given, found)| {
            let mut contact = json!({
                "point": found["b_body"],
                "inward_normal": found["n_body"],
                "preload": given["f"],
                "finger": { "radius": given["radius"] },
                "law": law(&given["law"]),
            });
            for piece in ["edge", "face"] {
                if let Some(number) = given.get(piece) {
                    contact[piece] = number.clone();
                }
            }
            contact
        })
        .collect()
}

fn law(given: &Value) -> Value {
    match given["type"].as_str() {
        Some("linear") => json!({ "kind": "linear", "stiffness": given["k"] }),
        Some("power") => {
            json!({ "kind": "power", "coefficient": given["c"], "exponent": given["p"] })
        }
        Some("hertz") => json!({ "kind": "hertz", "effective_modulus": given["E_star"] }),
        Some("hertz_circular") => json!({
            "kind": "hertz", "effective_modulus": given["E_star"], "relative_radius": given["R"]
        }),
        _ => json!({
            "kind": "line",
            "thickness": given["ell"],
            "reference_depth": given["d_B"],
            "finger": { "young": given["E_A"], "poisson": given["nu_A"] },
            "part": { "young": given["E_B"], "poisson": given["nu_B"] },
        }),
    }
}

fn check(name: &str, report: &Value, expected: &Value) {
    for (found, expected) in list(&report["contacts"]).iter().zip(list(&expected["contacts"])) {
        for (key, reference) in [("overlap", "delta"), ("stiffness", "fprime")] {
            let (found, reference) = (number(&found[key]), number(&expected[reference]));
            assert_close(found, reference, ROUNDING, reference, format!("{name}: {key}"));
        }
    }
    for (key, matrix) in
        [("stiffness", "K"), ("stiffness_first_order", "K1"), ("stiffness_preload", "K2")]
    {
        if expected[matrix].is_null() {
            continue;
        }
        let scale = numbers(&expected["K"]).into_iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        let (found, matrix) = (numbers(&report[key]), numbers(&expected[matrix]));
        assert_near(&found, &matrix, ROUNDING, scale, &format!("{name}: {key}"));
    }
    match expected["stability"].as_str() {
        Some("not_stable") => assert!(
            report["stability"] == "unstable" || report["stability"] == "marginal",
            "{name}: {}",
            report["stability"]
        ),
        stability => assert_eq!(report["stability"].as_str(), stability, "{name}"),
    }
    assert_eq!(report["equilibrium"]["holds"], expected["equilibrium"], "{name}");
    if report["equilibrium"]["holds"] == false {
        // All that follows from the stiffness then depends on where it is formed.
        return;
    }
    assert_eq!(report["force_closure"], expected["force_closure_frictionless"], "{name}");
    let principal = &expected["principal"];
    if report["translational"].is_null() {
        return assert!(report["free_motion"].is_object() && principal["mu"].is_null(), "{name}");
    }
    check_principal(name, report, principal);
    check_quality(name, report, &expected["quality"]);
    check_load(name, &report["load_cases"][0], &expected["load"]);
}
