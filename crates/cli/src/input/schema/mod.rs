//! The file schema, version 1: what a part file and a grasp file may say.

mod contact;
mod forbidden;
mod load;
mod part;

mod tolerance;

mod results;
mod words;

use serde::{Deserialize, Serialize};

use super::number::{Name, Whole};

pub(crate) use contact::{Contact, Finger, Law, Material, Preload};
pub(crate) use forbidden::{Forbidden, ForbiddenLayer, ForbiddenStretch};
pub(crate) use load::{Load, LoadCase, NamedPoint};
pub(crate) use part::{ModularPlate, Part, Planar, Spatial};
pub(super) use results::{is_report, without_results};
pub(crate) use tolerance::Tolerance;
pub(super) use words::{expected, help};

/// The schema that this program reads.
pub(crate) const VERSION: u64 = 1;

/// A part, and for a grasp its contacts and what acts on it; `P` is an option where a file may have
/// contacts alone.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table with `part`")]
pub(crate) struct File<P = Part> {
    pub(crate) version: Option<Whole>,
    #[serde(default)]
    pub(crate) units: Units,
    pub(crate) part: P,
    #[serde(default)]
    pub(crate) contacts: Vec<Contact>,
    /// Of all contacts that have none of their own.
    pub(crate) contact_tolerances: Option<Tolerance>,
    #[serde(default)]
    pub(crate) loads: Vec<Load>,
    #[serde(default)]
    pub(crate) points: Vec<NamedPoint>,
    #[serde(default)]
    pub(crate) load_cases: Vec<LoadCase>,
}

/// The names of the units that all numbers of a file are in.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `length` and `force`")]
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
