//! The screw axis of a twist or a wrench.

use crate::spatial::cross;
use crate::{Twist, Vector, Wrench};

/// A twist or wrench read as a screw [LBR, section 3.2].
///
/// The plane is the slice z = 0 of space: a rotation is about an axis along z.
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
        /// The axis, with its pitch.
        axis: Axis,
        /// Length of the angular velocity, or of the force.
        magnitude: f64,
    },
}

/// The axis of a screw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Unit direction.
    pub direction: Vector<3>,
    /// The point of the axis nearest to the origin (length).
    pub point: Vector<3>,
    /// Translation per rotation, or torque per force (length).
    pub pitch: f64,
}

impl Axis {
    /// The axis of a unit rotation or force along the unit `direction`, with the velocity or
    /// torque `moment` about the origin.
    #[must_use]
    pub fn new(direction: Vector<3>, moment: Vector<3>) -> Self {
        Self { direction, point: cross(direction, moment), pitch: direction.dot(moment) }
    }

    /// What a unit rotation or force along the axis does about the origin: the velocity of the
    /// body there, or the torque (length).
    #[must_use]
    pub fn moment(&self) -> Vector<3> {
        cross(self.point, self.direction) + self.direction * self.pitch
    }

    /// The unit rotation about the axis, with its pitch.
    #[must_use]
    pub fn twist(&self) -> Twist<3, 3> {
        Twist { linear: self.moment(), angular: self.direction }
    }

    /// The unit force along the axis, with its pitch.
    #[must_use]
    pub fn wrench(&self) -> Wrench<3, 3> {
        Wrench { force: self.direction, torque: self.moment() }
    }

    /// The power of a unit wrench on one of the axes along a unit twist on the other (length):
    /// `(h_1 + h_2) cos(alpha) - d sin(alpha)`, with the angle `alpha` from the first direction to
    /// the second about their common normal, and the distance `d` along it.
    ///
    /// If it is zero the screws are reciprocal: a wrench on one does nothing to a body that can
    /// only twist about the other.
    ///
    /// ```
    /// use clench_screw::{Axis, Vector};
    /// let [x, y] = [Vector::new([1.0, 0.0, 0.0]), Vector::new([0.0, 1.0, 0.0])];
    /// let hinge = Axis::new(x, Vector::ZERO);
    /// // A force along y through the hinge does nothing; one at the height 3 turns it by -3.
    /// let through = Axis::new(y, Vector::ZERO);
    /// let above = Axis { point: Vector::new([0.0, 0.0, 3.0]), ..through };
    /// assert_eq!(hinge.reciprocal_product(&through), 0.0);
    /// assert_eq!(hinge.reciprocal_product(&above), -3.0);
    /// ```
    #[must_use]
    pub fn reciprocal_product(&self, other: &Self) -> f64 {
        // About a point of one axis, so that two far axes lose nothing.
        let arm = cross(other.point - self.point, other.direction);
        (self.pitch + other.pitch) * self.direction.dot(other.direction) + self.direction.dot(arm)
    }
}

impl<const N: usize, const M: usize> Twist<N, M> {
    /// The screw of this twist: the axis goes through `omega x v / |omega|^2`.
    ///
    /// LBR print `v x omega`, which has the wrong sign: the velocity of the axis point `p` is
    /// `v + omega x p`, and this is parallel to `omega` for `p = omega x v / |omega|^2` only.
    ///
    /// ```
    /// use clench_screw::{Screw, Vector, planar};
    /// // A turn about (2, 0): the origin moves down y.
    /// let turn = planar::Twist { linear: [0.0, -2.0].into(), angular: [1.0].into() };
    /// let Screw::Axis { axis, .. } = turn.screw() else { unreachable!() };
    /// assert_eq!((axis.point, axis.pitch), (Vector::new([2.0, 0.0, 0.0]), 0.0));
    /// ```
    #[must_use]
    pub fn screw(&self) -> Screw {
        let twist = self.in_space();
        read(twist.angular, twist.linear)
    }

    /// The same twist as one of space, of which the plane is the slice z = 0.
    #[must_use]
    pub fn in_space(&self) -> Twist<3, 3> {
        Twist { linear: self.linear.in_space(), angular: self.angular.in_space() }
    }
}

impl<const N: usize, const M: usize> Wrench<N, M> {
    /// The screw of this wrench: the axis goes through `f x tau / |f|^2`.
    #[must_use]
    pub fn screw(&self) -> Screw {
        read(self.force.in_space(), self.torque.in_space())
    }
}

/// The screw with `line` along its axis and `moment` about the origin.
fn read(line: Vector<3>, moment: Vector<3>) -> Screw {
    // Neither squares of small numbers nor of large ones leave the range.
    if let Some(direction) = line.direction() {
        let magnitude = line.scaled_norm();
        return Screw::Axis { axis: Axis::new(direction, moment * magnitude.recip()), magnitude };
    }
    match moment.direction() {
        Some(direction) => Screw::Free { direction, magnitude: moment.scaled_norm() },
        None => Screw::Zero,
    }
}
