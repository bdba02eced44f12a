//! A case from another field: the shear center and the tension center of a beam's section follow
//! from its 6 x 6 stiffness by the same elimination.

use clench_metrics::Principal;
use clench_screw::{Axis, Screw, Stiffness, Vector};

/// The section of a wind turbine's blade in the tests of the `OpenFAST` toolbox (`converters`,
/// `test_BD_H2`): strains and curvatures in the order shear x, shear y, axial, bending x,
/// bending y, torsion; in N, N m and N m^2.
fn section() -> Stiffness<3, 3> {
    let rows = [
        [3.221_147_34e9, 3.256_715_41e7, 0.0, 0.0, 0.0, -4.996_684_23e7],
        [3.256_715_41e7, 2.436_486_38e9, 0.0, 0.0, 0.0, 3.717_843_04e7],
        [0.0, 0.0, 2.443_256_80e10, 1.907_035_65e8, 1.780_861_38e9, 0.0],
        [0.0, 0.0, 1.907_035_65e8, 4.840_651_53e10, 4.600_618_48e9, 0.0],
        [0.0, 0.0, 1.780_861_38e9, 4.600_618_48e9, 5.236_887_67e10, 0.0],
        [-4.996_684_23e7, 3.717_843_04e7, 0.0, 0.0, 0.0, 2.331_488_98e10],
    ];
    Stiffness::from_fn(|i, j| rows[i][j])
}

/// The digits that the toolbox compares to.
const DIGITS: f64 = 0.5e-6;

fn axis(screw: Screw) -> Axis {
    let Screw::Axis { axis, .. } = screw else { panic!("{screw:?}") };
    axis
}

#[test]
fn torsion_without_force_turns_about_the_shear_center() {
    let principal = Principal::of(Vector::ZERO, &section()).unwrap();
    let torsion = axis(principal.force_free_twist([0.0, 0.0, 1.0].into()).screw());
    assert!((torsion.point[0] - 0.015_468_467).abs() < DIGITS, "{:?}", torsion.point);
    assert!((torsion.point[1] - 0.015_668_518).abs() < DIGITS);
}

#[test]
fn an_axial_force_through_the_tension_center_does_not_bend() {
    let principal = Principal::of(Vector::ZERO, &section()).unwrap();
    let pull = axis(principal.rotation_free_wrench([0.0, 0.0, 1.0].into()).screw());
    assert!((pull.point[0] + 0.072_888_833).abs() < DIGITS, "{:?}", pull.point);
    assert!((pull.point[1] - 0.007_805_302).abs() < DIGITS);
    // The wrench-compliant axis along z is the same line.
    let stiffest = principal.wrench_axes()[2];
    assert!((stiffest.point - pull.point).norm() < 1e-12);
}

/// The principal axes of bending about the tension center, which are those of `K_V`.
#[test]
fn bending_has_the_principal_axes_of_the_section() {
    let principal = Principal::of(Vector::ZERO, &section()).unwrap();
    // The two stiffest rotations; the softest is torsion.
    let [_, _, stiffest] = principal.rotational().vectors;
    let angle = (stiffest[1] / stiffest[0]).atan();
    let off = (angle + 0.587_455_776).abs();
    let quarter = (off - std::f64::consts::FRAC_PI_2).abs();
    assert!(off.min(quarter) < DIGITS, "{angle}");
}
