//! Stiffnesses without principal parameters, each with the reason.

use clench_metrics::{MetricsError, Principal};
use clench_screw::{Mat, ScrewError, Stiffness, Vector, Wrench};

fn spring<const N: usize, const M: usize>(point: [f64; N], normal: [f64; N]) -> Stiffness<N, M> {
    Stiffness::outer(&Wrench::of_force_at(normal.into(), point.into()))
}

#[test]
fn a_free_translation_is_named_with_its_direction() {
    let stiffness = spring::<2, 1>([0.0, 0.0], [0.0, 1.0]) + spring([1.0, 0.0], [0.0, 1.0]);
    assert_eq!(
        Principal::of(Vector::ZERO, &stiffness),
        Err(MetricsError::TranslationNotHeld {
            direction: [1.0, 0.0, 0.0],
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
        axis: [0.0, 0.0, 1.0],
        point: [2.0, 1.0, 0.0],
        pitch: 0.0,
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
    assert_eq!((axis, value), ([0.0, 0.0, 1.0], 0.0));
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
