//! Derivatives where measures have kinks, and where they have none.

use clench_metrics::{
    EquivalentStiffness, Freedom, MetricsError, Principal, Quality, Sensitivity, Variation,
    WorstPoint,
};
use clench_screw::{Mat, Stiffness, Vector, Wrench};
use clench_shape::{Ellipsoid, Extent, ExtremePoints, Polygon};
use clench_testkit::{Random, assert_close};

use crate::springs::{corners, principal, springs};

/// One-sided differences err by this times a second derivative: entries here are of size 1, the
/// second derivatives of size 10, and the rounding over the step is 1e-9.
const STEP: f64 = 1e-6;

/// A change of any sign.
fn change<const N: usize, const M: usize>(r: &mut Random) -> Stiffness<N, M> {
    let wrench =
        |r: &mut Random| Wrench::<N, M>::of_force_at(r.array(1.0).into(), r.array(1.0).into());
    (0..N + M).fold(Stiffness::ZERO, |sum, i| {
        let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
        sum + Stiffness::outer(&wrench(r)) * sign
    })
}

/// `sigma_min`, `Q_V`, `Q_pt` and `Q`.
fn measures<const N: usize, const M: usize>(
    stiffness: &Stiffness<N, M>,
    body: Extent<'_, N>,
) -> [f64; 4] {
    let principal = Principal::of(Vector::ZERO, stiffness).unwrap();
    [
        principal.translational().values[0],
        EquivalentStiffness::least(&principal, body).unwrap().value,
        WorstPoint::of(&principal, body).unwrap().stiffness,
        Quality::of(&principal, body).unwrap().value,
    ]
}

type Found<const N: usize, const M: usize> = [Result<Sensitivity<N, M>, MetricsError>; 4];

fn sensitivities<const N: usize, const M: usize>(
    stiffness: &Stiffness<N, M>,
    body: Extent<'_, N>,
) -> Found<N, M> {
    let principal = Principal::of(Vector::ZERO, stiffness).unwrap();
    let least = EquivalentStiffness::least(&principal, body).unwrap();
    let worst = WorstPoint::of(&principal, body).unwrap();
    let quality = Quality::of(&principal, body).unwrap();
    [
        Ok(Sensitivity::of_translation(&principal)),
        Sensitivity::of_least(&principal, &least, body),
        Sensitivity::of_worst_point(&principal, &worst, body),
        Sensitivity::of_quality(&principal, &quality, body),
    ]
}

/// One-sided differences of those measures that have a derivative.
fn check_one_sided<const N: usize, const M: usize>(
    stiffness: &Stiffness<N, M>,
    body: Extent<'_, N>,
    r: &mut Random,
) {
    let found = sensitivities(stiffness, body);
    let rest = measures(stiffness, body);
    for _ in 0..20 {
        let change = change::<N, M>(r);
        for sign in [1.0, -1.0] {
            let moved = measures(&(*stiffness + change * (sign * STEP)), body);
            for (i, sensitivity) in found.iter().enumerate() {
                let Ok(sensitivity) = sensitivity else { continue };
                let wanted = (moved[i] - rest[i]) / STEP;
                let along = sensitivity.along(&(change * sign));
                assert_close(along, wanted, 1e-4, 1.0, format_args!("measure {i}"));
            }
        }
    }
}

fn isotropic<const N: usize, const M: usize>(sigma: f64, mu: f64) -> Stiffness<N, M> {
    Stiffness {
        translational: Mat::IDENTITY * sigma,
        coupling: Mat::ZERO,
        rotational: Mat::IDENTITY * mu,
    }
}

/// Two directions and four corners tie, and at a stiffness of 4 so do translation and rotation.
#[test]
fn a_square_held_at_its_center_has_one_sided_derivatives() {
    let square = Polygon::new(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]).unwrap();
    let r = &mut Random::new(101);
    for mu in [4.0, 1.0, 40.0] {
        let stiffness = isotropic::<2, 1>(2.0, mu);
        check_one_sided(&stiffness, (&square).into(), r);
        for sensitivity in sensitivities(&stiffness, (&square).into()) {
            assert!(!sensitivity.unwrap().is_smooth());
        }
    }
    // About each corner: a spring there along x adds 1 to that corner's way, none to the others.
    let worst = sensitivities(&isotropic::<2, 1>(2.0, 4.0), (&square).into())[2].clone().unwrap();
    assert_eq!(worst.origin(), Vector::ZERO);
    // More of all is as much more of each measure: q^T K q is the measure itself.
    let more = worst.along(&isotropic::<2, 1>(2.0, 4.0));
    assert_close(more, 1.0, 1e-14, 1.0, "in proportion");
    // A kink: no change is good and bad in proportion.
    let spring = Stiffness::outer(&Wrench::of_force_at([1.0, 0.0].into(), [1.0, 1.0].into()));
    assert_eq!(worst.along(&spring), 0.0);
    assert!(worst.along(&(spring * -1.0)) < -0.1);
}

#[test]
fn a_cube_held_alike_from_all_sides_has_them_but_for_the_quality() {
    let corner = |i: i32| [0, 1, 2].map(|axis| f64::from(i >> axis & 1) * 2.0 - 1.0);
    let cube = ExtremePoints::new(&[0, 1, 2, 3, 4, 5, 6, 7].map(corner)).unwrap();
    let r = &mut Random::new(102);
    // Rotations limit the first, and repeat: the quality jumps.
    let jumps = isotropic::<3, 3>(9.0, 4.0);
    check_one_sided(&jumps, (&cube).into(), r);
    let found = sensitivities(&jumps, (&cube).into())[3].clone();
    assert_eq!(found, Err(MetricsError::QualityJumps { multiplicity: 3 }));
    // Translations limit the second, and it has a derivative.
    let held = isotropic::<3, 3>(1.0, 9.0);
    check_one_sided(&held, (&cube).into(), r);
    assert!(sensitivities(&held, (&cube).into())[3].is_ok());
}

#[test]
fn opposite_ends_of_an_ellipse_tie_and_all_of_a_disc_do() {
    let ellipse = Ellipsoid::new(Vector::ZERO, [2.0, 1.0]).unwrap();
    let r = &mut Random::new(103);
    let mut stiffness = isotropic::<2, 1>(2.0, 4.0);
    stiffness.translational[0][0] = 2.5;
    check_one_sided(&stiffness, (&ellipse).into(), r);
    let found = sensitivities(&stiffness, (&ellipse).into());
    assert!(found[0].clone().unwrap().is_smooth());
    for tied in &found[1..] {
        assert!(!tied.clone().unwrap().is_smooth());
    }
    let disc = Ellipsoid::new(Vector::ZERO, [2.0, 2.0]).unwrap();
    let found = sensitivities(&isotropic::<2, 1>(2.0, 4.0), (&disc).into());
    for tied in &found[1..] {
        assert_eq!(tied.clone(), Err(MetricsError::TiesWithoutEnd));
    }
    // In space the two ends of a barrel, held at its center; both are as far from the axes.
    let barrel = Ellipsoid::new(Vector::ZERO, [1.0, 1.3, 3.0]).unwrap();
    let mut stiffness = isotropic::<3, 3>(2.0, 4.0);
    for i in 0..3 {
        stiffness.translational[i][i] += 0.3 * i as f64;
        stiffness.rotational[i][i] += 0.4 * i as f64;
    }
    check_one_sided(&stiffness, (&barrel).into(), r);
}

/// Along all directions of a plane of changes, for a measure with kinks and one without.
fn the_steepest_step_is_the_best_of_many<const N: usize, const M: usize>(
    stiffness: &Stiffness<N, M>,
    body: Extent<'_, N>,
    r: &mut Random,
) {
    for sensitivity in sensitivities(stiffness, body).into_iter().flatten() {
        for _ in 0..10 {
            let rates = [change::<N, M>(r), change::<N, M>(r)];
            let freedom = Freedom::Plane(rates);
            let rate =
                |angle: f64| sensitivity.along(&(rates[0] * angle.cos() + rates[1] * angle.sin()));
            let all = (0..2_000).map(|i| rate(f64::from(i) * std::f64::consts::TAU / 2_000.0));
            let (rise, fall) = all.fold((f64::MIN, f64::MAX), |(m, l), x| (m.max(x), l.min(x)));
            let (up, down) =
                (sensitivity.steepest_rise(&freedom), sensitivity.steepest_fall(&freedom));
            // A direction 1.6e-3 off, where a slope of size 10 has a kink; the square elsewhere.
            assert!(up.rate >= rise - 1e-12, "{} {rise}", up.rate);
            assert!(down.rate <= fall + 1e-12, "{} {fall}", down.rate);
            assert!(up.rate <= rise + 2e-2 && down.rate >= fall - 2e-2);
            for steepest in [up, down] {
                let [s, t] = steepest.step;
                assert_close(s.hypot(t), 1.0, 1e-14, 1.0, "unit step");
                let there = sensitivity.along(&(rates[0] * s + rates[1] * t));
                assert_close(there, steepest.rate, 1e-12, 10.0, "rate");
            }
            let line = sensitivity.steepest_rise(&Freedom::Line(rates[0]));
            assert_eq!(line.rate, rate(0.0).max(sensitivity.along(&(rates[0] * -1.0))));
        }
    }
}

#[test]
fn the_steepest_step_is_the_best_of_many_smooth_or_not() {
    let r = &mut Random::new(104);
    let square = Polygon::new(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]).unwrap();
    the_steepest_step_is_the_best_of_many(&isotropic::<2, 1>(2.0, 4.0), (&square).into(), r);
    let corner = |i: i32| [0, 1, 2].map(|axis| f64::from(i >> axis & 1) * 2.0 - 1.0);
    let cube = ExtremePoints::new(&[0, 1, 2, 3, 4, 5, 6, 7].map(corner)).unwrap();
    the_steepest_step_is_the_best_of_many(&isotropic::<3, 3>(1.0, 9.0), (&cube).into(), r);
    let points = corners::<3>(8, r);
    let body = ExtremePoints::new(&points).unwrap();
    let mut random = isotropic::<3, 3>(1.0, 1.0);
    random += change(r) * 0.02;
    the_steepest_step_is_the_best_of_many(&random, (&body).into(), r);
}

/// With several corners that tie: by all corners of the box of changes, of which one is the worst.
#[test]
fn the_worst_case_of_a_kink_is_that_of_all_corners_of_the_box() {
    let square = Polygon::new(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]).unwrap();
    let r = &mut Random::new(106);
    // Rotation limits, and no translation ties.
    let mut stiffness = isotropic::<2, 1>(9.0, 4.0);
    stiffness.translational[0][0] = 11.0;
    let quality = sensitivities(&stiffness, (&square).into())[3].clone().unwrap();
    assert!(!quality.is_smooth());
    for _ in 0..20 {
        let variation = |r: &mut Random| {
            let freedom = Freedom::Line(change(r));
            Variation { freedom, tolerance: r.between(0.1, 1.0) }
        };
        let variations: Vec<_> = (0..4).map(|_| variation(r)).collect();
        let at = |signs: u32| {
            let sum = variations.iter().enumerate().fold(Stiffness::ZERO, |sum, (i, variation)| {
                let Freedom::Line(rate) = variation.freedom else { panic!("a line was made") };
                let sign = if signs >> i & 1 == 1 { 1.0 } else { -1.0 };
                sum + rate * (sign * variation.tolerance)
            });
            quality.along(&sum)
        };
        let least = (0..16).map(at).fold(f64::INFINITY, f64::min);
        let worst = quality.worst_case(&variations);
        assert_close(worst.change, least, 1e-12, least.abs(), "worst");
        // And its steps lead there.
        let signs = worst.steps.iter().enumerate();
        let signs = signs.map(|(i, step)| u32::from(step[0] > 0.0) << i).sum();
        assert_close(at(signs), least, 1e-12, least.abs(), "steps");
    }
}

/// All measures are homogeneous of degree one: in proportion to the stiffness, whatever it is.
#[test]
fn a_measure_is_its_own_derivative_along_the_stiffness() {
    let r = &mut Random::new(105);
    for _ in 0..20 {
        let springs = springs::<3>(7, r);
        let principal = principal::<3, 3>(&springs).unwrap();
        let points = corners::<3>(8, r);
        let body = ExtremePoints::new(&points).unwrap();
        let quality = Quality::of(&principal, &body).unwrap();
        let least = EquivalentStiffness::least(&principal, &body).unwrap();
        let worst = WorstPoint::of(&principal, &body).unwrap();
        for (sensitivity, value) in [
            (Sensitivity::of_quality(&principal, &quality, &body), quality.value),
            (Sensitivity::of_least(&principal, &least, &body), least.value),
            (Sensitivity::of_worst_point(&principal, &worst, &body), worst.stiffness),
        ] {
            let sensitivity = sensitivity.unwrap();
            let all = crate::springs::assembled(&springs, sensitivity.origin());
            assert_close(sensitivity.along(&all), value, 1e-9, value, "in proportion");
            // Softer by a tenth at worst; what is rounding beside it stays where it is.
            let freedom = Freedom::Line(all);
            let vary = |freedom| Variation { freedom, tolerance: 0.1 };
            let rounding = Freedom::Line(all * 1e-15);
            let worst = sensitivity.worst_case(&[vary(freedom), vary(rounding)]);
            assert_close(worst.change, -0.1 * value, 1e-9, value, "worst");
            assert_eq!(worst.steps, [[-0.1, 0.0], [0.0, 0.0]]);
            let gain = sensitivity.best_gain(&[freedom, Freedom::Line(all * 2.0)]).unwrap();
            assert_eq!((gain.freedom, gain.steepest.step), (1, [1.0, 0.0]));
            assert_eq!(sensitivity.best_gain(&[]), None);
        }
    }
}
