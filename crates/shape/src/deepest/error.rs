//! What can be wrong with a body, or with a pair of them.

use std::fmt;

use clench_screw::Vector;

use crate::LARGEST_COORDINATE;

/// Why numbers do not describe a ball or a hull of points.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BodyError {
    /// There are no points to take the hull of.
    #[error("found no points, but a hull needs at least 1")]
    NoPoints,
    /// A coordinate is not a number, or so large that squares could overflow.
    #[error(
        "component {component} of point {point} is {value:e}, \
         but has to be a number of magnitude up to {LARGEST_COORDINATE:e}"
    )]
    PointOutOfRange {
        /// The first such point; 0 for the center of a ball.
        point: usize,
        /// Its first such component.
        component: usize,
        /// What was found.
        value: f64,
    },
    /// A radius is negative, not a number, or so large that squares could overflow.
    #[error("the radius is {radius:e}, but must be between 0 and {LARGEST_COORDINATE:e}")]
    RadiusOutOfRange {
        /// What was found (length).
        radius: f64,
    },
}

impl BodyError {
    /// The points, if there are any and all coordinates are in range.
    pub(crate) fn checked_points<const N: usize>(
        points: &[[f64; N]],
    ) -> Result<Vec<Vector<N>>, BodyError> {
        if points.is_empty() {
            return Err(BodyError::NoPoints);
        }
        let points: Vec<Vector<N>> = points.iter().map(|&point| point.into()).collect();
        for (number, &point) in points.iter().enumerate() {
            Self::check_point(number, point)?;
        }
        Ok(points)
    }

    /// Fails if the point with this number has a coordinate out of range.
    pub(crate) fn check_point<const N: usize>(
        number: usize,
        point: Vector<N>,
    ) -> Result<(), BodyError> {
        let allowed = -LARGEST_COORDINATE..=LARGEST_COORDINATE;
        match (0..N).find(|&component| !allowed.contains(&point[component])) {
            Some(component) => {
                let value = point[component];
                Err(BodyError::PointOutOfRange { point: number, component, value })
            }
            None => Ok(()),
        }
    }
}

/// One of the two bodies of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The finger.
    Finger,
    /// The part.
    Part,
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Side::Finger => "finger",
            Side::Part => "part",
        })
    }
}

/// Why a pair of bodies has no overlap that is one number.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OverlapError {
    /// A body is not convex and the other is neither disc nor ball.
    ///
    /// In a hollow such bodies touch at several places at once, each with an overlap of its own.
    /// The least translation that separates them jumps between these, so that it has no
    /// derivative and no stiffness follows from it.
    #[error(
        "the {side} is not convex and the other body is not round, so that the translation that \
         separates them jumps as they move; use a disc or ball, or convex pieces"
    )]
    NotConvex {
        /// Which of the two is not convex; the finger if both are.
        side: Side,
    },
}
