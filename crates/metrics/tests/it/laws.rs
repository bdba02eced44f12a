//! What the frame, the unit and the order of things must not change.

use clench_metrics::{EquivalentStiffness, Principal, Quality, WorstPoint};
use clench_screw::{Frame, Mat, Vector, planar, spatial};
use clench_shape::{Ellipsoid, Extent, ExtremePoints};
use clench_testkit::{Random, assert_all_close, assert_close};

use crate::springs::{Spring, assembled, corners, moved, principal, springs};

/// The numbers of a grasp of a body that no frame alters.
fn invariants<const N: usize, const M: usize>(
    springs: &[Spring<N>],
    body: Extent<'_, N>,
) -> Vec<(&'static str, Vec<f64>)> {
    let principal = principal::<N, M>(springs).unwrap();
    let quality = Quality::of(&principal, body).unwrap();
    let rotations = quality.rotations;
    vec![
        ("sigma", principal.translational().values.to_vec()),
        ("mu", principal.rotational().values.to_vec()),
        ("Q", vec![quality.value]),
        ("Q_V", vec![EquivalentStiffness::least(&principal, body).unwrap().value]),
        ("Q_pt", vec![WorstPoint::of(&principal, body).unwrap().stiffness]),
        ("mu_eq", rotations.iter().map(|rotation| rotation.value).collect()),
        ("pitch", rotations.iter().map(|rotation| rotation.pitch).collect()),
        ("deflection", rotations.iter().map(|rotation| rotation.farthest.value).collect()),
    ]
}

/// What depends on directions that nearly equal stiffnesses hardly determine.
const OF_DIRECTIONS: [&str; 3] = ["mu_eq", "pitch", "deflection"];

fn assert_same(
    found: &[(&'static str, Vec<f64>)],
    wanted: &[(&'static str, Vec<f64>)],
    digits: f64,
) {
    let mu = &wanted[1].1;
    let gaps = mu.windows(2).map(|pair| (pair[1] - pair[0]) / mu[mu.len() - 1]);
    let least_gap = gaps.fold(1.0, f64::min);
    for ((name, found), (_, wanted)) in found.iter().zip(wanted) {
        let digits = if OF_DIRECTIONS.contains(name) { digits / least_gap } else { digits };
        assert_all_close(found, wanted, digits, name);
    }
}

/// In frames up to 1e3 body lengths away, coordinates are rounded to 1e-13 body lengths.
fn the_frame_does_not_matter<const N: usize, const M: usize>(
    frame: impl Fn(&mut Random, f64) -> Frame<N, M>,
    seed: u64,
) {
    let r = &mut Random::new(seed);
    for distance in [1.0, 1e3] {
        for round in 0..40 {
            let springs = springs::<N>(7 + round % 3, r);
            let frame = frame(r, distance);
            let far = moved(&springs, &frame);
            let points = corners::<N>(8 + 20 * (round % 3), r);
            let far_points: Vec<_> =
                points.iter().map(|&p| frame.point_to_parent(p.into()).to_array()).collect();
            let [body, far_body] = [&points, &far_points].map(|p| ExtremePoints::new(p).unwrap());
            let (here, there) = (
                invariants::<N, M>(&springs, (&body).into()),
                invariants::<N, M>(&far, (&far_body).into()),
            );
            assert_same(&there, &here, 1e-11);
            let semi_axes = r.array::<N>(1.0).map(|a| 0.5 + a.abs());
            let body = Ellipsoid::new(r.array(0.5).into(), semi_axes).unwrap();
            let (here, there) = (
                invariants::<N, M>(&springs, (&body).into()),
                invariants::<N, M>(&far, (&body.placed(&frame)).into()),
            );
            assert_same(&there, &here, 1e-11);
        }
    }
}

#[test]
fn the_frame_does_not_matter_in_the_plane_and_in_space() {
    the_frame_does_not_matter(|r, d| planar::Frame::new(r.array(d), r.between(-3.0, 3.0)), 31);
    the_frame_does_not_matter(|r, d| spatial::Frame::new(r.array(d), r.array(2.0)), 32);
}

#[test]
fn a_far_stiffness_loses_digits_that_a_near_origin_keeps() {
    let r = &mut Random::new(35);
    let springs = springs::<3>(7, r);
    let wanted = principal::<3, 3>(&springs).unwrap().rotational().values;
    for distance in [1e2, 1e4] {
        let far = moved(&springs, &spatial::Frame::at([distance, 0.0, 0.0].into()));
        let of_matrix =
            Principal::of(Vector::ZERO, &assembled::<3, 3>(&far, Vector::ZERO)).unwrap();
        let near = principal::<3, 3>(&far).unwrap();
        let error = |p: &Principal<3, 3>| {
            let mu = p.rotational().values;
            (0..3).map(|i| ((mu[i] - wanted[i]) / wanted[i]).abs()).fold(0.0, f64::max)
        };
        // d^2 eps is lost from the matrix, d eps from the coordinates.
        let squared = distance * distance * f64::EPSILON;
        let matrix = error(&of_matrix);
        assert!(matrix > 0.1 * squared && matrix < 1e3 * squared, "{matrix:e} {squared:e}");
        let near = error(&near);
        assert!(near < 1e3 * distance * f64::EPSILON, "{near:e}");
    }
}

fn a_change_of_units_is_exact<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for (length, force) in [(4.0, 1.0), (4.0_f64.powi(-12), 4.0_f64.powi(8))] {
        let springs = springs::<N>(7, r);
        let points = corners::<N>(60, r);
        let semi_axes = r.array::<N>(1.0).map(|a| 0.5 + a.abs());
        let evaluate = |l: f64, f: f64| {
            let scaled: Vec<_> = springs.iter().map(|&(p, n, k)| (p * l, n, k * f / l)).collect();
            let body: Vec<_> = points.iter().map(|p| p.map(|x| x * l)).collect();
            let body = ExtremePoints::new(&body).unwrap();
            let smooth = Ellipsoid::new(Vector::ZERO, semi_axes.map(|a| a * l)).unwrap();
            let principal = principal::<N, M>(&scaled).unwrap();
            let of = |body: Extent<'_, N>| {
                let quality = Quality::of(&principal, body).unwrap();
                let least = EquivalentStiffness::least(&principal, body).unwrap();
                let worst = WorstPoint::of(&principal, body).unwrap();
                let place = (worst.corner, least.farthest.corner, quality.limited_by);
                let values = [quality.value, quality.equivalent(), least.value, worst.stiffness];
                (place, values, [least.farthest.value, quality.rotations[0].pitch])
            };
            (of((&body).into()), of((&smooth).into()))
        };
        let ((one, smooth_one), (other, smooth_other)) =
            (evaluate(1.0, 1.0), evaluate(length, force));
        for (one, other) in [(one, other), (smooth_one, smooth_other)] {
            assert_eq!(other.0, one.0);
            assert_eq!(other.1, one.1.map(|stiffness| stiffness * force / length));
            assert_eq!(other.2, one.2.map(|distance| distance * length));
        }
    }
}

#[test]
fn a_change_of_units_by_powers_of_four_is_exact_in_the_plane_and_in_space() {
    a_change_of_units_is_exact::<2, 1>(36);
    a_change_of_units_is_exact::<3, 3>(37);
}

/// In a mirror pitches change their signs and nothing else changes.
fn a_mirror_does_not_matter<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for _ in 0..40 {
        let springs = springs::<N>(7, r);
        let points = corners::<N>(8, r);
        let mirror = |v: Vector<N>| Vector::from_fn(|i| if i == 0 { -v[i] } else { v[i] });
        let mirrored: Vec<_> = springs.iter().map(|&(p, n, k)| (mirror(p), mirror(n), k)).collect();
        let far: Vec<_> = points.iter().map(|&p| mirror(p.into()).to_array()).collect();
        let [body, far] = [&points, &far].map(|p| ExtremePoints::new(p).unwrap());
        let here = invariants::<N, M>(&springs, (&body).into());
        let mut there = invariants::<N, M>(&mirrored, (&far).into());
        for (name, values) in &mut there {
            if *name == "pitch" {
                *values = values.iter().map(|pitch| -pitch).collect();
            }
        }
        assert_same(&there, &here, 1e-12);
    }
}

#[test]
fn a_mirror_does_not_matter_in_the_plane_and_in_space() {
    a_mirror_does_not_matter::<2, 1>(38);
    a_mirror_does_not_matter::<3, 3>(39);
}

fn more_points_never_help<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for _ in 0..60 {
        let principal = principal::<N, M>(&springs::<N>(7, r)).unwrap();
        let mut points = corners::<N>(3, r);
        let mut before = [f64::INFINITY; 3];
        for _ in 0..12 {
            points.push(r.array(2.0));
            let body = ExtremePoints::new(&points).unwrap();
            let after = [
                Quality::of(&principal, &body).unwrap().value,
                EquivalentStiffness::least(&principal, &body).unwrap().value,
                WorstPoint::of(&principal, &body).unwrap().stiffness,
            ];
            for (after, before) in after.iter().zip(before) {
                assert!(*after <= before * (1.0 + 1e-14), "{after} {before}");
            }
            before = after;
        }
    }
}

#[test]
fn more_points_never_help_in_the_plane_and_in_space() {
    more_points_never_help::<2, 1>(40);
    more_points_never_help::<3, 3>(41);
}

/// To first order a finger is a spring more.
fn a_finger_less_never_helps<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for _ in 0..60 {
        let springs = springs::<N>(9, r);
        let all = principal::<N, M>(&springs).unwrap();
        let points = ExtremePoints::new(&corners::<N>(8, r)).unwrap();
        let worst = |p: &Principal<N, M>| WorstPoint::of(p, &points).unwrap().stiffness;
        for removed in 0..springs.len() {
            let mut rest = springs.clone();
            rest.remove(removed);
            let rest = principal::<N, M>(&rest).unwrap();
            for i in 0..N {
                let (with, without) =
                    (all.translational().values[i], rest.translational().values[i]);
                assert!(without <= with * (1.0 + 1e-13), "sigma {without} {with}");
            }
            assert!(worst(&rest) <= worst(&all) * (1.0 + 1e-12), "Q_pt");
        }
    }
}

#[test]
fn a_finger_less_never_helps_in_the_plane_and_in_space() {
    a_finger_less_never_helps::<2, 1>(42);
    a_finger_less_never_helps::<3, 3>(43);
}

/// `min(sigma_min, Q_V) / 2 <= Q_pt <= min(sigma_min, Q_V) <= Q`, and the least `mu_eq` is at most
/// three times `Q_V`.
fn the_measures_are_in_order<const N: usize, const M: usize>(count: usize, seed: u64) {
    let r = &mut Random::new(seed);
    let slack = 1.0 + 1e-9;
    let mut held = 0;
    while held < count {
        // Few springs now and then hold badly, which makes the measures differ by far.
        let springs = springs::<N>(N + M + r.below(6), r);
        let Ok(principal) = principal::<N, M>(&springs) else { continue };
        let mu = principal.rotational().values;
        if mu[0] < 1e-6 * mu[M - 1] {
            continue;
        }
        held += 1;
        let body = ExtremePoints::new(&corners::<N>(N + 1 + r.below(8), r)).unwrap();
        let quality = Quality::of(&principal, &body).unwrap();
        let least = EquivalentStiffness::least(&principal, &body).unwrap().value;
        let worst = WorstPoint::of(&principal, &body).unwrap().stiffness;
        let bound = quality.translational.min(least);
        assert!(0.5 * bound <= worst * slack, "{bound} {worst}");
        assert!(worst <= bound * slack, "{worst} {bound}");
        assert!(bound <= quality.value * slack, "{bound} {}", quality.value);
        assert!(quality.equivalent() <= 3.0 * least * slack, "{} {least}", quality.equivalent());
        if M == 1 {
            assert_close(quality.equivalent(), least, 1e-12, least, "Q_V in the plane");
        }
    }
}

#[test]
fn the_measures_are_in_order_for_a_hundred_thousand_grasps() {
    the_measures_are_in_order::<2, 1>(40_000, 44);
    the_measures_are_in_order::<3, 3>(60_000, 45);
}

/// Fingers and corners in another order: the same numbers.
#[test]
fn the_order_of_things_does_not_matter() {
    let r = &mut Random::new(46);
    for _ in 0..40 {
        let mut springs = springs::<3>(8, r);
        let mut points = corners::<3>(40, r);
        let here = invariants::<3, 3>(&springs, (&ExtremePoints::new(&points).unwrap()).into());
        springs.reverse();
        points.rotate_left(17);
        let there = invariants::<3, 3>(&springs, (&ExtremePoints::new(&points).unwrap()).into());
        assert_same(&there, &here, 1e-11);
    }
}

/// The center moves with the frame.
#[test]
fn the_centers_move_with_the_frame() {
    let r = &mut Random::new(47);
    for _ in 0..50 {
        let springs = springs::<3>(7, r);
        let frame = spatial::Frame::new(r.array(1e3), r.array(2.0));
        let (here, there) = (
            principal::<3, 3>(&springs).unwrap(),
            principal::<3, 3>(&moved(&springs, &frame)).unwrap(),
        );
        for center in [
            Principal::<3, 3>::center,
            Principal::loncaric_center_of_stiffness,
            Principal::loncaric_center_of_compliance,
        ] {
            let off = frame.point_to_parent(center(&here)) - center(&there);
            assert!(off.norm() <= 1e-9, "{off:?}");
        }
        let turned: Mat<3, 3> = *frame.axes() * here.pitch_tensor() * frame.axes().transpose();
        let found = there.pitch_tensor();
        assert_all_close(found.rows().as_flattened(), turned.rows().as_flattened(), 1e-9, "S");
    }
}
