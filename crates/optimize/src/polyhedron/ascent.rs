//! Good placements, by local ascent from random starts.

use std::time::Instant;

use fastrand::Rng;

use super::rating::{Rating, Spot, Worth};
use super::scene::{Patch, across};
use super::summit::climbed;

/// So many placements by chance are rated for a start; the best is where the ascent begins.
const TRIALS: usize = 64;

/// Steps along faces go from this part of the part's radius to this one.
const LONGEST_STEP: f64 = 0.5;
const SHORTEST_STEP: f64 = 1e-3;

/// From one length of steps to the next.
const SHORTENED: f64 = 0.6;

/// So many steps in a row for each finger that gain nothing end a length of steps.
const PATIENCE: usize = 16;

/// While steps are longer than this, fingers also change places: one step of so many.
const CHANGING: f64 = 0.02;
const CHANGES: usize = 4;

/// So many places at most are tried for each finger in a sweep: all of so many candidates.
const SWEPT: usize = 10_000;

/// Sweeps follow each other while they gain, at most so often.
const SWEEPS: usize = 4;

/// A placement, and what it is worth.
pub(super) type Climber<const K: usize> = (Worth, [Spot; K]);

/// Ascents of one rating.
#[derive(Debug)]
pub(super) struct Ascent<'a> {
    rating: Rating<'a>,
    rng: Rng,
    /// When it has to end.
    deadline: Option<Instant>,
}

impl<'a> Ascent<'a> {
    /// Ascents whose chances depend on `seed` alone.
    pub(super) fn new(rating: Rating<'a>, seed: u64) -> Self {
        Self { rating, rng: Rng::with_seed(seed), deadline: None }
    }

    /// The same, which ends soon after a time.
    pub(super) fn until(self, deadline: Option<Instant>) -> Self {
        Self { deadline, ..self }
    }

    fn is_late(&self) -> bool {
        self.deadline.is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// The best placement that an ascent from a start by chance arrives at; `None` if it does not
    /// hold.
    pub(super) fn by_chance<const K: usize>(&mut self) -> Option<Climber<K>> {
        let mut best: Climber<K> = (Worth::Loose(f64::NEG_INFINITY), [self.spot(); K]);
        for _ in 0..TRIALS {
            if self.is_late() {
                break;
            }
            let spots = std::array::from_fn(|_| self.spot());
            if let Some(worth) = self.rating.above(&spots, best.0) {
                best = (worth, spots);
            }
        }
        self.from(best)
    }

    /// The best placement that an ascent from there arrives at; `None` if it does not hold.
    pub(super) fn from<const K: usize>(&mut self, start: Climber<K>) -> Option<Climber<K>> {
        let best = self.climbed(start);
        matches!(best.0, Worth::Held(..)).then(|| climbed(self.rating, best))
    }

    /// The best placement that changing the patch of one finger at a time, to any other one, and
    /// ascents between arrive at.
    pub(super) fn swept<const K: usize>(&mut self, start: Climber<K>) -> Climber<K> {
        let mut best = start;
        for sweep in 0..SWEEPS {
            let before = best.0;
            let count = self.rating.scene.patches.len();
            let places_each = self.rating.scene.patches.first().map_or(1, |p| places(p).count());
            let stride = (count * places_each).div_ceil(SWEPT).max(1);
            for i in 0..K {
                for patch in (sweep % stride..count).step_by(stride) {
                    if self.is_late() {
                        return best;
                    }
                    for point in places(&self.rating.scene.patches[patch]) {
                        self.consider(&mut best, i, Spot { patch, point });
                    }
                }
            }
            if best.0 <= before {
                break;
            }
            best = climbed(self.rating, self.climbed(best));
        }
        best
    }

    fn consider<const K: usize>(&self, best: &mut Climber<K>, finger: usize, spot: Spot) -> bool {
        let mut spots = best.1;
        spots[finger] = spot;
        self.improve(best, spots)
    }

    fn improve<const K: usize>(&self, best: &mut Climber<K>, spots: [Spot; K]) -> bool {
        let found = self.rating.above(&spots, best.0);
        if let Some(worth) = found {
            *best = (worth, spots);
        }
        found.is_some()
    }

    /// Steps of single fingers and of pairs, ever shorter.
    fn climbed<const K: usize>(&mut self, start: Climber<K>) -> Climber<K> {
        let mut best = start;
        let mut step = LONGEST_STEP;
        while step > SHORTEST_STEP && !self.is_late() {
            let mut idle = 0;
            while idle < PATIENCE * K {
                let mut spots = best.1;
                for _ in 0..=self.rng.usize(0..2) {
                    let finger = self.rng.usize(0..K);
                    spots[finger] = self.moved(spots[finger], step);
                }
                idle = if self.improve(&mut best, spots) { 0 } else { idle + 1 };
            }
            step *= SHORTENED;
        }
        best
    }

    /// Another place for a finger.
    fn moved(&mut self, spot: Spot, step: f64) -> Spot {
        if step > CHANGING && self.rng.usize(0..CHANGES) == 0 {
            return self.spot();
        }
        let patch = &self.rating.scene.patches[spot.patch];
        if patch.is_point() {
            return self.spot();
        }
        if self.rng.usize(0..CHANGES) == 0 {
            // Many best places are at corners, and on edges.
            let corner = patch.corners[self.rng.usize(0..patch.corners.len())];
            let way = corner - spot.point;
            let part = (step * self.rng.f64() / way.norm().max(step)).min(1.0);
            return Spot { point: patch.nearest(spot.point + way * part), ..spot };
        }
        let [u, v] = across(patch.normal);
        let [a, b] = [self.rng.f64() - 0.5, self.rng.f64() - 0.5];
        let point = patch.nearest(spot.point + (u * a + v * b) * (2.0 * step));
        Spot { point, ..spot }
    }

    /// A place by chance: more often near corners than not.
    fn spot(&mut self) -> Spot {
        let patches = &self.rating.scene.patches;
        let patch = self.rng.usize(0..patches.len());
        let of = &patches[patch];
        if of.is_point() {
            return Spot { patch, point: of.corners[0] };
        }
        let triangle = of.triangles[self.rng.usize(0..of.triangles.len())];
        let weights = [(); 3].map(|()| self.rng.f64().powi(3));
        let sum: f64 = weights.iter().sum();
        let share = |i: usize| if sum > 0.0 { weights[i] / sum } else { 1.0 / 3.0 };
        let point = triangle[0]
            + (triangle[1] - triangle[0]) * share(1)
            + (triangle[2] - triangle[0]) * share(2);
        Spot { patch, point }
    }
}

/// The places of a patch that a sweep tries.
fn places(patch: &Patch) -> impl Iterator<Item = clench_screw::Vector<3>> {
    let middle = (!patch.is_point()).then(|| patch.middle());
    // Corners of the hull need not be on a patch with holes at them; they always are its own.
    patch.corners.iter().copied().chain(middle)
}
