//! What a placement has to exceed to matter.

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
