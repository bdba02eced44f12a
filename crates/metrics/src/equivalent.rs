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

    /// The distance of the farthest point from the rotation's axis: `rho_max` (length).
    #[must_use]
    pub fn reach(&self) -> f64 {
        let (deflection, pitch) = (self.farthest.value, self.pitch.abs());
        ((deflection - pitch) * (deflection + pitch)).max(0.0).sqrt()
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
        let twist = principal.near_twist(rotation);
        let speed = twist.velocity_at(softest.point - principal.origin()).norm();
        let farthest = Farthest { point: softest.point, corner: softest.corner, value: speed };
        let found = Self {
            value: softest.compliance.recip(),
            at_least: softest.bound.recip(),
            rotation,
            pitch: twist.linear.in_space().dot(rotation.in_space()),
            farthest,
            multiplicity: end - first,
        };
        found.finite()
    }

    /// That of one rotation, of unit length, whose stiffness is `mu`.
    fn of_rotation(
        principal: &Principal<N, M>,
        rotation: Vector<M>,
        mu: f64,
        body: Extent<'_, N>,
    ) -> Result<Self, MetricsError> {
        let twist = principal.near_twist(rotation);
        let farthest = body.fastest(principal.origin(), &twist);
        let value = mu / (farthest.value * farthest.value);
        let pitch = twist.linear.in_space().dot(rotation.in_space());
        let found = Self { value, at_least: value, rotation, pitch, farthest, multiplicity: 1 };
        found.finite()
    }

    fn finite(self) -> Result<Self, MetricsError> {
        if self.value > 0.0 && self.farthest.value.is_finite() {
            return Ok(self);
        }
        Err(MetricsError::OutOfRange { stiffness: self.value, deflection: self.farthest.value })
    }
}
