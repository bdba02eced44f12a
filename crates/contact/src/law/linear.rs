//! `f = k delta`.

use super::ForceLaw;
use crate::ContactError;
use crate::error::positive;

/// A spring of constant stiffness [LBR, eq. 3].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    k: f64,
}

impl Linear {
    /// The law with `stiffness` (force / length).
    ///
    /// # Errors
    ///
    /// [`ContactError::NotPositive`] unless the stiffness is positive and finite.
    pub fn new(stiffness: f64) -> Result<Self, ContactError> {
        Ok(Self { k: positive("stiffness", stiffness)? })
    }

    /// `k` (force / length).
    #[must_use]
    pub const fn stiffness(self) -> f64 {
        self.k
    }
}

impl ForceLaw for Linear {
    fn force(&self, overlap: f64) -> f64 {
        self.k * overlap
    }

    fn slope(&self, _overlap: f64) -> f64 {
        self.k
    }

    fn energy(&self, overlap: f64) -> f64 {
        0.5 * self.k * overlap * overlap
    }

    fn overlap(&self, force: f64) -> f64 {
        force / self.k
    }

    fn slope_rate(&self, _force: f64) -> f64 {
        0.0
    }
}
