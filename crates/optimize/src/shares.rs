//! How a preload can be shared so that it balances.

use clench_screw::Vector;

/// Shares are rounded by this many units, times how much smaller the wrenches' volume is than their
/// sizes.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A balanced preload.
#[derive(Clone, Debug)]
pub(crate) struct Shares {
    /// One for each wrench; they sum to 1.
    pub(crate) all: Vec<f64>,
    pub(crate) least: f64,
    /// How well they are known.
    pub(crate) rounding: f64,
}

/// A set of wrenches that span their space.
#[derive(Clone, Copy, Debug)]
struct Set<const D: usize> {
    numbers: [usize; D],
    /// Of the sum of all wrenches in the set.
    coordinates: [f64; D],
    /// What shares are divided by.
    total: f64,
    least: f64,
    rounding: f64,
}

/// The shares of the preload with which these unit wrenches balance, with the largest least share
/// where there is a choice; `None` where the wrenches do not span their space.
///
/// That is a linear program, and at a corner of what it allows all but `D` fingers have the least
/// share: so all sets of `D` are tried. With `a` the coordinates of the sum of all wrenches in a
/// set, the shares are `1 - a_i` on the set and 1 elsewhere, divided by their sum.
pub(crate) fn shares<const D: usize>(wrenches: &[Vector<D>]) -> Option<Shares> {
    let count = wrenches.len();
    let sum = wrenches.iter().fold(Vector::ZERO, |sum, &w| sum + w);
    let sizes: Vec<f64> = wrenches.iter().map(|w| w.norm()).collect();
    let mut best: Option<Set<D>> = None;
    let mut set: [usize; D] = std::array::from_fn(|i| i);
    if count < D {
        return None;
    }
    loop {
        if let Some((coordinates, volume)) = solve(set.map(|i| wrenches[i]), sum) {
            let total = count as f64 - coordinates.iter().sum::<f64>();
            let others = if count > D { 1.0 } else { f64::INFINITY };
            let ends = coordinates.iter().map(|a| (1.0 - a) / total);
            let least = ends.fold(others / total, f64::min);
            let size: f64 = set.iter().map(|&i| sizes[i]).product();
            let largest = coordinates.iter().fold(1.0_f64, |m, a| m.max(a.abs()));
            let rounding = ROUNDING * size * largest / (volume * total.abs());
            if total.abs() > 0.0
                && best.is_none_or(|best| least - rounding > best.least - best.rounding)
            {
                best = Some(Set { numbers: set, coordinates, total, least, rounding });
            }
        }
        if !next_set(&mut set, count) {
            break;
        }
    }
    let Set { numbers, coordinates, total, least, rounding } = best?;
    let mut all = vec![total.recip(); count];
    for (&i, a) in numbers.iter().zip(coordinates) {
        all[i] = (1.0 - a) / total;
    }
    Some(Shares { all, least, rounding })
}

/// The next set of `D` ascending numbers below `count`.
fn next_set<const D: usize>(set: &mut [usize; D], count: usize) -> bool {
    let Some(i) = (0..D).rev().find(|&i| set[i] + D < count + i) else { return false };
    set[i] += 1;
    for j in i + 1..D {
        set[j] = set[j - 1] + 1;
    }
    true
}

/// The coordinates of `target` in a basis, and the basis' volume; `None` if that is zero.
///
/// Gaussian elimination with row pivots.
fn solve<const D: usize>(basis: [Vector<D>; D], target: Vector<D>) -> Option<([f64; D], f64)> {
    let mut rows: [[f64; D]; D] = std::array::from_fn(|i| std::array::from_fn(|j| basis[j][i]));
    let mut right = target.to_array();
    let mut volume = 1.0;
    for p in 0..D {
        let pivot = (p..D).max_by(|&i, &j| rows[i][p].abs().total_cmp(&rows[j][p].abs()))?;
        rows.swap(p, pivot);
        right.swap(p, pivot);
        let row = rows[p];
        volume *= row[p].abs();
        if volume.is_nan() || volume <= 0.0 {
            return None;
        }
        for i in p + 1..D {
            let factor = rows[i][p] / row[p];
            for j in p + 1..D {
                rows[i][j] -= factor * row[j];
            }
            right[i] -= factor * right[p];
        }
    }
    for p in (0..D).rev() {
        let known: f64 = (p + 1..D).map(|j| rows[p][j] * right[j]).sum();
        right[p] = (right[p] - known) / rows[p][p];
    }
    Some((right, volume))
}
