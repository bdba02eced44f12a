//! Four fingers: the search over all edge combinations.

use std::num::NonZeroUsize;

use rayon::prelude::*;

use super::Part;
use super::combinations::Combinations as Edges;
use super::leaders::{Candidate, Leaders};
use super::quadruple::{Peak, Quadruple};
use super::scene::Scene;
use crate::{
    Certificate, Combinations, Ending, OptimizeError, Outcome, Placement, Progress, Solution,
};

/// Combinations in the first round; each further round has twice as many, up to the last.
const FIRST_ROUND: u64 = 256;

/// Combinations in the largest round: some tens of milliseconds of work.
const LARGEST_ROUND: u64 = 1 << 17;

/// The visiting order strides through all combinations by about this part of their number (the
/// golden section), so that early rounds see edges from everywhere.
const STRIDE: f64 = 0.618_033_988_749_894_9;

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
/// Maximises `Q = min(sigma_min, mu_eq)` to first order [LBR, eqs. 14 and 18], over all
/// combinations of four edges, two fingers on one edge included, and all places on them, corners
/// included as limits. Each combination that no bound excludes is solved by the finite
/// enumeration of [`super::polygon`](crate::polygon). `watch` is called after each round.
///
/// The combinations are shared among the threads of the current rayon pool. Bounds use only what
/// earlier rounds found and the rounds do not depend on the pool, so the outcome is the same for
/// any number of threads.
///
/// # Errors
///
/// [`OptimizeError::NoPlacement`] when four frictionless fingers cannot hold the part.
pub fn four_fingers(
    part: &Part,
    options: &FourFingers,
    mut watch: impl FnMut(&Progress),
) -> Result<Outcome, OptimizeError> {
    let scene = Scene::new(part);
    let edges = Edges::of_edges(scene.supports.len());
    let total = edges.total();
    let stride = coprime_stride(total);
    let mut leaders = Leaders::new(options.top.get());
    let (mut settled, mut round, mut tally) = (0, FIRST_ROUND, Tally::default());
    while settled < total {
        let end = total.min(settled + round);
        let floor = leaders.floor();
        let (candidates, seen) = (settled..end)
            .into_par_iter()
            .map(|i| edges.get(position(i, stride, total)))
            .fold(Default::default, |found, edges| examine(&scene, edges, floor, found))
            .reduce(Default::default, |(mut a, x), (b, y)| {
                a.extend(b);
                (a, x.plus(y))
            });
        leaders.merge(candidates);
        tally = tally.plus(seen);
        settled = end;
        round = (2 * round).min(LARGEST_ROUND);
        watch(&Progress { settled, total, best: leaders.best() });
    }
    let (best, ties) = leaders.finish();
    let solutions: Vec<_> = best.iter().filter_map(|c| solution(&scene, c)).collect();
    let Some(first) = solutions.first() else {
        let spanning = tally.spanning;
        return Err(OptimizeError::NoPlacement { fingers: 4, combinations: total, spanning });
    };
    let upper_bound = first.quality.value;
    Ok(Outcome {
        ties,
        certificate: Certificate { ending: Ending::Proved, upper_bound, gap: 0.0 },
        combinations: Combinations { total, examined: tally.examined },
        solutions,
    })
}

/// The best placement on the given edges, in any order; two may be equal.
///
/// `None` when four fingers on these edges cannot hold the part.
///
/// # Errors
///
/// [`OptimizeError::NoSuchEdge`].
pub fn four_fingers_on(part: &Part, edges: [usize; 4]) -> Result<Option<Solution>, OptimizeError> {
    let edges = part.checked(edges)?;
    let scene = Scene::new(part);
    let quadruple = Quadruple::new(&scene, edges);
    let peak = quadruple.and_then(|quadruple| quadruple.peak(0.0));
    Ok(peak.and_then(|place| {
        let (sigma_min, equivalent) = (scene.sigma_min(&edges), place.equivalent);
        solution(&scene, &Candidate { edges, sigma_min, equivalent, place })
    }))
}

/// How many combinations were solved, and how many have normals that can balance.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    examined: u64,
    spanning: u64,
}

impl Tally {
    const fn plus(self, other: Self) -> Self {
        Self { examined: self.examined + other.examined, spanning: self.spanning + other.spanning }
    }
}

type Found = (Vec<Candidate<4, Peak>>, Tally);

/// Adds the best placement on `edges` to what was `found`, if its quality exceeds `floor`.
fn examine(scene: &Scene, edges: [usize; 4], floor: f64, mut found: Found) -> Found {
    let sigma_min = scene.sigma_min(&edges);
    if sigma_min <= floor {
        return found;
    }
    let Some(quadruple) = Quadruple::new(scene, edges) else { return found };
    found.1.spanning += 1;
    if quadruple.bound() <= floor {
        return found;
    }
    found.1.examined += 1;
    if let Some(place) = quadruple.peak(floor) {
        let equivalent = place.equivalent;
        found.0.push(Candidate { edges, sigma_min, equivalent, place });
    }
    found
}

fn solution(scene: &Scene, candidate: &Candidate<4, Peak>) -> Option<Solution> {
    let quadruple = Quadruple::new(scene, candidate.edges)?;
    let moments = quadruple.moments(&candidate.place);
    let shares = quadruple.shares(&candidate.place);
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
    Solution::of_first_order(scene.part, placements).ok()
}

/// A stride near the golden section of `total` that visits each number once.
fn coprime_stride(total: u64) -> u64 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "any stride will do that is put right below"
    )]
    let mut stride = (total as f64 * STRIDE) as u64;
    while stride < total && gcd(stride, total) != 1 {
        stride += 1;
    }
    stride.max(1)
}

const fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The `i`-th of `total` numbers in the visiting order.
fn position(i: u64, stride: u64, total: u64) -> u64 {
    let wide = u128::from(i) * u128::from(stride) % u128::from(total);
    u64::try_from(wide).unwrap_or(u64::MAX)
}
