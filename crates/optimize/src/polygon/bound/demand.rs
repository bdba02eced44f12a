//! What a placement has to reach to matter.

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

/// What is known of the placements on a node that meet a demand.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Verdict {
    /// None of them surpasses the demand by more.
    pub(crate) surplus: f64,
    /// The finger whose piece to halve.
    pub(crate) split: usize,
}
