//! The best combinations found so far.

/// Two qualities within this of each other, relatively, are a tie: a quality is computed in some
/// hundred operations, and each loses no more than the part's extent over a finger's lever.
const TIE: f64 = 4096.0 * f64::EPSILON;

/// The best placement on one combination of `K` edges, at the `place` of its kind.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate<const K: usize, P> {
    pub(super) edges: [usize; K],
    /// `sigma_min`, the same for all placements on these edges.
    pub(super) sigma_min: f64,
    /// `mu_eq`, the largest on these edges.
    pub(super) equivalent: f64,
    pub(super) place: P,
}

impl<const K: usize, P> Candidate<K, P> {
    pub(super) const fn quality(&self) -> f64 {
        self.sigma_min.min(self.equivalent)
    }
}

/// The combinations that may still be among the `top` best, or tie with the best.
#[derive(Clone, Debug)]
pub(super) struct Leaders<const K: usize, P> {
    top: usize,
    candidates: Vec<Candidate<K, P>>,
}

impl<const K: usize, P> Leaders<K, P> {
    pub(super) const fn new(top: usize) -> Self {
        Self { top, candidates: Vec::new() }
    }

    pub(super) fn best(&self) -> Option<f64> {
        self.candidates.first().map(Candidate::quality)
    }

    /// What a combination has to exceed to be among the leaders, or to tie with them.
    pub(super) fn floor(&self) -> f64 {
        self.candidates.get(self.top - 1).map_or(0.0, |last| below(last.quality()))
    }

    /// Takes in what a round found; the order of `round` does not matter.
    pub(super) fn merge(&mut self, round: Vec<Candidate<K, P>>) {
        self.candidates.extend(round);
        self.candidates.sort_by(|a, b| {
            b.quality().total_cmp(&a.quality()).then_with(|| a.edges.cmp(&b.edges))
        });
        let floor = self.floor();
        self.candidates.retain(|c| c.quality() > floor);
    }

    /// The leaders, best first, ties by larger equivalent stiffness; and how many others tie with
    /// the first.
    pub(super) fn finish(mut self) -> (Vec<Candidate<K, P>>, usize) {
        let tied = self.best().map_or(0.0, below);
        let ties = self.candidates.iter().take_while(|c| c.quality() > tied).count();
        let tied = &mut self.candidates[..ties];
        tied.sort_by(|a, b| b.equivalent.total_cmp(&a.equivalent));
        // Of those that tie in this as well, the lower edge numbers.
        let largest = tied.first().map_or(0.0, |c| below(c.equivalent));
        let twice = tied.iter().take_while(|c| c.equivalent > largest).count();
        tied[..twice].sort_by_key(|c| c.edges);
        self.candidates.truncate(self.top);
        (self.candidates, ties.saturating_sub(1))
    }
}

fn below(quality: f64) -> f64 {
    quality * (1.0 - TIE)
}
