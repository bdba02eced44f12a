//! How far the contacts of a file may be off.

use super::document::Document;
use super::fault::{ContactFault, Fault};
use super::number::Finite;
use super::place::Place;
use super::schema;
use crate::failure::Failure;

/// By how much a contact may be off, either way.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tolerance {
    /// Along the boundary [length].
    pub(crate) placement: f64,
    /// Of all forces of the law, relative.
    pub(crate) stiffness: f64,
    /// Relative.
    pub(crate) preload: f64,
}

/// Those of each contact: what it has of its own, otherwise what the file has of all; `None` if
/// the file has none.
pub(super) fn tolerances<P>(
    document: &Document,
    file: &schema::File<P>,
) -> Result<Option<Vec<Tolerance>>, Failure> {
    let place = Place::default().field("contact_tolerances");
    let all = file.contact_tolerances.as_ref();
    let all = all.map(|given| tolerance(document, &place, given, Tolerance::default()));
    let all = all.transpose()?;
    let own = |(i, contact): (usize, &schema::Contact)| {
        let rest = all.unwrap_or_default();
        let Some(given) = &contact.tolerance else { return Ok(rest) };
        tolerance(document, &Place::contact(i).field("tolerance"), given, rest)
    };
    let each = file.contacts.iter().enumerate().map(own).collect::<Result<Vec<_>, _>>()?;
    let any = all.is_some() || file.contacts.iter().any(|contact| contact.tolerance.is_some());
    Ok(any.then_some(each))
}

/// The tolerance at `place`, where it says nothing the `rest`.
fn tolerance(
    document: &Document,
    place: &Place,
    given: &schema::Tolerance,
    rest: Tolerance,
) -> Result<Tolerance, Failure> {
    let checked = |name: &str, given: Option<Finite>, rest: f64, below: f64| {
        let value = given.map_or(rest, |given| given.0);
        if value >= 0.0 && value < below {
            return Ok(value);
        }
        let relative = below < f64::INFINITY;
        let fault = if relative {
            ContactFault::RelativeTolerance { value }
        } else {
            ContactFault::Tolerance { value }
        };
        let fault = Fault::Contact(fault);
        Err(document.error(&place.clone().field(name), fault))
    };
    Ok(Tolerance {
        placement: checked("placement", given.placement, rest.placement, f64::INFINITY)?,
        stiffness: checked("stiffness", given.stiffness, rest.stiffness, 1.0)?,
        preload: checked("preload", given.preload, rest.preload, 1.0)?,
    })
}
