//! What can be wrong with a mesh file.

use std::io;

use clench::shape::PolyhedronError;

/// Why a mesh file was refused.
#[derive(Debug, thiserror::Error)]
pub(crate) enum MeshFault {
    /// The file cannot be read.
    #[error("cannot be read: {0}; expected a mesh file, .stl or .obj")]
    Unreadable(io::Error),
    /// The name does not say what it is.
    #[error("is not known by its ending, expected a mesh file, .stl or .obj")]
    UnknownEnding,
    /// The reader gave up in a way that it should not.
    #[error("cannot be read: its reader failed; is the file damaged?")]
    Panicked,
    /// The file has no bytes, or only spaces.
    #[error("is empty, expected a mesh")]
    Empty,
    /// A binary STL file ends early, or goes on.
    #[error(
        "has {found} bytes, but a binary STL file with the {triangles} triangles that this one \
         claims has {expected}; is it cut off, or no STL file?"
    )]
    StlLength { found: usize, triangles: u32, expected: u64 },
    /// Too short for the head of a binary STL file, and no text.
    #[error("is no STL file: it does not start with `solid`, and is too short to be a binary one")]
    NotStl,
    /// A text STL file that its reader does not take.
    #[error("is not a valid STL file: {0}")]
    Stl(io::Error),
    /// An OBJ file that its reader does not take.
    #[error("is not a valid OBJ file: {0}")]
    Obj(tobj::LoadError),
    /// An OBJ file that is no text.
    #[error("is not a valid OBJ file: byte {offset} is not UTF-8")]
    NotText { offset: usize },
    /// The triangles or faces enclose no solid.
    #[error("is not the surface of a solid: {0}")]
    Surface(PolyhedronError),
}

impl MeshFault {
    pub(super) fn help(&self) -> Option<&'static str> {
        match self {
            Self::UnknownEnding => Some("most programs that draw solids can export STL"),
            Self::Surface(_) => Some(
                "faces count from 0 in the order of the mesh, vertices in the order in which faces \
                 first use them",
            ),
            _ => None,
        }
    }
}
