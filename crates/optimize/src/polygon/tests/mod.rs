//! The search against plain enumeration, and its bounds against the placements under them.

mod bounds;
mod cuts;
mod search;
mod tips;

use std::f64::consts::TAU;

use clench_shape::Polygon;
use clench_testkit::Random;

use super::bound::Pieces;
use super::springs::Springs;
use super::{Fingers, Part, Stretch};
use crate::Objective;
use crate::search::{Floor, Leaders, Piece};

/// Outlines of `n` edges, more or less: some families have their own number.
fn outline(r: &mut Random, n: usize) -> Vec<[f64; 2]> {
    let turned = |corners: &[[f64; 2]], angle: f64| -> Vec<[f64; 2]> {
        let (s, c) = angle.sin_cos();
        corners.iter().map(|[x, y]| [c * x - s * y, s * x + c * y]).collect()
    };
    let angle = [0.0, r.between(0.0, TAU)][r.below(2)];
    let (w, h) = (r.between(1.0, 4.0), r.between(1.0, 4.0));
    match r.below(8) {
        0 | 1 => r.convex(n),
        2 | 3 => r.star(n),
        4 => turned(&[[0.0, 0.0], [w, 0.0], [w, h], [0.0, h]], angle),
        5 => {
            let (x, y) = (r.between(0.2, 0.8) * w, r.between(0.2, 0.8) * h);
            turned(&[[0.0, 0.0], [w, 0.0], [w, y], [x, y], [x, h], [0.0, h]], angle)
        }
        6 => {
            let near = [0.0, 1e-3][r.below(2)];
            let corner = |i: usize| {
                let (t, radius) = (angle + TAU * i as f64 / n as f64, 1.0 + r.between(0.0, near));
                [radius * t.cos(), radius * t.sin()]
            };
            (0..n).map(corner).collect()
        }
        // With parallel edges, and corners within straight sides.
        _ => {
            let teeth = n.div_ceil(8).max(1);
            let tooth = |i: usize| {
                let x = 4.0 * i as f64;
                [[x, 2.0], [x + 1.0, 2.0], [x + 1.0, 3.0], [x + 3.0, 3.0], [x + 3.0, 2.0]]
            };
            let end = 4.0 * teeth as f64;
            let top = (0..teeth).flat_map(tooth).chain([[end, 2.0], [end, 0.0], [1.0, 0.0]]);
            let corners: Vec<_> = [[0.0, 0.0]].into_iter().chain(top).collect();
            turned(&corners, angle)
        }
    }
}

fn part(r: &mut Random, n: usize) -> Part {
    let corners = outline(r, n);
    let stiffness = match r.below(3) {
        0 => vec![1.0; corners.len()],
        1 => corners.iter().map(|_| r.between(0.5, 2.0)).collect(),
        _ => corners.iter().map(|_| 10.0_f64.powf(r.between(-1.0, 1.0))).collect(),
    };
    Part::new(Polygon::new(&corners).unwrap(), stiffness).unwrap()
}

/// Some stretches taken away.
fn restricted(r: &mut Random, part: Part) -> Part {
    let edge = r.below(part.outline().edges().len());
    let length = part.outline().edges()[edge].length();
    let from = r.between(0.1, 0.5) * length;
    let middle = Stretch { edge, from, to: from + 0.2 * length };
    part.without(middle).unwrap()
}

/// Conditions and objectives that a combination of four is solved under.
fn question(r: &mut Random) -> Fingers {
    let mut question = Fingers::new(4);
    if r.below(3) == 0 {
        question.least_share = r.between(0.0, 0.2);
    }
    if r.below(3) == 0 {
        question.clearance = r.between(0.0, 1.5);
        question.finger_radius = [0.0, r.between(0.0, 0.5)][r.below(2)];
    }
    if r.below(3) == 0 {
        let least_translation = r.between(0.0, 2.0);
        question.objective = Objective::Rotation { least_translation };
    }
    question
}

/// Calls `visit` for all ascending sets of `K` of `n` numbers, repetition allowed.
fn each_set<const K: usize>(n: usize, mut visit: impl FnMut([usize; K])) {
    let mut set = [0; K];
    loop {
        visit(set);
        let Some(last) = (0..K).rfind(|&i| set[i] + 1 < n) else { return };
        let next = set[last] + 1;
        set[last..].fill(next);
    }
}

/// The best over all combinations, by solving each; but for those whose best fingers are too near
/// to each other.
fn enumerated(springs: Springs<'_>, stretches: usize) -> Option<(f64, f64)> {
    let mut leaders = Leaders::new(1);
    each_set::<4>(stretches, |set| {
        let found = springs.solve(set, &Floor::NONE);
        leaders.merge(found.filter(|found| !springs.is_crowded(found)));
    });
    leaders.candidates().first().map(|best| (best.quality, best.second))
}

/// A node somewhere in the tree, its pieces ascending; with stretches whole or divided.
fn node<const K: usize>(r: &mut Random, tree: &Pieces<3>, divided: bool) -> [Piece; K] {
    let mut pieces = [Piece::BOUNDARY; K];
    for piece in &mut pieces {
        for _ in 0..r.below(7) {
            if divided || tree.stretches(*piece).len() > 1 {
                *piece = tree.halves(*piece).unwrap()[r.below(2)];
            }
        }
    }
    pieces.sort_unstable();
    pieces
}
