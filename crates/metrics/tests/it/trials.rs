//! The measures against trial and error: loads at points, rotations, and displacements by hand.

use std::f64::consts::TAU;

use clench_metrics::{EquivalentStiffness, LimitedBy, Principal, Quality, WorstPoint};
use clench_screw::{Mat, Stiffness, Vector, Wrench, spatial};
use clench_shape::{Ellipsoid, Extent, ExtremePoints, Polygon};
use clench_testkit::{Random, assert_close};

use crate::springs::{assembled, corners, principal, solve, springs};

/// Unit vectors all over the circle or the sphere, none farther than 0.05 from another.
fn directions<const N: usize>() -> Vec<Vector<N>> {
    if N == 2 {
        let at = |i: i32| (f64::from(i) * TAU / 400.0).sin_cos();
        return (0..400).map(at).map(|(s, c)| Vector::from_fn(|i| [c, s][i])).collect();
    }
    // A spiral that goes down evenly.
    let count = 6000;
    let golden = TAU * 0.381_966_011_250_105;
    let at = |i: i32| {
        let height = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(count);
        let radius = (1.0 - height * height).sqrt();
        let (s, c) = (golden * f64::from(i)).sin_cos();
        Vector::from_fn(|k| [radius * c, radius * s, height][k])
    };
    (0..count).map(at).collect()
}

/// Forces at the points of a body in all directions, and what they move, by elimination.
fn softest_by_trial<const N: usize, const M: usize>(
    stiffness: &Stiffness<N, M>,
    points: &[Vector<N>],
) -> f64 {
    let mut softest = f64::INFINITY;
    for &point in points {
        // The compliance at the point, column by column.
        let columns: [Vector<N>; N] = std::array::from_fn(|j| {
            let force = Vector::from_fn(|i| if i == j { 1.0 } else { 0.0 });
            solve(stiffness, &Wrench::<N, M>::of_force_at(force, point)).velocity_at(point)
        });
        for force in directions::<N>() {
            let moved = (0..N).fold(Vector::ZERO, |sum, j| sum + columns[j] * force[j]);
            softest = softest.min(1.0 / moved.norm());
        }
    }
    softest
}

fn the_worst_point_is_what_forces_find_by_trial<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for _ in 0..15 {
        let springs = springs::<N>(7, r);
        let stiffness = assembled::<N, M>(&springs, Vector::ZERO);
        let principal = principal::<N, M>(&springs).unwrap();
        let points = corners::<N>(6, r);
        let body = ExtremePoints::new(&points).unwrap();
        let worst = WorstPoint::of(&principal, &body).unwrap();
        let points: Vec<Vector<N>> = points.into_iter().map(Vector::from).collect();
        let trial = softest_by_trial::<N, M>(&stiffness, &points);
        // A direction 0.05 off costs at most the square of that.
        assert!(worst.stiffness <= trial * (1.0 + 1e-9), "{} {trial}", worst.stiffness);
        assert!(worst.stiffness >= trial * 0.995, "{} {trial}", worst.stiffness);
        // And it is attained where it says.
        let load = Wrench::<N, M>::of_force_at(worst.direction, worst.point);
        let moved = solve(&stiffness, &load).velocity_at(worst.point);
        assert_close(1.0 / moved.norm(), worst.stiffness, 1e-9, worst.stiffness, "attained");
        assert_eq!(points[worst.corner.unwrap()], worst.point);
        assert_eq!(worst.at_least, worst.stiffness);
        // A force elsewhere moves no point more than the worst point moves itself.
        for _ in 0..50 {
            let (force, other) = (points[r.below(points.len())], points[r.below(points.len())]);
            let along = Vector::<N>::from(r.array(1.0)).direction().unwrap();
            let twist = solve(&stiffness, &Wrench::<N, M>::of_force_at(along, force));
            let deflection = twist.velocity_at(other).norm();
            assert!(deflection * worst.stiffness <= 1.0 + 1e-9);
        }
    }
}

#[test]
fn the_worst_point_is_what_forces_find_by_trial_in_the_plane_and_in_space() {
    the_worst_point_is_what_forces_find_by_trial::<2, 1>(51);
    the_worst_point_is_what_forces_find_by_trial::<3, 3>(52);
}

/// `omega^T K_V omega / D^2` over rotations all around, with the deflection taken corner by corner.
#[test]
fn the_least_equivalent_stiffness_is_what_rotations_find_by_trial() {
    let r = &mut Random::new(53);
    for _ in 0..15 {
        let principal = principal::<3, 3>(&springs::<3>(7, r)).unwrap();
        let points = corners::<3>(8, r);
        let body = ExtremePoints::new(&points).unwrap();
        let least = EquivalentStiffness::least(&principal, &body).unwrap();
        let equivalent = |rotation: Vector<3>| {
            let twist = principal.force_free_twist(rotation);
            let moved = points.iter().map(|&p| twist.velocity_at(p.into()).norm_squared());
            let stiffness = *principal.restricted_stiffness();
            rotation.dot(stiffness * rotation) / moved.fold(0.0, f64::max)
        };
        let trial = directions().into_iter().map(equivalent).fold(f64::INFINITY, f64::min);
        assert!(least.value <= trial * (1.0 + 1e-12), "{} {trial}", least.value);
        assert!(least.value >= trial * 0.98, "{} {trial}", least.value);
        let attained = equivalent(least.rotation);
        assert_close(attained, least.value, 1e-10, attained, "attained");
        let twist = principal.force_free_twist(least.rotation);
        let axis = twist.screw();
        let clench_screw::Screw::Axis { axis, .. } = axis else { panic!("{axis:?}") };
        assert_close(axis.pitch, least.pitch, 1e-10, 1.0, "pitch");
        // rho_max is the distance from the axis.
        let off = Vector::from(points[least.farthest.corner.unwrap()]) - axis.point;
        let distance = (off - axis.direction * axis.direction.dot(off)).norm();
        assert_close(least.reach, distance, 1e-9, distance, "reach");
    }
}

/// On an ellipsoid the same, over a net of its boundary, and proved to the last digits.
fn smooth_bodies_are_searched_everywhere<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for round in 0..20 {
        let springs = springs::<N>(7, r);
        let principal = principal::<N, M>(&springs).unwrap();
        let stretch = if round % 2 == 0 { 0.2 } else { 0.9 };
        let semi_axes = r.array::<N>(1.0).map(|a| stretch + a.abs());
        let body = Ellipsoid::new(r.array(0.5).into(), semi_axes).unwrap();
        let net: Vec<[f64; N]> = directions::<N>()
            .into_iter()
            .map(|u| (body.center() + Vector::from_fn(|i| semi_axes[i] * u[i])).to_array())
            .collect();
        let net = ExtremePoints::new(&net).unwrap();
        let worst = WorstPoint::of(&principal, &body).unwrap();
        let of_net = WorstPoint::of(&principal, &net).unwrap().stiffness;
        assert!(worst.stiffness <= of_net * (1.0 + 1e-12), "{} {of_net}", worst.stiffness);
        assert!(worst.stiffness >= of_net * 0.99, "{} {of_net}", worst.stiffness);
        assert!(worst.at_least <= worst.stiffness);
        assert_close(worst.at_least, worst.stiffness, 1e-12, of_net, "proved");
        let least = EquivalentStiffness::least(&principal, &body).unwrap();
        let of_net = EquivalentStiffness::least(&principal, &net).unwrap().value;
        assert!(least.value <= of_net * (1.0 + 1e-12), "{} {of_net}", least.value);
        assert!(least.value >= of_net * 0.99, "{} {of_net}", least.value);
        let quality = Quality::of(&principal, &body).unwrap();
        let of_net = Quality::of(&principal, &net).unwrap();
        assert!(quality.value <= of_net.value * (1.0 + 1e-12));
        assert!(quality.value >= of_net.value * 0.99);
    }
}

#[test]
fn smooth_bodies_are_searched_everywhere_in_the_plane_and_in_space() {
    smooth_bodies_are_searched_everywhere::<2, 1>(54);
    smooth_bodies_are_searched_everywhere::<3, 3>(55);
}

fn isotropic(sigma: f64, mu: [f64; 3]) -> Principal<3, 3> {
    let stiffness = Stiffness {
        translational: Mat::IDENTITY * sigma,
        coupling: Mat::ZERO,
        rotational: Mat::from_fn(|i, j| if i == j { mu[i] } else { 0.0 }),
    };
    Principal::of(Vector::ZERO, &stiffness).unwrap()
}

fn cube() -> Vec<[f64; 3]> {
    (0..8).map(|i| [0, 1, 2].map(|axis| f64::from(i >> axis & 1) * 2.0 - 1.0)).collect()
}

/// A ball about the center of an isotropic stiffness: every direction ties, and no search can
/// prove the last digit. `Q_V = mu / r^2` and `1 / Q_pt = 1 / sigma + r^2 / mu` all the same.
#[test]
fn a_ball_has_its_value_though_all_directions_tie() {
    let ball = Ellipsoid::new(Vector::ZERO, [2.0; 3]).unwrap();
    let principal = isotropic(3.0, [5.0; 3]);
    let least = EquivalentStiffness::least(&principal, &ball).unwrap();
    assert_close(least.value, 1.25, 1e-14, 1.25, "Q_V");
    assert!(least.at_least < least.value && least.at_least > 0.99 * least.value, "{least:?}");
    let worst = WorstPoint::of(&principal, &ball).unwrap();
    let wanted = 1.0 / (1.0 / 3.0 + 4.0 / 5.0);
    assert_close(worst.stiffness, wanted, 1e-14, wanted, "Q_pt");
    assert!(worst.at_least > 0.99 * wanted);
    let quality = Quality::of(&principal, &ball).unwrap();
    assert!(quality.degenerate && quality.limited_by == LimitedBy::Rotation);
    assert_close(quality.value, 1.25, 1e-14, 1.25, "Q");
}

/// [LBR, eq. 16] with one set of axes or another gives another number; the least of all is taken.
#[test]
fn repeated_stiffnesses_give_one_quality_whatever_the_axes() {
    let r = &mut Random::new(56);
    let mut of_printed = Vec::new();
    for _ in 0..40 {
        let turn = spatial::rotation(r.array(3.0).into());
        let points: Vec<_> =
            cube().into_iter().map(|p| (turn * Vector::new(p)).to_array()).collect();
        let body = ExtremePoints::new(&points).unwrap();
        let principal = isotropic(30.0, [4.0; 3]);
        let quality = Quality::of(&principal, &body).unwrap();
        assert!(quality.degenerate);
        // About a diagonal of a face corners are at the distance sqrt(3).
        assert_close(quality.value, 4.0 / 3.0, 1e-14, 1.0, "Q");
        // What (16) gives for the axes at hand.
        let of_axis = |axis: Vector<3>| {
            let reach = points.iter().map(|&p| spatial::cross(axis, p.into()).norm_squared());
            4.0 / reach.fold(0.0, f64::max)
        };
        let axes = principal.rotational().vectors;
        of_printed.push(axes.into_iter().map(of_axis).fold(f64::INFINITY, f64::min));
    }
    let least = of_printed.iter().copied().fold(f64::INFINITY, f64::min);
    let most = of_printed.iter().copied().fold(0.0, f64::max);
    assert!(least >= 4.0 / 3.0 - 1e-12 && most > 1.1 * least, "{least} {most}");
}

/// Two equal stiffnesses of three, and a gap that is just one or just none.
#[test]
fn the_cluster_convention_holds_for_pairs_and_ends_at_its_tolerance() {
    let body = ExtremePoints::new(&cube()).unwrap();
    // Rotations about x and y: the diagonals of the faces z = +-1 reach sqrt(3), x and y sqrt(2).
    let pair = Quality::of(&isotropic(30.0, [4.0, 4.0, 5.0]), &body).unwrap();
    assert!(pair.degenerate);
    assert_close(pair.rotations[0].value, 4.0 / 3.0, 1e-14, 1.0, "pair");
    assert_eq!(pair.rotations[0], pair.rotations[1]);
    assert_eq!(pair.rotations.map(|rotation| rotation.multiplicity), [2, 2, 1]);
    assert_close(pair.rotations[2].value, 5.0 / 2.0, 1e-14, 1.0, "single");
    // The chain of gaps counts, not the whole spread.
    let gap = 1e-9;
    let chain = isotropic(30.0, [4.0, 4.0 * (1.0 + 0.9 * gap), 4.0 * (1.0 + 1.8 * gap)]);
    assert!((Quality::of(&chain, &body).unwrap().value - 4.0 / 3.0).abs() < 1e-8);
    let apart = isotropic(30.0, [4.0, 4.0 * (1.0 + 2.0 * gap), 4.0 * (1.0 + 4.0 * gap)]);
    let quality = Quality::of(&apart, &body).unwrap();
    assert!(!quality.degenerate);
    assert!((quality.value - 2.0).abs() < 1e-7);
}

/// The cluster convention is the least over all rotations of the eigenspace.
#[test]
fn a_cluster_has_the_least_equivalent_stiffness_of_its_rotations() {
    let r = &mut Random::new(57);
    for _ in 0..30 {
        // Two equal stiffnesses of rotations that carry the body along: K_V and P_1 are chosen, and
        // K_22 = K_V + P_1^T K_11 P_1.
        let turn = spatial::rotation(r.array(3.0).into());
        let repeated = Mat::new([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 50.0]]);
        let restricted = turn * repeated * turn.transpose();
        let map = Mat::<3, 3>::new([r.array(0.5), r.array(0.5), r.array(0.5)]);
        let stiffness = Stiffness {
            translational: Mat::IDENTITY * 1e3,
            coupling: map * -1e3,
            rotational: restricted + map.transpose() * map * 1e3,
        };
        let principal = Principal::of(Vector::ZERO, &stiffness).unwrap();
        let points = corners::<3>(8, r);
        let body = ExtremePoints::new(&points).unwrap();
        let quality = Quality::of(&principal, &body).unwrap();
        let [one, other, _] = principal.rotational().vectors;
        let equivalent = |angle: f64| {
            let rotation = one * angle.cos() + other * angle.sin();
            let twist = principal.force_free_twist(rotation);
            let moved = points.iter().map(|&p| twist.velocity_at(p.into()).norm_squared());
            let stiffness = *principal.restricted_stiffness();
            rotation.dot(stiffness * rotation) / moved.fold(0.0, f64::max)
        };
        let trial = (0..2000).map(|i| equivalent(f64::from(i) * TAU / 4000.0));
        let trial = trial.fold(f64::INFINITY, f64::min);
        let found = quality.rotations[0].value;
        assert!(quality.degenerate);
        assert!(found <= trial * (1.0 + 1e-12) && found >= trial * 0.999, "{found} {trial}");
    }
}

#[test]
fn quality_is_the_smaller_of_its_two_stiffnesses() {
    let square = Polygon::new(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]).unwrap();
    let quality = |mu: f64| {
        let mut stiffness = Stiffness::<2, 1>::ZERO;
        stiffness.translational = [[3.0, 0.0], [0.0, 4.0]].into();
        stiffness.rotational = [[mu]].into();
        Quality::of(&Principal::of(Vector::ZERO, &stiffness).unwrap(), &square).unwrap()
    };
    // The corners are at a squared distance of 2.
    let (soft, stiff) = (quality(4.0), quality(40.0));
    assert_eq!(soft.limited_by, LimitedBy::Rotation);
    assert_close(soft.value, 2.0, 1e-15, 2.0, "mu_eq");
    assert_eq!(stiff.limited_by, LimitedBy::Translation);
    assert_close(stiff.value, 3.0, 1e-15, 3.0, "sigma_min");
}

/// With thousands of corners the search by the tree finds what looking at all finds.
#[test]
fn bodies_of_many_corners_have_the_measures_of_all_their_corners() {
    let r = &mut Random::new(58);
    for round in 0..6 {
        let principal = principal::<3, 3>(&springs::<3>(7, r)).unwrap();
        let stretch = r.array::<3>(1.0);
        let points: Vec<[f64; 3]> = (0..3000)
            .map(|_| {
                let unit = Vector::<3>::from(r.array(1.0)).direction().unwrap();
                [0, 1, 2].map(|i| unit[i] * (1.0 + 0.5 * stretch[i]) + f64::from(round) * 0.1)
            })
            .collect();
        let body = ExtremePoints::new(&points).unwrap();
        assert!(body.points().len() > 2900);
        let (mut worst, mut least) = (f64::INFINITY, f64::INFINITY);
        for &point in &points {
            let one = ExtremePoints::new(&[point]).unwrap();
            worst = worst.min(WorstPoint::of(&principal, &one).unwrap().stiffness);
            least = least.min(EquivalentStiffness::least(&principal, &one).unwrap().value);
        }
        let found = WorstPoint::of(&principal, &body).unwrap().stiffness;
        assert_close(found, worst, 1e-14, worst, "Q_pt");
        let found = EquivalentStiffness::least(&principal, Extent::from(&body)).unwrap().value;
        assert_close(found, least, 1e-14, least, "Q_V");
    }
}

/// Where nearly all directions tie, the same value is found in every frame, with its own point.
#[test]
fn nearly_round_bodies_have_the_same_measures_in_every_frame() {
    let r = &mut Random::new(59);
    for round in 0..12 {
        let size = [1e-2, 1e-3][round % 2];
        let near_one = |r: &mut Random| r.array::<3>(size).map(|x| 1.0 + x);
        let mu = near_one(r);
        let principal = isotropic(50.0, mu);
        let body = Ellipsoid::new(Vector::ZERO, near_one(r)).unwrap();
        let frame = spatial::Frame::new([0.0; 3], r.array(2.0));
        let (there, turned) = (principal.in_frame(&frame.inverse()), body.placed(&frame));
        let least = EquivalentStiffness::least(&principal, &body).unwrap();
        let in_frame = EquivalentStiffness::least(&there, &turned).unwrap();
        assert_close(in_frame.value, least.value, 1e-11, least.value, "Q_V");
        let [worst, in_frame] =
            [WorstPoint::of(&principal, &body), WorstPoint::of(&there, &turned)];
        let worst = worst.unwrap().stiffness;
        assert_close(in_frame.unwrap().stiffness, worst, 1e-11, worst, "Q_pt");
        let fastest =
            Extent::from(&body).fastest(Vector::ZERO, &principal.force_free_twist(least.rotation));
        assert_close(fastest.value, least.farthest.value, 1e-10, fastest.value, "farthest");
        let quality = Quality::of(&principal, &body).unwrap();
        assert!(least.value <= quality.equivalent() * (1.0 + 1e-15));
    }
}

/// A probe beside a screw axis with a large pitch: the difference of squares has lost its distance.
#[test]
fn the_reach_of_a_slender_body_keeps_its_digits() {
    for (pitch, reach) in [(1.0, 1e-3), (1.0, 1e-6), (1e3, 1.0)] {
        // Turning about x moves the body along x by the pitch.
        let map = Mat::new([[pitch, 0.0, 0.0], [0.0; 3], [0.0; 3]]);
        let stiffness = Stiffness {
            translational: Mat::IDENTITY,
            coupling: map * -1.0,
            rotational: Mat::new([[1.0, 0.0, 0.0], [0.0, 1e9, 0.0], [0.0, 0.0, 2e9]])
                + map.transpose() * map,
        };
        let principal = Principal::of(Vector::ZERO, &stiffness).unwrap();
        let probe = ExtremePoints::new(&[[0.0, reach, 0.0]]).unwrap();
        let softest = Quality::of(&principal, &probe).unwrap().rotations[0];
        assert_close(softest.reach, reach, 1e-9, reach, "reach");
    }
}
