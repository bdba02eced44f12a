//! The file schema, version 1: what a part file and a grasp file may say.

use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};

use super::number::{Finite, Name, PerEdge, Point, Whole};

/// The schema that this program reads.
pub(crate) const VERSION: u64 = 1;

/// A part, and for a grasp its contacts.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct File {
    pub(crate) version: Option<Whole>,
    #[serde(default)]
    pub(crate) units: Units,
    pub(crate) part: Part,
    #[serde(default)]
    pub(crate) contacts: Vec<Contact>,
}

/// The names of the units that all numbers of a file are in.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Units {
    pub(crate) length: Name,
    pub(crate) force: Name,
}

/// A file that names no units has one of length and one of force all the same.
impl Default for Units {
    fn default() -> Self {
        Self { length: Name("L".to_owned()), force: Name("F".to_owned()) }
    }
}

/// What is held.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Part {
    pub(crate) planar: Option<Planar>,
    /// Known, so that the message can say that it is for a later version.
    #[serde(skip_serializing)]
    pub(crate) spatial: Option<IgnoredAny>,
}

/// A planar part.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Planar {
    /// The corners, either way round.
    pub(crate) outline: Vec<Point>,
    /// Of a contact on each edge [force / length].
    pub(crate) stiffness: PerEdge,
}

/// A finger at its place.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Contact {
    pub(crate) point: Point,
    pub(crate) inward_normal: Option<Point>,
    pub(crate) edge: Option<Whole>,
    pub(crate) law: Option<Law>,
    pub(crate) preload: Option<Finite>,
    pub(crate) finger: Option<Finger>,
    /// A result of `optimize`: it follows from the points, so it is not read.
    #[serde(rename = "share")]
    _share: Option<IgnoredAny>,
}

/// Force as a function of overlap.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub(crate) enum Law {
    /// `f = stiffness * delta`.
    Linear { stiffness: Finite },
    /// `f = coefficient * delta^exponent`.
    Power { coefficient: Finite, exponent: Finite },
}

/// What touches the part.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Finger {
    /// 0 for a pointed finger [length].
    pub(crate) radius: Finite,
}
