//! Contact forces from equilibrium, against closed forms and against grasps that balance.

use clench_contact::{Contact, Geometry, Law};
use clench_screw::Vector;
use clench_stiffness::{DeadLoad, Grasp, GraspError, reactions};
use clench_testkit::{Random, assert_close};

fn support<const N: usize>(point: [f64; N], normal: [f64; N]) -> Geometry<N> {
    Geometry::on_face(point.into(), normal.into(), 0.0)
}

/// Three balls in three grooves: each flank carries half of the load over its ball, by the cosine
/// of its slope.
#[test]
fn the_flanks_of_three_grooves_share_the_load() {
    let half = 3.0_f64.sqrt() / 2.0;
    let slope: f64 = 0.6; // Of a flank, its sine; the cosine is 0.8.
    let mut supports = Vec::new();
    let mut loads = Vec::new();
    for [x, y] in [[0.0, 1.0], [-half, -0.5], [half, -0.5]] {
        for side in [-1.0, 1.0] {
            let normal = [-side * y * slope, side * x * slope, 0.8];
            supports.push(support([300.0 * x, 300.0 * y, 0.0], normal));
        }
        let point = Vector::new([300.0 * x, 300.0 * y, 50.0]);
        loads.push(DeadLoad { point, force: Vector::new([0.0, 0.0, -80.0]) });
    }
    // Rounding of a handful of products, and of the singular values.
    for force in reactions::<3, 3>(&supports, &loads).unwrap() {
        assert_close(force, 50.0, 1e-13, 50.0, "force");
    }
    // A couple about the axis unloads every other flank: 300 . 0.6 per unit of its force.
    let push = |x: f64, force: f64| DeadLoad {
        point: Vector::new([x, 0.0, 0.0]),
        force: Vector::new([0.0, force, 0.0]),
    };
    loads.extend([push(10.0, 5400.0), push(-10.0, -5400.0)]);
    let turned = reactions::<3, 3>(&supports, &loads).unwrap();
    for (i, force) in turned.into_iter().enumerate() {
        assert_close(force, [150.0, -50.0][i % 2], 1e-13, 150.0, format!("force {i}"));
    }
}

/// Six random supports against random loads: the grasp that they make is in equilibrium.
#[test]
fn a_grasp_with_its_reactions_is_in_equilibrium() {
    let mut r = Random::new(7);
    let mut held = 0;
    for _ in 0..200 {
        let place = |r: &mut Random| support::<3>(r.array(1.0), r.array(1.0));
        let supports: Vec<_> = (0..6).map(|_| place(&mut r)).collect();
        let load = DeadLoad { point: r.array(1.0).into(), force: r.array(3.0).into() };
        let forces = reactions::<3, 3>(&supports, &[load]).unwrap();
        let contacts = supports.iter().zip(&forces).map(|(&place, force)| {
            // A finger that would pull is one that pushes from the other side.
            let inward_normal = place.inward_normal * force.signum();
            let place = Geometry { inward_normal, ..place };
            Contact::<3, 3>::new(place, Law::linear(1.0).unwrap(), force.abs()).unwrap()
        });
        let grasp = Grasp::new(contacts.collect()).unwrap().with_loads(vec![load]).unwrap();
        assert!(grasp.equilibrium().holds, "{:?}", grasp.equilibrium());
        held += 1;
    }
    assert_eq!(held, 200);
}

#[test]
fn supports_that_press_against_one_another_are_refused() {
    let weight = DeadLoad { point: Vector::ZERO, force: Vector::new([0.0, -1.0]) };
    let vice = [
        support([-1.0, 0.0], [1.0, 0.0]),
        support([1.0, 0.0], [-1.0, 0.0]),
        support([0.0, -1.0], [0.0, 1.0]),
    ];
    let undetermined = Err(GraspError::Undetermined { contacts: 3, rank: 2 });
    assert_eq!(reactions::<2, 1>(&vice, &[weight]), undetermined);
    // Four in the plane always can, wherever they are.
    let four = [vice[0], vice[1], vice[2], support([0.5, -1.0], [0.1, 1.0])];
    let undetermined = Err(GraspError::Undetermined { contacts: 4, rank: 3 });
    assert_eq!(reactions::<2, 1>(&four, &[weight]), undetermined);
}

#[test]
fn loads_that_the_supports_do_not_resist_are_refused() {
    let below = [support([-1.0, 0.0], [0.0, 1.0]), support([1.0, 0.0], [0.0, 1.0])];
    let push = DeadLoad { point: Vector::ZERO, force: Vector::new([2.0, 0.0]) };
    let found = reactions::<2, 1>(&below, &[push]);
    let Err(GraspError::Unresisted { force, torque }) = found else { panic!("{found:?}") };
    assert_close(force, 1.0, 1e-15, 1.0, "force");
    assert_close(torque, 0.0, 1e-15, 1.0, "torque");
    // No load needs no force, and no supports have none.
    assert_eq!(reactions::<2, 1>(&below, &[]), Ok(vec![0.0, 0.0]));
    assert_eq!(reactions::<2, 1>(&[], &[]), Ok(vec![]));
    let found = reactions::<2, 1>(&[], &[push]);
    assert!(matches!(found, Err(GraspError::Unresisted { .. })), "{found:?}");
}

#[test]
fn places_and_loads_that_are_not_finite_are_refused() {
    let below = [support([-1.0, 0.0], [0.0, 1.0]), support([1.0, 0.0], [0.0, 0.0])];
    assert_eq!(reactions::<2, 1>(&below, &[]), Err(GraspError::Support { support: 1 }));
    let far = [below[0], support([f64::INFINITY, 0.0], [0.0, 1.0])];
    assert!(matches!(reactions::<2, 1>(&far, &[]), Err(GraspError::Support { .. })));
    let load = DeadLoad { point: Vector::new([1e200, 0.0]), force: Vector::new([0.0, 1e200]) };
    assert_eq!(reactions::<2, 1>(&below[..1], &[load]), Err(GraspError::Load { load: 0 }));
}
