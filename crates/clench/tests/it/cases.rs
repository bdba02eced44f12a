//! Contacts, stiffness and stability of the reference cases, all values that need no friction.

use clench::contact::{Law, Order};
use clench::screw::{Frame, Stiffness, Vector, planar, spatial};
use clench::stiffness::Stability;
use clench_testkit::cases::{array, list, number, numbers};
use clench_testkit::{assert_all_close, assert_close};

use crate::case::{Case, planar_cases, spatial_cases};

/// Geometry, laws and K: sums of a few products of correctly rounded factors.
const DIGITS: f64 = 1e-12;

/// The linear programs of the cases were solved in doubles.
const SEARCH_DIGITS: f64 = 1e-8;

pub(crate) fn entries<const N: usize, const M: usize>(k: &Stiffness<N, M>) -> Vec<f64> {
    (0..N + M).flat_map(|i| (0..N + M).map(move |j| k.entry(i, j))).collect()
}

fn check_contacts<const N: usize, const M: usize>(case: &Case<N, M>) {
    let wanted = list(case.wanted(&["contacts"]));
    for (contact, wanted) in case.grasp.contacts().iter().zip(wanted) {
        let check = |found: &[f64], key: &str| {
            let what = format!("{} {key}", case.name);
            assert_all_close(found, &numbers(&wanted[key]), DIGITS, what);
        };
        let overlap = contact.overlap();
        let gradient = overlap.gradient(Vector::ZERO);
        check(&overlap.inward_normal().to_array(), "n");
        check(&overlap.point().to_array(), "b");
        check(&[overlap.depth()], "delta");
        check(&[contact.slope()], "fprime");
        let radius = overlap.geometry().finger.radius().unwrap();
        let center = overlap.point() - overlap.inward_normal() * (radius - overlap.depth());
        check(&(center + case.frame.origin()).to_array(), "finger_centre");
        let both = [gradient.force.to_array().as_slice(), &gradient.torque.to_array()].concat();
        check(&both, "grad");
        if case.order == Order::Second {
            check(&entries(&overlap.hessian(Vector::ZERO)), "hess");
        }
        if let (Law::Hertz(law), false) = (contact.law(), wanted["semi_axes"].is_null()) {
            check(&law.semi_axes(overlap.depth()), "semi_axes");
        }
    }
}

fn check_stiffness<const N: usize, const M: usize>(case: &Case<N, M>, world: &Frame<N, M>) {
    let first = case.grasp.stiffness(Vector::ZERO, Order::First);
    case.check(&entries(&first), &["K1"], DIGITS);
    if case.order == Order::Second {
        let second = case.grasp.preload_stiffness(Vector::ZERO);
        case.check(&entries(&second), &["K2"], DIGITS);
    }
    let stiffness = case.grasp.stiffness(Vector::ZERO, case.order);
    case.check(&entries(&stiffness), &["K"], DIGITS);
    case.check(&[case.grasp.total_preload()], &["f_total"], DIGITS);
    let net = case.grasp.net_wrench(Vector::ZERO);
    let net = [net.force.to_array().as_slice(), &net.torque.to_array()].concat();
    let scale = case.grasp.total_preload() * case.grasp.length().max(1.0);
    for (found, wanted) in net.iter().zip(numbers(case.wanted(&["net_wrench"]))) {
        assert_close(*found, wanted, DIGITS, scale, format!("{} net wrench", case.name));
    }
    let balanced = case.wanted(&["equilibrium"]).as_bool().unwrap();
    assert_eq!(case.grasp.equilibrium().holds, balanced, "{}", case.name);

    let change = &case.value["output"]["frame_change"];
    let body = Frame::at(array(&change["d_b"]).into());
    let moved = stiffness.in_frame(&Frame::of_change(&case.frame, world, &body));
    case.check(&entries(&moved), &["frame_change", "K_bar"], DIGITS);
}

#[test]
fn contacts_and_stiffness_are_those_of_the_cases() {
    for case in planar_cases() {
        check_contacts(&case);
        let angle = number(case.wanted(&["frame_change", "theta_w"]));
        check_stiffness(&case, &planar::Frame::new([0.0; 2], angle));
    }
    for case in spatial_cases() {
        check_contacts(&case);
        let theta = array(case.wanted(&["frame_change", "theta_w"]));
        check_stiffness(&case, &spatial::Frame::new([0.0; 3], theta));
    }
}

/// The major semi-axis of an area of contact lies along the smaller relative curvature.
#[test]
fn the_directions_of_contact_ellipses_are_those_of_the_cases() {
    let mut checked = 0;
    for case in spatial_cases() {
        let wanted = list(case.wanted(&["contacts"]));
        for (contact, wanted) in case.grasp.contacts().iter().zip(wanted) {
            if wanted["major_dir"].is_null() {
                continue;
            }
            let along = contact.overlap().geometry().relative_curvature().unwrap().along;
            let cosine = along.dot(array(&wanted["major_dir"]).into());
            assert_close(cosine.abs(), 1.0, DIGITS, 1.0, format!("{} direction", case.name));
            checked += 1;
        }
    }
    assert!(checked > 20, "{checked}");
}

fn check_holding<const N: usize, const M: usize>(case: &Case<N, M>) {
    let expected = match case.wanted(&["stability"]).as_str().unwrap() {
        "first_order" => Stability::FirstOrder,
        "second_order" => Stability::SecondOrder,
        "marginal" => Stability::Marginal,
        _ => Stability::Unstable,
    };
    assert_eq!(case.grasp.stability(), expected, "{}", case.name);

    let preloads = case.grasp.preloads().unwrap();
    let rank = case.wanted(&["preload", "rank"]).as_u64().unwrap();
    assert_eq!(preloads.rank as u64, rank, "{}", case.name);
    let count = case.grasp.contacts().len();
    let projector: Vec<f64> = (0..count)
        .flat_map(|i| (0..count).map(move |j| (i, j)))
        .map(|(i, j)| preloads.basis.iter().map(|b| b[i] * b[j]).sum())
        .collect();
    case.check(&projector, &["preload", "projector"], DIGITS);
    let margin = preloads.best.as_ref().expect("balanced preload").margin;
    let wanted = number(case.wanted(&["preload", "t_star"]));
    assert_close(margin, wanted, SEARCH_DIGITS, 1.0, format!("{} t*", case.name));
    let closure = case.wanted(&["force_closure_frictionless"]).as_bool().unwrap();
    assert_eq!(preloads.force_closure, closure, "{}", case.name);
}

#[test]
fn stability_and_preloads_are_those_of_the_cases() {
    for case in planar_cases() {
        check_holding(&case);
    }
    for case in spatial_cases() {
        check_holding(&case);
    }
}
