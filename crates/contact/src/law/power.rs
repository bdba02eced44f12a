//! `f = c delta^p`.

use super::ForceLaw;
use crate::ContactError;
use crate::error::positive;

/// A power law; `p = 3/2` is the form of Hertz' law for smooth elastic bodies.
///
/// Without overlap its slope is 0 for `p > 1` and infinite for `p < 1`: such a contact needs a
/// preload.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power {
    c: f64,
    p: f64,
}

impl Power {
    /// The law with `coefficient` (force / length^exponent) and `exponent`.
    ///
    /// # Errors
    ///
    /// [`ContactError::NotPositive`] unless both are positive and finite.
    pub fn new(coefficient: f64, exponent: f64) -> Result<Self, ContactError> {
        Ok(Self { c: positive("coefficient", coefficient)?, p: positive("exponent", exponent)? })
    }

    /// `c` (force / length^exponent).
    #[must_use]
    pub const fn coefficient(&self) -> f64 {
        self.c
    }

    /// `p`.
    #[must_use]
    pub const fn exponent(&self) -> f64 {
        self.p
    }
}

impl ForceLaw for Power {
    fn force(&self, overlap: f64) -> f64 {
        self.c * overlap.powf(self.p)
    }

    fn slope(&self, overlap: f64) -> f64 {
        self.c * self.p * overlap.powf(self.p - 1.0)
    }

    fn energy(&self, overlap: f64) -> f64 {
        self.c * overlap.powf(self.p + 1.0) / (self.p + 1.0)
    }

    fn overlap(&self, force: f64) -> f64 {
        (force / self.c).powf(self.p.recip())
    }

    fn slope_rate(&self, force: f64) -> f64 {
        (self.p - 1.0) / self.overlap(force)
    }
}
