//! What a search returns.

use std::time::Duration;

use clench_metrics::{Principal, Quality};
use clench_screw::Vector;

use crate::Ended;

/// Where one finger goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement<const N: usize> {
    /// What it touches: the number of the edge of an outline, of the face of a solid, or of the
    /// candidate.
    pub on: usize,
    /// The contact point (length).
    pub point: Vector<N>,
    /// The unit normal into the part.
    pub inward_normal: Vector<N>,
    /// The finger's share of the total preload when the forces balance; the shares sum to 1. With
    /// more fingers than it takes to hold a part there is a choice: the least share is then as
    /// large as can be.
    ///
    /// 0 at the boundary of what can be held: the optimum is then a limit that is approached by
    /// placements which hold, and there the fingers with share 0 barely press.
    pub share: f64,
}

/// A best placement on one combination of edges, faces or candidates.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<const N: usize, const M: usize> {
    /// The fingers that were placed, by the numbers of what they touch; on an edge in order along
    /// the outline.
    pub placements: Vec<Placement<N>>,
    /// The shares of the fingers that were given, in their order; they and those of the placements
    /// sum to 1.
    pub given_shares: Vec<f64>,
    /// What was maximized (force / length).
    pub objective: f64,
    /// Its quality. When translation limits it, every placement on these edges whose equivalent
    /// stiffness reaches `quality.translational` is as good; this one has the largest.
    pub quality: Quality<N, M>,
    /// The principal parameters of its stiffness, in the frame of the part.
    pub principal: Principal<N, M>,
}

impl Solution<2, 1> {
    /// The center of compliance (length).
    #[must_use]
    pub fn center(&self) -> Vector<2> {
        self.principal.center()
    }
}

impl<const N: usize, const M: usize> Solution<N, M> {
    /// The numbers of the edges, faces or candidates that the placed fingers touch, ascending.
    #[must_use]
    pub fn touched(&self) -> Vec<usize> {
        self.placements.iter().map(|p| p.on).collect()
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

/// How many combinations of stretches of edges, of faces or of candidates there are, and what the
/// search took.
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
pub struct Outcome<const N: usize, const M: usize> {
    /// The best placement. Among ties it has the largest equivalent stiffness, then the lowest
    /// numbers of edges or faces.
    pub best: Solution<N, M>,
    /// The best placements on the next best combinations of stretches of edges, of
    /// faces or of candidates, as many as were asked for
    /// and exist, best first.
    pub others: Vec<Solution<N, M>>,
    /// The proof.
    pub certificate: Certificate,
    /// What it took.
    pub combinations: Combinations,
}

impl<const N: usize, const M: usize> Outcome<N, M> {
    /// The best placement and the others, best first.
    pub fn solutions(&self) -> impl Iterator<Item = &Solution<N, M>> {
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
