//! Whether the contact forces balance.

use clench_screw::Wrench;

use crate::Grasp;

/// Relative residual up to which the contact forces count as balanced: half the digits of a
/// double, so that files may print preloads with eight digits.
///
/// A residual `e` makes the stiffness depend on the frame by about `e` relative to force times
/// length, so half the digits of a second-order result are then still true in every frame.
pub const BALANCED: f64 = 1.490_116_119_384_765_6e-8;

/// The sum of the contact forces, and whether it is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium<const N: usize, const M: usize> {
    /// What is left, about the contacts' centroid.
    pub residual: Wrench<N, M>,
    /// Whether that is zero: the force relative to the total preload, the torque relative to the
    /// total preload times the grasp's length.
    pub holds: bool,
}

impl<const N: usize, const M: usize> Grasp<N, M> {
    /// Whether the preloads balance [LBR, eq. 5]. A grasp without preload does.
    #[must_use]
    pub fn equilibrium(&self) -> Equilibrium<N, M> {
        let residual = self.net_wrench(self.centroid());
        let allowed = BALANCED * self.total_preload();
        let holds =
            residual.force.norm() <= allowed && residual.torque.norm() <= allowed * self.length();
        Equilibrium { residual, holds }
    }
}
