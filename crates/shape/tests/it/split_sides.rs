//! Deepest pairs of bodies of the plane whose straight sides rounding has split.

use std::f64::consts::TAU;

use clench_screw::{Vector, planar};
use clench_shape::planar::{Body, deepest_pair};
use clench_shape::{Ball, DeepestPair, Ellipsoid, PointHull};
use clench_testkit::{Random, assert_all_close, assert_close};

/// Points turned by a pose are rounded once, feet are mixed from two of them, and a depth is a
/// product of a normal and a point: a few roundings of coordinates up to the size.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

fn hull(points: &[[f64; 2]]) -> Body {
    Body::Hull(PointHull::new(points).unwrap())
}

/// The square from (0, 0) to (2, 2), with a point in the middle of its lower side.
fn square() -> Body {
    hull(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])
}

fn turned(angle: f64) -> planar::Frame {
    planar::Frame::new([0.0, 0.0], angle)
}

/// How far `point` is outside the hull of `points`: from the normals of all lines through two of
/// them, among which are those of all its sides.
fn outside(points: &[Vector<2>], point: Vector<2>) -> f64 {
    let mut farthest = f64::NEG_INFINITY;
    for &p in points {
        for &q in points {
            let Some(across) = planar::quarter_turn(q - p).direction() else { continue };
            let high = points.iter().fold(f64::NEG_INFINITY, |h, v| h.max((*v - p).dot(across)));
            farthest = farthest.max((point - p).dot(across) - high);
        }
    }
    farthest
}

/// The points of a pair belong together, and each belongs to its body.
#[track_caller]
fn belong(pair: &DeepestPair<2>, bodies: [&[Vector<2>]; 2], size: f64, what: &str) {
    let offset = pair.on_finger - pair.on_part - pair.inward_normal * pair.depth;
    assert_close(offset.norm(), 0.0, ROUNDING, size, format!("{what}: offset of {pair:?}"));
    for (points, on) in bodies.into_iter().zip([pair.on_finger, pair.on_part]) {
        if points.len() > 2 {
            let beyond = outside(points, on);
            assert!(beyond <= ROUNDING * size, "{what}: {on:?} is {beyond:e} outside");
        }
    }
}

fn points(body: &Body) -> &[Vector<2>] {
    let Body::Hull(hull) = body else { panic!("{body:?} is no hull") };
    hull.points()
}

#[test]
fn a_point_at_a_split_side_is_opposite_its_own_foot_at_any_angle() {
    // Inside, on the side, and outside of it.
    for (height, depth) in [(0.2, 0.2), (0.0, 0.0), (-0.2, -0.2)] {
        for x in [0.3, 1.0, 1.7] {
            let finger = hull(&[[x, height]]);
            for i in 0..2000 {
                let pose = turned(0.007 + TAU * f64::from(i) / 2000.0);
                let (finger, part) = (finger.placed(&pose), square().placed(&pose));
                let pair = deepest_pair(&finger, &part).unwrap();
                let what = format!("({x}, {height}) at angle {i}");
                assert_close(pair.depth, depth, ROUNDING, 2.0, &what);
                belong(&pair, [points(&finger), points(&part)], 2.0, &what);
                let on_part = pose.point_in_frame(pair.on_part).to_array();
                assert_all_close(&on_part, &[x, 0.0], ROUNDING, &what);
            }
        }
    }
}

#[test]
fn a_point_on_the_line_of_a_segment_is_beyond_its_end() {
    let segment = hull(&[[0.0, 0.0], [1.0, 0.0]]);
    for i in 0..2000 {
        let pose = turned(TAU * f64::from(i) / 2000.0);
        let what = format!("angle {i}");
        let part = segment.placed(&pose);
        for (x, depth, end) in [(3.0, -2.0, 1.0), (-0.5, -0.5, 0.0), (0.25, 0.0, 0.25)] {
            let finger = hull(&[[x, 0.0]]).placed(&pose);
            let pair = deepest_pair(&finger, &part).unwrap();
            assert_close(pair.depth, depth, ROUNDING, 3.0, &what);
            belong(&pair, [points(&finger), points(&part)], 3.0, &what);
            let on_part = pose.point_in_frame(pair.on_part);
            assert_close((on_part - [end, 0.0].into()).norm(), 0.0, ROUNDING, 3.0, &what);
        }
        // Two segments of one line that share a piece touch; moved apart along it they do not.
        let other = hull(&[[0.5, 0.0], [4.0, 0.0]]).placed(&pose);
        let pair = deepest_pair(&other, &part).unwrap();
        assert_close(pair.depth, 0.0, ROUNDING, 4.0, &what);
        belong(&pair, [points(&other), points(&part)], 4.0, &what);
        let other = hull(&[[1.5, 0.0], [4.0, 0.0]]).placed(&pose);
        let pair = deepest_pair(&other, &part).unwrap();
        assert_close(pair.depth, -0.5, ROUNDING, 4.0, &what);
        belong(&pair, [points(&other), points(&part)], 4.0, &what);
    }
}

/// A convex polygon with up to three more points on each of its sides.
fn with_points_on_sides(r: &mut Random, size: f64) -> Vec<[f64; 2]> {
    let count = 3 + r.below(5);
    let corners: Vec<Vector<2>> =
        r.convex(count).into_iter().map(|c| Vector::new(c) * (size / 3.0)).collect();
    let mut points = Vec::new();
    for (i, &from) in corners.iter().enumerate() {
        let side = corners[(i + 1) % count] - from;
        points.push(from.to_array());
        points.extend((0..r.below(4)).map(|_| (from + side * r.between(0.0, 1.0)).to_array()));
    }
    points
}

#[test]
fn hulls_with_points_on_their_sides_touch_where_they_are() {
    let r = &mut Random::new(55);
    for round in 0..4000 {
        let size = [1e-9, 1.0, 1e9][round % 3];
        let (one, other) = (with_points_on_sides(r, size), with_points_on_sides(r, size));
        let few = 1 + r.below(2);
        let one = if round % 4 == 0 { &one[..few] } else { &one[..] };
        let away = r.between(0.0, 2.5) * size;
        let pose = planar::Frame::new([away, 0.0], r.between(0.0, TAU));
        let both = turned(r.between(0.0, TAU));
        let (finger, part) = (hull(one).placed(&(both * pose)), hull(&other).placed(&both));
        let pair = deepest_pair(&finger, &part).unwrap();
        let what = format!("round {round}");
        belong(&pair, [points(&finger), points(&part)], 8.0 * size, &what);
        let back = deepest_pair(&part, &finger).unwrap();
        assert_close(back.depth, pair.depth, ROUNDING, 8.0 * size, &what);
        let axes = [r.between(0.1, 1.0) * size, r.between(0.1, 1.0) * size];
        let ellipse = Ellipsoid::new([0.0, 0.0].into(), axes).unwrap();
        let pair = deepest_pair(&Body::Ellipse(ellipse).placed(&(both * pose)), &part).unwrap();
        let what = format!("{what}, ellipse");
        let offset = pair.on_finger - pair.on_part - pair.inward_normal * pair.depth;
        assert_close(offset.norm(), 0.0, ROUNDING, 8.0 * size, &what);
        let beyond = outside(points(&part), pair.on_part);
        assert!(beyond <= ROUNDING * 8.0 * size, "{what}: {pair:?} is {beyond:e} outside");
    }
}

#[test]
fn equal_sides_that_lie_flat_on_each_other_touch_within_both() {
    let r = &mut Random::new(56);
    for round in 0..4000 {
        // A side of each along the x axis, split anywhere; the finger below the part.
        let (from, to) = (r.between(-2.0, 0.0), r.between(0.3, 2.0));
        let split = |r: &mut Random, y: f64| -> Vec<[f64; 2]> {
            let middle = (0..4).map(|_| [r.between(from, to), y]).collect::<Vec<_>>();
            [vec![[from, y], [to, y]], middle].concat()
        };
        let gap = [0.0, 0.25, -0.25, 1e-12, -1e-12][round % 5];
        let mut part = split(r, 0.0);
        part.extend([[from, 2.0], [to, 2.0]]);
        let mut finger = split(r, -gap);
        finger.extend([[from, -2.0], [to, -2.0]]);
        let pose = planar::Frame::new(r.array(1.0), r.between(0.0, TAU));
        let (finger, part) = (hull(&finger).placed(&pose), hull(&part).placed(&pose));
        let pair = deepest_pair(&finger, &part).unwrap();
        let what = format!("round {round}, gap {gap}");
        assert_close(pair.depth, -gap, ROUNDING, 4.0, &what);
        belong(&pair, [points(&finger), points(&part)], 4.0, &what);
        // Sides of 0.3 and more, of points rounded at 4.
        let normal = pose.direction_in_frame(pair.inward_normal).to_array();
        assert_all_close(&normal, &[0.0, 1.0], 40.0 * ROUNDING, &what);
    }
}

#[test]
fn discs_and_ellipses_touch_a_split_side_at_their_own_foot() {
    let disc = Body::Disc(Ball::new([1.7, 0.0].into(), 0.2).unwrap());
    let ellipse = Body::Ellipse(Ellipsoid::new([1.7, 0.0].into(), [0.1, 0.2]).unwrap());
    for (k, finger) in [disc, ellipse].into_iter().enumerate() {
        for i in 0..2000 {
            let pose = turned(0.007 + TAU * f64::from(i) / 2000.0);
            let (finger, part) = (finger.placed(&pose), square().placed(&pose));
            for exchanged in [false, true] {
                let what = format!("{k} at angle {i}, {exchanged}");
                let pair = if exchanged {
                    deepest_pair(&part, &finger).unwrap()
                } else {
                    deepest_pair(&finger, &part).unwrap()
                };
                assert_close(pair.depth, 0.2, ROUNDING, 2.0, &what);
                let [on_finger, on_part] = if exchanged {
                    [pair.on_part, pair.on_finger]
                } else {
                    [pair.on_finger, pair.on_part]
                };
                let found = pose.point_in_frame(on_part).to_array();
                assert_all_close(&found, &[1.7, 0.0], ROUNDING, format!("{what}: part"));
                let found = pose.point_in_frame(on_finger).to_array();
                assert_all_close(&found, &[1.7, 0.2], ROUNDING, format!("{what}: finger"));
            }
        }
    }
}
