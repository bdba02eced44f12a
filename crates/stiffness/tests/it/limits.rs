//! Degenerate grasps, each with its exact answer or error.

use clench_contact::{Contact, Geometry, Law};
use clench_screw::Vector;
use clench_stiffness::{DeadLoad, Grasp, GraspError, Stability};

fn finger(x: f64, y: f64, nx: f64, ny: f64, preload: f64) -> Contact<2, 1> {
    let law = Law::linear(1.0).unwrap();
    Contact::new(Geometry::on_face(Vector::new([x, y]), Vector::new([nx, ny]), 0.0), law, preload)
        .unwrap()
}

#[test]
fn a_grasp_needs_a_contact() {
    assert_eq!(Grasp::<2, 1>::new(vec![]), Err(GraspError::NoContacts));
}

#[test]
fn a_stiffness_that_overflows_is_refused_with_its_contact() {
    let contacts = vec![finger(0.0, 0.0, 1.0, 0.0, 0.0), finger(1e200, 1e200, 0.0, 1.0, 0.0)];
    assert_eq!(Grasp::new(contacts), Err(GraspError::OutOfRange { contact: 0 }));
}

#[test]
fn a_load_that_is_not_finite_is_refused_with_its_number() {
    let good = DeadLoad { point: Vector::ZERO, force: Vector::new([0.0, -1.0]) };
    let grasp = || Grasp::new(vec![finger(0.0, 0.0, 0.0, 1.0, 1.0)]).unwrap();
    for bad in [
        DeadLoad { point: Vector::new([f64::NAN, 0.0]), ..good },
        DeadLoad { force: Vector::new([0.0, f64::INFINITY]), ..good },
        DeadLoad { point: Vector::new([1e200, 0.0]), force: Vector::new([1e200, 0.0]) },
        DeadLoad { point: Vector::new([1e200, 0.0]), force: Vector::new([0.0, 1e200]) },
    ] {
        let found = grasp().with_loads(vec![good, bad]);
        assert_eq!(found, Err(GraspError::Load { load: 1 }));
    }
    // So large that its square overflows, and two whose sum does.
    let large = DeadLoad { point: Vector::ZERO, force: Vector::new([0.0, -1e160]) };
    assert!(!grasp().with_loads(vec![large]).unwrap().equilibrium().holds);
    let larger = DeadLoad { point: Vector::ZERO, force: Vector::new([0.0, -1e308]) };
    let found = grasp().with_loads(vec![larger, larger]);
    assert_eq!(found, Err(GraspError::Load { load: 1 }));
    // One finger carries a weight above it.
    let carried = grasp().with_loads(vec![good]).unwrap();
    assert!(carried.equilibrium().holds);
    assert_eq!(grasp().equilibrium().relative_force, 1.0);
}

/// The sum is out of range though each share is not, and the last one is to blame.
#[test]
fn a_sum_that_overflows_is_refused_with_its_contact() {
    let stiff = || {
        let place = Geometry::on_face(Vector::new([0.0, 0.0]), Vector::new([0.0, 1.0]), 0.0);
        Contact::<2, 1>::new(place, Law::linear(1.2e308).unwrap(), 0.0).unwrap()
    };
    let found = Grasp::new(vec![stiff(), stiff()]);
    assert_eq!(found, Err(GraspError::OutOfRange { contact: 1 }));
}

#[test]
fn stiffnesses_of_any_size_are_judged_alike() {
    for k in [5e-324, 1e-310, 1.0, 1e300] {
        let finger = |x: f64, y: f64, nx: f64, ny: f64| {
            let place = Geometry::on_face(Vector::new([x, y]), Vector::new([nx, ny]), 0.0);
            Contact::<2, 1>::new(place, Law::linear(k).unwrap(), 0.0).unwrap()
        };
        let pair = vec![finger(0.0, 1.0, 0.0, -1.0), finger(0.0, -1.0, 0.0, 1.0)];
        assert_eq!(Grasp::new(pair).unwrap().stability(), Stability::Marginal, "{k:e}");
    }
}

/// The only balanced forces have the total zero: one pulls as much as the others press.
#[test]
fn forces_that_balance_without_a_total_are_no_preload() {
    let turned = |angle: f64| {
        let (s, c) = angle.sin_cos();
        let finger = |x: f64, normal: f64| {
            let place = Geometry::on_face(
                Vector::new([c * x, s * x]),
                Vector::new([-s * normal, c * normal]),
                0.0,
            );
            Contact::<2, 1>::new(place, Law::linear(1.0).unwrap(), 0.0).unwrap()
        };
        // Parallel, at 0, 1 and 3: forces 2, -3 and 1.
        Grasp::new(vec![finger(0.0, 1.0), finger(1.0, 1.0), finger(3.0, 1.0)]).unwrap()
    };
    for i in 0..200 {
        let preloads = turned(0.031 * f64::from(i)).preloads().unwrap();
        assert_eq!((preloads.best, preloads.force_closure), (None, false), "{i}");
    }
}

/// A load that does nothing, however far away, makes no couple look small.
#[test]
fn a_far_load_hides_no_torque() {
    for force in [0.0, 1e-9] {
        let contacts = vec![finger(-1.0, 0.0, 0.0, 1.0, 1.0), finger(1.0, 0.0, 0.0, -1.0, 1.0)];
        let load = DeadLoad { point: Vector::new([1e9, 0.0]), force: Vector::new([force, 0.0]) };
        let grasp = Grasp::new(contacts).unwrap().with_loads(vec![load]).unwrap();
        let equilibrium = grasp.equilibrium();
        assert!(!equilibrium.holds && equilibrium.relative_torque > 0.1);
    }
}

#[test]
fn forces_of_any_size_are_judged_alike() {
    for size in [1e-300, 1.0, 1e150] {
        let pair = |left: f64| {
            let law = || Law::linear(1.0).unwrap();
            let finger = |x: f64, f: f64| {
                let place = Geometry::on_face(Vector::new([x, 0.0]), Vector::new([-x, 0.0]), 0.0);
                Contact::<2, 1>::new(place, law(), f).unwrap()
            };
            Grasp::new(vec![finger(1.0, left), finger(-1.0, size)]).unwrap().equilibrium()
        };
        assert!(pair(size).holds);
        assert!((pair(0.5 * size).relative_force - 1.0 / 3.0).abs() < 1e-15);
    }
}

/// The mean of three equal numbers may be another one; that is no length.
#[test]
fn contacts_in_one_place_have_no_length_wherever_that_is() {
    for place in [[0.1, 0.7], [0.3, 0.9], [1e6, 1e-3]] {
        let contacts = (0..3).map(|i| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / 3.0).sin_cos();
            let place = Geometry::on_face(place.into(), Vector::new([cos, sin]), 0.5);
            Contact::<2, 1>::new(place, Law::linear(1.0).unwrap(), 0.2).unwrap()
        });
        let grasp = Grasp::new(contacts.collect()).unwrap();
        assert_eq!(grasp.length(), 0.0);
        assert_eq!(grasp.stability(), Stability::SecondOrder, "{place:?}");
    }
}

#[test]
fn one_finger_holds_nothing() {
    let grasp = Grasp::new(vec![finger(1.0, 1.0, 0.0, 1.0, 0.0)]).unwrap();
    assert_eq!(grasp.stability(), Stability::Marginal);
    let preloads = grasp.preloads().unwrap();
    assert_eq!((preloads.rank, preloads.best, preloads.force_closure), (1, None, false));
    assert!(grasp.equilibrium().holds);
}

#[test]
fn unbalanced_preloads_are_shown_with_their_residual() {
    let contacts = vec![finger(2.0, 0.0, 0.0, 1.0, 3.0), finger(2.0, 1.0, 0.0, -1.0, 1.0)];
    let equilibrium = Grasp::new(contacts).unwrap().equilibrium();
    assert!(!equilibrium.holds);
    assert_eq!(equilibrium.residual.force, Vector::new([0.0, 2.0]));
    assert_eq!(equilibrium.residual.torque, Vector::new([0.0]));
}

/// Four springs hold the part in every direction, yet it can be lifted away: the stiffness is
/// positive definite, and there is no force closure.
#[test]
fn a_positive_definite_stiffness_is_not_force_closure() {
    let contacts = vec![
        finger(-1.0, 0.0, 0.0, 1.0, 0.0),
        finger(1.0, 0.0, 0.0, 1.0, 0.0),
        finger(-2.0, 1.0, 1.0, 0.0, 0.0),
        finger(2.0, 1.0, -1.0, 0.0, 0.0),
    ];
    let grasp = Grasp::new(contacts).unwrap();
    assert_eq!(grasp.stability(), Stability::FirstOrder);
    let preloads = grasp.preloads().unwrap();
    assert_eq!((preloads.rank, preloads.force_closure), (3, false));
    // The two that face each other balance alone: the others carry nothing.
    let best = preloads.best.unwrap();
    assert!(best.margin.abs() < 1e-15, "{}", best.margin);
}

/// A fifth finger that presses on a side with nothing opposite carries nothing in any balance, and
/// without it the part slides.
#[test]
fn a_finger_without_an_opposite_is_unopposed() {
    let contacts = vec![
        finger(3.0, 0.0, 0.0, 1.0, 1.0),
        finger(7.0, 0.0, 0.0, 1.0, 1.0),
        finger(3.0, 10.0, 0.0, -1.0, 1.0),
        finger(7.0, 10.0, 0.0, -1.0, 1.0),
        finger(0.0, 5.0, 1.0, 0.0, 0.0),
    ];
    let grasp = Grasp::new(contacts).unwrap();
    assert_eq!(grasp.stability(), Stability::FirstOrder);
    let preloads = grasp.preloads().unwrap();
    assert_eq!((preloads.unopposed.as_slice(), preloads.force_closure), ([4].as_slice(), false));
    let rest = grasp.retain(|contact| !preloads.unopposed.contains(&contact)).unwrap();
    assert_eq!(rest.contacts().len(), 4);
    assert_eq!(rest.stability(), Stability::Marginal);
    assert_eq!(rest.retain(|_| false), Err(GraspError::NoContacts));

    // With one opposite to it nothing is left to say, aligned with it or not.
    for height in [5.0, 6.0] {
        let mut contacts = grasp.contacts().to_vec();
        contacts.push(finger(10.0, height, -1.0, 0.0, 0.0));
        assert!(Grasp::new(contacts).unwrap().preloads().unwrap().unopposed.is_empty());
    }
    // One finger alone, and two that press the same way, are all unopposed.
    let same = vec![finger(0.0, 0.0, 0.0, 1.0, 0.0), finger(1.0, 0.0, 0.0, 1.0, 0.0)];
    assert_eq!(Grasp::new(same).unwrap().preloads().unwrap().unopposed, [0, 1]);
    // So are very many, which are looked at as one.
    let row = (0..300).map(|i| finger(0.0, f64::from(i), 1.0, 0.0, 0.0)).collect();
    let all = Grasp::new(row).unwrap().preloads().unwrap().unopposed;
    assert_eq!(all, (0..300).collect::<Vec<_>>());
    let one = vec![finger(0.0, 0.0, 0.0, 1.0, 0.0)];
    assert_eq!(Grasp::new(one).unwrap().preloads().unwrap().unopposed, [0]);
}

/// Four fingers at the limit of closure, where one of them carries nothing, are opposed: moved a
/// little along their edges they close.
#[test]
fn fingers_at_the_limit_of_closure_are_opposed() {
    let contacts = vec![
        finger(-1.0, 0.0, 1.0, 0.0, 0.0),
        finger(1.0, 0.0, -1.0, 0.0, 0.0),
        finger(0.5, -1.0, 0.0, 1.0, 0.0),
        finger(-0.5, 1.0, 0.0, -1.0, 0.0),
    ];
    let preloads = Grasp::new(contacts).unwrap().preloads().unwrap();
    assert!(preloads.best.unwrap().margin.abs() < 1e-15);
    assert!(preloads.unopposed.is_empty());
}

#[test]
fn coincident_contacts_of_pointed_fingers_are_judged_without_a_length() {
    let grasp = Grasp::new(vec![finger(1.0, 1.0, 0.0, 1.0, 0.0); 3]).unwrap();
    assert_eq!(grasp.stability(), Stability::Marginal);
    assert_eq!(grasp.preloads().unwrap().rank, 1);
}

/// Two pairs of exactly opposite directions, on the quadrilateral of LBR: what is feasible is
/// decided by the last digit, which a linear program need not find.
#[test]
fn exactly_opposite_fingers_leave_no_preload_undecided() {
    let r = &mut clench_testkit::Random::new(17);
    let corners = [[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]];
    for _ in 0..400 {
        let count = 4 + r.below(5);
        let contacts = (0..count).map(|_| {
            let edge = r.below(4);
            let (start, end) = (Vector::new(corners[edge]), Vector::new(corners[(edge + 1) % 4]));
            let along = (end - start) * (end - start).norm().recip();
            let point = start + (end - start) * r.between(0.05, 0.95);
            finger(point[0], point[1], -along[1], along[0], 0.0)
        });
        let grasp = Grasp::new(contacts.collect()).unwrap();
        let preloads = grasp.preloads().unwrap();
        if preloads.force_closure {
            assert_eq!(preloads.unopposed, [0; 0]);
            continue;
        }
        // A finger is unopposed if and only if no others have normals that surround its opposite:
        // all normals that are not parallel to its own lie to one side of it, or none faces it.
        let normal = |i: usize| grasp.contacts()[i].overlap().inward_normal();
        for i in 0..count {
            let sides = (0..count).map(|j| {
                let (one, other) = (normal(i), normal(j));
                (one[0] * other[1] - one[1] * other[0], one.dot(other))
            });
            let sides: Vec<(f64, f64)> = sides.collect();
            let facing = sides.iter().any(|&(cross, dot)| cross.abs() < 1e-12 && dot < 0.0);
            let left = sides.iter().filter(|(cross, _)| *cross > 1e-12);
            let right: Vec<_> = sides.iter().filter(|(cross, _)| *cross < -1e-12).collect();
            // A pair on both sides surrounds the opposite if it turns by more than a half.
            let surrounds = left.into_iter().any(|&(cross, dot)| {
                right.iter().any(|&&(other, along)| cross * along - dot * other < -1e-12)
            });
            let opposed = facing || surrounds;
            assert_eq!(!preloads.unopposed.contains(&i), opposed, "{i}");
        }
    }
}

/// Three fingers at the points where the incircle touches a triangle, to nine digits: preloads that
/// balance to the digits of the file are preloads that balance.
#[test]
fn preloads_balance_for_points_of_few_digits_too() {
    let grasp = |digits: i32| {
        let rounded = |x: f64| (x * 10_f64.powi(digits)).round() / 10_f64.powi(digits);
        let sides =
            [([0.0, 0.0], [10.0, 0.0]), ([10.0, 0.0], [3.0, 7.0]), ([3.0, 7.0], [0.0, 0.0])];
        let lengths = sides.map(|(a, b)| (Vector::from(b) - Vector::from(a)).norm());
        let half = lengths.iter().sum::<f64>() / 2.0;
        let contact = |i: usize| {
            let (start, end) = (Vector::new(sides[i].0), Vector::new(sides[i].1));
            let along = (end - start) * lengths[i].recip();
            // The tangent from a corner is as long as the half perimeter less the opposite side.
            let point = start + along * (half - lengths[(i + 1) % 3]);
            let preload = rounded(lengths[i] / (2.0 * half));
            finger(rounded(point[0]), rounded(point[1]), -along[1], along[0], preload)
        };
        Grasp::new((0..3).map(contact).collect()).unwrap()
    };
    for digits in [15, 12, 10, 9, 8] {
        let grasp = grasp(digits);
        assert!(grasp.equilibrium().holds, "{digits}");
        let preloads = grasp.preloads().unwrap();
        assert_eq!(preloads.rank, 2, "{digits}");
        assert!(preloads.best.unwrap().margin > 0.2, "{digits}");
    }
}
