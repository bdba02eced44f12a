//! Units that have a size: what a material by its name needs.

use clench::contact::Units;
use clench::drawing::Unit;

use super::fault::ContactFault;
use super::schema;

/// A meter (micrometers).
const METER: f64 = 1e6;

/// The units of force, in newtons; a pound is 0.45359237 kg, and weighs 9.80665 N per kilogram.
const FORCES: [(&str, f64); 5] =
    [("mN", 1e-3), ("N", 1.0), ("kN", 1e3), ("kgf", 9.806_65), ("lbf", 0.453_592_37 * 9.806_65)];

/// The sizes of the units that a file names.
pub(super) fn sizes(units: &schema::Units) -> Result<Units, ContactFault> {
    let [length, force] = [&units.length.0, &units.force.0];
    let newtons = FORCES.iter().find(|(known, _)| known == force);
    match (Unit::named(length), newtons) {
        (Some(length), Some(&(_, force_n))) => {
            Ok(Units { length_m: length.micrometers() / METER, force_n })
        }
        _ => Err(ContactFault::UnknownUnits { length: length.clone(), force: force.clone() }),
    }
}

/// The names of the known units of length.
pub(super) fn lengths() -> String {
    Unit::all().map(Unit::name).collect::<Vec<_>>().join(", ")
}

/// The names of the known units of force.
pub(super) fn forces() -> String {
    FORCES.map(|(name, _)| name).join(", ")
}
