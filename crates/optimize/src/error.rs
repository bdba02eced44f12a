//! Why a search could not be made, or found nothing.

/// What is wrong with the question, or why it has no answer.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
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
    /// No placement of this many frictionless fingers can hold the part.
    #[error(
        "no placement of {fingers} frictionless fingers holds the part: of {combinations} edge \
         combinations, {spanning} have normals that can balance, and on none of those can the \
         lines of action balance the torque, so the part stays free to rotate"
    )]
    NoPlacement {
        /// The number of fingers.
        fingers: usize,
        /// The number of edge combinations.
        combinations: u64,
        /// Those whose inward normals positively span the plane.
        spanning: u64,
    },
}
