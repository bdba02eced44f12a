//! How the measures change with the stiffness, to first order.

use clench_screw::{Mat, Stiffness, SymmetricEigen, Twist, Vector, Wrench, lever};
use clench_shape::Extent;

use crate::softness::Softness;
use crate::{EquivalentStiffness, MetricsError, Principal, Quality, WorstPoint};

/// Values whose relative difference is at most this tie, and each of them counts: symmetric parts
/// and grasps are equal in different places to a few roundings only. As coarse as
/// [`crate::REPEATED`], and for the same reason.
pub const TIED: f64 = 1e-9;

/// The directional derivatives of a measure by the stiffness.
///
/// Each measure is the least of many values: of directions, of corners, of rotations. Where one
/// value is the least, its derivative by a change `dK` is `l^T dK r`, with two twists that belong
/// to the place where it is attained (Danskin): for `Q_pt` both are the displacement by a force at
/// the worst point, times `Q_pt`. Where several tie, to [`TIED`], the measure has a kink: it is
/// concave to first order, and its one-sided derivative is the least of theirs. Where they belong
/// to the eigenspace of a repeated eigenvalue, that is the least eigenvalue of `l_a^T dK r_b`.
///
/// How a stiffness changes is not asked: what changes it may be a place, a spring or a force.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity<const N: usize, const M: usize> {
    origin: Vector<N>,
    pieces: Vec<Piece<N, M>>,
}

/// One of the values that tie, with the twists of the eigenspace that it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Piece<const N: usize, const M: usize>(Vec<[Twist<N, M>; 2]>);

impl<const N: usize, const M: usize> Sensitivity<N, M> {
    /// That of `sigma_min`: `v^T dK_11 v` for its direction `v`.
    #[must_use]
    pub fn of_translation(principal: &Principal<N, M>) -> Self {
        Self::new(principal, vec![translation(principal)])
    }

    /// That of `mu_eq` of the principal rotation number `rotation` of a `quality` of `body`.
    ///
    /// The direction `omega` of the rotation changes too, by the other rotations divided by the
    /// differences of their stiffnesses, and with it the deflection.
    ///
    /// # Errors
    ///
    /// [`MetricsError::QualityJumps`] where the stiffness of the rotation is repeated;
    /// [`MetricsError::TiesWithoutEnd`] where the points of an ellipsoid that move most form a
    /// curve.
    ///
    /// # Panics
    ///
    /// When `rotation` is not below `M`.
    pub fn of_rotation<'a>(
        principal: &Principal<N, M>,
        quality: &Quality<N, M>,
        rotation: usize,
        body: impl Into<Extent<'a, N>>,
    ) -> Result<Self, MetricsError> {
        held_apart(quality, rotation)?;
        Ok(Self::new(principal, of_rotation(principal, rotation, body.into())?))
    }

    /// That of the `quality` of `body`: of `sigma_min` and the `mu_eq`, those that tie for it.
    ///
    /// # Errors
    ///
    /// [`MetricsError::QualityJumps`] where repeated rotational stiffnesses limit the quality:
    /// any change may separate them, and the quality jumps. `Q_V` and `Q_pt` do not.
    /// [`MetricsError::TiesWithoutEnd`] as for [`Self::of_rotation`].
    pub fn of_quality<'a>(
        principal: &Principal<N, M>,
        quality: &Quality<N, M>,
        body: impl Into<Extent<'a, N>>,
    ) -> Result<Self, MetricsError> {
        let (body, limit) = (body.into(), quality.value * (1.0 + TIED));
        let mut pieces = Vec::new();
        if quality.translational <= limit {
            pieces.push(translation(principal));
        }
        for rotation in (0..M).filter(|&i| quality.rotations[i].value <= limit) {
            held_apart(quality, rotation)?;
            pieces.extend(of_rotation(principal, rotation, body)?);
        }
        Ok(Self::new(principal, pieces))
    }

    /// That of `Q_V`, the `least` equivalent stiffness of all force-free rotations of `body`.
    ///
    /// # Errors
    ///
    /// [`MetricsError::TiesWithoutEnd`] where the softest rotations or points of an ellipsoid are
    /// too many to be told apart.
    pub fn of_least<'a>(
        principal: &Principal<N, M>,
        least: &EquivalentStiffness<N, M>,
        body: impl Into<Extent<'a, N>>,
    ) -> Result<Self, MetricsError> {
        let body = body.into();
        if M == 1 {
            // There is one rotation only.
            return Ok(Self::new(principal, of_rotation(principal, 0, body)?));
        }
        told_apart(least.value, least.at_least)?;
        let softness = Softness::of_rotations(principal, 0, M);
        let origin = principal.origin();
        let compliance = *principal.translational_compliance();
        let turned = |point: Vector<N>, direction: Vector<N>| {
            let torque = (*principal.near_map() - lever(point - origin)).transpose() * direction;
            let twist = principal.near_twist(principal.rotational_compliance() * torque);
            let carried = compliance * direction * 2.0;
            [Twist { linear: twist.linear + carried, ..twist }, twist].map(|q| q * least.value)
        };
        let pieces = softest(&softness, body, least.value, turned)?;
        Ok(Self::new(principal, pieces))
    }

    /// That of `Q_pt`, the stiffness at the `worst` point of `body`: `q^T dK q` for the
    /// displacement `q` by a force of size `Q_pt` there.
    ///
    /// # Errors
    ///
    /// As [`Self::of_least`].
    pub fn of_worst_point<'a>(
        principal: &Principal<N, M>,
        worst: &WorstPoint<N>,
        body: impl Into<Extent<'a, N>>,
    ) -> Result<Self, MetricsError> {
        told_apart(worst.stiffness, worst.at_least)?;
        let origin = principal.origin();
        let moved = |point: Vector<N>, direction: Vector<N>| {
            let load = Wrench::of_force_at(direction * worst.stiffness, point - origin);
            [principal.displacement(origin, &load); 2]
        };
        let softness = Softness::whole(principal);
        let pieces = softest(&softness, body.into(), worst.stiffness, moved)?;
        Ok(Self::new(principal, pieces))
    }

    fn new(principal: &Principal<N, M>, pieces: Vec<Piece<N, M>>) -> Self {
        Self { origin: principal.origin(), pieces }
    }

    /// The point about which a change has to be written, near the body; directions are those of the
    /// frame of the principal parameters.
    ///
    /// It is the origin of their computation. A change that leaves contact forces unbalanced is
    /// not the same about another point, and the measure of a grasp that was made anew is formed
    /// about this one, to first order.
    #[must_use]
    pub const fn origin(&self) -> Vector<N> {
        self.origin
    }

    /// The one-sided derivative of the measure by the `change`, written about [`Self::origin`]: how
    /// it grows, per unit of the change, when the stiffness grows by a little of it. Unit: that of
    /// the measure per unit of the change.
    #[must_use]
    pub fn along(&self, change: &Stiffness<N, M>) -> f64 {
        self.pieces.iter().map(|piece| piece.along(change)).fold(f64::INFINITY, f64::min)
    }

    /// Each of the values that tie, alone.
    pub(crate) fn each(&self) -> impl Iterator<Item = Self> {
        let alone = |piece: &Piece<N, M>| Self { origin: self.origin, pieces: vec![piece.clone()] };
        self.pieces.iter().map(alone)
    }

    /// Whether the measure has a derivative: [`Self::along`] is linear then. Otherwise it has a
    /// kink, and the derivatives along a change and against it are not opposite.
    #[must_use]
    pub fn is_smooth(&self) -> bool {
        matches!(&self.pieces[..], [Piece(twists)] if twists.len() == 1)
    }
}

impl<const N: usize, const M: usize> Piece<N, M> {
    /// The least eigenvalue of `l_a^T dK r_b`.
    fn along(&self, change: &Stiffness<N, M>) -> f64 {
        let twists = &self.0;
        let entry = |a: usize, b: usize| twists[a][0].power(&change.apply(&twists[b][1]));
        if twists.len() == 1 {
            return entry(0, 0);
        }
        let count = twists.len();
        let sizes = (0..count).flat_map(|a| (0..count).map(move |b| (a, b)));
        // On the rest of the diagonal what no eigenvalue exceeds.
        let large: f64 = sizes.map(|(a, b)| entry(a, b).abs()).sum();
        let form = Mat::<N, N>::from_fn(|a, b| match (a < count, b < count) {
            (true, true) => entry(a, b),
            _ if a == b => large,
            _ => 0.0,
        });
        SymmetricEigen::new(&form).map_or(f64::NAN, |eigen| eigen.values[0])
    }
}

/// `sigma_min`, with all directions that have it.
fn translation<const N: usize, const M: usize>(principal: &Principal<N, M>) -> Piece<N, M> {
    let sigma = principal.translational();
    let tied = (0..N).filter(|&i| sigma.values[i] <= sigma.values[0] * (1.0 + TIED));
    let twist = |i: usize| Twist { linear: sigma.vectors[i], angular: Vector::ZERO };
    Piece(tied.map(|i| [twist(i); 2]).collect())
}

/// `mu_eq` of a rotation, for each point that it moves most.
///
/// With `D = |y|`, `y = X omega`, and the twists `q_i` of the rotations, `mu' = q^T dK q`,
/// `y . P_1' omega = -(K_11^-1 y, 0)^T dK q` and
/// `omega' = sum of omega_j (q_j^T dK q) / (mu - mu_j)`.
fn of_rotation<const N: usize, const M: usize>(
    principal: &Principal<N, M>,
    rotation: usize,
    body: Extent<'_, N>,
) -> Result<Vec<Piece<N, M>>, MetricsError> {
    let mu = principal.rotational();
    let (origin, stiffness) = (principal.origin(), mu.values[rotation]);
    let twist = principal.near_twist(mu.vectors[rotation]);
    let points = body.all_fastest(origin, &twist, TIED).ok_or(MetricsError::TiesWithoutEnd)?;
    let compliance = *principal.translational_compliance();
    let piece = |point: Vector<N>| {
        let arm = point - origin;
        let y = twist.velocity_at(arm);
        let share = y.norm_squared().recip();
        let turning = (0..M).filter(|&j| j != rotation).fold(Vector::ZERO, |sum, j| {
            let moved = y.dot(principal.near_twist(mu.vectors[j]).velocity_at(arm));
            sum + mu.vectors[j] * (moved / (stiffness - mu.values[j]))
        });
        let turned = principal.near_twist(turning);
        let carried = Twist { linear: turned.linear - compliance * y, ..turned };
        let left = twist - carried * (2.0 * stiffness * share);
        Piece(vec![[left * share, twist]])
    };
    Ok(points.into_iter().map(piece).collect())
}

/// The pieces of the inverse of a compliance, for each point where it is as large as it gets:
/// `twists` belong to a point and a direction in which it gives way most.
fn softest<const N: usize, const M: usize>(
    softness: &Softness<'_, N, M>,
    body: Extent<'_, N>,
    stiffness: f64,
    twists: impl Fn(Vector<N>, Vector<N>) -> [Twist<N, M>; 2],
) -> Result<Vec<Piece<N, M>>, MetricsError> {
    let places = softness.all_softest(body, stiffness.recip(), TIED)?;
    let piece = |(point, directions): (Vector<N>, Vec<Vector<N>>)| {
        Piece(directions.into_iter().map(|direction| twists(point, direction)).collect())
    };
    Ok(places.into_iter().map(piece).collect())
}

/// Fails for a rotation whose stiffness is repeated.
fn held_apart<const N: usize, const M: usize>(
    quality: &Quality<N, M>,
    rotation: usize,
) -> Result<(), MetricsError> {
    let multiplicity = quality.rotations[rotation].multiplicity;
    if multiplicity == 1 { Ok(()) } else { Err(MetricsError::QualityJumps { multiplicity }) }
}

/// Fails where a search could not prove a value: too many places tie.
fn told_apart(value: f64, at_least: f64) -> Result<(), MetricsError> {
    if at_least >= value * (1.0 - TIED) { Ok(()) } else { Err(MetricsError::TiesWithoutEnd) }
}
