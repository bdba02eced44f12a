//! What can be wrong with a named point or a load case.

use crate::input::Place;
use crate::wording::digits;

/// Why a named point or a load case was refused.
#[derive(Debug, thiserror::Error)]
pub(crate) enum LoadFault {
    /// Two points of one name.
    #[error("found the name of {first} again, expected another one")]
    RepeatedName { first: Place },
    /// A load case that says nothing.
    #[error("found neither `force`, `forces` nor `torque`, expected at least one of them")]
    NoLoad,
    /// A point where no force acts.
    #[error("found a `point` without a `force`, expected both, or each `point` under `forces`")]
    PointWithoutForce,
    /// A torque of space on a planar part.
    #[error("found a list of three numbers, expected one number: the part is planar")]
    SpatialTorque,
    /// A torque of the plane on a spatial part.
    #[error("found one number, expected three numbers [x, y, z]: the part is spatial")]
    PlanarTorque,
    /// A tolerance that nothing keeps.
    #[error("the tolerance is {}, but has to be a positive number", digits(*.value))]
    Tolerance { value: f64 },
    /// A direction in which nothing is bounded.
    #[error(
        "found a `direction` without a `tolerance`, expected the largest displacement along it"
    )]
    DirectionWithoutTolerance,
    /// A direction that is none.
    #[error("found a `direction` of length 0, expected one that points somewhere")]
    NoDirection,
    /// The displacement or a force is not a finite number.
    #[error(
        "what the load does to the part is out of range: choose units in which lengths and forces \
         are nearer to 1"
    )]
    OutOfRange,
    /// A named point so far away that its displacement is not a finite number.
    #[error("{case} moves the point out of range, expected one nearer to the part")]
    PointOutOfRange { case: Place },
}
