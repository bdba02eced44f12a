//! Solids bounded by flat faces.

mod accessible;
mod convexity;
mod crossing;
mod ears;
mod error;
mod face;
mod facet;
mod place;
mod shells;
mod surface;
mod validity;

use std::collections::HashMap;

use clench_screw::Vector;

pub use accessible::{
    ACCESS_TOLERANCE, AccessibleFacet, BallTip, KeepOut, MOST_HOLES, Obstruction,
};
pub use error::PolyhedronError;
pub use face::Face;
pub use facet::Facet;
pub use place::{FaceFeature, FacePlace};

use crate::ExtremePoints;
use crate::deepest::Surface;
use shells::Shells;
use surface::{FaceTree, Feature};
use validity::SolidEdge;

/// The largest magnitude of a vertex's coordinate (length).
///
/// Volumes are products of three differences of coordinates, at most 8e300, which is below the
/// largest double, 1.8e308, with room for a sum of millions.
pub const LARGEST_SOLID_COORDINATE: f64 = 1e100;

/// The smallest magnitude of a vertex's coordinate that is not zero (length).
///
/// A volume of this size cubed is 1e-300: a normal double, with all digits.
pub const SMALLEST_SOLID_COORDINATE: f64 = 1e-100;

/// A solid enclosed by flat faces: convex or not, with holes or not.
///
/// Vertices and faces keep the numbers they were given in, from 0. A face has any number of
/// corners and may be hollow, but has no holes; the triangles of a mesh are faces too. Faces joined
/// by edges are a shell. Each cavity has a shell of its own, with its faces seen from the cavity,
/// and so has each piece of a solid in several.
///
/// A surface that exists is closed, does not pass through itself, and all of its shells are wound
/// for the material to be on one side. It may touch itself: at vertices, along edges, face to face.
/// One that passes through itself along edges of both alone is not noticed.
///
/// ```
/// use clench_shape::Polyhedron;
/// // The corner of a cube: three right angles at the origin.
/// let vertices = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]];
/// let faces = [vec![0, 2, 1], vec![0, 1, 3], vec![0, 3, 2], vec![1, 2, 3]];
/// let solid = Polyhedron::new(&vertices, &faces)?;
/// assert!((solid.volume() - 2.0).abs() < 1e-15);
/// assert_eq!(solid.faces()[0].inward_normal().to_array(), [0.0, 0.0, 1.0]);
/// assert_eq!(solid.signed_distance([0.25, 0.25, -1.0].into()), 1.0);
/// # Ok::<(), clench_shape::PolyhedronError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Polyhedron {
    vertices: Vec<Vector<3>>,
    used: Vec<usize>,
    faces: Vec<Face>,
    edges: Vec<SolidEdge>,
    vertex_normals: Vec<Vector<3>>,
    box_center: Vector<3>,
    enclosing_radius: f64,
    is_convex: bool,
    volume: f64,
    pieces: usize,
    extremes: ExtremePoints<3>,
    tree: FaceTree,
}

/// A solid is the same if its vertices and faces are.
impl PartialEq for Polyhedron {
    fn eq(&self, other: &Self) -> bool {
        self.vertices == other.vertices && self.faces == other.faces
    }
}

impl Polyhedron {
    /// The solid with these vertices (length) and these faces, lists of vertices from 0 that run
    /// counter-clockwise seen from where no material is: from outside, or from a cavity.
    ///
    /// A shell inside an even number of others is taken for the outside of a piece and has to
    /// enclose a positive volume, one inside an odd number for a cavity. Of shells that touch at
    /// all vertices, only the volume of all together has to be positive. Vertices that no face uses
    /// are fine.
    ///
    /// Faces pass through each other if points inside of one are on both sides of the other, where
    /// that is, too. It is decided exactly; then what the rounding of coordinates can explain is
    /// let pass: a depth of 7e-15 of the largest coordinate, or 5e-7 if all are numbers of single
    /// precision, as in STL files, each over the sine between the faces.
    ///
    /// Cost: O(n log n) for faces with `n` corners together, if few of the boxes around triangles
    /// overlap: not for thousands of long strips askew to the axes. With several shells also that
    /// of a ray from a vertex of each.
    ///
    /// # Errors
    ///
    /// The first fault found, in the order of the variants of [`PolyhedronError`]; of faults of
    /// edges, the one of the edge with the lowest vertices; of shells, the outermost.
    pub fn new(vertices: &[[f64; 3]], faces: &[Vec<usize>]) -> Result<Self, PolyhedronError> {
        let vertices: Vec<Vector<3>> = vertices.iter().map(|&v| v.into()).collect();
        // First: corners that are no numbers make the vertices of a mesh miscounted.
        validity::check_coordinates(&vertices)?;
        validity::check_counts(vertices.len(), faces.len())?;
        validity::check_corners(vertices.len(), faces)?;
        let used = validity::used_vertices(&vertices, faces)?;
        let built = faces.iter().enumerate().map(|(i, corners)| Face::new(&vertices, i, corners));
        let built: Vec<Face> = built.collect::<Result<_, _>>()?;
        let (edges, faces) = (validity::joined_edges(faces)?, built);
        let largest = used.iter().fold(0.0_f64, |m, &v| m.max(vertices[v].max_abs()));
        let box_center = center_of_box(&vertices, &used);
        let first_faces = shells::first_faces(faces.len(), &edges);
        let tree = FaceTree::new(&vertices, faces.iter().map(Face::vertices), largest);
        crossing::check_crossings(&vertices, &faces, &edges, &tree)?;
        let shells =
            Shells { vertices: &vertices, faces: &faces, first_faces: &first_faces, tree: &tree };
        let (volume, pieces) = shells.checked_volume(box_center, largest)?;
        let distances = used.iter().map(|&v| (vertices[v] - box_center).norm());
        let enclosing_radius = distances.fold(0.0, f64::max);
        let is_one_piece = first_faces.iter().all(|&first| first == 0);
        let is_convex = is_one_piece && convexity::is_convex(&vertices, &faces, &edges);
        let extremes = ExtremePoints::of_hull(&vertices, &used);
        let vertex_normals = surface::vertex_normals(&vertices, &faces);
        Ok(Self {
            vertices,
            used,
            faces,
            edges,
            vertex_normals,
            box_center,
            enclosing_radius,
            is_convex,
            volume,
            pieces,
            extremes,
            tree,
        })
    }

    /// The solid enclosed by triangles that each bring their own corners, as in an STL file.
    ///
    /// Corners with equal coordinates become one vertex, numbered as they first occur; triangle
    /// `f` becomes face `f`. Corners that ought to be equal and are not leave open edges.
    ///
    /// # Errors
    ///
    /// As [`Polyhedron::new`].
    ///
    /// ```
    /// use clench_shape::Polyhedron;
    /// let [o, x, y, z] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let solid = Polyhedron::from_triangles(&[[o, y, x], [o, x, z], [o, z, y], [x, y, z]])?;
    /// assert_eq!(solid.vertices().len(), 4);
    /// assert_eq!(solid.faces()[1].vertices(), [0, 2, 3]);
    /// # Ok::<(), clench_shape::PolyhedronError>(())
    /// ```
    pub fn from_triangles(triangles: &[[[f64; 3]; 3]]) -> Result<Self, PolyhedronError> {
        let mut vertices: Vec<[f64; 3]> = Vec::new();
        let mut numbers: HashMap<[u64; 3], usize> = HashMap::new();
        let mut number = |corner: [f64; 3]| {
            // Adding zero makes the two zeros equal.
            *numbers.entry(corner.map(|x| (x + 0.0).to_bits())).or_insert_with(|| {
                vertices.push(corner);
                vertices.len() - 1
            })
        };
        let faces: Vec<Vec<usize>> =
            triangles.iter().map(|corners| corners.iter().map(|&c| number(c)).collect()).collect();
        Self::new(&vertices, &faces)
    }

    /// The vertices, in the order given, with those that no face uses.
    #[must_use]
    pub fn vertices(&self) -> &[Vector<3>] {
        &self.vertices
    }

    /// The faces, in the order given.
    #[must_use]
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// The volume (length cubed).
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.volume
    }

    /// How many pieces the solid is in, which no face joins: 1 for most, whatever its cavities.
    #[must_use]
    pub fn pieces(&self) -> usize {
        self.pieces
    }

    /// The center of the box along the axes around all vertices that faces use.
    #[must_use]
    pub fn box_center(&self) -> Vector<3> {
        self.box_center
    }

    /// The largest distance of a vertex from [`Polyhedron::box_center`] (length).
    ///
    /// The ball of this radius there holds the solid. It is not the smallest such ball, but less
    /// than 1.74 times as large.
    #[must_use]
    pub fn enclosing_radius(&self) -> f64 {
        self.enclosing_radius
    }

    /// The vertices of the convex hull, for how far the solid reaches; of equal vertices one.
    #[must_use]
    pub fn extreme_points(&self) -> &ExtremePoints<3> {
        &self.extremes
    }

    /// The place of the surface nearest to `point`, and which faces share it. `point` is finite.
    ///
    /// Of places equally near, always the same one for the same bits. Cost: O(log n) for `n`
    /// compact faces, O(n) at a vertex.
    ///
    /// ```
    /// use clench_shape::{FaceFeature, Polyhedron};
    /// let vertices = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]];
    /// let faces = [vec![0, 2, 1], vec![0, 1, 3], vec![0, 3, 2], vec![1, 2, 3]];
    /// let solid = Polyhedron::new(&vertices, &faces)?;
    /// let place = solid.place([1.0, -3.0, -4.0].into());
    /// assert_eq!((place.distance, place.foot.to_array()), (5.0, [1.0, 0.0, 0.0]));
    /// assert_eq!(place.on, FaceFeature::Edge { faces: [0, 1], vertices: [0, 1] });
    /// # Ok::<(), clench_shape::PolyhedronError>(())
    /// ```
    #[must_use]
    pub fn place(&self, point: Vector<3>) -> FacePlace {
        place::nearest_place(self, point)
    }

    /// The distance of `point` from the surface (length): positive outside, negative inside.
    ///
    /// `point` is finite. Good to a few roundings of the largest coordinate. Cost: as
    /// [`Polyhedron::place`].
    #[must_use]
    pub fn signed_distance(&self, point: Vector<3>) -> f64 {
        self.surface_at(point).signed_distance
    }

    /// Whether the solid is convex, to the rounding of its coordinates: one surface, and at each
    /// edge neither face rises above the other. Cost: O(1), found when the solid was made.
    #[must_use]
    pub fn is_convex(&self) -> bool {
        self.is_convex
    }

    /// The vertices that faces use, each at least once.
    pub(crate) fn used_vertices(&self) -> impl Iterator<Item = Vector<3>> {
        self.used.iter().map(|&vertex| self.vertices[vertex])
    }

    /// The point of the surface nearest to `point`.
    pub(crate) fn surface_at(&self, point: Vector<3>) -> Surface<3> {
        let (face, foot) = surface::nearest(self, point);
        let inward = surface::inward(self, face, foot.feature);
        if foot.feature != Feature::Face {
            return Surface::at(foot.point, point, inward);
        }
        let inside = inward.dot(point - self.faces[face].point()) > 0.0;
        let signed_distance = if inside { -foot.distance } else { foot.distance };
        Surface { foot: foot.point, signed_distance, inward_normal: inward }
    }
}

fn center_of_box(vertices: &[Vector<3>], used: &[usize]) -> Vector<3> {
    Vector::from_fn(|axis| {
        let along = used.iter().map(|&v| vertices[v][axis]);
        let (low, high) =
            along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        0.5 * (low + high)
    })
}
