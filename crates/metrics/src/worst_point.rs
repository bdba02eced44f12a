//! The worst-point stiffness.

use clench_screw::Vector;
use clench_shape::Extent;

use crate::softness::{Softest, Softness};
use crate::{MetricsError, Principal};

/// Where a force moves its own point of attack most.
///
/// The compliance felt at a body point, `C_x = C_W + X K_V^-1 X^T` with `X = P_1 - lever(x)`, is
/// convex in the point, so its largest eigenvalue is largest at a corner of the convex hull. Its
/// inverse is the least ratio of force to deflection over all points and directions, also for the
/// deflection of other points than the one where the force acts. It is never above
/// `min(sigma_min, Q_V)`, and so not above the quality, and never below half of that minimum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstPoint<const N: usize> {
    /// `Q_pt`, the least force per deflection (force / length).
    pub stiffness: f64,
    /// A proved lower bound for all points and directions: the stiffness itself, but on an
    /// ellipsoid what a search could prove. Where the softest directions form a circle, as in
    /// grasps alike in all directions, that is up to 0.4 % less.
    pub at_least: f64,
    /// The point where it is attained.
    pub point: Vector<N>,
    /// Its number among the corners or vertices of the body; an ellipsoid has none.
    pub corner: Option<usize>,
    /// The unit direction of the force, and of the deflection.
    pub direction: Vector<N>,
}

impl<const N: usize> WorstPoint<N> {
    /// The worst point of `body`, given in the frame of the principal parameters.
    ///
    /// Cost: that of a search over extreme points; on an ellipsoid of up to thousands of
    /// decompositions, about a millisecond.
    ///
    /// # Errors
    ///
    /// [`MetricsError::OutOfRange`] when sizes are so unlike that numbers overflow.
    pub fn of<'a, const M: usize>(
        principal: &Principal<N, M>,
        body: impl Into<Extent<'a, N>>,
    ) -> Result<Self, MetricsError> {
        let softest = Softness::whole(principal).largest(body.into())?;
        let Softest { point, corner, direction, compliance, bound } = softest;
        let (stiffness, at_least) = (compliance.recip(), bound.recip());
        if !(stiffness > 0.0 && stiffness.is_finite()) {
            return Err(MetricsError::OutOfRange { stiffness, deflection: compliance });
        }
        Ok(Self { stiffness, at_least, point, corner, direction })
    }
}
