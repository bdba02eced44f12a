//! Degenerate and extreme input, each with its exact answer or error.

use clench_screw::{Cholesky, Mat, Screw, ScrewError, SymmetricEigen, Vector, planar, spatial};

#[test]
fn a_semidefinite_matrix_is_refused_at_the_pivot_that_fails() {
    let a = Mat::new([[4.0, 2.0], [2.0, 1.0]]);
    let expected = ScrewError::NotPositiveDefinite { pivot: 1, value: 0.0, diagonal: 1.0 };
    assert_eq!(Cholesky::new(&a), Err(expected));
    let third = 1.0 / 3.0;
    let nearly = Mat::new([[1.0, third], [third, third * third]]);
    assert!(matches!(
        Cholesky::new(&nearly),
        Err(ScrewError::NotPositiveDefinite { pivot: 1, .. })
    ));
    let message = expected.to_string();
    assert!(message.contains("pivot 1"), "{message}");
}

/// Squares of such numbers are zero, or overflow.
#[test]
fn tiny_and_huge_turns_are_turns_about_their_axes() {
    for size in [1e-170, 1e-155, 1.0, 1e155, 1e170] {
        let turn = planar::Twist { linear: [0.0, -2.0 * size].into(), angular: [size].into() };
        let Screw::Axis { axis, magnitude } = turn.screw() else { panic!("{size}") };
        assert!((magnitude / size - 1.0).abs() < 1e-15);
        assert!((axis.point[0] - 2.0).abs() < 1e-15 && axis.direction[2] == 1.0);
    }
}

#[test]
fn a_stiffness_in_si_units_is_not_called_singular() {
    let small = Mat::new([[2e-300, 1e-300], [1e-300, 2e-300]]);
    assert!(Cholesky::new(&small).is_ok());
    // Rows in different units: a force of 1e-6 and a torque of 1e12.
    let mixed = Mat::new([[1e-6, 5e2], [5e2, 1e12]]);
    assert!(Cholesky::new(&mixed).is_ok());
}

#[test]
fn numbers_that_are_not_finite_are_named_with_their_place() {
    let mut a = Mat::<3, 3>::IDENTITY;
    a[1][2] = f64::INFINITY;
    let expected = ScrewError::NotFinite { row: 1, column: 2, value: f64::INFINITY };
    assert_eq!(SymmetricEigen::new(&a), Err(expected));
    a[0][0] = f64::NAN;
    assert!(matches!(
        Cholesky::new(&a),
        Err(ScrewError::NotPositiveDefinite { pivot: 0, value, .. }) if value.is_nan()
    ));
}

#[test]
fn the_zero_matrix_has_the_standard_basis() {
    let eigen = SymmetricEigen::new(&Mat::<3, 3>::ZERO).unwrap();
    assert_eq!(eigen.values, [0.0; 3]);
    assert_eq!(eigen.vectors[2], Vector::new([0.0, 0.0, 1.0]));
}

#[test]
fn no_motion_and_no_load_have_no_screw() {
    assert_eq!(planar::Twist::ZERO.screw(), Screw::Zero);
    assert_eq!(spatial::Twist::ZERO.screw(), Screw::Zero);
    assert_eq!(spatial::Wrench::ZERO.screw(), Screw::Zero);
}

#[test]
fn lengths_and_directions_survive_any_size() {
    for size in [1e-300, 1.0, 1e300] {
        let v = Vector::new([3.0 * size, -4.0 * size]);
        assert!((v.scaled_norm() / size - 5.0).abs() < 1e-14, "{size:e}");
        let direction = v.direction().unwrap();
        assert!((direction - Vector::new([0.6, -0.8])).norm() < 1e-15, "{size:e}");
    }
    let none = [Vector::ZERO, Vector::new([f64::NAN, 0.0]), Vector::new([f64::INFINITY, 0.0])];
    assert_eq!(none.map(Vector::direction), [None; 3]);
    let [zero, nan, infinite] = none.map(Vector::scaled_norm);
    assert!(zero.to_bits() == 0 && nan.is_nan() && infinite == f64::INFINITY);
}
