//! What a placement has to reach to matter, and what that says of its quality.

use crate::polygon::search::{Floor, above, below};

/// What a placement has to reach to matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Demand {
    /// Of `sigma_min`.
    pub(crate) translation: f64,
    /// Of `mu_eq`.
    pub(crate) rotation: f64,
    /// Whether `sigma_min` counts only as a condition, and not in what is maximized.
    pub(crate) fixed_translation: bool,
    /// Of `Q_pt`; 0 where that does not count.
    pub(crate) worst_point: f64,
}

impl Demand {
    /// A quality of `q`.
    pub(crate) const fn both(q: f64) -> Self {
        Self { translation: q, rotation: q, fixed_translation: false, worst_point: 0.0 }
    }

    /// A worst-point stiffness of `q`, which no placement of less quality has.
    pub(crate) const fn worst_point(q: f64) -> Self {
        Self { worst_point: q, ..Self::both(q) }
    }
}

impl Floor {
    /// The bound of the qualities that exceed the floor, from a verdict on what that demands.
    pub(crate) fn bound(
        &self,
        verdict: impl Fn(&Demand) -> Option<Verdict>,
    ) -> Option<(f64, usize)> {
        let tie = below(self.quality);
        if self.second <= above(self.quality) {
            return verdict(&Demand::both(tie)).map(|v| (tie + v.surplus, v.split));
        }
        // Translation limits the best: what is better, or as good and better in rotation.
        let better = above(self.quality);
        if let Some(v) = verdict(&Demand::both(better)) {
            return Some((better + v.surplus, v.split));
        }
        let demand = Demand { rotation: below(self.second), ..Demand::both(tie) };
        verdict(&demand).map(|v| (better, v.split))
    }
}

impl Floor {
    /// The same for `mu_eq` where `sigma_min` has to be at least `translation`, and is what counts
    /// among ties.
    pub(crate) fn rotation_bound(
        &self,
        translation: f64,
        verdict: impl Fn(&Demand) -> Option<Verdict>,
    ) -> Option<(f64, usize)> {
        let demand = |translation, rotation| Demand {
            translation,
            fixed_translation: true,
            ..Demand::both(rotation)
        };
        let better = above(self.quality);
        if let Some(v) = verdict(&demand(translation, better)) {
            return Some((better + v.surplus, v.split));
        }
        let tied = demand(translation.max(below(self.second)), below(self.quality));
        verdict(&tied).map(|v| (better, v.split))
    }
}

/// What is known of the placements on a node that meet a demand.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Verdict {
    /// None of them surpasses the demand by more.
    pub(crate) surplus: f64,
    /// The finger whose piece to halve.
    pub(crate) split: usize,
}
