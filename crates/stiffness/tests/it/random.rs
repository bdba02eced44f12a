//! Random grasps in equilibrium, in the plane and in space.

use clench_contact::{Contact, Curvature, Geometry, Law};
use clench_screw::{Mat, Vector, Wrench, lever};
use clench_stiffness::{DeadLoad, Grasp};
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

/// The same with curved parts and with fingers of any shape: round, flat on a convex place, or
/// curved differently in each direction.
pub(crate) fn balanced_and_curved<const N: usize, const M: usize>(
    r: &mut Random,
    pairs: usize,
) -> Grasp<N, M> {
    let flat = balanced::<N, M>(r, pairs);
    let curved = flat.contacts().iter().map(|contact| {
        let place = *contact.overlap().geometry();
        let kind = r.below(3);
        let mut operator = || {
            let axis: Vector<N> = r.array(0.7).into();
            Curvature::of_shape_operator(Mat::outer(axis, axis) + Mat::IDENTITY * 0.3)
        };
        let (finger, part) = match kind {
            0 => (Curvature::FLAT, operator()),
            1 => (operator(), operator()),
            _ => (place.finger, Curvature::round(-2.5)),
        };
        let place = Geometry { finger, part, ..place };
        Contact::new(place, contact.law().clone(), contact.preload()).unwrap()
    });
    Grasp::new(curved.collect()).unwrap()
}

/// Contacts that do not balance, and the load that balances them.
pub(crate) fn loaded<const N: usize, const M: usize>(r: &mut Random) -> Grasp<N, M> {
    let pairs = balanced_and_curved::<N, M>(r, 3);
    let mut contacts = pairs.contacts().to_vec();
    let last = contacts.pop().unwrap();
    let (place, force) = (*last.overlap().geometry(), last.preload());
    // The missing finger's force acts at its line, well inside the part.
    let point = place.point + place.inward_normal * r.between(0.5, 2.0);
    let load = DeadLoad { point, force: place.inward_normal * force };
    Grasp::new(contacts).unwrap().with_loads(vec![load]).unwrap()
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
