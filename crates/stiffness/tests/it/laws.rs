//! Stiffness against the energy, and what no choice of frame, unit or order changes.

use clench_contact::{Contact, Curvature, Geometry, Law, Order};
use clench_screw::{Frame, Mat, Stiffness, Vector, planar, spatial};
use clench_stiffness::{DeadLoad, Grasp, GraspError, Stability};
use clench_testkit::{Random, assert_close};

use crate::random::{balanced, balanced_and_curved, loaded, net_wrench};

fn largest<const N: usize, const M: usize>(k: &Stiffness<N, M>) -> f64 {
    k.translational.max_abs().max(k.coupling.max_abs()).max(k.rotational.max_abs())
}

#[track_caller]
fn same<const N: usize, const M: usize>(
    found: &Stiffness<N, M>,
    wanted: &Stiffness<N, M>,
    tolerance: f64,
    what: &str,
) {
    for i in 0..N + M {
        for j in 0..N + M {
            let place = format!("{what} ({i}, {j})");
            assert_close(found.entry(i, j), wanted.entry(i, j), tolerance, largest(wanted), place);
        }
    }
}

/// The frame with the given `N + M` coordinates of the exponential chart.
type Chart<const N: usize, const M: usize> = fn(&[f64]) -> Frame<N, M>;

fn planar_chart(q: &[f64]) -> planar::Frame {
    planar::Frame::new([q[0], q[1]], q[2])
}

fn spatial_chart(q: &[f64]) -> spatial::Frame {
    spatial::Frame::new([q[0], q[1], q[2]], [q[3], q[4], q[5]])
}

/// K is the second derivative of the energy, in and out of balance: central differences of step
/// h err by h^2 times fourth derivatives and by eps / h^2 times the energy, both below 1e-4 here.
fn check_energy<const N: usize, const M: usize>(
    grasp: &Grasp<N, M>,
    origin: Vector<N>,
    chart: Chart<N, M>,
) {
    let stiffness = grasp.stiffness(origin, Order::Second);
    let about = |q: &[f64]| Frame::at(origin) * chart(q) * Frame::at(-origin);
    let h = 1e-3;
    let energy = |i: usize, s: f64, j: usize, t: f64| {
        let mut q = vec![0.0; N + M];
        q[i] += s * h;
        q[j] += t * h;
        grasp.potential_energy(&about(&q))
    };
    for i in 0..N + M {
        for j in 0..N + M {
            let mixed = energy(i, 1.0, j, 1.0) - energy(i, 1.0, j, -1.0) - energy(i, -1.0, j, 1.0)
                + energy(i, -1.0, j, -1.0);
            let what = format!("energy ({i}, {j})");
            let expected = mixed / (4.0 * h * h);
            assert_close(stiffness.entry(i, j), expected, 1e-4, largest(&stiffness), what);
        }
    }
}

/// What holds for balanced grasps, whatever the boundaries.
fn check_balanced<const N: usize, const M: usize>(
    r: &mut Random,
    grasp: &Grasp<N, M>,
    chart: Chart<N, M>,
) {
    assert!(grasp.equilibrium().holds);
    assert_eq!(grasp.equilibrium().required(), Ok(()));
    check_energy(grasp, Vector::ZERO, chart);

    // K changes frame by congruence, wherever it is formed.
    let stiffness = grasp.stiffness(Vector::ZERO, Order::Second);
    let origin = chart(&r.array::<6>(2.0)[..N + M]).origin();
    let moved = stiffness.in_frame(&Frame::at(origin));
    same(&grasp.stiffness(origin, Order::Second), &moved, 1e-13, "congruence");

    // It is the sum of its parts.
    let first = grasp.stiffness(origin, Order::First);
    same(&(first + grasp.preload_stiffness(origin)), &moved, 1e-13, "parts");

    // The order of the contacts does not matter beyond rounding.
    let mut reversed = grasp.contacts().to_vec();
    reversed.reverse();
    let reversed = Grasp::new(reversed).unwrap().with_loads(grasp.loads().to_vec()).unwrap();
    same(&reversed.stiffness(origin, Order::Second), &moved, 1e-13, "permutation");
}

/// What holds for round fingers on flat faces besides.
fn check_flat<const N: usize, const M: usize>(
    r: &mut Random,
    grasp: &Grasp<N, M>,
    chart: Chart<N, M>,
) {
    let stiffness = grasp.stiffness(Vector::ZERO, Order::Second);
    let frame = chart(&r.array::<6>(2.0)[..N + M]);

    // K_2 is purely rotational and does not depend on the origin.
    let here = grasp.preload_stiffness(Vector::ZERO);
    let there = grasp.preload_stiffness(frame.origin());
    let scale = largest(&stiffness);
    assert!(here.coupling.max_abs() <= 1e-14 * scale);
    assert!(here.translational.max_abs() <= 0.0);
    assert!((here.rotational + there.rotational * -1.0).max_abs() <= 1e-13 * scale);

    // The coupling block has no trace, in any frame (space only).
    if N == M {
        let moved = stiffness.in_frame(&frame);
        let trace: f64 = (0..N).map(|i| moved.coupling[i][i]).sum();
        assert_close(trace, 0.0, 1e-13, largest(&moved), "tr K_12");
    }
}

fn laws<const N: usize, const M: usize>(chart: Chart<N, M>, seed: u64) {
    let r = &mut Random::new(seed);
    for _ in 0..20 {
        let flat = balanced::<N, M>(r, 4);
        check_balanced(r, &flat, chart);
        check_flat(r, &flat, chart);
        let curved = balanced_and_curved::<N, M>(r, 4);
        check_balanced(r, &curved, chart);
        let loaded = loaded::<N, M>(r);
        check_balanced(r, &loaded, chart);
    }
}

#[test]
fn stiffness_obeys_its_laws_in_the_plane_and_in_space() {
    laws(planar_chart, 21);
    laws(spatial_chart, 22);
}

fn coincident_fingers_add<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    let axis: Vector<N> = r.array(1.0).into();
    let place = Geometry {
        point: r.array(2.0).into(),
        inward_normal: r.array(1.0).into(),
        finger: Curvature::round(0.5),
        part: Curvature::of_shape_operator(Mat::outer(axis, axis)),
    };
    let finger = |k: f64, f: f64| Contact::new(place, Law::linear(k).unwrap(), f).unwrap();
    let two = Grasp::<N, M>::new(vec![finger(3.0, 0.5), finger(3.0, 0.5)]).unwrap();
    let one = Grasp::<N, M>::new(vec![finger(6.0, 1.0)]).unwrap();
    let about: Vector<N> = r.array(1.0).into();
    let second = |grasp: &Grasp<N, M>| grasp.stiffness(about, Order::Second);
    same(&second(&two), &second(&one), 1e-15, "coincident");
}

#[test]
fn two_fingers_in_one_place_are_one_of_twice_the_stiffness() {
    coincident_fingers_add::<2, 1>(28);
    coincident_fingers_add::<3, 3>(29);
}

/// Powers of 64 are even powers of 2 and cubes, so that the roots of Hertz' law are exact too.
fn units_change_exactly<const N: usize, const M: usize>(
    seed: u64,
    law: fn(&Geometry<N>, [f64; 2], f64) -> Law,
) {
    let r = &mut Random::new(seed);
    let units = [(64.0, 1.0), (1.0 / 64.0, 64.0), (64.0_f64.powi(5), 64.0_f64.powi(-3))];
    for (length, force) in units {
        let places: Vec<[Vector<N>; 3]> =
            (0..7).map(|_| [2.0, 1.0, 1.0].map(|s| r.array(s).into())).collect();
        let sizes: Vec<[f64; 3]> = (0..7).map(|_| r.array::<3>(0.5).map(|x| x + 1.0)).collect();
        let grasp = |l: f64, f: f64| {
            let contacts = places.iter().zip(&sizes).map(|([p, n, axis], [radius, k, preload])| {
                let operator = Mat::outer(*axis, *axis) + Mat::IDENTITY * 0.25;
                let place = Geometry {
                    point: *p * l,
                    inward_normal: *n,
                    finger: Curvature::round(radius * l),
                    part: Curvature::of_shape_operator(operator * (1.0 / l)),
                };
                Contact::new(place, law(&place, [l, f], *k), 0.1 * preload * f).unwrap()
            });
            let load = DeadLoad { point: places[0][1] * l, force: places[0][2] * f };
            Grasp::<N, M>::new(contacts.collect()).unwrap().with_loads(vec![load]).unwrap()
        };
        let (one, other) = (grasp(1.0, 1.0), grasp(length, force));
        assert_eq!(other.centroid(), one.centroid() * length);
        let k = |g: &Grasp<N, M>| g.stiffness(g.centroid(), Order::Second);
        assert_eq!(k(&other).translational, k(&one).translational * (force / length));
        assert_eq!(k(&other).coupling, k(&one).coupling * force);
        assert_eq!(k(&other).rotational, k(&one).rotational * (force * length));
        assert_eq!(other.stability(), one.stability());
        assert_eq!(other.preloads().unwrap(), one.preloads().unwrap());
        assert_eq!(other.equilibrium().relative_force, one.equilibrium().relative_force);
        assert_eq!(other.equilibrium().relative_torque, one.equilibrium().relative_torque);
    }
}

#[test]
fn lengths_and_forces_by_powers_of_64_change_the_units_exactly() {
    units_change_exactly::<2, 1>(23, |_, [l, f], k| Law::linear(k * f / l).unwrap());
    units_change_exactly::<3, 3>(30, |place, [l, f], k| {
        Law::hertz(k * f / (l * l), place).unwrap()
    });
}

/// The balanced preloads are all of them: each null vector balances, and their number is that of
/// the contacts less the rank.
#[test]
fn null_vectors_balance() {
    let r = &mut Random::new(24);
    for pairs in [2, 3, 4, 6] {
        let grasp = balanced::<3, 3>(r, pairs);
        let preloads = grasp.preloads().unwrap();
        let count = grasp.contacts().len();
        assert_eq!(preloads.basis.len(), count - preloads.rank);
        for shares in preloads.basis.iter().chain(preloads.best.as_ref().map(|b| &b.shares)) {
            let mut net = clench_screw::Wrench::<3, 3>::ZERO;
            let mut scale = 0.0;
            for (c, f) in grasp.contacts().iter().zip(shares) {
                net += c.unit_wrench(Vector::ZERO) * *f;
                scale += f.abs() * c.overlap().point().norm().max(1.0);
            }
            assert!(net.force.norm() <= 1e-13 * scale && net.torque.norm() <= 1e-13 * scale);
        }
    }
}

/// From the best preload no way along the balanced ones leads to a stronger weakest finger. The
/// fingers are scattered around a ball, so that the best shares are all different.
#[test]
fn the_best_preload_has_the_strongest_weakest_finger() {
    let r = &mut Random::new(31);
    let mut improvable = 0;
    for _ in 0..100 {
        let contacts = (0..10).map(|_| {
            let (point, aside): (Vector<3>, Vector<3>) = (r.array(1.0).into(), r.array(0.5).into());
            let place = Geometry::on_face(point, aside - point, 0.1);
            Contact::<3, 3>::new(place, Law::linear(1.0).unwrap(), 0.0).unwrap()
        });
        let grasp = Grasp::new(contacts.collect()).unwrap();
        let preloads = grasp.preloads().unwrap();
        let best = preloads.best.expect("ten fingers have balanced preloads with a total");
        let spread = best.shares.iter().copied().fold(0.0, f64::max) - best.margin;
        improvable += usize::from(spread > 0.01);
        for step in [1e-3, 1e-2, 0.1, 1.0] {
            for _ in 0..100 {
                let mut shares = best.shares.clone();
                for b in &preloads.basis {
                    let step = r.between(-step, step);
                    shares.iter_mut().zip(b).for_each(|(f, x)| *f += step * x);
                }
                let total: f64 = shares.iter().sum();
                let least = shares.iter().copied().fold(f64::INFINITY, f64::min);
                assert!(total <= 0.0 || least / total <= best.margin + 1e-9);
            }
        }
    }
    assert!(improvable > 90, "{improvable}");
}

#[test]
fn the_net_wrench_is_the_sum_of_the_contact_forces() {
    let r = &mut Random::new(25);
    let grasp = balanced::<3, 3>(r, 3);
    let (found, wanted) = (grasp.net_wrench(Vector::ZERO), net_wrench(&grasp));
    for i in 0..3 {
        assert_close(found.force[i], wanted.force[i], 1e-15, 4.0, "force");
        assert_close(found.torque[i], wanted.torque[i], 1e-15, 8.0, "torque");
    }
}

/// Two opposite fingers leave the body free along their faces. Turning stretches the distance
/// between parallel faces to `h / cos(phi)`: that presses fingers which pinch a slab, and frees
/// fingers which spread a slot, unless their radii exceed the half width.
#[test]
fn two_opposite_fingers_pinch_marginally_and_spread_unstably() {
    let pair = |direction: f64, radius: f64| {
        let law = Law::linear(10.0).unwrap();
        let finger = |y: f64| {
            let normal = Vector::new([0.0, y * direction]);
            Contact::<2, 1>::new(
                Geometry::on_face(Vector::new([0.0, y]), normal, radius),
                law.clone(),
                1.0,
            )
            .unwrap()
        };
        Grasp::new(vec![finger(0.5), finger(-0.5)]).unwrap().stability()
    };
    assert_eq!(pair(-1.0, 0.0), Stability::Marginal);
    assert_eq!(pair(1.0, 0.1), Stability::Unstable);
    assert_eq!(pair(1.0, 0.7), Stability::Marginal);
}

/// Out of balance the stiffness about another origin is not the congruent one: it differs by what
/// the residual force does along the way. Both are Hessians of the energy, each in its own chart.
fn unbalanced_stiffness_moves_with_a_correction<const N: usize, const M: usize>(
    chart: Chart<N, M>,
    seed: u64,
) {
    let r = &mut Random::new(seed);
    for _ in 0..20 {
        let whole = loaded::<N, M>(r);
        let grasp = Grasp::new(whole.contacts().to_vec()).unwrap();
        let equilibrium = grasp.equilibrium();
        assert!(!equilibrium.holds);
        assert_eq!(
            equilibrium.required(),
            Err(GraspError::Unbalanced {
                force: equilibrium.relative_force,
                torque: equilibrium.relative_torque
            })
        );
        let shift: Vector<N> = r.array(2.0).into();
        check_energy(&grasp, Vector::ZERO, chart);
        check_energy(&grasp, shift, chart);
        let (here, there) =
            (grasp.stiffness(Vector::ZERO, Order::Second), grasp.stiffness(shift, Order::Second));
        // With the gradient g: (g . r) omega^2 - (g . omega) (r . omega), what a dead load g at r
        // would add.
        let residual = grasp.net_wrench(Vector::ZERO).force;
        let missing = DeadLoad { point: shift, force: residual * -1.0 };
        let corrected = (here + missing.stiffness(Vector::ZERO)).in_frame(&Frame::at(shift));
        same(&there, &corrected, 1e-13, "correction");
    }
}

#[test]
fn an_unbalanced_stiffness_moves_with_a_correction_in_the_plane_and_in_space() {
    unbalanced_stiffness_moves_with_a_correction(planar_chart, 26);
    unbalanced_stiffness_moves_with_a_correction(spatial_chart, 27);
}

/// A weight that hangs below the fingers turns back, one above them topples: the share of a
/// pendulum is weight times arm.
#[test]
fn a_weight_below_the_fingers_holds_and_one_above_topples() {
    for (height, wanted) in [(-2.0, 6.0), (2.0, -6.0)] {
        let weight =
            DeadLoad { point: Vector::new([0.0, height]), force: Vector::new([0.0, -3.0]) };
        assert_eq!(weight.stiffness::<1>(Vector::ZERO).rotational[0][0], wanted);
        let turned = planar::Frame::new([0.0, 0.0], 0.1);
        let energy = -3.0 * height * (1.0 - 0.1_f64.cos());
        assert_close(weight.energy_after(&turned), energy, 1e-15, 1.0, "energy");
    }
}

/// Two fingers of radius 5 pinch a part along a line, 20 apart, with 100 N and slopes of 1000:
/// turning is resisted by 2 f (w + R) between flat faces, and on round faces of radius rho only if
/// the part's centers of curvature are beyond each other, rho > w; sliding never is.
#[test]
fn a_pinched_part_turns_back_if_its_faces_are_flatter_than_its_width() {
    let (w, radius, force) = (10.0, 5.0, 100.0);
    for rho in [f64::INFINITY, 30.0, 8.0, -20.0] {
        let finger = |side: f64| {
            let place = Geometry {
                point: Vector::new([side * w, 0.0]),
                inward_normal: Vector::new([-side, 0.0]),
                finger: Curvature::round(radius),
                part: Curvature::round(rho),
            };
            // A law whose overlap vanishes beside the radii leaves the undeformed geometry.
            let law = Law::power(1e21, 1.0).unwrap();
            Contact::<2, 1>::new(place, law, force).unwrap()
        };
        let grasp = Grasp::new(vec![finger(1.0), finger(-1.0)]).unwrap();
        let found = grasp.preload_stiffness(Vector::ZERO);
        let (slide, turn) = if rho.is_infinite() {
            (0.0, 2.0 * force * (w + radius))
        } else {
            let sum = radius + rho;
            (-2.0 * force / sum, -2.0 * force * (w + radius) * (w - rho) / sum)
        };
        assert_close(found.translational[1][1], slide, 1e-13, force, format!("slide {rho}"));
        assert_close(found.rotational[0][0], turn, 1e-13, force * w, format!("turn {rho}"));
    }
}
