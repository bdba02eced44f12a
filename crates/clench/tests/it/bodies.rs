//! Grasps given by the poses of bodies instead of contact points: stiffness against the energy of
//! the overlaps that are measured between the bodies as they move.

use clench::contact::{Contact, Curvature, Geometry, Law, Order};
use clench::screw::{Frame, Stiffness, Vector, planar, spatial};
use clench::shape::planar::{Body as Region, deepest_pair as deepest_in_plane};
use clench::shape::spatial::{Body as Solid, deepest_pair as deepest_in_space};
use clench::shape::{Ball, DeepestPair, Ellipsoid, Polyhedron};
use clench::stiffness::Grasp;
use clench_testkit::{Random, assert_close};

/// The boundary's curvature at the deepest point of an ellipsoid.
fn curvature<const N: usize>(body: &Ellipsoid<N>, outward: Vector<N>) -> Curvature<N> {
    Curvature::of_shape_operator(body.at_normal(outward).unwrap().shape_operator)
}

/// The contact of a pair of bodies, whose curvatures there are known.
fn contact<const N: usize, const M: usize>(
    pair: &DeepestPair<N>,
    finger: Curvature<N>,
    part: Curvature<N>,
) -> Contact<N, M> {
    let (point, inward_normal) = (pair.on_part, pair.inward_normal);
    let place = Geometry { point, inward_normal, finger, part };
    Contact::overlapping(place, Law::power(10.0, 1.5).unwrap(), pair.depth).unwrap()
}

/// Central differences of the energy; they err by h^2 times fourth derivatives and by the error of
/// the depths over h^2.
fn check<const N: usize, const M: usize>(
    stiffness: &Stiffness<N, M>,
    energy: impl Fn(&[f64]) -> f64,
) {
    let h = 1e-3;
    let mixed = |i: usize, j: usize| {
        let at = |s: f64, t: f64| {
            let mut q = vec![0.0; N + M];
            q[i] += s * h;
            q[j] += t * h;
            energy(&q)
        };
        (at(1.0, 1.0) - at(1.0, -1.0) - at(-1.0, 1.0) + at(-1.0, -1.0)) / (4.0 * h * h)
    };
    let scale = stiffness.translational.max_abs().max(stiffness.rotational.max_abs());
    for i in 0..N + M {
        for j in 0..N + M {
            let what = format!("energy ({i}, {j})");
            assert_close(stiffness.entry(i, j), mixed(i, j), 3e-5, scale, what);
        }
    }
}

#[test]
fn ellipsoids_around_an_ellipsoid_have_the_stiffness_of_their_energy() {
    let r = &mut Random::new(51);
    for _ in 0..5 {
        let part = Ellipsoid::new(r.array::<3>(0.2).into(), [1.0, 1.4, 0.8]).unwrap();
        let mut fingers = Vec::new();
        let mut contacts = Vec::new();
        for _ in 0..4 {
            let touched = part.at_normal(r.array::<3>(1.0).into()).unwrap();
            let center = touched.point - touched.inward_normal * 0.55;
            let axes = [r.between(0.6, 0.9), r.between(0.6, 0.9), r.between(0.6, 0.9)];
            let own = Ellipsoid::new(Vector::ZERO, axes).unwrap();
            let finger = own.placed(&spatial::Frame::new(center.to_array(), r.array(2.0)));
            let pair =
                deepest_in_space(&Solid::Ellipsoid(finger), &Solid::Ellipsoid(part)).unwrap();
            let n = pair.inward_normal;
            contacts.push(contact::<3, 3>(&pair, curvature(&finger, n), curvature(&part, -n)));
            fingers.push(Solid::Ellipsoid(finger));
        }
        let grasp = Grasp::new(contacts).unwrap();
        check(&grasp.stiffness(Vector::ZERO, Order::Second), |q| {
            let pose = spatial::Frame::new([q[0], q[1], q[2]], [q[3], q[4], q[5]]);
            let moved = Solid::Ellipsoid(part.placed(&pose));
            let depths = fingers.iter().map(|f| deepest_in_space(f, &moved).unwrap().depth);
            depths.zip(grasp.contacts()).map(|(depth, c)| c.law().energy(depth)).sum()
        });
    }
}

#[test]
fn ellipses_around_an_ellipse_have_the_stiffness_of_their_energy() {
    let r = &mut Random::new(52);
    for _ in 0..10 {
        let part = Ellipsoid::new(r.array::<2>(0.2).into(), [1.0, 1.4]).unwrap();
        let mut fingers = Vec::new();
        let mut contacts = Vec::new();
        for _ in 0..3 {
            let touched = part.at_normal(r.array::<2>(1.0).into()).unwrap();
            let center = touched.point - touched.inward_normal * 0.55;
            let axes = [r.between(0.6, 0.9), r.between(0.6, 0.9)];
            let own = Ellipsoid::new(Vector::ZERO, axes).unwrap();
            let finger = own.placed(&planar::Frame::new(center.to_array(), r.between(0.0, 3.0)));
            let pair = deepest_in_plane(&Region::Ellipse(finger), &Region::Ellipse(part)).unwrap();
            let n = pair.inward_normal;
            contacts.push(contact::<2, 1>(&pair, curvature(&finger, n), curvature(&part, -n)));
            fingers.push(Region::Ellipse(finger));
        }
        let grasp = Grasp::new(contacts).unwrap();
        check(&grasp.stiffness(Vector::ZERO, Order::Second), |q| {
            let moved = Region::Ellipse(part.placed(&planar::Frame::new([q[0], q[1]], q[2])));
            let depths = fingers.iter().map(|f| deepest_in_plane(f, &moved).unwrap().depth);
            depths.zip(grasp.contacts()).map(|(depth, c)| c.law().energy(depth)).sum()
        });
    }
}

/// Balls on the faces of a cube: the bodies' own energy, and the grasp's, which is exact as long as
/// the balls stay on their faces.
#[test]
fn balls_around_a_cube_have_the_energy_that_the_grasp_says() {
    let r = &mut Random::new(53);
    let corner = |i: usize, bit: usize| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
    let vertices: Vec<[f64; 3]> =
        (0..8).map(|i| [corner(i, 2), corner(i, 1), corner(i, 0)]).collect();
    let faces =
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let cube = Polyhedron::new(&vertices, &faces.map(|f| f.to_vec())).unwrap();
    let solid = Solid::from(cube);
    let mut fingers = Vec::new();
    let mut contacts = Vec::new();
    for i in 0..7 {
        let (axis, side) = (i % 3, if i % 2 == 0 { 1.0 } else { -1.0 });
        let mut center = r.array::<3>(0.7);
        let radius = r.between(0.2, 0.5);
        center[axis] = side * (0.95 + radius);
        let finger = Solid::Ball(Ball::new(center.into(), radius).unwrap());
        let pair = deepest_in_space(&finger, &solid).unwrap();
        contacts.push(contact::<3, 3>(&pair, Curvature::round(radius), Curvature::FLAT));
        fingers.push(finger);
    }
    let grasp = Grasp::new(contacts).unwrap();
    for _ in 0..100 {
        let pose: Frame<3, 3> = spatial::Frame::new(r.array(0.02), r.array(0.02));
        let moved = solid.placed(&pose);
        let depths = fingers.iter().map(|f| deepest_in_space(f, &moved).unwrap().depth);
        let stored = |(depth, c): (f64, &Contact<3, 3>)| c.law().energy(depth.max(0.0));
        let energy: f64 = depths.zip(grasp.contacts()).map(stored).sum();
        assert_close(grasp.potential_energy(&pose), energy, 1e-12, 1.0, "energy");
    }
}
