//! The plane: two translations, one rotation (counter-clockwise positive).

use crate::{Mat, Vector};

/// A frame of the plane.
pub type Frame = crate::Frame<2, 1>;
/// A twist of the plane.
pub type Twist = crate::Twist<2, 1>;
/// A wrench of the plane.
pub type Wrench = crate::Wrench<2, 1>;
/// A stiffness of the plane.
pub type Stiffness = crate::Stiffness<2, 1>;

impl Frame {
    /// The frame at `origin`, turned counter-clockwise by `angle` (rad).
    #[must_use]
    pub fn new(origin: [f64; 2], angle: f64) -> Self {
        let (s, c) = angle.sin_cos();
        Self::from_parts(origin.into(), Mat::new([[c, -s], [s, c]]), Mat::IDENTITY)
    }
}

/// `a x b`, the signed area of the parallelogram; positive when `b` is to the left of `a`.
#[must_use]
pub fn cross(a: Vector<2>, b: Vector<2>) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// `v` turned by a quarter, counter-clockwise.
#[must_use]
pub fn quarter_turn(v: Vector<2>) -> Vector<2> {
    Vector::new([-v[1], v[0]])
}

/// Where a line is within `distance` (length) of a point: from and to, along the line from where
/// it starts (length). Both are equal where it only touches; `None` where it is never that near.
///
/// `way` leads from the start of the line to the point, `direction` is the line's (unit).
///
/// ```
/// use clench_screw::{Vector, planar};
/// let ahead = Vector::new([5.0, 3.0]);
/// assert_eq!(planar::chord(ahead, Vector::new([1.0, 0.0]), 5.0), Some([1.0, 9.0]));
/// assert_eq!(planar::chord(ahead, Vector::new([1.0, 0.0]), 2.0), None);
/// ```
#[must_use]
pub fn chord(way: Vector<2>, direction: Vector<2>, distance: f64) -> Option<[f64; 2]> {
    let across = cross(direction, way);
    // As a product, so that a line far away loses no digits.
    let half = ((distance - across) * (distance + across)).sqrt();
    let middle = direction.dot(way);
    // Not a number where it is never that near.
    (half >= 0.0).then_some([middle - half, middle + half])
}
