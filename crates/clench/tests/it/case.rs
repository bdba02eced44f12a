//! The grasps of the reference cases, from the part to its contacts.

use clench::contact::{Contact, Curvature, Elastic, Geometry, Hertz, Law, LineContact, Order};
use clench::screw::{Frame, planar, spatial};
use clench::shape::{Ellipsoid, Extent, ExtremePoints, Polygon, Polyhedron};
use clench::stiffness::Grasp;
use clench_testkit::assert_all_close;
use clench_testkit::cases::{Value, array, list, matching, number, numbers};

/// A grasp of the reference cases: everything along the world's axes and about the body frame's
/// origin, as in the files.
pub(crate) struct Case<const N: usize, const M: usize> {
    pub(crate) name: String,
    pub(crate) value: Value,
    pub(crate) frame: Frame<N, M>,
    pub(crate) grasp: Grasp<N, M>,
    pub(crate) order: Order,
    body: Body<N>,
}

/// What a part is made of, as far as its reach goes.
enum Body<const N: usize> {
    Corners(ExtremePoints<N>),
    Smooth(Ellipsoid<N>),
}

impl<const N: usize, const M: usize> Case<N, M> {
    /// `place` says where a contact touches the part.
    fn new(
        (name, value): (String, Value),
        frame: Frame<N, M>,
        body: Body<N>,
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
        Self { name, value, frame, grasp, order, body }
    }

    /// The part, about the body frame's origin.
    pub(crate) fn body(&self) -> Extent<'_, N> {
        match &self.body {
            Body::Corners(extremes) => extremes.into(),
            Body::Smooth(ellipsoid) => ellipsoid.into(),
        }
    }

    pub(crate) fn wanted(&self, path: &[&str]) -> &Value {
        path.iter().fold(&self.value["output"], |v, key| &v[key])
    }

    pub(crate) fn check(&self, found: &[f64], path: &[&str], digits: f64) {
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
) -> (Body<N>, impl Fn(&Value) -> Geometry<N> + use<N, M>) {
    let object = &input["object"];
    let body = Ellipsoid::new(array(&object["centre"]).into(), array(&object["axes"])).unwrap();
    let body = body.placed(&turn);
    let place = move |given: &Value| {
        let outward = turn.direction_to_parent(array(&given["m_body"]).into());
        let touched = body.at_normal(outward).unwrap();
        Geometry {
            point: touched.point,
            inward_normal: touched.inward_normal,
            finger: Curvature::round(number(&given["radius"])),
            part: Curvature::of_shape_operator(touched.shape_operator),
        }
    };
    (Body::Smooth(body), place)
}

fn planar_case(name: String, value: Value) -> Case<2, 1> {
    let input = &value["input"];
    let angle = number(&input["frame"]["theta"]);
    let frame = planar::Frame::new(array(&input["frame"]["d"]), angle);
    let turn = planar::Frame::new([0.0; 2], angle);
    let in_plane = |_: f64, _: &Geometry<2>| panic!("a disc touches along a line");
    if input["object"]["type"].as_str() == Some("ellipse") {
        let (body, place) = on_smooth(input, turn);
        return Case::new((name, value), frame, body, place, in_plane);
    }
    let outline = Polygon::new(&vertices(input, &turn)).unwrap();
    let place = |given: &Value| {
        let edge = &outline.edges()[whole(&given["edge"])];
        let (point, normal) = (edge.point_at(number(&given["s"])), edge.inward_normal());
        Geometry::on_face(point, normal, number(&given["radius"]))
    };
    let body = Body::Corners(outline.extreme_points().clone());
    Case::new((name, value), frame, body, place, in_plane)
}

fn spatial_case(name: String, value: Value) -> Case<3, 3> {
    let input = &value["input"];
    let theta = array(&input["frame"]["theta"]);
    let frame = spatial::Frame::new(array(&input["frame"]["d"]), theta);
    let turn = spatial::Frame::new([0.0; 3], theta);
    let hertz = |modulus: f64, place: &Geometry<3>| Law::hertz(modulus, place).unwrap();
    if input["object"]["type"].as_str() == Some("ellipsoid") {
        let (body, place) = on_smooth(input, turn);
        return Case::new((name, value), frame, body, place, hertz);
    }
    let faces = list(&input["object"]["faces"]).iter();
    let faces: Vec<Vec<usize>> = faces.map(|f| list(f).iter().map(whole).collect()).collect();
    let solid = Polyhedron::new(&vertices(input, &turn), &faces).unwrap();
    let place = |given: &Value| {
        let normal = solid.faces()[whole(&given["face"])].inward_normal();
        let point = turn.direction_to_parent(array(&given["b_body"]).into());
        Geometry::on_face(point, normal, number(&given["radius"]))
    };
    let body = Body::Corners(solid.extreme_points().clone());
    Case::new((name, value), frame, body, place, hertz)
}

pub(crate) fn planar_cases() -> Vec<Case<2, 1>> {
    let prefixes = ["planar_", "paper_", "ellipse_", "offeq_"];
    let found = prefixes.into_iter().flat_map(matching);
    found.map(|(name, value)| planar_case(name, value)).collect()
}

pub(crate) fn spatial_cases() -> Vec<Case<3, 3>> {
    let found = ["spatial_", "ellipsoid_", "degenerate_"].into_iter().flat_map(matching);
    found.map(|(name, value)| spatial_case(name, value)).collect()
}
