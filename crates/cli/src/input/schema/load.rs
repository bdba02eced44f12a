//! What acts on the part besides the fingers, and where one wants to know what it does.

use serde::Deserialize;

use super::super::number::{Coordinates, Finite, Label, Torque};

/// A force at a point of the part: at rest, such as its weight, or of a load case.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table with `point` and `force`")]
pub(crate) struct Load {
    pub(crate) point: Coordinates,
    pub(crate) force: Coordinates,
}

/// A point of the part with a name.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table with `name` and `point`")]
pub(crate) struct NamedPoint {
    pub(crate) name: Label,
    pub(crate) point: Coordinates,
    /// The largest displacement that is allowed of it under each load case [length].
    pub(crate) tolerance: Option<Finite>,
    /// The tolerance bounds the displacement along this direction only; of any length.
    pub(crate) direction: Option<Coordinates>,
}

/// A load that comes on top of the state at rest, such as the force of a tool.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table with `force`, `forces` or `torque`")]
pub(crate) struct LoadCase {
    pub(crate) name: Option<Label>,
    pub(crate) force: Option<Coordinates>,
    /// Where the force acts; the origin if left out.
    pub(crate) point: Option<Coordinates>,
    /// More forces, each at its point.
    #[serde(default)]
    pub(crate) forces: Vec<Load>,
    /// A couple besides the forces [force * length].
    pub(crate) torque: Option<Torque>,
    /// The largest displacement that is allowed of any point of the part [length].
    pub(crate) tolerance: Option<Finite>,
}
