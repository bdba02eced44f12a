//! Twists and wrenches as vectors of six numbers.

use clench_screw::Vector;

/// The twist or wrench with these two parts.
pub(super) fn joined(first: Vector<3>, second: Vector<3>) -> Vector<6> {
    let ([a, b, c], [d, e, f]) = (first.to_array(), second.to_array());
    Vector::new([a, b, c, d, e, f])
}

/// The velocity or the force.
pub(super) fn first(vector: Vector<6>) -> Vector<3> {
    Vector::new([vector[0], vector[1], vector[2]])
}

/// The rotation or the torque.
pub(super) fn second(vector: Vector<6>) -> Vector<3> {
    Vector::new([vector[3], vector[4], vector[5]])
}
