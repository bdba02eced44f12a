//! The quality measure of planar grasps.

use clench_shape::{Polygon, Reach};

use crate::Principal;

/// Which principal stiffness is the smallest, made comparable by the body's reach.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitedBy {
    /// `sigma_min`.
    Translation,
    /// `mu_eq`.
    Rotation,
}

/// The frame-invariant quality of a planar grasp [LBR, eqs. 13 and 14].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// `Q = min(sigma_min, mu_eq)` (force / length): the worst characteristic stiffness.
    pub value: f64,
    /// Which of the two it is.
    pub limited_by: LimitedBy,
    /// `sigma_min`, the smallest principal translational stiffness (force / length).
    pub translational: f64,
    /// `mu_eq = mu / rho_max^2`, the equivalent stiffness (force / length).
    pub equivalent: f64,
    /// The corner farthest from the center of compliance, and its distance `rho_max`.
    pub reach: Reach,
}

impl Quality {
    /// The quality of a grasp of `body`, both given in one frame.
    #[must_use]
    pub fn of(principal: &Principal<2, 1>, body: &Polygon) -> Self {
        let reach = body.farthest(principal.center());
        let translational = principal.translational().values[0];
        let equivalent = principal.rotational().values[0] / (reach.distance * reach.distance);
        let (value, limited_by) = if translational <= equivalent {
            (translational, LimitedBy::Translation)
        } else {
            (equivalent, LimitedBy::Rotation)
        };
        Self { value, limited_by, translational, equivalent, reach }
    }
}
