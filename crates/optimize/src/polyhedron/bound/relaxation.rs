//! Upper bounds over all placements of spring fingers on some pieces of the surface.

use clench_metrics::{EquivalentStiffness, Principal, WorstPoint};
use clench_screw::Vector;

use super::cut::{Cut, Limits};
use super::least_cylinder_squared;
use super::node::{Node, Normals};
use super::pieces::Pieces;
use crate::Objective;
use crate::polyhedron::rating::{Rating, stiffness};
use crate::search::boxes::value;
use crate::search::{Bounded, Floor, Piece, above};

/// Cuts that are added where none is inherited, and where one is.
const FIRST_CUTS: usize = 16;
const NEXT_CUTS: usize = 4;

/// Where no piece raises the bound by more than this part, what counts is whether fingers are too
/// near to each other.
const SMALL_RISE: f64 = 0.02;

/// Steps of the search for the weight of a cut, and the golden section.
const SECTIONS: usize = 9;
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The bounds; see [`super::super`] for their derivation.
#[derive(Debug)]
pub(crate) struct Relaxation<'a> {
    rating: Rating<'a>,
    pieces: &'a Pieces<'a>,
    /// No cylinder around the body has a smaller radius squared.
    cylinder_squared: f64,
}

/// What a node hands on to its halves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hint {
    cut: Cut,
    normals: Option<Normals>,
}

/// A cut, and the bound of a node by it.
struct Best {
    bound: f64,
    cut: Cut,
}

impl<'a> Relaxation<'a> {
    pub(crate) fn new(rating: Rating<'a>, pieces: &'a Pieces<'a>) -> Self {
        let cylinder_squared = least_cylinder_squared(rating.scene.extremes.points());
        Self { rating, pieces, cylinder_squared }
    }

    /// The bound of a node; `None` when no placement on it exceeds `floor`.
    pub(crate) fn bound(
        &self,
        pieces: &[Piece],
        floor: &Floor,
        hint: Option<&Hint>,
    ) -> Option<Bounded<Hint>> {
        let known = hint.and_then(|hint| hint.normals);
        let node = Node::new(self.rating, self.pieces, pieces, known)?;
        let least = above(floor.quality);
        let by_translation = match self.rating.fingers.objective {
            Objective::Quality | Objective::WorstPoint => node.largest_translation(),
            Objective::Rotation { .. } => f64::INFINITY,
        };
        if by_translation <= least {
            return None;
        }
        let best = self.best(&node, floor.quality, hint.map(|hint| &hint.cut));
        if best.bound <= least {
            return None;
        }
        let split = self.split(pieces, &node, &best);
        let hint = Hint { cut: best.cut, normals: node.normals };
        Some(Bounded { bound: best.bound.min(by_translation), split, hint })
    }

    /// The least bound by cuts that is found, as soon as it is not above `floor`.
    fn best(&self, node: &Node<'_>, floor: f64, hint: Option<&Cut>) -> Best {
        let steps = if hint.is_some() { NEXT_CUTS } else { FIRST_CUTS };
        let mut best = hint.map_or(Best { bound: f64::INFINITY, cut: Cut::NONE }, |&cut| Best {
            bound: node.bound(&cut),
            cut,
        });
        // All corners, as often as they are in a finger's piece; each as if a part of the finger
        // were there.
        let corners: Vec<Vector<6>> =
            node.fingers.iter().flat_map(|finger| finger.all().iter().copied()).collect();
        let even = node.fingers.iter().flat_map(|finger| {
            let count = finger.all().len();
            std::iter::repeat_n((count as f64).recip(), count)
        });
        let mut shares: Vec<f64> = even.collect();
        let mut values = Values::of(&best.cut, &corners, node);
        for step in 0..steps {
            if best.bound <= above(floor) {
                break;
            }
            let Some(cut) = self.violated(node, &corners, &shares, floor) else { break };
            let other = Values::of(&cut, &corners, node);
            if best.bound.is_finite() {
                values = improve(node, &mut best, values, (&cut, &other));
            } else {
                best = Best { bound: node.bound(&cut), cut };
                values = other;
            }
            // Each finger moves to where the cut is largest.
            let part = 2.0 / (step as f64 + 3.0);
            let mut rest = shares.as_mut_slice();
            for (finger, values) in values.by_finger(node) {
                let (shares, others) = rest.split_at_mut(finger);
                let top = (0..finger).fold(0, |i, j| if values[j] > values[i] { j } else { i });
                for share in &mut *shares {
                    *share *= 1.0 - part;
                }
                shares[top] += part;
                rest = others;
            }
        }
        best
    }

    /// The cut that fingers spread over the corners with these shares violate most.
    fn violated(
        &self,
        node: &Node<'_>,
        corners: &[Vector<6>],
        shares: &[f64],
        demand: f64,
    ) -> Option<Cut> {
        let spread = corners.iter().zip(shares).map(|(&p, share)| p * share.sqrt());
        let fixed = node.fixed.iter().map(|&(wrench, weight)| wrench * weight);
        let principal = Principal::of(Vector::ZERO, &stiffness(spread.chain(fixed))).ok()?;
        // Any points of the body make cuts that hold.
        let body = &self.rating.scene.coarse;
        let (sigma, mu) = (principal.translational(), principal.rotational());
        let cylinder = || Cut::cylinder(&principal, mu.vectors[0], self.cylinder_squared);
        match self.rating.fingers.objective {
            Objective::WorstPoint => {
                let worst = WorstPoint::of(&principal, body).ok()?;
                Some(Cut::worst_point(&principal, worst.point, worst.direction))
            }
            Objective::Quality => {
                let by_translation = sigma.values[0] * self.cylinder_squared <= mu.values[0];
                let translation = || Cut::translation(sigma.vectors[0]);
                Some(if by_translation { translation() } else { cylinder() })
            }
            Objective::Rotation { .. } => {
                let Some(Normals { translational, .. }) = &node.normals else {
                    return Some(cylinder());
                };
                let softest = EquivalentStiffness::least(&principal, body).ok()?;
                let moved = (softest.rotation, softest.farthest.point);
                // Sharpest for what the relaxation may reach.
                Cut::rotation(&principal, translational, moved, demand.max(softest.value))
            }
        }
    }

    /// The finger whose piece raises the bound most by its extent; of those with several patches,
    /// while there are any: all else is known better then. Where that is little, the largest piece
    /// on which a finger may be too near to another.
    fn split(&self, pieces: &[Piece], node: &Node<'_>, best: &Best) -> usize {
        let several = node.normals.is_none();
        let mut most = (0, f64::NEG_INFINITY);
        for (i, (corners, &piece)) in node.fingers.iter().zip(pieces).enumerate() {
            let is_several = self.pieces.patch(piece).is_none();
            if several != is_several || self.pieces.halves(piece).is_none() {
                continue;
            }
            let all = corners.all();
            let mean =
                all.iter().fold(Vector::ZERO, |sum, &p| sum + p) * (all.len() as f64).recip();
            let rise = corners.largest(&best.cut.form) - value(&best.cut.form, Vector::ZERO, mean);
            if rise > most.1 {
                most = (i, rise);
            }
        }
        if !several && most.1 < SMALL_RISE * best.bound {
            let centers = self.pieces.centers(pieces);
            let in_doubt = centers.and_then(|(tips, centers)| tips.largest_in_doubt(&centers));
            return in_doubt.filter(|&i| self.pieces.halves(pieces[i]).is_some()).unwrap_or(most.0);
        }
        most.0
    }
}

/// Puts in place of the best cut its mean with another one, if that bounds better; the values of
/// what is best then.
fn improve(
    node: &Node<'_>,
    best: &mut Best,
    values: Values,
    (cut, other): (&Cut, &Values),
) -> Values {
    let at = |part: f64| values.mixed_bound(part, other, (&best.cut.limits, &cut.limits), node);
    let (mut low, mut high) = (0.0, 1.0);
    let inner = |low: f64, high: f64| (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut a, mut b) = inner(low, high);
    let (mut at_a, mut at_b) = (at(a), at(b));
    for _ in 0..SECTIONS {
        if at_a < at_b {
            (high, b, at_b) = (b, a, at_a);
            a = inner(low, high).0;
            at_a = at(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = inner(low, high).1;
            at_b = at(b);
        }
    }
    let part = if at_a < at_b { a } else { b };
    let mixed = best.cut.mixed(part, cut);
    let bound = node.bound(&mixed);
    if bound >= best.bound {
        return values;
    }
    *best = Best { bound, cut: mixed };
    values.mixed(part, other)
}

/// The values of a cut's form at all corners, and the sum of those at the given contacts.
#[derive(Clone, Debug)]
struct Values {
    corners: Vec<f64>,
    fixed: f64,
}

impl Values {
    fn of(cut: &Cut, corners: &[Vector<6>], node: &Node<'_>) -> Self {
        let at = |p: &Vector<6>| value(&cut.form, Vector::ZERO, *p);
        Self {
            corners: corners.iter().map(at).collect(),
            fixed: node.fixed.iter().map(|(w, weight)| at(w) * weight * weight).sum(),
        }
    }

    /// The number of corners of each finger, and the values there.
    fn by_finger<'v>(&'v self, node: &'v Node<'_>) -> impl Iterator<Item = (usize, &'v [f64])> {
        let mut rest = self.corners.as_slice();
        node.fingers.iter().map(move |finger| {
            let (these, others) = rest.split_at(finger.all().len());
            rest = others;
            (these.len(), these)
        })
    }

    fn mixed(&self, part: f64, other: &Self) -> Self {
        let mean = |x: f64, y: f64| x * (1.0 - part) + y * part;
        let corners = self.corners.iter().zip(&other.corners);
        Self {
            corners: corners.map(|(&x, &y)| mean(x, y)).collect(),
            fixed: mean(self.fixed, other.fixed),
        }
    }

    /// The bound by a mean of two cuts, without rounding and the boxes of large groups.
    fn mixed_bound(
        &self,
        part: f64,
        other: &Self,
        (these, those): (&Limits, &Limits),
        node: &Node<'_>,
    ) -> f64 {
        let mean = |x: f64, y: f64| x * (1.0 - part) + y * part;
        let mut total = mean(self.fixed, other.fixed);
        for ((_, these), (_, those)) in self.by_finger(node).zip(other.by_finger(node)) {
            let all = these.iter().zip(those).map(|(&x, &y)| mean(x, y));
            total += all.fold(f64::NEG_INFINITY, f64::max);
        }
        these.mixed(part, those).largest_objective(total, node.sigma())
    }
}
