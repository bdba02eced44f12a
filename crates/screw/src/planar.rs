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
