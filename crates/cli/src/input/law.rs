//! The law of a contact: from the file, or from the stiffness of the part.

use clench::contact::{
    ContactError, Elastic, Hertz, Law, LineContact, Material, effective_modulus,
};

use super::boundary::PieceKind;
use super::contact::{Entry, Seated};
use super::fault::ContactFault;
use super::material;
use super::number::Finite;
use super::schema;
use super::units;
use crate::failure::Failure;

/// What Hertz' law follows from, as a file gives it.
struct HertzFields<'a> {
    modulus: Option<Finite>,
    finger: Option<&'a schema::Material>,
    part: Option<&'a schema::Material>,
    relative_radius: Option<Finite>,
}

impl<const N: usize> Entry<'_, N> {
    /// The law of a finger that sits there; `hertz` is Hertz' law of its curvatures, from the
    /// effective modulus.
    pub(super) fn law(
        &self,
        seated: &Seated<N>,
        hertz: impl FnOnce(f64) -> Result<Hertz, ContactFault>,
    ) -> Result<Law, Failure> {
        let law = match &self.given.law {
            None => {
                let fault = ContactFault::NoLaw { contact: self.number };
                let stiffness = self.part_stiffness(seated.piece);
                Law::linear(stiffness.ok_or_else(|| self.error(&self.place(), fault))?)
            }
            Some(schema::Law::Linear { stiffness }) => Law::linear(stiffness.0),
            Some(schema::Law::Power { coefficient, exponent }) => {
                Law::power(coefficient.0, exponent.0)
            }
            Some(schema::Law::Hertz { effective_modulus, finger, part, relative_radius }) => {
                let fields = HertzFields {
                    modulus: *effective_modulus,
                    finger: finger.as_ref(),
                    part: part.as_ref(),
                    relative_radius: *relative_radius,
                };
                return self.hertz(&fields, hertz).map(Law::Hertz);
            }
            Some(schema::Law::Line { thickness, reference_depth, finger, part }) => {
                Law::line(&LineContact {
                    radius: self.disc(seated)?,
                    thickness: thickness.0,
                    reference_depth: reference_depth.0,
                    finger: self.elastic("finger", finger)?,
                    part: self.elastic("part", part)?,
                })
            }
        };
        law.map_err(|e| self.fault("law", e))
    }

    fn hertz(
        &self,
        fields: &HertzFields<'_>,
        of_curvatures: impl FnOnce(f64) -> Result<Hertz, ContactFault>,
    ) -> Result<Hertz, Failure> {
        let modulus = self.modulus(fields)?;
        if let Some(radius) = fields.relative_radius {
            return Hertz::circular(modulus, radius.0).map_err(|e| self.fault("law", e));
        }
        of_curvatures(modulus).map_err(|fault| match fault {
            ContactFault::Library(ContactError::Pointed { .. }) if self.given.finger.is_none() => {
                self.fault("law", ContactFault::PointedByDefault { contact: self.number })
            }
            ContactFault::Library(
                ContactError::Pointed { .. }
                | ContactError::LineOfContact { .. }
                | ContactError::NoGap { .. }
                | ContactError::NoEllipse { .. }
                | ContactError::RadiusNotANumber { .. }
                | ContactError::PrincipalCurvature { .. }
                | ContactError::NoPrincipalDirection { .. },
            ) => self.fault("finger", fault),
            _ => self.fault("law", fault),
        })
    }

    /// The effective modulus, from the file or from the materials.
    fn modulus(&self, fields: &HertzFields<'_>) -> Result<f64, Failure> {
        let found = match (fields.modulus, fields.finger, fields.part) {
            (Some(modulus), None, None) => return Ok(modulus.0),
            (None, Some(finger), Some(part)) => {
                let finger = self.elastic("finger", finger)?;
                return Ok(effective_modulus(finger, self.elastic("part", part)?));
            }
            (Some(_), _, _) => "an `effective_modulus` and a material",
            (None, None, None) => "neither",
            (None, _, _) => "one material",
        };
        Err(self.fault("law", ContactFault::HertzModulus { found }))
    }

    /// The radius of a disc on a straight edge: they touch along a line.
    fn disc(&self, seated: &Seated<N>) -> Result<f64, Failure> {
        let found = match seated.piece.map(|piece| piece.kind) {
            Some(PieceKind::Face) => "a face of a solid",
            None if N == 2 => "an ellipse",
            None => "an ellipsoid",
            Some(PieceKind::Edge) => match seated.geometry.finger.radius() {
                Some(radius) if radius > 0.0 && radius.is_finite() => return Ok(radius),
                _ => "a finger that is no disc",
            },
        };
        Err(self.fault("law", ContactFault::LineOnOther { found }))
    }

    /// The material in the field `name` of the law.
    fn elastic(&self, name: &str, material: &schema::Material) -> Result<Elastic, Failure> {
        let place = self.place().field("law").field(name);
        let elastic = match material {
            schema::Material::Elastic(constants) => {
                Elastic::new(constants.young.0, constants.poisson.0)
            }
            schema::Material::Named(name) => {
                let sizes = || units::sizes(self.source.units);
                let found = Material::named(name).ok_or_else(|| material::unknown(name));
                let found = found.and_then(|material| Ok((material, sizes()?)));
                let (material, sizes) = found.map_err(|fault| self.error(&place, fault))?;
                material.elastic(sizes)
            }
        };
        elastic.map_err(|e| self.error(&place, ContactFault::from(e)))
    }
}
