//! What can be wrong with a finger tip and its surroundings.

/// Why it cannot be told where a finger touches.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AccessError {
    /// The radius is no length.
    #[error("the radius of the finger tip is {value}, expected a finite number of 0 or more")]
    Radius {
        /// What was given.
        value: f64,
    },
    /// The margin is no length.
    #[error("the margin is {value}, expected a finite number of 0 or more")]
    Margin {
        /// What was given.
        value: f64,
    },
    /// A box has no inside.
    #[error("along {} the box is from {from} to {to}, expected to be from less to more",
        ["x", "y", "z"][*axis])]
    KeepOut {
        /// The axis along which it has none: 0 is x.
        axis: usize,
        /// Where it begins.
        from: f64,
        /// Where it ends.
        to: f64,
    },
    /// Holes of a plate have no distance.
    #[error("the pitch of the plate is {value}, expected a positive number")]
    PlatePitch {
        /// What was given.
        value: f64,
    },
    /// A hole of a plate is nowhere.
    #[error("the offset of the plate is {value}, expected a finite number")]
    PlateOffset {
        /// What was given.
        value: f64,
    },
    /// A travel leaves no places with an area.
    #[error(
        "the travel over the plate is {value}, expected a positive number; for fingers that \
         stand in holes without travel list the candidates"
    )]
    PlateTravel {
        /// What was given.
        value: f64,
    },
    /// A plate has too many holes beside a facet.
    #[error(
        "{found:.3e} holes of the plate are beside facet {facet}, expected {most} at most: \
         is the pitch in the part's unit of length?"
    )]
    TooManyHoles {
        /// The facet.
        facet: usize,
        /// How many.
        found: f64,
        /// How many there may be.
        most: usize,
    },
    /// The hole that a plate is given by is so far away that others cannot be told apart.
    #[error(
        "the offset of the plate is {pitches:.3e} pitches away from edge {edge}: give a hole that \
         is nearer"
    )]
    PlateTooFar {
        /// The edge.
        edge: usize,
        /// How many pitches it is away, about.
        pitches: f64,
    },
    /// A plate has too many holes beside an edge.
    #[error(
        "{found:.3e} holes of the plate are beside edge {edge}, expected {most:e} at most: \
         is the pitch in the part's unit of length?"
    )]
    TooManyHolesAtEdge {
        /// The edge.
        edge: usize,
        /// About how many.
        found: f64,
        /// How many there may be.
        most: f64,
    },
}
