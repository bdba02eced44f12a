//! What can be wrong with a mesh file.

use std::borrow::Cow;
use std::io;

use clench::shape::PolyhedronError;

use crate::wording::{digits, quoted};

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
    /// A line of a text file that is not what such files have there.
    #[error("line {line}: found {}, expected {expected}", quoted(.found))]
    Line { line: usize, found: String, expected: Cow<'static, str> },
    /// A text STL file that ends early.
    #[error("line {line}: the file ends here, expected {expected}: is it cut off?")]
    CutOff { line: usize, expected: &'static str },
    /// A corner of a binary STL file that is no point.
    #[error(
        "facet {facet}, counted from 0, has a corner at ({}, {}, {}), expected finite numbers",
        .corner[0], .corner[1], .corner[2]
    )]
    NotFinite { facet: usize, corner: [f64; 3] },
    /// A file without any surface.
    #[error("has no {what}, expected the closed surface of a solid")]
    Nothing { what: &'static str },
    /// A part so far from the origin that its shape is lost.
    #[error(
        "has coordinates up to {}, which are {} apart in single precision, for a part of size {}: \
         expected it nearer to the origin, as STL files have no more digits",
        digits(*.farthest), digits(*.step), digits(*.size)
    )]
    Coarse { farthest: f64, step: f64, size: f64 },
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
    #[error("is not the surface of a solid: {fault}{}", listed(.places))]
    Surface {
        fault: PolyhedronError,
        /// Where the vertices are that the fault is about.
        places: Vec<(usize, [f64; 3])>,
    },
}

impl MeshFault {
    /// That these vertices are not those of a solid.
    pub(in crate::input) fn of_surface(fault: PolyhedronError, vertices: &[[f64; 3]]) -> Self {
        let about = match fault {
            PolyhedronError::TooLarge { vertex, .. }
            | PolyhedronError::TooSmall { vertex, .. }
            | PolyhedronError::RepeatedCorner { vertex, .. }
            | PolyhedronError::NotPlanar { vertex, .. } => vec![vertex],
            PolyhedronError::OpenEdge { vertices, .. }
            | PolyhedronError::NonManifoldEdge { vertices, .. }
            | PolyhedronError::FlippedNeighbor { vertices, .. } => vertices.to_vec(),
            _ => Vec::new(),
        };
        let place = |vertex| Some((vertex, *vertices.get(vertex)?));
        Self::Surface { fault, places: about.into_iter().filter_map(place).collect() }
    }

    /// The line of the file that it is about.
    pub(super) const fn line(&self) -> Option<usize> {
        match self {
            Self::Line { line, .. } | Self::CutOff { line, .. } => Some(*line),
            _ => None,
        }
    }

    pub(super) fn help(&self) -> Option<&'static str> {
        match self {
            Self::UnknownEnding => Some("most programs that draw solids can export STL"),
            Self::Surface { .. } => Some(
                "faces count from 0 in the order of the mesh, vertices in the order in which faces \
                 first use them",
            ),
            _ => None,
        }
    }
}

/// Where vertices are, in words.
fn listed(places: &[(usize, [f64; 3])]) -> String {
    let place = |(vertex, at): &(usize, [f64; 3])| {
        let [x, y, z] = at.map(digits);
        format!("; vertex {vertex} is at ({x}, {y}, {z})")
    };
    places.iter().map(place).collect()
}
