//! Units that have a size: what a material by its name needs.

use clench::contact::Units;

use super::fault::ContactFault;
use super::schema;

/// The units of length, in meters.
const LENGTHS: [(&str, f64); 6] =
    [("um", 1e-6), ("mm", 1e-3), ("cm", 1e-2), ("m", 1.0), ("in", 0.0254), ("ft", 0.3048)];

/// The units of force, in newtons; a pound is 0.45359237 kg, and weighs 9.80665 N per kilogram.
const FORCES: [(&str, f64); 5] =
    [("mN", 1e-3), ("N", 1.0), ("kN", 1e3), ("kgf", 9.806_65), ("lbf", 0.453_592_37 * 9.806_65)];

/// The sizes of the units that a file names.
pub(super) fn sizes(units: &schema::Units) -> Result<Units, ContactFault> {
    let size = |table: &[(&str, f64)], name: &str| {
        table.iter().find(|(known, _)| *known == name).map(|&(_, size)| size)
    };
    let [length, force] = [&units.length, &units.force];
    match (size(&LENGTHS, &length.0), size(&FORCES, &force.0)) {
        (Some(length_m), Some(force_n)) => Ok(Units { length_m, force_n }),
        _ => Err(ContactFault::UnknownUnits { length: length.0.clone(), force: force.0.clone() }),
    }
}

/// The size of a unit of length in micrometers, of which most units are whole numbers; none of one
/// that is not known.
pub(super) fn micrometers(name: &str) -> Option<f64> {
    let (_, meters) = LENGTHS.iter().find(|(known, _)| *known == name)?;
    // Ten digits are more than a unit has, and the product of its decimals has one rounding more.
    Some((meters * 1e10).round() * 1e-4)
}

/// The names of the known units of length.
pub(super) fn lengths() -> String {
    LENGTHS.map(|(name, _)| name).join(", ")
}

/// The names of the known units of force.
pub(super) fn forces() -> String {
    FORCES.map(|(name, _)| name).join(", ")
}
