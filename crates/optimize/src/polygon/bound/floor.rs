//! What has to be demanded of a placement that exceeds a floor.

use super::demand::{Demand, Verdict};
use crate::search::{Floor, above, below};

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
