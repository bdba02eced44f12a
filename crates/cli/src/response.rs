//! What a load case does to a part that is held.

use clench::metrics::{Displacement, Principal};
use clench::shape::Extent;
use clench::stiffness::{Grasp, LiftOff};

use crate::input::{LoadCase, NamedPoint};

/// A load case, and what moves and changes under it.
#[derive(Clone, Debug)]
pub(crate) struct Response<'a, const N: usize, const M: usize> {
    pub(crate) case: &'a LoadCase<N, M>,
    /// About the centroid of the contacts: far from the part digits would be lost.
    pub(crate) displacement: Displacement<N, M>,
    /// Of each contact.
    pub(crate) force_changes: Vec<f64>,
    /// The contact that lifts off first when the load grows.
    pub(crate) lift_off: Option<LiftOff>,
}

impl<'a, const N: usize, const M: usize> Response<'a, N, M> {
    /// What `case` does to `body`, held by `grasp` with these principal stiffnesses; `None` if that
    /// is out of the range of doubles.
    pub(crate) fn of(
        case: &'a LoadCase<N, M>,
        grasp: &Grasp<N, M>,
        principal: &Principal<N, M>,
        body: Extent<'_, N>,
    ) -> Option<Self> {
        let origin = grasp.centroid();
        // Its only error is to be out of range.
        let displacement = Displacement::of(principal, origin, &case.about(origin), body).ok()?;
        let force_changes = grasp.force_changes(origin, &displacement.twist);
        let lift_off = grasp.first_to_lift_off(&force_changes);
        let finite = force_changes.iter().all(|change| change.is_finite());
        finite.then_some(Self { case, displacement, force_changes, lift_off })
    }

    /// The first of the `points` that moves out of the range of doubles.
    pub(crate) fn out_of_range(&self, points: &[NamedPoint<N>]) -> Option<usize> {
        points.iter().position(|named| !self.displacement.at(named.point).norm().is_finite())
    }
}
