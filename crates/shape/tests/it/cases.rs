//! Smallest circles of the paper and of the reference cases.

use clench_shape::Polygon;
use clench_testkit::cases::{array, list, matching, numbers};
use clench_testkit::{assert_all_close, assert_close};

/// The reference circles come from a double-precision program; they are given with 16 digits, and
/// a centre suffers from cancellation in coordinates of a few radii.
const DIGITS: f64 = 1e-12;

#[test]
fn the_quadrilateral_of_example_5_1_has_the_centre_and_radius_of_the_paper() {
    // [LBR, Example 5.1] prints 6.7315 and (6.5, 1.75); the circle stands on the side from (0, 0)
    // to (13, 0) and goes through (9, 8), so that r^2 = 6.5^2 + 1.75^2 = 45.3125.
    let part = Polygon::new(&[[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]]).unwrap();
    let circle = part.enclosing_circle();
    assert_all_close(&circle.center.to_array(), &[6.5, 1.75], f64::EPSILON, "centre");
    assert_close(circle.radius.powi(2), 45.3125, 4.0 * f64::EPSILON, 45.3125, "r^2");
    assert_close(circle.radius, 6.7315, 5e-5, 1.0, "printed radius");
}

#[test]
fn smallest_circles_are_those_of_the_reference_polygons() {
    let mut checked = 0;
    for (name, cases) in matching("polygon_four_finger") {
        for (i, case) in list(&cases).iter().enumerate() {
            let corners: Vec<[f64; 2]> = list(&case["vertices"]).iter().map(array).collect();
            let circle = Polygon::new(&corners).unwrap().enclosing_circle();
            let [x, y] = circle.center.to_array();
            let expected = numbers(&case["four_finger"]["mec"]);
            assert_all_close(&[x, y, circle.radius], &expected, DIGITS, format!("{name} {i}"));
            checked += 1;
        }
    }
    assert_eq!(checked, 8, "number of polygons");
}
