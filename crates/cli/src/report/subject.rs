//! What fingers are placed on, in words.

use clench::optimize::polygon;
use clench::screw::Vector;
use clench::shape::{FaceFeature, Polygon, Polyhedron};

use super::analysis::NO_SHARE;
use super::number::counted as counted_number;
use crate::wording::counted;

/// Faces whose unit normals differ by less, 20 degrees, are one smooth surface to a finger on the
/// edge between them: pictures do not draw it either.
const SMOOTH: f64 = 0.347_296_355_333_860_7;

/// See [`Subject::no_share`].
const NEARLY_NO_SHARE: f64 = 1e-4;

/// What fingers are placed on.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Subject<'a> {
    Outline(&'a polygon::Part),
    Solid(SolidSubject<'a>),
}

/// A solid, and where on it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SolidSubject<'a> {
    pub(crate) solid: &'a Polyhedron,
    /// How many facets, or candidates.
    pub(crate) places: usize,
    /// Whether candidates are chosen.
    pub(crate) chosen: bool,
    /// How many contacts are given.
    pub(crate) fixed: usize,
}

impl Subject<'_> {
    /// The size of the part: a radius.
    pub(super) fn size(&self) -> f64 {
        match self {
            Self::Outline(part) => part.outline().enclosing_circle().radius,
            Self::Solid(part) => part.solid.enclosing_radius(),
        }
    }

    /// How large its description is.
    pub(super) fn described(&self) -> String {
        match self {
            Self::Outline(part) => counted(part.outline().corners().len(), "corner"),
            Self::Solid(SolidSubject { solid, places, chosen, .. }) => {
                let faces = counted(solid.faces().len(), "face");
                let places = match (*places, chosen) {
                    (places, true) => counted(places, "candidate"),
                    (1, false) => "1 plane".to_owned(),
                    (places, false) => format!("{places} planes"),
                };
                let joint = if *chosen { ", " } else { " in " };
                format!("{} vertices, {faces}{joint}{places}", solid.vertices().len())
            }
        }
    }

    /// What a corner is called.
    pub(super) const fn corner(&self) -> &'static str {
        match self {
            Self::Outline(_) => "corner",
            Self::Solid(_) => "vertex",
        }
    }

    /// What fingers are placed on, one and many of it.
    pub(super) const fn places(&self) -> [&'static str; 2] {
        match self {
            Self::Outline(_) => ["edge", "edges"],
            Self::Solid(SolidSubject { chosen: true, .. }) => ["candidate", "candidates"],
            Self::Solid(_) => ["face", "faces"],
        }
    }

    /// What combinations consist of.
    pub(super) const fn combined(&self) -> &'static str {
        match self {
            Self::Solid(SolidSubject { chosen: false, .. }) => "planes",
            _ => self.places()[1],
        }
    }

    /// Where else fingers could be.
    pub(super) const fn elsewhere(&self) -> &'static str {
        match self {
            Self::Outline(_) => "on this outline",
            Self::Solid(SolidSubject { chosen: true, .. }) => "on these candidates",
            Self::Solid(_) => "on this solid",
        }
    }

    /// How many contacts were given.
    pub(super) const fn fixed(&self) -> usize {
        match self {
            Self::Outline(_) => 0,
            Self::Solid(part) => part.fixed,
        }
    }

    /// A share of the preload that means that a finger barely presses. The closed forms on outlines
    /// reach a limit, the search on solids comes near it.
    pub(super) const fn no_share(&self) -> f64 {
        match self {
            Self::Outline(_) => NO_SHARE,
            Self::Solid(_) => NEARLY_NO_SHARE,
        }
    }

    /// The corner or edge at which a finger at `point` is, where no real one can be.
    pub(super) fn limit_at(&self, point: &[f64]) -> Option<String> {
        match self {
            Self::Outline(part) => {
                let place = part.outline().place(Vector::from_fn(|i| point[i]));
                let bends = |corner: &usize| bends(part.outline(), *corner);
                place.corner.filter(bends).map(|corner| format!("corner {corner}"))
            }
            Self::Solid(SolidSubject { chosen: true, .. }) => None,
            Self::Solid(part) => part.limit_at(Vector::from_fn(|i| point[i])),
        }
    }
}

impl SolidSubject<'_> {
    fn limit_at(&self, point: Vector<3>) -> Option<String> {
        let normal = |face: usize| self.solid.faces()[face].inward_normal();
        let bends = |faces: &[usize]| {
            faces.iter().any(|&face| (normal(face) - normal(faces[0])).norm() > SMOOTH)
        };
        match self.solid.place(point).on {
            FaceFeature::Vertex { vertex, faces } if bends(&faces) => {
                Some(format!("vertex {vertex}"))
            }
            FaceFeature::Edge { faces: [one, other], .. } if bends(&[one, other]) => {
                Some(format!("the edge of faces {one} and {other}"))
            }
            _ => None,
        }
    }
}

/// Whether an outline turns by more at a corner than on a smooth curve.
fn bends(outline: &Polygon, corner: usize) -> bool {
    let edges = outline.edges();
    let of_corner = outline.loops().iter().find(|corners| corners.contains(&corner));
    let before = match of_corner {
        Some(corners) if corner == corners.start => corners.end - 1,
        _ => corner.saturating_sub(1),
    };
    (edges[before].inward_normal() - edges[corner].inward_normal()).norm() > SMOOTH
}

/// What is to be said of a solid in several pieces.
pub(crate) fn in_pieces(pieces: usize) -> Option<String> {
    let joined = "pieces that no face joins: they are taken as one rigid part";
    (pieces > 1).then(|| format!("the solid is in {pieces} {joined}"))
}

/// How many fingers, in words.
pub(super) fn in_words(count: usize) -> String {
    let words = [
        "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven",
        "twelve",
    ];
    let word = count.checked_sub(1).and_then(|i| words.get(i));
    word.map_or_else(|| counted_number(count as f64), |word| (*word).to_owned())
}
