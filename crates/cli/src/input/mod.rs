//! Part and grasp files: read, checked against the schema, turned into what the libraries take.

mod document;

mod alone;
mod drawn;
mod part;
mod solid;
mod tip;
mod touch;

mod mesh;

mod given;
mod grasp;

mod balance;

mod contact;
mod finger;
mod law;

mod load;
mod tolerance;

mod boundary;
mod material;
mod units;

mod number;
pub(crate) mod schema;

mod excerpt;
mod fault;
mod place;

mod json_tree;
mod node;
mod reader;
mod shield;
mod text;
mod toml_tree;

pub(crate) use alone::{Alone, FORCE, LayerStiffness, part_file};
pub(crate) use boundary::{Piece, PieceKind};
pub(crate) use document::Document;
pub(crate) use drawn::{Asked, Drawn, drawn};
pub(crate) use fault::{InputError, LoadFault, Position};
pub(crate) use given::{GivenContact, Holder, given_contacts};
pub(crate) use grasp::{FileGrasp, planar_grasp, spatial_grasp};
pub(crate) use load::{LoadCase, NamedPoint, PointForce, PointTolerance};
pub(crate) use number::{FileName, Finite, Label, Name, Whole};
pub(crate) use part::{
    Body, Part, PlanarShape, Solid, SpatialShape, TouchablePart, part, touchable_part,
};
pub(crate) use place::Place;
pub(crate) use solid::{mesh_file, touchable};
pub(crate) use tip::{disc_tip, tip};
pub(crate) use tolerance::Tolerance;
pub(crate) use touch::without;
