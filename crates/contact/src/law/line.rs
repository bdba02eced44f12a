//! A disc on a straight edge: contact along a line through the thickness.

use std::f64::consts::PI;

use super::ForceLaw;
use crate::error::positive;
use crate::{ContactError, Elastic};

/// Newton's method for the overlap is monotonous and quadratic; 1e-300 takes 6 steps.
const MAX_STEPS: usize = 30;

/// What the law of a line contact follows from; lengths and moduli in one set of units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineContact {
    /// The radius of the disc (length).
    pub radius: f64,
    /// The thickness of disc and part, along the line of contact (length).
    pub thickness: f64,
    /// How far below the edge the part is held (length): a half plane under a line load sinks
    /// without end, so its approach is relative to a point at this depth.
    pub reference_depth: f64,
    /// The material of the disc.
    pub finger: Elastic,
    /// The material of the part.
    pub part: Elastic,
}

/// The law of a disc on a straight edge, in plane strain [Johnson, section 5.6]: the approach of
/// the disc's center, when the load enters at the far end of its diameter, and a point of the part
/// at the reference depth.
///
/// With `P = f / thickness` and `a^2 = 4 P R / (pi E*)`,
///
/// ```text
/// delta = P (1 - nu_A^2) / (pi E_A) (2 ln(4 R / a) - 1)
///       + P (1 - nu_B^2) / (pi E_B) (2 ln(2 d / a) - nu_B / (1 - nu_B))
/// ```
///
/// Collected, this is `delta = P (1 + ln(P_max / P)) / (pi E*)`, which grows up to `P = P_max`:
/// there the half width has become comparable to the radius and the depth, and the law ends.
///
/// There is no slope without overlap: such a contact needs a preload to have a stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// `1 / (pi E*)`.
    compliance: f64,
    thickness: f64,
    /// `P_max`.
    largest: f64,
    /// `ln P_max`.
    largest_logarithm: f64,
    /// `4 R / (pi E*)`: the square of the half width per force per thickness.
    spread: f64,
}

impl Line {
    /// The law of a contact.
    ///
    /// # Errors
    ///
    /// [`ContactError::NotPositive`] when radius, thickness or reference depth are not positive
    /// and finite, or when the law's largest force is not: the depth or the radius are then out of
    /// all proportion.
    pub fn new(contact: &LineContact) -> Result<Self, ContactError> {
        let radius = positive("disc radius", contact.radius)?;
        let thickness = positive("thickness", contact.thickness)?;
        let depth = positive("reference depth", contact.reference_depth)?;
        let (finger, part) = (contact.finger, contact.part);
        let own = |body: Elastic| (PI * body.plane_strain_modulus()).recip();
        let compliance = own(finger) + own(part);
        let spread = 4.0 * radius * compliance;
        let nu = part.poisson_ratio();
        let weighted = own(finger) * (2.0 * (4.0 * radius).ln() - 1.0)
            + own(part) * (2.0 * (2.0 * depth).ln() - nu / (1.0 - nu));
        let largest_logarithm = weighted / compliance - spread.ln() - 1.0;
        let largest = largest_logarithm.exp();
        positive("largest force", largest * thickness)?;
        positive("largest overlap", compliance * largest)?;
        Ok(Self { compliance, thickness, largest, largest_logarithm, spread })
    }

    /// The law of the same disc on the same edge with `factor` times the moduli.
    pub(super) fn scaled(&self, factor: f64) -> Result<Self, ContactError> {
        let largest = self.largest * factor;
        positive("largest force", largest * self.thickness)?;
        Ok(Self {
            compliance: positive("compliance", self.compliance / factor)?,
            thickness: self.thickness,
            largest,
            largest_logarithm: self.largest_logarithm + factor.ln(),
            spread: positive("spread", self.spread / factor)?,
        })
    }

    /// Half the width of the area of contact (length).
    #[must_use]
    pub fn half_width(&self, force: f64) -> f64 {
        (self.spread * force / self.thickness).sqrt()
    }

    /// The pressure in the middle of the area of contact, `2 P / (pi a)` (force / length^2).
    #[must_use]
    pub fn peak_pressure(&self, force: f64) -> f64 {
        // a^2 / P is constant, so that nothing divides zero by zero.
        2.0 / PI * (force / self.thickness / self.spread).sqrt()
    }

    /// The overlap at the largest force, where the law ends (length).
    #[must_use]
    pub fn largest_overlap(&self) -> f64 {
        self.compliance * self.largest
    }

    /// `ln(P_max / P)` at an overlap, between 0 and infinity: the root of
    /// `w - ln(1 + w) = ln(delta_max / delta)`.
    ///
    /// From above, where Newton's method on this convex function descends to the root.
    fn logarithm(&self, overlap: f64) -> f64 {
        let wanted = (self.largest_overlap().ln() - overlap.ln()).max(0.0);
        let mut w = wanted + (2.0 * wanted).sqrt();
        for _ in 0..MAX_STEPS {
            let error = w - w.ln_1p() - wanted;
            let next = w - error * (1.0 + w) / w;
            if !(next > 0.0 && next < w) {
                break;
            }
            w = next;
        }
        w
    }

    /// `ln(P_max / P)` and `P` at an overlap; the law stays at its end beyond its largest overlap.
    fn load(&self, overlap: f64) -> [f64; 2] {
        let w = self.logarithm(overlap);
        [w, self.largest * (-w).exp()]
    }

    /// `P` and `ln(P_max / P)` at a force.
    fn load_at_force(&self, force: f64) -> [f64; 2] {
        let p = force / self.thickness;
        [p, self.largest_logarithm - p.ln()]
    }
}

impl ForceLaw for Line {
    fn force(&self, overlap: f64) -> f64 {
        if overlap <= 0.0 {
            return 0.0;
        }
        self.thickness * self.load(overlap)[1]
    }

    fn slope(&self, overlap: f64) -> f64 {
        if overlap <= 0.0 {
            return 0.0;
        }
        self.thickness / (self.compliance * self.load(overlap)[0])
    }

    fn energy(&self, overlap: f64) -> f64 {
        if overlap <= 0.0 {
            return 0.0;
        }
        let [w, p] = self.load(overlap);
        let beyond = (overlap - self.largest_overlap()).max(0.0);
        self.thickness * p * (self.compliance * p * (0.5 * w + 0.25) + beyond)
    }

    fn overlap(&self, force: f64) -> f64 {
        let [p, w] = self.load_at_force(force);
        if p <= 0.0 { 0.0 } else { self.compliance * p * (1.0 + w) }
    }

    /// At the end of the law the overlap hardly changes with the force, so that it cannot tell the
    /// slope.
    fn slope_at_force(&self, force: f64) -> f64 {
        let [p, w] = self.load_at_force(force);
        if p <= 0.0 { 0.0 } else { self.thickness / (self.compliance * w) }
    }

    fn slope_rate(&self, force: f64) -> f64 {
        let [_, w] = self.load_at_force(force);
        self.slope_at_force(force) / (force * w)
    }

    fn largest_force(&self) -> f64 {
        self.largest * self.thickness
    }
}
