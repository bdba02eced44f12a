//! The numbers of a grasp that holds the part.

use clench::metrics::{EquivalentStiffness, MetricsError, Principal, Quality, WorstPoint};
use clench::shape::Extent;

/// What a stiffness is worth for a part.
#[derive(Clone, Debug)]
pub(crate) struct Metrics<const N: usize, const M: usize> {
    pub(crate) principal: Principal<N, M>,
    pub(crate) quality: Quality<N, M>,
    /// The softest of all rotations that need no force: `Q_V`.
    pub(crate) softest: EquivalentStiffness<N, M>,
    /// `Q_pt`.
    pub(crate) worst: WorstPoint<N>,
}

impl<const N: usize, const M: usize> Metrics<N, M> {
    /// The numbers of `body`, held with these principal stiffnesses.
    pub(crate) fn of(
        principal: Principal<N, M>,
        body: Extent<'_, N>,
    ) -> Result<Self, MetricsError> {
        Ok(Self {
            quality: Quality::of(&principal, body)?,
            softest: EquivalentStiffness::least(&principal, body)?,
            worst: WorstPoint::of(&principal, body)?,
            principal,
        })
    }
}
