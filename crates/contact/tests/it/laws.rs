//! Derivatives against finite differences of the actual geometry, and laws against their integrals.

use clench_contact::{Contact, Geometry, Law, Order};
use clench_screw::{Frame, Vector, planar, spatial};
use clench_testkit::{Random, assert_all_close, assert_close};

fn law(r: &mut Random) -> Law {
    match r.below(2) {
        0 => Law::linear(r.between(0.5, 2.0)).unwrap(),
        _ => Law::power(r.between(0.5, 2.0), r.between(1.0, 3.0)).unwrap(),
    }
}

fn contact<const N: usize, const M: usize>(r: &mut Random) -> Contact<N, M> {
    let (point, normal) = (r.array(2.0).into(), r.array(1.0).into());
    let radius = [0.0, r.between(0.1, 1.0)][r.below(2)];
    Contact::new(Geometry::on_face(point, normal, radius), law(r), r.between(0.1, 1.0)).unwrap()
}

/// The displacement `(d, exp(phi))` with the given `N + M` coordinates.
type Chart<const N: usize, const M: usize> = fn(&[f64]) -> Frame<N, M>;

fn planar_chart(q: &[f64]) -> planar::Frame {
    planar::Frame::new([q[0], q[1]], q[2])
}

fn spatial_chart(q: &[f64]) -> spatial::Frame {
    spatial::Frame::new([q[0], q[1], q[2]], [q[3], q[4], q[5]])
}

/// Central differences over `h`: errors of h^2 times a third derivative (gradient), of h^2 times a
/// fourth derivative plus eps / h^2 (Hessian); lengths here are of size 3.
fn derivatives_match<const N: usize, const M: usize>(chart: Chart<N, M>, seed: u64) {
    let r = &mut Random::new(seed);
    for _ in 0..100 {
        let contact = contact::<N, M>(r);
        let overlap = contact.overlap();
        let depth = |q: &[f64]| overlap.depth_after(&chart(q));
        let size = N + M;
        assert_close(depth(&vec![0.0; size]), overlap.depth(), 1e-15, 8.0, "depth at rest");

        let gradient = overlap.gradient(Vector::ZERO);
        let found = [gradient.force.to_array().as_slice(), &gradient.torque.to_array()].concat();
        let h = 1e-5;
        let at = |i: usize, s: f64, j: usize, t: f64| {
            let mut q = vec![0.0; size];
            q[i] += s;
            q[j] += t;
            depth(&q)
        };
        let slopes: Vec<f64> =
            (0..size).map(|i| (at(i, h, i, 0.0) - at(i, -h, i, 0.0)) / (2.0 * h)).collect();
        assert_all_close(&found, &slopes, 1e-9, "gradient");

        let h = 1e-3;
        let hessian = overlap.hessian(Vector::ZERO);
        for i in 0..size {
            for j in 0..size {
                let mixed = at(i, h, j, h) - at(i, h, j, -h) - at(i, -h, j, h) + at(i, -h, j, -h);
                let expected = mixed / (4.0 * h * h);
                let what = format!("Hessian ({i}, {j})");
                assert_close(hessian.entry(i, j), expected, 3e-6, 4.0, what);
            }
        }
    }
}

#[test]
fn gradient_and_hessian_are_derivatives_of_the_moved_geometry() {
    derivatives_match(planar_chart, 11);
    derivatives_match(spatial_chart, 12);
}

/// The force on the body is minus the gradient of the energy, and the stiffness its derivative.
fn share_matches_energy<const N: usize, const M: usize>(chart: Chart<N, M>, seed: u64) {
    let r = &mut Random::new(seed);
    for _ in 0..50 {
        let contact = contact::<N, M>(r);
        let size = N + M;
        let energy = |q: &[f64]| contact.law().energy(contact.overlap().depth_after(&chart(q)));
        let share = contact.stiffness(Vector::ZERO, Order::Second);
        let h = 1e-3;
        for i in 0..size {
            for j in 0..size {
                let at = |s: f64, t: f64| {
                    let mut q = vec![0.0; size];
                    q[i] += s * h;
                    q[j] += t * h;
                    energy(&q)
                };
                let mixed = at(1.0, 1.0) - at(1.0, -1.0) - at(-1.0, 1.0) + at(-1.0, -1.0);
                let expected = mixed / (4.0 * h * h);
                let what = format!("K ({i}, {j})");
                // h^2 times fourth derivatives of the energy, which are of size 1e2.
                assert_close(share.entry(i, j), expected, 2e-4, 10.0, what);
            }
        }
    }
}

#[test]
fn a_contacts_stiffness_is_the_second_derivative_of_its_energy() {
    share_matches_energy(planar_chart, 13);
    share_matches_energy(spatial_chart, 14);
}

#[test]
fn laws_invert_and_integrate() {
    let r = &mut Random::new(15);
    for _ in 0..200 {
        let law = law(r);
        let delta = r.between(0.1, 2.0);
        assert_close(law.overlap(law.force(delta)), delta, 1e-14, delta, "inverse");
        // Simpson's rule over 200 steps, on a smooth integrand away from 0.
        let (low, steps) = (0.05, 200_u32);
        let h = (delta - low) / f64::from(steps);
        let sum: f64 = (0..=steps)
            .map(|i| {
                let weight = match i {
                    0 => 1.0,
                    i if i == steps => 1.0,
                    i if i % 2 == 1 => 4.0,
                    _ => 2.0,
                };
                weight * law.force(low + h * f64::from(i))
            })
            .sum();
        let work = law.energy(delta) - law.energy(low);
        assert_close(work, sum * h / 3.0, 1e-8, law.energy(delta), "energy");
        let slope = (law.force(delta + 1e-6) - law.force(delta - 1e-6)) / 2e-6;
        assert_close(law.slope(delta), slope, 1e-8, slope, "slope");
    }
}

#[test]
fn a_power_law_of_exponent_one_is_the_linear_law() {
    let (linear, power) = (Law::linear(3.0).unwrap(), Law::power(3.0, 1.0).unwrap());
    for delta in [0.0, 0.25, 4.0] {
        assert_eq!(linear.force(delta), power.force(delta));
        assert_eq!(linear.slope(delta), power.slope(delta));
        assert_eq!(linear.energy(delta), power.energy(delta));
    }
}

/// The share about a far origin is the share about a near one, moved there, once the gradient is
/// balanced: two opposite contacts of equal force.
#[test]
fn two_opposite_contacts_change_origin_like_a_stiffness() {
    let r = &mut Random::new(16);
    for _ in 0..50 {
        let (point, normal): (Vector<2>, Vector<2>) = (r.array(1.0).into(), r.array(1.0).into());
        let law = Law::linear(2.0).unwrap();
        let one =
            Contact::<2, 1>::new(Geometry::on_face(point, normal, 0.3), law.clone(), 0.5).unwrap();
        let other =
            Contact::new(Geometry::on_face(point + normal * 2.0, -normal, 0.7), law, 0.5).unwrap();
        let origin: Vector<2> = r.array(5.0).into();
        let sum = |o| one.stiffness(o, Order::Second) + other.stiffness(o, Order::Second);
        let moved = sum(Vector::ZERO).in_frame(&Frame::at(origin));
        for i in 0..3 {
            for j in 0..3 {
                assert_close(sum(origin).entry(i, j), moved.entry(i, j), 1e-13, 100.0, "entry");
            }
        }
    }
}
