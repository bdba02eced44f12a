//! One flat face of a solid.

use clench_screw::{Vector, spatial};

use super::PolyhedronError;
use super::ears::ears;
use crate::loops::Loops;
use crate::predicates::turn;
use crate::validity::checked_hull;

/// Corners this many roundings of their coordinates away from one line, or one plane, are on it:
/// two for a corner's own rounding in a file and at its source, as many for each of the three
/// that the plane is laid through, whose errors grow at most twofold to the other corners of a
/// face, and the arithmetic once more.
pub(super) const FLAT_ROUNDING: f64 = 32.0 * f64::EPSILON;

/// A flat face: a place for fingers to touch.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    vertices: Vec<usize>,
    inward_normal: Vector<3>,
    area: f64,
    point: Vector<3>,
}

impl Face {
    /// Face number `face` of a solid, with distinct corners that are numbers of `vertices`.
    pub(super) fn new(
        vertices: &[Vector<3>],
        face: usize,
        corners: &[usize],
    ) -> Result<Self, PolyhedronError> {
        let points: Vec<Vector<3>> = corners.iter().map(|&corner| vertices[corner]).collect();
        let allowed = FLAT_ROUNDING * points.iter().fold(0.0_f64, |m, p| m.max(p.max_abs()));
        let (normal, width) = plane_normal(&points);
        if width <= allowed {
            return Err(PolyhedronError::ZeroAreaFace { face, width, allowed });
        }
        if points.len() > 3 {
            let (at, distance) = farthest_from_plane(&points, normal);
            if distance > allowed {
                let vertex = corners[at];
                return Err(PolyhedronError::NotPlanar { face, vertex, distance, allowed });
            }
            let outline: Vec<Vector<2>> = points.iter().map(|&p| flattened(p, normal)).collect();
            checked_hull(&outline, &Loops::of_lengths([outline.len()].into_iter()))
                .map_err(|fault| PolyhedronError::FaultyFace { face, fault })?;
        }
        let (signed_area, point) = moments(&points, normal);
        let inward_normal = if signed_area > 0.0 { -normal } else { normal };
        Ok(Self { vertices: corners.to_vec(), inward_normal, area: signed_area.abs(), point })
    }

    /// The numbers of its vertices, counter-clockwise seen from outside.
    #[must_use]
    pub fn vertices(&self) -> &[usize] {
        &self.vertices
    }

    /// The unit normal that points into the solid.
    #[must_use]
    pub fn inward_normal(&self) -> Vector<3> {
        self.inward_normal
    }

    /// The area (length squared).
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The centroid: a point of the face's plane, and of the face itself if it is convex.
    #[must_use]
    pub fn point(&self) -> Vector<3> {
        self.point
    }

    /// The ends of the edges, in the order of the vertices.
    pub(super) fn edges(&self) -> impl Iterator<Item = [usize; 2]> {
        edges_of(&self.vertices)
    }

    /// Triangles of its vertices that cover it exactly once, seen along the axis along which it is
    /// widest; counter-clockwise seen from outside.
    pub(super) fn triangles(&self, vertices: &[Vector<3>]) -> Vec<[usize; 3]> {
        if let [a, b, c] = self.vertices[..] {
            return vec![[a, b, c]];
        }
        let flat = |&corner: &usize| flattened(vertices[corner], self.inward_normal);
        let outline: Vec<Vector<2>> = self.vertices.iter().map(flat).collect();
        ears(&outline).into_iter().map(|corners| corners.map(|i| self.vertices[i])).collect()
    }

    /// Whether a point of the face's plane is within its outline.
    ///
    /// Counts how often the outline passes one side of the point, exactly, without the axis along
    /// which the face is widest seen; points of the outline itself may be called either.
    pub(super) fn encloses(&self, vertices: &[Vector<3>], point: Vector<3>) -> bool {
        let at = flattened(point, self.inward_normal);
        let mut inside = false;
        for edge in self.edges() {
            let [a, b] = edge.map(|corner| flattened(vertices[corner], self.inward_normal));
            if (a[1] > at[1]) != (b[1] > at[1]) {
                let left = turn(a, b, at) > 0.0;
                inside ^= left == (b[1] > a[1]);
            }
        }
        inside
    }
}

/// The pairs of neighbors of a closed chain.
pub(super) fn edges_of(corners: &[usize]) -> impl Iterator<Item = [usize; 2]> {
    (0..corners.len()).map(|i| [corners[i], corners[(i + 1) % corners.len()]])
}

/// A unit normal of the plane through `points`, of either sign, and how far they are from a line.
///
/// Of the offset from the first corner to the farthest and the largest offset across it: unlike
/// the usual sum of cross products, whose error grows with the square of a thin face's length,
/// this errs by the rounding of the points.
fn plane_normal(points: &[Vector<3>]) -> (Vector<3>, f64) {
    let longest = longest(points.iter().map(|&p| p - points[0]));
    let along = longest * (1.0 / longest.norm());
    let across = self::longest(points.iter().map(|&p| {
        let offset = p - points[0];
        offset - along * along.dot(offset)
    }));
    let width = across.norm();
    let normal = spatial::cross(along, across * (1.0 / width));
    (normal * (1.0 / normal.norm()), width)
}

fn longest(vectors: impl Iterator<Item = Vector<3>>) -> Vector<3> {
    vectors.fold(
        Vector::ZERO,
        |longest, v| {
            if v.norm_squared() > longest.norm_squared() { v } else { longest }
        },
    )
}

/// The corner farthest from the plane through the first one, and its distance.
fn farthest_from_plane(points: &[Vector<3>], normal: Vector<3>) -> (usize, f64) {
    let distances = points.iter().map(|&p| normal.dot(p - points[0]).abs());
    distances.enumerate().fold((0, 0.0), |far, near| if near.1 > far.1 { near } else { far })
}

/// The point without the coordinate along which `normal` is largest.
fn flattened(point: Vector<3>, normal: Vector<3>) -> Vector<2> {
    let [x, y, z] = normal.to_array().map(f64::abs);
    let dropped = if x >= y && x >= z { 0 } else { 1 + usize::from(z > y) };
    Vector::new([point[(dropped + 1) % 3], point[(dropped + 2) % 3]])
}

/// The area, positive if the corners run counter-clockwise about `normal`, and the centroid.
fn moments(points: &[Vector<3>], normal: Vector<3>) -> (f64, Vector<3>) {
    let (mut area, mut moment) = (0.0, Vector::ZERO);
    for pair in points[1..].windows(2) {
        let [a, b] = [pair[0] - points[0], pair[1] - points[0]];
        let triangle = 0.5 * normal.dot(spatial::cross(a, b));
        area += triangle;
        moment += (a + b) * (triangle / 3.0);
    }
    (area, points[0] + moment * (1.0 / area))
}
