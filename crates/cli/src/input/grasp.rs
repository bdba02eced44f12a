//! From the contacts and loads of a file to a grasp.

use clench::contact::{Contact, Hertz};
use clench::screw::Vector;
use clench::shape::Ellipsoid;
use clench::stiffness::{Grasp, GraspError};

use super::balance;
use super::boundary::{Boundary, Piece};
use super::contact::Entry;
use super::document::Document;
use super::fault::{ContactFault, Fault};
use super::finger;
use super::load::{self, LoadCase, NamedPoint};
use super::number::Coordinates;
use super::part::{Body, PlanarShape};
use super::place::Place;
use super::schema;
use super::solid::SpatialShape;
use super::tolerance::{self, Tolerance};
use crate::failure::Failure;

/// The grasp of a file, and what only the file knows of it.
#[derive(Debug)]
pub(crate) struct FileGrasp<const N: usize, const M: usize> {
    pub(crate) grasp: Grasp<N, M>,
    /// The edge or face that each contact presses on; none of a smooth part.
    pub(crate) pieces: Vec<Option<Piece>>,
    /// The radius of the part.
    pub(crate) radius: f64,
    pub(crate) points: Vec<NamedPoint<N>>,
    pub(crate) load_cases: Vec<LoadCase<N, M>>,
    /// How far each contact may be off, if the file says so.
    pub(crate) tolerances: Option<Vec<Tolerance>>,
    /// The part where it is smooth: fingers on other parts are on flat places.
    pub(crate) smooth: Option<Ellipsoid<N>>,
}

/// The grasp of a planar part by the contacts of a file.
pub(crate) fn planar_grasp(
    document: &Document,
    file: &schema::File,
    body: &Body<PlanarShape>,
) -> Result<FileGrasp<2, 1>, Failure> {
    let boundary: &dyn Boundary<2> = match &body.shape {
        PlanarShape::Outline(outline) => &**outline,
        PlanarShape::Ellipse(ellipse) => ellipse,
    };
    let stiffness = body.stiffness.as_deref();
    let source = Source { document, units: &file.units, boundary, stiffness };
    grasp(&source, file, |entry| {
        let seated = entry.seated(entry.curvature(|finger, _| finger::planar(finger))?)?;
        let law = entry.law(&seated, |_| Err(ContactFault::PlanarHertz))?;
        Ok((entry.contact(&seated, law)?, seated.piece))
    })
}

/// The grasp of a spatial part by the contacts of a file.
pub(crate) fn spatial_grasp(
    document: &Document,
    file: &schema::File,
    body: &Body<SpatialShape>,
) -> Result<FileGrasp<3, 3>, Failure> {
    let boundary: &dyn Boundary<3> = match &body.shape {
        SpatialShape::Polyhedron(solid) => &**solid,
        SpatialShape::Ellipsoid(ellipsoid) => ellipsoid,
    };
    let stiffness = body.stiffness.as_deref();
    let source = Source { document, units: &file.units, boundary, stiffness };
    grasp(&source, file, spatial_contact)
}

/// A contact on a spatial part, and what it is on.
pub(super) fn spatial_contact(
    entry: &Entry<'_, 3>,
) -> Result<(Contact<3, 3>, Option<Piece>), Failure> {
    let seated = entry.seated(entry.curvature(finger::spatial)?)?;
    let law = entry.law(&seated, |modulus| Ok(Hertz::of(modulus, &seated.geometry)?))?;
    Ok((entry.contact(&seated, law)?, seated.piece))
}

/// A file with contacts whose part is known.
pub(super) struct Source<'a, const N: usize> {
    pub(super) document: &'a Document,
    pub(super) units: &'a schema::Units,
    pub(super) boundary: &'a dyn Boundary<N>,
    /// Of a contact on each piece of the boundary, or on all of it.
    pub(super) stiffness: Option<&'a [f64]>,
}

/// The grasp by the contacts of a file, each made by `contact`.
fn grasp<const N: usize, const M: usize>(
    source: &Source<'_, N>,
    file: &schema::File,
    contact: impl Fn(&Entry<'_, N>) -> Result<(Contact<N, M>, Option<Piece>), Failure>,
) -> Result<FileGrasp<N, M>, Failure> {
    let Source { document, boundary, .. } = source;
    if file.contacts.is_empty() {
        return Err(document.error(&Place::default().field("contacts"), Fault::NoContacts));
    }
    let loads = load::dead_loads(document, &file.loads)?;
    let (contacts, pieces): (Vec<_>, Vec<_>) =
        balance::contacts(source, &file.contacts, &loads, contact)?.into_iter().unzip();
    let grasp = Grasp::new(contacts).and_then(|grasp| grasp.with_loads(loads)).map_err(|e| {
        let place = match e {
            GraspError::OutOfRange { contact } => Place::contact(contact),
            GraspError::Load { load } => Place::load(load),
            _ => Place::default().field("contacts"),
        };
        document.error(&place, Fault::Grasp(e))
    })?;
    Ok(FileGrasp {
        grasp,
        pieces,
        radius: boundary.radius(),
        points: load::named_points(document, &file.points)?,
        load_cases: load::load_cases(document, &file.load_cases)?,
        tolerances: tolerance::tolerances(document, file)?,
        smooth: boundary.smooth(),
    })
}

/// The point or direction at `place`, if it has as many numbers as the part has dimensions.
pub(super) fn vector<const N: usize>(
    document: &Document,
    place: &Place,
    numbers: &Coordinates,
) -> Result<Vector<N>, Failure> {
    let found = numbers.0.len();
    let components = <[f64; N]>::try_from(&numbers.0[..]);
    components
        .map(Vector::new)
        .map_err(|_| document.error(place, Fault::Dimension { found, expected: N }))
}
