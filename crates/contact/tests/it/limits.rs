//! What a contact refuses, each with its exact error.

use clench_contact::{Contact, ContactError, Geometry, Law, Order};
use clench_screw::Vector;

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
    assert_eq!(found, Err(ContactError::NoStiffness { slope: 0.0 }));
    assert!(found.unwrap_err().to_string().contains("give it a positive preload"));
    let law = Law::power(1.0, 0.5).unwrap();
    let found = contact([0.0, 0.0], [0.0, 1.0], 0.0, &law, 0.0);
    assert_eq!(found, Err(ContactError::NoStiffness { slope: f64::INFINITY }));
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
