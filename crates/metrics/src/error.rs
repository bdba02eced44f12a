//! Why a stiffness has no principal parameters.

use clench_screw::ScrewError;

/// What a stiffness lacks.
///
/// Directions are those of the frame that the stiffness is written in, padded with zeros in the
/// plane.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MetricsError {
    /// An entry of a block of the stiffness is infinite or not a number.
    #[error("the stiffness has no principal parameters: {0}")]
    NotFinite(#[from] ScrewError),
    /// The body is free to translate, or pushed away when it does.
    #[error(
        "the body is not held against translation along {direction:?}: \
         the stiffness there is {value:e}, the largest is {largest:e}"
    )]
    TranslationNotHeld {
        /// Unit direction.
        direction: [f64; 3],
        /// The principal translational stiffness along it (force / length).
        value: f64,
        /// The largest principal translational stiffness.
        largest: f64,
    },
    /// The body is free to rotate, or pushed away when it does.
    #[error(
        "the body is not held against rotation about {axis:?} through {point:?}: \
         the stiffness there is {value:e}, which is below the rounding error of {scale:e}"
    )]
    RotationNotHeld {
        /// Unit direction of the rotation; in the plane `[0, 0, 1]`.
        axis: [f64; 3],
        /// The point of the axis nearest to the frame's origin, about which the body would turn;
        /// in the plane the center of compliance.
        point: [f64; 3],
        /// How far the body would move along the axis per turn of one radian (length).
        pitch: f64,
        /// The principal rotational stiffness (force * length).
        value: f64,
        /// The rotational stiffness felt at the origin of the computation.
        scale: f64,
    },
    /// Lengths or stiffnesses are so large or so small together that their products overflow.
    #[error(
        "the body moves by {deflection:e} and resists with {stiffness:e}, \
         but both have to be numbers in the range of doubles"
    )]
    OutOfRange {
        /// What was to be the stiffness (force / length).
        stiffness: f64,
        /// The deflection that goes with it (length per rad, or length / force).
        deflection: f64,
    },
}
