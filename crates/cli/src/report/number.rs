//! Numbers and units as a reader wants them.

use std::fmt::{self, Display};

use crate::input::schema::Units;
use crate::wording::digits;

/// A coordinate this small beside the part is zero in text: it is rounding, and many times
/// smaller than any part can be placed.
pub(super) const INVISIBLE: f64 = 1e-12;

/// A point or a direction, beside something of the given `size`.
pub(crate) fn spot(point: &[f64], size: f64) -> String {
    let shown = |&v: &f64| digits(if v.abs() <= INVISIBLE * size { 0.0 } else { v });
    format!("({})", point.iter().map(shown).collect::<Vec<_>>().join(", "))
}

/// The names of the units of a report.
#[derive(Clone, Copy, Debug)]
pub(crate) struct UnitNames<'a>(pub(crate) &'a Units);

impl UnitNames<'_> {
    /// A length with its unit.
    pub(crate) fn length(self, value: f64) -> String {
        format!("{} {}", digits(value), self.0.length)
    }

    /// A force with its unit.
    pub(crate) fn force(self, value: f64) -> String {
        format!("{} {}", digits(value), self.0.force)
    }

    /// A force per deflection with its unit.
    pub(crate) fn stiffness(self, value: f64) -> String {
        format!("{} {}", digits(value), self.per_length())
    }

    /// A torque with its unit.
    pub(crate) fn torque(self, value: f64) -> String {
        format!("{} {} {}", digits(value), self.0.force, self.0.length)
    }

    /// A force per area with its unit.
    pub(crate) fn pressure(self) -> String {
        format!("{}/{}^2", self.0.force, self.0.length)
    }

    /// The unit of force per deflection.
    pub(crate) fn per_length(self) -> String {
        format!("{}/{}", self.0.force, self.0.length)
    }
}

impl Display for UnitNames<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "lengths in {}, forces in {}, angles in rad", self.0.length, self.0.force)
    }
}
