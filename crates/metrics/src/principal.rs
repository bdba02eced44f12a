//! The principal stiffness parameters of LBR section 3.

use clench_screw::{Axis, Mat, Stiffness, SymmetricEigen, Twist, Vector, lever, lever_center};

use crate::MetricsError;

/// A principal stiffness below this many units of rounding of its scale counts as zero: each
/// block of a stiffness sums one product per contact, of arms that are themselves differences.
const ZERO_STIFFNESS: f64 = 64.0 * f64::EPSILON;

/// The principal stiffness parameters: what remains of a stiffness when the frame is taken away.
///
/// With the blocks `K_11`, `K_12`, `K_22` [LBR, eq. 8]: the principal translational stiffnesses
/// are the eigenvalues of `K_11 = C_W^-1`, the principal rotational ones those of
/// `K_V = K_22 - K_12^T K_11^-1 K_12` [LBR, eqs. 9 to 11]. Directions and points are those of the
/// frame in which the stiffness is written, along its axes and from its origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Principal<const N: usize, const M: usize> {
    origin: Vector<N>,
    translational: SymmetricEigen<N>,
    rotational: SymmetricEigen<M>,
    restricted: Mat<M, M>,
    /// `P_1 = -K_11^-1 K_12` about `origin`: the translation that goes with a rotation.
    twist_map: Mat<N, M>,
}

impl<const N: usize, const M: usize> Principal<N, M> {
    /// The parameters of a `stiffness` written about `origin`.
    ///
    /// They are as good as the stiffness: about an origin `d` body lengths away from the body it
    /// has lost about `d^2` units of rounding already. [`Self::near`] avoids that.
    ///
    /// # Errors
    ///
    /// [`MetricsError`] names what is not held, when the stiffness is not positive definite.
    pub fn of(origin: Vector<N>, stiffness: &Stiffness<N, M>) -> Result<Self, MetricsError> {
        let scale = stiffness.rotational.trace().abs();
        Self::scaled(origin, stiffness, translational(stiffness)?, scale)
    }

    /// The parameters of the stiffness that `stiffness_about` forms about any origin.
    ///
    /// In two passes: about `start`, which has to be near the body, for the center of compliance;
    /// then about that center, where the blocks decouple and nothing cancels.
    ///
    /// # Errors
    ///
    /// Those of [`Self::of`].
    pub fn near(
        start: Vector<N>,
        stiffness_about: impl Fn(Vector<N>) -> Stiffness<N, M>,
    ) -> Result<Self, MetricsError> {
        let rough = stiffness_about(start);
        let translational = translational(&rough)?;
        let center = start + lever_center(&twist_map(&translational, &rough));
        // The translational block is the same about every origin.
        Self::scaled(
            center,
            &stiffness_about(center),
            translational,
            rough.rotational.trace().abs(),
        )
    }

    fn scaled(
        origin: Vector<N>,
        stiffness: &Stiffness<N, M>,
        translational: SymmetricEigen<N>,
        scale: f64,
    ) -> Result<Self, MetricsError> {
        let twist_map = twist_map(&translational, stiffness);
        let restricted = stiffness.rotational + stiffness.coupling.transpose() * twist_map;
        let rotational = SymmetricEigen::new(&restricted)?;
        let principal = Self { origin, translational, rotational, restricted, twist_map };
        let value = rotational.values[0];
        if value > ZERO_STIFFNESS * scale {
            return Ok(principal);
        }
        let Axis { direction, point, pitch } = principal.axis_of(0);
        let (axis, point) = (direction.to_array(), point.to_array());
        Err(MetricsError::RotationNotHeld { axis, point, pitch, value, scale })
    }

    /// The principal translational stiffnesses `sigma_i` (force / length), ascending, and their
    /// directions; `values[0]` is `sigma_min`.
    #[must_use]
    pub const fn translational(&self) -> &SymmetricEigen<N> {
        &self.translational
    }

    /// The principal rotational stiffnesses `mu_i` (force * length), ascending, and their
    /// directions.
    #[must_use]
    pub const fn rotational(&self) -> &SymmetricEigen<M> {
        &self.rotational
    }

    /// `K_V`, the stiffness felt by rotations that need no force [LBR, eq. 10].
    #[must_use]
    pub const fn restricted_stiffness(&self) -> &Mat<M, M> {
        &self.restricted
    }

    /// `C_W = K_11^-1`, the compliance felt by forces that cause no rotation (length / force).
    #[must_use]
    pub fn translational_compliance(&self) -> Mat<N, N> {
        inverse(&self.translational)
    }

    /// The center of compliance `d_b` of the plane [LBR, eq. 12]; in space the one point about
    /// which `P_1` is symmetric, which is a center of compliance if any is.
    #[must_use]
    pub fn center(&self) -> Vector<N> {
        self.origin + lever_center(&self.twist_map)
    }

    /// The twist, about the frame's origin, that turns by `rotation` and needs no force: the
    /// element `P omega` of `V` [LBR, eq. 9].
    #[must_use]
    pub fn forceless_twist(&self, rotation: Vector<M>) -> Twist<N, M> {
        let map = self.twist_map + lever(self.origin);
        Twist { linear: map * rotation, angular: rotation }
    }

    /// The twist-compliant axes: those of the forceless twists about the principal rotational
    /// directions [LBR, section 3.2]. In the plane there is one, along z through the center of
    /// compliance.
    #[must_use]
    pub fn twist_axes(&self) -> [Axis; M] {
        std::array::from_fn(|i| self.axis_of(i))
    }

    /// The axis of principal rotation `i`, from the frame's origin; its moment is taken near the
    /// body, where nothing cancels.
    fn axis_of(&self, i: usize) -> Axis {
        let center = self.center();
        let rotation = self.rotational.vectors[i];
        let about = self.twist_map - lever(center - self.origin);
        let twist = Twist { linear: about * rotation, angular: rotation }.in_space();
        let near = Axis::new(twist.angular, twist.linear);
        let center = padded(center);
        let across = center - near.direction * near.direction.dot(center);
        Axis { point: near.point + across, ..near }
    }

    /// The compliance felt at a body point: displacement of `point` per force at `point`,
    /// `C_W + X K_V^-1 X^T` with `X = P_1 - lever(point)` (length / force).
    #[must_use]
    pub fn compliance_at(&self, point: Vector<N>) -> Mat<N, N> {
        let x = self.twist_map - lever(point - self.origin);
        self.translational_compliance() + x * inverse(&self.rotational) * x.transpose()
    }
}

fn translational<const N: usize, const M: usize>(
    stiffness: &Stiffness<N, M>,
) -> Result<SymmetricEigen<N>, MetricsError> {
    let eigen = SymmetricEigen::new(&stiffness.translational)?;
    let (value, largest) = (eigen.values[0], eigen.values[N - 1]);
    if value > ZERO_STIFFNESS * largest {
        return Ok(eigen);
    }
    let direction = padded(eigen.vectors[0]).to_array();
    Err(MetricsError::TranslationNotHeld { direction, value, largest })
}

fn twist_map<const N: usize, const M: usize>(
    translational: &SymmetricEigen<N>,
    stiffness: &Stiffness<N, M>,
) -> Mat<N, M> {
    inverse(translational) * stiffness.coupling * -1.0
}

/// The inverse of a matrix from its eigenvalues.
fn inverse<const D: usize>(eigen: &SymmetricEigen<D>) -> Mat<D, D> {
    let pairs = eigen.values.iter().zip(&eigen.vectors);
    pairs.fold(Mat::ZERO, |sum, (value, &v)| sum + Mat::outer(v, v) * value.recip())
}

fn padded<const N: usize>(v: Vector<N>) -> Vector<3> {
    Vector::from_fn(|i| if i < N { v[i] } else { 0.0 })
}
