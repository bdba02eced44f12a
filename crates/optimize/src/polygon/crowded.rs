//! Four fingers on four stretches whose best placement has two tips too near to each other.
//!
//! Two tips are apart where their moments are outside of a convex set, an ellipse. So the ranges of
//! moments are divided: one finger of such a pair gets either side of where it is best, and the
//! other one loses what is too near to all of that. Each part is solved in closed form, best first,
//! and what is found is the best as soon as its own tips are apart.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::CROWDING_GAP;
use super::closed_form::Quadruple;
use super::rating::rate;
use super::scene::Support;
use super::springs::{Moments, Springs};
use super::tips::Keeping;

/// So many parts are solved; what is left then is told.
const MOST_PARTS: usize = 20_000;

/// Ranges of less than this part of their stretch are not divided: tips on them are as far apart
/// as they will be.
const NARROWEST: f64 = 1e-9;

/// The range of moments of each finger.
type Ranges = [[f64; 2]; 4];

/// A part of the placements, with its best one.
#[derive(Clone, Copy, Debug)]
struct Section {
    ranges: Ranges,
    equivalent: f64,
    moments: [f64; 4],
}

impl Ord for Section {
    fn cmp(&self, other: &Self) -> Ordering {
        let key = |part: &Self| part.ranges.map(|range| range[0]);
        let (one, two) = (key(self), key(other));
        let ranges = one.iter().zip(&two).map(|(a, b)| b.total_cmp(a));
        let first = ranges.fold(Ordering::Equal, Ordering::then);
        self.equivalent.total_cmp(&other.equivalent).then(first)
    }
}

impl PartialOrd for Section {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Section {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Section {}

/// The largest `mu_eq` of fingers that are apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parted {
    /// That of the best found, with its moments.
    pub(super) best: Option<(f64, [f64; 4])>,
    /// None is larger.
    pub(super) bound: f64,
}

/// Four stretches whose fingers have to be apart.
pub(super) struct Crowded<'a> {
    pub(super) springs: Springs<'a>,
    pub(super) keeping: Keeping<'a>,
    pub(super) stretches: [usize; 4],
}

impl Crowded<'_> {
    /// The best with a `mu_eq` of more than `floor`.
    pub(super) fn best(&self, floor: f64) -> Parted {
        let scene = self.springs.scene;
        let whole = self.stretches.map(|s| [scene.supports[s].low, scene.supports[s].high]);
        let mut open: BinaryHeap<Section> = self.solved(whole, floor).into_iter().collect();
        let mut best: Option<(f64, Moments<4>)> = None;
        let (mut solved, mut left) = (0, 0.0_f64);
        while let Some(part) = open.pop() {
            let least = best.map_or(floor, |best| best.0.max(floor));
            if part.equivalent <= least * (1.0 + CROWDING_GAP) || solved > MOST_PARTS {
                return Parted { best, bound: part.equivalent.max(left) };
            }
            let Some((i, j)) = self.keeping.nearest_pair(&self.stretches, &part.moments) else {
                let best = Some((part.equivalent, part.moments));
                return Parted { best, bound: part.equivalent.max(left) };
            };
            if let Some(found) = self.parted(&part.moments).filter(|found| found.0 > least) {
                best = Some(found);
            }
            let least = best.map_or(floor, |best| best.0.max(floor));
            let parts = self.divided(&part, i, j);
            if parts.is_none() {
                left = left.max(part.equivalent);
            }
            for ranges in parts.into_iter().flatten() {
                solved += 1;
                open.extend(self.solved(ranges, least));
            }
        }
        Parted { best, bound: best.map_or(floor, |best| best.0).max(left) }
    }

    /// The best placement within `ranges`, if it exceeds `floor`.
    fn solved(&self, ranges: Ranges, floor: f64) -> Option<Section> {
        let scene = self.springs.scene;
        let supports: [Support; 4] = std::array::from_fn(|i| {
            scene.supports[self.stretches[i]].narrowed(ranges[i], scene.center)
        });
        let fingers = self.springs.fingers;
        let quadruple = Quadruple::over(scene, supports.each_ref(), fingers)?.on_part();
        if quadruple.bound() <= floor {
            return None;
        }
        let peak = quadruple.peak(floor)?;
        let moments = quadruple.moments(peak.d, peak.z);
        Some(Section { ranges, equivalent: peak.equivalent, moments })
    }

    /// The placement with its tips moved apart, and its `mu_eq`.
    fn parted(&self, moments: &[f64; 4]) -> Option<(f64, [f64; 4])> {
        let scene = self.springs.scene;
        let spots = self.keeping.spots(&self.stretches, moments);
        let moments = super::rating::moments(scene, &self.keeping.parted(&spots));
        let rating = rate(scene, self.springs.fingers, &self.stretches, &moments, |_| true)?;
        Some((rating.equivalent, moments))
    }

    /// The parts on either side of finger `j`, or of finger `i` where that has more room; `None`
    /// where neither is divided further.
    fn divided(&self, part: &Section, i: usize, j: usize) -> Option<Vec<Ranges>> {
        let span = |i: usize| {
            let support = &self.springs.scene.supports[self.stretches[i]];
            (part.ranges[i][1] - part.ranges[i][0]) / (support.high - support.low)
        };
        let (i, j) = if span(i) > span(j) { (j, i) } else { (i, j) };
        if span(j) <= NARROWEST {
            return None;
        }
        let [low, high] = part.ranges[j];
        // Where it is best, unless that is at an end.
        let at = part.moments[j].clamp(low + 0.1 * (high - low), high - 0.1 * (high - low));
        let mut parts = Vec::new();
        for side in [[low, at], [at, high]] {
            let taken = self.keeping.taken(self.stretches[j], side, self.stretches[i]);
            let [from, to] = part.ranges[i];
            let rest = match taken {
                Some([a, b]) => vec![[from, to.min(a)], [from.max(b), to]],
                None => vec![[from, to]],
            };
            for range in rest.into_iter().filter(|range| range[0] < range[1]) {
                let mut ranges = part.ranges;
                (ranges[i], ranges[j]) = (range, side);
                parts.push(ranges);
            }
        }
        Some(parts)
    }
}
