//! Where things stand in the picture of a contact: in page units about `b`, y up.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::arc::{EllipseArc, Piece};
use crate::contact::ContactPicture;
use crate::error::DrawError;

/// The radius of a finger that is shown whole, and the least overlap for which it is.
const WHOLE_FINGER: f64 = 125.0;
const WHOLE_OVERLAP: f64 = 24.0;

/// The overlap under a finger that is cut off, unless its lens would be wider than this.
const CUT_OVERLAP: f64 = 30.0;
const WIDEST_LENS: f64 = 176.0;

/// The least overlap on which its dimension can be read.
const LEAST_OVERLAP: f64 = 16.0;

/// Half the width of the view around a whole finger, and around one that is cut off.
const WHOLE_HALF: f64 = 190.0;
const CUT_HALF: f64 = 220.0;

/// What is shown of a finger whose center is out of view, and above and below a center in view.
const CUT_TOP: f64 = 160.0;
const FARTHEST_CENTER: f64 = 190.0;
const AROUND_CENTER: f64 = 26.0;
const ABOVE_FINGER: f64 = 12.0;

/// How deep the part is shown below the finger, and how high its boundary beside a hollow.
const BELOW_FINGER: f64 = 85.0;
const HOLLOW_RISE: f64 = 95.0;

/// A circle this large departs from its tangent by less than half of what a page number can
/// write, 0.005, all across the view: `220^2 / 1e7 / 2`.
const STRAIGHT: f64 = 1e7;

/// The contact on the page.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Layout {
    /// `δ`.
    pub(crate) overlap: f64,
    /// The finger's boundary, through `a`.
    pub(crate) finger: Boundary,
    /// The part's boundary, through `b`.
    pub(crate) part: Boundary,
    /// Half the width of the lens of overlap.
    pub(crate) lens: f64,
    /// `a_H`.
    pub(crate) half_width: Option<f64>,
    /// Half the width of the view.
    pub(crate) half: f64,
    /// How far the view reaches above `b`.
    pub(crate) top: f64,
    /// How far it reaches below.
    pub(crate) bottom: f64,
}

impl Layout {
    /// Fits a checked picture into its view.
    pub(crate) fn new(picture: &ContactPicture) -> Result<Self, DrawError> {
        let alpha = picture.overlap / picture.finger_radius;
        let beta = picture.overlap / picture.part_radius;
        let ratio = lens_ratio(alpha, beta);
        let limit = WIDEST_LENS / LEAST_OVERLAP;
        if ratio > limit {
            return Err(DrawError::LensTooFlat { ratio, limit });
        }
        let whole = WHOLE_FINGER * alpha >= WHOLE_OVERLAP;
        let overlap =
            if whole { WHOLE_FINGER * alpha } else { CUT_OVERLAP.min(WIDEST_LENS / ratio) };
        let half_width = match picture.half_width.map(|width| [width, width / picture.overlap]) {
            Some([half_width, share]) if share > ratio => {
                let limit = ratio * picture.overlap;
                return Err(DrawError::ContactBeyondLens { half_width, limit });
            }
            shown => shown.map(|[_, share]| share * overlap),
        };
        let half = if whole { WHOLE_HALF } else { CUT_HALF };
        let finger = Boundary::new(-overlap, overlap / alpha);
        let part = Boundary::new(0.0, -overlap / beta);
        let center = finger.center()[1];
        let top = if whole {
            center + WHOLE_FINGER + ABOVE_FINGER
        } else if center <= FARTHEST_CENTER {
            center + AROUND_CENTER
        } else {
            CUT_TOP
        };
        let least = overlap + BELOW_FINGER;
        let below_center = part.radius + AROUND_CENTER;
        let bottom = if below_center <= half { least.max(below_center) } else { least };
        Ok(Self { overlap, finger, part, lens: ratio * overlap, half_width, half, top, bottom })
    }

    /// How far the finger's boundary is in view.
    pub(crate) fn finger_end(&self) -> End {
        self.finger.end(self.half, self.top + self.overlap)
    }

    /// How far the part's boundary is in view.
    pub(crate) fn part_end(&self) -> End {
        let reach = if self.part.bends_up { HOLLOW_RISE } else { self.bottom };
        self.part.end(self.half, reach)
    }

    /// The angle on either boundary at which the lens ends.
    pub(crate) fn lens_ends(&self) -> [f64; 2] {
        let part = self.part.angle(self.lens);
        let rim = self.part.point(part);
        [self.lens.atan2(self.finger.center()[1] - rim[1]), part]
    }

    /// Whether the finger's center is in view.
    pub(crate) fn shows_finger_center(&self) -> bool {
        self.finger.center()[1] < self.top
    }

    /// Whether the center of a convex part is in view.
    pub(crate) fn shows_part_center(&self) -> bool {
        !self.part.bends_up && self.part.radius < self.bottom
    }
}

/// How far a boundary is in view.
#[derive(Debug, Clone, Copy)]
pub(crate) struct End {
    /// The angle at which it leaves; half a turn if it does not.
    pub(crate) angle: f64,
    /// Whether it leaves sideways, and not across the far end.
    pub(crate) beside: bool,
}

/// Half the width of the lens over the overlap `δ`, from `alpha = δ / r_A` and
/// `beta = δ / r_B`: circles whose centers are `r_A + r_B - δ` apart meet at
/// `h^2 = δ (2 r_A - δ) (2 r_B - δ) (2 r_A + 2 r_B - δ) / (2 (r_A + r_B - δ))^2`.
fn lens_ratio(alpha: f64, beta: f64) -> f64 {
    let relative = alpha + beta;
    let apart = relative - alpha * beta;
    if apart > 0.0 {
        ((2.0 - alpha) * (2.0 - beta) * (relative + apart)).sqrt() / (2.0 * apart)
    } else {
        // Both vanish where the overlap does against the radii.
        f64::INFINITY
    }
}

/// A circular boundary that is level at its apex, on the axis of the contact.
///
/// Points on it are given by their angle at the center from the apex, positive to the right.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Boundary {
    /// The height of its apex.
    apex: f64,
    /// Its radius, at most [`STRAIGHT`].
    pub(crate) radius: f64,
    /// Whether its center is above it.
    pub(crate) bends_up: bool,
}

impl Boundary {
    /// The circle with this radius, which is positive where the center is above the apex.
    fn new(apex: f64, radius: f64) -> Self {
        Self { apex, radius: radius.abs().min(STRAIGHT), bends_up: radius > 0.0 }
    }

    /// Whether it is drawn as a straight line.
    pub(crate) fn is_straight(&self) -> bool {
        self.radius == STRAIGHT
    }

    /// Up where the center is above.
    pub(crate) fn side(&self) -> f64 {
        if self.bends_up { 1.0 } else { -1.0 }
    }

    /// The center.
    pub(crate) fn center(&self) -> [f64; 2] {
        [0.0, self.apex + self.side() * self.radius]
    }

    /// The point at an angle, without cancelling for a slight curvature.
    pub(crate) fn point(&self, angle: f64) -> [f64; 2] {
        let half = (angle / 2.0).sin();
        let rise = 2.0 * self.radius * half * half;
        [self.radius * angle.sin(), self.apex + self.side() * rise]
    }

    /// The angle of its point this far beside the axis, on the side of the apex.
    pub(crate) fn angle(&self, aside: f64) -> f64 {
        (aside / self.radius).min(1.0).asin()
    }

    /// How far from the axis it has departed from the apex's level by this much.
    pub(crate) fn away(&self, rise: f64) -> f64 {
        let rise = rise.min(self.radius);
        (rise * (2.0 * self.radius - rise)).sqrt()
    }

    /// Where it leaves a view of this half width that reaches this far from the apex towards the
    /// center. A circle wider than the view does not come back: then `reach <= half`.
    fn end(&self, half: f64, reach: f64) -> End {
        let beside = if self.radius > half { self.angle(half) } else { PI };
        let diameter = 2.0 * self.radius;
        let beyond = if diameter > reach { 2.0 * (reach / diameter).sqrt().asin() } else { PI };
        End { angle: beside.min(beyond), beside: beside < beyond }
    }

    /// The piece between two angles.
    pub(crate) fn pieces(&self, from: f64, to: f64) -> Vec<Piece> {
        if self.is_straight() {
            return vec![Piece::Corner(self.point(from)), Piece::Corner(self.point(to))];
        }
        vec![Piece::Arc(self.arc(from, to))]
    }

    /// The arc between two angles.
    pub(crate) fn arc(&self, from: f64, to: f64) -> EllipseArc {
        let turned = |angle: f64| self.side() * (angle - FRAC_PI_2);
        EllipseArc::circle(self.center(), self.radius).between(turned(from), turned(to))
    }
}
