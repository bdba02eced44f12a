//! Numbers and units as a reader wants them.

use std::fmt::{self, Display};

use crate::input::schema::Units;

/// Digits after the first, in text; JSON has all of them.
const FURTHER_DIGITS: i32 = 5;

/// Numbers with these powers of ten are written without a power.
const PLAIN_POWERS: std::ops::Range<i32> = -4..7;

/// A coordinate this small beside the part is zero in text: it is rounding, and many times
/// smaller than any part can be placed.
const INVISIBLE: f64 = 1e-12;

/// `value` with six significant digits.
pub(crate) fn digits(value: f64) -> String {
    if value.abs() <= 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{value:.5e}");
    let Some((mantissa, power)) = scientific.split_once('e') else { return scientific };
    let power: i32 = power.parse().unwrap_or(0);
    if PLAIN_POWERS.contains(&power) {
        let decimals = usize::try_from(FURTHER_DIGITS - power).unwrap_or(0);
        return trimmed(&format!("{value:.decimals$}")).to_owned();
    }
    format!("{}e{power}", trimmed(mantissa))
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// A point or a direction, beside something of the given `size`.
pub(crate) fn spot(point: [f64; 2], size: f64) -> String {
    let [x, y] = point.map(|v| if v.abs() <= INVISIBLE * size { 0.0 } else { v });
    format!("({}, {})", digits(x), digits(y))
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
