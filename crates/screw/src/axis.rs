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
        Twist { linear: translational(self.linear), angular: rotational(self.angular) }
    }
}

impl<const N: usize, const M: usize> Wrench<N, M> {
    /// The screw of this wrench: the axis goes through `f x tau / |f|^2`.
    #[must_use]
    pub fn screw(&self) -> Screw {
        read(translational(self.force), rotational(self.torque))
    }
}

/// A direction of the plane or of space, in space.
fn translational<const N: usize>(v: Vector<N>) -> Vector<3> {
    Vector::from_fn(|i| if i < N { v[i] } else { 0.0 })
}

/// A rotation of the plane, which is about z, or of space, in space.
fn rotational<const M: usize>(v: Vector<M>) -> Vector<3> {
    Vector::from_fn(|i| if i + M >= 3 { v[i + M - 3] } else { 0.0 })
}

/// The screw with `line` along its axis and `moment` about the origin.
fn read(line: Vector<3>, moment: Vector<3>) -> Screw {
    let magnitude = line.norm();
    if magnitude > 0.0 {
        let size = magnitude.recip();
        return Screw::Axis { axis: Axis::new(line * size, moment * size), magnitude };
    }
    let magnitude = moment.norm();
    if magnitude > 0.0 {
        return Screw::Free { direction: moment * magnitude.recip(), magnitude };
    }
    Screw::Zero
}
