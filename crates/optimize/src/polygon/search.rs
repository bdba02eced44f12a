//! The search over all sets of edges, for any number of fingers.

use std::num::NonZeroUsize;

use rayon::prelude::*;

use super::leaders::{Candidate, Leaders};
use crate::{Certificate, Combinations, OptimizeError, Outcome, Progress, Solution};

/// Sets in the first round; each further round has twice as many, up to the last.
const FIRST_ROUND: u64 = 256;

/// Sets in the largest round: some tens of milliseconds of work.
const LARGEST_ROUND: u64 = 1 << 17;

/// The visiting order strides through all sets by about this part of their number (the golden
/// section), so that early rounds see edges from everywhere.
const STRIDE: f64 = 0.618_033_988_749_894_9;

/// What became of one set of edges.
pub(super) enum Verdict<const K: usize, P> {
    /// Its normals cannot balance, or its stiffness bounds it below the floor.
    Skipped,
    /// Its normals can balance, but a bound excludes it.
    Excluded,
    /// It was solved; `None` when it does not exceed the floor.
    Examined(Option<Candidate<K, P>>),
}

/// Looks at all sets `0..total`, and returns the best `top`.
///
/// `examine` is given a set's number and the floor: the quality that it has to exceed to matter.
/// The floor of a round is what the rounds before it found, so neither the outcome nor the count
/// of examined sets depends on the threads. `confirm` turns a leader into a solution.
///
/// # Errors
///
/// [`OptimizeError::NormalsNeverBalance`] or [`OptimizeError::TorquesNeverBalance`] when no set
/// holds the part, and the errors of `confirm`.
pub(super) fn search<const K: usize, P: Send>(
    total: u64,
    top: NonZeroUsize,
    examine: impl Fn(u64, f64) -> Verdict<K, P> + Sync,
    confirm: impl Fn(&Candidate<K, P>) -> Result<Solution, OptimizeError>,
    mut watch: impl FnMut(&Progress),
) -> Result<Outcome, OptimizeError> {
    let stride = coprime_stride(total);
    let mut leaders = Leaders::new(top.get());
    let (mut settled, mut round, mut tally) = (0, FIRST_ROUND, Tally::default());
    while settled < total {
        let end = total.min(settled + round);
        let floor = leaders.floor();
        let (candidates, seen) = (settled..end)
            .into_par_iter()
            .map(|i| examine(position(i, stride, total), floor))
            .fold(Default::default, collect)
            .reduce(Default::default, |(mut a, x), (b, y)| {
                a.extend(b);
                (a, x.plus(y))
            });
        leaders.merge(candidates);
        tally = tally.plus(seen);
        settled = end;
        round = (2 * round).min(LARGEST_ROUND);
        watch(&Progress { settled, total, best: leaders.best() });
    }
    // The leaders' own numbers pruned the others: the bound is theirs if it is larger by rounding.
    let upper_bound = leaders.best().unwrap_or(0.0);
    let (leaders, ties) = leaders.finish();
    let (first, rest) = leaders.split_first().ok_or_else(|| tally.no_placement(K, total))?;
    let best = confirm(first)?;
    // A lesser set whose stiffness is lost in rounding is no alternative.
    let others = rest.iter().filter_map(|candidate| confirm(candidate).ok()).collect();
    Ok(Outcome {
        ties,
        certificate: Certificate { upper_bound: upper_bound.max(best.quality.value) },
        combinations: Combinations { total, examined: tally.examined },
        best,
        others,
    })
}

/// How many sets were solved, and how many have normals that can balance.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    examined: u64,
    spanning: u64,
}

impl Tally {
    const fn plus(self, other: Self) -> Self {
        Self { examined: self.examined + other.examined, spanning: self.spanning + other.spanning }
    }

    const fn no_placement(self, fingers: usize, combinations: u64) -> OptimizeError {
        match self.spanning {
            0 => OptimizeError::NormalsNeverBalance { fingers, combinations },
            spanning => OptimizeError::TorquesNeverBalance { fingers, combinations, spanning },
        }
    }
}

fn collect<const K: usize, P>(
    (mut candidates, mut tally): (Vec<Candidate<K, P>>, Tally),
    verdict: Verdict<K, P>,
) -> (Vec<Candidate<K, P>>, Tally) {
    match verdict {
        Verdict::Skipped => {}
        Verdict::Excluded => tally.spanning += 1,
        Verdict::Examined(candidate) => {
            tally.spanning += 1;
            tally.examined += 1;
            candidates.extend(candidate);
        }
    }
    (candidates, tally)
}

/// A stride near the golden section of `total` that visits each number once.
fn coprime_stride(total: u64) -> u64 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "any stride will do that is put right below"
    )]
    let mut stride = (total as f64 * STRIDE) as u64;
    while stride < total && gcd(stride, total) != 1 {
        stride += 1;
    }
    stride.max(1)
}

const fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The `i`-th of `total` numbers in the visiting order.
fn position(i: u64, stride: u64, total: u64) -> u64 {
    let wide = u128::from(i) * u128::from(stride) % u128::from(total);
    // A remainder of a 64-bit number fits.
    u64::try_from(wide).unwrap_or(i)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_visiting_order_visits_each_number_once() {
        for total in [1, 2, 12, 30, 1155] {
            let stride = coprime_stride(total);
            let mut seen: Vec<u64> = (0..total).map(|i| position(i, stride, total)).collect();
            seen.sort_unstable();
            assert_eq!(seen, (0..total).collect::<Vec<_>>());
        }
    }
}
