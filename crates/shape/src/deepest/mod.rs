//! How deep two bodies overlap, and where.

mod convex;
mod ellipsoids;
mod error;
mod hulls_in_plane;
mod hulls_in_space;

use clench_screw::Vector;

pub use error::{BodyError, OverlapError, Side};

pub(crate) use convex::{Convex, in_own_units};
pub(crate) use ellipsoids::deepest_of_ellipsoids;
pub(crate) use hulls_in_plane::{ellipse_and_points, points_in_plane};
pub(crate) use hulls_in_space::{ellipsoid_and_points, points_in_space};

use crate::{Ball, Nearest};

/// An offset below this many roundings of the coordinates that it is a difference of is noise.
const OFFSET_ROUNDING: f64 = 2.0 * f64::EPSILON;

/// The points by which a finger and a part overlap most, or are nearest if they are apart.
///
/// `on_finger - on_part = depth * inward_normal`: moving the part by that much separates the two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeepestPair<const N: usize> {
    /// The overlap `delta` (length): the least translation that separates the two, or minus their
    /// distance.
    pub depth: f64,
    /// The unit normal that points from the finger into the part.
    pub inward_normal: Vector<N>,
    /// The point of the finger deepest in the part, or nearest to it.
    pub on_finger: Vector<N>,
    /// The point of the part deepest in the finger, or nearest to it.
    pub on_part: Vector<N>,
}

impl<const N: usize> DeepestPair<N> {
    /// The pair with the roles of finger and part exchanged.
    pub(crate) fn exchanged(self) -> Self {
        Self {
            depth: self.depth,
            inward_normal: -self.inward_normal,
            on_finger: self.on_part,
            on_part: self.on_finger,
        }
    }

    /// The pair when the finger, which was its bare center, has a radius.
    pub(crate) fn with_radius(self, radius: f64) -> Self {
        Self {
            depth: self.depth + radius,
            on_finger: self.on_finger + self.inward_normal * radius,
            ..self
        }
    }
}

/// The pair of a ball and a surface: from the point of the surface nearest to the ball's center.
pub(crate) fn ball_at<const N: usize>(ball: &Ball<N>, near: Surface<N>) -> DeepestPair<N> {
    DeepestPair {
        depth: -near.signed_distance,
        inward_normal: near.inward_normal,
        on_finger: ball.center(),
        on_part: near.foot,
    }
    .with_radius(ball.radius())
}

/// The point of a body's surface nearest to some point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<const N: usize> {
    /// The nearest point of the surface.
    pub(crate) foot: Vector<N>,
    /// Its distance, negative inside.
    pub(crate) signed_distance: f64,
    /// The unit vector along the offset, into the body.
    pub(crate) inward_normal: Vector<N>,
}

impl<const N: usize> Surface<N> {
    /// The nearest point of the surface at a corner or an edge, where the outside is against
    /// `inward`.
    pub(crate) fn at(foot: Vector<N>, point: Vector<N>, inward: Vector<N>) -> Self {
        let offset = point - foot;
        let distance = offset.norm();
        let side = if inward.dot(offset) > 0.0 { 1.0 } else { -1.0 };
        // So near, the offset has no digits left to say where it points.
        let level = OFFSET_ROUNDING * (foot.max_abs() + point.max_abs());
        let along = if distance > level { offset * side } else { inward };
        Self {
            foot,
            signed_distance: -side * distance,
            inward_normal: along * (1.0 / along.norm()),
        }
    }
}

impl<const N: usize> From<Nearest<N>> for Surface<N> {
    fn from(near: Nearest<N>) -> Self {
        Self {
            foot: near.boundary.point,
            signed_distance: near.signed_distance,
            inward_normal: near.boundary.inward_normal,
        }
    }
}

/// The surface point nearest to the center of one ball, on another.
pub(crate) fn on_ball<const N: usize>(ball: &Ball<N>, point: Vector<N>) -> Surface<N> {
    let offset = ball.center() - point;
    let distance = offset.norm();
    // From the center all directions are as good.
    let any = Vector::from_fn(|i| f64::from(u8::from(i == 0)));
    let inward_normal = if distance > 0.0 { offset * (1.0 / distance) } else { any };
    Surface {
        foot: ball.center() - inward_normal * ball.radius(),
        signed_distance: distance - ball.radius(),
        inward_normal,
    }
}
