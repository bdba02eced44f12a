//! Random grasps in equilibrium, in the plane and in space.

use clench_contact::{Contact, Geometry, Law};
use clench_screw::{Vector, Wrench, lever};
use clench_stiffness::Grasp;
use clench_testkit::Random;

fn law(r: &mut Random) -> Law {
    match r.below(2) {
        0 => Law::linear(r.between(0.5, 2.0)).unwrap(),
        _ => Law::power(r.between(0.5, 2.0), r.between(1.0, 2.0)).unwrap(),
    }
}

/// Pairs of opposite fingers along random lines, the two of a pair with equal preloads but laws,
/// radii and distances of their own: balanced, and not symmetric.
pub(crate) fn balanced<const N: usize, const M: usize>(
    r: &mut Random,
    pairs: usize,
) -> Grasp<N, M> {
    let mut contacts = Vec::new();
    for _ in 0..pairs {
        let middle: Vector<N> = r.array(1.0).into();
        let normal: Vector<N> = r.array(1.0).into();
        let preload = r.between(0.1, 0.5);
        for side in [-1.0, 1.0] {
            let point = middle + normal * (side * r.between(0.5, 1.5));
            let radius = r.between(0.0, 0.8);
            contacts.push(
                Contact::new(Geometry::on_face(point, normal * -side, radius), law(r), preload)
                    .unwrap(),
            );
        }
    }
    Grasp::new(contacts).unwrap()
}

/// The sum of the contact forces, from points and normals alone.
pub(crate) fn net_wrench<const N: usize, const M: usize>(grasp: &Grasp<N, M>) -> Wrench<N, M> {
    let mut net = Wrench::ZERO;
    for contact in grasp.contacts() {
        let force = contact.overlap().inward_normal() * contact.preload();
        let torque = -(lever::<N, M>(contact.overlap().point()).transpose() * force);
        net += Wrench { force, torque };
    }
    net
}
