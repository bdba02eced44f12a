//! A round finger tip, and where it may be.

use clench_screw::Vector;

use crate::{AccessError, Plate};

/// The ball at the end of a finger that touches a solid from outside, and where it may be.
///
/// Nothing of the part is nearer to the ball's center than its radius, nor is any of the boxes that
/// are kept out of; the point that it touches is not too near to where the plane ends; and its
/// center is over a hole of the plate, if there is one.
#[derive(Clone, Debug, PartialEq)]
pub struct BallTip {
    radius: f64,
    margin: f64,
    keep_out: Vec<KeepOut>,
    plate: Option<Plate>,
}

impl BallTip {
    /// A ball (length); of radius 0 it is a point, which touches anywhere.
    ///
    /// # Errors
    ///
    /// [`AccessError::Radius`].
    pub fn new(radius: f64) -> Result<Self, AccessError> {
        if !(radius >= 0.0 && radius.is_finite()) {
            return Err(AccessError::Radius { value: radius });
        }
        Ok(Self { radius, margin: 0.0, keep_out: Vec::new(), plate: None })
    }

    /// The same, which touches no nearer than `margin` (length) to the border of a facet.
    ///
    /// # Errors
    ///
    /// [`AccessError::Margin`].
    pub fn with_margin(self, margin: f64) -> Result<Self, AccessError> {
        if !(margin >= 0.0 && margin.is_finite()) {
            return Err(AccessError::Margin { value: margin });
        }
        Ok(Self { margin, ..self })
    }

    /// The same, which stays out of these boxes.
    #[must_use]
    pub fn keeping_out(self, keep_out: Vec<KeepOut>) -> Self {
        Self { keep_out, ..self }
    }

    /// The same, whose center is over a hole of a plate.
    #[must_use]
    pub fn over(self, plate: Plate) -> Self {
        Self { plate: Some(plate), ..self }
    }

    /// The same with another radius (length).
    ///
    /// # Errors
    ///
    /// [`AccessError::Radius`].
    pub fn with_radius(&self, radius: f64) -> Result<Self, AccessError> {
        Ok(Self { radius: Self::new(radius)?.radius, ..self.clone() })
    }

    /// The radius (length).
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// The least distance from the border of a facet (length).
    #[must_use]
    pub const fn margin(&self) -> f64 {
        self.margin
    }

    /// The boxes that it stays out of.
    #[must_use]
    pub fn keep_out(&self) -> &[KeepOut] {
        &self.keep_out
    }

    /// The plate, if there is one.
    #[must_use]
    pub const fn plate(&self) -> Option<&Plate> {
        self.plate.as_ref()
    }

    /// Whether it touches anything that is convex anywhere.
    pub(super) fn is_free(&self) -> bool {
        self.margin <= 0.0 && self.keep_out.is_empty() && self.plate.is_none()
    }
}

/// A box along the axes in which nothing of a finger may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeepOut {
    from: Vector<3>,
    to: Vector<3>,
}

impl KeepOut {
    /// The box between two opposite corners (length).
    ///
    /// # Errors
    ///
    /// [`AccessError::KeepOut`] if a coordinate of `from` is not below that of `to`, or one is not
    /// finite.
    pub fn new(from: [f64; 3], to: [f64; 3]) -> Result<Self, AccessError> {
        let is_sound = |axis: &usize| {
            let (from, to) = (from[*axis], to[*axis]);
            from.is_finite() && to.is_finite() && from < to
        };
        match (0..3).find(|axis| !is_sound(axis)) {
            Some(axis) => Err(AccessError::KeepOut { axis, from: from[axis], to: to[axis] }),
            None => Ok(Self { from: from.into(), to: to.into() }),
        }
    }

    /// The lowest corner.
    #[must_use]
    pub const fn from(&self) -> Vector<3> {
        self.from
    }

    /// The highest corner.
    #[must_use]
    pub const fn to(&self) -> Vector<3> {
        self.to
    }

    /// The distance of a point (length), 0 inside.
    pub(super) fn distance(&self, point: Vector<3>) -> f64 {
        let out = |i: usize| (self.from[i] - point[i]).max(point[i] - self.to[i]).max(0.0);
        Vector::<3>::from_fn(out).norm()
    }

    /// The corners; bit `i` of the number says whether coordinate `i` is that of `to`.
    pub(super) fn corners(&self) -> [Vector<3>; 8] {
        let end = |n: usize, i: usize| if n >> i & 1 == 1 { self.to[i] } else { self.from[i] };
        std::array::from_fn(|n| Vector::from_fn(|i| end(n, i)))
    }
}
