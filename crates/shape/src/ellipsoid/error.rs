//! What can be wrong with an ellipsoid, or with a direction to ask it for.

use crate::{LARGEST_ASPECT, LARGEST_COORDINATE, SMALLEST_COORDINATE};

/// Why numbers do not describe an ellipsoid, or a direction has no boundary point.
///
/// Axes and components are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EllipsoidError {
    /// A coordinate of the center is infinite or not a number.
    #[error("component {component} of the center is {value}, not a finite number")]
    CenterNotFinite {
        /// The first such component.
        component: usize,
        /// What was found.
        value: f64,
    },
    /// A coordinate of the center is so large that squares could overflow.
    #[error(
        "component {component} of the center is {value:e}, \
         but magnitudes up to {LARGEST_COORDINATE:e} are allowed; choose a larger unit of length"
    )]
    CenterTooFar {
        /// The first such component.
        component: usize,
        /// What was found.
        value: f64,
    },
    /// A semi-axis is zero, negative or not a number, or so small or large that products of
    /// lengths could leave the range of numbers.
    #[error(
        "semi-axis {axis} is {value:e}, \
         but must be between {SMALLEST_COORDINATE:e} and {LARGEST_COORDINATE:e}"
    )]
    SemiAxisOutOfRange {
        /// The first such axis.
        axis: usize,
        /// What was found (length).
        value: f64,
    },
    /// Two semi-axes differ so much that curvatures could overflow.
    #[error(
        "semi-axis {long} is {} times semi-axis {short}, \
         but at most {LARGEST_ASPECT:e} times is allowed", .aspect
    )]
    TooThin {
        /// The longest axis.
        long: usize,
        /// The shortest axis.
        short: usize,
        /// The quotient of the two.
        aspect: f64,
    },
    /// A direction is zero, so that it is no direction.
    #[error("the outward direction is zero, but has to point somewhere")]
    ZeroDirection,
    /// A direction has a component that is infinite or not a number.
    #[error("component {component} of the outward direction is {value}, not a finite number")]
    DirectionNotFinite {
        /// The first such component.
        component: usize,
        /// What was found.
        value: f64,
    },
}
