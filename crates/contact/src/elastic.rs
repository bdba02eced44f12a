//! What a body is made of, as far as a contact feels it.

use crate::ContactError;
use crate::error::positive;

/// The elastic constants of an isotropic body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    young_modulus: f64,
    poisson_ratio: f64,
}

impl Elastic {
    /// The constants `E` (force / length^2) and `nu`.
    ///
    /// `nu = 1/2`, incompressible, is allowed: contact formulas stay finite there.
    ///
    /// # Errors
    ///
    /// [`ContactError::NotPositive`] unless `E` is positive and finite;
    /// [`ContactError::PoissonRatio`] unless `-1 < nu <= 1/2`.
    pub fn new(young_modulus: f64, poisson_ratio: f64) -> Result<Self, ContactError> {
        let young_modulus = positive("Young's modulus", young_modulus)?;
        if poisson_ratio > -1.0 && poisson_ratio <= 0.5 {
            return Ok(Self { young_modulus, poisson_ratio });
        }
        Err(ContactError::PoissonRatio { value: poisson_ratio })
    }

    /// `E` (force / length^2).
    #[must_use]
    pub const fn young_modulus(self) -> f64 {
        self.young_modulus
    }

    /// `nu`.
    #[must_use]
    pub const fn poisson_ratio(self) -> f64 {
        self.poisson_ratio
    }

    /// `E / (1 - nu^2)` (force / length^2): what a contact feels of one body.
    #[must_use]
    pub fn plane_strain_modulus(self) -> f64 {
        self.young_modulus / (1.0 - self.poisson_ratio * self.poisson_ratio)
    }
}

/// `E*` (force / length^2), `1 / E* = (1 - nu_A^2) / E_A + (1 - nu_B^2) / E_B`
/// [Johnson, eq. 4.20].
///
/// ```
/// use clench_contact::{Elastic, effective_modulus};
/// // Two bodies of the same material share the approach.
/// let steel = Elastic::new(200e3, 0.0)?;
/// assert_eq!(effective_modulus(steel, steel), 100e3);
/// # Ok::<(), clench_contact::ContactError>(())
/// ```
#[must_use]
pub fn effective_modulus(finger: Elastic, part: Elastic) -> f64 {
    let (one, other) = (finger.plane_strain_modulus(), part.plane_strain_modulus());
    let (soft, stiff) = (one.min(other), one.max(other));
    soft / (1.0 + soft / stiff)
}
