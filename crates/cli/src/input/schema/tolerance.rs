//! How far contacts may be off.

use serde::Deserialize;

use super::super::number::Finite;

/// What may be off at a contact, by how much at most either way.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table with `placement`, `stiffness` or `preload`")]
pub(crate) struct Tolerance {
    /// Of the point, along the boundary [length].
    pub(crate) placement: Option<Finite>,
    /// Of the forces of the law, relative.
    pub(crate) stiffness: Option<Finite>,
    /// Of the preload, relative.
    pub(crate) preload: Option<Finite>,
}
