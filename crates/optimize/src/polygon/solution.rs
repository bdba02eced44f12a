//! From contact points to a solution: the metrics of what was found.

use clench_metrics::{MetricsError, Principal, Quality, WorstPoint};
use clench_screw::{Stiffness, Vector, Wrench};

use super::Part;
use crate::{OptimizeError, Placement, Solution};

impl Solution<2, 1> {
    /// The solution by spring fingers at `placements`, with stiffness to first order [LBR, eq. 18].
    pub(super) fn of_first_order(
        part: &Part,
        placements: Vec<Placement<2>>,
    ) -> Result<Self, OptimizeError> {
        let about = |origin: Vector<2>| {
            placements.iter().fold(Stiffness::ZERO, |sum, p| {
                let wrench = Wrench::<2, 1>::of_force_at(p.inward_normal, p.point - origin);
                sum + Stiffness::outer(&wrench) * part.edge_stiffness()[p.on]
            })
        };
        let principal = Principal::near(part.outline().enclosing_circle().center, about);
        Self::of(part, placements, principal)
    }

    /// The three-finger solution by `placements` whose normals meet in `center`, with the
    /// rotational stiffness `mu` about it [LBR, proposition 5.1].
    pub(super) fn of_concurrent(
        part: &Part,
        placements: Vec<Placement<2>>,
        center: Vector<2>,
        mu: f64,
    ) -> Result<Self, OptimizeError> {
        let mut stiffness = Stiffness::ZERO;
        for p in &placements {
            let wrench = Wrench { force: p.inward_normal, torque: Vector::ZERO };
            stiffness += Stiffness::outer(&wrench) * part.edge_stiffness()[p.on];
        }
        stiffness.rotational[0][0] = mu;
        Self::of(part, placements, Principal::of(center, &stiffness))
    }

    /// The worst point of the part held so.
    pub(super) fn worst_point(&self, part: &Part) -> Result<WorstPoint<2>, OptimizeError> {
        let source = |source| OptimizeError::OutOfRange { touched: self.touched(), source };
        WorstPoint::of(&self.principal, part.outline()).map_err(source)
    }

    fn of(
        part: &Part,
        placements: Vec<Placement<2>>,
        principal: Result<Principal<2, 1>, MetricsError>,
    ) -> Result<Self, OptimizeError> {
        let evaluated = principal.and_then(|principal| {
            Quality::of(&principal, part.outline()).map(|quality| (principal, quality))
        });
        match evaluated {
            Ok((principal, quality)) => {
                let given_shares = Vec::new();
                Ok(Self { placements, given_shares, objective: quality.value, quality, principal })
            }
            Err(source) => {
                let touched = placements.iter().map(|p| p.on).collect();
                Err(OptimizeError::OutOfRange { touched, source })
            }
        }
    }
}
