//! Numbers and units as a reader wants them.

use std::fmt::{self, Display};

use serde::{Serialize, Serializer};

use crate::input::Whole;
use crate::input::schema::Units;
use crate::wording::digits;

/// A coordinate this small beside the part is zero in text: it is rounding, and many times
/// smaller than any part can be placed.
pub(super) const INVISIBLE: f64 = 1e-12;

/// A number beside something of the given `size`: zero if it is rounding.
pub(super) fn beside(size: f64, value: f64) -> String {
    digits(if value.abs() <= INVISIBLE * size { 0.0 } else { value })
}

/// A count in words.
pub(super) fn counted(value: f64) -> String {
    Whole::exactly(value).map_or_else(|| digits(value), |count| count.0.to_string())
}

/// A point or a direction, beside something of the given `size`.
pub(crate) fn spot(point: &[f64], size: f64) -> String {
    let shown = point.iter().map(|&value| beside(size, value));
    format!("({})", shown.collect::<Vec<_>>().join(", "))
}

/// A point that is written as `spot`, and its number if it is a `corner` or `vertex`.
pub(super) fn numbered(spot: String, name: &str, corner: Option<usize>) -> String {
    match corner {
        Some(corner) => format!("{name} {corner} at {spot}"),
        None => spot,
    }
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
        format!("{} {}", digits(value), self.per_turn())
    }

    /// A torque of the plane or of space with its unit.
    pub(crate) fn torques(self, torque: &[f64]) -> String {
        match torque {
            [torque] => self.torque(*torque),
            _ => format!("{} {}", spot(torque, 0.0), self.per_turn()),
        }
    }

    /// A force per area with its unit.
    pub(crate) fn pressure(self) -> String {
        format!("{}/{}^2", self.0.force, self.0.length)
    }

    /// The unit of force per deflection.
    pub(crate) fn per_length(self) -> String {
        format!("{}/{}", self.0.force, self.0.length)
    }

    /// The unit of a torque, and of torque per radian.
    pub(crate) fn per_turn(self) -> String {
        format!("{} {}", self.0.force, self.0.length)
    }
}

/// A torque or a rotation: one number in the plane, a list of three in space.
pub(super) fn in_plane_a_number<S: Serializer>(
    turning: &[f64],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    match turning {
        [number] => number.serialize(serializer),
        _ => turning.serialize(serializer),
    }
}

impl Display for UnitNames<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "lengths in {}, forces in {}, angles in rad", self.0.length, self.0.force)
    }
}
