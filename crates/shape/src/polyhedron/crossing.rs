//! Whether a solid's surface passes through itself.

use clench_screw::{Vector, spatial};

use super::face::FLAT_ROUNDING;
use super::surface::{FaceTree, faces_along};
use super::validity::SolidEdge;
use super::{Face, PolyhedronError};
use crate::predicates::{above, unit_scale};

/// Two points in single precision are this much nearer to each other than they were, or farther,
/// at most, over the size of their coordinates: the root of three by half a rounding for each, and
/// as much again for the plane or the edge that the other is on.
const SINGLE_ROUNDING: f64 = 4.0 * f32::EPSILON as f64;

/// Looks for the first face that passes through another, and the first of those.
///
/// Faces are triangles, or cut into them. Whether two have a point inside of both in common is
/// decided exactly. If they have, but only as near to an edge as the rounding of coordinates can
/// move it, then the triangles touch, which is no fault, unless it is an edge whose two faces are
/// on either side of the other triangle. Surfaces that cross along edges of both alone are not
/// noticed.
///
/// Cost: O(n log n) when few boxes of triangles overlap. The answer does not depend on the order
/// in which the tree gives them.
pub(super) fn check_crossings(
    vertices: &[Vector<3>],
    faces: &[Face],
    edges: &[SolidEdge],
    tree: &FaceTree,
) -> Result<(), PolyhedronError> {
    let corners = faces.iter().flat_map(Face::vertices);
    let largest = corners.fold(0.0_f64, |m, &corner| m.max(vertices[corner].max_abs()));
    let scale = unit_scale(largest);
    let points: Vec<Vector<3>> = vertices.iter().map(|&v| v * scale).collect();
    let pieces: Vec<Piece> = faces
        .iter()
        .enumerate()
        .flat_map(|(face, whole)| {
            let triangles = whole.triangles(vertices).into_iter();
            triangles.map(move |corners| Piece { face, corners })
        })
        .collect();
    let own;
    let tree = if pieces.len() == faces.len() {
        tree
    } else {
        own = FaceTree::new(vertices, pieces.iter().map(|piece| &piece.corners[..]), largest);
        &own
    };
    let rounding = rounding_of(vertices, faces) * largest * scale;
    let surface = Surface { points: &points, faces, edges, rounding };
    let mut first: Option<([usize; 2], Vector<3>)> = None;
    for piece in tree.in_order().map(|piece| &pieces[piece]) {
        let is_before = |faces: [usize; 2], first: &Option<([usize; 2], Vector<3>)>| {
            first.is_none_or(|(least, _)| faces < least)
        };
        if !is_before([piece.face, 0], &first) {
            continue;
        }
        for other in tree.overlapping(vertices, &piece.corners).map(|other| &pieces[other]) {
            let faces = [piece.face, other.face];
            if faces[0] < faces[1]
                && is_before(faces, &first)
                && let Some(point) = surface.crossing(piece, other)
            {
                first = Some((faces, point));
            }
        }
    }
    first.map_or(Ok(()), |(faces, point)| {
        let point = (point * (1.0 / scale)).to_array();
        Err(PolyhedronError::FacesCross { faces, point })
    })
}

/// How far rounding may have moved vertices, over the size of their coordinates.
fn rounding_of(vertices: &[Vector<3>], faces: &[Face]) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "what is lost is what is asked for")]
    let is_single = |x: f64| f64::from(x as f32).to_bits() == x.to_bits();
    let mut corners = faces.iter().flat_map(Face::vertices);
    let all_single = corners.all(|&corner| vertices[corner].to_array().into_iter().all(is_single));
    if all_single { SINGLE_ROUNDING } else { FLAT_ROUNDING }
}

/// A triangle of a face.
#[derive(Clone, Copy, Debug)]
struct Piece {
    face: usize,
    corners: [usize; 3],
}

impl Piece {
    fn edges(&self) -> [[usize; 2]; 3] {
        let [a, b, c] = self.corners;
        [[a, b], [b, c], [c, a]]
    }
}

/// What the pieces belong to, in units of about the solid's size.
struct Surface<'a> {
    points: &'a [Vector<3>],
    faces: &'a [Face],
    edges: &'a [SolidEdge],
    /// How far rounding may have moved a vertex.
    rounding: f64,
}

impl Surface<'_> {
    /// A point where two pieces of different faces pass through each other.
    fn crossing(&self, one: &Piece, other: &Piece) -> Option<Vector<3>> {
        let shared = one.corners.iter().filter(|&corner| other.corners.contains(corner)).count();
        if shared > 1 {
            // They meet elsewhere only if one is folded onto the other: no crossing.
            return None;
        }
        let [t, u] = [one, other].map(|piece| piece.corners.map(|corner| self.points[corner]));
        let beyond = sides(t, u);
        if is_aside(beyond) {
            return None;
        }
        if beyond == [0; 3] {
            return self.overlap(one, other, [t, u]);
        }
        let before = sides(u, t);
        if is_aside(before) {
            return None;
        }
        let is_cut = |sides: [i8; 3]| sides.contains(&1) && sides.contains(&-1);
        if is_cut(beyond) && is_cut(before) {
            if !cross_inside([t, u], [before, beyond]) {
                return None;
            }
            let normals = [one, other].map(|piece| self.faces[piece.face].inward_normal());
            if let Some(point) = deep_crossing([t, u], normals, self.rounding) {
                return Some(point);
            }
        }
        self.edge_through(one, other, u).or_else(|| self.edge_through(other, one, t))
    }

    /// A point inside of two pieces that are in one plane and face the same way, if they overlap
    /// by more than rounding.
    fn overlap(
        &self,
        one: &Piece,
        other: &Piece,
        [t, u]: [[Vector<3>; 3]; 2],
    ) -> Option<Vector<3>> {
        let [normal, there] = [one, other].map(|piece| self.faces[piece.face].inward_normal());
        if normal.dot(there) <= 0.0 {
            return None;
        }
        let inside = |corners, point| depth(corners, -normal, point);
        let middle = middle_of_common([t, u], normal)?;
        (inside(t, middle).min(inside(u, middle)) > self.rounding).then_some(middle)
    }

    /// A point where the edge of a piece lies in another, whose corners are `there`, with the
    /// faces along it on both sides.
    fn edge_through(
        &self,
        piece: &Piece,
        other: &Piece,
        there: [Vector<3>; 3],
    ) -> Option<Vector<3>> {
        let normal = self.faces[other.face].inward_normal();
        piece.edges().into_iter().find_map(|ends| {
            let [from, to] = ends.map(|end| self.points[end]);
            let level = |p: Vector<3>| normal.dot(p - there[0]).abs() <= self.rounding;
            if !level(from) || !level(to) || !self.leads_through(piece.face, ends, normal) {
                return None;
            }
            let middle = middle_within([from, to], there, normal)?;
            (depth(there, -normal, middle) > self.rounding).then_some(middle)
        })
    }

    /// Whether the surface goes on to both sides of the plane with this normal that an edge of a
    /// face is in, by more than rounding.
    fn leads_through(&self, face: usize, ends: [usize; 2], normal: Vector<3>) -> bool {
        let [from, to] = ends.map(|end| self.points[end]);
        let length = (to - from).norm();
        let along = (to - from) * (1.0 / length);
        // Away from the edge, to the left of it as the face runs, and how far.
        let rise = |face: usize, along: Vector<3>| {
            normal.dot(spatial::cross(along, self.faces[face].inward_normal()))
        };
        let here = rise(face, along);
        let beyond = match faces_along(self.edges, [ends[0].min(ends[1]), ends[0].max(ends[1])]) {
            Some([one, other]) => rise(if one == face { other } else { one }, -along),
            // Within a face.
            None => -here,
        };
        let least = self.rounding / length;
        (here > least && beyond < -least) || (here < -least && beyond > least)
    }
}

/// The sides of the plane through the first triangle on which the corners of the second are.
fn sides([a, b, c]: [Vector<3>; 3], corners: [Vector<3>; 3]) -> [i8; 3] {
    corners.map(|p| {
        let height = above(a, b, c, p);
        i8::from(height > 0.0) - i8::from(height < 0.0)
    })
}

/// Whether a triangle with its corners on these sides meets the plane in a corner at most.
fn is_aside(sides: [i8; 3]) -> bool {
    let sum: i8 = sides.iter().sum();
    sum.abs() > 1
}

/// Whether two triangles have points inside of both in common, where each has corners on both
/// sides of the plane of the other.
///
/// The line of both planes passes through both; the two segments of it are compared by P. Guigue
/// and O. Devillers, *Fast and Robust Triangle-Triangle Overlap Test Using Orientation
/// Predicates*, 2003.
fn cross_inside([t, u]: [[Vector<3>; 3]; 2], sides: [[i8; 3]; 2]) -> bool {
    let [(i, up), (j, there_up)] = sides.map(lone);
    let turned = |corners: [Vector<3>; 3], first: usize, is_kept: bool| {
        let [a, b, c] = [0, 1, 2].map(|k| corners[(first + k) % 3]);
        if is_kept { [a, b, c] } else { [a, c, b] }
    };
    // Each with its lone corner first, which is above the plane of the other.
    let [a, b, c] = turned(t, i, there_up);
    let [d, e, f] = turned(u, j, up);
    above(b, d, a, e) < 0.0 && above(a, d, c, f) < 0.0
}

/// The corner that has no other on its side, and whether that is the upper one.
fn lone(sides: [i8; 3]) -> (usize, bool) {
    let only = |side: i8| {
        let mut there = (0..3).filter(|&i| sides[i] == side);
        there.next().filter(|_| there.next().is_none())
    };
    only(1).map_or_else(|| (only(-1).unwrap_or(0), false), |i| (i, true))
}

/// The middle of the segment that two triangles have in common, if it is farther inside of both
/// than rounding can move it: by as much as their planes, over the sine between them.
fn deep_crossing(
    triangles: [[Vector<3>; 3]; 2],
    inward_normals: [Vector<3>; 2],
    rounding: f64,
) -> Option<Vector<3>> {
    let [t, u] = triangles;
    let [n, m] = inward_normals;
    let line = spatial::cross(n, m);
    let sine = line.norm();
    let cut = |corners: [Vector<3>; 3], normal: Vector<3>, point: Vector<3>| {
        let height = corners.map(|p| normal.dot(p - point));
        let mut points = (0..3).filter_map(|i| {
            let j = (i + 1) % 3;
            let share = height[i] / (height[i] - height[j]);
            let is_between = (height[i] > 0.0) != (height[j] > 0.0);
            is_between.then(|| corners[i] + (corners[j] - corners[i]) * share)
        });
        let [one, other] = [points.next()?, points.next()?];
        Some(if line.dot(other - one) > 0.0 { [one, other] } else { [other, one] })
    };
    let ([a, b], [c, d]) = (cut(t, m, u[0])?, cut(u, n, t[0])?);
    let start = if line.dot(c - a) > 0.0 { c } else { a };
    let end = if line.dot(d - b) > 0.0 { b } else { d };
    let middle = (start + end) * 0.5;
    let inside = depth(t, -n, middle).min(depth(u, -m, middle));
    (line.dot(end - start) > 0.0 && inside * sine > rounding).then_some(middle)
}

/// How far a point of a triangle's plane is inside of it; negative if it is outside.
fn depth(corners: [Vector<3>; 3], outward_normal: Vector<3>, point: Vector<3>) -> f64 {
    let from = |i: usize| depth_from([corners[i], corners[(i + 1) % 3]], outward_normal, point);
    (0..3).map(from).fold(f64::INFINITY, f64::min)
}

/// How far a point is to the left of an edge, seen from outside.
fn depth_from([a, b]: [Vector<3>; 2], outward_normal: Vector<3>, point: Vector<3>) -> f64 {
    outward_normal.dot(spatial::cross(b - a, point - a)) / (b - a).norm()
}

/// The middle of what of a segment is in a triangle, seen along its normal.
fn middle_within(
    [from, to]: [Vector<3>; 2],
    corners: [Vector<3>; 3],
    inward_normal: Vector<3>,
) -> Option<Vector<3>> {
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    for i in 0..3 {
        let edge = [corners[i], corners[(i + 1) % 3]];
        let [start, end] = [from, to].map(|p| depth_from(edge, -inward_normal, p));
        if start < 0.0 && end < 0.0 {
            return None;
        }
        let share = start / (start - end);
        if start < 0.0 {
            low = low.max(share);
        } else if end < 0.0 {
            high = high.min(share);
        }
    }
    (low < high).then(|| from + (to - from) * (0.5 * (low + high)))
}

/// The mean of the corners of what two triangles in one plane have in common.
fn middle_of_common([t, u]: [[Vector<3>; 3]; 2], inward_normal: Vector<3>) -> Option<Vector<3>> {
    let mut common = t.to_vec();
    for i in 0..3 {
        let edge = [u[i], u[(i + 1) % 3]];
        let depths: Vec<f64> =
            common.iter().map(|&p| depth_from(edge, -inward_normal, p)).collect();
        let mut kept = Vec::new();
        for (k, &p) in common.iter().enumerate() {
            let next = (k + 1) % common.len();
            if depths[k] >= 0.0 {
                kept.push(p);
            }
            if (depths[k] < 0.0) != (depths[next] < 0.0) {
                let share = depths[k] / (depths[k] - depths[next]);
                kept.push(p + (common[next] - p) * share);
            }
        }
        common = kept;
    }
    let sum = common.iter().fold(Vector::ZERO, |sum, &p| sum + p);
    (!common.is_empty()).then(|| sum * (1.0 / common.len() as f64))
}
