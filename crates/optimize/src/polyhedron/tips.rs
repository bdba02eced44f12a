//! How near to each other fingers may be.

use clench_screw::Vector;

use super::scene::Patch;
use super::{Fingers, Spacing};

/// Distances of centers are known to this many units of rounding of their coordinates.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The balls at the ends of fingers, in units of the part's radius.
#[derive(Clone, Debug)]
pub(super) struct Tips {
    clearance: f64,
    /// Of the fingers on each patch.
    radii: Vec<f64>,
    /// Of the given contacts.
    given: Vec<Tip>,
    rounding: f64,
}

/// A ball.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tip {
    center: Vector<3>,
    radius: f64,
}

/// A box around the centers that balls may have, and the least radius of those.
#[derive(Clone, Copy, Debug)]
pub(super) struct Centers {
    low: Vector<3>,
    high: Vector<3>,
    radius: f64,
}

impl Tips {
    /// Of fingers on so many patches, beside given contacts at these points; `unit` is the length
    /// that is 1.
    pub(super) fn new(
        spacing: &Spacing,
        patches: usize,
        given: &[(Vector<3>, Vector<3>)],
        unit: f64,
    ) -> Self {
        let of = |radii: &[f64], i: usize, other: f64| radii.get(i).copied().unwrap_or(other);
        let radius = |i| of(&spacing.candidates, i, spacing.radius) / unit;
        let given = given.iter().enumerate().map(|(i, &(point, normal))| {
            let radius = of(&spacing.given, i, 0.0) / unit;
            Tip { center: point - normal * radius, radius }
        });
        let radii: Vec<f64> = (0..patches).map(radius).collect();
        let given: Vec<Tip> = given.collect();
        let largest = given.iter().map(|tip| tip.radius).chain(radii.iter().copied());
        let rounding = ROUNDING * largest.fold(1.0, f64::max);
        Self { clearance: spacing.clearance / unit, radii, given, rounding }
    }

    /// The ball of a finger at a point of the patch with this number.
    pub(super) fn at(&self, patch: &Patch, number: usize, point: Vector<3>) -> Tip {
        let radius = self.radii[number];
        Tip { center: point - patch.normal * radius, radius }
    }

    /// The centers that a finger on some points of this patch may have.
    pub(super) fn centers(&self, patch: &Patch, number: usize, points: &[Vector<3>]) -> Centers {
        let boxes = points.iter().map(|&point| {
            let Tip { center, radius } = self.at(patch, number, point);
            Centers { low: center, high: center, radius }
        });
        boxes.reduce(Centers::joined).unwrap_or(Centers {
            low: Vector::ZERO,
            high: Vector::ZERO,
            radius: 0.0,
        })
    }

    /// Whether two of these balls, or one of them and a given one, are too near to each other.
    pub(super) fn are_crowded(&self, placed: &[Tip]) -> bool {
        self.pairs(placed).any(|(one, other)| {
            let distance = (one.center - other.center).norm();
            distance < self.least(one.radius, other.radius) - self.rounding
        })
    }

    /// The pairs that may not be too near: of placed balls, and of one with a given one, which
    /// comes second.
    fn pairs<'t>(&'t self, placed: &'t [Tip]) -> impl Iterator<Item = (Tip, Tip)> + 't {
        placed.iter().enumerate().flat_map(move |(i, &one)| {
            let others = placed[i + 1..].iter().chain(&self.given);
            others.map(move |&other| (one, other))
        })
    }

    /// The numbers of two placed balls that are not farther apart than they have to be by more than
    /// `slack`, or of one and none for a given one; the way from the second to the first, and how
    /// much nearer they may come.
    pub(super) fn near<const K: usize>(
        &self,
        placed: &[Tip; K],
        slack: f64,
    ) -> Vec<([Option<usize>; 2], Vector<3>, f64)> {
        let mut found = Vec::new();
        for (i, one) in placed.iter().enumerate() {
            let others = placed.iter().enumerate().skip(i + 1).map(|(j, other)| (Some(j), other));
            for (j, other) in others.chain(self.given.iter().map(|other| (None, other))) {
                let way = one.center - other.center;
                let left = way.norm() - self.least(one.radius, other.radius);
                if let Some(way) = way.direction().filter(|_| left < slack) {
                    found.push(([Some(i), j], way, left));
                }
            }
        }
        found
    }

    /// Whether in some pair each two balls are too near to each other.
    pub(super) fn are_never_apart(&self, boxes: &[Centers]) -> bool {
        self.pairs_of_centers(boxes).any(|(one, other)| {
            let apart = |i: usize| (one.high[i] - other.low[i]).max(other.high[i] - one.low[i]);
            let farthest = Vector::<3>::from_fn(apart).norm();
            farthest < self.least(one.radius, other.radius) - 2.0 * self.rounding
        })
    }

    /// The number of the largest of the boxes in which balls may be too near to others.
    pub(super) fn largest_in_doubt(&self, boxes: &[Centers]) -> Option<usize> {
        let is_in_doubt = |i: usize| {
            let is_near = |other: &Centers| {
                let one = &boxes[i];
                let beside =
                    |k: usize| (one.low[k] - other.high[k]).max(other.low[k] - one.high[k]);
                let nearest = Vector::<3>::from_fn(|k| beside(k).max(0.0)).norm();
                nearest < self.least(one.radius, other.radius)
            };
            let others = boxes.iter().enumerate().filter(|(j, _)| *j != i);
            others
                .map(|(_, other)| *other)
                .chain(self.centers_of_given())
                .any(|other| is_near(&other))
        };
        let size = |i: usize| (boxes[i].high - boxes[i].low).norm_squared();
        (0..boxes.len()).filter(|&i| is_in_doubt(i)).max_by(|&i, &j| size(i).total_cmp(&size(j)))
    }

    fn pairs_of_centers<'t>(
        &'t self,
        boxes: &'t [Centers],
    ) -> impl Iterator<Item = (Centers, Centers)> + 't {
        boxes.iter().enumerate().flat_map(move |(i, &one)| {
            let others = boxes[i + 1..].iter().copied().chain(self.centers_of_given());
            others.map(move |other| (one, other))
        })
    }

    fn centers_of_given(&self) -> impl Iterator<Item = Centers> + '_ {
        let centers = |tip: &Tip| Centers { low: tip.center, high: tip.center, radius: tip.radius };
        self.given.iter().map(centers)
    }

    /// The least distance of two centers.
    fn least(&self, one: f64, other: f64) -> f64 {
        one + other + self.clearance
    }
}

impl Centers {
    /// Around both.
    pub(super) fn joined(self, other: Self) -> Self {
        Self {
            low: Vector::from_fn(|i| self.low[i].min(other.low[i])),
            high: Vector::from_fn(|i| self.high[i].max(other.high[i])),
            radius: self.radius.min(other.radius),
        }
    }
}

impl Fingers {
    /// The condition on distances, if there is one.
    pub(super) fn checked_spacing(&self) -> Option<&Spacing> {
        let given = self.spacing.given.iter().chain(&self.spacing.candidates);
        let largest = given.copied().fold(self.spacing.radius + self.spacing.clearance, f64::max);
        (largest > 0.0).then_some(&self.spacing)
    }
}
