//! What a search returns.

use clench_metrics::{Principal, Quality};
use clench_screw::Vector;

/// Where one finger goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// The edge, numbered as in the outline.
    pub edge: usize,
    /// The contact point on it (length).
    pub point: Vector<2>,
    /// The unit normal into the part.
    pub inward_normal: Vector<2>,
    /// The finger's share of the total preload when the forces balance; the shares sum to 1.
    ///
    /// 0 at the boundary of what can be held: the optimum is then a limit that is approached by
    /// placements which hold, and there the fingers with share 0 barely press.
    pub share: f64,
}

/// A best placement on one combination of edges.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The fingers, in order along the outline.
    pub placements: Vec<Placement>,
    /// Its quality. When translation limits it, every placement on these edges whose equivalent
    /// stiffness reaches `quality.translational` is as good; this one has the largest.
    pub quality: Quality<2, 1>,
    /// The principal parameters of its stiffness, in the frame of the outline.
    pub principal: Principal<2, 1>,
}

impl Solution {
    /// The center of compliance (length).
    #[must_use]
    pub fn center(&self) -> Vector<2> {
        self.principal.center()
    }

    /// The edges that the fingers touch, ascending.
    #[must_use]
    pub fn edges(&self) -> Vec<usize> {
        self.placements.iter().map(|p| p.edge).collect()
    }
}

/// What is proved about the optimum: every combination was solved, or bounded below the best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// No placement has a larger quality (force / length), up to rounding.
    pub upper_bound: f64,
}

/// How many edge combinations a search looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Combinations {
    /// All there are.
    pub total: u64,
    /// Those that no bound excluded, and that were solved exactly.
    pub examined: u64,
}

/// The end of a search.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The best placement.
    pub best: Solution,
    /// The best placements on the next best combinations of edges, as many as were asked for and
    /// exist, best first.
    pub others: Vec<Solution>,
    /// How many further combinations are as good as the best, up to rounding. Among ties, the
    /// largest equivalent stiffness comes first, then the lower edge numbers.
    pub ties: usize,
    /// The proof.
    pub certificate: Certificate,
    /// What it took.
    pub combinations: Combinations,
}

impl Outcome {
    /// The best placement and the others, best first.
    pub fn solutions(&self) -> impl Iterator<Item = &Solution> {
        std::iter::once(&self.best).chain(&self.others)
    }
}

/// A search on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Combinations that are settled.
    pub settled: u64,
    /// Combinations in all.
    pub total: u64,
    /// The best quality so far; `None` before any was found.
    pub best: Option<f64>,
}
