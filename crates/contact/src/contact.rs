//! One finger on one face: geometry, force law and preload together.

use clench_screw::{Stiffness, Vector, Wrench};

use crate::error::{not_negative, positive};
use crate::{ContactError, Law, Overlap};

/// Which terms of [LBR, eq. 6] a stiffness has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// `f' grad grad^T` only: what does not depend on curvature and preload.
    First,
    /// `f' grad grad^T + f D^2 delta`.
    Second,
}

/// A round finger pressed on a flat face of the body by a preload.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<const N: usize, const M: usize> {
    overlap: Overlap<N, M>,
    law: Law,
    preload: f64,
    slope: f64,
}

impl<const N: usize, const M: usize> Contact<N, M> {
    /// The contact at `point` on the body's boundary, along `inward_normal` (of any length), of a
    /// finger with the tip radius `radius`, that presses with the force `preload`; the overlap
    /// follows from the law. Lengths, forces and the frame are the caller's.
    ///
    /// # Errors
    ///
    /// [`ContactError::NotFinite`], [`ContactError::NoNormal`] and [`ContactError::Negative`]
    /// (radius, preload) name what is wrong; [`ContactError::NoStiffness`] when the law has no
    /// finite positive slope at this preload.
    pub fn new(
        point: Vector<N>,
        inward_normal: Vector<N>,
        radius: f64,
        law: Law,
        preload: f64,
    ) -> Result<Self, ContactError> {
        let point = finite("contact point", point)?;
        let normal = unit(finite("inward normal", inward_normal)?)?;
        let radius = not_negative("finger radius", radius)?;
        let preload = not_negative("preload", preload)?;
        let depth = law.overlap(preload);
        let slope = law.slope(depth);
        positive("slope", slope).map_err(|_| ContactError::NoStiffness { slope })?;
        let overlap = Overlap::new(point, normal, radius, depth);
        Ok(Self { overlap, law, preload, slope })
    }

    /// Where the finger touches, and how deep.
    #[must_use]
    pub const fn overlap(&self) -> &Overlap<N, M> {
        &self.overlap
    }

    /// The force law.
    #[must_use]
    pub const fn law(&self) -> &Law {
        &self.law
    }

    /// `f`, the contact force at rest (force).
    #[must_use]
    pub const fn preload(&self) -> f64 {
        self.preload
    }

    /// `f'`, the slope of the law at rest (force / length).
    #[must_use]
    pub const fn slope(&self) -> f64 {
        self.slope
    }

    /// The wrench on the body of a unit contact force, about `origin`: `(n, b x n)`.
    #[must_use]
    pub fn unit_wrench(&self, origin: Vector<N>) -> Wrench<N, M> {
        self.overlap.gradient(origin) * -1.0
    }

    /// This contact's share of the stiffness, about `origin` [LBR, eq. 6].
    #[must_use]
    pub fn stiffness(&self, origin: Vector<N>, order: Order) -> Stiffness<N, M> {
        let first = Stiffness::outer(&self.overlap.gradient(origin)) * self.slope;
        match order {
            Order::First => first,
            Order::Second => first + self.overlap.hessian(origin) * self.preload,
        }
    }
}

fn finite<const N: usize>(
    parameter: &'static str,
    vector: Vector<N>,
) -> Result<Vector<N>, ContactError> {
    match (0..N).find(|&axis| !vector[axis].is_finite()) {
        Some(axis) => Err(ContactError::NotFinite { parameter, axis, value: vector[axis] }),
        None => Ok(vector),
    }
}

/// `vector` at unit length; divided by its largest component first, so that no square underflows.
fn unit<const N: usize>(vector: Vector<N>) -> Result<Vector<N>, ContactError> {
    let size = vector.max_abs();
    if size > 0.0 {
        let scaled = Vector::from_fn(|i| vector[i] / size);
        return Ok(scaled * scaled.norm().recip());
    }
    Err(ContactError::NoNormal)
}
