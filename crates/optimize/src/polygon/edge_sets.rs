//! The sets of edges that three or four fingers can close on, by number.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a first guess that is put right, and numbers of edges that exist"
)]

/// The multisets of four edges with at most one pair on one edge.
///
/// Three fingers on one edge, or two on each of two edges, never balance: their normals do not
/// positively span the plane, or only by leaving a finger without force.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeSets {
    distinct: u64,
    total: u64,
}

impl EdgeSets {
    /// `None` when there are more than can be counted.
    pub(super) fn of_edges(edges: usize) -> Option<Self> {
        let n = edges as u64;
        let distinct = choose(n, 4)?;
        let total = distinct.checked_add(choose(n, 3)?.checked_mul(3)?)?;
        Some(Self { distinct, total })
    }

    pub(super) const fn total(&self) -> u64 {
        self.total
    }

    /// Combination `number`, its edges ascending.
    pub(super) fn get(&self, number: u64) -> [usize; 4] {
        if number < self.distinct {
            return subset::<4>(number);
        }
        let rest = number - self.distinct;
        let [i, j, k] = subset::<3>(rest / 3);
        match rest % 3 {
            0 => [i, i, j, k],
            1 => [i, j, j, k],
            _ => [i, j, k, k],
        }
    }
}

/// Triplet `number` of different edges, ascending.
pub(super) fn triplet(number: u64) -> [usize; 3] {
    subset(number)
}

/// Subset `number` of size `K` in the combinatorial number system: the sum of
/// `choose(c_i, i + 1)` over its elements `c_0 < c_1 < ...`.
fn subset<const K: usize>(mut number: u64) -> [usize; K] {
    let mut elements = [0; K];
    for size in (1..=K as u64).rev() {
        let largest = largest_with_at_most(number, size);
        number -= choose(largest, size).unwrap_or(number);
        elements[size as usize - 1] = largest as usize;
    }
    elements
}

/// The largest `c` with `choose(c, size) <= number`.
fn largest_with_at_most(number: u64, size: u64) -> u64 {
    // A first guess, put right below.
    let scaled = number as f64 * FACTORIALS[size as usize] as f64;
    let root = match size {
        1 => scaled,
        2 => scaled.sqrt(),
        3 => scaled.cbrt(),
        _ => scaled.sqrt().sqrt(),
    };
    let mut c = root as u64;
    let at_most = |c: u64| choose(c, size).is_some_and(|count| count <= number);
    while at_most(c + 1) {
        c += 1;
    }
    while !at_most(c) {
        c -= 1;
    }
    c
}

/// How many subsets of `size` elements, at most 4, `n` elements have, if that can be counted.
pub(super) fn choose(n: u64, size: u64) -> Option<u64> {
    let factorial = FACTORIALS[size as usize];
    let factors = (0..size).map(|i| n.saturating_sub(i));
    // The usual case is counted without wide numbers: this is where a search spends its time.
    if n < 1 << 15 {
        return Some(factors.product::<u64>() / factorial);
    }
    let product = factors.map(u128::from).try_fold(1, u128::checked_mul)?;
    u64::try_from(product / u128::from(factorial)).ok()
}

const FACTORIALS: [u64; 5] = [1, 1, 2, 6, 24];

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn each_combination_has_one_number() {
        for edges in [3, 4, 7] {
            let sets = EdgeSets::of_edges(edges).unwrap();
            let found: BTreeSet<_> = (0..sets.total()).map(|i| sets.get(i)).collect();
            assert_eq!(found.len() as u64, sets.total());
            let mut expected = BTreeSet::new();
            for a in 0..edges {
                for b in a..edges {
                    for c in b..edges {
                        for d in c..edges {
                            let repeats = [a == b, b == c, c == d].iter().filter(|x| **x).count();
                            if repeats <= 1 {
                                expected.insert([a, b, c, d]);
                            }
                        }
                    }
                }
            }
            assert_eq!(found, expected);
        }
    }

    #[test]
    fn more_sets_than_can_be_counted_are_none() {
        assert!(EdgeSets::of_edges(100_000).is_some());
        assert!(EdgeSets::of_edges(1_000_000).is_none());
    }

    #[test]
    fn numbers_stay_exact_for_large_outlines() {
        let sets = EdgeSets::of_edges(20_000).unwrap();
        assert_eq!(sets.get(sets.total() - 1), [19_997, 19_998, 19_999, 19_999]);
        assert_eq!(sets.get(choose(20_000, 4).unwrap() - 1), [19_996, 19_997, 19_998, 19_999]);
    }
}
