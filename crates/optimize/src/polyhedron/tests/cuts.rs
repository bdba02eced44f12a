//! Each inequality by itself, where it is as sharp as it can be, and the corners of large groups.

use clench_metrics::{EquivalentStiffness, Principal, WorstPoint};
use clench_screw::{Cholesky, Mat, Stiffness, Vector};
use clench_shape::Polyhedron;
use clench_testkit::{Random, assert_close, solids};

use super::part;
use crate::polyhedron::bound::{Cut, Pieces, least_cylinder_squared};
use crate::polyhedron::rating::stiffness;
use crate::polyhedron::scene::Scene;
use crate::polyhedron::{Fingers, Part};
use crate::search::Piece;
use crate::search::boxes::value;

/// Wrenches of fingers by chance, two on each face of a tetrahedron, whose `K_11` is a multiple of
/// the identity, or on any faces.
fn wrenches(r: &mut Random, scene: &Scene<'_>, even: bool) -> Vec<Vector<6>> {
    let patches = &scene.patches;
    (0..8)
        .map(|i| {
            let patch = &patches[if even { i / 2 } else { r.below(patches.len()) }];
            let [a, b, c] = patch.triangles[0];
            let (u, v) = (r.between(0.0, 0.5), r.between(0.0, 0.5));
            patch.wrench(a + (b - a) * u + (c - a) * v)
        })
        .collect()
}

fn total(cut: &Cut, wrenches: &[Vector<6>]) -> f64 {
    wrenches.iter().map(|&p| value(&cut.form, Vector::ZERO, p)).sum()
}

/// The principal parameters with another translation that goes with `rotation`.
fn shifted(k: &Stiffness<3, 3>, rotation: Vector<3>, by: Vector<3>) -> Principal<3, 3> {
    let shift = Mat::outer(by, rotation) * rotation.norm_squared().recip();
    let coupling = k.coupling - k.translational * shift;
    let stiff = k.rotational + Mat::IDENTITY * (1e3 * k.rotational.trace());
    Principal::of(Vector::ZERO, &Stiffness { coupling, rotational: stiff, ..*k }).unwrap()
}

/// For the translation that leaves least room, the cut by rotation says what the quality is, and
/// for any other no less.
#[test]
fn the_cut_by_rotation_is_as_sharp_as_it_is_derived() {
    let mut r = Random::new(71);
    let mut sharp = 0;
    for round in 0..400 {
        let even = round % 2 == 0;
        let kind = if even { 1 } else { round % 5 };
        let part = part(&mut r, kind);
        let fingers = Fingers::new(8);
        let scene = Scene::of_part(&part, &fingers).unwrap();
        let wrenches = wrenches(&mut r, &scene, even);
        let k = stiffness(wrenches.iter().copied());
        let Ok(principal) = Principal::of(Vector::ZERO, &k) else { continue };
        let softest = EquivalentStiffness::least(&principal, &scene.extremes).unwrap();
        let (most, sigma) = (softest.value, principal.translational().values[0]);
        let q = most * r.between(-1.5, 1.5).exp();
        let twist = principal.force_free_twist(softest.rotation);
        let velocity = twist.velocity_at(softest.farthest.point);
        let resisted = k.translational + Mat::IDENTITY * q;
        let tightest = Cholesky::new(&resisted).unwrap().solve(velocity) * (most - q);
        let by = if even { tightest } else { Vector::from(r.array(1.0)) };
        let other = shifted(&k, softest.rotation, by);
        let moved = (softest.rotation, softest.farthest.point);
        let cut = Cut::rotation(&other, &k.translational, moved, q).unwrap();
        let bound = cut.limits.largest_objective(total(&cut, &wrenches), sigma);
        assert!(bound >= most * (1.0 - 1e-9), "{bound} < {most} for q = {q}");
        if even && bound.is_finite() {
            assert_close(bound, most, 1e-6, most, "the bound where nothing is left over");
            sharp += 1;
        }
        // A mean with a cut for another q, and with one that knows no y.
        let second = Cut::rotation(&principal, &k.translational, moved, 0.5 * q).unwrap();
        let radius = least_cylinder_squared(scene.extremes.points());
        let third = Cut::cylinder(&principal, softest.rotation, radius);
        let mean = cut.mixed(0.3, &second).mixed(0.2, &third);
        let bound = mean.limits.largest_objective(total(&mean, &wrenches), sigma);
        assert!(bound >= most * (1.0 - 1e-9), "{bound} < {most} by a mean");
    }
    assert!(sharp > 100, "{sharp}");
}

#[test]
fn the_cut_by_the_worst_point_is_sharp() {
    let mut r = Random::new(72);
    for round in 0..200 {
        let part = part(&mut r, round % 6);
        let fingers = Fingers::new(8);
        let scene = Scene::of_part(&part, &fingers).unwrap();
        let wrenches = wrenches(&mut r, &scene, false);
        let k = stiffness(wrenches.iter().copied());
        let Ok(principal) = Principal::of(Vector::ZERO, &k) else { continue };
        let worst = WorstPoint::of(&principal, &scene.extremes).unwrap();
        let cut = Cut::worst_point(&principal, worst.point, worst.direction);
        let bound = cut.limits.largest_objective(total(&cut, &wrenches), 0.0);
        assert_close(bound, worst.stiffness, 1e-8, worst.stiffness, "the bound");
        let any = Cut::worst_point(&principal, worst.point, Vector::from(r.array(1.0)));
        let bound = any.limits.largest_objective(total(&any, &wrenches), 0.0);
        assert!(bound >= worst.stiffness * (1.0 - 1e-9));
    }
}

/// Of a cylinder, a long box and a cube the radius is known.
#[test]
fn no_cylinder_is_smaller() {
    let least = |mesh: &solids::Mesh| {
        let points: Vec<Vector<3>> = mesh.0.iter().map(|&v| v.into()).collect();
        least_cylinder_squared(&points)
    };
    assert_close(least(&solids::cuboid([1.0, 1.0, 1.0])), 2.0, 1e-9, 2.0, "a cube");
    assert_close(least(&solids::cuboid([9.0, 2.0, 1.0])), 5.0, 1e-9, 5.0, "a box");
    let (mut vertices, faces) = solids::regular_prism(24);
    for vertex in &mut vertices {
        vertex[2] *= 4.0;
    }
    let found = least(&(vertices, faces));
    assert!(found <= 1.0 + 1e-12 && found > 0.999, "{found}");
    // Against axes by chance.
    let mut r = Random::new(73);
    for _ in 0..30 {
        let mesh = solids::between_planes(&mut r, 10);
        let bound = least(&mesh);
        for _ in 0..300 {
            let Some(axis) = Vector::<3>::from(r.array(1.0)).direction() else { continue };
            let foot = Vector::<3>::from(r.array(0.4));
            let farthest = mesh.0.iter().map(|&v| {
                let offset = Vector::from(v) - foot;
                offset.norm_squared() - offset.dot(axis).powi(2)
            });
            assert!(farthest.fold(0.0, f64::max) >= bound);
        }
    }
}

/// What is said of all corners of a group holds for each, whether they are looked at or in a box.
#[test]
fn boxes_hold_the_corners_of_large_groups() {
    let mut r = Random::new(74);
    let globe = solids::globe(14, [1.0, 2.0, 0.7]);
    let part = Part::uniform(Polyhedron::from_triangles(&globe).unwrap(), 1.0, 0.0).unwrap();
    let fingers = Fingers { roundness: 0.0, ..Fingers::new(7) };
    let scene = Scene::of_part(&part, &fingers).unwrap();
    let pieces = Pieces::new(&scene);
    let mut open = vec![Piece::BOUNDARY];
    let mut near = 0;
    while let Some(piece) = open.pop() {
        if pieces.patches(piece).len() > 1 {
            open.extend(pieces.halves(piece).unwrap());
        }
        let corners = pieces.corners(piece);
        let (t, s) = (Vector::<6>::from(r.array(1.0)), Vector::<6>::from(r.array(1.0)));
        let form = Mat::outer(t, t) + Mat::outer(s, s) * r.between(0.0, 2.0);
        let (mut largest, mut least) = (f64::NEG_INFINITY, f64::INFINITY);
        for &number in pieces.patches(piece) {
            let patch = &scene.patches[number];
            for &x in &patch.corners {
                let p = patch.wrench(x);
                largest = largest.max(value(&form, Vector::ZERO, p));
                least = least.min(t.dot(p));
            }
        }
        let (by_form, by_line) = (corners.largest(&form), corners.least_linear(t));
        assert!(by_form >= largest * (1.0 - 1e-12), "{by_form} < {largest}");
        assert!(by_line <= least + 1e-12, "{by_line} > {least}");
        let many = pieces.patches(piece).len() > 48;
        near += usize::from(many && by_form < 4.0 * largest);
    }
    assert!(near > 2, "{near} boxes are near");
}
