//! A round finger tip in the plane.

use crate::{AccessError, Plate, Polygon};

/// The disc at the end of a finger that touches an outline from outside, and where it may be.
///
/// A finger of radius `r` that touches an edge at `p` has its center at `p - r n`, with `n` the
/// inward normal. Nothing of the part is nearer to the center than the radius, nor is any of the
/// regions that are kept out of; and the center is over a hole of the plate, if there is one.
/// Touching is allowed.
#[derive(Clone, Debug, PartialEq)]
pub struct DiscTip {
    radius: f64,
    keep_out: Vec<Polygon>,
    plate: Option<Plate>,
}

impl DiscTip {
    /// A disc (length); of radius 0 it is a point, which touches anywhere.
    ///
    /// # Errors
    ///
    /// [`AccessError::Radius`].
    pub fn new(radius: f64) -> Result<Self, AccessError> {
        if radius >= 0.0 && radius.is_finite() {
            Ok(Self { radius, keep_out: Vec::new(), plate: None })
        } else {
            Err(AccessError::Radius { value: radius })
        }
    }

    /// The same, which stays out of these regions.
    #[must_use]
    pub fn keeping_out(self, keep_out: Vec<Polygon>) -> Self {
        Self { keep_out, ..self }
    }

    /// The same, whose center is over a hole of a plate.
    #[must_use]
    pub fn over(self, plate: Plate) -> Self {
        Self { plate: Some(plate), ..self }
    }

    /// The radius (length).
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// The regions that it stays out of.
    #[must_use]
    pub fn keep_out(&self) -> &[Polygon] {
        &self.keep_out
    }

    /// The plate, if there is one.
    #[must_use]
    pub const fn plate(&self) -> Option<&Plate> {
        self.plate.as_ref()
    }
}
