//! Every value of the planar grasp cases that needs no friction, from outline to quality.

use clench::contact::{Contact, Geometry, Law, Order};
use clench::metrics::{Principal, Quality, WorstPoint};
use clench::screw::planar::Frame;
use clench::screw::{Stiffness, Vector};
use clench::shape::Polygon;
use clench::stiffness::{Grasp, Stability};
use clench_testkit::cases::{Value, array, list, matching, number, numbers};
use clench_testkit::{assert_all_close, assert_close};

/// Geometry, laws and K: sums of at most five products of correctly rounded factors.
const DIGITS: f64 = 1e-12;

/// Quantities from the blocks of K, formed about the center of compliance.
const PRINCIPAL_DIGITS: f64 = 1e-11;

/// The linear programs of the cases were solved in doubles.
const SEARCH_DIGITS: f64 = 1e-8;

struct Case {
    name: String,
    value: Value,
    frame: Frame,
    outline: Polygon,
    grasp: Grasp<2, 1>,
    order: Order,
}

impl Case {
    /// Everything along the world's axes and about the body frame's origin, as in the files.
    fn new(name: String, value: Value) -> Self {
        let input = &value["input"];
        let frame = Frame::new(array(&input["frame"]["d"]), number(&input["frame"]["theta"]));
        let corners: Vec<[f64; 2]> = list(&input["object"]["vertices"])
            .iter()
            .map(|c| frame.direction_to_parent(array(c).into()).to_array())
            .collect();
        let outline = Polygon::new(&corners).unwrap();
        let contacts = list(&input["contacts"]).iter().map(|c| contact(&outline, c)).collect();
        let grasp = Grasp::new(contacts).unwrap();
        let first = input["second_order"].as_bool() == Some(false);
        let order = if first { Order::First } else { Order::Second };
        Self { name, value, frame, outline, grasp, order }
    }

    fn wanted(&self, path: &[&str]) -> &Value {
        path.iter().fold(&self.value["output"], |v, key| &v[key])
    }

    fn check(&self, found: &[f64], path: &[&str], digits: f64) {
        let what = format!("{} {}", self.name, path.join("."));
        assert_all_close(found, &numbers(self.wanted(path)), digits, what);
    }
}

fn contact(outline: &Polygon, given: &Value) -> Contact<2, 1> {
    let law = &given["law"];
    let law = match law["type"].as_str().unwrap() {
        "linear" => Law::linear(number(&law["k"])).unwrap(),
        "power" => Law::power(number(&law["c"]), number(&law["p"])).unwrap(),
        other => panic!("law {other}"),
    };
    let edge = &outline.edges()[usize::try_from(given["edge"].as_u64().unwrap()).unwrap()];
    let (point, normal) = (edge.point_at(number(&given["s"])), edge.inward_normal());
    Contact::new(
        Geometry::on_face(point, normal, number(&given["radius"])),
        law,
        number(&given["f"]),
    )
    .unwrap()
}

fn grasps() -> Vec<Case> {
    let planar = matching("planar_").into_iter().chain(matching("paper_"));
    planar.map(|(name, value)| Case::new(name, value)).collect()
}

fn entries(k: &Stiffness<2, 1>) -> Vec<f64> {
    (0..3).flat_map(|i| (0..3).map(move |j| k.entry(i, j))).collect()
}

#[test]
fn contacts_and_stiffness_are_those_of_the_cases() {
    for case in grasps() {
        let origin = Vector::ZERO;
        for (contact, wanted) in case.grasp.contacts().iter().zip(list(case.wanted(&["contacts"])))
        {
            let check = |found: &[f64], key: &str| {
                let what = format!("{} {key}", case.name);
                assert_all_close(found, &numbers(&wanted[key]), DIGITS, what);
            };
            let overlap = contact.overlap();
            let gradient = overlap.gradient(origin);
            check(&overlap.inward_normal().to_array(), "n");
            check(&overlap.point().to_array(), "b");
            check(&[overlap.depth()], "delta");
            check(&[contact.slope()], "fprime");
            let radius = overlap.geometry().finger.radius().unwrap();
            let center = overlap.point() - overlap.inward_normal() * (radius - overlap.depth())
                + case.frame.origin();
            check(&center.to_array(), "finger_centre");
            let [x, y] = gradient.force.to_array();
            check(&[x, y, gradient.torque[0]], "grad");
            if case.order == Order::Second {
                check(&entries(&overlap.hessian(origin)), "hess");
            }
        }
        let first = case.grasp.stiffness(origin, Order::First);
        case.check(&entries(&first), &["K1"], DIGITS);
        let stiffness = case.grasp.stiffness(origin, case.order);
        case.check(&entries(&stiffness), &["K"], DIGITS);
        case.check(&[case.grasp.total_preload()], &["f_total"], DIGITS);
        let balanced = case.wanted(&["equilibrium"]).as_bool().unwrap();
        assert_eq!(case.grasp.equilibrium().holds, balanced, "{}", case.name);

        let change = &case.value["output"]["frame_change"];
        let world = Frame::new([0.0, 0.0], number(&change["theta_w"]));
        let body = Frame::new(array(&change["d_b"]), 0.0);
        let moved = stiffness.in_frame(&Frame::of_change(&case.frame, &world, &body));
        case.check(&entries(&moved), &["frame_change", "K_bar"], DIGITS);
    }
}

#[test]
fn stability_and_preloads_are_those_of_the_cases() {
    for case in grasps() {
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
}

#[test]
fn principal_parameters_and_quality_are_those_of_the_cases() {
    for case in grasps() {
        let about = |origin| case.grasp.stiffness(origin, case.order);
        let principal = Principal::near(case.grasp.centroid(), about).unwrap();
        let digits = PRINCIPAL_DIGITS;
        let check = |found: &[f64], key| case.check(found, &["principal", key], digits);
        check(&principal.translational().values, "sigma");
        check(&principal.rotational().values, "mu");
        check(principal.restricted_stiffness().rows().as_flattened(), "K_V");
        check(principal.translational_compliance().rows().as_flattened(), "C_W");
        check(&principal.center().to_array(), "centre");
        let in_body = case.frame.direction_in_frame(principal.center());
        check(&in_body.to_array(), "d_b");
        let twist = principal.forceless_twist(Vector::new([1.0]));
        check(&twist.linear.to_array(), "P1");
        let directions = principal.translational().vectors.map(Vector::to_array);
        check(directions.as_flattened(), "sigma_dirs");

        let quality = Quality::of(&principal, &case.outline);
        let check = |found: f64, key| case.check(&[found], &["quality", key], digits);
        check(quality.value, "Q");
        check(quality.translational, "sigma_min");
        check(quality.equivalent, "mu_eq");
        check(quality.equivalent, "Q_V");
        check(quality.reach.distance, "rho_max");
        check(WorstPoint::of(&principal, &case.outline).unwrap().stiffness, "Q_pt");
    }
}
