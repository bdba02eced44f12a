//! Three fingers: the question, and its best answers.

use std::ops::ControlFlow;

use super::Part;
use super::reason::nothing;
use super::scene::Scene;
use super::tips;
use super::triplets::{TripletSearch, Triplets};
use crate::search::{Floor, Leaders, Matter, choose, outcome, search};
use crate::{Effort, OptimizeError, Outcome, Progress, Solution};

/// What to search for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreeFingers {
    /// `f_T`, the sum of the contact forces (force).
    pub total_preload: f64,
    /// The radius of the fingers' tips (length); 0 for pointed fingers.
    pub finger_radius: f64,
    /// The least gap between the tips of two fingers (length).
    pub clearance: f64,
    /// The least share of the total preload that each finger has; below a third.
    pub least_share: f64,
}

impl ThreeFingers {
    /// Pointed fingers with the given total preload, without conditions.
    #[must_use]
    pub const fn with_preload(total_preload: f64) -> Self {
        Self { total_preload, finger_radius: 0.0, clearance: 0.0, least_share: 0.0 }
    }

    /// The least distance of the centers of two tips (length).
    pub(super) fn least_distance(&self) -> f64 {
        2.0 * self.finger_radius + self.clearance
    }

    fn checked(&self) -> Result<(), OptimizeError> {
        let force = self.total_preload;
        if !(force > 0.0 && force.is_finite()) {
            return Err(OptimizeError::TotalPreload { value: force });
        }
        tips::check(self.finger_radius, self.clearance)?;
        let limit = 1.0 / 3.0;
        if !(0.0..limit).contains(&self.least_share) {
            return Err(OptimizeError::LeastShare { value: self.least_share, limit });
        }
        Ok(())
    }
}

/// The best placements of three frictionless fingers on the edges of `part`.
///
/// Maximizes `Q = min(sigma_min, mu_eq)` [LBR, eq. 14] over all triplets of edges and all
/// placements whose normals meet in a point. On a triplet, `sigma_min` and
///
/// `mu = f_T (sum of share_i dist_i + r)`
///
/// are constant (`dist_i`: distance of the meeting point from edge `i`, the sum being the radius
/// of the triangle's inscribed circle), so the best meeting point is the feasible one with the
/// least reach. This is LBR's proposition 5.1 with the radius `r` of the fingers; the overlaps,
/// which lower `mu` by the sum of `f_i delta_i`, are neglected as there. `watch`, threads and
/// determinism are as for [`fingers`](super::fingers()).
///
/// # Errors
///
/// [`OptimizeError::TotalPreload`], [`OptimizeError::FingerRadius`], [`OptimizeError::Clearance`],
/// [`OptimizeError::LeastShare`], [`OptimizeError::Gap`]; [`OptimizeError::NormalsNeverBalance`],
/// [`OptimizeError::TorquesNeverBalance`] or [`OptimizeError::ConditionsNeverMet`] when three
/// frictionless fingers cannot hold the part so; [`OptimizeError::NothingFound`] when the search
/// was stopped before; [`OptimizeError::NowhereToTouch`]; [`OptimizeError::TooThin`] and
/// [`OptimizeError::OutOfRange`] when the numbers of the best placement overflow.
pub fn three_fingers(
    part: &Part,
    fingers: &ThreeFingers,
    effort: &Effort,
    watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Outcome<2, 1>, OptimizeError> {
    fingers.checked()?;
    effort.checked()?;
    let scene = Scene::checked(part)?;
    let triplets = Triplets::new(&scene, fingers);
    let mut leaders = Leaders::new(effort.top.get());
    leaders.merge(triplets.first());
    let searched = search(&TripletSearch::new(triplets), leaders, effort, watch);
    let combinations = choose(scene.supports.len(), 3, false);
    let conditions =
        fingers.least_share > 0.0 || fingers.least_distance() > 0.0 || part.is_restricted();
    let matter = Matter { fingers: 3, combinations };
    outcome(
        scene.stiffness_unit,
        matter,
        &searched,
        |candidate| triplets.solution(candidate),
        || nothing(&scene, matter, conditions),
    )
}

/// The best placement on the given edges, in any order.
///
/// `None` when three fingers on these edges cannot hold the part.
///
/// # Errors
///
/// [`OptimizeError::NoSuchEdge`], and those of the question.
pub fn three_fingers_on(
    part: &Part,
    edges: [usize; 3],
    fingers: &ThreeFingers,
) -> Result<Option<Solution<2, 1>>, OptimizeError> {
    fingers.checked()?;
    let edges = part.checked(edges)?;
    let scene = Scene::checked(part)?;
    let triplets = Triplets::new(&scene, fingers);
    let mut best = Leaders::new(1);
    for stretches in scene.stretches_of(edges) {
        best.merge(triplets.solve(stretches, &Floor::NONE));
    }
    best.candidates().first().map(|candidate| triplets.solution(candidate)).transpose()
}
