//! Questions without an answer, and parts at the edge of what has one.

use clench_optimize::polygon::{
    Fingers, LARGEST_SPREAD, Part, ThreeFingers, fingers, four_fingers_on, three_fingers,
    three_fingers_on,
};
use clench_optimize::{Effort, OptimizeError, unwatched};
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
        let fault = three_fingers(
            &rectangle(),
            &ThreeFingers::with_preload(value),
            &Effort::default(),
            unwatched,
        )
        .unwrap_err();
        assert_eq!(fault, OptimizeError::TotalPreload { value });
    }
    let options = ThreeFingers { finger_radius: -0.5, ..ThreeFingers::with_preload(1.0) };
    let fault = three_fingers(&rectangle(), &options, &Effort::default(), unwatched).unwrap_err();
    assert_eq!(fault, OptimizeError::FingerRadius { value: -0.5 });
}

#[test]
fn edges_that_do_not_exist_are_refused() {
    let fault = four_fingers_on(&rectangle(), [0, 1, 2, 4], &Fingers::new(4)).unwrap_err();
    assert_eq!(fault, OptimizeError::NoSuchEdge { edge: 4, last: 3 });
    let options = ThreeFingers::with_preload(1.0);
    let fault = three_fingers_on(&rectangle(), [9, 1, 2], &options).unwrap_err();
    assert_eq!(fault, OptimizeError::NoSuchEdge { edge: 9, last: 3 });
}

#[test]
fn three_fingers_cannot_hold_a_rectangle() {
    let fault = three_fingers(
        &rectangle(),
        &ThreeFingers::with_preload(1.0),
        &Effort::default(),
        unwatched,
    )
    .unwrap_err();
    assert_eq!(fault, OptimizeError::NormalsNeverBalance { fingers: 3, combinations: 4.0 });
    assert!(fault.to_string().contains("no placement of 3 frictionless fingers"));
}

/// A bent strip: the normals of two triplets balance, but none has a point that all three face.
#[test]
fn three_fingers_need_a_point_where_their_normals_meet() {
    let strip = [[2.0, 5.0], [5.0, 2.0], [6.0, 0.0], [5.0, 1.0], [1.0, 5.0], [1.0, 6.0]];
    let part = Part::uniform(Polygon::new(&strip).unwrap(), 1.0).unwrap();
    let fault =
        three_fingers(&part, &ThreeFingers::with_preload(1.0), &Effort::default(), unwatched)
            .unwrap_err();
    assert_eq!(fault, OptimizeError::TorquesNeverBalance { fingers: 3, combinations: 20.0 });
}

#[test]
fn stiffnesses_of_any_size_but_not_of_any_ratio_are_taken() {
    let outline = || Polygon::new(&RECTANGLE).unwrap();
    let quality = |k: f64| {
        let part = Part::uniform(outline(), k).unwrap();
        fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap().best.quality.value
    };
    for k in [1e-200, 1e200, 1e300] {
        assert!((quality(k) / k - quality(1.0)).abs() <= 1e-12 * quality(1.0), "{k:e}");
    }
    let fault = Part::new(outline(), vec![1e10, 1.0, 1.0, 2.0]).unwrap_err();
    let (smallest, largest, limit) = (1.0, 1e10, LARGEST_SPREAD);
    assert_eq!(fault, OptimizeError::StiffnessSpread { smallest, largest, limit });
}

/// So flat that its stiffness across is lost beside the one along: refused, not called free.
#[test]
fn a_needle_beyond_rounding_is_out_of_range() {
    let needle = Polygon::new(&[[0.0, 0.0], [1.0, 0.0], [0.4, 3e-8]]).unwrap();
    let part = Part::uniform(needle, 1.0).unwrap();
    let fault = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap_err();
    assert!(matches!(fault, OptimizeError::OutOfRange { .. }), "{fault:?}");
}

/// On a square of side 2 with `k = 1`, fingers at one end of each side, all turning the same way
/// round, are 1 from the center: `mu = 4`, `rho^2 = 2`, both stiffnesses 2.
#[test]
fn a_square_is_held_at_its_corners() {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let part = Part::uniform(Polygon::new(&square).unwrap(), 1.0).unwrap();
    let outcome = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap();
    let best = &outcome.best;
    assert!((best.quality.value - 2.0).abs() < 1e-14);
    assert!((best.quality.equivalent() - 2.0).abs() < 1e-14);
    assert_eq!(best.edges(), [0, 1, 2, 3]);
    assert_eq!(outcome.combinations.total, 35.0);
}

/// Two fingers on each of two edges, or three on one, never close.
#[test]
fn crowded_edges_never_close() {
    for edges in [[0, 0, 2, 2], [0, 0, 0, 2], [1, 1, 1, 1], [0, 0, 1, 2]] {
        assert_eq!(
            four_fingers_on(&rectangle(), edges, &Fingers::new(4)).unwrap(),
            None,
            "{edges:?}"
        );
    }
}

#[test]
fn slivers_and_extreme_sizes_have_an_optimum() {
    for size in [1e-9, 1.0, 1e9] {
        for sliver in [1.0, 1e-3, 1e-6] {
            let corners = [[0.0, 0.0], [size, 0.0], [0.4 * size, sliver * size]];
            let part = Part::uniform(Polygon::new(&corners).unwrap(), 2.0).unwrap();
            let four = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap();
            assert!(four.best.quality.value > 0.0);
            let three = three_fingers(
                &part,
                &ThreeFingers::with_preload(1e-3 * size),
                &Effort::default(),
                unwatched,
            )
            .unwrap();
            assert!(three.best.quality.value > 0.0);
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
        fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap().best.quality
    };
    let (six, twenty_four, forty_eight) = (quality(6), quality(24), quality(48));
    assert!(six.value > twenty_four.value && twenty_four.value > forty_eight.value);
    // mu is of the order of the squared half side, (pi / n)^2.
    let ratio = twenty_four.value / forty_eight.value;
    assert!((3.9..4.1).contains(&ratio), "{ratio}");
}
