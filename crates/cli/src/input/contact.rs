//! One contact of a file: where it sits, and how deep its finger presses.

use clench::contact::{Contact, ContactError, Curvature, Geometry, Law};
use clench::screw::Vector;

use super::boundary::{Foot, Piece, PieceKind, Seat};
use super::fault::{ContactFault, Coordinates, Fault, Nearest};
use super::grasp::{Source, vector};
use super::place::Place;
use super::schema::{self, Preload};
use crate::failure::Failure;

/// How far a contact may be from the boundary, relative to the radius of the part: as many digits
/// as a drawing gives. Whatever is nearer to both edges of a corner is at the corner.
const ON_BOUNDARY: f64 = 1e-6;

/// How far a unit normal may be from that of the boundary: files may give it with four decimals.
/// The boundary's own is used.
const SAME_NORMAL: f64 = 1e-4;

/// A contact of the file, and what is needed to place it.
pub(super) struct Entry<'a, const N: usize> {
    pub(super) source: &'a Source<'a, N>,
    pub(super) number: usize,
    pub(super) given: &'a schema::Contact,
    /// The force of a contact that balances the rest; none before it is known.
    pub(super) balancing: Option<f64>,
}

/// Where a finger sits, and how hard it presses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seated<const N: usize> {
    pub(super) geometry: Geometry<N>,
    /// The edge or face; none of a smooth part.
    pub(super) piece: Option<Piece>,
    press: Press,
}

#[derive(Clone, Copy, Debug)]
enum Press {
    Preload(f64),
    Overlap(f64),
}

impl<const N: usize> Entry<'_, N> {
    /// How the finger is curved: pointed, or as `read` has it from its fields and its direction.
    pub(super) fn curvature(
        &self,
        read: impl FnOnce(&schema::Finger, Option<Vector<N>>) -> Result<Curvature<N>, ContactFault>,
    ) -> Result<Curvature<N>, Failure> {
        let Some(finger) = &self.given.finger else { return Ok(Curvature::POINTED) };
        let place = || self.place().field("finger").field("direction");
        let along = finger.direction.as_ref();
        let along = along.map(|numbers| vector(self.source.document, &place(), numbers));
        read(finger, along.transpose()?).map_err(|fault| self.fault("finger", fault))
    }

    /// Where `finger` sits, and how hard it presses.
    pub(super) fn seated(&self, finger: Curvature<N>) -> Result<Seated<N>, Failure> {
        let (Seat { piece, point, inward_normal, curvature }, press) = self.seat_and_press()?;
        let geometry = Geometry { point, inward_normal, finger, part: curvature };
        Ok(Seated { geometry, piece, press })
    }

    /// The contact of a finger that sits there, by its law.
    pub(super) fn contact<const M: usize>(
        &self,
        seated: &Seated<N>,
        law: Law,
    ) -> Result<Contact<N, M>, Failure> {
        let contact = match seated.press {
            Press::Preload(force) => Contact::new(seated.geometry, law, force),
            Press::Overlap(depth) => Contact::overlapping(seated.geometry, law, depth),
        };
        contact.map_err(|e| self.fault(self.field_at_fault(&e), e))
    }

    /// The error that the field `name` of this contact has a fault.
    pub(super) fn fault(&self, name: &str, fault: impl Into<ContactFault>) -> Failure {
        self.error(&self.place().field(name), fault.into())
    }

    pub(super) fn error(&self, place: &Place, fault: ContactFault) -> Failure {
        self.source.document.error(place, Fault::Contact(fault))
    }

    pub(super) fn place(&self) -> Place {
        Place::contact(self.number)
    }

    /// The field that a contact's fault is about; one that does not exist is shown as the contact.
    fn field_at_fault(&self, fault: &ContactError) -> &'static str {
        match fault {
            ContactError::Negative { .. }
            | ContactError::BeyondLaw { .. }
            | ContactError::TooDeep { .. } => match self.given.center {
                Some(_) => "center",
                None => "preload",
            },
            ContactError::NoStiffness { .. } => "law",
            _ => "finger",
        }
    }

    fn allowed(&self) -> f64 {
        ON_BOUNDARY * self.source.boundary.radius()
    }

    fn seat_and_press(&self) -> Result<(Seat<N>, Press), Failure> {
        let vector =
            |name, numbers| vector(self.source.document, &self.place().field(name), numbers);
        match (&self.given.point, &self.given.center) {
            (Some(point), None) => {
                let seat = self.seat_at(vector("point", point)?)?;
                Ok((seat, Press::Preload(self.preload()?)))
            }
            (None, Some(center)) => self.seat_around(vector("center", center)?),
            (None, None) => {
                Err(self.error(&self.place(), ContactFault::PointOrCenter { found: "no place" }))
            }
            (Some(_), Some(_)) => {
                Err(self.fault("center", ContactFault::PointOrCenter { found: "both" }))
            }
        }
    }

    fn preload(&self) -> Result<f64, Failure> {
        match self.given.preload {
            None => Ok(0.0),
            Some(Preload::Force(force)) => Ok(force.0),
            Some(Preload::Balanced) => {
                self.balancing.ok_or_else(|| self.fault("preload", ContactFault::NothingToBalance))
            }
        }
    }

    /// Where a finger sits that touches at `point`.
    fn seat_at(&self, point: Vector<N>) -> Result<Seat<N>, Failure> {
        let seats = self.source.boundary.seats(point, self.allowed());
        if !seats.is_empty() {
            return self.chosen("point", seats);
        }
        let Foot { signed_distance, piece, .. } = self.source.boundary.foot(point);
        Err(self.fault(
            "point",
            ContactFault::OffBoundary {
                contact: self.number,
                distance: signed_distance.abs(),
                nearest: Nearest(piece),
                // Of a point so far away that its distance is infinite the sign is rounding.
                side: if signed_distance < 0.0 && signed_distance.is_finite() {
                    "inside"
                } else {
                    "outside"
                },
                allowed: self.allowed(),
                unit: self.unit(),
            },
        ))
    }

    /// Where a round finger around `center` sits, and how deep it presses.
    fn seat_around(&self, center: Vector<N>) -> Result<(Seat<N>, Press), Failure> {
        if self.given.preload.is_some() {
            return Err(self.fault("preload", ContactFault::PreloadWithCenter));
        }
        let given = self.given.finger.as_ref().map_or(Some(0.0), |f| f.radius.map(|r| r.0));
        let radius = given.filter(|&radius| radius >= 0.0);
        let radius = radius.ok_or_else(|| self.fault("finger", ContactFault::CenterOfNothing))?;
        let foot = self.source.boundary.foot(center);
        let gap = foot.signed_distance - radius;
        if gap > self.allowed() {
            let (contact, distance, unit) = (self.number, foot.signed_distance, self.unit());
            let fault = ContactFault::Apart { contact, gap, distance, unit };
            return Err(self.fault("center", fault));
        }
        let across = |seat: &Seat<N>| {
            let arm = foot.point - center;
            (arm - seat.inward_normal * seat.inward_normal.dot(arm)).norm() <= self.allowed()
        };
        let mut seats = self.source.boundary.seats(foot.point, self.allowed());
        seats.retain(across);
        if seats.is_empty() {
            let foot = Coordinates(foot.point.to_array().to_vec());
            let fault = ContactFault::CenterBeside { contact: self.number, foot };
            return Err(self.fault("center", fault));
        }
        Ok((self.chosen("center", seats)?, Press::Overlap((-gap).max(0.0))))
    }

    /// The one of several seats that the contact means: that of the edge or face it names, or of
    /// the normal. `field` is what they follow from.
    fn chosen(&self, field: &str, mut seats: Vec<Seat<N>>) -> Result<Seat<N>, Failure> {
        let contact = self.number;
        let nearest = seats[0];
        if let Some(piece) = self.named()? {
            seats.retain(|seat| seat.piece == Some(piece));
            if seats.is_empty() {
                let nearest = Nearest(nearest.piece);
                let fault = ContactFault::OffPiece { contact, piece, nearest };
                return Err(self.fault(field, fault));
            }
        }
        let first = seats[0];
        if let Some(numbers) = &self.given.inward_normal {
            let place = self.place().field("inward_normal");
            let normal = vector(self.source.document, &place, numbers)?;
            seats.retain(|seat| same_direction(normal, seat.inward_normal));
            if seats.is_empty() {
                return Err(self.other_normal(&first));
            }
        }
        let other = seats[1..].iter().find(|other| !self.interchangeable(&seats[0], other));
        let both = other.and_then(|other| seats[0].piece.zip(other.piece));
        match both {
            Some((first, second)) => {
                let fault = ContactFault::AmbiguousPiece { contact, first, second };
                Err(self.fault(field, fault))
            }
            None => Ok(seats[0]),
        }
    }

    /// The edge or face that the contact names, if it names one.
    fn named(&self) -> Result<Option<Piece>, Failure> {
        let pieces = self.source.boundary.pieces();
        let names = [(PieceKind::Edge, self.given.edge), (PieceKind::Face, self.given.face)];
        let mut named = None;
        for (found, number) in names {
            let Some(number) = number else { continue };
            let Some((kind, count)) = pieces.filter(|&(kind, _)| kind == found) else {
                let kind = pieces.map(|(kind, _)| kind);
                return Err(self.fault(found.field(), ContactFault::WrongPiece { found, kind }));
            };
            let piece = usize::try_from(number.0).ok().filter(|&piece| piece < count);
            let Some(piece) = piece.map(|number| Piece { kind, number }) else {
                let fault = ContactFault::NoSuchPiece { kind, found: number.0, last: count - 1 };
                return Err(self.fault(kind.field(), fault));
            };
            named = Some(piece);
        }
        Ok(named)
    }

    /// At a corner within a straight side it does not matter which edge is pressed on, if both
    /// would be as stiff.
    fn interchangeable(&self, one: &Seat<N>, other: &Seat<N>) -> bool {
        let stiffness = |seat: &Seat<N>| self.part_stiffness(seat.piece).map(f64::to_bits);
        let same_law = self.given.law.is_some() || stiffness(one) == stiffness(other);
        (one.inward_normal - other.inward_normal).norm() <= SAME_NORMAL && same_law
    }

    /// The stiffness of a contact without a law on `piece`.
    pub(super) fn part_stiffness(&self, piece: Option<Piece>) -> Option<f64> {
        match self.source.stiffness? {
            [one] => Some(*one),
            each => each.get(piece?.number).copied(),
        }
    }

    fn other_normal(&self, seat: &Seat<N>) -> Failure {
        let found = self.given.inward_normal.as_ref().map_or(Vec::new(), |n| n.0.clone());
        let fault = ContactFault::OtherNormal {
            contact: self.number,
            found: Coordinates(found),
            expected: Coordinates(seat.inward_normal.to_array().to_vec()),
            at: Nearest(seat.piece),
        };
        self.fault("inward_normal", fault)
    }

    /// The name of the unit of length.
    fn unit(&self) -> String {
        self.source.units.length.0.clone()
    }
}

/// Whether a direction of any length is that of a unit normal.
fn same_direction<const N: usize>(direction: Vector<N>, normal: Vector<N>) -> bool {
    direction.direction().is_some_and(|unit| (unit - normal).norm() <= SAME_NORMAL)
}
