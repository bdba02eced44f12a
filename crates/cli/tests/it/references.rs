//! Grasps of every kind against the reference cases, through the command.

use clench::screw::Vector;
use clench::screw::spatial::cross;
use clench_testkit::assert_close;
use clench_testkit::cases::{Value, list, matching, number, numbers};
use serde_json::json;

use crate::run::Folder;

/// Force laws, an elliptic integral and sums of up to twelve contacts: a few hundred roundings.
/// Points go through a search for the nearest point of the boundary.
const ROUNDING: f64 = 1e-11;

/// A principal direction of a stiffness whose neighbors differ by a thousandth moves by a thousand
/// roundings, and an axis with it.
const AXIS: f64 = 1e-8;

#[test]
fn outlines_are_analyzed_as_in_the_reference_cases() {
    for prefix in ["planar_", "offeq_"] {
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
        let file = json!({ "part": part(&case), "contacts": contacts(&case) });
        let folder = Folder::new(&format!("reference-{name}"));
        folder.write("grasp.json", file.to_string());
        let command = format!("analyze grasp.json --order second --frame {}", frame.join(","));
        let ran = folder.run(&format!("{command} --format json"));
        assert!(ran.code == Some(0) || ran.code == Some(3), "{name}: {}", ran.err);
        check(&name, &ran.json(), &case["output"]);
    }
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
    for (key, reference) in [("translational", "sigma"), ("rotational", "mu")] {
        let values: Vec<f64> = list(&report[key]).iter().map(|p| number(&p["value"])).collect();
        let reference = numbers(&principal[reference]);
        let scale = reference[reference.len() - 1];
        assert_near(&values, &reference, ROUNDING, scale, &format!("{name}: {key}"));
    }
    let key = if report["dimension"] == 2 { "center_of_compliance" } else { "center" };
    let (center, size) = (numbers(&report[key]), number(&expected["length"]));
    let expected_center = numbers(&principal["centre"]);
    assert_near(&center, &expected_center, AXIS, size, &format!("{name}: {key}"));
    if let Some(clusters) = expected["quality"]["clusters"].as_array()
        && clusters.len() == 3
    {
        check_axes(name, report, principal);
    }
}

/// Principal rotational stiffnesses that differ have one axis each.
fn check_axes(name: &str, report: &Value, principal: &Value) {
    for (found, expected) in list(&report["rotational"]).iter().zip(list(&principal["twist_axes"]))
    {
        let pitch = number(&expected["pitch"]);
        assert_close(number(&found["pitch"]), pitch, AXIS, 1.0, format!("{name}: pitch"));
        let vector = |value: &Value| Vector::<3>::from_fn(|i| number(&value[i]));
        let (direction, omega) = (vector(&found["direction"]), vector(&expected["omega"]));
        let along = direction.dot(omega).abs();
        assert_close(along, 1.0, AXIS, 1.0, format!("{name}: direction"));
        let apart = vector(&found["axis_point"]) - vector(&expected["point"]);
        assert!(cross(apart, omega).norm() <= AXIS, "{name}: {found}");
    }
}

/// Numbers of one scale, some of which may cancel.
fn assert_near(found: &[f64], expected: &[f64], tolerance: f64, scale: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert_close(*found, *expected, tolerance, scale, format!("{what}[{i}]"));
    }
}
