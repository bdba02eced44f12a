//! The worst-point stiffness of planar grasps.

use clench_screw::{SymmetricEigen, Vector};
use clench_shape::Polygon;

use crate::{MetricsError, Principal};

/// Where a force moves its own point of attack most.
///
/// The compliance felt at a body point is convex in the point, so its largest eigenvalue is
/// largest at a corner of the convex hull. Its inverse is the least ratio of force to deflection
/// over all points and directions, never above the quality [`crate::Quality::value`] and never
/// below half of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstPoint {
    /// `Q_pt`, the least force per deflection (force / length).
    pub stiffness: f64,
    /// The corner where it is attained.
    pub corner: usize,
    /// The unit direction of the force, and of the deflection.
    pub direction: Vector<2>,
}

impl WorstPoint {
    /// The worst point of `body`, given in the frame of the principal parameters.
    ///
    /// # Errors
    ///
    /// [`MetricsError::NotFinite`] when a compliance overflows.
    pub fn of(principal: &Principal<2, 1>, body: &Polygon) -> Result<Self, MetricsError> {
        let mut worst = Self { stiffness: f64::INFINITY, corner: 0, direction: Vector::ZERO };
        for &corner in body.hull() {
            let compliance = principal.compliance_at(body.corners()[corner]);
            let eigen = SymmetricEigen::new(&compliance)?;
            let stiffness = eigen.values[1].recip();
            if stiffness < worst.stiffness {
                worst = Self { stiffness, corner, direction: eigen.vectors[1] };
            }
        }
        Ok(worst)
    }
}
