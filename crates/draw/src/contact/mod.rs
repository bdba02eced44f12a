//! The cross-section of one contact.

mod drawing;
mod labels;
mod layout;

use crate::contact::layout::Layout;
use crate::error::{DrawError, Input};
use crate::figure::Figure;
use crate::world_map::finite;

/// The largest overlap that is drawn, in parts of the smaller radius: the names of its dimensions
/// need the rest.
const DEEPEST: f64 = 0.5;

/// The cross-section of a round finger that presses into a part, to one scale in both
/// directions, drawn by [`ContactPicture::figure`].
///
/// It shows the undeformed shapes of the finger `A` and the part `B`: where they overlap, the
/// deepest points `b` of the part and `a` of the finger, the overlap `δ` between them, the
/// inward normal `n`, the finger's center `c` and the radii `r_A` and `r_B`. What is larger than
/// the view is cut off. Lengths are in one unit, of any size; nothing is computed from them but
/// the outline of the overlap, so all numbers of the caption come from the caller.
///
/// A real overlap is a small part of the radii and cannot be seen: draw one that is larger, and
/// say how much in the caption.
///
/// ```
/// use clench_draw::ContactPicture;
///
/// let picture = ContactPicture {
///     finger_radius: 5.0,
///     part_radius: 12.0,
///     overlap: 1.0,
///     half_width: Some(1.9),
///     caption: vec!["δ drawn 100 times larger".into()],
/// };
/// // A finger that is shown whole has a radius of 125 page units: 25 a unit.
/// let svg = picture.figure()?.to_svg();
/// assert!(svg.contains(">δ drawn 100 times larger</text>"));
/// // From b, 25 down to a.
/// assert!(svg.contains("cx=\"190\" cy=\"237\"") && svg.contains("cx=\"190\" cy=\"262\""));
/// # Ok::<(), clench_draw::DrawError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ContactPicture {
    /// `r_A`, the radius of the finger; positive.
    pub finger_radius: f64,
    /// `r_B`, the radius of the part's boundary: positive where it is convex, negative where
    /// hollow, infinite where flat.
    pub part_radius: f64,
    /// `δ`, the overlap of the undeformed shapes; positive.
    pub overlap: f64,
    /// `a_H`, half the width of the area of contact, at this overlap.
    pub half_width: Option<f64>,
    /// Lines of text beside the drawing; `_{…}` lowers and `^{…}` raises.
    pub caption: Vec<String>,
}

impl ContactPicture {
    /// Draws the picture.
    ///
    /// # Errors
    /// - [`DrawError::NotFinite`] for a number that is none; only the part's radius may be
    ///   infinite, and not negative;
    /// - [`DrawError::NotPositive`] for the finger's radius, the overlap and the half width;
    /// - [`DrawError::TightHollow`] for a finger as wide as the hollow;
    /// - [`DrawError::OverlapTooDeep`] beyond half the smaller radius: always for a pointed part;
    /// - [`DrawError::LensTooFlat`] for an overlap too slight to be seen;
    /// - [`DrawError::ContactBeyondLens`] for an area of contact wider than the overlap.
    pub fn figure(&self) -> Result<Figure, DrawError> {
        self.check()?;
        drawing::draw(&Layout::new(self)?, &self.caption)
    }

    fn check(&self) -> Result<(), DrawError> {
        positive(self.finger_radius, Input::FingerRadius)?;
        positive(self.overlap, Input::Overlap)?;
        if let Some(half_width) = self.half_width {
            positive(half_width, Input::HalfWidth)?;
        }
        if self.part_radius != f64::INFINITY {
            finite(self.part_radius, Input::PartRadius, 0)?;
        }
        let (finger, part) = (self.finger_radius, self.part_radius.abs());
        let limit = DEEPEST * finger.min(part);
        if self.overlap > limit {
            return Err(DrawError::OverlapTooDeep { overlap: self.overlap, limit });
        }
        if self.part_radius < 0.0 && finger >= part {
            return Err(DrawError::TightHollow { finger, hollow: part });
        }
        Ok(())
    }
}

fn positive(value: f64, input: Input) -> Result<(), DrawError> {
    if finite(value, input, 0)? > 0.0 {
        Ok(())
    } else {
        Err(DrawError::NotPositive { input, value })
    }
}
