//! Where on a solid's surface a point is.

use clench_screw::Vector;

use super::Polyhedron;
use super::surface::{self, faces_along, foot_on_edge};

/// A place is on an edge or a vertex within this many roundings of the coordinates there: two for
/// the point's own rounding in a file and at its source, two for each end's, and as many again
/// for its foot on the face.
const PLACE_ROUNDING: f64 = 12.0 * f64::EPSILON;

/// The place of a solid's surface nearest to some point.
#[derive(Clone, Debug, PartialEq)]
pub struct FacePlace {
    /// The number of the face; of several that meet there, the lowest.
    pub face: usize,
    /// The distance between the point and the surface (length).
    pub distance: f64,
    /// The nearest point of the surface.
    pub foot: Vector<3>,
    /// What of the face the place is.
    pub on: FaceFeature,
}

/// What of a face a place is, to the rounding of its coordinates.
#[derive(Clone, Debug, PartialEq)]
pub enum FaceFeature {
    /// Its inside, where it has its own normal.
    Interior,
    /// An edge; a finger there has a normal only if both faces have the same.
    Edge {
        /// The two faces that it joins, the lower number first.
        faces: [usize; 2],
        /// The vertices that it joins, the lower number first.
        vertices: [usize; 2],
    },
    /// A vertex; a finger there has a normal only if all faces have the same.
    Vertex {
        /// Its number.
        vertex: usize,
        /// The faces that meet there, ascending.
        faces: Vec<usize>,
    },
}

/// The place nearest to `point`, which is finite.
pub(super) fn nearest_place(solid: &Polyhedron, point: Vector<3>) -> FacePlace {
    let (face, foot) = surface::nearest(solid, point);
    let on = feature_at(solid, face, foot.point);
    let face = match &on {
        FaceFeature::Interior => face,
        FaceFeature::Edge { faces, .. } => faces[0],
        FaceFeature::Vertex { faces, .. } => faces[0],
    };
    FacePlace { face, distance: foot.distance, foot: foot.point, on }
}

/// What of `face` its point `foot` is.
fn feature_at(solid: &Polyhedron, face: usize, foot: Vector<3>) -> FaceFeature {
    let corners = solid.faces[face].vertices();
    let scale = corners.iter().fold(0.0_f64, |m, &c| m.max(solid.vertices[c].max_abs()));
    let rounding = PLACE_ROUNDING * scale;
    let near = |&&corner: &&usize| (solid.vertices[corner] - foot).norm() <= rounding;
    if let Some(&vertex) = corners.iter().find(near) {
        let meeting = |&face: &usize| solid.faces[face].vertices().contains(&vertex);
        return FaceFeature::Vertex {
            vertex,
            faces: (0..solid.faces.len()).filter(meeting).collect(),
        };
    }
    let edge = solid.faces[face]
        .edges()
        .find(|&edge| foot_on_edge(&solid.vertices, edge, foot).distance <= rounding)
        .map(|[from, to]| [from.min(to), from.max(to)]);
    match edge.and_then(|vertices| Some((vertices, faces_along(&solid.edges, vertices)?))) {
        Some((vertices, faces)) => FaceFeature::Edge { faces, vertices },
        None => FaceFeature::Interior,
    }
}
