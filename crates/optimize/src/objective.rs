//! What is maximized.

use crate::OptimizeError;

/// What is maximized.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Objective {
    /// The quality `Q = min(sigma_min, mu_eq)` [LBR, eqs. 14 and 16]. In space it jumps where
    /// rotational stiffnesses come to be equal, which the others do not, and its bound on solids
    /// need not close: it is limited by translation and by a cylinder around the body.
    Quality,
    /// The worst-point stiffness `Q_pt`: the least ratio of a force to the deflection of the point
    /// that it acts on, over all points of the part. At most the quality; in the plane at least
    /// half of it, in space at least a sixth.
    WorstPoint,
    /// The least equivalent stiffness of all rotations, `Q_V`, in the plane `mu_eq`, among the
    /// placements whose least translational stiffness `sigma_min` is at least this
    /// (force / length).
    Rotation {
        /// The condition.
        least_translation: f64,
    },
}

impl Objective {
    pub(crate) fn checked(self) -> Result<(), OptimizeError> {
        let value = self.least_translation();
        if value >= 0.0 && value.is_finite() {
            Ok(())
        } else {
            Err(OptimizeError::LeastTranslation { value })
        }
    }

    /// The least `sigma_min` that is asked for (force / length).
    pub(crate) const fn least_translation(self) -> f64 {
        match self {
            Self::Rotation { least_translation } => least_translation,
            Self::Quality | Self::WorstPoint => 0.0,
        }
    }
}
