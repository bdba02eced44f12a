//! A force that acts on the body besides the contacts.

use clench_screw::{Frame, Stiffness, Vector, Wrench, lever};

/// A force of fixed direction and size that acts at a point of the body, such as its weight.
///
/// Its energy is `-force . (d + R point)`. Where the point lies above the contacts, turning the
/// body lowers it: the load has a share of the stiffness of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeadLoad<const N: usize> {
    /// The point of the body at which it acts (length).
    pub point: Vector<N>,
    /// The force.
    pub force: Vector<N>,
}

impl<const N: usize> DeadLoad<N> {
    /// The wrench on the body about `origin`.
    #[must_use]
    pub fn wrench<const M: usize>(&self, origin: Vector<N>) -> Wrench<N, M> {
        Wrench::of_force_at(self.force, self.point - origin)
    }

    /// Its share of the stiffness about `origin`: `(c . F) omega^2 - (c . omega) (F . omega)`,
    /// with `c` the arm, from the second-order terms of `-F . R c`.
    #[must_use]
    pub fn stiffness<const M: usize>(&self, origin: Vector<N>) -> Stiffness<N, M> {
        let arm = lever::<N, M>(self.point - origin);
        let force = lever::<N, M>(self.force);
        let rotational = (arm.transpose() * force).symmetric_part();
        Stiffness { rotational, ..Stiffness::ZERO }
    }

    /// The energy gained from rest, after the body has moved (force * length).
    #[must_use]
    pub fn energy_after<const M: usize>(&self, displacement: &Frame<N, M>) -> f64 {
        self.force.dot(self.point - displacement.point_to_parent(self.point))
    }

    /// The size of the force, and of its moment about `origin` at most.
    pub(crate) fn sizes(&self, origin: Vector<N>) -> [f64; 2] {
        let force = self.force.scaled_norm();
        [force, force * (self.point - origin).scaled_norm()]
    }
}
