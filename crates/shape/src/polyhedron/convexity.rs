//! Whether a solid is convex.

use clench_screw::Vector;

use super::Face;
use super::face::FLAT_ROUNDING;
use super::validity::SolidEdge;

/// Whether a closed surface in one piece is the boundary of a convex solid, to the rounding of its
/// coordinates.
///
/// That is so if it bends outward at each edge: neither of its two faces has a corner above the
/// plane of the other. (A closed surface that is convex around each of its points is convex:
/// H. Tietze and S. Nakajima, 1928.)
pub(super) fn is_convex(vertices: &[Vector<3>], faces: &[Face], edges: &[SolidEdge]) -> bool {
    let level = |face: usize| {
        let corners = faces[face].vertices().iter();
        FLAT_ROUNDING * corners.fold(0.0_f64, |m, &corner| m.max(vertices[corner].max_abs()))
    };
    let below = |face: usize, other: usize| {
        let (normal, point) = (faces[face].inward_normal(), faces[face].point());
        let allowed = -level(face).max(level(other));
        faces[other].vertices().iter().all(|&c| normal.dot(vertices[c] - point) >= allowed)
    };
    let bends_out = |edge: &SolidEdge| {
        let [one, other] = edge.faces;
        below(one, other) && below(other, one)
    };
    edges.iter().all(bends_out)
}
