//! Laws and overlaps against values from an independent program.

use std::f64::consts::PI;

use clench_contact::{
    Contact, Curvature, Elastic, ForceLaw, Geometry, Hertz, Law, Line, LineContact,
    effective_modulus,
};
use clench_screw::{Mat, Vector};
use clench_testkit::cases::{Value, array, matching, number, numbers, rows};
use clench_testkit::{assert_all_close, assert_close};

/// Laws are products of a few correctly rounded factors and roots; two iterations end at rounding.
const DIGITS: f64 = 1e-13;

/// The derivatives of the cases are differences of the geometry, to ten digits by their own
/// account; the smallest entries are those of a case's roundest bodies.
const DERIVATIVE_DIGITS: f64 = 1e-10;

fn elastic(input: &Value, body: &str) -> Elastic {
    // A rigid body is one whose modulus is beyond all others.
    let young = number(&input[format!("E_{body}")]).min(1e300);
    Elastic::new(young, number(&input[format!("nu_{body}")])).unwrap()
}

#[test]
fn elliptic_contacts_are_those_of_the_cases() {
    for (name, case) in matching("hertz_elliptic_") {
        let (input, output) = (&case["input"], &case["output"]);
        let modulus = effective_modulus(elastic(input, "A"), elastic(input, "B"));
        let law = Hertz::elliptic(modulus, [number(&input["A"]), number(&input["B"])]).unwrap();
        let overlap = law.overlap(number(&input["f"]));
        let [a, b] = law.semi_axes(overlap);
        let found = [
            ("E_star", modulus),
            ("delta", overlap),
            ("fprime", law.slope(overlap)),
            ("energy", law.energy(overlap)),
            ("a", a),
            ("b", b),
            ("one_minus_m", (b / a) * (b / a)),
            ("p0", law.peak_pressure(overlap)),
            ("c", law.coefficient()),
        ];
        for (key, found) in found {
            let wanted = number(&output[key]);
            assert_close(found, wanted, DIGITS, wanted, format!("{name} {key}"));
        }
        assert_close(law.force(overlap), number(&input["f"]), DIGITS, 200.0, &name);
    }
}

#[test]
fn the_ellipse_of_two_skewed_bodies_is_that_of_the_cases() {
    for (name, case) in matching("hertz_general_") {
        let (input, output) = (&case["input"], &case["output"]);
        let radii = |key: &str| array::<2>(&input[key]).map(f64::recip);
        let phi = number(&input["phi"]);
        let place = Geometry {
            point: Vector::new([0.3, -0.2, 0.9]),
            // The bodies' angle is counted about the normal.
            inward_normal: Vector::new([0.0, 0.0, 1.0]),
            finger: Curvature::principal_radii(radii("kappa_A"), Vector::new([1.0, 0.0, 0.0])),
            part: Curvature::principal_radii(
                radii("kappa_B"),
                Vector::new([phi.cos(), phi.sin(), 0.0]),
            ),
        };
        let relative = place.relative_curvature().unwrap();
        let modulus = number(&input["E_star"]);
        let law = Hertz::of(modulus, &place).unwrap();
        let overlap = number(&input["delta"]);
        let [a, b] = law.semi_axes(overlap);
        let found = [
            ("A", 0.5 * relative.smaller),
            ("B", 0.5 * relative.larger),
            ("a", a),
            ("b", b),
            ("f", law.force(overlap)),
            ("fprime", law.slope(overlap)),
            ("energy", law.energy(overlap)),
        ];
        for (key, found) in found {
            let wanted = number(&output[key]);
            assert_close(found, wanted, DIGITS, wanted, format!("{name} {key}"));
        }
        let angle = relative.along[1].atan2(relative.along[0]);
        let off = (angle - number(&output["major_axis_angle"])) / PI;
        assert_close(off, off.round(), DIGITS, 1.0, format!("{name} direction"));
    }
}

#[test]
fn line_contacts_are_those_of_the_cases() {
    for (name, case) in matching("law_line_") {
        let (given, output) = (&case["input"]["law"], &case["output"]);
        let law = Line::new(&LineContact {
            radius: number(&given["R"]),
            thickness: number(&given["ell"]),
            reference_depth: number(&given["d_B"]),
            finger: elastic(given, "A"),
            part: elastic(given, "B"),
        })
        .unwrap();
        let force = number(&case["input"]["f"]);
        let overlap = law.overlap(force);
        let found = [
            ("delta", overlap),
            ("fprime", law.slope(overlap)),
            ("half_width", law.half_width(force)),
            ("energy", law.energy(overlap)),
            ("f_max", law.largest_force()),
            ("delta_max", law.largest_overlap()),
        ];
        for (key, found) in found {
            let wanted = number(&output[key]);
            assert_close(found, wanted, DIGITS, wanted, format!("{name} {key}"));
        }
        assert_close(law.force(overlap), force, DIGITS, force, format!("{name} f"));
    }
}

#[test]
fn simple_laws_are_those_of_the_cases() {
    for (name, case) in matching("law_simple_") {
        let (given, output) = (&case["input"]["law"], &case["output"]);
        let overlap = number(&case["input"]["delta"]);
        let law = match given["type"].as_str().unwrap() {
            "hertz_circular" => {
                let law = Hertz::circular(number(&given["E_star"]), number(&given["R"])).unwrap();
                let a = number(&output["a"]);
                assert_close(law.semi_axes(overlap)[0], a, DIGITS, a, &name);
                assert_close(law.semi_axes(overlap)[1], a, DIGITS, a, &name);
                Law::Hertz(law)
            }
            "power" => Law::power(number(&given["c"]), number(&given["p"])).unwrap(),
            other => panic!("law {other}"),
        };
        let found = [
            ("f", law.force(overlap)),
            ("fprime", law.slope(overlap)),
            ("energy", law.energy(overlap)),
        ];
        for (key, found) in found {
            let wanted = number(&output[key]);
            assert_close(found, wanted, DIGITS, wanted, format!("{name} {key}"));
        }
    }
}

fn overlaps<const N: usize, const M: usize>(prefix: &str) -> usize {
    let mut checked = 0;
    for (name, case) in matching(prefix) {
        let (input, output) = (&case["input"], &case["output"]);
        let depth = number(&output["delta"]);
        // A contact presses: the separated pairs of the cases are tested where overlaps are
        // measured.
        if depth < -1e-9 {
            continue;
        }
        let tensor = |key: &str| Curvature::of_shape_operator(Mat::new(rows::<N, N>(&output[key])));
        let radius = &input["finger"]["radius"];
        let origin: Vector<N> = array(&input["frame"]["d"]).into();
        let finger = radius.as_f64().map_or_else(|| tensor("L_A"), Curvature::round);
        let place = Geometry {
            point: array(&output["b"]).into(),
            inward_normal: array(&output["n"]).into(),
            finger,
            part: tensor("L_B"),
        };
        let law = Law::linear(1.0).unwrap();
        let contact = Contact::<N, M>::overlapping(place, law, depth.max(0.0)).unwrap();
        let overlap = contact.overlap();
        let deepest = overlap.finger_point();
        assert_all_close(&deepest.to_array(), &numbers(&output["a"]), 1e-12, &name);
        let gradient = overlap.gradient(origin);
        let found = [gradient.force.to_array().as_slice(), &gradient.torque.to_array()].concat();
        assert_all_close(&found, &numbers(&output["grad"]), DERIVATIVE_DIGITS, &name);
        let hessian = overlap.hessian(origin);
        let entries: Vec<f64> = (0..N + M)
            .flat_map(|i| (0..N + M).map(move |j| (i, j)))
            .map(|(i, j)| hessian.entry(i, j))
            .collect();
        assert_all_close(&entries, &numbers(&output["hess"]), DERIVATIVE_DIGITS, &name);
        checked += 1;
    }
    checked
}

#[test]
fn gradients_and_hessians_are_those_of_the_cases() {
    assert!(overlaps::<2, 1>("overlap_planar_") >= 2);
    assert!(overlaps::<3, 3>("overlap_ellipsoids_") >= 3);
    assert!(overlaps::<3, 3>("overlap_sphere_plane_") >= 2);
    assert!(overlaps::<3, 3>("overlap_sphere_saddle_") >= 2);
}
