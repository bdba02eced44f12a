//! Questions without an answer, and parts at the edge of what has one.

use clench_metrics::LimitedBy;
use clench_optimize::OptimizeError;
use clench_optimize::polygon::{
    FourFingers, Part, ThreeFingers, four_fingers, four_fingers_on, three_fingers, three_fingers_on,
};
use clench_shape::Polygon;

const RECTANGLE: [[f64; 2]; 4] = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]];

fn rectangle() -> Part {
    Part::uniform(Polygon::new(&RECTANGLE).unwrap(), 1.0).unwrap()
}

#[test]
fn each_edge_needs_one_positive_stiffness() {
    let outline = || Polygon::new(&RECTANGLE).unwrap();
    let fault = Part::new(outline(), vec![1.0; 3]).unwrap_err();
    assert_eq!(fault, OptimizeError::StiffnessCount { found: 3, edges: 4 });
    for value in [0.0, -1.0, f64::INFINITY] {
        let fault = Part::new(outline(), vec![1.0, 1.0, value, 1.0]).unwrap_err();
        assert_eq!(fault, OptimizeError::Stiffness { edge: 2, value });
    }
    let fault = Part::uniform(outline(), f64::NAN).unwrap_err();
    assert!(matches!(fault, OptimizeError::Stiffness { edge: 0, value } if value.is_nan()));
}

#[test]
fn three_fingers_need_a_preload_and_a_radius() {
    for value in [0.0, -1.0, f64::INFINITY] {
        let fault = three_fingers(&rectangle(), &ThreeFingers::with_preload(value)).unwrap_err();
        assert_eq!(fault, OptimizeError::TotalPreload { value });
    }
    let options = ThreeFingers { finger_radius: -0.5, ..ThreeFingers::with_preload(1.0) };
    let fault = three_fingers(&rectangle(), &options).unwrap_err();
    assert_eq!(fault, OptimizeError::FingerRadius { value: -0.5 });
}

#[test]
fn edges_that_do_not_exist_are_refused() {
    let fault = four_fingers_on(&rectangle(), [0, 1, 2, 4]).unwrap_err();
    assert_eq!(fault, OptimizeError::NoSuchEdge { edge: 4, last: 3 });
    let options = ThreeFingers::with_preload(1.0);
    let fault = three_fingers_on(&rectangle(), [9, 1, 2], &options).unwrap_err();
    assert_eq!(fault, OptimizeError::NoSuchEdge { edge: 9, last: 3 });
}

#[test]
fn three_fingers_cannot_hold_a_rectangle() {
    let fault = three_fingers(&rectangle(), &ThreeFingers::with_preload(1.0)).unwrap_err();
    assert_eq!(fault, OptimizeError::NoPlacement { fingers: 3, combinations: 4, spanning: 0 });
    assert!(fault.to_string().contains("no placement of 3 frictionless fingers"));
}

/// On a square of side 2 with `k = 1`, fingers at one end of each side, all turning the same way
/// round, are 1 from the center: `mu = 4`, `rho^2 = 2`, both stiffnesses 2.
#[test]
fn a_square_is_held_at_its_corners() {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let part = Part::uniform(Polygon::new(&square).unwrap(), 1.0).unwrap();
    let outcome = four_fingers(&part, &FourFingers::default(), |_| {}).unwrap();
    let best = &outcome.solutions[0];
    assert!((best.quality.value - 2.0).abs() < 1e-14);
    assert!((best.quality.equivalent - 2.0).abs() < 1e-14);
    assert_eq!(best.edges(), [0, 1, 2, 3]);
    assert_eq!(outcome.combinations.total, 13);
}

/// Two fingers on each of two edges, or three on one, never close.
#[test]
fn crowded_edges_never_close() {
    for edges in [[0, 0, 2, 2], [0, 0, 0, 2], [1, 1, 1, 1], [0, 0, 1, 2]] {
        assert_eq!(four_fingers_on(&rectangle(), edges).unwrap(), None, "{edges:?}");
    }
}

#[test]
fn slivers_and_extreme_sizes_have_an_optimum() {
    for size in [1e-9, 1.0, 1e9] {
        for sliver in [1.0, 1e-3, 1e-6] {
            let corners = [[0.0, 0.0], [size, 0.0], [0.4 * size, sliver * size]];
            let part = Part::uniform(Polygon::new(&corners).unwrap(), 2.0).unwrap();
            let four = four_fingers(&part, &FourFingers::default(), |_| {}).unwrap();
            assert!(four.solutions[0].quality.value > 0.0);
            let three = three_fingers(&part, &ThreeFingers::with_preload(1e-3 * size)).unwrap();
            assert!(three.solutions[0].quality.value > 0.0);
        }
    }
}

/// The rounder the outline, the less it can be held against rotation.
#[test]
fn regular_polygons_get_harder_to_hold_with_more_corners() {
    let quality = |n: u32| {
        let angle = |i| std::f64::consts::TAU * f64::from(i) / f64::from(n);
        let corners: Vec<_> = (0..n).map(|i| [angle(i).cos(), angle(i).sin()]).collect();
        let part = Part::uniform(Polygon::new(&corners).unwrap(), 1.0).unwrap();
        four_fingers(&part, &FourFingers::default(), |_| {}).unwrap().solutions[0].quality
    };
    let (six, twenty_four, forty_eight) = (quality(6), quality(24), quality(48));
    assert!(six.value > twenty_four.value && twenty_four.value > forty_eight.value);
    assert_eq!(forty_eight.limited_by, LimitedBy::Rotation);
    // mu is of the order of the squared half side, (pi / n)^2.
    let ratio = twenty_four.value / forty_eight.value;
    assert!((3.9..4.1).contains(&ratio), "{ratio}");
}
