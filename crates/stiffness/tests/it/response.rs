//! Contact forces under a displacement, against fingers that are really moved.

use clench_contact::{Contact, Geometry, Law};
use clench_screw::{Frame, Twist, Vector, planar, spatial};
use clench_stiffness::{Grasp, LiftOff};
use clench_testkit::{Random, assert_close};

use crate::random::balanced_and_curved;

/// Central differences of the force of each law at the depth that the moved body has.
fn changes_are_those_of_the_moved_body<const N: usize, const M: usize>(
    placed: impl Fn(&Twist<N, M>) -> Frame<N, M>,
    seed: u64,
) {
    let r = &mut Random::new(seed);
    for _ in 0..30 {
        let grasp = balanced_and_curved::<N, M>(r, 3);
        let origin: Vector<N> = r.array(1.0).into();
        let twist = Twist { linear: r.array(1.0).into(), angular: r.array(1.0).into() };
        let changes = grasp.force_changes(origin, &twist);
        let step = 1e-5;
        for (contact, change) in grasp.contacts().iter().zip(&changes) {
            let force = |h: f64| {
                // The body's motion about `origin`, seen from the frame's own.
                let moved = Frame::at(origin) * placed(&(twist * h)) * Frame::at(-origin);
                contact.law().force(contact.overlap().depth_after(&moved))
            };
            let slope = (force(step) - force(-step)) / (2.0 * step);
            assert_close(*change, slope, 1e-7, slope.abs().max(1.0), "change");
        }
        let first = grasp.first_to_lift_off(&changes).unwrap();
        let left =
            |(i, change): (usize, f64)| grasp.contacts()[i].preload() + first.load_factor * change;
        let least = changes.iter().copied().enumerate().map(left).fold(f64::INFINITY, f64::min);
        let of_first = left((first.contact, changes[first.contact]));
        assert_close(of_first, 0.0, 1e-14, 1.0, "used up");
        assert_close(least, 0.0, 1e-14, 1.0, "and no other before");
    }
}

#[test]
fn changes_are_those_of_the_moved_body_in_the_plane_and_in_space() {
    changes_are_those_of_the_moved_body(
        |q: &Twist<2, 1>| planar::Frame::new(q.linear.to_array(), q.angular[0]),
        91,
    );
    changes_are_those_of_the_moved_body(
        |q: &Twist<3, 3>| spatial::Frame::new(q.linear.to_array(), q.angular.to_array()),
        92,
    );
}

fn locator(point: [f64; 3], normal: [f64; 3], preload: f64) -> Contact<3, 3> {
    let place = Geometry::on_face(point.into(), normal.into(), 0.0);
    Contact::new(place, Law::linear(100.0).unwrap(), preload).unwrap()
}

/// Slid along a linear law, a finger comes free just where the factor says.
#[test]
fn a_finger_comes_free_at_its_factor() {
    let grasp = Grasp::new(vec![
        locator([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], 3.0),
        locator([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], 3.0),
    ])
    .unwrap();
    let twist = Twist { linear: [0.01, 0.0, 0.0].into(), angular: Vector::ZERO };
    let changes = grasp.force_changes(Vector::ZERO, &twist);
    let first = grasp.first_to_lift_off(&changes);
    assert_eq!(first, Some(LiftOff { contact: 0, load_factor: 3.0 }));
    let depth = |s: f64| {
        let moved = spatial::Frame::new([0.01 * s, 0.0, 0.0], [0.0; 3]);
        grasp.contacts()[0].overlap().depth_after(&moved)
    };
    assert!(depth(2.999) > 0.0 && depth(3.001) < 0.0);
}

/// What is nothing but rounding takes no finger off, and one without preload comes off at once.
#[test]
fn a_load_along_the_supports_leaves_the_side_locators_alone() {
    let mut contacts = vec![
        locator([-0.7, -0.7, -1.0], [0.0, 0.0, 1.0], 0.0),
        locator([0.7, -0.7, -1.0], [0.0, 0.0, 1.0], 0.0),
        locator([0.0, 0.7, -1.0], [0.0, 0.0, 1.0], 0.0),
        locator([-0.7, -1.0, 0.0], [0.0, 1.0, 0.0], 0.0),
        locator([0.7, -1.0, 0.0], [0.0, 1.0, 0.0], 0.0),
        locator([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], 0.0),
    ];
    let down = Twist { linear: [1e-17, -1e-17, -0.1].into(), angular: [0.01, 0.02, 1e-18].into() };
    let grasp = Grasp::new(contacts.clone()).unwrap();
    let changes = grasp.force_changes(Vector::ZERO, &down);
    assert!(changes[..3].iter().all(|change| *change > 0.0), "{changes:?}");
    assert_eq!(changes[3..], [0.0; 3]);
    assert_eq!(grasp.first_to_lift_off(&changes), None);

    contacts.push(locator([0.0, 0.0, 1.0], [0.0, 0.0, -1.0], 0.0));
    let grasp = Grasp::new(contacts).unwrap();
    let first = grasp.first_to_lift_off(&grasp.force_changes(Vector::ZERO, &down));
    assert_eq!(first, Some(LiftOff { contact: 6, load_factor: 0.0 }));
}
