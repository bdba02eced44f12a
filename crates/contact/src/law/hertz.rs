//! Hertz' law: two smooth elastic bodies that touch at a point.

use ellip::cel2;

use super::ForceLaw;
use crate::error::positive;
use crate::{ContactError, Geometry, RelativeCurvature};

/// Newton's method on the shape of the ellipse converges quadratically from a start that is right
/// to a factor of 4 for ratios of curvatures up to 1e6; this many steps are the end for any ratio.
const MAX_STEPS: usize = 40;

/// The largest ratio of the relative curvatures: far beyond it the elliptic integrals leave the
/// range of numbers, and any such contact is a line.
pub(crate) const LARGEST_CURVATURE_RATIO: f64 = 1e60;

/// A step in the logarithm of the ratio of the semi-axes this small ends the iteration: the next
/// one, its square, is far below rounding.
const LAST_STEP: f64 = 1e-9;

/// Hertz' law `f = c delta^(3/2)` of an elliptic area of contact [Johnson, chapter 4].
///
/// The gap between the undeformed bodies is `A x^2 + B y^2`, `A <= B`. With the semi-axes
/// `a >= b`, `m = 1 - (b/a)^2`, and the complete elliptic integrals `K(m)`, `E(m)`,
/// `D = (K - E) / m`, `C = K - D`,
///
/// ```text
/// B / A = C / ((1 - m) D)       a^2 = delta D / (K A)
/// f = 2 pi E* / (3 K) sqrt(D / (K A)) delta^(3/2)
/// ```
///
/// The major semi-axis lies along the direction of the smaller relative curvature `A`. The
/// coefficient belongs to the place of contact and stays with it.
///
/// There is no slope without overlap: such a contact needs a preload to have a stiffness.
///
/// ```
/// use clench_contact::Hertz;
/// // A ball of radius 9 mm on a flat with E* = 1000 N/mm^2, pressed in by 0.01 mm.
/// let law = Hertz::circular(1000.0, 9.0)?;
/// let [a, b] = law.semi_axes(0.01);
/// assert!((a - 0.3).abs() < 1e-15 && (b - 0.3).abs() < 1e-15); // sqrt(R delta)
/// # Ok::<(), clench_contact::ContactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hertz {
    effective_modulus: f64,
    /// `b / a`.
    ratio: f64,
    /// `D / (K A)`: the square of the major semi-axis per overlap.
    spread: f64,
    /// `c`.
    coefficient: f64,
}

impl Hertz {
    /// The law of two bodies with the relative radius `radius`, `1 / R = 1 / R_1 + 1 / R_2`
    /// (length), and the effective modulus `E*` (force / length^2).
    ///
    /// # Errors
    ///
    /// [`ContactError::NotPositive`] unless both are positive and finite.
    pub fn circular(effective_modulus: f64, radius: f64) -> Result<Self, ContactError> {
        let curvature = 0.5 / positive("relative radius", radius)?;
        Self::elliptic(effective_modulus, [curvature, curvature])
    }

    /// The law of two bodies whose gap is `A x^2 + B y^2` with `gap = [A, B]`, `A <= B`
    /// (1 / length), and the effective modulus `E*` (force / length^2).
    ///
    /// `2 A` and `2 B` are the principal relative curvatures: see
    /// [`Geometry::relative_curvature`].
    ///
    /// # Errors
    ///
    /// [`ContactError::NotPositive`] unless all three are positive and finite;
    /// [`ContactError::NoEllipse`] when `A > B`, or `B` is more than 1e60 times as large. A line of
    /// contact, `A = 0`, has another law: [`Line`](super::Line).
    pub fn elliptic(effective_modulus: f64, gap: [f64; 2]) -> Result<Self, ContactError> {
        let modulus = positive("effective modulus", effective_modulus)?;
        let a = positive("A of the gap", gap[0])?;
        let b = positive("B of the gap", gap[1])?;
        let no_ellipse = || ContactError::NoEllipse { a, b };
        if a > b || b / a > LARGEST_CURVATURE_RATIO {
            return Err(no_ellipse());
        }
        let ellipse = ellipse(b / a).ok_or_else(no_ellipse)?;
        let spread = ellipse.d / (ellipse.k * a);
        let coefficient = 2.0 * std::f64::consts::PI * modulus / (3.0 * ellipse.k) * spread.sqrt();
        positive("coefficient", coefficient)?;
        let law = Self { effective_modulus: modulus, ratio: ellipse.ratio, spread, coefficient };
        positive("pressure per root of the overlap", law.pressure_per_root())?;
        Ok(law)
    }

    /// The law for the curvatures of finger and part in `geometry`.
    ///
    /// # Errors
    ///
    /// Those of [`Geometry::relative_curvature`] and [`Self::elliptic`];
    /// [`ContactError::LineOfContact`] when one relative curvature is 0, and
    /// [`ContactError::NoGap`] when it is negative.
    pub fn of(effective_modulus: f64, geometry: &Geometry<3>) -> Result<Self, ContactError> {
        let RelativeCurvature { smaller, larger, .. } = geometry.relative_curvature()?;
        if smaller < 0.0 || larger <= 0.0 {
            return Err(ContactError::NoGap { relative_curvature: smaller });
        }
        if smaller <= 0.0 {
            return Err(ContactError::LineOfContact { larger });
        }
        Self::elliptic(effective_modulus, [0.5 * smaller, 0.5 * larger])
    }

    /// The law of the same place with `factor` times the effective modulus.
    pub(super) fn scaled(&self, factor: f64) -> Result<Self, ContactError> {
        let effective_modulus = positive("effective modulus", self.effective_modulus * factor)?;
        let coefficient = positive("coefficient", self.coefficient * factor)?;
        let law = Self { effective_modulus, coefficient, ..*self };
        positive("pressure per root of the overlap", law.pressure_per_root())?;
        Ok(law)
    }

    /// `E*` (force / length^2).
    #[must_use]
    pub const fn effective_modulus(&self) -> f64 {
        self.effective_modulus
    }

    /// `c` (force / length^(3/2)).
    #[must_use]
    pub const fn coefficient(&self) -> f64 {
        self.coefficient
    }

    /// The semi-axes `[a, b]` of the area of contact, `a >= b` (length).
    ///
    /// `a` lies along [`RelativeCurvature::along`](crate::RelativeCurvature::along).
    #[must_use]
    pub fn semi_axes(&self, overlap: f64) -> [f64; 2] {
        let major = (self.spread * overlap).sqrt();
        [major, self.ratio * major]
    }

    /// The pressure in the middle of the area of contact, `3 f / (2 pi a b)` (force / length^2).
    ///
    /// Zero without overlap.
    #[must_use]
    pub fn peak_pressure(&self, overlap: f64) -> f64 {
        self.pressure_per_root() * overlap.sqrt()
    }

    /// `3 f / (2 pi a b)` with the powers of delta collected, so that nothing divides zero by zero.
    fn pressure_per_root(&self) -> f64 {
        1.5 / std::f64::consts::PI * self.coefficient / (self.ratio * self.spread)
    }
}

impl ForceLaw for Hertz {
    fn force(&self, overlap: f64) -> f64 {
        self.coefficient * overlap * overlap.sqrt()
    }

    fn slope(&self, overlap: f64) -> f64 {
        1.5 * self.coefficient * overlap.sqrt()
    }

    fn energy(&self, overlap: f64) -> f64 {
        0.4 * overlap * self.force(overlap)
    }

    fn overlap(&self, force: f64) -> f64 {
        let root = (force / self.coefficient).cbrt();
        root * root
    }

    fn slope_rate(&self, force: f64) -> f64 {
        0.5 / self.overlap(force)
    }
}

/// The shape of an area of contact, and the integrals that belong to it.
struct Ellipse {
    /// `b / a`.
    ratio: f64,
    k: f64,
    d: f64,
}

/// Solves `B / A = C(m) / ((1 - m) D(m))` for `b / a` by Newton's method in `ln(b / a)`.
///
/// `None` when the integrals leave the range of numbers.
fn ellipse(curvature_ratio: f64) -> Option<Ellipse> {
    let wanted = curvature_ratio.ln();
    let mut ratio = curvature_ratio.powf(-2.0 / 3.0);
    for _ in 0..MAX_STEPS {
        let [c, d] = integrals(ratio)?;
        let m = (1.0 - ratio) * (1.0 + ratio);
        // d ln(C / D) / dm from dC/dm = (D - C) / 2m and dD/dm = (C / (1 - m) - D) / 2m; for a
        // circle it is 1/8 - 3/8.
        let square = ratio * ratio;
        let bend = if m > 0.0 { ((d - c) / c - (c / square - d) / d) / (2.0 * m) } else { -0.25 };
        let error = (c / d).ln() - 2.0 * ratio.ln() - wanted;
        let step = error / (2.0 + 2.0 * square * bend);
        // Not beyond the circle.
        ratio = (ratio * step.exp()).min(1.0);
        if step.abs() <= LAST_STEP {
            break;
        }
    }
    let [c, d] = integrals(ratio)?;
    let k = c + d;
    k.is_finite().then_some(Ellipse { ratio, k, d })
}

/// `[C, D]` with `K = C + D`, by Bulirsch's integrals in the complementary modulus `b / a`: no
/// difference is taken, neither near the circle nor near the line.
fn integrals(ratio: f64) -> Option<[f64; 2]> {
    let c = cel2(ratio, 1.0, 0.0).ok()?;
    let d = cel2(ratio, 0.0, 1.0).ok()?;
    Some([c, d])
}
