//! What follows from the stiffness of a grasp against the reference cases.

use clench::screw::Vector;
use clench::screw::spatial::cross;
use clench_testkit::assert_close;
use clench_testkit::cases::{Value, list, number, numbers};

/// Points of smooth parts go through a search for the nearest one, laws through their inverses; and
/// eigenvalues have `EPSILON` times the quotient of the largest and the smallest one besides.
const DIGITS: f64 = 1e-10;

/// A direction turns by the rounding of the stiffness, some hundred units, over the gap of its
/// eigenvalue to the next one, relative to the largest.
const TURN: f64 = 1e-13;

/// Directions that may turn by more are those of repeated eigenvalues.
const REPEATED: f64 = 1e-3;

/// In the cases the least value over the points of a smooth part comes from a search.
const SEARCHED: f64 = 1e-9;

/// The principal stiffnesses with their matrices, centers and axes.
pub(crate) fn check_principal(name: &str, report: &Value, expected: &Value) {
    let [sigma, mu] = ["sigma", "mu"].map(|key| numbers(&expected[key]));
    for (key, expected) in [("translational", &sigma), ("rotational", &mu)] {
        let scale = expected[expected.len() - 1];
        assert_near(&values(&report[key], "value"), expected, DIGITS, scale, name);
    }
    let spread = DIGITS + f64::EPSILON * condition(&sigma).max(condition(&mu));
    for (key, reference) in [
        ("restricted_stiffness", "K_V"),
        ("translational_compliance", "C_W"),
        ("twist_map", "P1"),
        ("pitch_tensor", "S"),
        ("loncaric_center_of_stiffness", "centre_of_stiffness"),
        ("loncaric_center_of_compliance", "centre_of_compliance_loncaric"),
        (center(report), "centre"),
    ] {
        if expected[reference].is_null() {
            assert!(report.get(key).is_none(), "{name}: {key}");
            continue;
        }
        let wanted = numbers(&expected[reference]);
        // Lengths are as exact as the largest of them, however near the centers are to zero.
        let scale = match reference {
            "K_V" | "C_W" => largest(&wanted),
            _ => largest(&numbers(&report["contacts"][0]["point"])).max(1.0),
        };
        assert_near(&numbers(&report[key]), &wanted, spread, scale, &format!("{name}: {key}"));
    }
    if report["dimension"] == 3 {
        let [twists, wrenches] = ["twist_axes", "wrench_axes"].map(|key| list(&expected[key]));
        check_axes(name, list(&report["rotational"]), (twists, "omega"), &mu);
        check_axes(name, list(&report["translational"]), (wrenches, "f"), &sigma);
    }
}

/// The axes of those stiffnesses that no other one is equal to.
fn check_axes(name: &str, found: &[Value], (expected, along): (&[Value], &str), sizes: &[f64]) {
    for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
        let turn = turn(sizes, i);
        if turn > REPEATED {
            continue;
        }
        let vector = |value: &Value| Vector::<3>::from_fn(|i| number(&value[i]));
        let pitch = number(&expected["pitch"]);
        assert_close(number(&found["pitch"]), pitch, turn, 1.0, format!("{name}: pitch"));
        let (direction, wanted) = (vector(&found["direction"]), vector(&expected[along]));
        let off = cross(direction, wanted).norm();
        assert_close(off, 0.0, turn, 1.0, format!("{name}: direction"));
        let apart = cross(vector(&found["axis_point"]) - vector(&expected["point"]), wanted);
        assert_close(apart.norm(), 0.0, turn, 1.0, format!("{name}: axis"));
    }
}

/// The quality, and what it is made of.
pub(crate) fn check_quality(name: &str, report: &Value, expected: &Value) {
    let mu = values(&report["rotational"], "value");
    let clusters = list(&expected["clusters"]);
    assert_eq!(report["degenerate"], clusters.len() < mu.len(), "{name}");
    let least = DIGITS + f64::EPSILON * condition(&mu);
    let turned = (0..mu.len()).filter(|&i| turn(&mu, i) < REPEATED).map(|i| turn(&mu, i));
    let turned = turned.fold(least, f64::max);
    for (key, reference, tolerance) in [
        ("sigma_min", "sigma_min", DIGITS),
        ("quality", "Q", turned),
        ("quality_rotational", "Q_V", least.max(SEARCHED)),
        ("worst_point_stiffness", "Q_pt", least.max(SEARCHED)),
    ] {
        let (found, wanted) = (number(&report[key]), number(&expected[reference]));
        assert_close(found, wanted, tolerance, wanted, format!("{name}: {key}"));
    }
    for (key, reference) in
        [("reach", "rho_max"), ("deflection", "deflection"), ("equivalent", "mu_eq")]
    {
        if let (Some(wanted), false) = (expected[reference].as_array(), clusters.len() < mu.len()) {
            for (i, wanted) in wanted.iter().map(number).enumerate() {
                let found = number(&report["rotational"][i][key]);
                assert_close(found, wanted, turn(&mu, i), wanted, format!("{name}: {key}"));
            }
        }
    }
    let Some(of_clusters) = expected["mu_eq_cluster"].as_array() else { return };
    for (cluster, wanted) in clusters.iter().zip(of_clusters.iter().map(number)) {
        let members = numbers(cluster);
        for (i, rotation) in list(&report["rotational"]).iter().enumerate() {
            if members.contains(&(i as f64)) {
                let found = number(&rotation["equivalent"]);
                assert_close(found, wanted, turned, wanted, format!("{name}: mu_eq"));
                assert_eq!(rotation.get("softest_direction").is_some(), members.len() > 1);
            }
        }
    }
}

/// The displacement under the load of a case, and its largest.
pub(crate) fn check_load(name: &str, found: &Value, expected: &Value) {
    let wrench = numbers(&expected["wrench"]);
    let given = [numbers(&found["force"]), numbers(&found["torque"])].concat();
    assert_near(&given, &wrench, DIGITS, largest(&wrench), &format!("{name}: load"));
    let displacement = &found["displacement"];
    let parts = ["translation", "rotation"].map(|key| numbers(&displacement[key]));
    let twist = numbers(&expected["twist"]);
    assert_near(&parts.concat(), &twist, DIGITS, largest(&twist), &format!("{name}: twist"));
    if let Some(deflection) = expected["deflection"].as_f64() {
        let distance = number(&found["largest"]["distance"]);
        assert_close(distance, deflection, DIGITS, deflection, format!("{name}: deflection"));
    }
}

/// Numbers of one scale, some of which may cancel.
pub(crate) fn assert_near(found: &[f64], expected: &[f64], tolerance: f64, scale: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert_close(*found, *expected, tolerance, scale, format!("{what}[{i}]"));
    }
}

fn values(entries: &Value, key: &str) -> Vec<f64> {
    list(entries).iter().map(|entry| number(&entry[key])).collect()
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |largest, x| largest.max(x.abs()))
}

/// Of ascending positive eigenvalues.
fn condition(values: &[f64]) -> f64 {
    values[values.len() - 1] / values[0]
}

/// How far the direction of number `i` of the ascending `values` may be off.
fn turn(values: &[f64], i: usize) -> f64 {
    let gap = |j: usize| (values[i] - values[j]).abs() / values[values.len() - 1];
    let gap = (0..values.len()).filter(|&j| j != i).map(gap).fold(1.0, f64::min);
    DIGITS + TURN / gap + f64::EPSILON * condition(values)
}

fn center(report: &Value) -> &'static str {
    if report["dimension"] == 2 { "center_of_compliance" } else { "center" }
}
