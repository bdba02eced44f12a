//! Contacts of a file of their own, on the part of another: locators that are given, or candidates.

use std::path::Path;

use clench::contact::{Contact, Geometry};
use clench::optimize::polyhedron::Touch;

use super::boundary::Piece;
use super::contact::Entry;
use super::document::Document;
use super::fault::{Fault, PartFault};
use super::grasp::{Source, spatial_contact};
use super::part::{self, Body, Part, Solid, SpatialShape};
use super::place::Place;
use super::schema::{self, File};
use crate::failure::Failure;
use crate::report::html;

/// The part that contacts are on, and the file that it is from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Holder<'a> {
    pub(crate) name: &'a str,
    pub(crate) units: &'a schema::Units,
    pub(crate) body: &'a Body<Solid>,
}

/// A contact that is given, or that may be chosen.
#[derive(Clone, Debug)]
pub(crate) struct GivenContact {
    contact: Contact<3, 3>,
    /// The face that it presses on.
    pub(crate) face: Option<usize>,
    /// As the file has it.
    pub(crate) finger: Option<schema::Finger>,
}

impl GivenContact {
    /// The spring that it is at its preload.
    pub(crate) fn touch(&self) -> Touch {
        let overlap = self.contact.overlap();
        Touch {
            point: overlap.point(),
            inward_normal: overlap.inward_normal(),
            stiffness: self.contact.slope(),
        }
    }

    /// The radius of the ball at its end; 0 of one that is curved otherwise, and none if the file
    /// does not say how it is.
    pub(crate) fn tip_radius(&self) -> Option<f64> {
        let finger = self.finger.as_ref()?;
        Some(finger.radius.map_or(0.0, |radius| radius.0.max(0.0)))
    }

    /// Where it touches, and how the finger is curved.
    pub(crate) fn geometry(&self) -> Geometry<3> {
        *self.contact.overlap().geometry()
    }
}

/// The contacts in the file at `path`, on the part of another file; and the file as it was read.
pub(crate) fn given_contacts(
    path: &Path,
    holder: Holder<'_>,
) -> Result<(Vec<GivenContact>, html::Source), Failure> {
    let (document, file): (_, File<Option<schema::Part>>) = Document::read(path)?;
    check_units(&document, &file.units, holder)?;
    if let Some(part) = &file.part {
        check_part(&document, part, holder)?;
    }
    if !file.loads.is_empty() {
        return Err(document.error(&Place::default().field("loads"), Fault::Loads));
    }
    if file.contacts.is_empty() {
        return Err(document.error(&Place::default().field("contacts"), Fault::NoContacts));
    }
    let source = Source {
        document: &document,
        units: &file.units,
        boundary: &holder.body.shape,
        stiffness: holder.body.stiffness.as_deref(),
    };
    let contact = |(number, given): (usize, &schema::Contact)| {
        let entry = Entry { source: &source, number, given, balancing: None };
        let (contact, piece) = spatial_contact(&entry)?;
        let face = piece.map(|Piece { number, .. }| number);
        Ok(GivenContact { contact, face, finger: given.finger.clone() })
    };
    let contacts = file.contacts.iter().enumerate().map(contact).collect::<Result<_, Failure>>()?;
    Ok((contacts, document.source()))
}

fn check_units(
    document: &Document,
    units: &schema::Units,
    holder: Holder<'_>,
) -> Result<(), Failure> {
    if units == holder.units {
        return Ok(());
    }
    let both = Box::new([units.clone(), holder.units.clone()]);
    let fault = Fault::OtherUnits { name: holder.name.to_owned(), units: both };
    Err(document.error(&Place::default().field("units"), fault))
}

/// Checks that a part is the one of the other file: its shape, and the stiffness if it has one.
fn check_part(document: &Document, part: &schema::Part, holder: Holder<'_>) -> Result<(), Failure> {
    let expected = holder.body;
    let same = match part::part(document, part)? {
        Part::Spatial(Body { shape: SpatialShape::Polyhedron(found), stiffness }) => {
            let (found, shape) = (&found.polyhedron, &expected.shape.polyhedron);
            let faces = found.faces().iter().zip(shape.faces());
            found.vertices() == shape.vertices()
                && found.faces().len() == shape.faces().len()
                && faces.into_iter().all(|(one, other)| one.vertices() == other.vertices())
                && (stiffness.is_none() || stiffness == expected.stiffness)
        }
        _ => false,
    };
    if same {
        return Ok(());
    }
    let fault = PartFault::OtherPart { name: holder.name.to_owned() };
    Err(document.error(&Place::part(), fault))
}
