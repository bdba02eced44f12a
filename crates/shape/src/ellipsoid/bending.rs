//! How the curvature of an ellipsoid changes along its boundary.

use clench_screw::{Mat, Vector};

use super::{Ellipsoid, across};
use crate::BoundaryPoint;

impl<const N: usize> Ellipsoid<N> {
    /// The rate of the shape operator at the boundary point `at` of this body, when that point
    /// moves along the boundary with the velocity `along`: 1 / length^2 for one of unit length.
    ///
    /// With the outward normal `m`, which turns by `L along`, `A = diag(a^2)`, `h = |diag(a) m|`
    /// and `P = I - m m^T`, it is the derivative of `L = h P A^-1 P`. What of `along` is along
    /// the normal does not count.
    ///
    /// ```
    /// use clench_shape::Ellipsoid;
    /// // At the tip of an ellipse the curvature is largest, so that it does not change, but the
    /// // tangent that it belongs to turns with it: by the curvature 2.
    /// let ellipse = Ellipsoid::new([0.0, 0.0].into(), [2.0, 1.0])?;
    /// let tip = ellipse.at_normal([1.0, 0.0].into())?;
    /// let rate = ellipse.shape_operator_rate(&tip, [0.0, 1.0].into());
    /// assert_eq!((rate[1][1], rate[0][1]), (0.0, -4.0));
    /// # Ok::<(), clench_shape::EllipsoidError>(())
    /// ```
    #[must_use]
    pub fn shape_operator_rate(&self, at: &BoundaryPoint<N>, along: Vector<N>) -> Mat<N, N> {
        let axes = &self.axes;
        let m = -(axes.transpose() * at.inward_normal);
        let turning = axes.transpose() * (at.shape_operator * along);
        let stretched = Vector::<N>::from_fn(|i| self.semi_axes[i] * m[i]);
        let h = stretched.scaled_norm();
        let growth =
            (0..N).map(|i| self.semi_axes[i] * turning[i] * (stretched[i] / h)).sum::<f64>();
        let plane = across(m);
        let outer = Mat::outer(turning, m);
        let plane_rate = (outer + outer.transpose()) * -1.0;
        // h A^-1, without squares that leave the range of numbers.
        let weights = self.semi_axes.map(|a| h / a / a);
        let weighted = Mat::from_fn(|i, j| weights[i] * plane[i][j]);
        let half = plane_rate * weighted;
        let local = plane * weighted * (growth / h) + half + half.transpose();
        (*axes * local * axes.transpose()).symmetric_part()
    }
}
