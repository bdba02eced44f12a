//! What can be wrong with a spline.

/// Splines of higher degree are in no drawing.
pub(crate) const HIGHEST_DEGREE: usize = 24;

/// Why a spline of a DXF file is none.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SplineError {
    /// Of degree 0, or of an absurd one.
    #[error("has the degree {degree}, expected one from 1 to {HIGHEST_DEGREE}")]
    Degree {
        /// What was found; 0 for what is no number.
        degree: usize,
    },
    /// Too few or too many knots.
    #[error("has {points} control points and {knots} knots, expected {needed} knots for them")]
    Counts {
        /// The number of control points.
        points: usize,
        /// The number of knots.
        knots: usize,
        /// The number of knots that these points need.
        needed: usize,
    },
    /// Fewer points than one more than the degree.
    #[error("has {points} control points, expected at least {needed}")]
    TooFewPoints {
        /// What was found.
        points: usize,
        /// What the degree needs.
        needed: usize,
    },
    /// Knots that go back, or an empty range of them.
    #[error("has knots that do not ascend, at number {knot}")]
    Knots {
        /// The first such knot, from 0.
        knot: usize,
    },
    /// A knot so often that the spline falls apart there.
    #[error("is torn at knot {knot}, which is there more often than its degree")]
    Torn {
        /// The last of the first such knots, from 0.
        knot: usize,
    },
    /// Not as many weights as control points.
    #[error("has {weights} weights for {points} control points")]
    WeightCount {
        /// The number of weights.
        weights: usize,
        /// The number of control points.
        points: usize,
    },
    /// A weight that is not positive.
    #[error("has the weight {weight}, expected a positive number")]
    Weight {
        /// The first such weight.
        weight: f64,
    },
    /// Points to go through that do not make a curve.
    #[error("has {points} points to go through, expected at least 2 that differ")]
    FitPoints {
        /// The number of points.
        points: usize,
    },
}
