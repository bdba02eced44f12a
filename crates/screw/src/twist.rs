//! A small displacement or velocity of a rigid body.

use std::ops::{Add, Mul, Sub};

use crate::{Frame, Mat, Vector, Wrench, lever};

/// A small displacement of a rigid body, written about a frame's origin and along its axes.
///
/// [LBR, section 2]: `q = (v, omega)`. Counter-clockwise rotation is positive in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist<const N: usize, const M: usize> {
    /// Velocity of the body point at the frame's origin (length).
    pub linear: Vector<N>,
    /// Angular velocity (rad).
    pub angular: Vector<M>,
}

impl<const N: usize, const M: usize> Twist<N, M> {
    /// No displacement.
    pub const ZERO: Self = Self { linear: Vector::ZERO, angular: Vector::ZERO };

    /// The same twist, given in the parent of `frame`, written in `frame`: `T^-1 q` [LBR, eq. 1].
    #[must_use]
    pub fn in_frame(&self, frame: &Frame<N, M>) -> Self {
        Self {
            linear: frame.axes().transpose() * self.velocity_at(frame.origin()),
            angular: frame.spin().transpose() * self.angular,
        }
    }

    /// The same twist, given in `frame`, written in the parent of `frame`: `T q`.
    #[must_use]
    pub fn to_parent(&self, frame: &Frame<N, M>) -> Self {
        let angular = *frame.spin() * self.angular;
        Self { linear: *frame.axes() * self.linear + frame.lever() * angular, angular }
    }

    /// The velocity of the body point at `point`: `v + omega x point`.
    #[must_use]
    pub fn velocity_at(&self, point: Vector<N>) -> Vector<N> {
        self.linear - lever(point) * self.angular
    }

    /// How the velocity changes from point to point: `omega x`, as a matrix that acts on points.
    ///
    /// The velocity of the body point `x` is `linear + velocity_gradient * x`; in the plane the
    /// matrix is `omega [[0, -1], [1, 0]]`.
    ///
    /// ```
    /// use clench_screw::{Mat, Vector, planar};
    /// let turn = planar::Twist { linear: Vector::ZERO, angular: [2.0].into() };
    /// assert_eq!(turn.velocity_gradient(), Mat::new([[0.0, -2.0], [2.0, 0.0]]));
    /// ```
    #[must_use]
    pub fn velocity_gradient(&self) -> Mat<N, N> {
        let whole = lever::<3, 3>(self.angular.in_space());
        Mat::from_fn(|i, j| whole[i][j])
    }

    /// The power of `wrench` along this twist, which no change of frame alters.
    #[must_use]
    pub fn power(&self, wrench: &Wrench<N, M>) -> f64 {
        self.linear.dot(wrench.force) + self.angular.dot(wrench.torque)
    }
}

impl<const N: usize, const M: usize> Add for Twist<N, M> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { linear: self.linear + other.linear, angular: self.angular + other.angular }
    }
}

impl<const N: usize, const M: usize> Sub for Twist<N, M> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { linear: self.linear - other.linear, angular: self.angular - other.angular }
    }
}

impl<const N: usize, const M: usize> Mul<f64> for Twist<N, M> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { linear: self.linear * factor, angular: self.angular * factor }
    }
}
