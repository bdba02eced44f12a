//! What can be wrong with a contact.

use crate::law::LARGEST_CURVATURE_RATIO;

/// Why a law or a contact was refused.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactError {
    /// A parameter that has to be positive and finite is not.
    #[error("{parameter} is {value}, but has to be a positive finite number")]
    NotPositive {
        /// The name of the parameter.
        parameter: &'static str,
        /// What was found.
        value: f64,
    },
    /// A parameter that has to be zero or positive, and finite, is not.
    #[error("{parameter} is {value}, but has to be a finite number, zero or positive")]
    Negative {
        /// The name of the parameter.
        parameter: &'static str,
        /// What was found.
        value: f64,
    },
    /// A coordinate is infinite or not a number.
    #[error("{parameter} has the component {value} on axis {axis}, which is not a finite number")]
    NotFinite {
        /// The name of the vector.
        parameter: &'static str,
        /// The axis, from 0.
        axis: usize,
        /// What was found.
        value: f64,
    },
    /// The radius of a round boundary is not a number, or infinitely hollow.
    #[error("the {body}'s boundary has the radius {value}, but a radius has to be a number")]
    RadiusNotANumber {
        /// `"finger"` or `"part"`.
        body: &'static str,
        /// What was found.
        value: f64,
    },
    /// A principal curvature is infinite or not a number: a knife edge has none.
    #[error(
        "the {body}'s boundary has the principal curvature {value}, but it has to be a finite \
         number: an edge, of radius 0, has no curvature"
    )]
    PrincipalCurvature {
        /// `"finger"` or `"part"`.
        body: &'static str,
        /// What was found.
        value: f64,
    },
    /// Hertz' law needs smooth bodies.
    #[error("the {body} is pointed, but Hertz' law needs a smooth boundary: give it a radius")]
    Pointed {
        /// `"finger"` or `"part"`.
        body: &'static str,
    },
    /// Hertz' law needs a contact at a point.
    #[error(
        "finger and part touch along a line, with the relative curvature {larger} across it, but \
         Hertz' law needs them to touch at a point"
    )]
    LineOfContact {
        /// The relative curvature across the line (1 / length).
        larger: f64,
    },
    /// The principal direction of a boundary is along the normal, or is none.
    #[error("the {body}'s principal direction is along the normal, or is zero or not finite")]
    NoPrincipalDirection {
        /// `"finger"` or `"part"`.
        body: &'static str,
    },
    /// The shape operator of a boundary has an entry that is not a finite number.
    #[error("the {body}'s shape operator has an entry that is not a finite number")]
    ShapeOperator {
        /// `"finger"` or `"part"`.
        body: &'static str,
    },
    /// The gap between finger and part does not open in all directions.
    #[error(
        "along some direction the curvatures of finger and part sum to {relative_curvature}, but \
         have to sum to more than 0 and its rounding: flat on flat, or a finger in a hollow as \
         narrow as itself, touches in more than one point"
    )]
    NoGap {
        /// The least relative curvature (1 / length).
        relative_curvature: f64,
    },
    /// The overlap is as large as the radii of curvature: the deepest points are not unique.
    #[error(
        "the overlap is {depth}, but has to be less than {limit}, where the curvatures of finger \
         and part leave its deepest points undecided"
    )]
    TooDeep {
        /// The overlap (length).
        depth: f64,
        /// What it has to be below (length).
        limit: f64,
    },
    /// The force is more than the law can describe.
    #[error("the contact force is {force}, but the law holds for less than {largest} only")]
    BeyondLaw {
        /// What was found.
        force: f64,
        /// The law's largest force.
        largest: f64,
    },
    /// The overlap is more than the law can describe.
    #[error("the overlap is {overlap}, but the law holds for less than {largest} only")]
    OverlapBeyondLaw {
        /// What was found (length).
        overlap: f64,
        /// The overlap at the law's largest force (length).
        largest: f64,
    },
    /// A gap does not belong to an ellipse.
    #[error(
        "the gap A x^2 + B y^2 has A = {a} and B = {b}, but A has to be the smaller one, and B \
         at most {LARGEST_CURVATURE_RATIO:e} times as large"
    )]
    NoEllipse {
        /// `A` (1 / length).
        a: f64,
        /// `B` (1 / length).
        b: f64,
    },
    /// No elastic material has this Poisson's ratio.
    #[error("Poisson's ratio is {value}, but has to be more than -1 and at most 1/2")]
    PoissonRatio {
        /// What was found.
        value: f64,
    },
    /// Curvatures so large that their products leave the range of numbers.
    #[error(transparent)]
    Screw(#[from] clench_screw::ScrewError),
    /// The inward normal has no direction.
    #[error("inward normal is zero, so it has no direction")]
    NoNormal,
    /// A pointed part has no boundary along which a finger could move.
    #[error("the part is pointed where the finger touches, so the finger cannot move along it")]
    NoTangent,
    /// At this preload the law has no finite positive slope, so the contact has no stiffness.
    #[error(
        "with a preload of {preload} the law's slope is {slope}, so the contact has no stiffness: \
         a nonlinear law needs a positive preload, in the range of numbers"
    )]
    NoStiffness {
        /// `f`.
        preload: f64,
        /// `f'`.
        slope: f64,
    },
}

/// `value`, if it is positive and finite.
pub(crate) fn positive(parameter: &'static str, value: f64) -> Result<f64, ContactError> {
    if value > 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(ContactError::NotPositive { parameter, value })
}

/// `value`, if it is finite and not negative.
pub(crate) fn not_negative(parameter: &'static str, value: f64) -> Result<f64, ContactError> {
    if value >= 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(ContactError::Negative { parameter, value })
}
