//! The screws of LBR section 3.2, and the centers.

use clench_screw::{Axis, Mat, SymmetricEigen, Vector, lever, lever_center};

use crate::Principal;

impl<const N: usize, const M: usize> Principal<N, M> {
    /// The canonical point: the one about which `P_1` is symmetric.
    ///
    /// In the plane it is the center of compliance `d_b` [LBR, eq. 12], and there always is one.
    /// In space it is the center of compliance if any is, see [`Self::center_of_compliance`].
    #[must_use]
    pub fn center(&self) -> Vector<N> {
        self.origin() + lever_center(self.near_map())
    }

    /// What is left of `P_1` about the canonical point (length per rad): zero in the plane,
    /// symmetric in space.
    ///
    /// With this tensor `S`, the force-free rotation `omega` has the pitch `omega^T S omega`, and
    /// the rotation-free force `f` the pitch `-f^T S f`, both of unit length.
    #[must_use]
    pub fn pitch_tensor(&self) -> Mat<N, M> {
        *self.near_map() - lever(lever_center(self.near_map()))
    }

    /// The center of compliance, if there is one: the point about which forces cause translations
    /// only, and rotations need torques only.
    ///
    /// In space it exists only if [`Self::pitch_tensor`] is zero, which counts as such when it is
    /// nothing but rounding: of the arms of the contacts, or of the origin about which a given
    /// stiffness was formed.
    #[must_use]
    pub fn center_of_compliance(&self) -> Option<Vector<N>> {
        let exists = self.pitch_tensor().max_abs() <= self.map_rounding();
        exists.then(|| self.center())
    }

    /// The twist-compliant axes: those of the force-free twists about the principal rotational
    /// directions [LBR, section 3.2]. A pure couple about such an axis, `mu_i` per rad, turns the
    /// body about it, with its pitch. In the plane there is one, along z through the center of
    /// compliance.
    #[must_use]
    pub fn twist_axes(&self) -> [Axis; M] {
        let map = *self.near_map();
        let axis = |rotation| self.axis_along(rotation, (map * rotation).in_space());
        self.rotational().vectors.map(axis)
    }

    /// The wrench-compliant axes: those of the rotation-free wrenches along the principal
    /// translational directions [LBR, section 3.2]. Such a wrench moves the body along the axis,
    /// by `1 / sigma_i` per force, and does not turn it. In the plane they go through the center of
    /// compliance.
    #[must_use]
    pub fn wrench_axes(&self) -> [Axis; N] {
        let map = self.near_map().transpose();
        let axis = |force| self.axis_along(force, -(map * force).in_space());
        self.translational().vectors.map(axis)
    }

    /// The axis along a unit direction with the given `moment` about the origin of the computation,
    /// near the body, seen from the frame's origin.
    fn axis_along<const D: usize>(&self, direction: Vector<D>, moment: Vector<3>) -> Axis {
        let near = Axis::new(direction.in_space(), moment);
        let origin = self.origin().in_space();
        let across = origin - near.direction * near.direction.dot(origin);
        Axis { point: near.point + across, ..near }
    }
}

impl Principal<3, 3> {
    /// The center of stiffness by Loncaric: the point about which `K_12` is symmetric.
    ///
    /// Not the canonical point and not the center of compliance: all three are one point only where
    /// there is a center of compliance [`Self::center_of_compliance`].
    #[must_use]
    pub fn loncaric_center_of_stiffness(&self) -> Vector<3> {
        // About any point K_12 = -K_11 P_1, and (tr K_11 - K_11) c = -2 vee skew K_12 from there.
        let sigma = self.translational();
        let stiffness = sigma.map(|value| value);
        let skew = lever_center(&(stiffness * *self.near_map()));
        self.origin() + solved(sigma, |value| value, skew * 2.0)
    }

    /// The center of compliance by Loncaric: the point about which `C_12` is symmetric.
    ///
    /// It always exists, unlike [`Self::center_of_compliance`], about which `C_12` is zero.
    #[must_use]
    pub fn loncaric_center_of_compliance(&self) -> Vector<3> {
        // About any point C_12 = P_1 C_22, and (tr C_22 - C_22) c = 2 vee skew C_12 from there.
        let mu = self.rotational();
        let skew = lever_center(&(*self.near_map() * self.rotational_compliance()));
        self.origin() + solved(mu, f64::recip, skew * 2.0)
    }
}

/// The solution `x` of `(tr A - A) x = b` for the matrix `A` with the given function of the
/// eigenvalues: each denominator is the sum of the other two.
fn solved(eigen: &SymmetricEigen<3>, value: impl Fn(f64) -> f64, b: Vector<3>) -> Vector<3> {
    (0..3).fold(Vector::ZERO, |sum, i| {
        let others = value(eigen.values[(i + 1) % 3]) + value(eigen.values[(i + 2) % 3]);
        let along = eigen.vectors[i];
        sum + along * (along.dot(b) / others)
    })
}
