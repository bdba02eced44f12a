//! Preloads that keep contacts on, against brute force and against grasps analyzed again.

use clench_contact::{Contact, Geometry, Law, Order};
use clench_screw::{Twist, Vector};
use clench_stiffness::{
    Basis, DeadLoad, Grasp, GraspError, LeastPreloads, Needed, NeededPreloads, Remedy,
};
use clench_testkit::{Random, assert_all_close, assert_close};

/// A contact of a finger with this law and preload.
fn finger(point: [f64; 2], normal: [f64; 2], law: Law, preload: f64) -> Contact<2, 1> {
    Contact::new(Geometry::on_face(point.into(), normal.into(), 0.3), law, preload).unwrap()
}

fn linear(stiffness: f64) -> Law {
    Law::linear(stiffness).unwrap()
}

/// Two on the bottom, one on each other side of a square of side 2: two ways to balance.
fn clamped(laws: [Law; 5], preloads: [f64; 5]) -> Grasp<2, 1> {
    let places = [
        ([-0.6, -1.0], [0.0, 1.0]),
        ([0.8, -1.0], [0.0, 1.0]),
        ([1.0, 0.2], [-1.0, 0.0]),
        ([0.1, 1.0], [0.0, -1.0]),
        ([-1.0, 0.3], [1.0, 0.0]),
    ];
    let contacts = places.into_iter().zip(laws).zip(preloads);
    let contacts = contacts.map(|(((point, normal), law), f)| finger(point, normal, law, f));
    Grasp::new(contacts.collect()).unwrap()
}

/// Balanced, for [`clamped`].
const PRESENT: [f64; 5] = [1.0, 1.0 + 3.0 / 7.0, 3.0, 2.0 + 3.0 / 7.0, 3.0];

/// The displacement about the centroid by a load, from the rows of the stiffness, by elimination.
fn displacement(grasp: &Grasp<2, 1>, order: Order, load: [f64; 3]) -> Twist<2, 1> {
    let stiffness = grasp.stiffness(grasp.centroid(), order);
    let mut rows: Vec<Vec<f64>> =
        (0..3).map(|i| (0..3).map(|j| stiffness.entry(i, j)).chain([load[i]]).collect()).collect();
    for i in 0..3 {
        let pivot = (i..3).max_by(|&a, &b| rows[a][i].abs().total_cmp(&rows[b][i].abs())).unwrap();
        rows.swap(i, pivot);
        for k in 0..3 {
            if k != i {
                let factor = rows[k][i] / rows[i][i];
                for j in 0..4 {
                    rows[k][j] -= factor * rows[i][j];
                }
            }
        }
    }
    let q = [0, 1, 2].map(|i| rows[i][3] / rows[i][i]);
    Twist { linear: [q[0], q[1]].into(), angular: [q[2]].into() }
}

fn changes(grasp: &Grasp<2, 1>, order: Order, loads: &[[f64; 3]]) -> Vec<Vec<f64>> {
    let of =
        |&load: &[f64; 3]| grasp.force_changes(grasp.centroid(), &displacement(grasp, order, load));
    loads.iter().map(of).collect()
}

fn found(needed: NeededPreloads) -> Needed {
    let NeededPreloads::Found(needed) = needed else { panic!("{needed:?}") };
    needed
}

/// The load factor at which the first contact of `grasp` lifts off, with these preloads.
fn lift_off(grasp: &Grasp<2, 1>, order: Order, loads: &[[f64; 3]]) -> f64 {
    let of = |changes: &Vec<f64>| grasp.first_to_lift_off(changes).map(|first| first.load_factor);
    let factors = changes(grasp, order, loads).iter().filter_map(of).collect::<Vec<_>>();
    factors.into_iter().fold(f64::INFINITY, f64::min)
}

/// Every way to balance is scanned: by its angle in the plane of the two null vectors.
#[test]
fn the_least_sum_is_that_of_a_scan_over_all_balanced_preloads() {
    let r = &mut Random::new(611);
    for _ in 0..20 {
        let laws = [(); 5].map(|()| linear(r.between(50.0, 200.0)));
        let grasp = clamped(laws, [0.0; 5]);
        let least: Vec<f64> = (0..5).map(|_| r.between(-1.0, 2.0).max(0.0)).collect();
        let LeastPreloads::Found(preloads) = grasp.least_preloads(&least).unwrap() else {
            panic!("each pair of opposite sides can be pressed")
        };
        for (force, least) in preloads.iter().zip(&least) {
            assert!(*force >= least - 1e-12, "{preloads:?} {least:?}");
        }
        // About the middle of the bottom, from the geometry alone: forces and torques balance.
        let [a, b, c, d, e] = preloads[..] else { panic!() };
        let balance = [e - c, a + b - d, -0.6 * a + 0.8 * b - 0.1 * d + 0.2 * c - 0.3 * e];
        for left in balance {
            assert_close(left, 0.0, 1e-12, 1.0, "balance");
        }
        // All ways: c = e turns the part by 0.1 e, which takes a seventh more at b than at a.
        let mut best = f64::INFINITY;
        for step in 0..40_000 {
            let angle = std::f64::consts::FRAC_PI_2 * f64::from(step) / 40_000.0;
            let (up, across) = angle.sin_cos();
            let right = up + across / 7.0;
            let ways = [up, right, across, up + right, across];
            let size = least.iter().zip(ways).map(|(least, way)| least / way).fold(0.0, f64::max);
            if size.is_finite() {
                best = best.min(size * ways.iter().sum::<f64>());
            }
        }
        let total: f64 = preloads.iter().sum();
        assert!(total <= best * (1.0 + 1e-12), "{total} {best}");
        assert_close(total, best, 1e-3, total, "total");
    }
}

#[test]
fn analyzed_again_a_linear_grasp_keeps_its_contacts_up_to_the_load_and_no_further() {
    let loads = [[3.0, 1.0, 0.5], [0.0, 4.0, -1.0], [-2.0, -1.0, 1.0]];
    let laws = || [100.0, 130.0, 80.0, 100.0, 90.0].map(linear);
    let grasp = clamped(laws(), PRESENT);
    assert!(grasp.equilibrium().holds);
    for order in [Order::First, Order::Second] {
        let changes_of = |grasp: &Grasp<2, 1>| Some(changes(grasp, order, &loads));
        let mut totals = Vec::new();
        for remedy in [Remedy::Least, Remedy::Scaled] {
            let needed = found(grasp.needed_preloads(remedy, 0.0, changes_of).unwrap());
            assert_eq!(needed.basis, Basis::Needed);
            let preloads: [f64; 5] = needed.preloads.clone().try_into().unwrap();
            let again = clamped(laws(), preloads);
            assert!(again.equilibrium().holds);
            assert_close(lift_off(&again, order, &loads), 1.0, 1e-9, 1.0, "load factor");
            assert_eq!(needed.changes.len(), loads.len());
            for (old, new) in needed.changes.iter().zip(changes(&again, order, &loads)) {
                assert_all_close(old, &new, 1e-9, "changes");
            }
            let less = preloads.map(|preload| 0.999 * preload);
            assert!(lift_off(&clamped(laws(), less), order, &loads) < 0.9995);
            if remedy == Remedy::Scaled {
                let ratios: Vec<f64> = preloads.iter().zip(PRESENT).map(|(a, b)| a / b).collect();
                assert_all_close(&ratios, &[ratios[0]; 5], 1e-12, "one ratio");
                let factor = lift_off(&grasp, Order::First, &loads).recip();
                if order == Order::First {
                    assert_close(ratios[0], factor, 1e-12, factor, "by hand");
                }
            }
            totals.push(preloads.iter().sum::<f64>());
        }
        assert!(totals[0] < 0.99 * totals[1], "{totals:?}");
    }
}

/// A reserve of a fifth is a load of five fourths.
#[test]
fn a_reserve_is_what_is_left_of_each_preload() {
    let loads = [[3.0, 1.0, 0.5], [0.0, 4.0, -1.0]];
    let grasp = clamped([100.0; 5].map(linear), PRESENT);
    let changes_of = |grasp: &Grasp<2, 1>| Some(changes(grasp, Order::First, &loads));
    for remedy in [Remedy::Least, Remedy::Scaled] {
        let [plain, reserved] = [0.0, 0.2]
            .map(|reserve| found(grasp.needed_preloads(remedy, reserve, changes_of).unwrap()));
        let more: Vec<f64> = plain.preloads.iter().map(|preload| 1.25 * preload).collect();
        assert_all_close(&reserved.preloads, &more, 1e-10, "a quarter more");
    }
    for reserve in [1.0, -0.1, f64::NAN] {
        let refused = grasp.needed_preloads(Remedy::Least, reserve, changes_of);
        assert!(matches!(refused, Err(GraspError::Reserve { .. })), "{refused:?}");
    }
}

/// Where the slope grows with the preload the changes do too, each contact's in its own way.
#[test]
fn preloads_of_laws_that_stiffen_settle_and_hold_when_analyzed_again() {
    let loads = [[3.0, 1.0, 0.5], [0.0, 4.0, -1.0]];
    let laws = || [300.0, 500.0, 200.0, 400.0, 100.0].map(|c| Law::power(c, 1.5).unwrap());
    let grasp = clamped(laws(), PRESENT);
    let changes_of = |grasp: &Grasp<2, 1>| Some(changes(grasp, Order::Second, &loads));
    for remedy in [Remedy::Least, Remedy::Scaled] {
        let needed = found(grasp.needed_preloads(remedy, 0.0, changes_of).unwrap());
        assert_eq!(needed.basis, Basis::Needed);
        let again = clamped(laws(), needed.preloads.try_into().unwrap());
        let factor = lift_off(&again, Order::Second, &loads);
        assert_close(factor, 1.0, 1e-8, 1.0, "load factor");
    }
}

/// A box that is pushed down on its two feet needs nothing from its sides, but with laws that have
/// no stiffness without force it slides between them then.
#[test]
fn what_needs_no_preload_may_still_need_one_to_be_stiff() {
    let sides = |law: &Law| {
        vec![
            finger([-0.6, -1.0], [0.0, 1.0], law.clone(), 8.0),
            finger([0.8, -1.0], [0.0, 1.0], law.clone(), 12.0),
            finger([0.2, 1.0], [0.0, -1.0], law.clone(), 20.0),
            finger([1.0, 0.2], [-1.0, 0.0], law.clone(), 10.0),
            finger([-1.0, 0.2], [1.0, 0.0], law.clone(), 10.0),
        ]
    };
    let loads = [[0.0, -3.0, 0.5]];
    let changes_of = |grasp: &Grasp<2, 1>| Some(changes(grasp, Order::First, &loads));
    let needed = |law: &Law| {
        let grasp = Grasp::new(sides(law)).unwrap();
        grasp.needed_preloads(Remedy::Least, 0.0, changes_of).unwrap()
    };
    let Needed { preloads, .. } = found(needed(&linear(100.0)));
    assert_all_close(&preloads[3..], &[0.0, 0.0], 1e-12, "the sides");
    for exponent in [1.2, 1.5] {
        let law = Law::power(300.0, exponent).unwrap();
        assert_eq!(needed(&law), NeededPreloads::NoLeast { contacts: vec![3, 4] });
    }
}

/// Nothing is known of a grasp that does not hold: then the first step is all there is.
#[test]
fn changes_that_are_not_known_leave_the_first_step() {
    let loads = [[3.0, 1.0, 0.5]];
    let grasp = clamped([100.0; 5].map(linear), PRESENT);
    let only_present =
        |other: &Grasp<2, 1>| (*other == grasp).then(|| changes(other, Order::First, &loads));
    let needed = found(grasp.needed_preloads(Remedy::Least, 0.0, only_present).unwrap());
    assert_eq!(
        (needed.basis, needed.changes),
        (Basis::Present, changes(&grasp, Order::First, &loads))
    );
    let never = grasp.needed_preloads(Remedy::Least, 0.0, |_| None).unwrap();
    assert_eq!(never, NeededPreloads::NoChanges);
}

/// Nothing presses from above: no preload of others holds the part down, nor does scaling.
#[test]
fn a_contact_that_nothing_opposes_is_named() {
    let law = || linear(100.0);
    let contacts = vec![
        finger([-0.6, -1.0], [0.0, 1.0], law(), 0.0),
        finger([0.8, -1.0], [0.0, 1.0], law(), 0.0),
        finger([1.0, 0.2], [-1.0, 0.0], law(), 3.0),
        finger([-1.0, 0.2], [1.0, 0.0], law(), 3.0),
    ];
    let grasp = Grasp::new(contacts).unwrap();
    let lifted = grasp.least_preloads(&[0.0, 1.0, 1.0, 0.0]).unwrap();
    assert_eq!(lifted, LeastPreloads::Unreachable { contacts: vec![1] });
    let LeastPreloads::Found(sides) = grasp.least_preloads(&[0.0, 0.0, 1.0, 2.0]).unwrap() else {
        panic!()
    };
    assert_all_close(&sides, &[0.0, 0.0, 2.0, 2.0], 1e-12, "the sides press each other");
    let lifts = |_: &Grasp<2, 1>| Some(vec![vec![-1.0, 0.0, -1.0, 1.0]]);
    let named = |contacts| NeededPreloads::Unreachable { contacts };
    assert_eq!(grasp.needed_preloads(Remedy::Least, 0.0, lifts).unwrap(), named(vec![0]));
    let scaled = grasp.needed_preloads(Remedy::Scaled, 0.0, lifts).unwrap();
    assert_eq!(scaled, NeededPreloads::NoPreload { contacts: vec![0] });
}

/// A weight of 5 on two fingers at -0.6 and 0.8, above 0.1: half and half, whatever is asked for.
#[test]
fn weights_are_balanced_and_bound_what_can_be_had() {
    let law = || linear(100.0);
    let weighed = |force: [f64; 2], preload: f64| {
        let contacts = vec![
            finger([-0.6, -1.0], [0.0, 1.0], law(), preload),
            finger([0.8, -1.0], [0.0, 1.0], law(), preload),
        ];
        let load = DeadLoad { point: Vector::new([0.1, 0.0]), force: force.into() };
        Grasp::new(contacts).unwrap().with_loads(vec![load]).unwrap()
    };
    for present in [2.5, 0.0] {
        let grasp = weighed([0.0, -5.0], present);
        assert_eq!(grasp.equilibrium().holds, present > 0.0);
        let LeastPreloads::Found(found) = grasp.least_preloads(&[1.0, 2.0]).unwrap() else {
            panic!()
        };
        assert_all_close(&found, &[2.5, 2.5], 1e-12, "half each");
        let more = grasp.least_preloads(&[1.0, 3.0]).unwrap();
        assert_eq!(more, LeastPreloads::Unreachable { contacts: vec![1] });
    }
    // They cannot pull down, nor push aside.
    for force in [[0.0, 5.0], [1.0, -5.0]] {
        let found = weighed(force, 0.0).least_preloads(&[0.0, 0.0]).unwrap();
        assert_eq!(found, LeastPreloads::LoadsNotBalanced, "{force:?}");
    }
    let lifts = |_: &Grasp<2, 1>| Some(vec![vec![-1.0, 0.0]]);
    let scaled = weighed([0.0, -5.0], 2.5).needed_preloads(Remedy::Scaled, 0.0, lifts).unwrap();
    assert_eq!(scaled, NeededPreloads::NotByScaling);
}

#[test]
fn forces_that_are_none_are_refused() {
    let grasp = clamped([100.0; 5].map(linear), [0.0; 5]);
    let few = grasp.least_preloads(&[1.0, 2.0]);
    assert_eq!(few, Err(GraspError::LeastForces { found: 2, expected: 5 }));
    for value in [-1.0, f64::INFINITY] {
        let refused = grasp.least_preloads(&[0.0, 1.0, value, 0.0, 0.0]);
        assert_eq!(refused, Err(GraspError::LeastForce { contact: 2, value }));
    }
    let nothing = grasp.least_preloads(&[0.0; 5]).unwrap();
    assert_eq!(nothing, LeastPreloads::Found(vec![0.0; 5]));
}
