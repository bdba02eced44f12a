//! Deepest pairs against reference cases, supporting planes and sampled directions.

use std::f64::consts::TAU;

use clench_screw::{Frame, Vector, planar, spatial};
use clench_shape::planar::Body as Flat;
use clench_shape::spatial::Body as Solid;
use clench_shape::{
    Ball, BodyError, DeepestPair, Ellipsoid, OverlapError, PointHull, Polygon, Side,
};
use clench_testkit::cases::{Value, array, matching, number};
use clench_testkit::{Random, assert_all_close, assert_close};

use crate::solids::{cuboid, globe, prism, ring, rough_ball, solid};

/// An overlap is a sum of a few terms of the size of the bodies and their distance, and does not
/// change with the normal to first order.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A normal is a quotient of coordinates and radii of curvature, with a condition of up to 100 in
/// these tests.
const NORMAL: f64 = 1e-13;

fn flat_pose(value: &Value, angle: &str, origin: &str) -> planar::Frame {
    planar::Frame::new(array(&value[origin]), number(&value[angle]))
}

fn solid_pose(value: &Value, angle: &str, origin: &str) -> spatial::Frame {
    spatial::Frame::new(array(&value[origin]), array(&value[angle]))
}

#[track_caller]
fn is_reference<const N: usize>(pair: &DeepestPair<N>, output: &Value, name: &str) {
    assert_close(pair.depth, number(&output["delta"]), ROUNDING, 5.0, name);
    let pairs = [(pair.inward_normal, "n"), (pair.on_finger, "a"), (pair.on_part, "b")];
    for (found, key) in pairs {
        let expected: [f64; N] = array(&output[key]);
        let what = format!("{name}: {key}");
        assert_all_close(&found.to_array(), &expected, NORMAL, what);
    }
}

#[test]
fn ellipses_overlap_as_in_the_reference_cases() {
    let mut checked = 0;
    for (name, case) in matching("overlap_planar_") {
        if case["input"]["object"]["type"] != "ellipse" {
            continue;
        }
        let ellipse = |value: &Value| {
            let shape = Ellipsoid::new(Vector::ZERO, array(&value["axes"])).unwrap();
            Flat::Ellipse(shape).placed(&flat_pose(value, "theta", "centre"))
        };
        let finger = ellipse(&case["input"]["finger"]);
        let pose = flat_pose(&case["input"]["frame"], "theta", "d");
        let part = ellipse(&case["input"]["object"]).placed(&pose);
        let pair = clench_shape::planar::deepest_pair(&finger, &part).unwrap();
        is_reference(&pair, &case["output"], &name);
        checked += 1;
    }
    assert!(checked >= 2, "only {checked} cases");
}

#[test]
fn ellipsoids_overlap_as_in_the_reference_cases() {
    for (name, case) in matching("overlap_ellipsoids_") {
        let ellipsoid = |value: &Value| {
            let shape = Ellipsoid::new(Vector::ZERO, array(&value["axes"])).unwrap();
            Solid::Ellipsoid(shape).placed(&solid_pose(value, "theta", "centre"))
        };
        let finger = ellipsoid(&case["input"]["finger"]);
        let pose = solid_pose(&case["input"]["frame"], "theta", "d");
        let part = ellipsoid(&case["input"]["object"]).placed(&pose);
        let pair = clench_shape::spatial::deepest_pair(&finger, &part).unwrap();
        is_reference(&pair, &case["output"], &name);
    }
}

#[test]
fn balls_on_planes_overlap_as_in_the_reference_cases() {
    for (name, case) in matching("overlap_sphere_plane_") {
        let finger = &case["input"]["finger"];
        let ball = Ball::new(array::<3>(&finger["centre"]).into(), number(&finger["radius"]));
        // The half-space z <= 0, as far as it matters.
        let block = cuboid([8.0, 8.0, 4.0]);
        let lowered = Solid::from(solid(&block)).placed(&Frame::at([0.0, 0.0, -4.0].into()));
        let part = lowered.placed(&solid_pose(&case["input"]["frame"], "theta", "d"));
        let finger = Solid::Ball(ball.unwrap());
        let pair = clench_shape::spatial::deepest_pair(&finger, &part).unwrap();
        is_reference(&pair, &case["output"], &name);
    }
}

/// The support function of a convex body.
fn flat_support(body: &Flat, m: Vector<2>) -> f64 {
    match body {
        Flat::Disc(disc) => disc.center().dot(m) + disc.radius() * m.norm(),
        Flat::Ellipse(ellipse) => ellipse.support(m),
        Flat::Hull(hull) => highest(hull.points().iter().copied(), m),
        Flat::Polygon { outline, pose } => {
            highest(outline.corners().iter().map(|&c| pose.point_to_parent(c)), m)
        }
    }
}

fn solid_support(body: &Solid, m: Vector<3>) -> f64 {
    match body {
        Solid::Ball(ball) => ball.center().dot(m) + ball.radius() * m.norm(),
        Solid::Ellipsoid(ellipsoid) => ellipsoid.support(m),
        Solid::Hull(hull) => highest(hull.points().iter().copied(), m),
        Solid::Polyhedron { solid, pose } => {
            highest(solid.vertices().iter().map(|&v| pose.point_to_parent(v)), m)
        }
    }
}

fn highest<const N: usize>(points: impl Iterator<Item = Vector<N>>, m: Vector<N>) -> f64 {
    points.fold(f64::NEG_INFINITY, |high, point| high.max(point.dot(m)))
}

/// What holds for each pair of convex bodies of about the given size near the origin.
///
/// Any normal `m` separates them by the translation `h_A(m) + h_B(-m)`, so the depth is at most
/// that of any direction tried, and it is that of its own normal. For bodies apart the second
/// proves that it is the distance.
#[track_caller]
fn pair_laws<const N: usize>(
    pair: &DeepestPair<N>,
    [finger, part]: [&dyn Fn(Vector<N>) -> f64; 2],
    directions: &[Vector<N>],
    size: f64,
    what: &str,
) {
    let n = pair.inward_normal;
    let tolerance = ROUNDING * 10.0;
    assert_close(n.norm(), 1.0, 8.0 * f64::EPSILON, 1.0, what);
    assert_close(finger(n) + part(-n), pair.depth, tolerance, size, what);
    let offset = (pair.on_finger - pair.on_part - n * pair.depth).norm();
    assert_close(offset, 0.0, 100.0 * tolerance, size, format!("{what}: offset"));
    // Both points are in their bodies: below each supporting plane.
    for &m in directions {
        let separating = finger(m) + part(-m);
        assert!(
            pair.depth <= separating + tolerance * size,
            "{what}: {m:?} gives {separating:e}, {pair:?}"
        );
        assert!(
            pair.on_finger.dot(m) <= finger(m) + 100.0 * tolerance * size,
            "{what}: finger {m:?} {pair:?}"
        );
        assert!(
            pair.on_part.dot(m) <= part(m) + 100.0 * tolerance * size,
            "{what}: part {m:?} {pair:?}"
        );
    }
}

/// Walks downhill from the best of the directions by ever smaller random steps: no normal that it
/// finds separates by less than the depth.
#[track_caller]
fn no_walk_leads_below<const N: usize>(
    r: &mut Random,
    pair: &DeepestPair<N>,
    separating: &dyn Fn(Vector<N>) -> f64,
    directions: &[Vector<N>],
    (size, what): (f64, &str),
) {
    let mut sorted: Vec<(f64, Vector<N>)> =
        directions.iter().map(|&m| (separating(m), m)).collect();
    sorted.sort_by(|x, y| x.0.total_cmp(&y.0));
    for &(start, m) in sorted.iter().step_by(sorted.len() / 40 + 1) {
        let (mut least, mut at, mut reach) = (start, m, 0.3);
        while reach > 1e-7 {
            let tried = at + Vector::new(r.array(reach));
            let tried = tried * (1.0 / tried.norm());
            let next = separating(tried);
            if next < least {
                (least, at) = (next, tried);
            } else {
                reach *= 0.93;
            }
        }
        let tolerance = 10.0 * ROUNDING * size;
        assert!(pair.depth <= least + tolerance, "{what}: {at:?} gives {least:e}, {pair:?}");
    }
}

fn flat_directions(count: usize) -> Vec<Vector<2>> {
    let angles = (0..count).map(|i| TAU * i as f64 / count as f64);
    angles.map(|angle| Vector::new([angle.cos(), angle.sin()])).collect()
}

fn solid_directions(r: &mut Random, count: usize) -> Vec<Vector<3>> {
    let all = (0..count).map(|_| Vector::<3>::new(r.array(1.0)));
    all.map(|v| v * (1.0 / v.norm())).collect()
}

/// Convex bodies of the plane of every kind, about the origin.
fn flat_bodies(r: &mut Random, size: f64) -> Vec<Flat> {
    let points =
        |r: &mut Random, n: usize| -> Vec<[f64; 2]> { (0..n).map(|_| r.array(size)).collect() };
    let outline: Vec<[f64; 2]> = r.convex(7).iter().map(|c| c.map(|x| x * size * 0.5)).collect();
    let axes = [r.between(0.1, 1.5) * size, r.between(0.1, 1.5) * size];
    vec![
        Flat::Disc(Ball::new(Vector::ZERO, r.between(0.1, 1.0) * size).unwrap()),
        Flat::Disc(Ball::new(Vector::ZERO, 0.0).unwrap()),
        Flat::Ellipse(Ellipsoid::new(Vector::ZERO, axes).unwrap()),
        Flat::Hull(PointHull::new(&points(r, 8)).unwrap()),
        Flat::Hull(PointHull::new(&points(r, 2)).unwrap()),
        Flat::Hull(PointHull::new(&points(r, 1)).unwrap()),
        Flat::from(Polygon::new(&outline).unwrap()),
    ]
}

#[test]
fn convex_bodies_of_the_plane_are_separated_by_their_least_translation() {
    let r = &mut Random::new(51);
    let directions = flat_directions(400);
    for round in 0..40 {
        let size = [1e-9, 1.0, 1e9][round % 3];
        let (fingers, parts) = (flat_bodies(r, size), flat_bodies(r, size));
        for (i, finger) in fingers.iter().enumerate() {
            for (j, part) in parts.iter().enumerate() {
                let reach = r.between(0.0, 4.0);
                let angle = r.between(0.0, TAU);
                let origin = [angle.cos(), angle.sin()].map(|x| x * reach * size);
                let finger = finger.placed(&planar::Frame::new(origin, r.between(0.0, TAU)));
                let part = part.placed(&planar::Frame::new([0.0, 0.0], r.between(0.0, TAU)));
                let pair = clench_shape::planar::deepest_pair(&finger, &part).unwrap();
                let a = |m: Vector<2>| flat_support(&finger, m);
                let b = |m: Vector<2>| flat_support(&part, m);
                let what = format!("round {round}: {i} on {j}");
                pair_laws(&pair, [&a, &b], &directions, 4.0 * size, &what);
                let separating = |m| a(m) + b(-m);
                let scale = (4.0 * size, what.as_str());
                no_walk_leads_below(r, &pair, &separating, &directions, scale);
                let back = clench_shape::planar::deepest_pair(&part, &finger).unwrap();
                assert_close(back.depth, pair.depth, 10.0 * ROUNDING, 4.0 * size, &what);
            }
        }
    }
}

/// Convex bodies of space of every kind, about the origin.
fn solid_bodies(r: &mut Random, size: f64) -> Vec<Solid> {
    let points =
        |r: &mut Random, n: usize| -> Vec<[f64; 3]> { (0..n).map(|_| r.array(size)).collect() };
    let axes = std::array::from_fn(|_| r.between(0.2, 1.5) * size);
    let outline: Vec<[f64; 2]> = r.convex(6).iter().map(|c| c.map(|x| x * size * 0.5)).collect();
    vec![
        Solid::Ball(Ball::new(Vector::ZERO, r.between(0.1, 1.0) * size).unwrap()),
        Solid::Ball(Ball::new(Vector::ZERO, 0.0).unwrap()),
        Solid::Ellipsoid(Ellipsoid::new(Vector::ZERO, axes).unwrap()),
        Solid::Hull(PointHull::new(&points(r, 12)).unwrap()),
        Solid::Hull(PointHull::new(&points(r, 3)).unwrap()),
        Solid::Hull(PointHull::new(&points(r, 2)).unwrap()),
        Solid::Hull(PointHull::new(&points(r, 1)).unwrap()),
        Solid::from(solid(&cuboid([size, 0.5 * size, 0.7 * size]))),
        Solid::from(solid(&prism(&outline, 0.5 * size))),
    ]
}

#[test]
fn convex_bodies_of_space_are_separated_by_their_least_translation() {
    let r = &mut Random::new(52);
    let directions = solid_directions(r, 600);
    for round in 0..30 {
        let size = [1e-9, 1.0, 1e9][round % 3];
        let (fingers, parts) = (solid_bodies(r, size), solid_bodies(r, size));
        for (i, finger) in fingers.iter().enumerate() {
            for (j, part) in parts.iter().enumerate() {
                let away = Vector::<3>::new(r.array(1.0));
                let reach = r.between(0.0, 4.0) * size / away.norm();
                let origin = (away * reach).to_array();
                let finger = finger.placed(&spatial::Frame::new(origin, r.array(2.0)));
                let part = part.placed(&spatial::Frame::new([0.0; 3], r.array(2.0)));
                let pair = clench_shape::spatial::deepest_pair(&finger, &part).unwrap();
                let a = |m: Vector<3>| solid_support(&finger, m);
                let b = |m: Vector<3>| solid_support(&part, m);
                let what = format!("round {round}: {i} on {j}");
                pair_laws(&pair, [&a, &b], &directions, 4.0 * size, &what);
                let separating = |m| a(m) + b(-m);
                let scale = (4.0 * size, what.as_str());
                no_walk_leads_below(r, &pair, &separating, &directions, scale);
                let back = clench_shape::spatial::deepest_pair(&part, &finger).unwrap();
                assert_close(back.depth, pair.depth, 10.0 * ROUNDING, 4.0 * size, &what);
            }
        }
    }
}

#[test]
fn a_ball_at_a_hollow_solid_overlaps_the_side_that_it_is_nearest_to() {
    let part = Solid::from(solid(&ring(8)));
    // In the middle of the ring, 2 cos(pi / 8) from its inner sides.
    let inner = 2.0 * (TAU / 16.0).cos();
    let ball = |x: f64, radius: f64| Solid::Ball(Ball::new([x, 0.0, 0.0].into(), radius).unwrap());
    let pair = clench_shape::spatial::deepest_pair(&ball(0.0, 1.0), &part).unwrap();
    assert_close(pair.depth, 1.0 - inner, ROUNDING, 3.0, "apart");
    // Towards the vertex at (2, 0, 0.5), whose edge is convex from the hole: not a side.
    let pair = clench_shape::spatial::deepest_pair(&ball(2.5, 0.25), &part).unwrap();
    let side = 0.25 + 0.5 * (TAU / 16.0).cos();
    assert_close(pair.depth, side.min(0.75), ROUNDING, 3.0, "inside");
    let back = clench_shape::spatial::deepest_pair(&part, &ball(2.5, 0.25)).unwrap();
    assert_eq!(back.inward_normal, -pair.inward_normal);
    assert_eq!((back.on_finger, back.on_part), (pair.on_part, pair.on_finger));
}

#[test]
fn a_disc_at_a_hollow_outline_has_the_overlap_of_its_nearest_edge() {
    // An L, whose hollow corner is at (1, 1).
    let outline = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
    let part = Flat::from(Polygon::new(&outline).unwrap());
    let at = |center: [f64; 2]| {
        let disc = Flat::Disc(Ball::new(center.into(), 0.5).unwrap());
        clench_shape::planar::deepest_pair(&disc, &part).unwrap()
    };
    let pair = at([2.0, 1.25]);
    assert_eq!((pair.depth, pair.inward_normal.to_array()), (0.25, [0.0, -1.0]));
    assert_eq!((pair.on_finger.to_array(), pair.on_part.to_array()), ([2.0, 0.75], [2.0, 1.0]));
    // Inside, the nearest way out; at the corner (3, 1), along the line to it.
    assert_eq!((at([2.0, 0.75]).depth, at([2.0, 0.75]).inward_normal[1]), (0.75, -1.0));
    let corner = at([3.3, 1.4]);
    assert_close(corner.depth, 0.0, ROUNDING, 3.0, "corner");
    assert_all_close(&corner.inward_normal.to_array(), &[-0.6, -0.8], ROUNDING, "normal");
    // With its center on the corner, the mean of the two normals.
    let diagonal = 0.5_f64.sqrt();
    let on = at([3.0, 1.0]);
    assert_eq!(on.depth, 0.5);
    assert_all_close(&on.inward_normal.to_array(), &[-diagonal, -diagonal], ROUNDING, "corner");
}

#[test]
fn bodies_that_just_touch_or_share_a_center_have_a_normal() {
    let square = |x: f64| {
        let corners = [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
        Flat::from(Polygon::new(&corners).unwrap())
    };
    let pair = clench_shape::planar::deepest_pair(&square(0.0), &square(1.0)).unwrap();
    assert_eq!((pair.depth, pair.inward_normal.to_array()), (0.0, [1.0, 0.0]));
    let cube =
        |x: f64| Solid::from(solid(&cuboid([1.0; 3]))).placed(&Frame::at([x, 0.25, 0.0].into()));
    for gap in [0.0, 0.5, -0.5] {
        let pair = clench_shape::spatial::deepest_pair(&cube(0.0), &cube(2.0 + gap)).unwrap();
        assert_close(pair.depth, -gap, ROUNDING, 2.0, "cubes");
        assert_all_close(&pair.inward_normal.to_array(), &[1.0, 0.0, 0.0], NORMAL, "cubes");
    }
    let ball = |radius: f64| Solid::Ball(Ball::new([1.0; 3].into(), radius).unwrap());
    let pair = clench_shape::spatial::deepest_pair(&ball(2.0), &ball(1.0)).unwrap();
    assert_eq!((pair.depth, pair.inward_normal.norm()), (3.0, 1.0));
    let round = Ellipsoid::new([1.0; 3].into(), [3.0, 1.0, 2.0]).unwrap();
    let pair = clench_shape::spatial::deepest_pair(&ball(0.5), &Solid::Ellipsoid(round)).unwrap();
    assert_eq!((pair.depth, pair.inward_normal[1].abs()), (1.5, 1.0));
    let other = Solid::Ellipsoid(round);
    let pair = clench_shape::spatial::deepest_pair(&other, &other).unwrap();
    assert_close(pair.depth, 2.0, ROUNDING, 6.0, "the same ellipsoid");
}

#[test]
fn thin_and_unequal_ellipsoids_keep_their_digits() {
    let r = &mut Random::new(53);
    let directions = solid_directions(r, 400);
    for _ in 0..200 {
        let mut body = |reach: f64| {
            let axes = std::array::from_fn(|_| 10_f64.powf(r.between(-3.0, 0.0)));
            let pose = spatial::Frame::new(r.array(reach), r.array(2.0));
            Solid::Ellipsoid(Ellipsoid::new(Vector::ZERO, axes).unwrap()).placed(&pose)
        };
        let (finger, part) = (body(1.0), body(0.0));
        let pair = clench_shape::spatial::deepest_pair(&finger, &part).unwrap();
        let a = |m: Vector<3>| solid_support(&finger, m);
        let b = |m: Vector<3>| solid_support(&part, m);
        pair_laws(&pair, [&a, &b], &directions, 4.0, "thin");
    }
}

#[test]
fn a_hull_of_many_points_touches_like_the_mesh_that_it_is() {
    let r = &mut Random::new(54);
    // Radii so alike that the mesh is convex: the sagitta of a triangle is near 0.03.
    let mesh = rough_ball(r, 2, 1.001);
    let points: Vec<[f64; 3]> = mesh.concat();
    let hull = Solid::Hull(PointHull::new(&points).unwrap());
    let part = Solid::from(clench_shape::Polyhedron::from_triangles(&mesh).unwrap());
    let far = Frame::at([0.5, 1.5, 0.25].into());
    let finger = Solid::from(solid(&cuboid([0.5, 0.25, 0.75]))).placed(&far);
    let (one, other) = (
        clench_shape::spatial::deepest_pair(&finger, &hull).unwrap(),
        clench_shape::spatial::deepest_pair(&finger, &part).unwrap(),
    );
    assert_close(one.depth, other.depth, ROUNDING, 2.0, "depth");
    let ball = Solid::Ball(Ball::new([0.0, 1.25, 0.5].into(), 0.75).unwrap());
    let (one, other) = (
        clench_shape::spatial::deepest_pair(&ball, &hull).unwrap(),
        clench_shape::spatial::deepest_pair(&ball, &part).unwrap(),
    );
    assert_close(one.depth, other.depth, ROUNDING, 2.0, "ball");
    assert_all_close(&one.on_part.to_array(), &other.on_part.to_array(), NORMAL, "ball");
}

#[test]
fn a_mesh_of_a_hundred_thousand_triangles_overlaps_like_the_ellipsoid_that_it_is() {
    let (n, axes, smaller) = (224, [1.0, 1.25, 0.75], [0.5, 0.25, 0.375]);
    let mesh =
        |axes| Solid::from(clench_shape::Polyhedron::from_triangles(&globe(n, axes)).unwrap());
    let round = |axes| Solid::Ellipsoid(Ellipsoid::new(Vector::ZERO, axes).unwrap());
    let (part, smooth) = (mesh(axes), round(axes));
    let cube = PointHull::new(&cuboid([0.5, 0.25, 0.75]).0).unwrap();
    let fingers = [
        [round(smaller), round(smaller)],
        [Solid::Hull(cube.clone()), Solid::Hull(cube)],
        [mesh(smaller), round(smaller)],
    ];
    // Between its meridians and its steps a mesh is inside the ball that it is stretched from by
    // the sagitta of an arc of 1 / n turns and one of half of that, for both bodies.
    let arc = TAU / n as f64;
    let sagitta = 1.25 * (arc * arc / 8.0 + arc * arc / 32.0) * 2.0;
    let r = &mut Random::new(57);
    for round in 0..8 {
        let origin = Vector::<3>::new(r.array(1.0));
        let reach = r.between(1.0, 3.0) / origin.norm();
        let pose = spatial::Frame::new((origin * reach).to_array(), r.array(2.0));
        for [finger, shape] in &fingers {
            let (finger, shape) = (finger.placed(&pose), shape.placed(&pose));
            let pair = clench_shape::spatial::deepest_pair(&finger, &part).unwrap();
            let limit = clench_shape::spatial::deepest_pair(&shape, &smooth).unwrap();
            let inside = limit.depth - pair.depth;
            assert!((-ROUNDING..=sagitta).contains(&inside), "{round}: {inside:e} of {sagitta:e}");
            let a = |m: Vector<3>| solid_support(&finger, m);
            let b = |m: Vector<3>| solid_support(&part, m);
            pair_laws(&pair, [&a, &b], &solid_directions(r, 20), 4.0, &format!("{round}"));
        }
    }
}

#[test]
fn hollow_bodies_without_a_ball_are_refused() {
    let outline = [[0.0, 0.0], [3.0, 0.0], [1.0, 1.0], [0.0, 3.0]];
    let hollow = Flat::from(Polygon::new(&outline).unwrap());
    let ellipse = Flat::Ellipse(Ellipsoid::new(Vector::ZERO, [2.0, 1.0]).unwrap());
    let refused = |side| Err(OverlapError::NotConvex { side });
    let found = clench_shape::planar::deepest_pair(&ellipse, &hollow);
    assert_eq!(found, refused(Side::Part));
    assert_eq!(clench_shape::planar::deepest_pair(&hollow, &ellipse), refused(Side::Finger));
    let message = found.unwrap_err().to_string();
    assert!(message.starts_with("the part is not convex and the other body"), "{message}");

    let cube = Solid::from(solid(&cuboid([1.0; 3])));
    let ring = Solid::from(solid(&ring(5)));
    assert_eq!(
        clench_shape::spatial::deepest_pair(&cube, &ring),
        Err(OverlapError::NotConvex { side: Side::Part })
    );
    // Two cubes in one solid are each convex, but not together.
    let (mut vertices, mut faces) = cuboid([1.0; 3]);
    vertices.extend(cuboid([1.0; 3]).0.iter().map(|&[x, y, z]| [x + 4.0, y, z]));
    faces.extend(cuboid([1.0; 3]).1.iter().map(|f| f.iter().map(|&c| c + 8).collect::<Vec<_>>()));
    let pair = solid(&(vertices, faces));
    assert!(!pair.is_convex() && solid(&cuboid([1.0; 3])).is_convex());
    assert_eq!(
        clench_shape::spatial::deepest_pair(&cube, &pair.into()),
        Err(OverlapError::NotConvex { side: Side::Part })
    );
}

#[test]
fn numbers_that_are_no_ball_and_no_hull_are_refused() {
    let fault = BodyError::RadiusOutOfRange { radius: -1.0 };
    assert_eq!(Ball::new(Vector::<2>::ZERO, -1.0), Err(fault));
    let fault = BodyError::PointOutOfRange { point: 0, component: 1, value: f64::INFINITY };
    assert_eq!(Ball::new([0.0, f64::INFINITY].into(), 1.0), Err(fault));
    assert_eq!(PointHull::<3>::new(&[]), Err(BodyError::NoPoints));
    let fault = BodyError::PointOutOfRange { point: 1, component: 0, value: -1e200 };
    assert_eq!(PointHull::new(&[[0.0, 0.0], [-1e200, 0.0]]), Err(fault));
    let fault = PointHull::new(&[[0.0, f64::NAN]]).unwrap_err().to_string();
    assert!(fault.starts_with("component 1 of point 0 is NaN, but has to be"), "{fault}");
}
