//! Whether contact forces and loads balance.

use clench_screw::{Vector, Wrench};

use crate::{Grasp, GraspError};

/// Relative residual up to which the contact forces count as balanced: half the digits of a
/// double, so that files may print preloads with eight digits.
///
/// A residual `e` makes the stiffness depend on the frame by about `e` relative to force times
/// length, so half the digits of a second-order result are then still true in every frame.
pub const BALANCED: f64 = 1.490_116_119_384_765_6e-8;

/// The sum of contact forces and loads, and whether it is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium<const N: usize, const M: usize> {
    /// What is left, about the contacts' centroid.
    pub residual: Wrench<N, M>,
    /// The residual force relative to the total of all contact forces and loads; 0 without any.
    pub relative_force: f64,
    /// The residual torque relative to the sum of the preloads times the grasp's length and of the
    /// loads times their distances from the centroid; 0 without any.
    pub relative_torque: f64,
    /// Whether both are at most [`BALANCED`].
    pub holds: bool,
}

impl<const N: usize, const M: usize> Equilibrium<N, M> {
    /// Nothing, if the forces balance.
    ///
    /// # Errors
    ///
    /// [`GraspError::Unbalanced`] with the residual: a stiffness to second order then depends on
    /// the frame in which it is formed, and so does all that follows from it.
    pub const fn required(&self) -> Result<(), GraspError> {
        if self.holds {
            return Ok(());
        }
        Err(GraspError::Unbalanced { force: self.relative_force, torque: self.relative_torque })
    }
}

impl<const N: usize, const M: usize> Grasp<N, M> {
    /// Whether contact forces and loads balance [LBR, eq. 5]. A grasp without either does.
    #[must_use]
    pub fn equilibrium(&self) -> Equilibrium<N, M> {
        let residual = self.net_wrench(self.centroid());
        let (mut force, mut torque) = (self.total_preload(), self.total_preload() * self.length());
        for load in self.loads() {
            let [load_force, load_torque] = load.sizes(self.centroid());
            force += load_force;
            torque += load_torque;
        }
        let relative_force = relative(residual.force, force);
        let relative_torque = relative(residual.torque, torque);
        let holds = relative_force <= BALANCED && relative_torque <= BALANCED;
        Equilibrium { residual, relative_force, relative_torque, holds }
    }
}

/// The size of `part` relative to `whole`; nothing of nothing is nothing.
pub(crate) fn relative<const D: usize>(part: Vector<D>, whole: f64) -> f64 {
    let size = part.scaled_norm();
    if size <= 0.0 { 0.0 } else { size / whole }
}
