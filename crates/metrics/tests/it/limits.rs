//! Stiffnesses without principal parameters, each with the reason.

use clench_metrics::{
    Displacement, EquivalentStiffness, LimitedBy, MetricsError, Principal, Quality, WorstPoint,
};
use clench_screw::{Axis, Mat, ScrewError, Stiffness, Vector, Wrench};
use clench_shape::{Ellipsoid, ExtremePoints};

fn spring<const N: usize, const M: usize>(point: [f64; N], normal: [f64; N]) -> Stiffness<N, M> {
    Stiffness::outer(&Wrench::of_force_at(normal.into(), point.into()))
}

#[test]
fn a_free_translation_is_named_with_its_direction() {
    let stiffness = spring::<2, 1>([0.0, 0.0], [0.0, 1.0]) + spring([1.0, 0.0], [0.0, 1.0]);
    assert_eq!(
        Principal::of(Vector::ZERO, &stiffness),
        Err(MetricsError::TranslationNotHeld {
            direction: Vector::new([1.0, 0.0, 0.0]),
            value: 0.0,
            largest: 2.0
        })
    );
}

#[test]
fn a_free_rotation_is_named_with_its_center() {
    // Two springs through (2, 1).
    let about = |origin: Vector<2>| {
        let place = [2.0 - origin[0], 1.0 - origin[1]];
        spring::<2, 1>(place, [0.0, 1.0]) + spring(place, [1.0, 0.0])
    };
    let found = Principal::near(Vector::ZERO, about);
    let expected = MetricsError::RotationNotHeld {
        axis: Axis {
            direction: Vector::new([0.0, 0.0, 1.0]),
            point: Vector::new([2.0, 1.0, 0.0]),
            pitch: 0.0,
        },
        value: 0.0,
        scale: 5.0,
    };
    assert_eq!(found, Err(expected));
    assert!(expected.to_string().contains("rotation about [0.0, 0.0, 1.0]"));
}

#[test]
fn a_free_rotation_in_space_is_named_with_its_axis() {
    // All forces meet the z axis.
    let stiffness = spring::<3, 3>([0.0, 0.0, 1.0], [1.0, 0.0, 0.0])
        + spring([0.0, 0.0, -1.0], [1.0, 0.0, 0.0])
        + spring([0.0, 0.0, 1.0], [0.0, 1.0, 0.0])
        + spring([0.0, 0.0, -1.0], [0.0, 1.0, 0.0])
        + spring([0.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let found = Principal::of(Vector::ZERO, &stiffness);
    let Err(MetricsError::RotationNotHeld { axis, value, .. }) = found else { panic!("{found:?}") };
    assert_eq!((axis.direction.to_array(), value), ([0.0, 0.0, 1.0], 0.0));
}

#[test]
fn no_stiffness_at_all_holds_nothing() {
    let found = Principal::<2, 1>::of(Vector::ZERO, &Stiffness::ZERO);
    assert!(matches!(found, Err(MetricsError::TranslationNotHeld { largest: 0.0, .. })));
}

#[test]
fn a_stiffness_that_pushes_away_is_refused() {
    let mut stiffness = Stiffness::<2, 1>::ZERO;
    stiffness.translational = Mat::IDENTITY;
    stiffness.rotational = Mat::new([[-1.0]]);
    let found = Principal::of(Vector::ZERO, &stiffness);
    assert!(matches!(found, Err(MetricsError::RotationNotHeld { value: -1.0, .. })));
}

#[test]
fn entries_that_are_not_finite_are_refused() {
    let mut stiffness = Stiffness::<2, 1>::ZERO;
    stiffness.translational = Mat::IDENTITY;
    stiffness.rotational = Mat::new([[f64::INFINITY]]);
    let fault = ScrewError::NotFinite { row: 0, column: 0, value: f64::INFINITY };
    let found = Principal::of(Vector::ZERO, &stiffness);
    assert_eq!(found, Err(MetricsError::NotFinite(fault)));
}

/// A stiffness in SI units is small in numbers and not singular for that.
#[test]
fn tiny_numbers_are_not_taken_for_zero() {
    let mut stiffness = Stiffness::<2, 1>::ZERO;
    stiffness.translational = Mat::IDENTITY * 1e-30;
    stiffness.rotational = Mat::new([[1e-60]]);
    let principal = Principal::of(Vector::ZERO, &stiffness).unwrap();
    assert_eq!(principal.rotational().values, [1e-60]);
}

fn diagonal(sigma: f64, mu: f64) -> Principal<3, 3> {
    let stiffness = Stiffness {
        translational: Mat::IDENTITY * sigma,
        coupling: Mat::ZERO,
        rotational: Mat::IDENTITY * mu,
    };
    Principal::of(Vector::ZERO, &stiffness).unwrap()
}

/// A body of 1e130 on a stiffness of 1e-80 gives way by more than a double can say.
#[test]
fn a_stiffness_that_no_double_can_hold_is_refused() {
    let body = ExtremePoints::new(&[[1e130, 0.0, 0.0], [0.0, 1e130, 0.0]]).unwrap();
    let soft = diagonal(1.0, 1e-80);
    let out_of_range = |found| matches!(found, Err(MetricsError::OutOfRange { .. }));
    let quality = Quality::of(&soft, &body).map(|quality| quality.value);
    assert!(out_of_range(quality));
    assert!(out_of_range(EquivalentStiffness::least(&soft, &body).map(|least| least.value)));
    let worst = WorstPoint::of(&soft, &body).map(|worst| worst.stiffness);
    let (stiffness, deflection) = (0.0, f64::INFINITY);
    assert_eq!(worst, Err(MetricsError::OutOfRange { stiffness, deflection }));
    assert!(worst.unwrap_err().to_string().contains("in the range of doubles"));
}

/// Sizes of 1e-9 and 1e9 are ordinary.
#[test]
fn small_and_large_bodies_have_the_same_measures_in_their_units() {
    let cube = |size: f64| {
        let corner = |i: usize| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { size } else { -size });
        ExtremePoints::new(&(0..8).map(corner).collect::<Vec<_>>()).unwrap()
    };
    for size in [1e-9, 1.0, 1e9] {
        let principal = diagonal(3.0, 4.0 * size * size);
        let quality = Quality::of(&principal, &cube(size)).unwrap();
        assert!((quality.value - 4.0 / 3.0).abs() < 1e-14, "{quality:?}");
        let worst = WorstPoint::of(&principal, &cube(size)).unwrap();
        // 1 / 3 + 3 / 4
        assert!((1.0 / worst.stiffness - 13.0 / 12.0).abs() < 1e-14);
        let ball = Ellipsoid::new(Vector::ZERO, [size; 3]).unwrap();
        let least = EquivalentStiffness::least(&principal, &ball).unwrap();
        assert!((least.value - 4.0).abs() < 1e-13);
    }
}

/// A bar along a principal axis does not limit the turn about that axis; a point at the center of
/// compliance limits no turn at all.
#[test]
fn rotations_that_move_no_point_do_not_limit() {
    let stiffness = Stiffness {
        translational: Mat::IDENTITY * 3.0,
        coupling: Mat::ZERO,
        rotational: Mat::new([[4.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, 0.0, 6.0]]),
    };
    let principal = Principal::of(Vector::ZERO, &stiffness).unwrap();
    let bar = ExtremePoints::new(&[[-4.0, 0.0, 0.0], [4.0, 0.0, 0.0]]).unwrap();
    let quality = Quality::of(&principal, &bar).unwrap();
    assert_eq!(
        quality.rotations.map(|rotation| rotation.value),
        [f64::INFINITY, 5.0 / 16.0, 0.375]
    );
    assert_eq!(quality.value, 5.0 / 16.0);

    let point = ExtremePoints::new(&[[0.0; 3]]).unwrap();
    let quality = Quality::of(&principal, &point).unwrap();
    assert_eq!((quality.value, quality.limited_by), (3.0, LimitedBy::Translation));
    assert_eq!(EquivalentStiffness::least(&principal, &point).unwrap().value, f64::INFINITY);
    assert_eq!(WorstPoint::of(&principal, &point).unwrap().stiffness, 3.0);
}

/// A load that moves the body by more than a double can say.
#[test]
fn a_displacement_that_overflows_is_refused() {
    let body = ExtremePoints::new(&[[1e100, 0.0, 0.0]]).unwrap();
    let load = Wrench { force: Vector::ZERO, torque: Vector::new([0.0, 0.0, 1e250]) };
    let found = Displacement::of(&diagonal(1.0, 1.0), Vector::ZERO, &load, &body);
    let deflection = f64::INFINITY;
    assert_eq!(found, Err(MetricsError::OutOfRange { stiffness: 0.0, deflection }));
}

fn springs(given: &[([f64; 3], [f64; 3])]) -> impl Fn(Vector<3>) -> Stiffness<3, 3> + '_ {
    move |origin| {
        given.iter().fold(Stiffness::ZERO, |sum, &(point, normal)| {
            let arm = Vector::from(point) - origin;
            sum + Stiffness::outer(&Wrench::of_force_at(normal.into(), arm))
        })
    }
}

/// Five springs leave a rotation free. One translation is so soft that the canonical point is a
/// hundred body lengths away, where the rounding would pass for a stiffness.
#[test]
fn a_soft_translation_does_not_hide_a_free_rotation() {
    let t = 1.0 / 128.0;
    let given = [
        ([0.5, -0.5, 0.5], [-t, 0.0, 0.0]),
        ([-1.0, -1.0, -0.5], [t, -2.0, -1.0]),
        ([-0.5, 1.0, -1.0], [0.0, -1.0, 0.0]),
        ([1.0, 1.0, 0.5], [0.0, -1.0, -1.0]),
        ([-0.5, 0.5, 0.5], [t, 0.0, 0.0]),
    ];
    let found = Principal::near(Vector::ZERO, springs(&given));
    assert!(matches!(found, Err(MetricsError::RotationNotHeld { .. })), "{found:?}");
}

/// Six springs that hold all, the softest translation a millionth of the stiffest; `mu` by 40
/// digits.
#[test]
fn a_soft_translation_costs_no_digits() {
    let t = 1.0 / 1024.0;
    let given = [
        ([-0.5, 0.0, 0.0], [-t, -2.0, 2.0]),
        ([1.0, -0.5, 1.0], [-t, -2.0, -1.0]),
        ([0.0, 0.0, -1.0], [-2.0 * t, 2.0, -2.0]),
        ([1.0, 0.0, -0.5], [-2.0 * t, 2.0, -1.0]),
        ([1.0, -0.5, 0.0], [t, 0.0, 1.0]),
        ([-1.0, -1.0, 1.0], [2.0 * t, 1.0, -2.0]),
    ];
    let principal = Principal::near(Vector::ZERO, springs(&given)).unwrap();
    let mu = principal.rotational().values[0];
    assert!((mu / 0.148_419_884_713_252_63 - 1.0).abs() < 1e-12, "{mu}");
}

/// Two springs in the plane hold no turn about the point where they meet; nearly parallel ones
/// carry rounding of the stiff direction into `mu`.
#[test]
fn what_a_stiff_direction_rounds_is_not_a_rotational_stiffness() {
    let about = |origin: Vector<2>| {
        let spring = |point: [f64; 2], normal: [f64; 2]| {
            let arm = Vector::from(point) - origin;
            Stiffness::<2, 1>::outer(&Wrench::of_force_at(normal.into(), arm))
        };
        spring([0.5, 1.5], [0.6, 0.81]) + spring([0.0, -0.5], [0.61, 0.81])
    };
    for found in
        [Principal::of(Vector::ZERO, &about(Vector::ZERO)), Principal::near(Vector::ZERO, about)]
    {
        assert!(matches!(found, Err(MetricsError::RotationNotHeld { .. })), "{found:?}");
    }
}

/// Springs nearly along z: what little resists along x and y rounds as little, and does not hide
/// the stiffness of a turn about z. A thin ellipsoid on eight fingers; `mu` by 40 digits.
#[test]
fn the_small_stiffness_of_a_thin_body_is_not_taken_for_rounding() {
    let body = Ellipsoid::new(Vector::ZERO, [10.0, 9.0, 0.01]).unwrap();
    let points = [
        [-3.247_770_880_109_944_5, 7.852_679_297_595_093, 0.003_650_052_450_235_766],
        [-3.607_325_301_539_616, 3.530_080_198_756_114_6, -0.008_461_836_560_943_436],
        [5.746_543_823_958_116, -4.896_034_438_004_921, 0.006_114_181_691_825_133],
        [4.263_528_733_873_161, -6.704_922_057_549_375, 0.005_130_410_617_924_198],
        [1.604_919_494_536_538_8, -2.729_544_725_769_209, 0.009_392_879_799_859_39],
        [4.617_417_194_791_669, -6.125_342_903_988_017, -0.005_688_469_564_889_913],
        [3.718_247_293_332_446, 3.295_856_993_380_317_2, -0.008_530_177_563_342_508],
        [8.138_482_847_469_524, 0.584_445_984_752_376_7, -0.005_774_374_148_491_023],
    ];
    let about = |origin: Vector<3>| {
        points.iter().fold(Stiffness::<3, 3>::ZERO, |sum, &point| {
            let touched = body.nearest(point.into()).boundary;
            let arm = touched.point - origin;
            sum + Stiffness::outer(&Wrench::of_force_at(touched.inward_normal, arm)) * 1000.0
        })
    };
    let principal = Principal::near(Vector::ZERO, about).unwrap();
    let mu = principal.rotational().values[0];
    assert!((mu / 0.002_861_871_891_401_29 - 1.0).abs() < 1e-9, "{mu}");
}
