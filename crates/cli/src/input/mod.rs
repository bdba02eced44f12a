//! Part and grasp files: read, checked against the schema, turned into what the libraries take.

mod document;
mod grasp;
mod part;

mod number;
pub(crate) mod schema;

mod excerpt;
mod fault;
mod place;

mod json_tree;
mod node;
mod reader;
mod toml_tree;

pub(crate) use document::Document;
pub(crate) use fault::InputError;
pub(crate) use grasp::grasp;
pub(crate) use number::Finite;
pub(crate) use part::planar_part;
