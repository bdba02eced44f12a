//! The last steps of an ascent, by linear programs.
//!
//! Near a placement the objective is the least of smooth functions of the contact points: one for
//! each point of the body and direction that give way about as much as the worst. A step maximizes
//! the least of their linear models, with the fingers on their faces, near where they are, and all
//! contacts pushing.

use clench_metrics::Principal;
use clench_screw::spatial::cross;
use clench_screw::{SymmetricEigen, Vector, Wrench};
use microlp::{ComparisonOp, OptimizationDirection, Problem, Variable};

use super::ascent::Climber;
use super::bound::Cut;
use super::rating::{Rating, Spot};
use super::scene::across;
use super::vectors::joined;
use crate::Objective;

/// Directions that give way by this part of the worst count.
const NEAR: f64 = 0.7;

/// So many of them at most.
const MOST_CUTS: usize = 48;

/// Where steps begin and end, beside the part's radius, and what they are multiplied by where they
/// gain and where they do not.
const FIRST_STEP: f64 = 0.1;
const LAST_STEP: f64 = 1e-8;
const LONGER: f64 = 2.0;
const SHORTER: f64 = 0.35;

/// A coefficient of the balance below this is rounding of a unit wrench.
const NOISE: f64 = f64::EPSILON;

/// Steps at most.
const STEPS: usize = 60;

/// The best placement that steps by linear programs arrive at; the same where the objective is no
/// least of smooth functions.
pub(super) fn climbed<const K: usize>(rating: Rating<'_>, start: Climber<K>) -> Climber<K> {
    let mut best = start;
    let mut step = FIRST_STEP;
    for _ in 0..STEPS {
        if step < LAST_STEP {
            break;
        }
        let Some(spots) = stepped(rating, &best.1, step) else {
            step *= SHORTER;
            continue;
        };
        if let Some(worth) = rating.above(&spots, best.0) {
            best = (worth, spots);
            step *= LONGER;
        } else {
            step *= SHORTER;
        }
    }
    best
}

/// The placement that the linear models within `step` promise most of.
fn stepped<const K: usize>(rating: Rating<'_>, spots: &[Spot; K], step: f64) -> Option<[Spot; K]> {
    let scene = rating.scene;
    let patches = spots.map(|spot| &scene.patches[spot.patch]);
    let principal = rating.principal(spots)?;
    let cuts = cuts(rating, &principal);
    let shares = rating.shares(spots);
    let mut program = Problem::new(OptimizationDirection::Maximize);
    let objective = program.add_var(1.0, (f64::NEG_INFINITY, f64::INFINITY));
    let axes = patches.map(|patch| across(patch.normal));
    let moves: [[Variable; 2]; K] = patches.map(|patch| {
        let reach = if patch.is_point() { 0.0 } else { step };
        [(); 2].map(|()| program.add_var(0.0, (-reach, reach)))
    });
    for (cut, q) in &cuts {
        let mut row = vec![(objective, 1.0)];
        for i in 0..K {
            let slope = cut.form * patches[i].wrench(spots[i].point) * 2.0;
            for (variable, axis) in moves[i].iter().zip(axes[i]) {
                let turned =
                    joined(Vector::ZERO, cross(axis, patches[i].normal)) * patches[i].weight;
                row.push((*variable, -slope.dot(turned)));
            }
        }
        program.add_constraint(row.as_slice(), ComparisonOp::Le, *q);
    }
    for i in 0..K {
        for (normal, room) in patches[i].borders(spots[i].point) {
            let row = [0, 1].map(|j| (moves[i][j], normal.dot(axes[i][j])));
            program.add_constraint(row.as_slice(), ComparisonOp::Le, room);
        }
    }
    if let Some(tips) = &scene.tips {
        let placed = spots.map(|spot| rating.tip(tips, spot));
        // Two fingers come nearer by two steps at most, each along both of its axes.
        for (pair, way, left) in tips.near(&placed, 4.0 * step) {
            let mut row = Vec::new();
            for (finger, sign) in pair.into_iter().zip([-1.0, 1.0]) {
                let Some(i) = finger else { continue };
                row.extend([0, 1].map(|j| (moves[i][j], sign * way.dot(axes[i][j]))));
            }
            program.add_constraint(row.as_slice(), ComparisonOp::Le, left.max(0.0));
        }
    }
    balance(rating, spots, (&mut program, &moves, &axes), &shares, step);
    let solution = program.solve().ok()?.into_solution().ok()?;
    let at = |i: usize| {
        let by = |j: usize| axes[i][j] * solution.var_value(moves[i][j]);
        let point = spots[i].point + by(0) + by(1);
        Spot { point: patches[i].nearest(point), ..spots[i] }
    };
    Some(std::array::from_fn(at))
}

/// That all contacts go on pushing: the shares change so that forces and torques still balance, to
/// first order, with room for what is of second order.
fn balance<const K: usize>(
    rating: Rating<'_>,
    spots: &[Spot; K],
    (program, moves, axes): (&mut Problem, &[[Variable; 2]; K], &[[Vector<3>; 2]; K]),
    shares: &[f64],
    step: f64,
) {
    let scene = rating.scene;
    let least = rating.least() + step * step;
    let changes: Vec<Variable> =
        shares.iter().map(|share| program.add_var(0.0, (least - share, f64::INFINITY))).collect();
    let wrenches = rating.unit_wrenches(spots);
    for row in 0..6 {
        let mut terms: Vec<_> =
            changes.iter().zip(&wrenches).map(|(&change, wrench)| (change, wrench[row])).collect();
        for i in 0..K {
            let normal = scene.patches[spots[i].patch].normal;
            for (variable, axis) in moves[i].iter().zip(axes[i]) {
                terms.push((*variable, shares[i] * joined(Vector::ZERO, cross(axis, normal))[row]));
            }
        }
        terms.retain(|(_, factor)| factor.abs() > NOISE);
        program.add_constraint(terms.as_slice(), ComparisonOp::Eq, 0.0);
    }
    let total: Vec<_> = changes.iter().map(|&change| (change, 1.0)).collect();
    program.add_constraint(total.as_slice(), ComparisonOp::Eq, 0.0);
}

/// The functions that the objective is the least of, those near it, with their values.
fn cuts(rating: Rating<'_>, principal: &Principal<3, 3>) -> Vec<(Cut, f64)> {
    let rotation = match rating.fingers.objective {
        Objective::WorstPoint => false,
        Objective::Rotation { .. } => true,
        Objective::Quality => return Vec::new(),
    };
    let by_translation = principal.translational_compliance();
    let mut found: Vec<(f64, Vector<3>, Vector<3>)> = Vec::new();
    for &x in rating.scene.coarse.points() {
        let mut compliance = principal.compliance_at(x);
        if rotation {
            compliance = compliance - *by_translation;
        }
        let Ok(eigen) = SymmetricEigen::beside_largest(&compliance) else { continue };
        found.extend((0..3).map(|i| (eigen.values[i], eigen.vectors[i], x)));
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    let worst = found.first().map_or(0.0, |first| first.0);
    found.truncate(MOST_CUTS);
    found.retain(|(compliance, ..)| *compliance >= NEAR * worst);
    let translational = principal.translational().map(|sigma| sigma);
    let cut = |(compliance, direction, x): (f64, Vector<3>, Vector<3>)| {
        let q = compliance.recip();
        if !rotation {
            return Some((Cut::worst_point(principal, x, direction), q));
        }
        let load = Wrench::of_force_at(direction, x);
        let turned = principal.displacement(Vector::ZERO, &load).angular;
        Some((Cut::rotation(principal, &translational, (turned, x), q)?, q))
    };
    found.into_iter().filter_map(cut).collect()
}
