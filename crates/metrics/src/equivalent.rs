//! Rotations made comparable to translations.

use clench_screw::Vector;
use clench_shape::{Extent, Farthest};

use crate::softness::Softness;
use crate::{MetricsError, Principal};

/// The equivalent stiffness of a rotation that needs no force: its energy is that of a spring of
/// this stiffness stretched by the body's deflection [LBR, eqs. 13 and 15].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EquivalentStiffness<const N: usize, const M: usize> {
    /// `mu_eq = omega^T K_V omega / (rho_max^2 + h^2)` (force / length); infinite for a rotation
    /// that moves no point of the body.
    pub value: f64,
    /// A proved lower bound for the rotations that were compared: the value itself, but on an
    /// ellipsoid, where several are compared, what a search could prove.
    pub at_least: f64,
    /// The unit rotation `omega`: a principal one, or the softest of those that were compared.
    pub rotation: Vector<M>,
    /// The pitch `h` of the force-free twist that turns so (length per rad); 0 in the plane.
    pub pitch: f64,
    /// The point that this twist moves most, and how far, the *deflection* (length per rad).
    pub farthest: Farthest<N>,
    /// The distance of that point from the axis of the twist: `rho_max` (length).
    pub reach: f64,
    /// How many principal rotations, with all between them, were compared: the multiplicity of a
    /// principal stiffness; for [`Self::least`] all.
    pub multiplicity: usize,
}

impl<const N: usize, const M: usize> EquivalentStiffness<N, M> {
    /// The least of all rotations that need no force: `Q_V` (force / length).
    ///
    /// `Q_V = min over x of 1 / lambda_max(X(x) K_V^-1 X(x)^T)`, `X(x) = P_1 - lever(x)`, for the
    /// points `x` of the body. Unlike [`crate::Quality`] it is continuous in the grasp. In the
    /// plane it is `mu_eq`.
    ///
    /// # Errors
    ///
    /// As [`crate::Quality::of`].
    pub fn least<'a>(
        principal: &Principal<N, M>,
        body: impl Into<Extent<'a, N>>,
    ) -> Result<Self, MetricsError> {
        Self::among(principal, 0, M, body.into())
    }

    /// The least among the combinations of the principal rotations `first` to `end`, exclusive.
    pub(crate) fn among(
        principal: &Principal<N, M>,
        first: usize,
        end: usize,
        body: Extent<'_, N>,
    ) -> Result<Self, MetricsError> {
        let mu = principal.rotational();
        if end == first + 1 {
            return Self::of_rotation(principal, mu.vectors[first], mu.values[first], body);
        }
        let softness = Softness::of_rotations(principal, first, end);
        let softest = softness.largest(body)?;
        let turned = softness.rotation(softest.point, softest.direction);
        let rotation = turned.unwrap_or(mu.vectors[first]);
        let place = (softest.point, softest.corner);
        let found = Self::moving(principal, rotation, place);
        let (value, at_least) = (softest.compliance.recip(), softest.bound.recip());
        Self { value, at_least, multiplicity: end - first, ..found }.finite()
    }

    /// That of one rotation, of unit length, whose stiffness is `mu`.
    fn of_rotation(
        principal: &Principal<N, M>,
        rotation: Vector<M>,
        mu: f64,
        body: Extent<'_, N>,
    ) -> Result<Self, MetricsError> {
        let Farthest { point, corner, .. } =
            body.fastest(principal.origin(), &principal.near_twist(rotation));
        let found = Self::moving(principal, rotation, (point, corner));
        let value = mu / (found.farthest.value * found.farthest.value);
        Self { value, at_least: value, ..found }.finite()
    }

    /// How the force-free twist of a rotation moves its farthest point, still without a value.
    fn moving(
        principal: &Principal<N, M>,
        rotation: Vector<M>,
        (point, corner): (Vector<N>, Option<usize>),
    ) -> Self {
        let twist = principal.near_twist(rotation);
        let velocity = twist.velocity_at(point - principal.origin());
        let along = rotation.in_space();
        let pitch = twist.linear.in_space().dot(along);
        Self {
            value: 0.0,
            at_least: 0.0,
            rotation,
            pitch,
            farthest: Farthest { point, corner, value: velocity.norm() },
            // What is left of the velocity across the axis: the difference of squares cancels.
            reach: (velocity.in_space() - along * pitch).norm(),
            multiplicity: 1,
        }
    }

    fn finite(self) -> Result<Self, MetricsError> {
        if self.value > 0.0 && self.farthest.value.is_finite() {
            return Ok(self);
        }
        Err(MetricsError::OutOfRange { stiffness: self.value, deflection: self.farthest.value })
    }
}
