//! The bounds against placements under them, and the search among candidates against enumeration.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on fails"
)]

mod ascents;
mod bounds;
mod cuts;
mod enumeration;
mod tips;

use clench_screw::spatial::cross;
use clench_shape::Polyhedron;
use clench_testkit::{Random, solids};

use super::ascent::Ascent;
use super::bound::Pieces;
use super::rating::{Rating, Spot, Worth};
use super::scene::{Patch, Scene};
use super::{Fingers, Part, Touch};
use crate::Objective;
use crate::search::Piece;

/// The objectives; the last one with a condition that some placements miss.
pub(super) const OBJECTIVES: [Objective; 4] = [
    Objective::WorstPoint,
    Objective::Quality,
    Objective::Rotation { least_translation: 0.0 },
    Objective::Rotation { least_translation: 1.0 },
];

/// Bodies of all kinds: regular, skew, hollow, with unlike stiffnesses.
pub(super) fn part(r: &mut Random, kind: usize) -> Part {
    let (vertices, faces) = match kind {
        0 => solids::cuboid([1.0, 1.0, 1.0]),
        1 => solids::tetrahedron(),
        2 => solids::wedge(),
        3 => solids::angle(),
        4 => solids::bracket(),
        _ => solids::between_planes(r, 12),
    };
    let solid = Polyhedron::new(&vertices, &faces).unwrap();
    if kind == 3 {
        let stiffness = (0..faces.len()).map(|_| r.between(0.3, 3.0)).collect();
        Part::new(solid, stiffness, 0.0).unwrap()
    } else {
        Part::uniform(solid, 1.0, 1e-9).unwrap()
    }
}

/// A contact on the part by chance.
pub(super) fn touch(r: &mut Random, part: &Part) -> Touch {
    let facet = &part.facets()[r.below(part.facets().len())];
    let triangle = facet.triangles()[r.below(facet.triangles().len())];
    let (mut u, mut v) = (r.between(0.0, 1.0), r.between(0.0, 1.0));
    if u + v > 1.0 {
        (u, v) = (1.0 - u, 1.0 - v);
    }
    let [a, b, c] = triangle;
    let point = a + (b - a) * u + (c - a) * v;
    Touch { point, inward_normal: facet.inward_normal(), stiffness: r.between(0.5, 2.0) }
}

/// A placement that holds, by a short ascent.
pub(super) fn held<const K: usize>(rating: Rating<'_>, seed: u64) -> Option<(Worth, [Spot; K])> {
    Ascent::new(rating, seed).by_chance()
}

/// Whether a spot is on a triangle of its patch, to rounding.
pub(super) fn is_on(patch: &Patch, triangle: &[clench_screw::Vector<3>; 3], spot: &Spot) -> bool {
    let [a, b, c] = *triangle;
    // The distances from the edges' lines, with a sign.
    let turn = |p: clench_screw::Vector<3>, q: clench_screw::Vector<3>| {
        cross(q - p, spot.point - p).dot(patch.normal) / (q - p).norm()
    };
    let turns = [turn(a, b), turn(b, c), turn(c, a)];
    turns.iter().all(|t| *t <= 4e-15) || turns.iter().all(|t| *t >= -4e-15)
}

/// A piece that a spot is on, at most so deep in the tree.
pub(super) fn piece_of(pieces: &Pieces<'_>, spot: &Spot, depth: usize) -> Piece {
    let mut piece = Piece::BOUNDARY;
    for _ in 0..depth {
        let Some(halves) = pieces.halves(piece) else { break };
        let Some(half) = halves.into_iter().find(|&half| pieces.holds(half, spot)) else { break };
        piece = half;
    }
    piece
}

/// The scene's rating, for a test that needs nothing else.
pub(super) fn rating<'a>(scene: &'a Scene<'a>, fingers: &'a Fingers) -> Rating<'a> {
    Rating { scene, fingers }
}
