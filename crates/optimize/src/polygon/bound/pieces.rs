//! Pieces of the boundary: a binary tree over its stretches, with a box of wrenches for each run.
#![allow(
    clippy::cast_possible_truncation,
    reason = "there are fewer than twice as many groups as stretches, which are in memory"
)]

use clench_screw::{Mat, Vector};

use crate::polygon::rating::Spot;
use crate::polygon::scene::Support;
use crate::search::Piece;
use crate::search::boxes::{BOX_ROUNDING, arrange, largest_in_box, principal_box, spread, value};

/// Pieces of up to this many stretches are looked at one by one instead of by their box.
const SCAN_LIMIT: usize = 8;

/// What fingers on a piece can be: vectors, such as the scaled wrenches `p = (arm, s)` of
/// [`super`], and the stiffness of the stretches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Range<const D: usize> {
    /// The first stretch, and the one after the last.
    pub(crate) first: u32,
    pub(crate) end: u32,
    /// All vectors are `center + sum of t_j axes[j]` with `t_j` in `[-1, 1]`; of one stretch,
    /// these are all, along the first axis.
    pub(crate) center: Vector<D>,
    pub(crate) axes: [Vector<D>; D],
    /// A disc around the normals' `k (cos 2 phi, sin 2 phi)`.
    pub(crate) turn: Vector<2>,
    pub(crate) turn_radius: f64,
    /// The middle and the half-width of the range of stiffnesses.
    pub(crate) stiffness: f64,
    pub(crate) stiffness_spread: f64,
}

impl<const D: usize> Range<D> {
    /// Whether it belongs to a single stretch.
    pub(crate) const fn is_single(&self) -> bool {
        self.end - self.first == 1
    }

    /// How much `linear . p` changes from the center to an end of the box.
    pub(crate) fn spread(&self, linear: Vector<D>) -> f64 {
        spread(&self.axes, linear)
    }
}

/// A node of the tree.
#[derive(Clone, Copy, Debug)]
struct Group<const D: usize> {
    range: Range<D>,
    /// The two halves; unused for a single stretch.
    halves: [u32; 2],
}

/// All groups; the first is the whole boundary.
#[derive(Clone, Debug)]
pub(crate) struct Pieces<const D: usize> {
    groups: Vec<Group<D>>,
    /// The stretches, each group next to each other.
    order: Vec<usize>,
    /// The vectors at the two ends of each stretch, in this order.
    ends: Vec<[Vector<D>; 2]>,
}

impl<const D: usize> Pieces<D> {
    /// The tree over `supports`, with their vectors at a scaled moment, which is linear; components
    /// are compared in these `units`.
    pub(crate) fn new(
        supports: &[Support],
        units: Vector<D>,
        vector: impl Fn(&Support, f64) -> Vector<D>,
    ) -> Self {
        let middle = |s: &Support| {
            let p = vector(s, 0.5 * (s.low + s.high));
            Vector::<D>::from_fn(|i| p[i] / units[i])
        };
        let middles: Vec<_> = supports.iter().map(middle).collect();
        let mut order: Vec<_> = (0..supports.len()).collect();
        arrange(&middles, &mut order);
        Self::in_order(order, supports, units, vector)
    }

    /// The tree whose pieces are those of another one, over other vectors.
    pub(crate) fn like<const E: usize>(
        other: &Pieces<E>,
        supports: &[Support],
        units: Vector<D>,
        vector: impl Fn(&Support, f64) -> Vector<D>,
    ) -> Self {
        Self::in_order(other.order.clone(), supports, units, vector)
    }

    fn in_order(
        order: Vec<usize>,
        supports: &[Support],
        units: Vector<D>,
        vector: impl Fn(&Support, f64) -> Vector<D>,
    ) -> Self {
        let sorted: Vec<_> = order.iter().map(|&stretch| supports[stretch]).collect();
        let ends = sorted.iter().map(|s| [vector(s, s.low), vector(s, s.high)]).collect();
        let mut tree = Self { groups: Vec::with_capacity(2 * sorted.len()), order, ends };
        tree.grow(&sorted, 0, sorted.len(), units);
        tree
    }

    fn grow(&mut self, supports: &[Support], first: usize, end: usize, units: Vector<D>) -> u32 {
        let place = self.groups.len();
        let range = self.enclose(supports, (first, end), units);
        self.groups.push(Group { range, halves: [0; 2] });
        if end - first > 1 {
            let middle = usize::midpoint(first, end);
            let left = self.grow(supports, first, middle, units);
            let right = self.grow(supports, middle, end, units);
            self.groups[place].halves = [left, right];
        }
        place as u32
    }

    /// How many groups there are.
    pub(crate) fn count(&self) -> usize {
        self.groups.len()
    }

    /// What fingers on `piece` can be.
    pub(crate) fn range(&self, piece: Piece) -> Range<D> {
        let mut range = self.groups[piece.group()].range;
        if piece.part() > 1 {
            let (from, to) = piece.along();
            let axis = range.axes[0];
            range.center += axis * (from + to - 1.0);
            range.axes[0] = axis * (to - from);
        }
        range
    }

    /// The two halves of a piece; `None` where there is nothing left to halve.
    pub(crate) fn halves(&self, piece: Piece) -> Option<[Piece; 2]> {
        let group = &self.groups[piece.group()];
        if !group.range.is_single() {
            return Some(group.halves.map(Piece::whole));
        }
        piece.halves()
    }

    /// The stretches of a piece.
    pub(crate) fn stretches(&self, piece: Piece) -> &[usize] {
        let range = &self.groups[piece.group()].range;
        &self.order[range.first as usize..range.end as usize]
    }

    /// The stretches, ascending, of pieces that are of one each.
    pub(crate) fn combination<const K: usize>(&self, node: &[Piece; K]) -> Option<[usize; K]> {
        let mut combination = [0; K];
        for (stretch, &piece) in combination.iter_mut().zip(node) {
            match self.stretches(piece) {
                [one] => *stretch = *one,
                _ => return None,
            }
        }
        combination.sort_unstable();
        Some(combination)
    }

    /// A place near the middle of a piece.
    pub(crate) fn middle(&self, piece: Piece) -> Spot {
        let stretches = self.stretches(piece);
        let (from, to) = piece.along();
        Spot { stretch: stretches[stretches.len() / 2], along: 0.5 * (from + to) }
    }

    /// An upper bound of `p^T form p + linear . p` over a range; attained when it is of few
    /// stretches.
    ///
    /// `form` is symmetric and not concave along stretches, so that it is largest at their ends.
    pub(crate) fn largest(&self, of: &Range<D>, form: &Mat<D, D>, linear: Vector<D>) -> f64 {
        if of.is_single() {
            let (center, axis) = (of.center, of.axes[0]);
            return value(form, linear, center - axis).max(value(form, linear, center + axis));
        }
        let (first, end) = (of.first as usize, of.end as usize);
        if end - first > SCAN_LIMIT {
            return largest_in_box(form, linear, of.center, &of.axes);
        }
        let ends = self.ends[first..end].as_flattened();
        ends.iter().map(|&p| value(form, linear, p)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// An upper bound of `linear . p` over a range, attained as in [`Self::largest`].
    pub(crate) fn largest_linear(&self, of: &Range<D>, linear: Vector<D>) -> f64 {
        let (first, end) = (of.first as usize, of.end as usize);
        if of.is_single() || end - first > SCAN_LIMIT {
            return of.center.dot(linear) + of.spread(linear);
        }
        let ends = self.ends[first..end].as_flattened();
        ends.iter().map(|p| p.dot(linear)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The boxes and discs around the stretches from `first` to before `end`.
    fn enclose(
        &self,
        supports: &[Support],
        (first, end): (usize, usize),
        units: Vector<D>,
    ) -> Range<D> {
        let ends = self.ends[first..end].as_flattened();
        let supports = &supports[first..end];
        let turns = supports.iter().map(|s| s.double_angle);
        let mean = (supports.len() as f64).recip();
        let turn = turns.clone().fold(Vector::ZERO, |sum, t| sum + t) * mean;
        let turn_radius = turns.map(|t| (t - turn).norm()).fold(0.0, f64::max);
        let (softest, stiffest) = supports
            .iter()
            .fold((f64::INFINITY, 0.0_f64), |(a, b), s| (a.min(s.stiffness), b.max(s.stiffness)));
        let (center, axes) = match ends {
            [low, high] => {
                let mut axes = [Vector::ZERO; D];
                axes[0] = (*high - *low) * 0.5;
                ((*low + *high) * 0.5, axes)
            }
            _ => principal_box(ends, units),
        };
        Range {
            first: first as u32,
            end: end as u32,
            center,
            axes,
            turn,
            turn_radius: if turn_radius > 0.0 {
                turn_radius + BOX_ROUNDING * stiffest
            } else {
                0.0
            },
            stiffness: 0.5 * (softest + stiffest),
            stiffness_spread: 0.5 * (stiffest - softest),
        }
    }
}
