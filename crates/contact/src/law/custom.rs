//! A law that a user of this crate wrote.

use std::sync::Arc;

use super::ForceLaw;

/// A shared [`ForceLaw`]; equal only to its own clones.
///
/// ```
/// use clench_contact::{ForceLaw, Law};
///
/// /// A pad of rubber: `f = k delta + c delta^3`.
/// #[derive(Debug)]
/// struct Pad {
///     k: f64,
///     c: f64,
/// }
///
/// impl ForceLaw for Pad {
///     fn force(&self, x: f64) -> f64 {
///         self.k * x + self.c * x.powi(3)
///     }
///     fn slope(&self, x: f64) -> f64 {
///         self.k + 3.0 * self.c * x * x
///     }
///     fn energy(&self, x: f64) -> f64 {
///         self.k * x * x / 2.0 + self.c * x.powi(4) / 4.0
///     }
///     fn overlap(&self, force: f64) -> f64 {
///         // The one real root, by Cardano: both terms increase.
///         let (p, q) = (self.k / (3.0 * self.c), force / (2.0 * self.c));
///         let root = (q + (q * q + p.powi(3)).sqrt()).cbrt();
///         root - p / root
///     }
/// }
///
/// let law = Law::custom(Pad { k: 1.0, c: 1.0 });
/// assert!((law.overlap(10.0) - 2.0).abs() < 1e-14);
/// assert_eq!(law.slope(2.0), 13.0);
/// ```
#[derive(Clone, Debug)]
pub struct CustomLaw(Arc<dyn ForceLaw>);

impl CustomLaw {
    /// Shares `law`.
    #[must_use]
    pub fn new(law: impl ForceLaw + 'static) -> Self {
        Self(Arc::new(law))
    }

    pub(super) fn as_force_law(&self) -> &dyn ForceLaw {
        self.0.as_ref()
    }
}

impl PartialEq for CustomLaw {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// A law whose forces are some times as large.
#[derive(Debug)]
pub(super) struct Scaled {
    pub(super) law: CustomLaw,
    pub(super) factor: f64,
}

impl ForceLaw for Scaled {
    fn force(&self, overlap: f64) -> f64 {
        self.law.as_force_law().force(overlap) * self.factor
    }

    fn slope(&self, overlap: f64) -> f64 {
        self.law.as_force_law().slope(overlap) * self.factor
    }

    fn energy(&self, overlap: f64) -> f64 {
        self.law.as_force_law().energy(overlap) * self.factor
    }

    fn overlap(&self, force: f64) -> f64 {
        self.law.as_force_law().overlap(force / self.factor)
    }

    fn slope_at_force(&self, force: f64) -> f64 {
        self.law.as_force_law().slope_at_force(force / self.factor) * self.factor
    }

    fn slope_rate(&self, force: f64) -> f64 {
        // Slope and force are both scaled: their quotient is that of the law itself.
        self.law.as_force_law().slope_rate(force / self.factor)
    }

    fn largest_force(&self) -> f64 {
        self.law.as_force_law().largest_force() * self.factor
    }
}
