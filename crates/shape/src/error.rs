//! What can be wrong with an outline.

use crate::{LARGEST_COORDINATE, SMALLEST_COORDINATE};

/// Why lists of corners are no valid outline.
///
/// Corners are counted from 0 in the order given, through the outline and then the holes; edge `e`
/// joins corner `e` to the next one of its loop. Holes are counted from 0 too.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PolygonError {
    /// There are too few corners to enclose anything.
    #[error("found {count} corners, but an outline needs at least 3")]
    TooFewCorners {
        /// The number of corners given.
        count: usize,
    },
    /// There are too few corners to bound a hole.
    #[error("found {count} corners of hole {hole}, but a hole needs at least 3")]
    TooFewCornersOfHole {
        /// The first such hole.
        hole: usize,
        /// The number of its corners.
        count: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("{axis} of corner {corner} is {value}, not a finite number")]
    NotFinite {
        /// The first corner with such a coordinate.
        corner: usize,
        /// `'x'` or `'y'`.
        axis: char,
        /// What was found.
        value: f64,
    },
    /// A coordinate is so large that areas could overflow.
    #[error(
        "{axis} of corner {corner} is {value:e}, \
         but magnitudes up to {LARGEST_COORDINATE:e} are allowed; choose a larger unit of length"
    )]
    TooLarge {
        /// The first corner with such a coordinate.
        corner: usize,
        /// `'x'` or `'y'`.
        axis: char,
        /// What was found.
        value: f64,
    },
    /// A coordinate other than zero is so small that areas could underflow.
    #[error(
        "{axis} of corner {corner} is {value:e}, \
         but only 0 or magnitudes from {SMALLEST_COORDINATE:e} up are allowed"
    )]
    TooSmall {
        /// The first corner with such a coordinate.
        corner: usize,
        /// `'x'` or `'y'`.
        axis: char,
        /// What was found.
        value: f64,
    },
    /// Two consecutive corners are the same point, so that the edge between them has no direction.
    #[error(
        "corners {start} and {end} are the same point, so edge {start} has no length; \
         the outline closes by itself, without repeating its first corner"
    )]
    ZeroLengthEdge {
        /// The first corner of the edge, and the number of the edge.
        start: usize,
        /// Its second corner; the first of its loop when the last corner repeats that.
        end: usize,
    },
    /// Two corners that are no neighbors are the same point, so that the outline touches itself.
    #[error(
        "corners {first} and {second} are the same point, but an outline must not touch itself"
    )]
    RepeatedCorner {
        /// The first of them.
        first: usize,
        /// The next corner at the same point.
        second: usize,
    },
    /// All corners lie on one line: the outline encloses nothing.
    #[error("all {count} corners lie on one line, but an outline must enclose an area")]
    ZeroArea {
        /// The number of corners given.
        count: usize,
    },
    /// All corners of a hole lie on one line.
    #[error("all {count} corners of hole {hole} lie on one line, but a hole must have an area")]
    ZeroAreaOfHole {
        /// The first such hole.
        hole: usize,
        /// The number of its corners.
        count: usize,
    },
    /// An edge runs back along the edge before it.
    #[error("edge {edge} folds back on the edge before it, at corner {edge}")]
    FoldedEdge {
        /// The second of the two edges, and the number of the corner between them.
        edge: usize,
    },
    /// Two edges that are no neighbors have a point in common.
    #[error("edges {first} and {second} cross or touch, but an outline must not meet itself")]
    CrossingEdges {
        /// The first edge that meets another.
        first: usize,
        /// The first edge, after its neighbor, that it meets.
        second: usize,
    },
    /// A hole is not in the part.
    #[error("hole {hole} is outside the outline, but a hole has to be within it")]
    HoleOutside {
        /// The first such hole.
        hole: usize,
    },
    /// A hole is in another one, where there is no material.
    #[error("hole {hole} is within hole {within}, where there is no material to cut from")]
    HoleInHole {
        /// The first such hole.
        hole: usize,
        /// A hole around it.
        within: usize,
    },
}
