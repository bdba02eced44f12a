//! The law of a contact: from the file, or from the stiffness of the part.

use clench::contact::{
    ContactError, Elastic, Geometry, Hertz, Law, LineContact, Material, effective_modulus,
};
use clench::screw::Vector;

use super::boundary::PieceKind;
use super::contact::Entry;
use super::fault::ContactFault;
use super::number::Finite;
use super::schema;
use super::units;
use crate::failure::Failure;

/// A law, and the direction in which the area of contact is longest, where that is known.
type LawAndAxis<const N: usize> = (Law, Option<Vector<N>>);

/// What Hertz' law follows from, as a file gives it.
struct HertzFields<'a> {
    modulus: Option<Finite>,
    finger: Option<&'a schema::Material>,
    part: Option<&'a schema::Material>,
    relative_radius: Option<Finite>,
}

impl<const N: usize> Entry<'_, N> {
    /// The law of the contact at `geometry`, on the edge or face `piece`.
    pub(super) fn law(
        &self,
        piece: Option<usize>,
        geometry: &Geometry<N>,
    ) -> Result<LawAndAxis<N>, Failure> {
        let law = match &self.given.law {
            None => {
                let fault = ContactFault::NoLaw { contact: self.number };
                let stiffness = self.part_stiffness(piece);
                Law::linear(stiffness.ok_or_else(|| self.error(&self.place(), fault))?)
            }
            Some(schema::Law::Linear { stiffness }) => Law::linear(stiffness.0),
            Some(schema::Law::Power { coefficient, exponent }) => {
                Law::power(coefficient.0, exponent.0)
            }
            Some(schema::Law::Hertz { effective_modulus, finger, part, relative_radius }) => {
                return self.hertz(
                    &HertzFields {
                        modulus: *effective_modulus,
                        finger: finger.as_ref(),
                        part: part.as_ref(),
                        relative_radius: *relative_radius,
                    },
                    geometry,
                );
            }
            Some(schema::Law::Line { thickness, reference_depth, finger, part }) => {
                self.check_line(geometry)?;
                Law::line(&LineContact {
                    radius: geometry.finger.radius().unwrap_or(0.0),
                    thickness: thickness.0,
                    reference_depth: reference_depth.0,
                    finger: self.elastic("finger", finger)?,
                    part: self.elastic("part", part)?,
                })
            }
        };
        Ok((law.map_err(|e| self.fault("law", e))?, None))
    }

    fn hertz(
        &self,
        fields: &HertzFields<'_>,
        geometry: &Geometry<N>,
    ) -> Result<LawAndAxis<N>, Failure> {
        let modulus = match (fields.modulus, fields.finger, fields.part) {
            (Some(modulus), None, None) => modulus.0,
            (None, Some(finger), Some(part)) => {
                effective_modulus(self.elastic("finger", finger)?, self.elastic("part", part)?)
            }
            (modulus, finger, part) => {
                let found = match (modulus, finger, part) {
                    (Some(_), _, _) => "an `effective_modulus` and a material",
                    (None, None, None) => "neither",
                    _ => "one material",
                };
                return Err(self.fault("law", ContactFault::HertzModulus { found }));
            }
        };
        if let Some(radius) = fields.relative_radius {
            let law = Hertz::circular(modulus, radius.0).map_err(|e| self.fault("law", e))?;
            return Ok((Law::Hertz(law), None));
        }
        let (law, axis) = (self.dimension.hertz)(modulus, geometry).map_err(|fault| {
            let field = match fault {
                ContactFault::Library(ContactError::NotPositive {
                    parameter: "effective modulus" | "coefficient",
                    ..
                })
                | ContactFault::PlanarHertz => "law",
                _ => "finger",
            };
            self.fault(field, fault)
        })?;
        Ok((Law::Hertz(law), Some(axis)))
    }

    /// A line of contact is that of a disc on a straight edge.
    fn check_line(&self, geometry: &Geometry<N>) -> Result<(), Failure> {
        let found = match self.source.boundary.pieces() {
            Some((PieceKind::Face, _)) => "a face of a solid",
            None if N == 2 => "an ellipse",
            None => "an ellipsoid",
            Some((PieceKind::Edge, _)) => match geometry.finger.radius() {
                Some(radius) if radius > 0.0 => return Ok(()),
                _ => "a finger that is no disc",
            },
        };
        Err(self.fault("law", ContactFault::LineOnOther { found }))
    }

    /// The material in the field `name` of the law.
    fn elastic(&self, name: &str, material: &schema::Material) -> Result<Elastic, Failure> {
        let elastic = match material {
            schema::Material::Elastic(constants) => {
                Elastic::new(constants.young.0, constants.poisson.0).map_err(ContactFault::from)
            }
            schema::Material::Named(name) => Material::named(name)
                .map_err(ContactFault::from)
                .and_then(|found| Ok(found.elastic(units::sizes(&self.source.file.units)?)?)),
        };
        let place = self.place().field("law").field(name);
        elastic.map_err(|fault| self.error(&place, fault))
    }
}
