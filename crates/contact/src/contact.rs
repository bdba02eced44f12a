//! One finger on the part: geometry, force law and preload together.

use clench_screw::{Stiffness, Vector, Wrench};

use crate::error::{not_negative, positive};
use crate::{ContactError, Geometry, Law, Overlap};

/// Which terms of [LBR, eq. 6] a stiffness has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// `f' grad grad^T` only: what springs at the contacts would give. Of the preload it knows the
    /// slope of the law there.
    First,
    /// `f' grad grad^T + f D^2 delta`.
    Second,
}

/// A finger pressed on the part by a preload.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact<const N: usize, const M: usize> {
    overlap: Overlap<N, M>,
    law: Law,
    preload: f64,
    slope: f64,
}

impl<const N: usize, const M: usize> Contact<N, M> {
    /// The contact at the place `geometry` of a finger that presses with the force `preload`; the
    /// overlap follows from the law. Lengths, forces and the frame are the caller's.
    ///
    /// # Errors
    ///
    /// [`ContactError::Negative`] for the preload, [`ContactError::BeyondLaw`] for one that the
    /// law does not reach, [`ContactError::NoStiffness`] when the law has no finite positive slope
    /// at it: Hertz' law has none without preload. Of the geometry,
    ///
    /// - [`ContactError::NotFinite`], [`ContactError::NoNormal`],
    ///   [`ContactError::RadiusNotANumber`], [`ContactError::PrincipalCurvature`],
    ///   [`ContactError::NoPrincipalDirection`] and [`ContactError::ShapeOperator`] name a number
    ///   that is none;
    /// - [`ContactError::NoGap`]: flat on flat, or a finger in a pocket that is narrower than the
    ///   finger: the overlap is no smooth function then;
    /// - [`ContactError::TooDeep`]: the overlap exceeds what the radii of curvature allow.
    pub fn new(geometry: Geometry<N>, law: Law, preload: f64) -> Result<Self, ContactError> {
        let preload = not_negative("preload", preload)?;
        within(&law, preload)?;
        let depth = not_negative("overlap at the preload", law.overlap(preload))?;
        let slope = law.slope_at_force(preload);
        Self::at_rest(geometry, law, depth, preload, slope)
    }

    /// The contact at the place `geometry` of a finger that overlaps the part by `overlap`; the
    /// preload follows from the law.
    ///
    /// # Errors
    ///
    /// Those of [`Self::new`], with the overlap in place of the preload:
    /// [`ContactError::OverlapBeyondLaw`].
    pub fn overlapping(
        geometry: Geometry<N>,
        law: Law,
        overlap: f64,
    ) -> Result<Self, ContactError> {
        let overlap = not_negative("overlap", overlap)?;
        let preload = not_negative("force at the overlap", law.force(overlap))?;
        if within(&law, preload).is_err() {
            let largest = law.overlap(law.largest_force());
            return Err(ContactError::OverlapBeyondLaw { overlap, largest });
        }
        let slope = law.slope(overlap);
        Self::at_rest(geometry, law, overlap, preload, slope)
    }

    fn at_rest(
        geometry: Geometry<N>,
        law: Law,
        depth: f64,
        preload: f64,
        slope: f64,
    ) -> Result<Self, ContactError> {
        positive("slope", slope).map_err(|_| ContactError::NoStiffness { preload, slope })?;
        let overlap = Overlap::new(geometry, depth)?;
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

/// Fails for a force that the law does not reach.
fn within(law: &Law, force: f64) -> Result<(), ContactError> {
    let largest = law.largest_force();
    if force < largest { Ok(()) } else { Err(ContactError::BeyondLaw { force, largest }) }
}
