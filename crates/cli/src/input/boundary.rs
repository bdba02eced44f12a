//! Boundaries of parts, as contacts need them: where a finger may sit, and what is nearest.

use std::fmt;

use clench::contact::Curvature;
use clench::screw::Vector;
use clench::shape::{Edge, Ellipsoid, FaceFeature, Polygon, Polyhedron};

use super::solid::Solid;

/// What the boundary of a part consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PieceKind {
    Edge,
    Face,
}

/// One edge or face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Piece {
    pub(crate) kind: PieceKind,
    pub(crate) number: usize,
}

/// A place of the boundary where a finger may press.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seat<const N: usize> {
    /// The edge or face; none of a smooth part.
    pub(super) piece: Option<Piece>,
    pub(super) point: Vector<N>,
    pub(super) inward_normal: Vector<N>,
    pub(super) curvature: Curvature<N>,
}

/// The place of the boundary nearest to some point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot<const N: usize> {
    pub(super) point: Vector<N>,
    /// Negative inside the part.
    pub(super) signed_distance: f64,
    pub(super) piece: Option<Piece>,
}

/// The boundary of a part.
pub(super) trait Boundary<const N: usize> {
    /// The radius of the part, which says how exact a drawing is.
    fn radius(&self) -> f64;

    /// What it consists of, and of how many; none if it is smooth.
    fn pieces(&self) -> Option<(PieceKind, usize)>;

    /// The place nearest to `point`.
    fn foot(&self, point: Vector<N>) -> Foot<N>;

    /// The part, if it is smooth.
    fn smooth(&self) -> Option<Ellipsoid<N>> {
        None
    }

    /// All places that `point` may stand for, to the distance `within`: several at a corner.
    fn seats(&self, point: Vector<N>, within: f64) -> Vec<Seat<N>>;
}

impl Boundary<2> for Polygon {
    fn radius(&self) -> f64 {
        self.enclosing_circle().radius
    }

    fn pieces(&self) -> Option<(PieceKind, usize)> {
        Some((PieceKind::Edge, self.edges().len()))
    }

    fn foot(&self, point: Vector<2>) -> Foot<2> {
        let (place, signed_distance) = (self.place(point), self.signed_distance(point));
        let foot = self.edges()[place.edge].point_at(place.along);
        Foot { point: foot, signed_distance, piece: Some(edge(place.edge)) }
    }

    fn seats(&self, point: Vector<2>, within: f64) -> Vec<Seat<2>> {
        let near = |edge: &Edge| {
            (nearest_between([edge.start(), edge.end()], point) - point).norm() <= within
        };
        let edges = self.edges().iter().enumerate().filter(|(_, edge)| near(edge));
        edges.map(|(i, side)| flat_seat(edge(i), point, side.inward_normal())).collect()
    }
}

impl Boundary<3> for Solid {
    fn radius(&self) -> f64 {
        self.polyhedron.enclosing_radius()
    }

    fn pieces(&self) -> Option<(PieceKind, usize)> {
        Some((PieceKind::Face, self.polyhedron.faces().len()))
    }

    fn foot(&self, point: Vector<3>) -> Foot<3> {
        let place = self.polyhedron.place(point);
        let signed_distance = self.polyhedron.signed_distance(point);
        Foot { point: place.foot, signed_distance, piece: Some(face(place.face)) }
    }

    fn seats(&self, point: Vector<3>, within: f64) -> Vec<Seat<3>> {
        let place = self.polyhedron.place(point);
        if place.distance > within {
            return Vec::new();
        }
        let faces = match vertex_or_edge_near(&self.polyhedron, place.face, point, within) {
            Some(near) => faces_at(&self.polyhedron.place(near).on, place.face),
            None => vec![place.face],
        };
        let seat = |i: usize| flat_seat(face(i), point, self.inward_normals[i]);
        faces.into_iter().map(seat).collect()
    }
}

impl<const N: usize> Boundary<N> for Ellipsoid<N> {
    fn radius(&self) -> f64 {
        self.radius()
    }

    fn pieces(&self) -> Option<(PieceKind, usize)> {
        None
    }

    fn smooth(&self) -> Option<Ellipsoid<N>> {
        Some(*self)
    }

    fn foot(&self, point: Vector<N>) -> Foot<N> {
        let nearest = self.nearest(point);
        let signed_distance = nearest.signed_distance;
        Foot { point: nearest.boundary.point, signed_distance, piece: None }
    }

    fn seats(&self, point: Vector<N>, within: f64) -> Vec<Seat<N>> {
        let nearest = self.nearest(point);
        if nearest.signed_distance.abs() > within {
            return Vec::new();
        }
        let boundary = nearest.boundary;
        vec![Seat {
            piece: None,
            point: boundary.point,
            inward_normal: boundary.inward_normal,
            curvature: Curvature::of_shape_operator(boundary.shape_operator),
        }]
    }
}

const fn edge(number: usize) -> Piece {
    Piece { kind: PieceKind::Edge, number }
}

const fn face(number: usize) -> Piece {
    Piece { kind: PieceKind::Face, number }
}

fn flat_seat<const N: usize>(piece: Piece, point: Vector<N>, normal: Vector<N>) -> Seat<N> {
    Seat { piece: Some(piece), point, inward_normal: normal, curvature: Curvature::FLAT }
}

/// The vertex of a face, or else the point of one of its edges, that is this near to `point`.
fn vertex_or_edge_near(
    solid: &Polyhedron,
    face: usize,
    point: Vector<3>,
    within: f64,
) -> Option<Vector<3>> {
    let vertices = solid.faces()[face].vertices();
    let near = |place: &Vector<3>| (*place - point).norm() <= within;
    let mut places = vertices.iter().map(|&vertex| solid.vertices()[vertex]);
    let edge = |i: usize| {
        let ends = [vertices[i], vertices[(i + 1) % vertices.len()]];
        nearest_between(ends.map(|vertex| solid.vertices()[vertex]), point)
    };
    places.find(near).or_else(|| (0..vertices.len()).map(edge).find(near))
}

/// The faces that meet at a place of `face`.
fn faces_at(on: &FaceFeature, face: usize) -> Vec<usize> {
    match on {
        FaceFeature::Interior => vec![face],
        FaceFeature::Edge { faces, .. } => faces.to_vec(),
        FaceFeature::Vertex { faces, .. } => faces.clone(),
    }
}

/// The point between two ends that is nearest to `point`.
fn nearest_between<const N: usize>(ends: [Vector<N>; 2], point: Vector<N>) -> Vector<N> {
    let [start, end] = ends;
    let side = end - start;
    let length = side.norm();
    let direction = side * length.recip();
    start + direction * (point - start).dot(direction).clamp(0.0, length)
}

impl PieceKind {
    /// The field of a contact that says which it is on.
    pub(crate) const fn field(self) -> &'static str {
        match self {
            Self::Edge => "edge",
            Self::Face => "face",
        }
    }
}

impl fmt::Display for Piece {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{} {}", self.kind, self.number)
    }
}

impl fmt::Display for PieceKind {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.field())
    }
}
