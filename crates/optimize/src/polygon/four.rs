//! Four fingers: all sets of edges, and the best placement on each.

use std::num::NonZeroUsize;

use super::Part;
use super::edge_sets::EdgeSets;
use super::leaders::Candidate;
use super::quadruple::{Quadruple, Spot};
use super::scene::Scene;
use super::search::{Verdict, search};
use crate::{OptimizeError, Outcome, Placement, Progress, Solution};

/// What to search for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FourFingers {
    /// How many of the best edge combinations to return.
    pub top: NonZeroUsize,
}

impl Default for FourFingers {
    fn default() -> Self {
        Self { top: NonZeroUsize::MIN }
    }
}

/// The best placements of four frictionless fingers on the edges of `part`.
///
/// Maximizes `Q = min(sigma_min, mu_eq)` to first order [LBR, eqs. 14 and 18], over all
/// combinations of four edges, two fingers on one edge included, and all places on them, corners
/// included as limits. Each combination that no bound excludes is solved by the finite
/// enumeration of [`polygon`](crate::polygon). `watch` is called after each round.
///
/// The combinations are shared among the threads of the current rayon pool; the outcome is the
/// same for any number of them. Their number grows with the fourth power of that of the edges.
///
/// # Errors
///
/// [`OptimizeError::NormalsNeverBalance`] or [`OptimizeError::TorquesNeverBalance`] when four
/// frictionless fingers cannot hold the part; [`OptimizeError::TooManyEdges`];
/// [`OptimizeError::OutOfRange`] when the numbers of the best placement overflow.
pub fn four_fingers(
    part: &Part,
    options: &FourFingers,
    watch: impl FnMut(&Progress),
) -> Result<Outcome, OptimizeError> {
    let scene = Scene::new(part);
    let edges = scene.supports.len();
    let sets = EdgeSets::of_edges(edges).ok_or(OptimizeError::TooManyEdges { edges })?;
    search(
        sets.total(),
        options.top,
        |number, floor| examine(&scene, sets.get(number), floor),
        |candidate| solution(&scene, candidate),
        watch,
    )
}

/// The best placement on the given edges, in any order; two may be equal.
///
/// `None` when four fingers on these edges cannot hold the part.
///
/// # Errors
///
/// [`OptimizeError::NoSuchEdge`]; [`OptimizeError::OutOfRange`] as for [`four_fingers`].
pub fn four_fingers_on(part: &Part, edges: [usize; 4]) -> Result<Option<Solution>, OptimizeError> {
    let edges = part.checked(edges)?;
    let scene = Scene::new(part);
    match examine(&scene, edges, 0.0) {
        Verdict::Examined(Some(candidate)) => solution(&scene, &candidate).map(Some),
        _ => Ok(None),
    }
}

/// The best placement on `edges`, if its quality can exceed `floor`.
fn examine(scene: &Scene, edges: [usize; 4], floor: f64) -> Verdict<4, Spot> {
    let unit = scene.stiffness_unit;
    let (sigma_min, floor) = (scene.sigma_min(&edges), floor / unit);
    if sigma_min <= floor {
        return Verdict::Skipped;
    }
    let Some(quadruple) = Quadruple::new(scene, edges) else { return Verdict::Skipped };
    if quadruple.bound() <= floor {
        return Verdict::Excluded;
    }
    Verdict::Examined(quadruple.peak(floor).map(|peak| {
        let (sigma_min, equivalent) = (sigma_min * unit, peak.equivalent * unit);
        Candidate { edges, sigma_min, equivalent, place: quadruple.spot(&peak) }
    }))
}

fn solution(scene: &Scene, candidate: &Candidate<4, Spot>) -> Result<Solution, OptimizeError> {
    let Spot { moments, shares } = candidate.place;
    let placement = |i: usize| {
        let edge = candidate.edges[i];
        Placement {
            edge,
            point: scene.point_of_moment(edge, moments[i]),
            inward_normal: scene.supports[edge].normal,
            share: shares[i],
        }
    };
    let mut placements: Vec<_> = (0..4).map(placement).collect();
    let along = |p: &Placement| (p.point - scene.start(p.edge)).norm_squared();
    placements.sort_by(|p, q| p.edge.cmp(&q.edge).then(along(p).total_cmp(&along(q))));
    Solution::of_first_order(scene.part, placements)
}
