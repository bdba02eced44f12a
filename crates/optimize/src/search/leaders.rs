//! The best combinations found so far.

use super::floor::{Floor, below};

/// The best placement on one combination of `K` stretches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidate<const K: usize, P> {
    pub(crate) stretches: [usize; K],
    /// What is maximized.
    pub(crate) quality: f64,
    /// What is maximized among ties.
    pub(crate) second: f64,
    pub(crate) place: P,
}

/// The `top` best combinations.
#[derive(Clone, Debug)]
pub(crate) struct Leaders<const K: usize, P> {
    top: usize,
    candidates: Vec<Candidate<K, P>>,
}

impl<const K: usize, P> Leaders<K, P> {
    pub(crate) const fn new(top: usize) -> Self {
        Self { top, candidates: Vec::new() }
    }

    /// Best first; among ties the larger second objective, then the lower numbers.
    pub(crate) fn candidates(&self) -> &[Candidate<K, P>] {
        &self.candidates
    }

    pub(crate) fn best(&self) -> Option<f64> {
        self.candidates.iter().map(|c| c.quality).max_by(f64::total_cmp)
    }

    /// What a combination has to exceed to be among the leaders.
    pub(crate) fn floor(&self) -> Floor {
        let last = self.candidates.get(self.top - 1);
        last.map_or(Floor::NONE, |last| Floor { quality: last.quality, second: last.second })
    }

    /// The one on these stretches.
    pub(crate) fn on(&self, stretches: [usize; K]) -> Option<Floor> {
        let leader = self.candidates.iter().find(|c| c.stretches == stretches)?;
        Some(Floor { quality: leader.quality, second: leader.second })
    }

    /// Takes in what a round found; the order of `round` does not matter.
    pub(crate) fn merge(&mut self, round: impl IntoIterator<Item = Candidate<K, P>>) {
        let count = self.candidates.len();
        self.candidates.extend(round);
        if self.candidates.len() == count {
            return;
        }
        // Of one combination, the best placement.
        self.candidates.sort_by(|a, b| {
            let better = b.quality.total_cmp(&a.quality);
            a.stretches.cmp(&b.stretches).then(better).then(b.second.total_cmp(&a.second))
        });
        self.candidates.dedup_by_key(|c| c.stretches);
        sort_with_ties(
            &mut self.candidates,
            |c| c.quality,
            |tied| {
                sort_with_ties(tied, |c| c.second, |tied| tied.sort_by_key(|c| c.stretches));
            },
        );
        self.candidates.truncate(self.top);
    }
}

/// Sorts by descending `key`, and then each group that ties with its largest by `arrange`.
fn sort_with_ties<T>(items: &mut [T], key: impl Fn(&T) -> f64, arrange: impl Fn(&mut [T])) {
    items.sort_by(|a, b| key(b).total_cmp(&key(a)));
    let mut rest = items;
    while let Some(first) = rest.first() {
        let tied = below(key(first));
        let count = rest.iter().take_while(|item| key(item) >= tied).count().max(1);
        let (group, others) = rest.split_at_mut(count);
        arrange(group);
        rest = others;
    }
}
