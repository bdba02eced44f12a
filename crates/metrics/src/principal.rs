//! The principal stiffness parameters of LBR section 3.

use clench_screw::{
    Cholesky, Frame, Mat, Stiffness, SymmetricEigen, Twist, Vector, Wrench, lever, lever_center,
};

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
    translational_compliance: Mat<N, N>,
    restricted: Mat<M, M>,
    /// `P_1 = -K_11^-1 K_12` about `origin`: the translation that goes with a rotation.
    twist_map: Mat<N, M>,
    /// The trace of `K_22` about the origin that the computation started from.
    scale: f64,
    /// How far from the frame's origin the stiffness was formed (length).
    distance: f64,
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
        let translational = translational(stiffness)?;
        let compliance = translational.map(f64::recip);
        let scale = stiffness.rotational.trace().abs();
        Self::scaled(origin, stiffness, translational, compliance, scale)
    }

    /// The parameters of the stiffness that `stiffness_about` forms about any origin.
    ///
    /// In two passes: about `start`, which has to be near the body, for the point about which the
    /// trace of `K_22` is least; then about that point, where least cancels when what forces resist
    /// is taken from `K_22`. In the plane it is the center of compliance, in space Loncaric's
    /// center of stiffness. (The canonical point would not do: where a translation is soft it is
    /// far away.)
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
        // The translational block is the same about every origin.
        let compliance = translational.map(f64::recip);
        let step = match M {
            // The same point, without another factorization.
            1 => lever_center(&(compliance * rough.coupling * -1.0)),
            _ => step_to_least_rotational(&rough),
        };
        let origin = start + step;
        let scale = rough.rotational.trace().abs();
        Self::scaled(origin, &stiffness_about(origin), translational, compliance, scale)
    }

    fn scaled(
        origin: Vector<N>,
        stiffness: &Stiffness<N, M>,
        translational: SymmetricEigen<N>,
        translational_compliance: Mat<N, N>,
        scale: f64,
    ) -> Result<Self, MetricsError> {
        let twist_map = translational_compliance * stiffness.coupling * -1.0;
        let restricted = stiffness.rotational + stiffness.coupling.transpose() * twist_map;
        let rotational = SymmetricEigen::new(&restricted)?;
        let principal = Self {
            origin,
            translational,
            rotational,
            translational_compliance,
            restricted,
            twist_map,
            scale,
            distance: origin.max_abs(),
        };
        let value = rotational.values[0];
        // What is carried is at most this: as a rule that decides without a root.
        let squares = twist_map.rows().as_flattened().iter().map(|x| x * x).sum::<f64>();
        if value > ZERO_STIFFNESS * (scale + squares * stiffness.translational.trace()) {
            return Ok(principal);
        }
        let scale = scale + carried(&stiffness.translational, &twist_map);
        if value > ZERO_STIFFNESS * scale {
            return Ok(principal);
        }
        let axis = principal.twist_axes()[0];
        Err(MetricsError::RotationNotHeld { axis, value, scale })
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
    pub const fn translational_compliance(&self) -> &Mat<N, N> {
        &self.translational_compliance
    }

    /// `P_1 = -K_11^-1 K_12` about the frame's origin (length per rad): the map `P = [P_1; I]`
    /// takes a rotation to the element of `V` that has it [LBR, eq. 9], and `Q = [I; -P_1^T]` a
    /// force to the element of `W` [LBR, eq. 11].
    #[must_use]
    pub fn twist_map(&self) -> Mat<N, M> {
        self.twist_map + lever(self.origin)
    }

    /// The twist, about the frame's origin, that turns by `rotation` and needs no force: the
    /// element `P omega` of `V` [LBR, eq. 9].
    #[must_use]
    pub fn force_free_twist(&self, rotation: Vector<M>) -> Twist<N, M> {
        Twist { linear: self.twist_map() * rotation, angular: rotation }
    }

    /// The wrench, about the frame's origin, that has the given `force` and turns nothing: the
    /// element `Q f` of `W` [LBR, eq. 11].
    #[must_use]
    pub fn rotation_free_wrench(&self, force: Vector<N>) -> Wrench<N, M> {
        Wrench { force, torque: -(self.twist_map().transpose() * force) }
    }

    /// The displacement by an external `load`, both about `origin`: `q = C w`.
    ///
    /// By the blocks of `C`, about the point where they decouple: the rotation that the torque
    /// causes, with what it carries along, and the translation that the force causes. An origin
    /// near the body loses nothing; one `d` body lengths away about `d` units of rounding.
    #[must_use]
    pub fn displacement(&self, origin: Vector<N>, load: &Wrench<N, M>) -> Twist<N, M> {
        let near = Frame::at(self.origin - origin);
        let Wrench { force, torque } = load.in_frame(&near);
        let torque = torque + self.twist_map.transpose() * force;
        let angular = self.rotational_compliance() * torque;
        let linear = self.translational_compliance * force + self.twist_map * angular;
        Twist { linear, angular }.to_parent(&near)
    }

    /// The compliance felt at a body point: displacement of `point` per force at `point`,
    /// `C_W + X K_V^-1 X^T` with `X = P_1 - lever(point)` (length / force).
    #[must_use]
    pub fn compliance_at(&self, point: Vector<N>) -> Mat<N, N> {
        let x = self.twist_map - lever(point - self.origin);
        self.translational_compliance + x * self.rotational_compliance() * x.transpose()
    }

    /// The same parameters, given in the parent of `frame`, written in `frame`: points from its
    /// origin, directions and matrices along its axes.
    #[must_use]
    pub fn in_frame(&self, frame: &Frame<N, M>) -> Self {
        let (axes, spin) = (frame.axes(), frame.spin());
        Self {
            origin: frame.point_in_frame(self.origin),
            translational: self.translational.in_basis(axes),
            rotational: self.rotational.in_basis(spin),
            translational_compliance: axes.transpose() * self.translational_compliance * *axes,
            restricted: spin.transpose() * self.restricted * *spin,
            twist_map: axes.transpose() * self.twist_map * *spin,
            scale: self.scale,
            distance: self.distance,
        }
    }

    /// `K_V^-1` (rad per force * length).
    pub(crate) fn rotational_compliance(&self) -> Mat<M, M> {
        self.rotational.map(f64::recip)
    }

    /// [`Self::force_free_twist`], about the origin of the computation.
    pub(crate) fn near_twist(&self, rotation: Vector<M>) -> Twist<N, M> {
        Twist { linear: self.twist_map * rotation, angular: rotation }
    }

    /// The origin of the computation, near the body.
    pub(crate) const fn origin(&self) -> Vector<N> {
        self.origin
    }

    /// `P_1` about that origin.
    pub(crate) const fn near_map(&self) -> &Mat<N, M> {
        &self.twist_map
    }

    /// How far `P_1` may be off by rounding (length): of each contact a product with its arm is
    /// divided by the smallest of the stiffnesses. Arms are about the root of the quotient of
    /// rotational and translational stiffness, and are rounded with their distance from the origin.
    pub(crate) fn map_rounding(&self) -> f64 {
        let sigma = &self.translational.values;
        let arm = (self.scale / sigma.iter().sum::<f64>()).sqrt();
        ZERO_STIFFNESS * (arm + self.distance) * (sigma[N - 1] / sigma[0])
    }
}

/// What the rounding of `K_11` is multiplied with when it is taken from `K_22`: an entry rounds
/// with the root of the product of its two diagonal ones, so that an axis along which little
/// resists rounds little.
fn carried<const N: usize, const M: usize>(
    translational: &Mat<N, N>,
    twist_map: &Mat<N, M>,
) -> f64 {
    let roots = Vector::<N>::from_fn(|i| translational[i][i].abs().sqrt());
    let sizes = (0..M).map(|j| (0..N).map(|i| twist_map[i][j].abs() * roots[i]).sum::<f64>());
    sizes.map(|size| size * size).sum()
}

/// The step to the point about which the trace of `K_22` is least: `A c = b` with
/// `A_kj = <lever(e_k), K_11 lever(e_j)>` and `b_k = -<lever(e_k), K_12>`; none if nothing resists.
fn step_to_least_rotational<const N: usize, const M: usize>(
    stiffness: &Stiffness<N, M>,
) -> Vector<N> {
    let levers: [Mat<N, M>; N] =
        std::array::from_fn(|k| lever(Vector::from_fn(|i| if i == k { 1.0 } else { 0.0 })));
    let inner = |a: &Mat<N, M>, b: &Mat<N, M>| -> f64 {
        a.rows().as_flattened().iter().zip(b.rows().as_flattened()).map(|(x, y)| x * y).sum()
    };
    let resisted = levers.map(|lever| stiffness.translational * lever);
    let matrix = Mat::<N, N>::from_fn(|k, j| inner(&levers[k], &resisted[j]));
    let moments = Vector::from_fn(|k| -inner(&levers[k], &stiffness.coupling));
    Cholesky::new(&matrix).map_or(Vector::ZERO, |factors| factors.solve(moments))
}

fn translational<const N: usize, const M: usize>(
    stiffness: &Stiffness<N, M>,
) -> Result<SymmetricEigen<N>, MetricsError> {
    let eigen = SymmetricEigen::new(&stiffness.translational)?;
    let (value, largest) = (eigen.values[0], eigen.values[N - 1]);
    if value > ZERO_STIFFNESS * largest {
        return Ok(eigen);
    }
    let direction = eigen.vectors[0].in_space();
    Err(MetricsError::TranslationNotHeld { direction, value, largest })
}
