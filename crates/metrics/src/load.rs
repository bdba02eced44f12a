//! What a load does to a body.

use clench_screw::{Twist, Vector, Wrench};
use clench_shape::{Extent, Farthest};

use crate::{MetricsError, Principal};

/// The displacement of a body by a load, as far as it is proportional to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Displacement<const N: usize, const M: usize> {
    /// The origin that the twist is written about.
    pub origin: Vector<N>,
    /// The displacement about it (length, rad).
    pub twist: Twist<N, M>,
    /// The point of the body that moves most, and how far (length).
    pub largest: Farthest<N>,
}

impl<const N: usize, const M: usize> Displacement<N, M> {
    /// What `load`, an external wrench about `origin`, does to `body`.
    ///
    /// Take an origin near the body, and form the load about it: see [`Principal::displacement`].
    ///
    /// ```
    /// use clench_metrics::{Displacement, Principal};
    /// use clench_screw::{Mat, Stiffness, Vector, Wrench};
    /// use clench_shape::ExtremePoints;
    /// let stiffness = Stiffness::<2, 1> {
    ///     translational: Mat::IDENTITY * 100.0,
    ///     coupling: Mat::ZERO,
    ///     rotational: Mat::new([[800.0]]),
    /// };
    /// let principal = Principal::of(Vector::ZERO, &stiffness)?;
    /// let bar = ExtremePoints::new(&[[-4.0, 0.0], [4.0, 0.0]])?;
    /// // 2 along y at the right end: 0.02 everywhere, and a turn of 8 / 800.
    /// let load = Wrench::of_force_at([0.0, 2.0].into(), [4.0, 0.0].into());
    /// let displacement = Displacement::of(&principal, Vector::ZERO, &load, &bar)?;
    /// assert!((displacement.largest.value - 0.06).abs() < 1e-15);
    /// assert!((displacement.at([-4.0, 0.0].into())[1] + 0.02).abs() < 1e-15);
    /// // The right end may move by 0.15: the load may be 2.5 times as large.
    /// assert!((displacement.margin(0.15) - 2.5).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`MetricsError::OutOfRange`] when a point would move by more than a double can say.
    pub fn of<'a>(
        principal: &Principal<N, M>,
        origin: Vector<N>,
        load: &Wrench<N, M>,
        body: impl Into<Extent<'a, N>>,
    ) -> Result<Self, MetricsError> {
        let twist = principal.displacement(origin, load);
        let largest = body.into().fastest(origin, &twist);
        if largest.value.is_finite() {
            return Ok(Self { origin, twist, largest });
        }
        Err(MetricsError::OutOfRange { stiffness: 0.0, deflection: largest.value })
    }

    /// The displacement of the body point at `point` (length).
    #[must_use]
    pub fn at(&self, point: Vector<N>) -> Vector<N> {
        self.twist.velocity_at(point - self.origin)
    }

    /// How many times the load can grow before a point of the body moves by more than `tolerance`
    /// (length): below 1 the load itself is too large. Infinite for a load that moves nothing.
    ///
    /// That no contact lifts off before is not looked at.
    #[must_use]
    pub fn margin(&self, tolerance: f64) -> f64 {
        tolerance / self.largest.value
    }
}
