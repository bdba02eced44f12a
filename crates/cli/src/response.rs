//! What a load case does to a part that is held.

use clench::metrics::{Deflection, Principal};
use clench::screw::Vector;
use clench::shape::Extent;
use clench::stiffness::{Grasp, LiftOff};

use crate::input::{LoadCase, NamedPoint};

/// A load case, and what moves and changes under it.
#[derive(Clone, Debug)]
pub(crate) struct Response<'a, const N: usize, const M: usize> {
    pub(crate) case: &'a LoadCase<N, M>,
    /// About the origin of the file's frame.
    pub(crate) deflection: Deflection<N, M>,
    /// Of each contact.
    pub(crate) force_changes: Vec<f64>,
    /// The contact that lifts off first when the load grows.
    pub(crate) lift_off: Option<LiftOff>,
}

impl<'a, const N: usize, const M: usize> Response<'a, N, M> {
    /// What `case` does to `body`, held by `grasp` with these principal stiffnesses.
    pub(crate) fn of(
        case: &'a LoadCase<N, M>,
        grasp: &Grasp<N, M>,
        principal: &Principal<N, M>,
        body: Extent<'_, N>,
    ) -> Self {
        let deflection = Deflection::of(principal, &case.wrench, body);
        let (origin, displacement) = (Vector::ZERO, &deflection.twist);
        Self {
            case,
            force_changes: grasp.force_changes(origin, displacement),
            lift_off: grasp.first_to_lift_off(origin, displacement),
            deflection,
        }
    }

    /// Whether all of it are numbers in range, at `points` too.
    pub(crate) fn is_finite(&self, points: &[NamedPoint<N>]) -> bool {
        let distance = |named: &NamedPoint<N>| self.deflection.at(named.point).norm();
        let distances = points.iter().map(distance).chain([self.deflection.largest.value]);
        distances.chain(self.force_changes.iter().copied()).all(f64::is_finite)
    }
}
