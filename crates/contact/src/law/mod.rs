//! Force laws: the contact force as a function of the overlap.

mod linear;
mod power;

pub use linear::Linear;
pub use power::Power;

use crate::ContactError;

/// How the contact force `f` follows from the overlap `delta >= 0`.
///
/// ```
/// use clench_contact::Law;
/// let law = Law::power(3.0, 2.0)?;
/// assert_eq!((law.force(2.0), law.slope(2.0), law.energy(2.0)), (12.0, 12.0, 8.0));
/// assert_eq!(law.overlap(12.0), 2.0);
/// # Ok::<(), clench_contact::ContactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Law {
    /// `f = k delta` [LBR, eq. 3].
    Linear(Linear),
    /// `f = c delta^p`.
    Power(Power),
}

impl Law {
    /// The linear law with `stiffness` (force / length).
    ///
    /// # Errors
    ///
    /// [`ContactError::NotPositive`] unless the stiffness is positive and finite.
    pub fn linear(stiffness: f64) -> Result<Self, ContactError> {
        Linear::new(stiffness).map(Self::Linear)
    }

    /// The power law with `coefficient` (force / length^exponent) and `exponent`.
    ///
    /// # Errors
    ///
    /// [`ContactError::NotPositive`] unless both are positive and finite.
    pub fn power(coefficient: f64, exponent: f64) -> Result<Self, ContactError> {
        Power::new(coefficient, exponent).map(Self::Power)
    }

    /// The force `f(delta)` of an overlap that is not negative.
    #[must_use]
    pub fn force(&self, overlap: f64) -> f64 {
        match self {
            Self::Linear(law) => law.force(overlap),
            Self::Power(law) => law.force(overlap),
        }
    }

    /// The slope `f'(delta)` (force / length).
    #[must_use]
    pub fn slope(&self, overlap: f64) -> f64 {
        match self {
            Self::Linear(law) => law.stiffness(),
            Self::Power(law) => law.slope(overlap),
        }
    }

    /// The energy, the integral of `f` from 0 to `delta` (force * length).
    #[must_use]
    pub fn energy(&self, overlap: f64) -> f64 {
        match self {
            Self::Linear(law) => law.energy(overlap),
            Self::Power(law) => law.energy(overlap),
        }
    }

    /// The overlap at which the force is `force`, which is not negative.
    #[must_use]
    pub fn overlap(&self, force: f64) -> f64 {
        match self {
            Self::Linear(law) => law.overlap(force),
            Self::Power(law) => law.overlap(force),
        }
    }
}
