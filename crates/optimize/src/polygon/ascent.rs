//! Good placements to begin with, by trial and by ascent.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "numbers of stretches, from parts of 1"
)]

use rayon::prelude::*;

use crate::polygon::rating::Spot;

/// How many trial placements are rated, and how many of them climb.
const TRIALS: usize = 128;
const CLIMBERS: usize = 3;

/// Steps along stretches end at this part of their length: what is gained by less is a rounding of
/// the square of it, where a maximum is smooth.
const SHORTEST_STEP: f64 = 1.0 / (1_u64 << 26) as f64;

/// A step that gains less than this part is followed by shorter ones.
const SMALLEST_GAIN: f64 = 1e-6;

/// The first step of a climb goes this part of the boundary.
const FIRST_PART: usize = 8;

/// Climbs over up to this many stretches are shorter than it takes to wake other threads.
const FEW_STRETCHES: usize = 64;

/// Square roots of primes, whose multiples spread evenly.
const ROOTS: [f64; 8] = [
    std::f64::consts::SQRT_2,
    1.732_050_807_568_877_2,
    2.236_067_977_499_79,
    2.645_751_311_064_590_6,
    3.316_624_790_355_4,
    3.605_551_275_463_989,
    4.123_105_625_617_661,
    4.358_898_943_540_674,
];

/// The highest placements that ascents arrive at, best first, with their ratings. `rate` is given a
/// floor, need not answer for what is not above it, and may mend a placement.
pub(crate) fn ascents<const K: usize>(
    stretches: usize,
    rate: impl Fn(&[Spot; K], f64) -> Option<(f64, [Spot; K])> + Sync,
    fine: bool,
) -> Vec<(f64, [Spot; K])> {
    let mut climbers: Vec<(f64, [Spot; K])> = Vec::new();
    for j in 1..=TRIALS {
        let spots = trial(j, stretches);
        let floor = climbers.get(CLIMBERS - 1).map_or(0.0, |last| last.0);
        if let Some(rated) = rate(&spots, floor) {
            climbers.push(rated);
            climbers.sort_by(|a, b| b.0.total_cmp(&a.0));
            climbers.truncate(CLIMBERS);
        }
    }
    let up = |from| climb(stretches, &rate, from, stretches / FIRST_PART, fine);
    let mut tops: Vec<_> = if fine || stretches > FEW_STRETCHES {
        climbers.into_par_iter().map(up).collect()
    } else {
        climbers.into_iter().map(up).collect()
    };
    tops.sort_by(|a, b| b.0.total_cmp(&a.0));
    tops
}

fn trial<const K: usize>(j: usize, stretches: usize) -> [Spot; K] {
    std::array::from_fn(|i| {
        let place = (j as f64 * ROOTS[i % ROOTS.len()]).fract() * stretches as f64;
        Spot { stretch: (place as usize).min(stretches - 1), along: place.fract().round() }
    })
}

/// The best placement that single fingers and pairs of them reach, with shrinking steps.
pub(crate) fn climb<const K: usize>(
    stretches: usize,
    rate: &impl Fn(&[Spot; K], f64) -> Option<(f64, [Spot; K])>,
    (mut best, mut at): (f64, [Spot; K]),
    first_step: usize,
    fine: bool,
) -> (f64, [Spot; K]) {
    let mut step = Step::Stretches(first_step.max(1));
    loop {
        let mut found = (best, at);
        let mut consider = |next: [Spot; K]| {
            if let Some(rated) = rate(&next, found.0).filter(|rated| rated.0 > found.0) {
                found = rated;
            }
        };
        for i in 0..K {
            for to in step.neighbors(at[i], stretches) {
                let mut next = at;
                next[i] = to;
                consider(next);
                if !step.is_coarse() {
                    for j in 0..i {
                        for to in step.neighbors(at[j], stretches) {
                            let mut pair = next;
                            pair[j] = to;
                            consider(pair);
                        }
                    }
                }
            }
        }
        // On a ridge each step gains something: shorter ones gain more than many of this length.
        let gains = found.0 > best * (1.0 + SMALLEST_GAIN);
        (best, at) = found;
        if gains {
            continue;
        }
        if let Some(shorter) = step.shorter(fine) {
            step = shorter;
        } else {
            return (best, at);
        }
    }
}

/// How far a finger moves at a time.
#[derive(Clone, Copy, Debug)]
enum Step {
    /// By this many stretches, which are taken as going round.
    Stretches(usize),
    /// By this part of its stretch.
    Along(f64),
}

impl Step {
    const fn is_coarse(self) -> bool {
        matches!(self, Self::Stretches(step) if step > 1)
    }

    fn neighbors(self, at: Spot, stretches: usize) -> [Spot; 2] {
        match self {
            Self::Stretches(step) => [step, stretches - step % stretches]
                .map(|by| Spot { stretch: (at.stretch + by) % stretches, ..at }),
            Self::Along(step) => {
                [step, -step].map(|by| Spot { along: (at.along + by).clamp(0.0, 1.0), ..at })
            }
        }
    }

    fn shorter(self, fine: bool) -> Option<Self> {
        match self {
            Self::Stretches(1) => Some(Self::Along(1.0)),
            Self::Stretches(step) => Some(Self::Stretches(step / 2)),
            Self::Along(step) if fine && step > SHORTEST_STEP => Some(Self::Along(0.5 * step)),
            Self::Along(_) => None,
        }
    }
}
