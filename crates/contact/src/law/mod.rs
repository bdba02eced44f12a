//! Force laws: the contact force as a function of the overlap.

mod custom;
mod hertz;
mod line;
mod linear;
mod power;

pub use custom::CustomLaw;
use custom::Scaled;
pub use hertz::Hertz;
pub(crate) use hertz::LARGEST_CURVATURE_RATIO;
pub use line::{Line, LineContact};
pub use linear::Linear;
pub use power::Power;

use std::fmt::Debug;

use crate::error::positive;
use crate::{ContactError, Geometry};

/// The step of a central difference relative to the force: the cube root of the rounding, where
/// the error of the difference, its square, equals what the rounding of the two values leaves.
const DIFFERENCE: f64 = 6.055_454_452_393_343e-6;

/// What a force law has to answer; implement it for one of your own, and wrap that in
/// [`Law::custom`].
///
/// A law is increasing and starts at the origin, and is only asked about overlaps and forces that
/// are not negative. All numbers are in one consistent set of units.
pub trait ForceLaw: Debug + Send + Sync {
    /// The force `f(delta)` of an overlap that is not negative.
    fn force(&self, overlap: f64) -> f64;

    /// The slope `f'(delta)` (force / length).
    fn slope(&self, overlap: f64) -> f64;

    /// The energy, the integral of `f` from 0 to `delta` (force * length).
    fn energy(&self, overlap: f64) -> f64;

    /// The overlap at which the force is `force`, which is between 0 and [`Self::largest_force`].
    fn overlap(&self, force: f64) -> f64;

    /// The slope where the force is `force`; for laws whose slope is not well determined by the
    /// overlap.
    fn slope_at_force(&self, force: f64) -> f64 {
        self.slope(self.overlap(force))
    }

    /// How fast the slope grows with the force, `df'/df` (1 / length), where the force is `force`
    /// and positive.
    ///
    /// Unless a law says it, by a central difference of [`Self::slope_at_force`], good to about
    /// ten digits where the law is as smooth as a power.
    fn slope_rate(&self, force: f64) -> f64 {
        let step = force * DIFFERENCE;
        let (above, below) = (force + step, force - step);
        (self.slope_at_force(above) - self.slope_at_force(below)) / (above - below)
    }

    /// The force up to which the law holds; infinite unless it says otherwise.
    fn largest_force(&self) -> f64 {
        f64::INFINITY
    }
}

/// How the contact force `f` follows from the overlap `delta >= 0`.
///
/// ```
/// use clench_contact::Law;
/// let law = Law::power(3.0, 2.0)?;
/// assert_eq!((law.force(2.0), law.slope(2.0), law.energy(2.0)), (12.0, 12.0, 8.0));
/// assert_eq!(law.overlap(12.0), 2.0);
/// # Ok::<(), clench_contact::ContactError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Law {
    /// `f = k delta` [LBR, eq. 3].
    Linear(Linear),
    /// `f = c delta^p`.
    Power(Power),
    /// Hertz' law of two smooth elastic bodies that touch at a point.
    Hertz(Hertz),
    /// The law of a disc on a straight edge, which touch along a line through the thickness.
    Line(Line),
    /// A law of the caller's own.
    Custom(CustomLaw),
}

impl Law {
    /// The linear law with `stiffness` (force / length).
    ///
    /// # Errors
    ///
    /// [`ContactError::NotPositive`] unless the stiffness is positive and finite.
    pub fn linear(stiffness: f64) -> Result<Self, ContactError> {
        Linear::new(stiffness).map(Self::Linear)
    }

    /// The power law with `coefficient` (force / length^exponent) and `exponent`.
    ///
    /// # Errors
    ///
    /// [`ContactError::NotPositive`] unless both are positive and finite.
    pub fn power(coefficient: f64, exponent: f64) -> Result<Self, ContactError> {
        Power::new(coefficient, exponent).map(Self::Power)
    }

    /// Hertz' law for the curvatures of finger and part in `geometry`, with the
    /// `effective_modulus` `E*` (force / length^2) of [`effective_modulus`]. Area and pressure of
    /// the contact are asked of the [`Hertz`] inside.
    ///
    /// # Errors
    ///
    /// Those of [`Hertz::of`].
    ///
    /// [`effective_modulus`]: crate::effective_modulus
    pub fn hertz(effective_modulus: f64, geometry: &Geometry<3>) -> Result<Self, ContactError> {
        Hertz::of(effective_modulus, geometry).map(Self::Hertz)
    }

    /// The law of a disc on a straight edge.
    ///
    /// # Errors
    ///
    /// Those of [`Line::new`].
    pub fn line(contact: &LineContact) -> Result<Self, ContactError> {
        Line::new(contact).map(Self::Line)
    }

    /// A law of the caller's own.
    #[must_use]
    pub fn custom(law: impl ForceLaw + 'static) -> Self {
        Self::Custom(CustomLaw::new(law))
    }

    /// The law itself, whichever it is.
    fn as_force_law(&self) -> &dyn ForceLaw {
        match self {
            Self::Linear(law) => law,
            Self::Power(law) => law,
            Self::Hertz(law) => law,
            Self::Line(law) => law,
            Self::Custom(law) => law.as_force_law(),
        }
    }

    /// The force `f(delta)`; 0 where the bodies are apart.
    #[must_use]
    pub fn force(&self, overlap: f64) -> f64 {
        if overlap < 0.0 { 0.0 } else { self.as_force_law().force(overlap) }
    }

    /// The slope `f'(delta)` (force / length); 0 where the bodies are apart.
    #[must_use]
    pub fn slope(&self, overlap: f64) -> f64 {
        if overlap < 0.0 { 0.0 } else { self.as_force_law().slope(overlap) }
    }

    /// The energy, the integral of `f` from 0 to `delta` (force * length); 0 where the bodies are
    /// apart.
    #[must_use]
    pub fn energy(&self, overlap: f64) -> f64 {
        if overlap < 0.0 { 0.0 } else { self.as_force_law().energy(overlap) }
    }

    /// The overlap at which the force is `force`, between 0 and [`Self::largest_force`].
    #[must_use]
    pub fn overlap(&self, force: f64) -> f64 {
        self.as_force_law().overlap(force)
    }

    /// The slope `f'` where the force is `force` (force / length).
    #[must_use]
    pub fn slope_at_force(&self, force: f64) -> f64 {
        self.as_force_law().slope_at_force(force)
    }

    /// How fast the slope grows with the force, `df'/df` (1 / length), at a positive `force`.
    #[must_use]
    pub fn slope_rate(&self, force: f64) -> f64 {
        self.as_force_law().slope_rate(force)
    }

    /// The law whose force is `factor` times as large at each overlap: of elastic bodies the one
    /// of moduli that are `factor` times as large.
    ///
    /// # Errors
    ///
    /// [`ContactError::NotPositive`] unless the factor is positive and finite, and so is what the
    /// law consists of after it.
    ///
    /// ```
    /// use clench_contact::Law;
    /// let law = Law::power(3.0, 2.0)?.scaled(2.0)?;
    /// assert_eq!((law.force(2.0), law.slope(2.0)), (24.0, 24.0));
    /// # Ok::<(), clench_contact::ContactError>(())
    /// ```
    pub fn scaled(&self, factor: f64) -> Result<Self, ContactError> {
        let factor = positive("factor", factor)?;
        Ok(match self {
            Self::Linear(law) => Self::Linear(Linear::new(law.stiffness() * factor)?),
            Self::Power(law) => Self::power(law.coefficient() * factor, law.exponent())?,
            Self::Hertz(law) => Self::Hertz(law.scaled(factor)?),
            Self::Line(law) => Self::Line(law.scaled(factor)?),
            Self::Custom(law) => Self::custom(Scaled { law: law.clone(), factor }),
        })
    }

    /// The force up to which the law holds; infinite for all but [`Law::Line`].
    #[must_use]
    pub fn largest_force(&self) -> f64 {
        self.as_force_law().largest_force()
    }
}
