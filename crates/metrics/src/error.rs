//! Why a stiffness has no principal parameters.

use clench_screw::{Axis, ScrewError, Vector};

/// What a stiffness lacks.
///
/// Directions and axes are those of the frame that the stiffness is written in, and of space: the
/// plane is the slice z = 0.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MetricsError {
    /// An entry of `K_11` or of `K_V`, which all blocks enter, is infinite or not a number.
    #[error("the stiffness has no principal parameters: {0}")]
    NotFinite(#[from] ScrewError),
    /// The body is free to translate, or pushed away when it does.
    #[error(
        "the body is not held against translation along {:?}: \
         the stiffness there is {value:e}, the largest is {largest:e}",
        direction.to_array()
    )]
    TranslationNotHeld {
        /// Unit direction.
        direction: Vector<3>,
        /// The principal translational stiffness along it (force / length).
        value: f64,
        /// The largest principal translational stiffness.
        largest: f64,
    },
    /// The body is free to rotate, or pushed away when it does.
    #[error(
        "the body is not held against rotation about {:?} through {:?}: \
         the stiffness there is {value:e}, which is below the rounding error of {scale:e}",
        axis.direction.to_array(),
        axis.point.to_array()
    )]
    RotationNotHeld {
        /// The axis about which the body would turn, with its pitch; in the plane along z through
        /// the center of compliance.
        axis: Axis,
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
    /// The quality has no derivative: repeated principal stiffnesses limit it.
    #[error(
        "the quality has no derivative: {multiplicity} principal rotational stiffnesses are the \
         same, and where a change separates them it jumps"
    )]
    QualityJumps {
        /// How many are the same.
        multiplicity: usize,
    },
    /// A measure has no derivative that could be found: on an ellipsoid more places tie for it than
    /// can be told apart.
    #[error(
        "the measure has no derivative: on the ellipsoid, places that are equally soft form a curve"
    )]
    TiesWithoutEnd,
}
