//! Whether vertices and faces are the surface of a solid.

use std::cmp::Ordering;

use clench_screw::Vector;

use super::face::edges_of;
use super::{LARGEST_SOLID_COORDINATE, PolyhedronError, SMALLEST_SOLID_COORDINATE};

/// An edge of a solid, and the two faces that it joins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SolidEdge {
    /// The ends, the lower number first.
    pub(super) vertices: [usize; 2],
    /// The face that runs from the first end to the second, and the one that runs back.
    pub(super) faces: [usize; 2],
}

pub(super) fn check_counts(vertices: usize, faces: usize) -> Result<(), PolyhedronError> {
    if vertices < 4 {
        return Err(PolyhedronError::TooFewVertices { count: vertices });
    }
    if faces < 4 {
        return Err(PolyhedronError::TooFewFaces { count: faces });
    }
    Ok(())
}

pub(super) fn check_coordinates(vertices: &[Vector<3>]) -> Result<(), PolyhedronError> {
    let named = |(vertex, v): (usize, &Vector<3>)| {
        v.to_array()
            .into_iter()
            .zip(['x', 'y', 'z'])
            .map(move |(value, axis)| (vertex, axis, value))
    };
    for (vertex, axis, value) in vertices.iter().enumerate().flat_map(named) {
        if !value.is_finite() {
            return Err(PolyhedronError::NotFinite { vertex, axis, value });
        }
        if value.abs() > LARGEST_SOLID_COORDINATE {
            return Err(PolyhedronError::TooLarge { vertex, axis, value });
        }
        if value.abs() > 0.0 && value.abs() < SMALLEST_SOLID_COORDINATE {
            return Err(PolyhedronError::TooSmall { vertex, axis, value });
        }
    }
    Ok(())
}

/// Each face has at least three corners, all different, that are vertices.
pub(super) fn check_corners(count: usize, faces: &[Vec<usize>]) -> Result<(), PolyhedronError> {
    for (face, corners) in faces.iter().enumerate() {
        if corners.len() < 3 {
            return Err(PolyhedronError::TooFewCorners { face, count: corners.len() });
        }
        if let Some(&vertex) = corners.iter().find(|&&corner| corner >= count) {
            return Err(PolyhedronError::NoSuchVertex { face, vertex, count });
        }
        let mut sorted = corners.clone();
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(PolyhedronError::RepeatedCorner { face, vertex: pair[0] });
        }
    }
    Ok(())
}

/// The vertices that faces use, ascending; no two are the same point.
pub(super) fn used_vertices(
    vertices: &[Vector<3>],
    faces: &[Vec<usize>],
) -> Result<Vec<usize>, PolyhedronError> {
    let mut is_used = vec![false; vertices.len()];
    faces.iter().flatten().for_each(|&corner| is_used[corner] = true);
    let used: Vec<usize> = (0..vertices.len()).filter(|&vertex| is_used[vertex]).collect();
    let mut order = used.clone();
    order.sort_unstable_by(|&i, &j| compare(vertices[i], vertices[j]).then(i.cmp(&j)));
    let equal = |pair: &&[usize]| compare(vertices[pair[0]], vertices[pair[1]]) == Ordering::Equal;
    match order.windows(2).filter(equal).min() {
        Some(pair) => Err(PolyhedronError::EqualVertices { first: pair[0], second: pair[1] }),
        None => Ok(used),
    }
}

/// By x, then y, then z; the coordinates are finite.
fn compare(a: Vector<3>, b: Vector<3>) -> Ordering {
    // Adding zero makes the two zeros equal.
    let by = |axis: usize| (a[axis] + 0.0).total_cmp(&(b[axis] + 0.0));
    by(0).then_with(|| by(1)).then_with(|| by(2))
}

/// An edge as one face runs along it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Run {
    vertices: [usize; 2],
    face: usize,
    backward: bool,
}

impl Run {
    /// The ends in the order in which the face has them.
    fn direction(self) -> [usize; 2] {
        let [low, high] = self.vertices;
        if self.backward { [high, low] } else { [low, high] }
    }
}

/// The edges, in order of their vertices: each is run along once in either direction.
pub(super) fn joined_edges(faces: &[Vec<usize>]) -> Result<Vec<SolidEdge>, PolyhedronError> {
    let mut runs = Vec::with_capacity(faces.iter().map(Vec::len).sum());
    for (face, corners) in faces.iter().enumerate() {
        runs.extend(edges_of(corners).map(|[from, to]| Run {
            vertices: [from.min(to), from.max(to)],
            face,
            backward: from > to,
        }));
    }
    runs.sort_unstable();
    runs.chunk_by(|a, b| a.vertices == b.vertices).map(joined).collect()
}

/// The edge of all faces that run along it.
fn joined(runs: &[Run]) -> Result<SolidEdge, PolyhedronError> {
    match *runs {
        [one] => Err(PolyhedronError::OpenEdge { vertices: one.direction(), face: one.face }),
        [one, other] if one.backward == other.backward => {
            let faces = [one.face, other.face];
            Err(PolyhedronError::FlippedNeighbor { vertices: one.direction(), faces })
        }
        [one, other] => {
            let faces = if one.backward { [other, one] } else { [one, other] };
            Ok(SolidEdge { vertices: one.vertices, faces: faces.map(|run| run.face) })
        }
        _ => Err(PolyhedronError::NonManifoldEdge {
            vertices: runs[0].vertices,
            faces: std::array::from_fn(|i| runs[i].face),
            count: runs.len(),
        }),
    }
}
