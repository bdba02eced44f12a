//! Where on an outline a point is.

use clench_screw::{Vector, planar};

use crate::Edge;
use crate::loops::Loops;

/// A place on an outline is called a corner within this many roundings of its coordinates: two
/// for the point's own rounding in a file and at its source, two for the corner's.
const CORNER_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The place of an outline nearest to some point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The number of the edge; at a corner, of the edge that starts there.
    pub edge: usize,
    /// The distance from the edge's start (length); 0 at a corner.
    pub along: f64,
    /// The distance between the point and the outline (length).
    pub distance: f64,
    /// The corner, where the place is one to the rounding of its coordinates.
    ///
    /// A finger there touches two edges, so that it has no normal.
    pub corner: Option<usize>,
}

/// The place nearest to `point`: each edge's foot point is kept within the edge.
pub(crate) fn nearest_place(edges: &[Edge], loops: &Loops, point: Vector<2>) -> Place {
    let mut nearest = Place { edge: 0, along: 0.0, distance: f64::INFINITY, corner: None };
    for (edge, candidate) in edges.iter().enumerate() {
        let (along, distance) = foot(candidate, point);
        if distance < nearest.distance {
            nearest = Place { edge, along, distance, corner: None };
        }
    }
    at_corner(edges, loops, nearest)
}

/// How far along the edge its point nearest to `point` is, and how far `point` is from that.
fn foot(edge: &Edge, point: Vector<2>) -> (f64, f64) {
    let along = (point - edge.start()).dot(edge.direction());
    if along <= 0.0 {
        (0.0, (point - edge.start()).norm())
    } else if along >= edge.length() {
        (edge.length(), (point - edge.end()).norm())
    } else {
        // From the nearer end: the error of the cross product grows with the distance to it.
        let near_start = along < edge.length() - along;
        let offset = point - if near_start { edge.start() } else { edge.end() };
        (along, planar::cross(edge.direction(), offset).abs())
    }
}

/// The same place, named by its corner if it is one.
fn at_corner(edges: &[Edge], loops: &Loops, place: Place) -> Place {
    let edge = &edges[place.edge];
    let scale = edge.start().max_abs().max(edge.end().max_abs());
    let rounding = CORNER_ROUNDING * scale;
    let corner = if place.along <= rounding {
        place.edge
    } else if edge.length() - place.along <= rounding {
        loops.after(place.edge)
    } else {
        return place;
    };
    Place { edge: corner, along: 0.0, corner: Some(corner), ..place }
}
