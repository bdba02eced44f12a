//! What a search returns.

use std::time::Duration;

use clench_metrics::{Principal, Quality};
use clench_screw::Vector;

use crate::Ended;

/// Where one finger goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// The edge, numbered as in the outline.
    pub edge: usize,
    /// The contact point on it (length).
    pub point: Vector<2>,
    /// The unit normal into the part.
    pub inward_normal: Vector<2>,
    /// The finger's share of the total preload when the forces balance; the shares sum to 1. With
    /// more than four fingers there is a choice: the least share is then as large as can be.
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
    /// What was maximized (force / length).
    pub objective: f64,
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

/// What is proved about the optimum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// No placement has a larger objective (force / length), up to rounding.
    pub upper_bound: f64,
    /// How the search ended.
    pub ended: Ended,
}

/// How many combinations of stretches there are, and what the search took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Combinations {
    /// All there are; exact up to 2^53.
    pub total: f64,
    /// Those that no bound excluded, and that were solved exactly.
    pub examined: u64,
    /// Sets of combinations that were bounded.
    pub nodes: u64,
}

/// The end of a search.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The best placement. Among ties it has the largest equivalent stiffness, then the lowest edge
    /// numbers.
    pub best: Solution,
    /// The best placements on the next best combinations of stretches, as many as were asked for
    /// and exist, best first.
    pub others: Vec<Solution>,
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

    /// By how much another placement could be better, as a part of the best.
    #[must_use]
    pub fn gap(&self) -> f64 {
        (self.certificate.upper_bound / self.best.objective - 1.0).max(0.0)
    }
}

/// A search on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The best objective so far (force / length); `None` before any was found.
    pub best: Option<f64>,
    /// No placement has a larger objective (force / length).
    pub upper_bound: f64,
    /// Nodes, sets of combinations, that were bounded.
    pub nodes: u64,
    /// Nodes that are still to be divided.
    pub open: usize,
    /// The time since the search began.
    pub elapsed: Duration,
}
