//! The reference cases of an independent program: changes of frame, screws, rotations.

use clench_screw::{Axis, Frame, Mat, Screw, Stiffness, Twist, Vector, Wrench, planar, spatial};
use clench_testkit::cases::{Value, array, list, matching, number, numbers, rows};
use clench_testkit::{assert_all_close, assert_close};

/// The reference is rounded once from 40 digits; our own sums have at most 36 terms of size 1e2.
const DIGITS: f64 = 1e-13;

fn split<const N: usize, const M: usize>(v: &Value) -> (Vector<N>, Vector<M>) {
    let all = numbers(v);
    assert_eq!(all.len(), N + M);
    (Vector::from_fn(|i| all[i]), Vector::from_fn(|i| all[N + i]))
}

fn stiffness<const N: usize, const M: usize>(v: &Value) -> Stiffness<N, M> {
    Stiffness::from_fn(|i, j| number(&v[i][j]))
}

fn change_of_frame<const N: usize, const M: usize>(
    name: &str,
    case: &Value,
    frame: impl Fn(&Value, &Value) -> Frame<N, M>,
) {
    let (given, wanted) = (&case["input"], &case["output"]);
    let pose = frame(&given["d_0"], &given["theta_0"]);
    let world = frame(&given["d_w"], &given["theta_w"]);
    let body = frame(&given["d_b"], &given["theta_b"]);
    let change = Frame::of_change(&pose, &world, &body);

    let (linear, angular) = split::<N, M>(&given["twist"]);
    let (force, torque) = split::<N, M>(&given["wrench"]);
    let q = Twist { linear, angular }.in_frame(&change);
    let w = Wrench { force, torque }.in_frame(&change);
    let k = stiffness::<N, M>(&given["K"]).in_frame(&change);
    let new_pose = world.inverse() * pose * body;

    let check = |found: Vec<f64>, key: &str| {
        assert_all_close(&found, &numbers(&wanted[key]), DIGITS, format!("{name} {key}"));
    };
    check([q.linear.to_array().as_slice(), &q.angular.to_array()].concat(), "twist_bar");
    check([w.force.to_array().as_slice(), &w.torque.to_array()].concat(), "wrench_bar");
    let entries = (0..N + M).flat_map(|i| (0..N + M).map(move |j| k.entry(i, j)));
    check(entries.collect(), "K_bar");
    check(new_pose.origin().to_array().to_vec(), "d_bar");
    check(new_pose.axes().rows().as_flattened().to_vec(), "R_bar");
}

#[test]
fn twists_wrenches_and_stiffness_change_frame_as_the_cases_say() {
    for (name, case) in matching("transform_") {
        match case["input"]["dim"].as_u64() {
            Some(2) => change_of_frame(&name, &case, |d, theta| {
                planar::Frame::new(array(d), number(theta))
            }),
            Some(3) => change_of_frame(&name, &case, |d, theta| {
                spatial::Frame::new(array(d), array(theta))
            }),
            other => panic!("{name}: dimension {other:?}"),
        }
    }
}

#[test]
fn screw_axes_are_those_of_the_cases() {
    let (_, case) = &matching("screws")[0];
    let sixes = list(&case["input"]["six"]);
    let items = list(&case["output"]["items"]);
    assert_eq!(sixes.len(), items.len());
    for (i, (six, item)) in sixes.iter().zip(items).enumerate() {
        let (a, b) = split::<3, 3>(six);
        check(Twist { linear: a, angular: b }.screw(), &item["as_twist"], "translation", i);
        check(Wrench { force: a, torque: b }.screw(), &item["as_wrench"], "couple", i);
    }
}

fn check(found: Screw, wanted: &Value, free: &str, i: usize) {
    let what = format!("screw {i}");
    let kind = wanted["kind"].as_str().unwrap();
    match found {
        Screw::Free { direction, magnitude } => {
            assert_eq!(kind, free, "{what}");
            assert_all_close(&direction.to_array(), &numbers(&wanted["direction"]), DIGITS, &what);
            assert_close(magnitude, number(&wanted["magnitude"]), DIGITS, magnitude, &what);
        }
        Screw::Axis { axis: Axis { direction, point, pitch }, magnitude } => {
            assert_eq!(kind, "screw", "{what}");
            assert_all_close(&direction.to_array(), &numbers(&wanted["direction"]), DIGITS, &what);
            let expected = numbers(&wanted["point"]);
            let scale = Vector::new(array::<3>(&wanted["point"])).norm().max(1.0);
            for (p, e) in point.to_array().iter().zip(expected) {
                assert_close(*p, e, DIGITS, scale, &what);
            }
            assert_close(pitch, number(&wanted["pitch"]), DIGITS, 1.0, &what);
            assert_close(magnitude, number(&wanted["magnitude"]), DIGITS, magnitude, &what);
        }
        other @ Screw::Zero => panic!("{what}: {other:?}"),
    }
}

#[test]
fn rotations_and_left_jacobians_are_those_of_the_cases() {
    let (_, case) = &matching("rotations")[0];
    let thetas = list(&case["input"]["theta"]);
    let items = list(&case["output"]["items"]);
    assert_eq!(thetas.len(), items.len());
    for (theta, item) in thetas.iter().zip(items) {
        let theta: Vector<3> = array::<3>(theta).into();
        let wanted = Mat::<3, 3>::new(rows(&item["R"]));
        let found = spatial::rotation(theta);
        assert_all_close(found.rows().as_flattened(), wanted.rows().as_flattened(), 1e-15, "R");
        let wanted = Mat::<3, 3>::new(rows(&item["left_jacobian"]));
        let found = spatial::left_jacobian(theta);
        // (t - sin t) / t^3 loses up to 16 units above the switch to the series.
        let limit = 16.0 * f64::EPSILON;
        assert_all_close(found.rows().as_flattened(), wanted.rows().as_flattened(), limit, "J_l");
    }
}
