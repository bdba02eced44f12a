//! What a load does to a body.

use clench_screw::{Twist, Vector, Wrench};
use clench_shape::{Extent, Extreme};

use crate::Principal;

/// The displacement of a body by a load, as far as it is proportional to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deflection<const N: usize, const M: usize> {
    /// The displacement about the frame's origin (length, rad).
    pub twist: Twist<N, M>,
    /// The point of the body that moves most, and how far (length).
    pub largest: Extreme<N>,
}

impl<const N: usize, const M: usize> Deflection<N, M> {
    /// What `load`, an external wrench about the frame's origin, does to `body`.
    ///
    /// ```
    /// use clench_metrics::{Deflection, Principal};
    /// use clench_screw::{Mat, Stiffness, Vector, Wrench};
    /// use clench_shape::Extremes;
    /// let stiffness = Stiffness::<2, 1> {
    ///     translational: Mat::IDENTITY * 100.0,
    ///     coupling: Mat::ZERO,
    ///     rotational: Mat::new([[800.0]]),
    /// };
    /// let principal = Principal::of(Vector::ZERO, &stiffness)?;
    /// let bar = Extremes::new(&[[-4.0, 0.0], [4.0, 0.0]])?;
    /// // 2 along y at the right end: 0.02 everywhere, and a turn of 8 / 800.
    /// let load = Wrench::of_force_at([0.0, 2.0].into(), [4.0, 0.0].into());
    /// let deflection = Deflection::of(&principal, &load, &bar);
    /// assert!((deflection.largest.value - 0.06).abs() < 1e-15);
    /// assert!((deflection.at([-4.0, 0.0].into())[1] + 0.02).abs() < 1e-15);
    /// // The right end may move by 0.15: the load may be 2.5 times as large.
    /// assert!((deflection.margin(0.15) - 2.5).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn of<'a>(
        principal: &Principal<N, M>,
        load: &Wrench<N, M>,
        body: impl Into<Extent<'a, N>>,
    ) -> Self {
        let twist = principal.displacement(load);
        Self { twist, largest: body.into().fastest(Vector::ZERO, &twist) }
    }

    /// The displacement of the body point at `point` (length).
    #[must_use]
    pub fn at(&self, point: Vector<N>) -> Vector<N> {
        self.twist.velocity_at(point)
    }

    /// How many times the load can grow before a point of the body moves by more than `tolerance`
    /// (length): below 1 the load itself is too large. Infinite for a load that moves nothing.
    #[must_use]
    pub fn margin(&self, tolerance: f64) -> f64 {
        tolerance / self.largest.value
    }
}
