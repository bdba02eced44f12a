//! The nearest point of a solid's surface.

use clench_screw::{Vector, spatial};
use parry3d_f64::bounding_volume::Aabb;
use parry3d_f64::math::Vector as ParryVector;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhLeafCost, BvhNode};

use super::validity::SolidEdge;
use super::{Face, Polyhedron};
use crate::predicates::unit_scale;

/// What of the surface a point is on, as found by projecting to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Feature {
    /// The inside of the face.
    Face,
    /// The inside of the edge with these ends.
    Edge([usize; 2]),
    /// The vertex.
    Vertex(usize),
}

/// A point of a face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot {
    pub(super) point: Vector<3>,
    pub(super) distance: f64,
    pub(super) feature: Feature,
}

/// The boxes of the faces, as a tree, in units of about the solid's own size.
#[derive(Clone, Debug)]
pub(super) struct FaceTree {
    boxes: Bvh,
    scale: f64,
}

impl FaceTree {
    /// Of faces with these corners, whose coordinates are up to `largest`.
    pub(super) fn new<'a>(
        vertices: &[Vector<3>],
        faces: impl Iterator<Item = &'a [usize]>,
        largest: f64,
    ) -> Self {
        let scale = unit_scale(largest);
        let boxes: Vec<Aabb> = faces.map(|corners| box_around(vertices, corners, scale)).collect();
        Self { boxes: Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes), scale }
    }

    /// All faces, those near each other soon after each other.
    pub(super) fn in_order(&self) -> impl Iterator<Item = usize> + '_ {
        self.boxes.leaves(|_: &BvhNode| true).map(|face| face as usize)
    }

    /// What coordinates are multiplied by.
    pub(super) const fn scale(&self) -> f64 {
        self.scale
    }

    /// The faces in boxes whose lowest and highest corners, in units of the tree, `meets` accepts.
    pub(super) fn in_boxes(
        &self,
        meets: impl Fn([f64; 3], [f64; 3]) -> bool,
    ) -> impl Iterator<Item = usize> {
        let accepts = move |node: &BvhNode| meets(node.mins().to_array(), node.maxs().to_array());
        self.boxes.leaves(accepts).map(|face| face as usize)
    }

    /// The faces whose boxes meet that of these corners.
    pub(super) fn overlapping(
        &self,
        vertices: &[Vector<3>],
        corners: &[usize],
    ) -> impl Iterator<Item = usize> + '_ {
        let around = BvhNode::leaf(box_around(vertices, corners, self.scale), 0);
        self.boxes.leaves(move |node: &BvhNode| node.intersects(&around)).map(|face| face as usize)
    }

    /// The faces whose boxes, wider by `margin` to all sides, the ray from `point` along the
    /// x axis meets.
    pub(super) fn along_x(
        &self,
        point: Vector<3>,
        margin: f64,
    ) -> impl Iterator<Item = usize> + '_ {
        let (at, margin) = (to_parry(point * self.scale), margin * self.scale);
        let meets = move |node: &BvhNode| {
            let (low, high) = (node.mins() - margin, node.maxs() + margin);
            let beside = at.y < low.y || at.y > high.y || at.z < low.z || at.z > high.z;
            at.x <= high.x && !beside
        };
        self.boxes.leaves(meets).map(|face| face as usize)
    }
}

/// A candidate for the nearest foot; its cost is the distance in the units of the tree.
struct Candidate {
    foot: Foot,
    cost: f64,
}

impl BvhLeafCost for Candidate {
    fn cost(&self) -> f64 {
        self.cost
    }
}

/// The face nearest to `point`, and its nearest point. `point` is finite.
pub(super) fn nearest(solid: &Polyhedron, point: Vector<3>) -> (usize, Foot) {
    let FaceTree { boxes, scale } = &solid.tree;
    let at = to_parry(point * *scale);
    let found = boxes.find_best(
        f64::MAX,
        |node: &BvhNode, _| at.distance(at.clamp(node.mins(), node.maxs())),
        |face, _| {
            let foot = foot_on(&solid.vertices, &solid.faces[face as usize], point);
            Some(Candidate { foot, cost: foot.distance * scale })
        },
    );
    match found {
        Some((face, candidate)) => (face as usize, candidate.foot),
        // Only for a point that is not finite.
        None => (0, foot_on(&solid.vertices, &solid.faces[0], point)),
    }
}

/// The point of a face nearest to `point`.
pub(super) fn foot_on(vertices: &[Vector<3>], face: &Face, point: Vector<3>) -> Foot {
    let depth = face.inward_normal().dot(point - face.point());
    let level = point - face.inward_normal() * depth;
    if face.encloses(vertices, level) {
        return Foot { point: level, distance: depth.abs(), feature: Feature::Face };
    }
    let unknown = Foot { point: level, distance: f64::INFINITY, feature: Feature::Face };
    face.edges()
        .map(|edge| foot_on_edge(vertices, edge, point))
        .fold(unknown, |near, foot| if foot.distance < near.distance { foot } else { near })
}

/// The point of an edge nearest to `point`, the same from both of its faces.
pub(super) fn foot_on_edge(
    vertices: &[Vector<3>],
    [from, to]: [usize; 2],
    point: Vector<3>,
) -> Foot {
    let ends = [from.min(to), from.max(to)];
    let [a, b] = ends.map(|end| vertices[end]);
    let length = (b - a).norm();
    let direction = (b - a) * (1.0 / length);
    let along = direction.dot(point - a);
    if along <= 0.0 || along >= length {
        let vertex = ends[usize::from(along > 0.0)];
        let distance = (point - vertices[vertex]).norm();
        return Foot { point: vertices[vertex], distance, feature: Feature::Vertex(vertex) };
    }
    // From the nearer end: the error grows with the distance to it.
    let foot =
        if along < 0.5 * length { a + direction * along } else { b - direction * (length - along) };
    Foot { point: foot, distance: (point - foot).norm(), feature: Feature::Edge(ends) }
}

/// The sums of the faces' outward normals around each vertex, weighted by their angles there.
///
/// A point whose nearest point is the vertex is outside if and only if it is on the side of this
/// vector (J. A. Bærentzen, H. Aanæs, *Signed Distance Computation Using the Angle Weighted
/// Pseudonormal*, 2005).
pub(super) fn vertex_normals(vertices: &[Vector<3>], faces: &[Face]) -> Vec<Vector<3>> {
    let mut normals = vec![Vector::ZERO; vertices.len()];
    for face in faces {
        let outward = -face.inward_normal();
        let corners = face.vertices();
        let n = corners.len();
        for i in 0..n {
            let at = vertices[corners[i]];
            let next = vertices[corners[(i + 1) % n]] - at;
            let before = vertices[corners[(i + n - 1) % n]] - at;
            let turn = outward.dot(spatial::cross(next, before)).atan2(next.dot(before));
            // Corners may be hollow, up to a full turn.
            let angle = if turn < 0.0 { turn + std::f64::consts::TAU } else { turn };
            normals[corners[i]] += outward * angle;
        }
    }
    normals
}

/// The inward direction at a point of the surface, of any length.
pub(super) fn inward(solid: &Polyhedron, face: usize, feature: Feature) -> Vector<3> {
    match feature {
        Feature::Face => solid.faces[face].inward_normal(),
        Feature::Vertex(vertex) => -solid.vertex_normals[vertex],
        Feature::Edge(ends) => {
            let [one, other] = faces_along(&solid.edges, ends).unwrap_or([face, face]);
            solid.faces[one].inward_normal() + solid.faces[other].inward_normal()
        }
    }
}

/// The two faces that the edge with these ends joins, the lower number first.
pub(super) fn faces_along(edges: &[SolidEdge], ends: [usize; 2]) -> Option<[usize; 2]> {
    let found = edges.binary_search_by_key(&ends, |edge| edge.vertices).ok()?;
    let [one, other] = edges[found].faces;
    Some([one.min(other), one.max(other)])
}

fn box_around(vertices: &[Vector<3>], corners: &[usize], scale: f64) -> Aabb {
    let points = corners.iter().map(|&corner| to_parry(vertices[corner] * scale));
    points.fold(Aabb::new_invalid(), |around, point| {
        Aabb::new(around.mins.min(point), around.maxs.max(point))
    })
}

fn to_parry(v: Vector<3>) -> ParryVector {
    ParryVector::from_array(v.to_array())
}
