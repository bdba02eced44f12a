//! The combinations of edges that four fingers can close on, by number.

/// The multisets of four edges with at most one pair on one edge.
///
/// Three fingers on one edge, or two on each of two edges, never balance: their normals do not
/// positively span the plane, or only by leaving a finger without force.
#[derive(Clone, Copy, Debug)]
pub(super) struct Combinations {
    distinct: u64,
    total: u64,
}

impl Combinations {
    pub(super) fn of_edges(edges: usize) -> Self {
        let n = edges as u64;
        let distinct = choose::<4>(n);
        Self { distinct, total: distinct + 3 * choose::<3>(n) }
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

/// Subset `number` of size `K` in the combinatorial number system: the sum of
/// `choose(c_i, i + 1)` over its elements `c_0 < c_1 < ...`.
fn subset<const K: usize>(mut number: u64) -> [usize; K] {
    let mut elements = [0; K];
    for size in (1..=K).rev() {
        let largest = largest_with_at_most(number, size);
        number -= choose_dynamic(largest, size);
        elements[size - 1] = usize::try_from(largest).unwrap_or(usize::MAX);
    }
    elements
}

/// The largest `c` with `choose(c, size) <= number`.
fn largest_with_at_most(number: u64, size: usize) -> u64 {
    let factorial: f64 = (1..=size).map(|i| i as f64).product();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "a first guess, put right below"
    )]
    let mut c = (number as f64 * factorial).powf((size as f64).recip()) as u64;
    while choose_dynamic(c + 1, size) <= number {
        c += 1;
    }
    while choose_dynamic(c, size) > number {
        c -= 1;
    }
    c
}

fn choose<const K: usize>(n: u64) -> u64 {
    choose_dynamic(n, K)
}

fn choose_dynamic(n: u64, k: usize) -> u64 {
    (0..k as u64).fold(1, |product, i| product * n.saturating_sub(i) / (i + 1))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn each_combination_has_one_number() {
        for edges in [3, 4, 7] {
            let combinations = Combinations::of_edges(edges);
            let found: BTreeSet<_> =
                (0..combinations.total()).map(|i| combinations.get(i)).collect();
            assert_eq!(found.len() as u64, combinations.total());
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
    fn numbers_stay_exact_for_large_outlines() {
        let combinations = Combinations::of_edges(20_000);
        assert_eq!(combinations.get(combinations.total() - 1), [19_997, 19_998, 19_999, 19_999]);
        assert_eq!(combinations.get(choose::<4>(20_000) - 1), [19_996, 19_997, 19_998, 19_999]);
    }
}
