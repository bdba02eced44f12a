//! The edges of a solid that are drawn, joined to lines.

use std::collections::BTreeMap;

use clench_screw::Vector;

use crate::solid::SolidPicture;
use crate::solid::scene::{Scene, SeenFace};

/// The cosine of 20 degrees: faces whose normals differ by less belong to one smooth surface. A
/// cylinder of 20 sides does.
const SMOOTH: f64 = 0.939_692_620_785_908_4;

/// Why an edge is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum EdgeKind {
    /// The surface ends, or bends sharply.
    Sharp,
    /// A smooth surface turns away from the viewer.
    Outline,
    /// A smooth surface turns away in a hollow, which never is in sight: where it seems so, the
    /// outline of a mesh zigzags.
    Hollow,
}

/// Edges of one kind that follow one another; a closed line ends where it begins.
#[derive(Debug)]
pub(crate) struct Line {
    pub(crate) points: Vec<Vector<3>>,
    pub(crate) kind: EdgeKind,
}

/// The edges to draw, joined to lines.
pub(crate) fn lines(picture: &SolidPicture, scene: &Scene) -> Vec<Line> {
    let mesh = Mesh::new(picture);
    let mut drawn: BTreeMap<EdgeKind, Vec<[usize; 2]>> = BTreeMap::new();
    for (&edge, faces) in &mesh.edges {
        if let Some(kind) = kind(faces, scene) {
            drawn.entry(kind).or_default().push(edge);
        }
    }
    let point = |vertex: usize| scene.point(mesh.vertices[vertex]);
    let mut lines = Vec::new();
    for (kind, edges) in drawn {
        for chain in chains(&edges) {
            lines.push(Line { points: chain.into_iter().map(point).collect(), kind });
        }
    }
    lines
}

/// The corners of the loops, each once, and the faces at each edge.
#[derive(Default)]
struct Mesh {
    vertices: Vec<[f64; 3]>,
    edges: BTreeMap<[usize; 2], Vec<usize>>,
}

impl Mesh {
    fn new(picture: &SolidPicture) -> Self {
        let mut mesh = Self::default();
        let mut numbers = BTreeMap::new();
        for (face, solid_face) in picture.faces.iter().enumerate() {
            for ring in &solid_face.loops {
                let ring: Vec<_> = ring.iter().map(|&at| mesh.vertex(&mut numbers, at)).collect();
                for (i, &from) in ring.iter().enumerate() {
                    let to = ring[(i + 1) % ring.len()];
                    if from != to {
                        mesh.edges.entry([from.min(to), from.max(to)]).or_default().push(face);
                    }
                }
            }
        }
        mesh
    }

    /// The number of the vertex here; a new one unless a corner was here before.
    fn vertex(&mut self, numbers: &mut BTreeMap<[u64; 3], usize>, at: [f64; 3]) -> usize {
        // Adding zero makes the negative zero positive.
        *numbers.entry(at.map(|value| (value + 0.0).to_bits())).or_insert_with(|| {
            self.vertices.push(at);
            self.vertices.len() - 1
        })
    }
}

/// Why the edge between faces is drawn; none inside a smooth or plane surface.
fn kind(faces: &[usize], scene: &Scene) -> Option<EdgeKind> {
    let [a, b] = faces else { return Some(EdgeKind::Sharp) };
    let [a, b] = [a, b].map(|&face| &scene.faces[face]);
    if a.normal.dot(b.normal) < SMOOTH {
        return Some(EdgeKind::Sharp);
    }
    // In a hollow, a face rises above the plane of its neighbor.
    let is_hollow = (middle(b) - middle(a)).dot(a.normal) > 0.0;
    let outline = if is_hollow { EdgeKind::Hollow } else { EdgeKind::Outline };
    (a.is_front() != b.is_front()).then_some(outline)
}

/// The mean of the corners of a face's triangles.
fn middle(face: &SeenFace) -> Vector<3> {
    let corners = face.triangles.as_flattened();
    let sum = corners.iter().fold(Vector::ZERO, |sum, &corner| sum + corner);
    sum * (corners.len() as f64).recip()
}

/// Joins edges at vertices where exactly two meet.
fn chains(edges: &[[usize; 2]]) -> Vec<Vec<usize>> {
    let mut at_vertex: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (edge, ends) in edges.iter().enumerate() {
        for &end in ends {
            at_vertex.entry(end).or_default().push(edge);
        }
    }
    let mut used = vec![false; edges.len()];
    let mut chains = Vec::new();
    // Open lines from their ends, then what is left: closed ones.
    let ends = at_vertex.iter().filter(|(_, edges)| edges.len() != 2);
    for (&start, starting) in ends.chain(at_vertex.iter().filter(|(_, edges)| edges.len() == 2)) {
        for &first in starting {
            if used[first] {
                continue;
            }
            let (mut chain, mut next) = (vec![start], Some(first));
            while let Some(edge) = next {
                used[edge] = true;
                let [a, b] = edges[edge];
                let here = if chain.last() == Some(&a) { b } else { a };
                chain.push(here);
                next = match at_vertex[&here][..] {
                    [a, b] => [a, b].into_iter().find(|&edge| !used[edge]),
                    _ => None,
                };
            }
            chains.push(chain);
        }
    }
    chains
}
