//! The screw axis of a spatial twist or wrench.

use crate::Vector;
use crate::spatial::{Twist, Wrench, cross};

/// A spatial twist or wrench read as a screw [LBR, section 3.2].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Screw {
    /// No motion, or no load.
    Zero,
    /// A pure translation or a pure couple: no axis, infinite pitch.
    Free {
        /// Unit direction.
        direction: Vector<3>,
        /// Length of the velocity, or of the torque.
        magnitude: f64,
    },
    /// A rotation about an axis with a translation along it, or a force with a torque about it.
    Axis {
        /// Unit direction of the axis.
        direction: Vector<3>,
        /// The point of the axis nearest to the origin (length).
        point: Vector<3>,
        /// Translation per rotation, or torque per force (length).
        pitch: f64,
        /// Length of the angular velocity, or of the force.
        magnitude: f64,
    },
}

impl Twist {
    /// The screw of this twist: the axis goes through `omega x v / |omega|^2`.
    ///
    /// LBR print `v x omega`, which has the wrong sign: the velocity of the axis point `p` is
    /// `v + omega x p`, and this is parallel to `omega` for `p = omega x v / |omega|^2` only.
    ///
    /// ```
    /// use clench_screw::{Screw, Vector, spatial::Twist};
    /// // A turn about the axis through (2, 0, 0) along z: the origin moves down y.
    /// let turn = Twist { linear: [0.0, -2.0, 0.0].into(), angular: [0.0, 0.0, 1.0].into() };
    /// let Screw::Axis { point, pitch, .. } = turn.screw() else { unreachable!() };
    /// assert_eq!((point, pitch), (Vector::new([2.0, 0.0, 0.0]), 0.0));
    /// ```
    #[must_use]
    pub fn screw(&self) -> Screw {
        read(self.angular, self.linear)
    }
}

impl Wrench {
    /// The screw of this wrench: the axis goes through `f x tau / |f|^2`.
    #[must_use]
    pub fn screw(&self) -> Screw {
        read(self.force, self.torque)
    }
}

/// The screw with `line` along its axis and `moment` about the origin.
fn read(line: Vector<3>, moment: Vector<3>) -> Screw {
    let magnitude = line.norm();
    if magnitude > 0.0 {
        let direction = line * magnitude.recip();
        let moment = moment * magnitude.recip();
        let (point, pitch) = (cross(direction, moment), direction.dot(moment));
        return Screw::Axis { direction, point, pitch, magnitude };
    }
    let magnitude = moment.norm();
    if magnitude > 0.0 {
        return Screw::Free { direction: moment * magnitude.recip(), magnitude };
    }
    Screw::Zero
}
