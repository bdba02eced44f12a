//! What can be wrong with the surface of a solid.

use super::{LARGEST_SOLID_COORDINATE, SMALLEST_SOLID_COORDINATE};
use crate::PolygonError;

/// Why vertices and faces do not enclose a solid.
///
/// Vertices and faces are counted from 0 in the order given, corners of a face by the numbers of
/// their vertices unless it says otherwise.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PolyhedronError {
    /// A coordinate is infinite or not a number.
    #[error("{axis} of vertex {vertex} is {value}, not a finite number")]
    NotFinite {
        /// The first vertex with such a coordinate.
        vertex: usize,
        /// `'x'`, `'y'` or `'z'`.
        axis: char,
        /// What was found.
        value: f64,
    },
    /// A coordinate is so large that volumes could overflow.
    #[error(
        "{axis} of vertex {vertex} is {value:e}, but magnitudes up to \
         {LARGEST_SOLID_COORDINATE:e} are allowed; choose a larger unit of length"
    )]
    TooLarge {
        /// The first vertex with such a coordinate.
        vertex: usize,
        /// `'x'`, `'y'` or `'z'`.
        axis: char,
        /// What was found.
        value: f64,
    },
    /// A coordinate other than zero is so small that volumes could underflow.
    #[error(
        "{axis} of vertex {vertex} is {value:e}, \
         but only 0 or magnitudes from {SMALLEST_SOLID_COORDINATE:e} up are allowed"
    )]
    TooSmall {
        /// The first vertex with such a coordinate.
        vertex: usize,
        /// `'x'`, `'y'` or `'z'`.
        axis: char,
        /// What was found.
        value: f64,
    },
    /// There are too few vertices to enclose anything.
    #[error("found {count} vertices, but a solid needs at least 4")]
    TooFewVertices {
        /// The number of vertices given.
        count: usize,
    },
    /// There are too few faces to enclose anything.
    #[error("found {count} faces, but a solid needs at least 4")]
    TooFewFaces {
        /// The number of faces given.
        count: usize,
    },
    /// A face has too few corners to have an area.
    #[error("face {face} has {count} corners, but needs at least 3")]
    TooFewCorners {
        /// The first such face.
        face: usize,
        /// The number of its corners.
        count: usize,
    },
    /// A face names a vertex that does not exist.
    #[error("face {face} names vertex {vertex}, but there are only {count}, counted from 0")]
    NoSuchVertex {
        /// The first such face.
        face: usize,
        /// The vertex that it names.
        vertex: usize,
        /// The number of vertices.
        count: usize,
    },
    /// A face names a vertex twice.
    #[error("face {face} has vertex {vertex} as a corner more than once")]
    RepeatedCorner {
        /// The first such face.
        face: usize,
        /// The vertex.
        vertex: usize,
    },
    /// Two vertices that faces use are the same point, so that neighbors do not know each other.
    #[error(
        "vertices {first} and {second} are the same point; \
         give it once, and let all faces that meet there name it by one number"
    )]
    EqualVertices {
        /// The first of them.
        first: usize,
        /// The next one at the same point.
        second: usize,
    },
    /// The corners of a face are on one line, to the rounding of their coordinates.
    #[error(
        "face {face} has no area: its corners are within {width:e} of one line, \
         which coordinates of their size round to ({allowed:e})"
    )]
    ZeroAreaFace {
        /// The first such face.
        face: usize,
        /// The largest distance of a corner from the line (length).
        width: f64,
        /// The width that counts as none (length).
        allowed: f64,
    },
    /// The corners of a face are not in one plane.
    #[error(
        "face {face} is not flat: vertex {vertex} is {distance:e} off its plane, \
         allowed {allowed:e}; split it into triangles or give more digits"
    )]
    NotPlanar {
        /// The first such face.
        face: usize,
        /// The vertex farthest from the plane.
        vertex: usize,
        /// How far it is (length).
        distance: f64,
        /// What the rounding of coordinates explains (length).
        allowed: f64,
    },
    /// The outline of a face meets itself.
    #[error("the outline of face {face}, its corners counted from 0, is faulty: {fault}")]
    FaultyFace {
        /// The first such face.
        face: usize,
        /// What is wrong; its numbers count the corners of this face.
        #[source]
        fault: PolygonError,
    },
    /// An edge belongs to one face only: the surface has a hole.
    #[error(
        "the surface is open: the edge from vertex {} to {} belongs to face {face} only",
        .vertices[0], .vertices[1]
    )]
    OpenEdge {
        /// The ends of the edge, as the face runs.
        vertices: [usize; 2],
        /// The one face.
        face: usize,
    },
    /// More than two faces share an edge.
    #[error(
        "{count} faces, among them {}, {} and {}, share the edge from vertex {} to {}, \
         but an edge joins two", .faces[0], .faces[1], .faces[2], .vertices[0], .vertices[1]
    )]
    NonManifoldEdge {
        /// The ends of the edge, the lower number first.
        vertices: [usize; 2],
        /// The first three of the faces.
        faces: [usize; 3],
        /// How many there are.
        count: usize,
    },
    /// Two neighbors run along their common edge in the same direction: one is wound the wrong
    /// way.
    #[error(
        "faces {} and {} both run from vertex {} to {}: one of them is not counter-clockwise \
         seen from outside; reverse its corners",
        .faces[0], .faces[1], .vertices[0], .vertices[1]
    )]
    FlippedNeighbor {
        /// The ends of the edge, as both faces run.
        vertices: [usize; 2],
        /// The two faces, the lower number first.
        faces: [usize; 2],
    },
    /// The surface passes through itself.
    #[error(
        "faces {} and {} pass through each other, at ({}, {}, {}): the surface of a solid does \
         not cross itself; join pieces that overlap into one, or move them apart",
        .faces[0], .faces[1], .point[0], .point[1], .point[2]
    )]
    FacesCross {
        /// The first such face, and the first one that it crosses.
        faces: [usize; 2],
        /// A point that they have in common (length).
        point: [f64; 3],
    },
    /// A shell, faces joined by edges, encloses nothing, to the rounding of the coordinates.
    #[error(
        "the solid is flat at face {face}: with all faces joined to it, it encloses a volume of \
         {volume:e}, which coordinates of its size round to ({allowed:e})"
    )]
    ZeroVolume {
        /// The first face of the first such shell.
        face: usize,
        /// The volume found (length cubed).
        volume: f64,
        /// The volume that counts as none (length cubed).
        allowed: f64,
    },
    /// All faces of a shell that is not inside another are wound clockwise seen from outside.
    #[error(
        "the solid is inside out at face {face}: with all faces joined to it, it encloses a \
         volume of {volume:e}, since they run clockwise seen from outside; \
         reverse the corners of all of them"
    )]
    InsideOut {
        /// The first face of the shell.
        face: usize,
        /// The volume that the shell encloses (length cubed).
        volume: f64,
    },
    /// A shell is inside another and wound like it, so that the material would be on both sides,
    /// or on neither.
    #[error(
        "face {face} and all faces joined to it are inside the surface of face {around} and \
         wound the same way; if they are a cavity, or a piece in one, \
         reverse the corners of all of them, else leave them out"
    )]
    NestedAlike {
        /// The first face of the inner shell.
        face: usize,
        /// The first face of the next shell around it.
        around: usize,
    },
}
