//! What a search returns.

use clench_metrics::Quality;
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
    pub quality: Quality,
    /// The center of compliance (length).
    pub center: Vector<2>,
}

impl Solution {
    /// The edges that the fingers touch, ascending.
    #[must_use]
    pub fn edges(&self) -> Vec<usize> {
        self.placements.iter().map(|p| p.edge).collect()
    }
}

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ending {
    /// Every combination was solved, or bounded below the best.
    Proved,
}

/// What is known about the optimum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// How the search ended.
    pub ending: Ending,
    /// No placement has a larger quality (force / length), up to rounding.
    pub upper_bound: f64,
    /// `(upper_bound - best) / upper_bound`.
    pub gap: f64,
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
    /// The best placements on the best combinations of edges, best first; never empty.
    pub solutions: Vec<Solution>,
    /// How many further combinations are as good as the best, up to rounding. Among ties, the
    /// largest equivalent stiffness comes first, then the lower edge numbers.
    pub ties: usize,
    /// The proof.
    pub certificate: Certificate,
    /// What it took.
    pub combinations: Combinations,
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
