//! How far bodies reach: hulls, farthest points and fastest points, against looking at all.

use clench_screw::{Mat, Twist, Vector};
use clench_shape::{BodyError, Ellipsoid, Extent, ExtremePoints, Polygon, Polyhedron};
use clench_testkit::{Random, assert_all_close, assert_close};

/// Points of several kinds that hulls get wrong: in general position, on a sphere, on a grid with
/// many in one plane and many equal, on a cylinder, in a thin plate, on a needle, far away.
fn clouds(count: usize, r: &mut Random) -> Vec<Vec<Vector<3>>> {
    let turn = Mat::<3, 3>::new([r.array(1.0), r.array(1.0), r.array(1.0)]);
    let mut cloud = |point: &mut dyn FnMut(&mut Random, usize) -> Vector<3>| {
        (0..count).map(|i| point(r, i)).collect::<Vec<_>>()
    };
    vec![
        cloud(&mut |r, _| r.array(1.0).into()),
        cloud(&mut |r, _| Vector::<3>::from(r.array(1.0)).direction().unwrap()),
        cloud(&mut |r, _| r.array::<3>(2.0).map(f64::round).into()),
        cloud(&mut |r, _| turn * Vector::new(r.array(2.0).map(f64::round))),
        cloud(&mut |_, i| {
            let angle = std::f64::consts::TAU * (i / 2) as f64 / (count / 2).max(1) as f64;
            turn * Vector::new([angle.cos(), angle.sin(), (i % 2) as f64])
        }),
        cloud(&mut |r, _| {
            let [x, y, z] = r.array(1.0);
            turn * Vector::new([100.0 * x, 100.0 * y, 1e-6 * z.signum()])
        }),
        cloud(&mut |r, _| {
            let [x, y, z] = r.array(1.0);
            turn * Vector::new([1e6 * x, y, z])
        }),
        cloud(&mut |r, _| Vector::from(r.array(1.0)) + Vector::new([1e6, -1e6, 0.0])),
        cloud(&mut |r, _| Vector::from(r.array(1.0)) * 1e-90),
    ]
}

#[test]
fn extremes_have_the_support_of_all_points_in_every_direction_to_the_last_bit() {
    let r = &mut Random::new(71);
    for count in [1, 2, 3, 4, 5, 8, 20, 100, 1000] {
        for _ in 0..4 {
            for cloud in clouds(count, r) {
                let points: Vec<[f64; 3]> = cloud.iter().map(|p| p.to_array()).collect();
                let extremes = ExtremePoints::new(&points).unwrap();
                for _ in 0..100 {
                    let along: Vector<3> = r.array(1.0).into();
                    let support = |points: &[Vector<3>]| {
                        points.iter().map(|p| p.dot(along)).fold(f64::NEG_INFINITY, f64::max)
                    };
                    assert_eq!(support(extremes.points()), support(&cloud));
                }
                for (point, &number) in extremes.points().iter().zip(extremes.numbers()) {
                    assert_eq!(*point, cloud[number]);
                }
            }
        }
    }
}

/// A cube with points in the middle of each face, of each edge and of itself, each of them twice.
#[test]
fn only_corners_of_the_hull_are_extreme() {
    let step = |i: usize| i as f64 - 1.0;
    let corner = |i: usize| [step(i % 3), step(i / 3 % 3), step(i / 9 % 3)];
    let points: Vec<[f64; 3]> = (0..54).map(corner).collect();
    let extremes = ExtremePoints::new(&points).unwrap();
    assert_eq!(extremes.points().len(), 8);
    assert!(extremes.points().iter().all(|p| p.to_array().iter().all(|x| x.abs() == 1.0)));
    // In the plane the same, and points of a line have two ends.
    let square: Vec<[f64; 2]> = (0..18).map(|i| [step(i % 3), step(i / 3 % 3)]).collect();
    assert_eq!(ExtremePoints::new(&square).unwrap().points().len(), 4);
    let line = [[1.0, 1.0], [3.0, 3.0], [2.0, 2.0]];
    let mut ends = ExtremePoints::new(&line).unwrap().numbers().to_vec();
    ends.sort_unstable();
    assert_eq!(ends, [0, 1]);
    assert_eq!(ExtremePoints::new(&[[5.0, 5.0]]).unwrap().numbers(), [0]);
    assert_eq!(
        ExtremePoints::new(&[[3.0, 4.0], [3.0, 4.0]])
            .unwrap()
            .farthest_by(1.0, |p, _| p.norm_squared())
            .value,
        5.0
    );
}

/// A solid reaches no farther than its vertices that faces use.
#[test]
fn vertices_that_no_face_uses_are_not_extreme() {
    let vertices = [[9.0; 3], [0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]];
    let faces = [vec![1, 3, 2], vec![1, 2, 4], vec![1, 4, 3], vec![2, 3, 4]];
    let solid = Polyhedron::new(&vertices, &faces).unwrap();
    let found = Extent::from(&solid).farthest(Vector::ZERO);
    assert_eq!((found.corner, found.value), (Some(4), 3.0));
}

/// The fastest of all points, by looking at all.
fn fastest<const N: usize, const M: usize>(
    points: &[Vector<N>],
    origin: Vector<N>,
    twist: &Twist<N, M>,
) -> f64 {
    points.iter().map(|&p| twist.velocity_at(p - origin).norm()).fold(0.0, f64::max)
}

fn the_tree_finds_the_fastest_point<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for count in [1, 2, 16, 17, 40, 300, 5000] {
        for flatness in [1.0, 0.01] {
            let points: Vec<[f64; N]> = (0..count)
                .map(|_| {
                    let mut point = r.array::<N>(1.0);
                    point[0] *= flatness;
                    point
                })
                .collect();
            let extremes = ExtremePoints::new(&points).unwrap();
            let points: Vec<Vector<N>> = points.into_iter().map(Vector::from).collect();
            for _ in 0..40 {
                let twist =
                    Twist::<N, M> { linear: r.array(1.0).into(), angular: r.array(1.0).into() };
                let origin: Vector<N> = r.array(1.0).into();
                let found = Extent::from(&extremes).fastest(origin, &twist);
                let wanted = fastest(&points, origin, &twist);
                assert_close(found.value, wanted, 1e-15, wanted, "speed");
                let corner = found.corner.unwrap();
                assert_eq!(points[corner], found.point);
                let speed = twist.velocity_at(found.point - origin).norm();
                assert_close(speed, wanted, 1e-15, wanted, "speed there");
            }
        }
    }
}

#[test]
fn the_tree_finds_the_fastest_point_in_the_plane_and_in_space() {
    the_tree_finds_the_fastest_point::<2, 1>(72);
    the_tree_finds_the_fastest_point::<3, 3>(73);
}

#[test]
fn a_polygon_reaches_as_far_by_its_extremes_as_by_its_regions() {
    let r = &mut Random::new(74);
    for corners in [3, 8, 60] {
        let outline = Polygon::new(&r.star(corners)).unwrap();
        for _ in 0..100 {
            let point: Vector<2> = r.array(3.0).into();
            let (tree, regions) = (Extent::from(&outline).farthest(point), outline.farthest(point));
            assert_close(tree.value, regions.distance, 1e-15, tree.value, "reach");
        }
    }
}

/// No point of a fine net of the boundary is farther, and the best of the net comes close.
fn an_ellipsoid_reaches_as_far_as_its_points<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for round in 0..60 {
        let axes = r.array::<N>(1.0).map(|x| 0.3 + x.abs());
        let center: Vector<N> = r.array(1.0).into();
        let body = Ellipsoid::new(center, axes).unwrap();
        let origin: Vector<N> = if round % 3 == 0 { center } else { r.array(2.0).into() };
        let mut twist = Twist::<N, M> { linear: r.array(1.0).into(), angular: r.array(1.0).into() };
        if round % 2 == 0 {
            twist.linear = Vector::ZERO;
        }
        let found = Extent::from(&body).fastest(origin, &twist);
        let speed = |p: Vector<N>| twist.velocity_at(p - origin).norm();
        assert_close(speed(found.point), found.value, 1e-14, found.value, "speed there");
        let scaled = Vector::<N>::from_fn(|i| (found.point - center)[i] / axes[i]);
        assert_close(scaled.norm(), 1.0, 1e-14, 1.0, "on the boundary");
        let mut best = 0.0_f64;
        for _ in 0..3000 {
            let unit = Vector::<N>::from(r.array(1.0)).direction().unwrap();
            best = best.max(speed(center + Vector::from_fn(|i| axes[i] * unit[i])));
        }
        assert!(best <= found.value * (1.0 + 1e-14), "{best} {}", found.value);
        // A net of 3000 points of a sphere leaves gaps of about 0.1, which cost their square.
        assert!(best >= found.value * 0.95, "{best} {}", found.value);
    }
}

#[test]
fn an_ellipsoid_reaches_as_far_as_its_points_in_the_plane_and_in_space() {
    an_ellipsoid_reaches_as_far_as_its_points::<2, 1>(75);
    an_ellipsoid_reaches_as_far_as_its_points::<3, 3>(76);
}

#[test]
fn the_hard_case_of_an_ellipse_has_two_farthest_points() {
    // From (0, d) the squared distance of (2 cos t, sin t) is 4 - 3 y^2 - 2 y d + d^2 with
    // y = sin t, largest at y = -d / 3.
    let ellipse = Ellipsoid::new([0.0, 0.0].into(), [2.0, 1.0]).unwrap();
    for d in [0.0, 1e-12, 0.3, 1.0, 2.9] {
        let found = Extent::from(&ellipse).farthest([0.0, d].into());
        let wanted = (4.0 + 4.0 * d * d / 3.0_f64).sqrt();
        assert_close(found.value, wanted, 1e-15, wanted, format!("from {d}"));
        let y = -d / 3.0;
        let foot = [2.0 * (1.0 - y * y).sqrt(), y];
        assert_all_close(&found.point.to_array().map(f64::abs), &foot.map(f64::abs), 1e-14, "foot");
    }
    // Beyond the center of curvature of the lower end that end is farthest.
    let found = Extent::from(&ellipse).farthest([0.0, 4.0].into());
    assert_eq!((found.point.to_array(), found.value), ([0.0, -1.0], 5.0));
}

#[test]
fn a_ball_reaches_its_radius_beyond_the_distance() {
    let ball = Ellipsoid::new([1.0, 2.0, 3.0].into(), [2.0; 3]).unwrap();
    let found = Extent::from(&ball).farthest([1.0, 2.0, -1.0].into());
    assert_eq!((found.value, found.point.to_array()), (6.0, [1.0, 2.0, 5.0]));
    assert_eq!(Extent::from(&ball).farthest(ball.center()).value, 2.0);
    // A turn about an axis through the center: the equator, with a pitch.
    let twist = Twist { linear: [0.0, 0.0, 1.5].into(), angular: [0.0, 0.0, 1.0].into() };
    assert_eq!(Extent::from(&ball).fastest(ball.center(), &twist).value, 2.5);
}

#[test]
fn extremes_of_no_points_or_of_infinite_ones_are_refused() {
    assert_eq!(ExtremePoints::<3>::new(&[]), Err(BodyError::NoPoints));
    let fault = ExtremePoints::new(&[[0.0, 1.0], [f64::NAN, 0.0]]);
    assert!(matches!(fault, Err(BodyError::PointOutOfRange { point: 1, component: 0, .. })));
}

/// A prism of many corners: its two faces are hulled without looking at them again and again, and
/// coordinates far below the largest do not confuse the signs of volumes.
#[test]
fn faces_of_many_corners_and_coordinates_of_unlike_size_have_their_hull() {
    let ring = |i: usize| std::f64::consts::TAU * (i / 2) as f64 / 2000.0;
    let prism: Vec<[f64; 3]> =
        (0..4000).map(|i| [ring(i).cos(), ring(i).sin(), (i % 2) as f64]).collect();
    assert_eq!(ExtremePoints::new(&prism).unwrap().points().len(), 4000);

    let values = [0.0, 1.0, 2.0, 1e-20, 1e-55, 1e-89, 1e-91, 1e-110];
    let r = &mut Random::new(77);
    for _ in 0..3000 {
        let cloud: Vec<[f64; 3]> = (0..11).map(|_| [0, 1, 2].map(|_| values[r.below(8)])).collect();
        let extremes = ExtremePoints::new(&cloud).unwrap();
        for axis in 0..3 {
            let largest = |points: &mut dyn Iterator<Item = f64>| points.fold(0.0, f64::max);
            let found = largest(&mut extremes.points().iter().map(|p| p[axis]));
            assert!((found - largest(&mut cloud.iter().map(|p| p[axis]))).abs() < 1e-89);
        }
    }
    // In the plane below what squares can say.
    let s = 1e-125;
    let square = [[0.0, 0.0], [s, 0.0], [0.0, s], [s, s], [2.0 * s, 0.5 * s]];
    assert_eq!(ExtremePoints::new(&square).unwrap().points().len(), 5);
}

/// Faces full of points in one plane, exactly: the support in every direction of whole numbers.
#[test]
fn lattice_clouds_have_their_support_exactly() {
    let r = &mut Random::new(78);
    let steps = [-2.0, -1.0, 0.0, 1.0, 2.0];
    for _ in 0..2000 {
        let (count, size) = (4 + r.below(30), 2 + r.below(3));
        let cloud: Vec<[f64; 3]> =
            (0..count).map(|_| [0, 1, 2].map(|_| r.below(size) as f64)).collect();
        let extremes = ExtremePoints::new(&cloud).unwrap();
        for i in 0..125 {
            let along = Vector::new([steps[i % 5], steps[i / 5 % 5], steps[i / 25]]);
            let all = cloud.iter().map(|&p| along.dot(p.into())).fold(f64::MIN, f64::max);
            let found = extremes.points().iter().map(|p| along.dot(*p)).fold(f64::MIN, f64::max);
            assert_eq!(found, all, "{cloud:?}");
        }
    }
}

/// A component of the gradient that is no normal number.
#[test]
fn an_offset_of_a_denormal_length_does_not_matter() {
    let body = Ellipsoid::new(Vector::ZERO, [2.0, 1.0, 1.0]).unwrap();
    let offset = Vector::new([1e-310, 1.5, 0.0]);
    let found = Extent::from(&body).farthest_image(Vector::ZERO, offset, &Mat::IDENTITY);
    let wanted = Extent::from(&body).farthest([0.0, -1.5, 0.0].into());
    assert_close(found.value, wanted.value, 1e-14, wanted.value, "farthest");
}
