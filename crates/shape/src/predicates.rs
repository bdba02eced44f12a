//! Signs of geometric tests, decided exactly.

use clench_screw::Vector;

/// The doubled signed area of `a b c`: positive for a left turn, zero on one line only.
///
/// The sign is exact for coordinates within the limits of `validity`; the value is good to a few
/// roundings of `|a - c| |b - c|`.
pub(crate) fn turn(a: Vector<2>, b: Vector<2>, c: Vector<2>) -> f64 {
    robust::orient2d(coord(a), coord(b), coord(c))
}

/// Six times the signed volume over `a b c`: positive for `d` on the side from which they run
/// counter-clockwise, zero in one plane only.
///
/// The sign is exact when the coordinates are of the order of 1. A product of three differences
/// below 1e-300 can round to zero; to their user such points are in the plane.
pub(crate) fn above(a: Vector<3>, b: Vector<3>, c: Vector<3>, d: Vector<3>) -> f64 {
    let [a, b, c, d] = [a, b, c, d].map(|v| robust::Coord3D { x: v[0], y: v[1], z: v[2] });
    -robust::orient3d(a, b, c, d)
}

/// Positive for `point` inside the circle through `a b c` (counter-clockwise), negative outside.
///
/// The sign is exact when the coordinates are of the order of 1. A product of four differences
/// below 1e-300 can round to zero; to their user such points are on the circle.
pub(crate) fn in_circle([a, b, c]: [Vector<2>; 3], point: Vector<2>) -> f64 {
    robust::incircle(coord(a), coord(b), coord(c), coord(point))
}

/// The power of two that brings `magnitude`, a normal positive number, to between 1 and 2.
///
/// Multiplying by it is exact, so that no decision depends on the unit of length.
pub(crate) fn unit_scale(magnitude: f64) -> f64 {
    const EXPONENT: u32 = f64::MANTISSA_DIGITS - 1;
    let exponent = magnitude.to_bits() >> EXPONENT;
    let bias = 1.0_f64.to_bits() >> EXPONENT;
    f64::from_bits((2 * bias - exponent) << EXPONENT)
}

fn coord(v: Vector<2>) -> robust::Coord<f64> {
    robust::Coord { x: v[0], y: v[1] }
}
