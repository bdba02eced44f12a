//! The tips of round fingers: where their centers are, and when two are too near to each other.
#![allow(
    clippy::cast_possible_truncation,
    reason = "there are fewer than twice as many groups as stretches, which are in memory"
)]

use clench_screw::Vector;
use clench_screw::planar::chord;
use clench_shape::LARGEST_COORDINATE;

use super::Fingers;
use super::bound::{Cut, Middle, Pieces};
use super::rating::{DISTANCE_ROUNDING, Spot};
use super::scene::{Scene, Support};
use crate::OptimizeError;
use crate::search::Piece;

/// Checks the radius of tips, whose square is formed, and the clearance between them (length).
pub(super) fn check(radius: f64, clearance: f64) -> Result<(), OptimizeError> {
    if !(0.0..=LARGEST_COORDINATE).contains(&radius) {
        return Err(OptimizeError::FingerRadius { value: radius });
    }
    if !(clearance >= 0.0 && clearance.is_finite()) {
        return Err(OptimizeError::Clearance { value: clearance });
    }
    Ok(())
}

/// What distances fingers keep.
#[derive(Clone, Copy, Debug)]
pub(super) struct Keeping<'a> {
    scene: &'a Scene<'a>,
    radius: f64,
    least: f64,
}

impl<'a> Keeping<'a> {
    /// The distances that are asked for, if any.
    pub(super) fn asked(scene: &'a Scene<'a>, fingers: &Fingers) -> Option<Self> {
        let (radius, least) = (fingers.finger_radius, fingers.least_distance());
        (least > 0.0).then_some(Self { scene, radius, least })
    }

    /// The center of the tip of a finger with the scaled moment `s`, relative to that of the part.
    fn tip(&self, support: &Support, s: f64) -> Vector<2> {
        let center = self.scene.center;
        support.point(s, center) - center - support.normal * self.radius
    }

    /// Whether two of the fingers with these scaled moments are too near to each other.
    pub(super) fn is_crowded<const K: usize>(
        &self,
        stretches: &[usize; K],
        moments: &[f64; K],
    ) -> bool {
        (0..K).any(|i| (0..i).any(|j| self.shortage(stretches, moments, i, j) > 0.0))
    }

    /// The fingers on two edges that are too near to each other by most.
    pub(super) fn nearest_pair<const K: usize>(
        &self,
        stretches: &[usize; K],
        moments: &[f64; K],
    ) -> Option<(usize, usize)> {
        let edge = |i: usize| self.scene.supports[stretches[i]].edge;
        let pairs = (0..K).flat_map(|i| (0..i).map(move |j| (i, j)));
        let near = pairs.filter(|&(i, j)| edge(i) != edge(j)).map(|(i, j)| {
            let shortage = self.shortage(stretches, moments, i, j);
            (shortage, (i, j))
        });
        let most = near.max_by(|a, b| a.0.total_cmp(&b.0));
        most.filter(|most| most.0 > 0.0).map(|(_, pair)| pair)
    }

    /// How much less than asked for the distance of two fingers is.
    fn shortage<const K: usize>(
        &self,
        stretches: &[usize; K],
        moments: &[f64; K],
        i: usize,
        j: usize,
    ) -> f64 {
        let tip = |i: usize| self.tip(&self.scene.supports[stretches[i]], moments[i]);
        self.least - self.rounding() - (tip(i) - tip(j)).norm()
    }

    /// The moments of a finger on one stretch that are too near to all fingers with moments in
    /// `range` on `other`: where it is too near to both ends, since distances are convex.
    pub(super) fn taken(&self, other: usize, range: [f64; 2], stretch: usize) -> Option<[f64; 2]> {
        let (one, other) = (&self.scene.supports[stretch], &self.scene.supports[other]);
        let least = self.least - self.rounding();
        let start = self.tip(one, one.low);
        let span = self.tip(one, one.high) - start;
        let (length, direction) = (span.norm(), span.direction()?);
        let near = |s: f64| chord(self.tip(other, s) - start, direction, least);
        let ([a, b], [c, d]) = (near(range[0])?, near(range[1])?);
        let both = [a.max(c), b.min(d)].map(|along| one.moment(along / length));
        (both[0] < both[1]).then_some(both)
    }

    /// The places of fingers with these scaled moments.
    pub(super) fn spots<const K: usize>(
        &self,
        stretches: &[usize; K],
        moments: &[f64; K],
    ) -> [Spot; K] {
        std::array::from_fn(|i| {
            let support = &self.scene.supports[stretches[i]];
            let along = (moments[i] - support.low) / (support.high - support.low);
            Spot { stretch: stretches[i], along: along.clamp(0.0, 1.0) }
        })
    }

    /// The placement with one finger of each pair that is too near moved along its stretch, just
    /// far enough.
    pub(super) fn parted<const K: usize>(&self, spots: &[Spot; K]) -> [Spot; K] {
        let mut spots = *spots;
        for i in 0..K {
            for j in 0..i {
                if let Some(moved) = self.beside(spots[j], spots[i]) {
                    spots[i] = moved;
                } else if let Some(moved) = self.beside(spots[i], spots[j]) {
                    spots[j] = moved;
                }
            }
        }
        spots
    }

    /// The place nearest to `spot` on its stretch that is just far enough from the finger at
    /// `other`; `None` if that is far already, or there is no such place.
    fn beside(&self, other: Spot, spot: Spot) -> Option<Spot> {
        let at = |spot: Spot| {
            let support = &self.scene.supports[spot.stretch];
            self.tip(support, support.moment(spot.along))
        };
        let way = at(spot) - at(other);
        if way.norm() >= self.least {
            return None;
        }
        let support = &self.scene.supports[spot.stretch];
        let span = self.tip(support, support.high) - self.tip(support, support.low);
        let (length, direction) = (span.norm(), span.direction()?);
        let places = chord(-way, direction, self.least)?.map(|by| spot.along + by / length);
        let near = |a: &f64, b: &f64| (a - spot.along).abs().total_cmp(&(b - spot.along).abs());
        let place = places.into_iter().filter(|place| (0.0..=1.0).contains(place)).min_by(near)?;
        Some(Spot { along: place, ..spot })
    }

    /// What distances may fall short by.
    fn rounding(&self) -> f64 {
        DISTANCE_ROUNDING * (self.scene.radius + self.radius)
    }
}

/// The tips of fingers on pieces of the boundary.
#[derive(Clone, Debug)]
pub(super) struct Tips<'a> {
    keeping: Keeping<'a>,
    /// A disc around the tips on each group of stretches, with its radius.
    discs: Vec<(Vector<2>, f64)>,
}

impl<'a> Tips<'a> {
    pub(super) fn new(keeping: Keeping<'a>, pieces: &Pieces<3>) -> Self {
        let disc = |group: usize| {
            let stretches = pieces.stretches(Piece::whole(group as u32)).iter();
            let supports = stretches.map(|&s| &keeping.scene.supports[s]);
            let tips: Vec<_> =
                supports.flat_map(|s| [keeping.tip(s, s.low), keeping.tip(s, s.high)]).collect();
            let far = Vector::new([f64::INFINITY; 2]);
            let (low, high) = tips.iter().fold((far, -far), |(low, high), tip| {
                let (least, most) = (|i| f64::min(low[i], tip[i]), |i| f64::max(high[i], tip[i]));
                (Vector::from_fn(least), Vector::from_fn(most))
            });
            let middle = (low + high) * 0.5;
            (middle, tips.iter().map(|tip| (*tip - middle).norm()).fold(0.0, f64::max))
        };
        Self { keeping, discs: (0..pieces.count()).map(disc).collect() }
    }

    /// Whether two fingers of a node are too near to each other, wherever they are on it.
    pub(super) fn are_crowded<const K: usize>(
        &self,
        node: &[Piece; K],
        pieces: &Pieces<3>,
    ) -> bool {
        let limit = self.keeping.least - self.keeping.rounding();
        let crowded = |a: Piece, b: Piece| {
            let [one, other] = [a, b].map(|piece| self.segment(piece, pieces));
            let apart = if let Some((one, other)) = one.zip(other) {
                // The distance is convex, so it is largest at ends.
                let ends = one.iter().flat_map(|p| other.iter().map(move |q| (*p - *q).norm()));
                ends.fold(0.0, f64::max)
            } else {
                let [(p, r), (q, s)] = [a, b].map(|piece| self.discs[piece.group()]);
                (p - q).norm() + r + s
            };
            apart < limit
        };
        (0..K).any(|i| (0..i).any(|j| crowded(node[i], node[j])))
    }

    /// Where the tips on a piece of a single stretch begin and end.
    fn segment(&self, piece: Piece, pieces: &Pieces<3>) -> Option<[Vector<2>; 2]> {
        let [one] = *pieces.stretches(piece) else { return None };
        let (support, range) = (&self.keeping.scene.supports[one], pieces.range(piece));
        let (middle, half) = (range.center[2], range.axes[0][2].abs());
        Some([middle - half, middle + half].map(|s| self.keeping.tip(support, s)))
    }

    /// For each two fingers on single stretches that their distance is no less than asked for, to
    /// first order and with what is left out as slack.
    ///
    /// With the tips at `a + u x` and `b + v y`, `x` and `y` in `[-1, 1]`, the squared distance is
    /// `|a - b|^2 + 2 (a - b) . (u x - v y)` and at most `(|u| + |v|)^2` more.
    pub(super) fn cuts<const K: usize>(
        &self,
        node: &[Piece; K],
        middle: &Middle<K>,
        pieces: &Pieces<3>,
    ) -> impl Iterator<Item = Cut<K>> {
        let segments = node.map(|piece| self.segment(piece, pieces));
        let spins = middle.ranges.map(|range| (range.center[2], range.axes[0][2].abs()));
        let pairs = (0..K).flat_map(|i| (0..i).map(move |j| (i, j)));
        pairs.filter_map(move |(i, j)| {
            let ([p, q], [r, s]) = (segments[i]?, segments[j]?);
            let ((a, u), (b, v)) = (((p + q) * 0.5, (q - p) * 0.5), ((r + s) * 0.5, (s - r) * 0.5));
            let apart = a - b;
            let least = self.keeping.least - self.keeping.rounding();
            let rest = u.norm() + v.norm();
            if apart.norm() - rest >= least {
                return None;
            }
            let (mut linear, mut constant) = ([Vector::ZERO; K], 0.0);
            for (finger, slope) in [(i, apart.dot(u)), (j, -apart.dot(v))] {
                let (center, half) = spins[finger];
                let per_moment = if half > 0.0 { 2.0 * slope / half } else { 0.0 };
                linear[finger] = Vector::new([0.0, 0.0, per_moment]);
                constant += per_moment * center;
            }
            let demanded = least * least - apart.norm_squared();
            let size = least * least + apart.norm_squared() + constant.abs() + rest * rest;
            Some(Cut::of_linear(linear, constant + demanded, rest * rest, size))
        })
    }
}
