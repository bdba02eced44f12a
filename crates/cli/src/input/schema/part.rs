//! What is held.

use serde::{Deserialize, Serialize};

use super::super::number::{FileName, Finite, Label, PerPiece, Point, Whole};
use super::Forbidden;

/// A part of the plane or of space.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `planar` or `spatial`")]
pub(crate) struct Part {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) planar: Option<Planar>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) spatial: Option<Spatial>,
}

/// A planar part: an outline, from the file or from a drawing, or an ellipse.
///
/// What a drawing says takes the place of the fields about it before the part is made: a report
/// has corners.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `outline`, `drawing` or `ellipse`")]
pub(crate) struct Planar {
    /// The path of a drawing, from the folder of this file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) drawing: Option<FileName>,
    /// How far edges may be from the curves of the drawing [length].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) chord: Option<Finite>,
    /// The layers of the drawing that the outline and the holes are on.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) layers: Vec<Label>,
    /// The corners, either way round.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) outline: Option<Vec<Point<2>>>,
    /// The corners of each hole of the outline, either way round.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) holes: Vec<Vec<Point<2>>>,
    /// The semi-axes along x and y [length].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) ellipse: Option<Point<2>>,
    /// Of the ellipse; the origin if left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) center: Option<Point<2>>,
    /// Of a contact on each edge, or on the ellipse [force / length].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) stiffness: Option<PerPiece>,
    /// No finger nearer to a corner of the outline [length].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) margin: Option<Finite>,
    /// Edges of the outline, and stretches of them, without fingers.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) forbidden: Vec<Forbidden>,
    /// Polygons in which nothing of a finger may be.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) keep_out: Vec<Vec<Point<2>>>,
    /// Where the centers of fingers may be.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) plate: Option<ModularPlate>,
}

/// A spatial part: a polyhedron, from the file or from a mesh, or an ellipsoid.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table with `vertices` and `faces`, `mesh` or `ellipsoid`"
)]
pub(crate) struct Spatial {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) vertices: Option<Vec<Point<3>>>,
    /// The corners of each face, counter-clockwise seen from outside.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) faces: Option<Vec<Vec<Whole>>>,
    /// The path of a mesh file, from the folder of this one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) mesh: Option<FileName>,
    /// The semi-axes along x, y and z [length].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) ellipsoid: Option<Point<3>>,
    /// Of the ellipsoid; the origin if left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) center: Option<Point<3>>,
    /// Of a contact on each face, or anywhere [force / length].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) stiffness: Option<PerPiece>,
    /// No finger nearer to where a plane ends [length].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) margin: Option<Finite>,
    /// Boxes in which nothing of a finger may be.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) keep_out: Vec<KeepOutBox>,
    /// Where the centers of fingers may be along x and y.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) plate: Option<ModularPlate>,
}

/// A box along the axes.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `from` and `to`")]
pub(crate) struct KeepOutBox {
    /// The lowest corner [length].
    pub(crate) from: Point<3>,
    /// The highest corner [length].
    pub(crate) to: Point<3>,
}

/// A plate with holes for fingers.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `pitch` and `travel`")]
pub(crate) struct ModularPlate {
    /// The distances of holes along x and y [length].
    pub(crate) pitch: Point<2>,
    /// Where one hole is; the origin if left out [length].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) offset: Option<Point<2>>,
    /// How far a center may be from a hole [length].
    pub(crate) travel: Finite,
}
