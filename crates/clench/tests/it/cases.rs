//! Every value of the grasp cases that needs no friction, from the part to its quality.

use clench::contact::{Contact, Curvature, Elastic, Geometry, Hertz, Law, LineContact, Order};
use clench::metrics::{Principal, Quality, WorstPoint};
use clench::screw::{Frame, Stiffness, Vector, planar, spatial};
use clench::shape::{Ellipsoid, Polygon, Polyhedron};
use clench::stiffness::{Grasp, Stability};
use clench_testkit::cases::{Value, array, list, matching, number, numbers};
use clench_testkit::{assert_all_close, assert_close};

/// Geometry, laws and K: sums of a few products of correctly rounded factors.
const DIGITS: f64 = 1e-12;

/// Quantities from the blocks of K, formed about the center of compliance.
const PRINCIPAL_DIGITS: f64 = 1e-11;

/// The linear programs of the cases were solved in doubles.
const SEARCH_DIGITS: f64 = 1e-8;

struct Case<const N: usize, const M: usize> {
    name: String,
    value: Value,
    frame: Frame<N, M>,
    grasp: Grasp<N, M>,
    order: Order,
}

impl<const N: usize, const M: usize> Case<N, M> {
    /// Everything along the world's axes and about the body frame's origin, as in the files;
    /// `place` says where a contact touches the part.
    fn new(
        name: String,
        value: Value,
        frame: Frame<N, M>,
        place: impl Fn(&Value) -> Geometry<N>,
        hertz: impl Fn(f64, &Geometry<N>) -> Law,
    ) -> Self {
        let input = &value["input"];
        let contacts = list(&input["contacts"]).iter().map(|given| {
            let place = place(given);
            let law = match given["law"]["type"].as_str().unwrap() {
                "hertz" => hertz(number(&given["law"]["E_star"]), &place),
                kind => law(kind, &given["law"]),
            };
            Contact::new(place, law, number(&given["f"])).unwrap()
        });
        let grasp = Grasp::new(contacts.collect()).unwrap();
        let first = input["second_order"].as_bool() == Some(false);
        let order = if first { Order::First } else { Order::Second };
        Self { name, value, frame, grasp, order }
    }

    fn wanted(&self, path: &[&str]) -> &Value {
        path.iter().fold(&self.value["output"], |v, key| &v[key])
    }

    fn check(&self, found: &[f64], path: &[&str], digits: f64) {
        let what = format!("{} {}", self.name, path.join("."));
        assert_all_close(found, &numbers(self.wanted(path)), digits, what);
    }
}

fn law(kind: &str, given: &Value) -> Law {
    let elastic = |body: &str| {
        let young = number(&given[format!("E_{body}")]);
        Elastic::new(young, number(&given[format!("nu_{body}")])).unwrap()
    };
    match kind {
        "linear" => Law::linear(number(&given["k"])).unwrap(),
        "power" => Law::power(number(&given["c"]), number(&given["p"])).unwrap(),
        "hertz_circular" => {
            let (modulus, radius) = (number(&given["E_star"]), number(&given["R"]));
            Law::Hertz(Hertz::circular(modulus, radius).unwrap())
        }
        "line_hertz" => Law::line(&LineContact {
            radius: number(&given["R"]),
            thickness: number(&given["ell"]),
            reference_depth: number(&given["d_B"]),
            finger: elastic("A"),
            part: elastic("B"),
        })
        .unwrap(),
        other => panic!("law {other}"),
    }
}

fn whole(value: &Value) -> usize {
    usize::try_from(value.as_u64().unwrap()).unwrap()
}

/// The part's vertices, turned by `turn`.
fn vertices<const N: usize, const M: usize>(input: &Value, turn: &Frame<N, M>) -> Vec<[f64; N]> {
    let given = list(&input["object"]["vertices"]).iter();
    given.map(|c| turn.direction_to_parent(array(c).into()).to_array()).collect()
}

/// A disc or ball on an ellipse or ellipsoid, turned by `turn`.
fn on_smooth<const N: usize, const M: usize>(
    input: &Value,
    turn: Frame<N, M>,
) -> impl Fn(&Value) -> Geometry<N> + use<N, M> {
    let object = &input["object"];
    let body = Ellipsoid::new(array(&object["centre"]).into(), array(&object["axes"])).unwrap();
    let body = body.placed(&turn);
    move |given| {
        let outward = turn.direction_to_parent(array(&given["m_body"]).into());
        let touched = body.at_normal(outward).unwrap();
        Geometry {
            point: touched.point,
            inward_normal: touched.inward_normal,
            finger: Curvature::round(number(&given["radius"])),
            part: Curvature::of_shape_operator(touched.shape_operator),
        }
    }
}

/// A planar case, and its outline if it has corners.
fn planar_case(name: String, value: Value) -> (Case<2, 1>, Option<Polygon>) {
    let input = &value["input"];
    let angle = number(&input["frame"]["theta"]);
    let frame = planar::Frame::new(array(&input["frame"]["d"]), angle);
    let turn = planar::Frame::new([0.0; 2], angle);
    let in_plane = |_: f64, _: &Geometry<2>| panic!("a disc touches along a line");
    if input["object"]["type"].as_str() == Some("ellipse") {
        let place = on_smooth(input, turn);
        return (Case::new(name, value, frame, place, in_plane), None);
    }
    let outline = Polygon::new(&vertices(input, &turn)).unwrap();
    let place = |given: &Value| {
        let edge = &outline.edges()[whole(&given["edge"])];
        let (point, normal) = (edge.point_at(number(&given["s"])), edge.inward_normal());
        Geometry::on_face(point, normal, number(&given["radius"]))
    };
    (Case::new(name, value, frame, place, in_plane), Some(outline.clone()))
}

fn spatial_case(name: String, value: Value) -> Case<3, 3> {
    let input = &value["input"];
    let theta = array(&input["frame"]["theta"]);
    let frame = spatial::Frame::new(array(&input["frame"]["d"]), theta);
    let turn = spatial::Frame::new([0.0; 3], theta);
    let hertz = |modulus: f64, place: &Geometry<3>| Law::hertz(modulus, place).unwrap();
    if input["object"]["type"].as_str() == Some("ellipsoid") {
        let place = on_smooth(input, turn);
        return Case::new(name, value, frame, place, hertz);
    }
    let faces = list(&input["object"]["faces"]).iter();
    let faces: Vec<Vec<usize>> = faces.map(|f| list(f).iter().map(whole).collect()).collect();
    let solid = Polyhedron::new(&vertices(input, &turn), &faces).unwrap();
    let place = |given: &Value| {
        let normal = solid.faces()[whole(&given["face"])].inward_normal();
        let point = turn.direction_to_parent(array(&given["b_body"]).into());
        Geometry::on_face(point, normal, number(&given["radius"]))
    };
    Case::new(name, value, frame, place, hertz)
}

fn planar_cases() -> Vec<(Case<2, 1>, Option<Polygon>)> {
    let prefixes = ["planar_", "paper_", "ellipse_", "offeq_"];
    let found = prefixes.into_iter().flat_map(matching);
    found.map(|(name, value)| planar_case(name, value)).collect()
}

fn spatial_cases() -> Vec<Case<3, 3>> {
    let found = ["spatial_", "ellipsoid_", "degenerate_"].into_iter().flat_map(matching);
    found.map(|(name, value)| spatial_case(name, value)).collect()
}

fn entries<const N: usize, const M: usize>(k: &Stiffness<N, M>) -> Vec<f64> {
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
    for (case, _) in planar_cases() {
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
    for (case, _) in planar_cases() {
        check_holding(&case);
    }
    for case in spatial_cases() {
        check_holding(&case);
    }
}

#[test]
fn principal_parameters_and_quality_are_those_of_the_cases() {
    for (case, outline) in planar_cases() {
        // A smooth part has no reach yet, and a stiffness out of balance depends on the origin.
        let Some(outline) = outline.filter(|_| case.grasp.equilibrium().holds) else { continue };
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

        let quality = Quality::of(&principal, &outline);
        let check = |found: f64, key| case.check(&[found], &["quality", key], digits);
        check(quality.value, "Q");
        check(quality.translational, "sigma_min");
        check(quality.equivalent, "mu_eq");
        check(quality.equivalent, "Q_V");
        check(quality.reach.distance, "rho_max");
        check(WorstPoint::of(&principal, &outline).unwrap().stiffness, "Q_pt");
    }
}
