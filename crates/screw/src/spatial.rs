//! Space: three translations, three rotations.

use crate::{Mat, Vector, lever};

/// A frame of space.
pub type Frame = crate::Frame<3, 3>;
/// A twist of space.
pub type Twist = crate::Twist<3, 3>;
/// A wrench of space.
pub type Wrench = crate::Wrench<3, 3>;
/// A stiffness of space.
pub type Stiffness = crate::Stiffness<3, 3>;

/// Below this angle (rad) `(t - sin t) / t^3` is summed from its series, whose first term left
/// out is `t^12 / 15!`, below a unit of rounding of 1/6 here; above it, the subtraction loses at
/// most two digits.
const SERIES_ANGLE: f64 = 0.25;

impl Frame {
    /// The frame at `origin`, turned by `rotation_vector` (axis times angle (rad)).
    #[must_use]
    pub fn new(origin: [f64; 3], rotation_vector: [f64; 3]) -> Self {
        let turn = rotation(rotation_vector.into());
        Self::from_parts(origin.into(), turn, turn)
    }
}

/// `a x b`.
#[must_use]
pub fn cross(a: Vector<3>, b: Vector<3>) -> Vector<3> {
    lever(a) * b
}

/// The rotation matrix `exp(hat(theta))` of a rotation vector (rad).
///
/// `I + sin(t)/t hat + (1 - cos t)/t^2 hat^2` with `t = |theta|`, the last factor as
/// `2 (sin(t/2)/t)^2`, so that small angles keep all their digits.
#[must_use]
pub fn rotation(theta: Vector<3>) -> Mat<3, 3> {
    let t = theta.norm();
    let hat = lever(theta);
    Mat::IDENTITY + hat * sinc(t) + (hat * hat) * (0.5 * sinc(0.5 * t).powi(2))
}

/// The left Jacobian of the exponential map: `omega = left_jacobian(theta) * d(theta)/dt`.
///
/// It turns derivatives in the coordinates `theta` of [`rotation`] into angular velocities.
#[must_use]
pub fn left_jacobian(theta: Vector<3>) -> Mat<3, 3> {
    let t = theta.norm();
    let hat = lever(theta);
    let second = if t < SERIES_ANGLE {
        let x = t * t;
        let tail = 1.0 - x / 110.0 * (1.0 - x / 156.0);
        (1.0 - x / 20.0 * (1.0 - x / 42.0 * (1.0 - x / 72.0 * tail))) / 6.0
    } else {
        (t - t.sin()) / t.powi(3)
    };
    Mat::IDENTITY + hat * (0.5 * sinc(0.5 * t).powi(2)) + (hat * hat) * second
}

fn sinc(t: f64) -> f64 {
    if t > 0.0 { t.sin() / t } else { 1.0 }
}
