//! Neighboring faces in one plane, taken together.

use clench_screw::{Vector, spatial};

use super::face::FLAT_ROUNDING;
use super::{Face, Polyhedron};

/// A face within some distance of a plane, and this many times as wide, is tilted by 30 degrees at
/// most, so that it faces one way or the other. What is narrower may be tilted by rounding alone.
const NARROW: f64 = 4.0;

/// A maximal set of faces in one plane, joined by edges: a place to touch.
///
/// [`Polyhedron::facets`] makes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Facet {
    faces: Vec<usize>,
    inward_normal: Vector<3>,
    area: f64,
    triangles: Vec<[Vector<3>; 3]>,
    loops: Vec<Vec<usize>>,
}

impl Facet {
    /// The numbers of the solid's faces, ascending.
    #[must_use]
    pub fn faces(&self) -> &[usize] {
        &self.faces
    }

    /// The unit normal that points into the solid, one for all of it: the mean of the faces'
    /// normals, weighted by their areas.
    #[must_use]
    pub fn inward_normal(&self) -> Vector<3> {
        self.inward_normal
    }

    /// The area: the sum of those of the faces (length squared).
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area
    }

    /// Triangles that cover it exactly once (length), counter-clockwise seen from outside.
    ///
    /// Their corners are vertices of the solid. None has its corners on one line, to the rounding
    /// of their coordinates; an edge of one may have a corner of others in its middle.
    #[must_use]
    pub fn triangles(&self) -> &[[Vector<3>; 3]] {
        &self.triangles
    }

    /// Its boundary, as closed chains of the solid's vertices: first the outer one, which runs
    /// counter-clockwise seen from outside, then the holes, clockwise, the larger ones first.
    ///
    /// A chain has no vertex twice and begins at its lowest. Vertices in the middle of straight
    /// stretches are kept.
    #[must_use]
    pub fn loops(&self) -> &[Vec<usize>] {
        &self.loops
    }
}

impl Polyhedron {
    /// The faces taken together where they are in one plane: what a part has as places to touch,
    /// however its sides were cut into triangles.
    ///
    /// A facet grows over edges from its largest face: a neighbor joins if its vertices are within
    /// `flatness` (length), and what coordinates round to, of that face's plane, and it is not
    /// the other side of a thin sheet. The largest face of all has the first choice, so that the
    /// numbers of faces do not matter. Each face is in one facet; facets are in the order of their
    /// lowest faces. A `flatness` below 0, or not a number, is as 0.
    ///
    /// Coordinates in single precision, as in STL files, are off by up to 6e-8 of the largest, and
    /// a plane through three of them by several times that at the far end of a side: 1e-6 of the
    /// largest is a sensible `flatness` for them, 0 for coordinates in double precision that are
    /// exact. What a curved surface rises by within the flatness is taken for flat.
    ///
    /// Cost: O(n log n) for faces with `n` corners together; the triangles of a face with many
    /// hollow corners cost their product with all of its corners.
    ///
    /// ```
    /// use clench_shape::Polyhedron;
    /// // The corner of a cube; its base is cut into two triangles.
    /// let vertices =
    ///     [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0], [1.0, 1.0, 0.0]];
    /// let faces = [[0, 2, 4], [0, 4, 1], [0, 1, 3], [0, 3, 2], [1, 4, 3], [4, 2, 3]];
    /// let solid = Polyhedron::new(&vertices, &faces.map(Vec::from))?;
    /// let facets = solid.facets(0.0);
    /// assert_eq!(facets.len(), 4);
    /// assert_eq!((facets[0].faces(), facets[0].area()), ([0, 1].as_slice(), 2.0));
    /// assert_eq!(facets[0].loops(), [[0, 2, 4, 1]]);
    /// # Ok::<(), clench_shape::PolyhedronError>(())
    /// ```
    #[must_use]
    pub fn facets(&self, flatness: f64) -> Vec<Facet> {
        let seeds = seeds(self, flatness.max(0.0));
        let mut numbers = vec![usize::MAX; self.faces.len()];
        let mut members: Vec<Vec<usize>> = Vec::new();
        for (face, &seed) in seeds.iter().enumerate() {
            if numbers[seed] == usize::MAX {
                numbers[seed] = members.len();
                members.push(Vec::new());
            }
            members[numbers[seed]].push(face);
        }
        let mut borders = vec![Vec::new(); members.len()];
        for edge in &self.edges {
            let [low, high] = edge.vertices;
            let [one, other] = edge.faces.map(|face| numbers[seeds[face]]);
            if one != other {
                borders[one].push([low, high]);
                borders[other].push([high, low]);
            }
        }
        members.into_iter().zip(borders).map(|(faces, border)| facet(self, faces, border)).collect()
    }
}

/// For each face the largest one of its facet.
fn seeds(solid: &Polyhedron, flatness: f64) -> Vec<usize> {
    let neighbors = Neighbors::new(solid);
    let mut seeds: Vec<Option<usize>> = vec![None; solid.faces.len()];
    for seed in by_size(&solid.faces) {
        if seeds[seed].is_some() {
            continue;
        }
        seeds[seed] = Some(seed);
        let plane = Plane::of(solid, seed, flatness);
        let mut reached = vec![seed];
        while let Some(face) = reached.pop() {
            for &next in neighbors.of(face) {
                if seeds[next].is_none() && plane.holds(solid, next) {
                    seeds[next] = Some(seed);
                    reached.push(next);
                }
            }
        }
    }
    seeds.into_iter().enumerate().map(|(face, seed)| seed.unwrap_or(face)).collect()
}

/// The faces, the largest first; of equal ones the one with the lowest coordinates of its centroid.
fn by_size(faces: &[Face]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..faces.len()).collect();
    order.sort_unstable_by(|&i, &j| {
        let (one, other) = (&faces[i], &faces[j]);
        let (at, there) = (one.point(), other.point());
        let along = |axis: usize| at[axis].total_cmp(&there[axis]);
        let by_place = || along(0).then_with(|| along(1)).then_with(|| along(2));
        other.area().total_cmp(&one.area()).then_with(by_place).then(i.cmp(&j))
    });
    order
}

/// The faces across the edges of each face.
struct Neighbors {
    starts: Vec<usize>,
    faces: Vec<usize>,
}

impl Neighbors {
    fn new(solid: &Polyhedron) -> Self {
        let mut starts = vec![0];
        starts.extend(solid.faces.iter().scan(0, |end, face| {
            *end += face.vertices().len();
            Some(*end)
        }));
        let (mut next, mut faces) = (starts.clone(), vec![0; 2 * solid.edges.len()]);
        for edge in &solid.edges {
            let [one, other] = edge.faces;
            for (face, neighbor) in [(one, other), (other, one)] {
                faces[next[face]] = neighbor;
                next[face] += 1;
            }
        }
        Self { starts, faces }
    }

    fn of(&self, face: usize) -> &[usize] {
        &self.faces[self.starts[face]..self.starts[face + 1]]
    }
}

/// The plane of a face.
struct Plane {
    point: Vector<3>,
    inward_normal: Vector<3>,
    flatness: f64,
    size: f64,
}

impl Plane {
    fn of(solid: &Polyhedron, face: usize, flatness: f64) -> Self {
        let size = size(solid, face);
        let face = &solid.faces[face];
        Self { point: face.point(), inward_normal: face.inward_normal(), flatness, size }
    }

    fn holds(&self, solid: &Polyhedron, face: usize) -> bool {
        let allowed = self.flatness + FLAT_ROUNDING * self.size.max(size(solid, face));
        let height = |corner: usize| self.inward_normal.dot(solid.vertices[corner] - self.point);
        let is_reversed = self.inward_normal.dot(solid.faces[face].inward_normal()) <= 0.0;
        solid.faces[face].vertices().iter().all(|&corner| height(corner).abs() <= allowed)
            && !(is_reversed && breadth(solid, face) > NARROW * allowed)
    }
}

/// The height of a triangle over its longest edge; of other faces that of one as large.
fn breadth(solid: &Polyhedron, face: usize) -> f64 {
    let face = &solid.faces[face];
    let length = |[from, to]: [usize; 2]| (solid.vertices[to] - solid.vertices[from]).norm();
    2.0 * face.area() / face.edges().map(length).fold(0.0, f64::max)
}

/// The largest magnitude of a coordinate of a face.
fn size(solid: &Polyhedron, face: usize) -> f64 {
    let corners = solid.faces[face].vertices().iter();
    corners.fold(0.0_f64, |m, &corner| m.max(solid.vertices[corner].max_abs()))
}

/// The facet of these faces; the edges of its border in any order, as the faces run.
fn facet(solid: &Polyhedron, faces: Vec<usize>, border: Vec<[usize; 2]>) -> Facet {
    let area = faces.iter().map(|&face| solid.faces[face].area()).sum();
    let inward_normal = mean_normal(solid, &faces, area);
    let triangles = faces.iter().flat_map(|&face| triangles(solid, face)).collect();
    let mut loops = loops(border);
    if loops.len() > 1 {
        let turning = |chain: &[usize]| -inward_normal.dot(area_vector(&solid.vertices, chain));
        loops.sort_by(|one, other| {
            let (large, small) = (turning(one), turning(other));
            // The outer one, then holes from the largest.
            let is_hole = (large < 0.0).cmp(&(small < 0.0));
            is_hole.then(small.abs().total_cmp(&large.abs())).then(one[0].cmp(&other[0]))
        });
    }
    Facet { faces, inward_normal, area, triangles, loops }
}

fn mean_normal(solid: &Polyhedron, faces: &[usize], area: f64) -> Vector<3> {
    let first = solid.faces[faces[0]].inward_normal();
    if faces.iter().all(|&face| solid.faces[face].inward_normal() == first) {
        return first;
    }
    let share = |&face: &usize| {
        let face = &solid.faces[face];
        face.inward_normal() * (face.area() / area)
    };
    let sum = faces.iter().map(share).fold(Vector::ZERO, |sum, part| sum + part);
    // Both sides of what is smaller than the flatness cancel.
    sum.direction().unwrap_or(first)
}

/// The triangles of a face, without those that rounding has made of straight stretches.
fn triangles(solid: &Polyhedron, face: usize) -> Vec<[Vector<3>; 3]> {
    let all = solid.faces[face].triangles(&solid.vertices);
    let mut corners: Vec<_> = all.iter().map(|t| t.map(|corner| solid.vertices[corner])).collect();
    if corners.len() > 1 {
        let allowed = FLAT_ROUNDING * size(solid, face);
        let is_wide = |triangle: &[Vector<3>; 3]| width(triangle) > allowed;
        // Of a face that is hardly wider itself, all are kept.
        if corners.iter().any(is_wide) {
            corners.retain(is_wide);
        }
    }
    corners
}

/// The least height of a triangle.
fn width([a, b, c]: &[Vector<3>; 3]) -> f64 {
    let (p, q, r) = (*b - *a, *c - *b, *a - *c);
    // Across the longest side, from the two shorter ones, with least cancellation.
    let [mut along, mut one, mut other] = [p, q, r];
    if q.norm_squared() > along.norm_squared() {
        [along, one, other] = [q, r, p];
    }
    if r.norm_squared() > along.norm_squared() {
        [along, one, other] = [r, p, q];
    }
    spatial::cross(one, other).norm() / along.norm()
}

/// The closed chains of edges that begin where others end, none with a vertex twice.
fn loops(mut edges: Vec<[usize; 2]>) -> Vec<Vec<usize>> {
    edges.sort_unstable();
    // A vertex is known by the first edge that begins there.
    let place = |vertex: usize| edges.partition_point(|edge| edge[0] < vertex);
    let mut next: Vec<usize> = (0..edges.len()).collect();
    let mut depth = vec![usize::MAX; edges.len()];
    let mut loops = Vec::new();
    for start in 0..edges.len() {
        let begin = place(edges[start][0]);
        if next[begin] > start {
            continue;
        }
        let (mut path, mut at) = (Vec::new(), begin);
        loop {
            depth[at] = path.len();
            path.push(at);
            let edge = next[at];
            next[at] += 1;
            at = place(edges[edge][1]);
            if depth[at] == usize::MAX {
                continue;
            }
            let chain = path.split_off(depth[at]);
            for &passed in &chain {
                depth[passed] = usize::MAX;
            }
            loops.push(from_lowest(chain.iter().map(|&passed| edges[passed][0]).collect()));
            if path.is_empty() {
                break;
            }
        }
    }
    loops
}

fn from_lowest(mut chain: Vec<usize>) -> Vec<usize> {
    let lowest = (0..chain.len()).min_by_key(|&i| chain[i]).unwrap_or(0);
    chain.rotate_left(lowest);
    chain
}

/// Twice the area of a closed chain, as a vector around which it runs counter-clockwise.
fn area_vector(vertices: &[Vector<3>], chain: &[usize]) -> Vector<3> {
    let from = |corner: usize| vertices[corner] - vertices[chain[0]];
    let pairs = chain.windows(2).map(|pair| spatial::cross(from(pair[0]), from(pair[1])));
    pairs.fold(Vector::ZERO, |sum, part| sum + part)
}
