//! A finger that touches a part, and its shape on the page.

use crate::error::{DrawError, Input};
use crate::world_map::{UNSEEN, finite};

/// A finger, touching from outside.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Finger {
    /// Where it touches.
    pub point: [f64; 2],
    /// The unit normal that points into the part.
    pub inward_normal: [f64; 2],
    /// The radius of a disc finger in world units; 0 for a pointed one.
    pub radius: f64,
    /// How hard it presses, in any unit: arrows are in proportion where a force is given, and all
    /// of one length where none is.
    pub force: f64,
    /// Its name; `_{…}` lowers and `^{…}` raises. Empty for none.
    pub label: String,
    /// Its preload, shown after the name in the same blue. Empty for none.
    pub preload: String,
}

impl Finger {
    pub(crate) fn check(&self, index: usize) -> Result<(), DrawError> {
        for value in self.point {
            finite(value, Input::FingerPoint, index)?;
        }
        for value in self.inward_normal {
            finite(value, Input::FingerNormal, index)?;
        }
        finite(self.radius, Input::FingerRadius, index)?;
        finite(self.force, Input::FingerForce, index)?;
        if self.radius < 0.0 {
            return Err(DrawError::NegativeRadius { finger: index, radius: self.radius });
        }
        let length = self.inward_normal[0].hypot(self.inward_normal[1]);
        if (length - 1.0).abs() > UNSEEN {
            return Err(DrawError::NormalNotUnit { finger: index, length });
        }
        Ok(())
    }

    /// The point this far along the normal and to its left; negative is outside the part.
    pub(crate) fn offset(&self, along: f64, aside: f64) -> [f64; 2] {
        let [x, y] = self.inward_normal;
        [self.point[0] + along * x - aside * y, self.point[1] + along * y + aside * x]
    }
}
