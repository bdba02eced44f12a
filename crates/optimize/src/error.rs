//! Why a search could not be made, or found nothing.

use clench_metrics::MetricsError;

/// What is wrong with the question, or why it has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OptimizeError {
    /// The number of edge stiffnesses is not the number of edges.
    #[error("found {found} edge stiffnesses, but the outline has {edges} edges")]
    StiffnessCount {
        /// How many were given.
        found: usize,
        /// How many edges there are.
        edges: usize,
    },
    /// An edge stiffness is not positive and finite.
    #[error("the stiffness of edge {edge} is {value}, but has to be a positive finite number")]
    Stiffness {
        /// The edge, from 0.
        edge: usize,
        /// What was found.
        value: f64,
    },
    /// The total preload of a three-finger grasp is not positive and finite.
    #[error(
        "the total preload is {value}, but has to be a positive finite number: \
         three fingers resist rotation by their preload alone"
    )]
    TotalPreload {
        /// What was found.
        value: f64,
    },
    /// The finger radius is negative or not finite.
    #[error("the finger radius is {value}, but has to be a finite number, zero or positive")]
    FingerRadius {
        /// What was found.
        value: f64,
    },
    /// An edge number is too large.
    #[error("edge {edge} does not exist: the outline has edges 0 to {last}")]
    NoSuchEdge {
        /// What was asked for.
        edge: usize,
        /// The last edge of the outline.
        last: usize,
    },
    /// There are more combinations of edges than can be counted.
    #[error("an outline of {edges} edges has more combinations of edges than can be counted")]
    TooManyEdges {
        /// The number of edges.
        edges: usize,
    },
    /// The largest edge stiffness is too many times the smallest.
    #[error(
        "the edge stiffnesses go from {smallest:e} to {largest:e}: their ratio has to be below \
         {limit:e}, or the smaller ones are lost in the rounding of the larger ones"
    )]
    StiffnessSpread {
        /// The smallest.
        smallest: f64,
        /// The largest.
        largest: f64,
        /// [`crate::polygon::LARGEST_SPREAD`].
        limit: f64,
    },
    /// A placement was found whose stiffness has no principal parameters in the range of numbers.
    #[error("the best placement on edges {edges:?} is out of the range of numbers: {source}")]
    OutOfRange {
        /// The edges.
        edges: Vec<usize>,
        /// What its stiffness lacks.
        source: MetricsError,
    },
    /// The normals of no combination positively span the plane.
    #[error(
        "no placement of {fingers} frictionless fingers holds the part: on none of the \
         {combinations} edge combinations can the inward normals balance, so the part can always \
         be pushed away"
    )]
    NormalsNeverBalance {
        /// The number of fingers.
        fingers: usize,
        /// The number of edge combinations.
        combinations: u64,
    },
    /// Where normals can balance, torques cannot.
    #[error(
        "no placement of {fingers} frictionless fingers holds the part: of {combinations} edge \
         combinations, {spanning} have normals that can balance, and on none of those do the \
         torques balance as well, so the part can always be turned away"
    )]
    TorquesNeverBalance {
        /// The number of fingers.
        fingers: usize,
        /// The number of edge combinations.
        combinations: u64,
        /// Those whose inward normals positively span the plane.
        spanning: u64,
    },
}
