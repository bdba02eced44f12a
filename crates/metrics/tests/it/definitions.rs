//! The parameters against what they are defined by, on the full matrices.

use clench_metrics::{Displacement, Principal};
use clench_screw::{Axis, Frame, Mat, Stiffness, Twist, Vector, Wrench, spatial};
use clench_shape::ExtremePoints;
use clench_testkit::{Random, assert_all_close, assert_close};

use crate::springs::{assembled, corners, principal, solve, springs};

/// The unit vector along axis `i`.
fn unit<const D: usize>(i: usize) -> Vector<D> {
    Vector::from_fn(|k| if k == i { 1.0 } else { 0.0 })
}

/// `mu` and `sigma` are what they are named for: the torque per rotation without force, and the
/// force per translation without rotation.
fn principal_parameters_fulfil_their_definitions<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for _ in 0..50 {
        let springs = springs::<N>(7, r);
        let stiffness = assembled::<N, M>(&springs, Vector::ZERO);
        let principal = principal::<N, M>(&springs).unwrap();
        for (mu, axis) in principal.rotational().values.iter().zip(principal.rotational().vectors) {
            let wrench = stiffness.apply(&principal.force_free_twist(axis));
            let wanted = axis * *mu;
            assert!(wrench.force.norm() <= 1e-12 * wanted.norm().max(1.0));
            assert_all_close(&wrench.torque.to_array(), &wanted.to_array(), 1e-10, "torque");
        }
        let sigma = principal.translational();
        for (value, direction) in sigma.values.iter().zip(sigma.vectors) {
            let load = principal.rotation_free_wrench(direction);
            let twist = solve(&stiffness, &load);
            assert!(twist.angular.norm() <= 1e-10 * twist.linear.norm(), "{:?}", twist.angular);
            let moved = twist.linear * *value;
            assert_all_close(&moved.to_array(), &direction.to_array(), 1e-10, "translation");
        }
        let compliance = Mat::<N, N>::from_fn(|i, j| {
            solve(&stiffness, &principal.rotation_free_wrench(unit(j))).linear[i]
        });
        let found = principal.translational_compliance();
        let wanted = compliance.rows().as_flattened();
        assert_all_close(found.rows().as_flattened(), wanted, 1e-10, "C_W");
    }
}

#[test]
fn principal_parameters_fulfil_their_definitions_in_the_plane_and_in_space() {
    principal_parameters_fulfil_their_definitions::<2, 1>(33);
    principal_parameters_fulfil_their_definitions::<3, 3>(34);
}

/// Displacements by loads, of the body and of its points, by elimination on the full matrix.
fn loads_move_the_body<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for _ in 0..50 {
        let springs = springs::<N>(7, r);
        let stiffness = assembled::<N, M>(&springs, Vector::ZERO);
        let principal = principal::<N, M>(&springs).unwrap();
        let load = Wrench::<N, M> { force: r.array(1.0).into(), torque: r.array(1.0).into() };
        let wanted = solve(&stiffness, &load);
        let points = corners::<N>(9, r);
        let body = ExtremePoints::new(&points).unwrap();
        let found = Displacement::of(&principal, Vector::ZERO, &load, &body).unwrap();
        assert_all_close(&found.twist.linear.to_array(), &wanted.linear.to_array(), 1e-10, "v");
        assert_all_close(&found.twist.angular.to_array(), &wanted.angular.to_array(), 1e-10, "w");
        let speeds = points.iter().map(|&p| wanted.velocity_at(p.into()).norm());
        let largest = speeds.fold(0.0, f64::max);
        assert_close(found.largest.value, largest, 1e-10, largest, "largest");
        // So many times the load just keeps the tolerance.
        let grown = Displacement::of(&principal, Vector::ZERO, &(load * found.margin(3.0)), &body);
        assert_close(grown.unwrap().largest.value, 3.0, 1e-10, 3.0, "margin");
        // About another origin it is the same displacement.
        let origin: Vector<N> = r.array(1.0).into();
        let there = Displacement::of(&principal, origin, &load.in_frame(&Frame::at(origin)), &body)
            .unwrap();
        let off = there.at(found.largest.point) - found.at(found.largest.point);
        assert!(off.norm() <= 1e-10 * largest, "{off:?}");
        assert_close(found.at(found.largest.point).norm(), largest, 1e-10, largest, "there");
        // A force at a point moves it by the point's compliance.
        let (point, force): (Vector<N>, Vector<N>) = (r.array(1.0).into(), r.array(1.0).into());
        let twist = solve(&stiffness, &Wrench::<N, M>::of_force_at(force, point));
        let found = principal.compliance_at(point) * force;
        let wanted = twist.velocity_at(point).to_array();
        assert_all_close(&found.to_array(), &wanted, 1e-10, "point");
    }
}

#[test]
fn loads_move_the_body_in_the_plane_and_in_space() {
    loads_move_the_body::<2, 1>(48);
    loads_move_the_body::<3, 3>(49);
}

/// A motion or load of the plane is one of space.
fn flat<const N: usize>(v: Vector<3>) -> Vector<N> {
    Vector::from_fn(|i| v[i])
}

fn turning<const M: usize>(v: Vector<3>) -> Vector<M> {
    Vector::from_fn(|i| v[i + 3 - M])
}

/// Turned about its axis with its pitch, the body answers with a pure couple, `mu_i` times the
/// turn; pushed along its axis with its pitch, it moves along it and does not turn. Far from the
/// origin too.
fn axes_have_their_property<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for distance in [1.0, 1e3] {
        for _ in 0..50 {
            let shift: Vector<N> = r.array(distance).into();
            let springs: Vec<_> =
                springs::<N>(7, r).iter().map(|&(p, n, k)| (p + shift, n, k)).collect();
            let principal = principal::<N, M>(&springs).unwrap();
            let stiffness = assembled::<N, M>(&springs, shift);
            // The axis counted from the shift, near the springs, so that nothing cancels here.
            let near = |axis: &Axis| Axis { point: axis.point - shift.in_space(), ..*axis };
            let size = 1e-11 * distance;
            for (axis, mu) in principal.twist_axes().iter().zip(principal.rotational().values) {
                let twist = near(axis).twist();
                let twist = Twist { linear: flat(twist.linear), angular: turning(twist.angular) };
                let wrench = stiffness.apply(&twist);
                assert!(wrench.force.norm() <= size, "{:?}", wrench.force);
                let off = wrench.torque - twist.angular * mu;
                assert!(off.norm() <= size, "{off:?}");
                assert!(axis.point.dot(axis.direction).abs() <= size, "the nearest point");
            }
            for (axis, sigma) in
                principal.wrench_axes().iter().zip(principal.translational().values)
            {
                let wrench = near(axis).wrench();
                let load = Wrench { force: flat(wrench.force), torque: turning(wrench.torque) };
                let twist: Twist<N, M> = solve(&stiffness, &load);
                let scale = size / principal.rotational().values[0];
                assert!(twist.angular.norm() <= scale, "{:?}", twist.angular);
                let off = twist.linear * sigma - load.force;
                assert!(off.norm() <= scale * sigma.max(1.0) * 10.0, "{off:?}");
                assert!(axis.point.dot(axis.direction).abs() <= size, "the nearest point");
            }
        }
    }
}

#[test]
fn axes_have_their_property_in_the_plane_and_in_space() {
    axes_have_their_property::<2, 1>(61);
    axes_have_their_property::<3, 3>(62);
}

/// About the canonical point `P_1` is symmetric, about Loncaric's centers `K_12` and `C_12` are.
#[test]
fn each_center_makes_its_block_symmetric() {
    let r = &mut Random::new(63);
    let skew =
        |m: &Mat<3, 3>| (0..9).map(|i| m[i / 3][i % 3] - m[i % 3][i / 3]).fold(0.0, f64::max);
    for _ in 0..50 {
        let springs = springs::<3>(7, r);
        let principal = principal::<3, 3>(&springs).unwrap();
        let compliance_coupling = |origin| {
            let stiffness = assembled::<3, 3>(&springs, origin);
            Mat::<3, 3>::from_fn(|i, j| {
                let couple = Wrench { force: Vector::ZERO, torque: unit(j) };
                solve(&stiffness, &couple).linear[i]
            })
        };
        let map = |origin| {
            let stiffness = assembled::<3, 3>(&springs, origin);
            Principal::of(Vector::ZERO, &stiffness).unwrap().twist_map()
        };
        let [canonical, of_stiffness, of_compliance] = [
            principal.center(),
            principal.loncaric_center_of_stiffness(),
            principal.loncaric_center_of_compliance(),
        ];
        assert!(skew(&map(canonical)) < 1e-11);
        assert!(skew(&assembled::<3, 3>(&springs, of_stiffness).coupling) < 1e-11);
        assert!(skew(&compliance_coupling(of_compliance)) < 1e-10);
        // Three different points, in general, and none of them a center of compliance.
        assert!((canonical - of_stiffness).norm() > 1e-6);
        assert!((canonical - of_compliance).norm() > 1e-6);
        assert!((of_stiffness - of_compliance).norm() > 1e-6);
        assert_eq!(principal.center_of_compliance(), None);
        // Pitches are those of the symmetric rest.
        let tensor = principal.pitch_tensor();
        for (axis, rotation) in principal.twist_axes().iter().zip(principal.rotational().vectors) {
            assert_close(axis.pitch, rotation.dot(tensor * rotation), 1e-12, 1.0, "pitch");
        }
        for (axis, force) in principal.wrench_axes().iter().zip(principal.translational().vectors) {
            assert_close(axis.pitch, -force.dot(tensor * force), 1e-12, 1.0, "wrench pitch");
        }
    }
}

/// Springs in threes along the axes, on both sides of a point alike, have it for their center.
#[test]
fn a_center_of_compliance_is_found_where_there_is_one_and_decouples() {
    let r = &mut Random::new(64);
    for distance in [0.0, 1.0, 1e3] {
        let center: Vector<3> = r.array(distance).into();
        let turn = spatial::Frame::new([0.0; 3], r.array(2.0));
        let springs: Vec<_> = (0..12)
            .map(|i| {
                let (axis, across) = (i / 4, (i / 4 + 1) % 3);
                let sides = [1.0, -1.0, 1.0, -1.0];
                let arm = unit::<3>(across) * sides[i % 4] + unit::<3>(axis) * sides[i % 4 / 2];
                let normal = turn.direction_to_parent(unit(axis));
                (center + turn.direction_to_parent(arm), normal, 1.0 + axis as f64)
            })
            .collect();
        let principal = principal::<3, 3>(&springs).unwrap();
        let found = principal.center_of_compliance().unwrap();
        assert!((found - center).norm() <= 1e-13 * distance.max(1.0), "{found:?} {center:?}");
        let coupling = assembled::<3, 3>(&springs, found).coupling.max_abs();
        assert!(coupling <= 1e-12 * distance.max(1.0), "{coupling}");
        for other in
            [principal.loncaric_center_of_stiffness(), principal.loncaric_center_of_compliance()]
        {
            assert!((other - center).norm() <= 1e-12 * distance.max(1.0));
        }
    }
}

/// Three springs about each axis, at unlike heights, turned and far away: where coordinates are
/// rounded, so is the pitch tensor, and the center is still one.
#[test]
fn a_center_of_compliance_does_not_depend_on_the_frame() {
    let r = &mut Random::new(67);
    for distance in [1.0, 1e3, 1e6] {
        for _ in 0..50 {
            let center: Vector<3> = r.array(distance).into();
            let turn = spatial::Frame::new([0.0; 3], r.array(2.0));
            let mut springs = Vec::new();
            for axis in 0..3 {
                let height = r.between(-1.0, 1.0);
                for third in 0..3 {
                    let angle = std::f64::consts::TAU * f64::from(third) / 3.0;
                    let (one, other) = (unit::<3>((axis + 1) % 3), unit::<3>((axis + 2) % 3));
                    let arm = one * angle.cos() + other * angle.sin() + unit(axis) * height;
                    let point = center + turn.direction_to_parent(arm);
                    springs.push((point, turn.direction_to_parent(unit(axis)), 1.0));
                }
            }
            let principal = principal::<3, 3>(&springs).unwrap();
            let found = principal.center_of_compliance().unwrap();
            assert!((found - center).norm() <= 1e-13 * distance.max(10.0), "{found:?} {center:?}");
        }
    }
}

/// Every point of the surfaces has unit energy; sections and projections are parts of them.
fn surfaces_have_unit_energy<const N: usize, const M: usize>(
    frame: impl Fn(&mut Random) -> Frame<N, M>,
    seed: u64,
) {
    let r = &mut Random::new(seed);
    for _ in 0..50 {
        let springs = springs::<N>(7, r);
        let stiffness = assembled::<N, M>(&springs, Vector::ZERO);
        let principal = principal::<N, M>(&springs).unwrap();
        let both = Vector::<6>::from(r.array(1.0)).direction().unwrap();
        let size = (0..N + M).map(|i| both[i] * both[i]).sum::<f64>().sqrt();
        let along = Vector::<N>::from_fn(|i| both[i] / size);
        let about = Vector::<M>::from_fn(|i| both[N + i] / size);

        let twist = principal.displacement_of_unit_energy(along, about);
        assert_close(0.5 * stiffness.quadratic(&twist), 1.0, 1e-11, 1.0, "displacement");
        let section = principal.displacement_section(twist.angular).unwrap();
        let left = along.norm();
        let back = section.point(along * left.recip()) - twist.linear;
        assert!(back.norm() <= 1e-11, "{back:?}");
        let largest = (2.0 / principal.translational().values[0]).sqrt();
        assert!(section.semi_axes[0] <= largest * (1.0 + 1e-14));

        let wrench = principal.wrench_of_unit_energy(along, about);
        let energy = 0.5 * solve(&stiffness, &wrench).power(&wrench);
        assert_close(energy, 1.0, 1e-10, 1.0, "wrench");
        let section = principal.wrench_section(wrench.force).unwrap();
        let back = section.point(about * about.norm().recip()) - wrench.torque;
        assert!(back.norm() <= 1e-10, "{back:?}");

        // At the rim of a projection nothing is left for the section.
        let rim = principal.displacement_projection().point(unit(0));
        assert!(principal.displacement_section(rim * 1.000_1).is_none());
        let rim = principal.displacement_section(rim * 0.999_999).unwrap();
        assert!(rim.semi_axes[N - 1] < 0.01 * largest);
        let rim = principal.wrench_projection().point(unit(0));
        assert!(principal.wrench_section(rim * 1.000_1).is_none());

        // Semi-axes are the same in another frame, centers are not.
        let frame = frame(r);
        let moved = Principal::of(Vector::ZERO, &stiffness.in_frame(&frame)).unwrap();
        let rotation = twist.angular;
        let there = moved.displacement_section(frame.spin().transpose() * rotation).unwrap();
        let here = principal.displacement_section(rotation).unwrap();
        assert_all_close(&there.semi_axes, &here.semi_axes, 1e-9, "semi-axes");
        let there = moved.displacement_projection().semi_axes;
        let here = principal.displacement_projection().semi_axes;
        assert_all_close(&there, &here, 1e-9, "projection");
        // Written in that frame, the parameters are those of the stiffness written there.
        let written = principal.in_frame(&frame);
        let same = |found: &[f64], wanted: &[f64], what: &str| {
            assert_all_close(found, wanted, 1e-9, what);
        };
        same(
            written.twist_map().rows().as_flattened(),
            moved.twist_map().rows().as_flattened(),
            "P_1",
        );
        same(
            written.restricted_stiffness().rows().as_flattened(),
            moved.restricted_stiffness().rows().as_flattened(),
            "K_V",
        );
        same(
            written.translational_compliance().rows().as_flattened(),
            moved.translational_compliance().rows().as_flattened(),
            "C_W",
        );
        same(&written.center().to_array(), &moved.center().to_array(), "center");
        let unit = written.translational().vectors[0].dot(moved.translational().vectors[0]);
        assert_close(unit.abs(), 1.0, 1e-6, 1.0, "direction");
    }
}

#[test]
fn surfaces_have_unit_energy_in_the_plane_and_in_space() {
    surfaces_have_unit_energy(
        |r| clench_screw::planar::Frame::new(r.array(3.0), r.between(-3.0, 3.0)),
        65,
    );
    surfaces_have_unit_energy(|r| spatial::Frame::new(r.array(3.0), r.array(2.0)), 66);
}

/// Both surfaces by hand: `K = diag(2, 8, 32)` about the origin of the plane.
#[test]
fn the_semi_axes_of_a_simple_stiffness_are_those_of_the_paper() {
    let stiffness = Stiffness::<2, 1> {
        translational: Mat::new([[2.0, 0.0], [0.0, 8.0]]),
        coupling: Mat::ZERO,
        rotational: Mat::new([[32.0]]),
    };
    let principal = Principal::of(Vector::ZERO, &stiffness).unwrap();
    assert_eq!(principal.displacement_section(Vector::ZERO).unwrap().semi_axes, [1.0, 0.5]);
    assert_eq!(principal.displacement_projection().semi_axes, [0.25]);
    assert_eq!(principal.wrench_section(Vector::ZERO).unwrap().semi_axes, [8.0]);
    assert_eq!(principal.wrench_projection().semi_axes, [2.0, 4.0]);
    // Half of the energy in a rotation of 1 / sqrt(32): sections are smaller by sqrt(1/2).
    let half = principal.displacement_section(Vector::new([1.0 / 32.0_f64.sqrt()])).unwrap();
    assert_all_close(&half.semi_axes, &[0.5_f64.sqrt(), 0.5 * 0.5_f64.sqrt()], 1e-15, "half");
}
