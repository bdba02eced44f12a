//! Derivatives against finite differences of the actual geometry, and laws against their integrals.

use clench_contact::{
    Contact, Curvature, Elastic, ForceLaw, Geometry, Hertz, Law, LineContact, Order,
};
use clench_screw::{Frame, Mat, SymmetricEigen, Vector, planar, spatial};
use clench_testkit::{Random, assert_all_close, assert_close};

fn elastic(r: &mut Random) -> Elastic {
    Elastic::new(r.between(5.0, 20.0), r.between(0.0, 0.5)).unwrap()
}

pub(crate) fn law(r: &mut Random) -> Law {
    match r.below(4) {
        0 => Law::linear(r.between(0.5, 2.0)).unwrap(),
        1 => Law::power(r.between(0.5, 2.0), r.between(1.0, 3.0)).unwrap(),
        2 => {
            let gap = [r.between(0.1, 1.0), r.between(1.0, 5.0)];
            Law::Hertz(Hertz::elliptic(r.between(0.5, 2.0), gap).unwrap())
        }
        _ => {
            let (finger, part) = (elastic(r), elastic(r));
            let (radius, reference_depth) = (r.between(20.0, 40.0), r.between(20.0, 40.0));
            let contact = LineContact { radius, thickness: 0.2, reference_depth, finger, part };
            Law::line(&contact).unwrap()
        }
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

/// The ellipse becomes a circle without a jump: between equal curvatures and curvatures apart by a
/// part `e`, stiffness and semi-axes differ by a part of the size of `e`.
#[test]
fn the_elliptic_law_tends_to_the_circular_one() {
    let circle = Hertz::circular(100.0, 2.5).unwrap();
    for e in [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3] {
        let law = Hertz::elliptic(100.0, [0.2, 0.2 * (1.0 + e)]).unwrap();
        let (found, wanted) = (law.slope(0.01), circle.slope(0.01));
        assert_close(found, wanted, 4e-15 + e, wanted, format!("slope at {e}"));
        let [a, b] = law.semi_axes(0.01);
        // b / a = 1 - 2 e / 3 to first order [math of Hertz: B / A = 1 + 3 m / 4].
        assert_close(1.0 - b / a, 2.0 * e / 3.0, 4e-15 + e * e, 1.0, format!("axes at {e}"));
        assert!(a >= b);
    }
}

/// The equation `B / A = C / ((1 - m) D)` with both integrals by the trapezoidal rule, which
/// converges exponentially for periodic integrands, at a rate of `b / a` per point.
#[test]
fn the_ellipse_satisfies_its_equation() {
    for ratio in [1.0, 1.1, 2.0, 10.0, 100.0, 1e3, 1e4] {
        let law = Hertz::elliptic(1.0, [1.0, ratio]).unwrap();
        let [a, b] = law.semi_axes(1.0);
        let square = (b / a) * (b / a);
        let points = 20_000_u32;
        let (mut c, mut d) = (0.0, 0.0);
        for i in 0..points {
            let (sin, cos) = (std::f64::consts::PI * f64::from(i) / f64::from(points)).sin_cos();
            // 1 - m sin^2 = cos^2 + (b / a)^2 sin^2.
            let weight = (cos * cos + square * sin * sin).sqrt().recip();
            c += cos * cos * weight;
            d += sin * sin * weight;
        }
        let found = c / (square * d);
        assert_close(found, ratio, 1e-12, ratio, format!("B / A of {ratio}"));
        // a^2 = delta D / (K A) with delta = A = 1.
        assert_close(a * a, d / (c + d), 1e-12, 1.0, format!("a of {ratio}"));
        // Pressure times area is the force.
        let force = law.peak_pressure(1.0) * 2.0 / 3.0 * std::f64::consts::PI * a * b;
        assert_close(force, law.force(1.0), 1e-14, law.force(1.0), "force");
    }
    for exponent in -12..=60 {
        let law = Hertz::elliptic(1.0, [1.0, 1.0 + 10.0_f64.powi(exponent)]).unwrap();
        let [a, b] = law.semi_axes(1.0);
        assert!(0.0 < b && b <= a && law.slope(1.0) > 0.0, "1e{exponent}");
    }
}

/// Near the end of the line law its slope follows from the force: `d delta / d f` there.
#[test]
fn the_line_law_has_its_slope_up_to_its_end() {
    let body = Elastic::new(100.0, 0.3).unwrap();
    let (radius, reference_depth) = (3.0, 5.0);
    let disc = LineContact { radius, thickness: 2.0, reference_depth, finger: body, part: body };
    let law = Law::line(&disc).unwrap();
    let largest = law.largest_force();
    for part in [1e-300, 1e-9, 0.1, 0.9, 1.0 - 1e-3, 1.0 - 1e-6] {
        let force = largest * part;
        let h = force * 1e-2 * (1.0 - part).min(0.1);
        let steps = [-2.0, -1.0, 1.0, 2.0].map(|i| law.overlap(force + i * h));
        let compliance = (steps[0] - 8.0 * steps[1] + 8.0 * steps[2] - steps[3]) / (12.0 * h);
        let found = law.slope_at_force(force);
        // The differences lose the digits of h; the formula does not.
        let lost = 1e-8 + 1e-14 / (h / force) / (1.0 - part);
        assert_close(found * compliance, 1.0, lost, 1.0, format!("slope at {part}"));
    }
    // The force stays where the law ends, and the energy is its integral still.
    let end = match &law {
        Law::Line(line) => line.largest_overlap(),
        _ => unreachable!("made above"),
    };
    let more = law.energy(2.0 * end) - law.energy(end);
    assert_close(more, largest * end, 1e-14, largest * end, "energy beyond the end");
}

/// The Hessian grows with the radii of either body: flatter is stiffer.
#[test]
fn flatter_bodies_have_the_larger_hessian() {
    let r = &mut Random::new(18);
    for _ in 0..100 {
        let (point, normal) = (r.array(1.0).into(), r.array(1.0).into());
        let radii: [f64; 2] = [r.between(0.5, 2.0), r.between(0.5, 2.0)];
        let other: [f64; 2] = [r.between(0.5, 2.0), r.between(0.5, 2.0)];
        let (along, across) = (r.array(1.0).into(), r.array(1.0).into());
        let grown = |radii: [f64; 2], by: f64| radii.map(|radius| radius + by);
        let hessian = |finger, part| {
            let place = Geometry {
                point,
                inward_normal: normal,
                finger: Curvature::principal_radii(finger, along),
                part: Curvature::principal_radii(part, across),
            };
            let contact = Contact::<3, 3>::overlapping(place, Law::linear(1.0).unwrap(), 0.2);
            contact.unwrap().overlap().hessian(Vector::ZERO)
        };
        let before = hessian(radii, other);
        for after in [hessian(grown(radii, 0.7), other), hessian(radii, grown(other, 0.7))] {
            let change = after + before * -1.0;
            let full = Mat::<6, 6>::from_fn(|i, j| change.entry(i, j));
            let least = SymmetricEigen::new(&full).unwrap().values[0];
            assert!(least >= -1e-14 * full.max_abs().max(1.0), "{least}");
        }
    }
}

/// Round fingers leave the coupling block without a trace, whatever the part, in any frame.
#[test]
fn round_fingers_have_a_coupling_block_without_trace() {
    let r = &mut Random::new(19);
    for _ in 0..100 {
        let (p, q) = (r.between(-0.4, 2.0), r.between(-0.4, 2.0));
        let place = Geometry {
            point: r.array(2.0).into(),
            inward_normal: r.array(1.0).into(),
            finger: Curvature::round(r.between(0.0, 2.0)),
            part: Curvature::principal_radii([1.0 / p, 1.0 / q], r.array(1.0).into()),
        };
        let overlap = r.between(0.0, 0.3);
        let contact = Contact::<3, 3>::overlapping(place, Law::linear(1.0).unwrap(), overlap);
        let contact = contact.unwrap();
        let hessian = contact.overlap().hessian(r.array::<3>(2.0).into());
        let frame = spatial_chart(&r.array::<6>(1.0));
        let coupling = hessian.in_frame(&Frame::at(Vector::ZERO)).coupling;
        let size = hessian.rotational.max_abs().max(coupling.max_abs());
        assert!(coupling.trace().abs() <= 1e-14 * size);
        assert!(hessian.in_frame(&frame).coupling.trace().abs() <= 1e-13 * size);
    }
}

/// One shape by several descriptions.
#[test]
fn equal_boundaries_have_equal_hessians_however_they_are_given() {
    let normal = Vector::new([0.0, 0.6, 0.8]);
    let hessian = |finger, part| {
        let place =
            Geometry { point: Vector::new([1.0, 2.0, 3.0]), inward_normal: normal, finger, part };
        let law = Law::linear(1.0).unwrap();
        *Contact::<3, 3>::overlapping(place, law, 0.1).unwrap().overlap()
    };
    let tangent = Mat::IDENTITY - Mat::outer(normal, normal);
    let along = Vector::new([1.0, 0.3, -0.2]);
    let same = [
        Curvature::round(2.0),
        Curvature::principal_radii([2.0, 2.0], along),
        Curvature::of_shape_operator(tangent * 0.5),
        Curvature::of_shape_operator(Mat::IDENTITY * 0.5),
    ];
    for part in [Curvature::FLAT, Curvature::round(5.0), Curvature::round(-5.0)] {
        let wanted = hessian(same[0], part).hessian(Vector::ZERO);
        for finger in same {
            let found = hessian(finger, part).hessian(Vector::ZERO);
            for i in 0..6 {
                for j in 0..6 {
                    assert_close(found.entry(i, j), wanted.entry(i, j), 1e-14, 10.0, "entry");
                }
            }
        }
    }
}

/// A finger that presses on a corner of the part turns about it like a disc about a needle: the
/// roles of a pointed finger and a pointed part are the same.
#[test]
fn a_pointed_part_is_a_pointed_finger_seen_from_the_part() {
    let law = Law::linear(1.0).unwrap();
    let point = Vector::new([0.4, -0.3]);
    let corner = Geometry {
        point,
        inward_normal: Vector::new([0.6, 0.8]),
        finger: Curvature::round(2.0),
        part: Curvature::POINTED,
    };
    let contact = Contact::<2, 1>::overlapping(corner, law, 0.3).unwrap();
    let hessian = contact.overlap().hessian(Vector::ZERO);
    // delta = r - |b - c|, with c the center of the disc: along the tangent -1 / (r - delta).
    let tangent = Vector::new([-0.8, 0.6]);
    assert_close(
        tangent.dot(hessian.translational * tangent),
        -1.0 / 1.7,
        1e-15,
        1.0,
        "sliding off the disc",
    );
    // About the corner nothing turns.
    let about = contact.overlap().hessian(point);
    assert!(about.coupling.max_abs() <= 1e-16 && about.rotational.max_abs() <= 1e-16);
}

/// Far larger radii than depths and displacements cost no digits.
#[test]
fn the_depth_after_a_small_motion_keeps_its_digits_beside_large_radii() {
    let normal = Vector::new([0.36, 0.48, 0.8]);
    for size in [1.0, 1e6, 1e12] {
        for (finger, part) in [(size, f64::INFINITY), (size, 2.0 * size), (size, -2.0 * size)] {
            let place = Geometry {
                point: Vector::new([0.5, 0.25, 0.125]),
                inward_normal: normal,
                finger: Curvature::round(finger),
                part: Curvature::round(part),
            };
            let law = Law::linear(1.0).unwrap();
            let contact = Contact::<3, 3>::overlapping(place, law, 7e-4).unwrap();
            let after = |frame: &spatial::Frame| contact.overlap().depth_after(frame);
            assert_eq!(after(&spatial::Frame::IDENTITY), 7e-4);
            let shift = normal * 1e-4;
            let found = after(&Frame::at(shift));
            assert_close(found, 6e-4, 1e-12, 6e-4, format!("shift at {size:e}"));
        }
    }
}
