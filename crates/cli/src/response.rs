//! What a load case does to a part that is held.

use clench::contact::Order;
use clench::metrics::{Displacement, Principal};
use clench::shape::Extent;
use clench::stiffness::{Grasp, GraspError, LiftOff, NeededPreloads, Remedy};

use crate::held::{Classes, held};
use crate::input::{FileGrasp, LoadCase, NamedPoint};

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

/// Preloads under which no contact lifts off, whatever load case acts.
#[derive(Clone, Debug)]
pub(crate) struct Remedies {
    /// The part of its preload that each contact keeps.
    pub(crate) reserve: f64,
    pub(crate) least: NeededPreloads,
    pub(crate) scaled: NeededPreloads,
}

impl Remedies {
    /// Those for the load cases of a file; `order` says what is in the stiffness of a grasp.
    pub(crate) fn of<const N: usize, const M: usize>(
        found: &FileGrasp<N, M>,
        reserve: f64,
        order: impl Fn(&Grasp<N, M>) -> Order,
    ) -> Result<Self, GraspError> {
        let changes = |grasp: &Grasp<N, M>| {
            let order = order(grasp);
            let principal = held(grasp, order, Classes::of(grasp).to_order(order)).ok()?;
            let origin = grasp.centroid();
            let of_case = |case: &LoadCase<N, M>| {
                let twist = principal.displacement(origin, &case.about(origin));
                let changes = grasp.force_changes(origin, &twist);
                changes.iter().all(|change| change.is_finite()).then_some(changes)
            };
            found.load_cases.iter().map(of_case).collect()
        };
        let by = |remedy| found.grasp.needed_preloads(remedy, reserve, changes);
        Ok(Self { reserve, least: by(Remedy::Least)?, scaled: by(Remedy::Scaled)? })
    }
}
