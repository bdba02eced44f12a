//! What a contact refuses, each with its exact error.

use clench_contact::{
    Contact, ContactError, Curvature, Elastic, ForceLaw, Geometry, Hertz, Law, Line, LineContact,
    Material, Order, Units, effective_modulus,
};
use clench_screw::{Mat, Vector, spatial};
use clench_testkit::{Random, assert_close};

fn contact(
    point: [f64; 2],
    normal: [f64; 2],
    radius: f64,
    law: &Law,
    preload: f64,
) -> Result<Contact<2, 1>, ContactError> {
    Contact::new(Geometry::on_face(point.into(), normal.into(), radius), law.clone(), preload)
}

#[test]
fn laws_need_positive_finite_parameters() {
    for value in [0.0, -1.0, f64::INFINITY] {
        let parameter = "stiffness";
        assert_eq!(Law::linear(value), Err(ContactError::NotPositive { parameter, value }));
        let parameter = "coefficient";
        assert_eq!(Law::power(value, 1.5), Err(ContactError::NotPositive { parameter, value }));
        let parameter = "exponent";
        assert_eq!(Law::power(1.0, value), Err(ContactError::NotPositive { parameter, value }));
    }
    let nan = Law::linear(f64::NAN);
    assert!(matches!(nan, Err(ContactError::NotPositive { value, .. }) if value.is_nan()));
}

#[test]
fn a_contact_names_what_is_wrong_with_it() {
    let law = Law::linear(1.0).unwrap();
    let (p, n) = ([0.0, 0.0], [0.0, 1.0]);
    assert_eq!(contact(p, [0.0, 0.0], 0.0, &law, 0.0), Err(ContactError::NoNormal));
    assert_eq!(
        contact([0.0, f64::INFINITY], n, 0.0, &law, 0.0),
        Err(ContactError::NotFinite { parameter: "contact point", axis: 1, value: f64::INFINITY })
    );
    assert!(matches!(
        contact(p, [f64::NAN, 1.0], 0.0, &law, 0.0),
        Err(ContactError::NotFinite { parameter: "inward normal", axis: 0, .. })
    ));
    assert_eq!(
        contact(p, n, -0.5, &law, 0.0),
        Err(ContactError::NoGap { relative_curvature: -2.0 })
    );
    assert_eq!(
        contact(p, n, 0.0, &law, -2.0),
        Err(ContactError::Negative { parameter: "preload", value: -2.0 })
    );
}

#[test]
fn a_nonlinear_law_without_preload_has_no_stiffness() {
    let law = Law::power(1.0, 1.5).unwrap();
    let found = contact([0.0, 0.0], [0.0, 1.0], 0.0, &law, 0.0);
    assert_eq!(found, Err(ContactError::NoStiffness { preload: 0.0, slope: 0.0 }));
    assert!(found.unwrap_err().to_string().contains("needs a positive preload"));
    let law = Law::power(1.0, 0.5).unwrap();
    let found = contact([0.0, 0.0], [0.0, 1.0], 0.0, &law, 0.0);
    assert_eq!(found, Err(ContactError::NoStiffness { preload: 0.0, slope: f64::INFINITY }));
}

#[test]
fn the_length_of_the_given_normal_does_not_matter() {
    let law = Law::linear(1.0).unwrap();
    for length in [1e-200, 1.0, 1e200] {
        let found = contact([1.0, 2.0], [3.0 * length, 4.0 * length], 0.0, &law, 0.1).unwrap();
        assert_eq!(found.overlap().inward_normal(), Vector::new([0.600_000_000_000_000_1, 0.8]));
    }
}

#[test]
fn without_preload_both_orders_agree() {
    let law = Law::linear(2.0).unwrap();
    let free = contact([1.0, 2.0], [3.0, 4.0], 0.5, &law, 0.0).unwrap();
    let origin = Vector::ZERO;
    assert_eq!(free.stiffness(origin, Order::First), free.stiffness(origin, Order::Second));
}

fn solid(finger: Curvature<3>, part: Curvature<3>, overlap: f64) -> Result<(), ContactError> {
    along(Vector::new([0.0, 0.0, 1.0]), finger, part, overlap)
}

fn along(
    inward_normal: Vector<3>,
    finger: Curvature<3>,
    part: Curvature<3>,
    overlap: f64,
) -> Result<(), ContactError> {
    let point = Vector::ZERO;
    let place = Geometry { point, inward_normal, finger, part };
    Contact::<3, 3>::overlapping(place, Law::linear(1.0).unwrap(), overlap).map(|_| ())
}

#[test]
fn boundaries_that_do_not_open_a_gap_are_refused() {
    let x = Vector::new([1.0, 0.0, 0.0]);
    let cylinder = |along| Curvature::principal_radii([1.0, f64::INFINITY], along);
    let round = Curvature::round;
    let no_gap = |relative_curvature| Err(ContactError::NoGap { relative_curvature });
    assert_eq!(solid(Curvature::FLAT, Curvature::FLAT, 0.0), no_gap(0.0));
    // A needle on a corner has no normal of its own.
    assert_eq!(solid(Curvature::POINTED, Curvature::POINTED, 0.0), no_gap(0.0));
    // A ball in a socket of its own size, or a smaller one; in a larger one it is held.
    assert_eq!(solid(round(2.0), round(-2.0), 0.0), no_gap(0.0));
    assert_eq!(solid(round(4.0), round(-2.0), 0.0), no_gap(-0.25));
    assert_eq!(solid(round(1.0), round(-2.0), 0.1), Ok(()));
    // Cylinders touch in a point when they cross, along a line when they are parallel.
    assert_eq!(solid(cylinder(x), cylinder(x), 0.1), no_gap(0.0));
    assert_eq!(solid(cylinder(x), cylinder(Vector::new([0.6, 0.8, 0.0])), 0.1), Ok(()));
    // A needle reaches into any hollow, and a hollow finger holds a smaller ball.
    assert_eq!(solid(Curvature::POINTED, round(-0.1), 0.0), Ok(()));
    assert_eq!(solid(round(-3.0), round(2.0), 0.1), Ok(()));
    let saddle = Curvature::principal_radii([1.0, -0.5], x);
    assert_eq!(solid(round(1.0), saddle, 0.0), no_gap(-1.0));
}

/// Two convex bodies may overlap up to the sum of their least radii, in the same direction; a
/// finger in a hollow as deep as its own radius, where its center would reach the boundary, and
/// on, as long as the finger's center is not at the hollow's.
#[test]
fn overlaps_are_less_than_the_radii_allow() {
    let x = Vector::new([1.0, 0.0, 0.0]);
    let too_deep = |depth, limit| Err(ContactError::TooDeep { depth, limit });
    let round = Curvature::round;
    assert_eq!(solid(round(1.0), round(2.0), 2.9), Ok(()));
    assert_eq!(solid(round(1.0), round(2.0), 3.0), too_deep(3.0, 3.0));
    assert_eq!(solid(Curvature::POINTED, round(2.0), 1.9), Ok(()));
    assert_eq!(solid(Curvature::POINTED, round(2.0), 2.5), too_deep(2.5, 2.0));
    assert_eq!(solid(round(1.0), Curvature::FLAT, 1e9), Ok(()));
    // The least sum of radii in one direction counts: 1 + 2.
    let [finger, part] = [[1.0, 4.0], [2.0, 3.0]].map(|radii| Curvature::principal_radii(radii, x));
    assert_eq!(solid(finger, part, 2.9), Ok(()));
    let found = solid(finger, part, 3.5);
    assert!(matches!(
        found,
        Err(ContactError::TooDeep { depth: 3.5, limit }) if (limit - 3.0).abs() < 1e-14
    ));
}

#[test]
fn a_boundary_names_what_is_wrong_with_it() {
    let (x, z) = (Vector::new([1.0, 0.0, 0.0]), Vector::new([0.0, 0.0, 2.0]));
    let bad = |curvature| solid(curvature, Curvature::FLAT, 0.0);
    let nan = bad(Curvature::round(f64::NAN));
    let Err(ContactError::RadiusNotANumber { body: "finger", value }) = nan else {
        panic!("{nan:?}")
    };
    assert!(value.is_nan());
    let value = f64::NEG_INFINITY;
    let found = bad(Curvature::round(value));
    assert_eq!(found, Err(ContactError::RadiusNotANumber { body: "finger", value }));
    let found = solid(Curvature::round(1.0), Curvature::principal_radii([0.0, 1.0], x), 0.0);
    let value = f64::INFINITY;
    assert_eq!(found, Err(ContactError::PrincipalCurvature { body: "part", value }));
    for along in [z, Vector::ZERO, Vector::new([f64::NAN, 0.0, 0.0])] {
        let found = bad(Curvature::principal_radii([1.0, 2.0], along));
        assert_eq!(found, Err(ContactError::NoPrincipalDirection { body: "finger" }));
    }
    let found = bad(Curvature::of_shape_operator(Mat::IDENTITY * f64::INFINITY));
    assert_eq!(found, Err(ContactError::ShapeOperator { body: "finger" }));
    let found = solid(Curvature::round(1.0), Curvature::FLAT, -0.1);
    assert_eq!(found, Err(ContactError::Negative { parameter: "overlap", value: -0.1 }));
}

#[test]
fn hertz_needs_smooth_bodies_and_a_preload() {
    let (point, inward_normal) = (Vector::ZERO, Vector::new([0.0, 0.0, 1.0]));
    let place = |finger, part| Geometry { point, inward_normal, finger, part };
    let ball = place(Curvature::round(2.0), Curvature::FLAT);
    let law = Law::hertz(100.0, &ball).unwrap();
    let found = Contact::<3, 3>::new(ball, law, 0.0);
    assert_eq!(found, Err(ContactError::NoStiffness { preload: 0.0, slope: 0.0 }));
    let found = Law::hertz(100.0, &place(Curvature::POINTED, Curvature::FLAT));
    assert_eq!(found, Err(ContactError::Pointed { body: "finger" }));
    // A cylinder on a face touches along a line.
    let along = Vector::new([1.0, 0.0, 0.0]);
    let cylinder = Curvature::principal_radii([1.0, f64::INFINITY], along);
    let found = Law::hertz(100.0, &place(cylinder, Curvature::FLAT));
    assert_eq!(found, Err(ContactError::LineOfContact { larger: 1.0 }));
    let socket = place(Curvature::round(4.0), Curvature::round(-2.0));
    let found = Law::hertz(100.0, &socket);
    assert_eq!(found, Err(ContactError::NoGap { relative_curvature: -0.25 }));
    let found = Hertz::elliptic(1.0, [2.0, 1.0]);
    assert_eq!(found, Err(ContactError::NoEllipse { a: 2.0, b: 1.0 }));
    let parameter = "A of the gap";
    let found = Hertz::elliptic(1.0, [0.0, 1.0]);
    assert_eq!(found, Err(ContactError::NotPositive { parameter, value: 0.0 }));
    let found = Hertz::elliptic(1.0, [1e-300, 1e300]);
    assert!(matches!(found, Err(ContactError::NoEllipse { .. })), "{found:?}");
    let found = Hertz::circular(0.0, 1.0);
    let parameter = "effective modulus";
    assert_eq!(found, Err(ContactError::NotPositive { parameter, value: 0.0 }));
    let huge = Curvature::of_shape_operator(Mat::IDENTITY * f64::MAX);
    let found = place(huge, huge).relative_curvature();
    assert!(matches!(found, Err(ContactError::Screw(_))), "{found:?}");
}

#[test]
fn elastic_constants_are_those_of_a_material() {
    let parameter = "Young's modulus";
    let found = Elastic::new(0.0, 0.3);
    assert_eq!(found, Err(ContactError::NotPositive { parameter, value: 0.0 }));
    for value in [-1.0, 0.6] {
        assert_eq!(Elastic::new(1.0, value), Err(ContactError::PoissonRatio { value }));
    }
    assert!(matches!(
        Elastic::new(1.0, f64::NAN),
        Err(ContactError::PoissonRatio { value }) if value.is_nan()
    ));
    // Incompressible, against itself.
    let rubber = Elastic::new(3.0, 0.5).unwrap();
    assert_eq!(effective_modulus(rubber, rubber), 2.0);
    let units = Units::MILLIMETER_NEWTON;
    for material in Material::ALL {
        let found = Material::named(material.name).unwrap().elastic(units).unwrap();
        assert!(found.young_modulus() > 1.0 && found.young_modulus() < 1e6, "{material:?}");
    }
    let found = Material::named("wood");
    assert_eq!(found, None);
    let nowhere = Units { length_m: 0.0, force_n: 1.0 };
    let parameter = "Young's modulus";
    let found = Material::ALL[0].elastic(nowhere);
    assert_eq!(found, Err(ContactError::NotPositive { parameter, value: 0.0 }));
}

#[test]
fn the_line_law_ends_at_its_largest_force() {
    let body = Elastic::new(100.0, 0.5).unwrap();
    let disc =
        LineContact { radius: 3.0, thickness: 2.0, reference_depth: 5.0, finger: body, part: body };
    let law = Line::new(&disc).unwrap();
    let (end, largest) = (law.largest_overlap(), law.largest_force());
    assert!((law.force(end) - largest).abs() <= 1e-14 * largest);
    assert_eq!(law.force(2.0 * end), law.force(end));
    let place = || Geometry::on_face(Vector::ZERO, Vector::new([0.0, 1.0]), 3.0);
    for beyond in [largest, 2.0 * largest] {
        let found = Contact::<2, 1>::new(place(), Law::Line(law), beyond);
        assert_eq!(found, Err(ContactError::BeyondLaw { force: beyond, largest }));
    }
    let found = Contact::<2, 1>::overlapping(place(), Law::Line(law), 2.0 * end);
    let Err(ContactError::OverlapBeyondLaw { overlap, largest }) = found else {
        panic!("{found:?}")
    };
    assert_eq!(overlap, 2.0 * end);
    assert!((largest - end).abs() <= 1e-14 * end);
    let found = Contact::<2, 1>::new(place(), Law::Line(law), 0.0);
    assert_eq!(found, Err(ContactError::NoStiffness { preload: 0.0, slope: 0.0 }));
    for (wrong, parameter) in [
        (LineContact { radius: 0.0, ..disc }, "disc radius"),
        (LineContact { thickness: 0.0, ..disc }, "thickness"),
        (LineContact { reference_depth: 0.0, ..disc }, "reference depth"),
    ] {
        let found = Line::new(&wrong);
        assert_eq!(found, Err(ContactError::NotPositive { parameter, value: 0.0 }));
    }
    let tiny = LineContact { radius: 1e-300, reference_depth: 1e-300, ..disc };
    let found = Line::new(&LineContact { thickness: 1e-300, ..tiny });
    assert!(matches!(
        found,
        Err(ContactError::NotPositive { parameter: "largest force", value: 0.0 })
    ));
}

/// A direction that no coordinate axis is special for, a unit vector across it, and one across
/// both.
fn oblique(r: &mut Random) -> [Vector<3>; 3] {
    let normal: Vector<3> = r.array(1.0).into();
    let normal = normal * normal.norm().recip();
    let first = spatial::cross(normal, r.array(1.0).into());
    let first = first * first.norm().recip();
    [normal, first, spatial::cross(normal, first)]
}

/// Where limits meet, roots are double and differences nothing but rounding: no direction of the
/// normal may decide otherwise than another.
#[test]
fn limits_are_the_same_for_all_normals() {
    let r = &mut Random::new(61);
    let round = Curvature::round;
    for _ in 0..2000 {
        let [normal, first, second] = oblique(r);
        let (at, beyond) = (r.between(0.99, 1.0) - 1e-6, r.between(1.0, 2.0) + 1e-6);
        let limits = [
            (round(1.0), round(2.0), 3.0),
            (Curvature::POINTED, round(2.0), 2.0),
            (round(2.0), Curvature::POINTED, 2.0),
            (
                Curvature::principal_radii([1.0, 2.0], first),
                Curvature::principal_radii([2.0, 1.0], first),
                3.0,
            ),
            (
                Curvature::principal_radii([1.0, 2.0], first),
                Curvature::principal_radii([1.0, 2.0], second),
                3.0,
            ),
        ];
        for (finger, part, limit) in limits {
            assert_eq!(along(normal, finger, part, at * limit), Ok(()));
            let found = along(normal, finger, part, beyond * limit);
            let Err(ContactError::TooDeep { limit: found, .. }) = found else {
                panic!("{found:?} at {beyond} of {limit}")
            };
            assert_close(found, limit, 1e-7, limit, "limit");
        }

        // A cylinder on a face, and two parallel ones, touch along a line.
        let cylinder = Curvature::principal_radii([1.0, f64::INFINITY], first);
        for part in [Curvature::FLAT, cylinder] {
            let found = along(normal, cylinder, part, 0.0);
            assert!(matches!(found, Err(ContactError::NoGap { .. })), "{found:?}");
            let place = Geometry { point: first, inward_normal: normal, finger: cylinder, part };
            assert_eq!(place.relative_curvature().unwrap().smaller, 0.0);
            let found = Law::hertz(1.0, &place);
            assert!(matches!(found, Err(ContactError::LineOfContact { .. })), "{found:?}");
        }

        // A direction along the normal is none in the tangent plane.
        let none = Curvature::principal_radii([1.0, 2.0], normal * r.between(0.1, 10.0));
        let found = along(normal, none, Curvature::FLAT, 0.0);
        assert_eq!(found, Err(ContactError::NoPrincipalDirection { body: "finger" }));

        // A ball in a socket of nearly its own size, as close as the plane allows too.
        assert_eq!(along(normal, round(10.0), round(-10.0 * (1.0 + 1e-12)), 0.0), Ok(()));
        let found = along(normal, round(10.0), round(-10.0), 0.0);
        assert!(matches!(found, Err(ContactError::NoGap { .. })), "{found:?}");
    }
}

#[test]
fn nearly_straight_boundaries_keep_their_digits() {
    let [x, z] = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(Vector::new);
    for exponent in 0..=12 {
        let radius = 10.0_f64.powi(exponent);
        let finger = Curvature::principal_radii([1.0, radius], x);
        let place = Geometry { point: z, inward_normal: z, finger, part: Curvature::FLAT };
        let law = Law::linear(1.0).unwrap();
        let contact = Contact::<3, 3>::overlapping(place, law, 0.25).unwrap();
        // Turning about y tilts along x, turning about x along y.
        let hessian = contact.overlap().hessian(z);
        assert_close(hessian.rotational[1][1], 0.75, 1e-15, 1.0, "the short way");
        assert_close(hessian.rotational[0][0], radius - 0.25, 1e-15, radius, "the long way");
    }
}

/// A law that breaks its promises is found out where it matters.
#[derive(Debug)]
struct Liar {
    force: f64,
    overlap: f64,
    largest: f64,
}

impl ForceLaw for Liar {
    fn force(&self, _: f64) -> f64 {
        self.force
    }
    fn slope(&self, _: f64) -> f64 {
        1.0
    }
    fn energy(&self, _: f64) -> f64 {
        0.0
    }
    fn overlap(&self, _: f64) -> f64 {
        self.overlap
    }
    fn largest_force(&self) -> f64 {
        self.largest
    }
}

#[test]
fn a_custom_law_that_lies_is_refused() {
    let place = Geometry::on_face(Vector::ZERO, Vector::new([0.0, 1.0]), 1.0);
    let good = || Liar { force: 1.0, overlap: 1.0, largest: f64::INFINITY };
    let new = |liar| Contact::<2, 1>::new(place, Law::custom(liar), 1.0).map(|_| ());
    let overlapping =
        |liar| Contact::<2, 1>::overlapping(place, Law::custom(liar), 1.0).map(|_| ());
    assert_eq!((new(good()), overlapping(good())), (Ok(()), Ok(())));
    let parameter = "overlap at the preload";
    let found = new(Liar { overlap: -5.0, ..good() });
    assert_eq!(found, Err(ContactError::Negative { parameter, value: -5.0 }));
    let parameter = "force at the overlap";
    let found = overlapping(Liar { force: -1.0, ..good() });
    assert_eq!(found, Err(ContactError::Negative { parameter, value: -1.0 }));
    assert!(overlapping(Liar { force: f64::NAN, ..good() }).is_err());
    let found = new(Liar { largest: f64::NAN, ..good() });
    assert!(matches!(found, Err(ContactError::BeyondLaw { force: 1.0, .. })), "{found:?}");
}
