//! Ellipses and ellipsoids against the geometry they describe.

use clench_screw::{Frame, Mat, Vector, planar, spatial};
use clench_shape::{Ellipsoid, EllipsoidError, LARGEST_ASPECT, LARGEST_COORDINATE};
use clench_testkit::cases::{array, list, matching, number, numbers};
use clench_testkit::{Random, assert_all_close, assert_close};

/// A result is a few products, quotients and roots of the input, each rounded once.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Semi-axes of all kinds: alike, equal, thin by up to a million, tiny and huge.
fn semi_axes<const N: usize>(r: &mut Random) -> Vec<[f64; N]> {
    let mut all = vec![[1.0; N], std::array::from_fn(|i| [2.0, 1.0, 1.0][i])];
    for aspect in [0.3, 3.0, 6.0] {
        for size in [1e-9, 1.0, 1e9] {
            for _ in 0..4 {
                all.push(std::array::from_fn(|_| size * 10_f64.powf(-r.between(0.0, aspect))));
            }
        }
    }
    all
}

/// Directions in general position, and along axes and planes of symmetry.
fn directions<const N: usize>(r: &mut Random) -> Vec<Vector<N>> {
    let mut all: Vec<Vector<N>> = (0..20).map(|_| Vector::new(r.array(1.0))).collect();
    for i in 0..N {
        let axis = Vector::from_fn(|k| f64::from(u8::from(k == i)));
        let level = Vector::from_fn(|k| if k == i { 0.0 } else { all[0][k] });
        all.extend([axis, -axis, level]);
    }
    all.iter().map(|d| *d * (1.0 / d.norm())).collect()
}

fn poses2(r: &mut Random) -> Vec<Frame<2, 1>> {
    let [x, y, angle] = r.array(3.0);
    vec![Frame::IDENTITY, planar::Frame::new([x, y], angle)]
}

fn poses3(r: &mut Random) -> Vec<Frame<3, 3>> {
    vec![Frame::IDENTITY, spatial::Frame::new(r.array(3.0), r.array(2.0))]
}

fn moved<const N: usize, const M: usize>(
    axes: [f64; N],
    turn: &Frame<N, M>,
) -> (Ellipsoid<N>, Vector<N>) {
    let size = axes.into_iter().fold(0.0, f64::max);
    let body = Ellipsoid::new(Vector::ZERO, axes).unwrap().placed(turn);
    // The center at a distance of the order of the body itself.
    let center = turn.origin() * size;
    let there = Ellipsoid::new(turn.point_in_frame(center), axes).unwrap().placed(turn);
    assert_all_close(&there.axes().rows()[0], &body.axes().rows()[0], f64::EPSILON, "axes");
    (there, there.center())
}

/// `sum (x_i / a_i)^2` along the axes of the body.
fn implicit<const N: usize>(body: &Ellipsoid<N>, point: Vector<N>) -> f64 {
    let local = body.axes().transpose() * (point - body.center());
    Vector::<N>::from_fn(|i| local[i] / body.semi_axes()[i]).norm_squared()
}

fn boundary_laws<const N: usize, const M: usize>(body: &Ellipsoid<N>, m: Vector<N>) {
    let at = body.at_normal(m * 7.0).unwrap();
    let what = format!("{body:?} at {m:?}");
    assert_all_close(&at.inward_normal.to_array(), &(-m).to_array(), ROUNDING, &what);
    // The point is on the boundary, and no point is farther along the normal: h(m) = m . x.
    let from_center = at.point - body.center();
    let scale = body.radius() + body.center().norm();
    let thinnest = body.semi_axes().into_iter().fold(f64::INFINITY, f64::min);
    assert_close(implicit(body, at.point), 1.0, ROUNDING, scale / thinnest, &what);
    assert_close(body.support(m), at.point.dot(m), ROUNDING, scale, &what);
    assert!(from_center.dot(m) > 0.0, "{what}");
    // The curvature: symmetric, without a part along the normal, positive.
    let l = at.shape_operator;
    assert_eq!(l, l.transpose(), "{what}");
    let null = l * at.inward_normal;
    assert_close(null.norm(), 0.0, ROUNDING, l.max_abs(), &what);
    for i in 0..N {
        assert!(l[i][i] >= -ROUNDING * l.max_abs(), "{what}");
    }
}

#[test]
fn boundary_points_are_on_the_boundary_and_farthest_along_their_normal() {
    let r = &mut Random::new(31);
    for axes in semi_axes::<2>(r) {
        for turn in poses2(r) {
            let (body, _) = moved(axes, &turn);
            for m in directions(r) {
                boundary_laws::<2, 1>(&body, m);
            }
        }
    }
    for axes in semi_axes::<3>(r) {
        for turn in poses3(r) {
            let (body, _) = moved(axes, &turn);
            for m in directions(r) {
                boundary_laws::<3, 3>(&body, m);
            }
        }
    }
}

/// The Gauss map by central differences: the outward normal changes by `L dx`.
fn gauss_map_law<const N: usize>(body: &Ellipsoid<N>, m: Vector<N>, tangent: Vector<N>) {
    // Central differences of step `e` err by e^2 and by the rounding over e, both near 1e-10.
    let e = 1e-5;
    let at = body.at_normal(m).unwrap();
    let along = tangent - m * tangent.dot(m);
    let (front, back) =
        (body.at_normal(m + along * e).unwrap(), body.at_normal(m - along * e).unwrap());
    let turned = back.inward_normal - front.inward_normal;
    let expected = at.shape_operator * (front.point - back.point);
    assert_all_close(&expected.to_array(), &turned.to_array(), 1e-8, format!("{body:?} {m:?}"));
}

#[test]
fn the_shape_operator_is_the_derivative_of_the_gauss_map() {
    let r = &mut Random::new(32);
    for _ in 0..50 {
        let axes = [r.between(0.5, 2.0), r.between(0.5, 2.0), r.between(0.5, 2.0)];
        let body = Ellipsoid::new(Vector::ZERO, axes).unwrap();
        let body = body.placed(&spatial::Frame::new(r.array(0.1), r.array(2.0)));
        let flat = Ellipsoid::new(Vector::ZERO, [axes[0], axes[1]]).unwrap();
        let flat = flat.placed(&planar::Frame::new(r.array(0.1), r.between(0.0, 3.0)));
        for (m, t) in directions(r).into_iter().zip(directions(r).into_iter().rev()) {
            gauss_map_law::<3>(&body, m, t);
        }
        for m in directions(r) {
            gauss_map_law::<2>(&flat, m, planar::quarter_turn(m));
        }
    }
}

#[test]
fn curvatures_of_thin_bodies_keep_their_digits() {
    // The curvature of an ellipse at (a cos t, b sin t) is a b / (a^2 sin^2 + b^2 cos^2)^(3/2).
    let (a, b) = (1.0_f64, 1e-6_f64);
    let body = Ellipsoid::new(Vector::ZERO, [a, b]).unwrap();
    for i in 1..200 {
        let t = 1.5e-2_f64 * f64::from(i) * 0.5;
        let (s, c) = t.sin_cos();
        let at = body.at_normal([b * c, a * s].into()).unwrap();
        let expected = a * b / (a * s).hypot(b * c).powi(3);
        assert_close(at.shape_operator.trace(), expected, ROUNDING, expected, format!("t = {t}"));
    }
}

/// Moving out along a normal, or in by less than to the plane of symmetry, the foot stays.
fn nearest_laws<const N: usize>(body: &Ellipsoid<N>, m: Vector<N>) {
    let foot = body.at_normal(m).unwrap();
    let local = body.axes().transpose() * (foot.point - body.center());
    let thinnest = body.semi_axes().into_iter().fold(f64::INFINITY, f64::min);
    let h = body.support(m) - body.center().dot(m);
    let limit = thinnest * thinnest / h;
    let size = body.radius();
    for distance in [-0.9 * limit, -1e-3 * limit, 0.0, 1e-6 * thinnest, size, 1e3 * size] {
        // The point in the body's own axes, so that thin bodies keep their digits.
        let point = local + (body.axes().transpose() * m) * distance;
        let own = Ellipsoid::new(Vector::ZERO, body.semi_axes()).unwrap();
        let near = own.nearest(point);
        let what = format!("{body:?}, {m:?}, {distance:e}");
        let scale = distance.abs() + size;
        assert_close(near.signed_distance, distance, ROUNDING, scale, &what);
        let apart = (near.boundary.point - local).norm();
        // The foot moves faster than the point by R / (R - depth), with R >= limit.
        assert_close(apart, 0.0, 20.0 * ROUNDING, scale, &what);
        assert_close(implicit(&own, near.boundary.point), 1.0, ROUNDING, 1.0, &what);
        // Where the body stands changes nothing but the rounding of where the point is.
        let there = body.nearest(body.center() + body.axes().to_owned() * point);
        let far = scale + body.center().norm();
        assert_close(there.signed_distance, distance, ROUNDING, far, &what);
        let back = there.boundary.point + there.boundary.inward_normal * -there.signed_distance;
        let point = body.center() + *body.axes() * point;
        // The normal of a thin body errs by the aspect, but then the distance is short: its
        // product with the error is what counts.
        assert_all_close(&back.to_array(), &point.to_array(), 1e-9, &what);
    }
}

#[test]
fn the_nearest_point_undoes_moving_along_the_normal() {
    let r = &mut Random::new(33);
    for axes in semi_axes::<2>(r) {
        for turn in poses2(r) {
            let (body, _) = moved(axes, &turn);
            for m in directions(r) {
                nearest_laws(&body, m);
            }
        }
    }
    for axes in semi_axes::<3>(r) {
        for turn in poses3(r) {
            let (body, _) = moved(axes, &turn);
            for m in directions(r) {
                nearest_laws(&body, m);
            }
        }
    }
}

#[test]
fn no_sampled_boundary_point_is_nearer_than_the_nearest() {
    let r = &mut Random::new(34);
    for _ in 0..60 {
        let axes = [r.between(0.2, 2.0), r.between(0.2, 2.0), r.between(0.2, 2.0)];
        let body = Ellipsoid::new(Vector::ZERO, axes).unwrap();
        let mut sample = || {
            let u = Vector::<3>::new(r.array(1.0));
            Vector::from_fn(|i| axes[i] * u[i] / u.norm())
        };
        let samples: Vec<Vector<3>> = (0..4000).map(|_| sample()).collect();
        for k in 0..30 {
            // Inside, outside, and on planes and axes of symmetry.
            let mut point = Vector::new(r.array(1.5));
            for i in 0..k % 4 {
                point[(i + k) % 3] = 0.0;
            }
            let near = body.nearest(point);
            let least = samples.iter().map(|s| (*s - point).norm()).fold(f64::INFINITY, f64::min);
            let distance = near.signed_distance.abs();
            assert!(distance <= least + ROUNDING, "{axes:?} {point:?}: {distance} {least}");
            // 4000 samples leave no gap of 0.15 on the unit sphere, which is stretched by up to 2.
            assert!(least < distance + 0.3, "{axes:?} {point:?}: {distance} {least}");
            let inside = implicit(&body, point) < 1.0;
            assert_eq!(near.signed_distance < 0.0, inside, "{axes:?} {point:?}");
        }
    }
}

#[test]
fn points_of_symmetry_have_a_nearest_point_too() {
    let body = Ellipsoid::new(Vector::ZERO, [3.0, 2.0]).unwrap();
    let near = body.nearest(Vector::ZERO);
    assert_eq!((near.signed_distance, near.boundary.point.to_array()), (-2.0, [0.0, 2.0]));
    // On the long axis before the center of curvature, at 3 - 4/3: x = 9 y / 5, up or down.
    let near = body.nearest([1.0, 0.0].into());
    let expected = [9.0 / 5.0, 2.0 * (1.0 - 0.36_f64).sqrt()];
    assert_all_close(&near.boundary.point.to_array(), &expected, ROUNDING, "before");
    // Beyond it the tip is nearest.
    let near = body.nearest([2.0, 0.0].into());
    assert_eq!((near.signed_distance, near.boundary.point.to_array()), (-1.0, [3.0, 0.0]));
    let ball = Ellipsoid::new([1.0, 1.0, 1.0].into(), [2.0; 3]).unwrap();
    assert_eq!(ball.nearest(ball.center()).signed_distance, -2.0);
    assert_eq!(ball.nearest([1.0, 1.0, 7.0].into()).boundary.point.to_array(), [1.0, 1.0, 3.0]);
    assert_eq!(ball.nearest([1.0, 1.0, 7.0].into()).boundary.shape_operator[0][0], 0.5);
}

#[test]
fn the_reference_contacts_are_reproduced() {
    let mut checked = 0;
    for (name, case) in matching("ellipsoid_") {
        let axes: [f64; 3] = array(&case["input"]["object"]["axes"]);
        let center = Vector::new(array(&case["input"]["object"]["centre"]));
        let frame = &case["input"]["frame"];
        let pose = spatial::Frame::new(array(&frame["d"]), array(&frame["theta"]));
        let body = Ellipsoid::new(center, axes).unwrap();
        let output = list(&case["output"]["contacts"]);
        for (contact, expected) in list(&case["input"]["contacts"]).iter().zip(output) {
            let m = Vector::new(array(&contact["m_body"]));
            let at = body.at_normal(m).unwrap();
            let point = numbers(&expected["b_body"]);
            assert_all_close(&at.point.to_array(), &point, ROUNDING, format!("{name} point"));
            let placed = body.placed(&pose).at_normal(pose.direction_to_parent(m)).unwrap();
            let found = placed.shape_operator.rows().concat();
            assert_all_close(&found, &numbers(&expected["LB"]), ROUNDING, format!("{name} L"));
            checked += 1;
        }
    }
    assert!(checked > 20, "only {checked} contacts");
}

#[test]
fn the_reference_contacts_of_ellipses_are_reproduced() {
    let mut checked = 0;
    for (name, case) in matching("ellipse_") {
        let axes: [f64; 2] = array(&case["input"]["object"]["axes"]);
        let center = Vector::new(array(&case["input"]["object"]["centre"]));
        let body = Ellipsoid::new(center, axes).unwrap();
        let output = list(&case["output"]["contacts"]);
        for (contact, expected) in list(&case["input"]["contacts"]).iter().zip(output) {
            let at = body.at_normal(Vector::new(array(&contact["m_body"]))).unwrap();
            let point = numbers(&expected["b_body"]);
            assert_all_close(&at.point.to_array(), &point, ROUNDING, format!("{name} point"));
            let curvature = number(&expected["LB"]);
            assert_close(at.shape_operator.trace(), curvature, ROUNDING, curvature, &name);
            checked += 1;
        }
    }
    assert!(checked >= 8, "only {checked} contacts");
}

#[test]
fn what_is_no_ellipsoid_is_refused_with_its_numbers() {
    let refused = |center: [f64; 2], axes: [f64; 2], expected: EllipsoidError| {
        assert_eq!(Ellipsoid::new(center.into(), axes), Err(expected));
    };
    let infinite = f64::INFINITY;
    let fault = EllipsoidError::CenterNotFinite { component: 1, value: infinite };
    refused([0.0, infinite], [1.0, 1.0], fault);
    let fault = EllipsoidError::CenterTooFar { component: 0, value: -1e200 };
    refused([-1e200, 0.0], [1.0, 1.0], fault);
    for value in [0.0, -1.0, 1e200, 1e-200, infinite] {
        refused([0.0; 2], [1.0, value], EllipsoidError::SemiAxisOutOfRange { axis: 1, value });
    }
    let fault = Ellipsoid::new(Vector::ZERO, [f64::NAN, 1.0]).unwrap_err();
    assert!(fault.to_string().starts_with("semi-axis 0 is NaN, but must be between"), "{fault}");
    let aspect = 1e130 / 1e-130;
    refused([0.0; 2], [1e-130, 1e130], EllipsoidError::TooThin { long: 1, short: 0, aspect });
}

#[test]
fn what_is_no_direction_is_refused() {
    let body = Ellipsoid::new(Vector::ZERO, [3.0, 2.0]).unwrap();
    assert_eq!(body.at_normal(Vector::ZERO), Err(EllipsoidError::ZeroDirection));
    let fault = EllipsoidError::DirectionNotFinite { component: 0, value: f64::INFINITY };
    assert_eq!(body.at_normal([f64::INFINITY, f64::NAN].into()), Err(fault));
    // The smallest direction there is, and the largest.
    for length in [f64::from_bits(1), f64::MAX] {
        let at = body.at_normal([0.0, length].into()).unwrap();
        assert_eq!(at.point.to_array(), [0.0, 2.0]);
    }
}

#[test]
fn extreme_sizes_stay_finite() {
    let large = LARGEST_COORDINATE;
    for axes in [[large, large / LARGEST_ASPECT], [1e-130, 1e-30], [1e-130, 1e-130]] {
        let body = Ellipsoid::new(Vector::ZERO, axes).unwrap();
        for point in [[0.0, 0.0], [large, large], [1e-130, 1e-130], [axes[0] * 0.5, axes[1] * 0.5]]
        {
            let near = body.nearest(point.into());
            assert!(near.signed_distance.is_finite(), "{axes:?} {point:?} {near:?}");
            assert!(near.boundary.point.is_finite(), "{axes:?} {point:?} {near:?}");
            assert!(Mat::is_finite(&near.boundary.shape_operator), "{axes:?} {point:?} {near:?}");
        }
    }
}

/// Central differences over 1e-5 of shape operators at points that were really moved, by the
/// nearest point: third derivatives of size 1e3 leave 1e-8.
fn curvatures_change_at_their_rates<const N: usize, const M: usize>(
    placed: impl Fn(&mut Random) -> Frame<N, M>,
    seed: u64,
) {
    let r = &mut Random::new(seed);
    for _ in 0..50 {
        let semi_axes = r.array::<N>(1.0).map(|a| 1.0 + a.abs());
        let body = Ellipsoid::new(r.array(1.0).into(), semi_axes).unwrap().placed(&placed(r));
        let at = body.at_normal(r.array(1.0).into()).unwrap();
        let any: Vector<N> = r.array(1.0).into();
        let along = any - at.inward_normal * at.inward_normal.dot(any);
        let moved = |step: f64| body.nearest(at.point + along * step).boundary.shape_operator;
        let h = 1e-5;
        let difference = (moved(h) - moved(-h)) * (0.5 / h);
        let rate = body.shape_operator_rate(&at, any);
        assert!((rate - difference).max_abs() < 1e-6, "{rate:?} {difference:?}");
    }
}

#[test]
fn curvatures_change_at_their_rates_along_ellipses_and_ellipsoids() {
    let plane = |r: &mut Random| planar::Frame::new(r.array(1.0), r.between(-3.0, 3.0));
    curvatures_change_at_their_rates::<2, 1>(plane, 81);
    let space = |r: &mut Random| spatial::Frame::new(r.array(1.0), r.array(2.0));
    curvatures_change_at_their_rates::<3, 3>(space, 82);
}
