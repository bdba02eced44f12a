//! What a placement has to exceed to matter, and what bounds say of that.

use super::demand::{Demand, Verdict};

/// Two qualities within this of each other, relatively, are a tie: a quality is computed in some
/// hundred operations, and each loses no more than the part's extent over a finger's lever.
const TIE: f64 = 4096.0 * f64::EPSILON;

/// What a placement has to exceed to matter: a better quality, or as good a one, up to rounding,
/// and the same or a better second objective.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Floor {
    pub(crate) quality: f64,
    pub(crate) second: f64,
}

impl Floor {
    /// Exceeded by all there is.
    pub(crate) const NONE: Self = Self { quality: 0.0, second: 0.0 };

    pub(crate) fn is_exceeded_by(&self, quality: f64, second: f64) -> bool {
        quality > above(self.quality)
            || (quality > below(self.quality) && second > below(self.second))
    }
}

/// A little less: what is not below that is a tie.
pub(crate) fn below(quality: f64) -> f64 {
    quality * (1.0 - TIE)
}

/// A little more: what is above that is better.
pub(crate) fn above(quality: f64) -> f64 {
    quality * (1.0 + TIE)
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
