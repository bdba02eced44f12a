//! A coordinate frame: an origin and axes, seen from a parent frame.

use std::ops::Mul;

use crate::{Mat, Vector, lever};

/// A frame given by its origin and axes in a parent frame.
///
/// It changes twists, wrenches and stiffnesses by the matrix of [LBR, eq. 2]
///
/// `T = [[A, lever(r) S], [0, S]]`,
///
/// with `A` the axes (`N` x `N`), `S` their action on angular velocities (`M` x `M`; 1 in the
/// plane), and `r` the origin (length). `a * b` is the frame that has coordinates `b` in frame
/// `a`. Composition and inversion are products of these blocks, the same in plane and space.
///
/// ```
/// use clench_screw::planar::Frame;
/// let quarter = Frame::new([2.0, 0.0], std::f64::consts::FRAC_PI_2);
/// let point = quarter.point_to_parent([1.0, 0.0].into());
/// assert!((point[0] - 2.0).abs() < 1e-15 && (point[1] - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<const N: usize, const M: usize> {
    origin: Vector<N>,
    axes: Mat<N, N>,
    spin: Mat<M, M>,
}

impl<const N: usize, const M: usize> Frame<N, M> {
    /// The parent frame itself.
    pub const IDENTITY: Self =
        Self { origin: Vector::ZERO, axes: Mat::IDENTITY, spin: Mat::IDENTITY };

    /// The frame with the parent's axes and its origin at `origin`.
    #[must_use]
    pub const fn at(origin: Vector<N>) -> Self {
        Self { origin, axes: Mat::IDENTITY, spin: Mat::IDENTITY }
    }

    /// The frame with orthonormal `axes` (columns) that act on angular velocities as `spin`.
    ///
    /// Only the constructors of `planar` and `spatial` know which spin belongs to which axes.
    pub(crate) const fn from_parts(origin: Vector<N>, axes: Mat<N, N>, spin: Mat<M, M>) -> Self {
        Self { origin, axes, spin }
    }

    /// The change of twists when the world frame and the body frame are both replaced
    /// [LBR, eqs. 1 and 2].
    ///
    /// `pose` is the body frame seen from the world; `world` is the new world frame seen from the
    /// old one, `body` the new body frame seen from the old one. Twists and wrenches in hybrid
    /// coordinates (about the body frame's origin, along the world's axes) are then rewritten by
    /// `in_frame` of the result. The origin of `world` and the axes of `body` do not matter.
    #[must_use]
    pub fn of_change(pose: &Self, world: &Self, body: &Self) -> Self {
        Self { origin: pose.axes * body.origin, axes: world.axes, spin: world.spin }
    }

    /// The origin, in the parent frame.
    #[must_use]
    pub const fn origin(&self) -> Vector<N> {
        self.origin
    }

    /// The axes as columns, in the parent frame.
    #[must_use]
    pub const fn axes(&self) -> &Mat<N, N> {
        &self.axes
    }

    /// The matrix by which angular velocities and torques turn into the parent frame's.
    #[must_use]
    pub const fn spin(&self) -> &Mat<M, M> {
        &self.spin
    }

    /// The lever map of the origin, along the parent's axes: `r x omega = lever * omega`.
    #[must_use]
    pub fn lever(&self) -> Mat<N, M> {
        lever(self.origin)
    }

    /// The parent frame seen from this one.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let axes = self.axes.transpose();
        Self { origin: -(axes * self.origin), axes, spin: self.spin.transpose() }
    }

    /// The point with coordinates `point` in this frame, in the parent frame.
    #[must_use]
    pub fn point_to_parent(&self, point: Vector<N>) -> Vector<N> {
        self.origin + self.axes * point
    }

    /// The point with coordinates `point` in the parent frame, in this frame.
    #[must_use]
    pub fn point_in_frame(&self, point: Vector<N>) -> Vector<N> {
        self.axes.transpose() * (point - self.origin)
    }

    /// The direction with components `direction` in this frame, in the parent frame.
    #[must_use]
    pub fn direction_to_parent(&self, direction: Vector<N>) -> Vector<N> {
        self.axes * direction
    }

    /// The direction with components `direction` in the parent frame, in this frame.
    #[must_use]
    pub fn direction_in_frame(&self, direction: Vector<N>) -> Vector<N> {
        self.axes.transpose() * direction
    }
}

impl<const N: usize, const M: usize> Mul for Frame<N, M> {
    type Output = Self;
    fn mul(self, child: Self) -> Self {
        Self {
            origin: self.point_to_parent(child.origin),
            axes: self.axes * child.axes,
            spin: self.spin * child.spin,
        }
    }
}
