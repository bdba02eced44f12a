//! A force and a torque on a rigid body.

use std::ops::{Add, AddAssign, Mul, Sub};

use crate::{Frame, Vector, lever};

/// A load on a rigid body, written about a frame's origin and along its axes.
///
/// [LBR, section 2]: `w = (f, tau)`. In the plane `tau = x f_y - y f_x`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<const N: usize, const M: usize> {
    /// Force (force).
    pub force: Vector<N>,
    /// Torque about the frame's origin (force * length).
    pub torque: Vector<M>,
}

impl<const N: usize, const M: usize> Wrench<N, M> {
    /// No load.
    pub const ZERO: Self = Self { force: Vector::ZERO, torque: Vector::ZERO };

    /// The wrench of `force` acting at `point`, about the origin: `(f, point x f)`.
    #[must_use]
    pub fn of_force_at(force: Vector<N>, point: Vector<N>) -> Self {
        Self { force, torque: -(lever(point).transpose() * force) }
    }

    /// The same wrench, given in the parent of `frame`, written in `frame`: `T^T w` [LBR, eq. 1].
    #[must_use]
    pub fn in_frame(&self, frame: &Frame<N, M>) -> Self {
        let torque = self.torque + frame.lever().transpose() * self.force;
        Self {
            force: frame.axes().transpose() * self.force,
            torque: frame.spin().transpose() * torque,
        }
    }

    /// The same wrench, given in `frame`, written in the parent of `frame`: `T^-T w`.
    #[must_use]
    pub fn to_parent(&self, frame: &Frame<N, M>) -> Self {
        let force = *frame.axes() * self.force;
        let torque = *frame.spin() * self.torque - frame.lever().transpose() * force;
        Self { force, torque }
    }
}

impl<const N: usize, const M: usize> Add for Wrench<N, M> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { force: self.force + other.force, torque: self.torque + other.torque }
    }
}

impl<const N: usize, const M: usize> AddAssign for Wrench<N, M> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const N: usize, const M: usize> Sub for Wrench<N, M> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { force: self.force - other.force, torque: self.torque - other.torque }
    }
}

impl<const N: usize, const M: usize> Mul<f64> for Wrench<N, M> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { force: self.force * factor, torque: self.torque * factor }
    }
}
