//! The ellipsoids of unit elastic energy of LBR section 3.3.

use clench_screw::{SymmetricEigen, Twist, Vector, Wrench};

use crate::Principal;

/// Twice the energy at which the surfaces are drawn: `q^T K q = 2` on `q^T K q / 2 = 1`.
const DOUBLED_ENERGY: f64 = 2.0;

/// What is left of the doubled energy at the rim of a projection: the rounding of its square.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// A section or a projection of a surface of unit energy: an ellipsoid in space, an ellipse in the
/// plane, two points on a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyEllipsoid<const D: usize> {
    /// Its center.
    pub center: Vector<D>,
    /// The semi-axes: in the order of the principal stiffnesses, whose least comes first.
    pub semi_axes: [f64; D],
    /// The unit vectors along them.
    pub directions: [Vector<D>; D],
}

impl<const D: usize> EnergyEllipsoid<D> {
    /// The point of the surface that `unit`, a vector of unit length, is taken to.
    #[must_use]
    pub fn point(&self, unit: Vector<D>) -> Vector<D> {
        let steps = self.directions.iter().zip(self.semi_axes).enumerate();
        steps.fold(self.center, |sum, (i, (&along, a))| sum + along * (a * unit[i]))
    }
}

/// The displacements and the wrenches of unit energy, and what of them no frame alters.
///
/// Rotations, translations and points are those of the frame in which the parameters are written;
/// [`Principal::in_frame`] writes them in another.
impl<const N: usize, const M: usize> Principal<N, M> {
    /// The translations `v` that together with `rotation` (rad) have unit energy: the section of
    /// the surface `q^T K q = 2` at that rotation.
    ///
    /// Its semi-axes `sqrt((2 - omega^T K_V omega) / sigma_i)` (length) are the same in all frames;
    /// the center `P_1 omega` is not. `None` if the rotation alone has more energy.
    #[must_use]
    pub fn displacement_section(&self, rotation: Vector<M>) -> Option<EnergyEllipsoid<N>> {
        let left = DOUBLED_ENERGY - rotation.dot(*self.restricted_stiffness() * rotation);
        let center = self.twist_map() * rotation;
        ellipsoid(center, self.translational(), left, |energy, sigma| (energy / sigma).sqrt())
    }

    /// The rotations that a displacement of unit energy can have at most: the projection of the
    /// points at which the surface `q^T K q = 2` has a normal without translation.
    ///
    /// Its semi-axes are `sqrt(2 / mu_i)` (rad), its center is 0.
    #[must_use]
    pub fn displacement_projection(&self) -> EnergyEllipsoid<M> {
        let mu = self.rotational();
        EnergyEllipsoid {
            center: Vector::ZERO,
            semi_axes: mu.values.map(|mu| (DOUBLED_ENERGY / mu).sqrt()),
            directions: mu.vectors,
        }
    }

    /// The torques that together with `force` have unit energy: the section of the surface
    /// `w^T C w = 2` at that force.
    ///
    /// Its semi-axes `sqrt(mu_i (2 - f^T K_11^-1 f))` (force * length) are the same in all frames;
    /// the center `-P_1^T f` is not. `None` if the force alone has more energy.
    #[must_use]
    pub fn wrench_section(&self, force: Vector<N>) -> Option<EnergyEllipsoid<M>> {
        let left = DOUBLED_ENERGY - force.dot(*self.translational_compliance() * force);
        let center = self.rotation_free_wrench(force).torque;
        ellipsoid(center, self.rotational(), left, |energy, mu| (energy * mu).sqrt())
    }

    /// The forces that a wrench of unit energy can have at most: the projection of the points at
    /// which the surface `w^T C w = 2` has a normal without torque.
    ///
    /// Its semi-axes are `sqrt(2 sigma_i)` (force), its center is 0.
    #[must_use]
    pub fn wrench_projection(&self) -> EnergyEllipsoid<N> {
        let sigma = self.translational();
        EnergyEllipsoid {
            center: Vector::ZERO,
            semi_axes: sigma.values.map(|sigma| (DOUBLED_ENERGY * sigma).sqrt()),
            directions: sigma.vectors,
        }
    }

    /// A displacement of unit energy: the point of the surface `q^T K q = 2` that (`along`,
    /// `about`), of unit length together, is taken to.
    ///
    /// `about` chooses the point of [`Self::displacement_projection`], `along` that of the section
    /// there, in the order of the principal stiffnesses.
    #[must_use]
    pub fn displacement_of_unit_energy(&self, along: Vector<N>, about: Vector<M>) -> Twist<N, M> {
        let flat = EnergyEllipsoid {
            center: Vector::ZERO,
            semi_axes: self.translational().values.map(|sigma| (DOUBLED_ENERGY / sigma).sqrt()),
            directions: self.translational().vectors,
        };
        let turned = self.force_free_twist(self.displacement_projection().point(about));
        Twist { linear: turned.linear + flat.point(along), ..turned }
    }

    /// A wrench of unit energy: the point of the surface `w^T C w = 2` that (`along`, `about`), of
    /// unit length together, is taken to.
    ///
    /// `along` chooses the point of [`Self::wrench_projection`], `about` that of the section there,
    /// in the order of the principal stiffnesses.
    #[must_use]
    pub fn wrench_of_unit_energy(&self, along: Vector<N>, about: Vector<M>) -> Wrench<N, M> {
        let flat = EnergyEllipsoid {
            center: Vector::ZERO,
            semi_axes: self.rotational().values.map(|mu| (DOUBLED_ENERGY * mu).sqrt()),
            directions: self.rotational().vectors,
        };
        let pushed = self.rotation_free_wrench(self.wrench_projection().point(along));
        Wrench { torque: pushed.torque + flat.point(about), ..pushed }
    }
}

/// The section whose semi-axes follow from what is left of the doubled energy.
fn ellipsoid<const D: usize>(
    center: Vector<D>,
    stiffness: &SymmetricEigen<D>,
    left: f64,
    semi_axis: impl Fn(f64, f64) -> f64,
) -> Option<EnergyEllipsoid<D>> {
    (left >= -ROUNDING).then(|| EnergyEllipsoid {
        center,
        semi_axes: stiffness.values.map(|value| semi_axis(left.max(0.0), value)),
        directions: stiffness.vectors,
    })
}
