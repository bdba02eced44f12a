//! Discs and balls.

use clench_screw::{Frame, Vector};

use crate::{BodyError, LARGEST_COORDINATE};

/// A disc (`N` = 2) or ball (`N` = 3); a point if its radius is 0.
///
/// ```
/// use clench_shape::Ball;
/// let disc = Ball::new([3.0, 0.0].into(), 2.0)?;
/// assert_eq!((disc.center()[0], disc.radius()), (3.0, 2.0));
/// # Ok::<(), clench_shape::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball<const N: usize> {
    center: Vector<N>,
    radius: f64,
}

impl<const N: usize> Ball<N> {
    /// The ball of this `radius` (length) about `center`.
    ///
    /// # Errors
    ///
    /// [`BodyError::PointOutOfRange`] for the center, counted as point 0, and
    /// [`BodyError::RadiusOutOfRange`].
    pub fn new(center: Vector<N>, radius: f64) -> Result<Self, BodyError> {
        BodyError::check_point(0, center)?;
        if !(0.0..=LARGEST_COORDINATE).contains(&radius) {
            return Err(BodyError::RadiusOutOfRange { radius });
        }
        Ok(Self { center, radius })
    }

    /// The ball given in the frame `pose`, written in the parent of `pose`.
    #[must_use]
    pub fn placed<const M: usize>(&self, pose: &Frame<N, M>) -> Self {
        Self { center: pose.point_to_parent(self.center), radius: self.radius }
    }

    /// The center.
    #[must_use]
    pub fn center(&self) -> Vector<N> {
        self.center
    }

    /// The radius (length).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }
}
