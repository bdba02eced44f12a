//! From contact points to a solution: the metrics of what was found.

use clench_metrics::{MetricsError, Principal, Quality};
use clench_screw::{Stiffness, Vector, Wrench};

use super::Part;
use crate::{Placement, Solution};

impl Solution {
    /// The four-finger solution by `placements`, with stiffness to first order [LBR, eq. 18].
    pub(super) fn of_first_order(
        part: &Part,
        placements: Vec<Placement>,
    ) -> Result<Self, MetricsError> {
        let about = |origin: Vector<2>| {
            placements.iter().fold(Stiffness::ZERO, |sum, p| {
                let wrench = Wrench::<2, 1>::of_force_at(p.inward_normal, p.point - origin);
                sum + Stiffness::outer(&wrench) * part.edge_stiffness()[p.edge]
            })
        };
        let principal = Principal::near(part.outline().enclosing_circle().center, about)?;
        Ok(Self::of(part, placements, &principal))
    }

    /// The three-finger solution by `placements` whose normals meet in `center`, with the
    /// rotational stiffness `mu` about it [LBR, proposition 5.1].
    pub(super) fn of_concurrent(
        part: &Part,
        placements: Vec<Placement>,
        center: Vector<2>,
        mu: f64,
    ) -> Result<Self, MetricsError> {
        let mut stiffness = Stiffness::ZERO;
        for p in &placements {
            let wrench = Wrench { force: p.inward_normal, torque: Vector::ZERO };
            stiffness += Stiffness::outer(&wrench) * part.edge_stiffness()[p.edge];
        }
        stiffness.rotational[0][0] = mu;
        Ok(Self::of(part, placements, &Principal::of(center, &stiffness)?))
    }

    fn of(part: &Part, placements: Vec<Placement>, principal: &Principal<2, 1>) -> Self {
        let quality = Quality::of(principal, part.outline());
        Self { placements, quality, center: principal.center() }
    }
}
