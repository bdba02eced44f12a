//! From the contacts of a file to a grasp.

use clench::contact::{Contact, ContactError, Geometry, Law};
use clench::optimize::polygon::Part;
use clench::screw::Vector;
use clench::shape::Edge;
use clench::stiffness::{Grasp, GraspError};

use super::document::Document;
use super::fault::Fault;
use super::place::Place;
use super::schema;
use crate::failure::Failure;

/// How far a contact may be from its edge, relative to the radius of the part's smallest
/// enclosing circle: as many digits as a drawing gives. Whatever is nearer to both edges of a
/// corner is at the corner.
const ON_BOUNDARY: f64 = 1e-6;

/// How far a unit normal may be from that of its edge: files may give it with four decimals.
/// The edge's own is used.
const SAME_NORMAL: f64 = 1e-4;

/// The grasp of a file, and the edge that each contact presses on.
#[derive(Debug)]
pub(crate) struct FileGrasp {
    pub(crate) grasp: Grasp<2, 1>,
    pub(crate) edges: Vec<usize>,
}

/// The grasp of `part` by the contacts of a file.
pub(crate) fn grasp(
    document: &Document,
    file: &schema::File,
    part: &Part,
) -> Result<FileGrasp, Failure> {
    if file.contacts.is_empty() {
        return Err(document.error(&Place::default().field("contacts"), Fault::NoContacts));
    }
    let mut edges = Vec::new();
    let mut contacts = Vec::new();
    for (number, entry) in file.contacts.iter().enumerate() {
        let entry = Entry { document, part, unit: &file.units.length.0, number, given: entry };
        let edge = entry.edge()?;
        edges.push(edge);
        contacts.push(entry.contact(edge)?);
    }
    let grasp = Grasp::new(contacts).map_err(|e| {
        let place = match e {
            GraspError::OutOfRange { contact } => Place::contact(contact),
            _ => Place::default().field("contacts"),
        };
        document.error(&place, Fault::Grasp(e))
    })?;
    Ok(FileGrasp { grasp, edges })
}

/// A contact of the file, and what is needed to place it.
struct Entry<'a> {
    document: &'a Document,
    part: &'a Part,
    /// The name of the unit of length.
    unit: &'a str,
    number: usize,
    given: &'a schema::Contact,
}

impl Entry<'_> {
    fn place(&self) -> Place {
        Place::contact(self.number)
    }

    fn point(&self) -> Vector<2> {
        self.given.point.0.into()
    }

    fn allowed(&self) -> f64 {
        ON_BOUNDARY * self.part.outline().enclosing_circle().radius
    }

    /// The edge that the contact presses on: the one it names, or the only one it is on whose
    /// normal is the one it names.
    fn edge(&self) -> Result<usize, Failure> {
        let on = match self.given.edge {
            Some(edge) => vec![self.named_edge(edge.0)?],
            None => self.edges_at_point()?,
        };
        let edges = self.part.outline().edges();
        let pressed: Vec<usize> =
            on.iter().copied().filter(|&e| self.fits_normal(&edges[e])).collect();
        match (pressed[..].first(), pressed[..].get(1)) {
            (Some(&first), Some(&second)) if !self.interchangeable(first, second) => {
                let contact = self.number;
                let fault = Fault::AmbiguousEdge { contact, first, second };
                Err(self.document.error(&self.place().field("point"), fault))
            }
            (Some(&first), _) => Ok(first),
            (None, _) => Err(self.other_normal(on[0])),
        }
    }

    /// The edge of this number, if the contact is on it.
    fn named_edge(&self, found: u64) -> Result<usize, Failure> {
        let edges = self.part.outline().edges();
        let edge = usize::try_from(found).ok().filter(|&e| e < edges.len());
        let Some(edge) = edge else {
            let fault = Fault::NoSuchEdge { found, last: edges.len() - 1 };
            return Err(self.document.error(&self.place().field("edge"), fault));
        };
        let (distance, allowed) = (distance(&edges[edge], self.point()), self.allowed());
        if distance <= allowed {
            return Ok(edge);
        }
        let nearest = self.part.outline().place(self.point()).edge;
        let (contact, unit) = (self.number, self.unit.to_owned());
        let fault = Fault::OffEdge { contact, edge, distance, allowed, unit, nearest };
        Err(self.document.error(&self.place().field("point"), fault))
    }

    /// All edges that the contact is on: two at a corner.
    fn edges_at_point(&self) -> Result<Vec<usize>, Failure> {
        let (outline, allowed) = (self.part.outline(), self.allowed());
        let edges = outline.edges().iter().enumerate();
        let on = edges.filter(|(_, edge)| distance(edge, self.point()) <= allowed);
        let on: Vec<usize> = on.map(|(number, _)| number).collect();
        if !on.is_empty() {
            return Ok(on);
        }
        let nearest = outline.place(self.point());
        let fault = Fault::OffBoundary {
            contact: self.number,
            distance: nearest.distance,
            edge: nearest.edge,
            allowed,
            unit: self.unit.to_owned(),
        };
        Err(self.document.error(&self.place().field("point"), fault))
    }

    fn fits_normal(&self, edge: &Edge) -> bool {
        self.given.inward_normal.is_none_or(|normal| {
            let normal = Vector::new(normal.0);
            let size = normal.max_abs();
            let unit = normal * size.recip();
            let off = unit * unit.norm().recip() - edge.inward_normal();
            size > 0.0 && off.norm() <= SAME_NORMAL
        })
    }

    /// At a corner within a straight side it does not matter which edge is pressed on, if both
    /// would be as stiff.
    fn interchangeable(&self, first: usize, second: usize) -> bool {
        let [a, b] = [first, second].map(|e| self.part.outline().edges()[e].inward_normal());
        let stiffness = self.part.edge_stiffness();
        let same_law =
            self.given.law.is_some() || stiffness[first].to_bits() == stiffness[second].to_bits();
        (a - b).norm() <= SAME_NORMAL && same_law
    }

    fn other_normal(&self, edge: usize) -> Failure {
        let fault = Fault::OtherNormal {
            contact: self.number,
            edge,
            found: self.given.inward_normal.map_or([0.0; 2], |normal| normal.0),
            // Zero has no sign.
            expected: self.part.outline().edges()[edge].inward_normal().to_array().map(|v| v + 0.0),
        };
        self.document.error(&self.place().field("inward_normal"), fault)
    }

    fn contact(&self, edge: usize) -> Result<Contact<2, 1>, Failure> {
        let law = self.law(edge)?;
        let normal = self.part.outline().edges()[edge].inward_normal();
        let radius = self.given.finger.map_or(0.0, |finger| finger.radius.0);
        let preload = self.given.preload.map_or(0.0, |preload| preload.0);
        Contact::new(Geometry::on_face(self.point(), normal, radius), law, preload).map_err(|e| {
            let place = match e {
                ContactError::Negative { .. } if preload < 0.0 => self.place().field("preload"),
                ContactError::Negative { .. } => self.place().field("finger").field("radius"),
                ContactError::NoStiffness { .. } => self.place().field("law"),
                _ => self.place(),
            };
            self.document.error(&place, Fault::Contact(e))
        })
    }

    fn law(&self, edge: usize) -> Result<Law, Failure> {
        let law = match self.given.law {
            None => Law::linear(self.part.edge_stiffness()[edge]),
            Some(schema::Law::Linear { stiffness }) => Law::linear(stiffness.0),
            Some(schema::Law::Power { coefficient, exponent }) => {
                Law::power(coefficient.0, exponent.0)
            }
        };
        law.map_err(|e| self.document.error(&self.place().field("law"), Fault::Contact(e)))
    }
}

/// How far `point` is from an edge.
fn distance(edge: &Edge, point: Vector<2>) -> f64 {
    let along = (point - edge.start()).dot(edge.direction()).clamp(0.0, edge.length());
    (point - edge.point_at(along)).norm()
}
