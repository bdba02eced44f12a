//! Degenerate and extreme outlines, each with its exact answer or error.

#![expect(clippy::float_cmp, reason = "the expected numbers are exact")]

use clench_shape::{LARGEST_COORDINATE, Polygon, PolygonError, SMALLEST_COORDINATE, Winding};
use clench_testkit::assert_close;

#[track_caller]
fn refused(corners: &[[f64; 2]], expected: PolygonError) {
    assert_eq!(Polygon::new(corners), Err(expected));
}

#[test]
fn fewer_than_three_corners_enclose_nothing() {
    refused(&[], PolygonError::TooFewCorners { count: 0 });
    refused(&[[1.0, 2.0]], PolygonError::TooFewCorners { count: 1 });
    refused(&[[1.0, 2.0], [3.0, 4.0]], PolygonError::TooFewCorners { count: 2 });
}

#[test]
fn numbers_that_are_not_finite_are_named_with_their_place() {
    let infinite = PolygonError::NotFinite { corner: 2, axis: 'x', value: f64::INFINITY };
    refused(&[[0.0, 0.0], [1.0, 0.0], [f64::INFINITY, f64::NAN]], infinite);
    let found = Polygon::new(&[[0.0, 0.0], [1.0, f64::NAN], [0.0, 1.0]]).unwrap_err();
    let message = found.to_string();
    let PolygonError::NotFinite { corner: 1, axis: 'y', value } = found else {
        panic!("{found:?}");
    };
    assert!(value.is_nan());
    assert_eq!(message, "y of corner 1 is NaN, not a finite number");
}

#[test]
fn coordinates_whose_areas_overflow_or_underflow_are_refused_by_value() {
    let too_large = PolygonError::TooLarge { corner: 1, axis: 'x', value: -1e200 };
    refused(&[[0.0, 0.0], [-1e200, 0.0], [0.0, 1.0]], too_large);
    let message = too_large.to_string();
    assert!(message.contains("-1e200") && message.contains("1e130"), "{message}");

    let subnormal = f64::from_bits(1);
    let too_small = PolygonError::TooSmall { corner: 2, axis: 'y', value: subnormal };
    refused(&[[0.0, 0.0], [1.0, 0.0], [0.0, subnormal]], too_small);
    let barely = LARGEST_COORDINATE.next_up();
    let too_large = PolygonError::TooLarge { corner: 0, axis: 'y', value: barely };
    refused(&[[0.0, barely], [1.0, 0.0], [0.0, 0.0]], too_large);
}

#[test]
fn a_triangle_of_any_allowed_size_has_the_circle_of_its_hypotenuse() {
    for size in [SMALLEST_COORDINATE, 1e-9, 1.0, 1e9, LARGEST_COORDINATE] {
        let part = Polygon::new(&[
            [0.0, 0.0],
            [0.8 * size.max(1.25 * SMALLEST_COORDINATE), 0.0],
            [0.0, size],
        ]);
        let part = part.unwrap();
        let far = part.edges()[1].length();
        let circle = part.enclosing_circle();
        assert_close(circle.radius, 0.5 * far, 2.0 * f64::EPSILON, far, "radius");
        assert_close(circle.center[1], 0.5 * size, f64::EPSILON, size, "centre");
        assert_eq!(part.farthest(circle.center).distance, circle.radius);
        assert_eq!(part.winding(), Winding::CounterClockwise);
    }
}

#[test]
fn extremes_of_both_kinds_in_one_outline_are_taken_exactly() {
    let (large, small) = (LARGEST_COORDINATE, SMALLEST_COORDINATE);
    // Straight but for the smallest coordinate there is: valid, and nearly flat.
    let part = Polygon::new(&[[-large, 0.0], [0.0, -small], [large, 0.0], [0.0, small]]).unwrap();
    assert_eq!(part.hull(), [0, 1, 2, 3]);
    assert_eq!(part.enclosing_circle().center.to_array(), [0.0, 0.0]);
    assert_eq!(part.enclosing_circle().radius, large);
    assert_eq!(part.farthest([1.0, 0.0].into()).distance, large);
    let flat = [[-large, 0.0], [0.0, 0.0], [large, 0.0]];
    refused(&flat, PolygonError::ZeroArea { count: 3 });
}

#[test]
fn neighbors_at_the_same_point_leave_an_edge_without_length() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    refused(&square, PolygonError::ZeroLengthEdge { start: 1, end: 2 });
    // The first corner repeated at the end, as many file formats do; the zeros differ in sign.
    let closed = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [-0.0, 0.0]];
    let fault = PolygonError::ZeroLengthEdge { start: 3, end: 0 };
    refused(&closed, fault);
    assert!(fault.to_string().contains("corners 3 and 0 are the same point"), "{fault}");
}

#[test]
fn a_corner_repeated_elsewhere_is_found_with_both_its_numbers() {
    // Two triangles that share the corner (0, 0); the zeros differ in sign.
    let touching = [[0.0, 0.0], [1.0, -1.0], [1.0, 1.0], [-0.0, 0.0], [-1.0, 1.0], [-1.0, -1.0]];
    refused(&touching, PolygonError::RepeatedCorner { first: 0, second: 3 });
}

#[test]
fn corners_on_one_line_enclose_nothing() {
    let line = [[0.0, 0.0], [2.0, 2.0], [1.0, 1.0]];
    refused(&line, PolygonError::ZeroArea { count: 3 });
    // 0.1 + 0.2 is not 0.3: these three are not on one line, if only just.
    let nearly = [[0.1, 0.1], [0.2, 0.2], [0.3, 0.1 + 0.2]];
    assert!(Polygon::new(&nearly).is_ok_and(|part| part.hull().len() == 3));
}

#[test]
fn an_edge_that_folds_back_is_named() {
    let longer = [[0.0, 0.0], [3.0, 0.0], [1.0, 0.0], [1.0, 2.0]];
    refused(&longer, PolygonError::FoldedEdge { edge: 1 });
    let beyond = [[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 2.0]];
    refused(&beyond, PolygonError::FoldedEdge { edge: 1 });
    let upwards = [[0.0, 1.0], [0.0, 3.0], [-2.0, 0.0], [0.0, 0.0], [0.0, 4.0]];
    refused(&upwards, PolygonError::FoldedEdge { edge: 0 });
}

#[test]
fn edges_that_cross_or_touch_are_named() {
    let bow_tie = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
    refused(&bow_tie, PolygonError::CrossingEdges { first: 0, second: 2 });
    // Corner 3 is within edge 0, so that edges 2 and 3 touch it.
    let touching = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
    let fault = PolygonError::CrossingEdges { first: 0, second: 2 };
    refused(&touching, fault);
    assert_eq!(
        fault.to_string(),
        "edges 0 and 2 cross or touch, but an outline must not meet itself"
    );
    // A slit: edges 1 and 4 lie on one line and overlap.
    let slit = [[0.0, 0.0], [9.0, 0.0], [9.0, 6.0], [8.0, 6.0], [9.0, 2.0], [9.0, 5.0], [0.0, 6.0]];
    refused(&slit, PolygonError::CrossingEdges { first: 1, second: 3 });
}

#[test]
fn a_gap_of_one_rounding_is_a_gap() {
    let outline = |y: f64| [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, y], [0.0, 2.0]];
    assert!(Polygon::new(&outline(1e-130)).is_ok());
    let touch = PolygonError::CrossingEdges { first: 0, second: 2 };
    refused(&outline(0.0), touch);
    refused(&outline(-1e-130), touch);
}

#[test]
fn corners_within_a_straight_side_are_kept_but_are_no_hull_corners() {
    let part =
        Polygon::new(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 2.0], [0.0, 2.0]]);
    let part = part.unwrap();
    assert_eq!(part.corners().len(), 6);
    assert_eq!(part.edges()[1].inward_normal().to_array(), [0.0, 1.0]);
    assert_eq!(part.hull(), [0, 2, 3, 5]);
    assert_eq!(part.enclosing_circle().center.to_array(), [1.0, 1.0]);
    // Four corners on one circle: the regions meet in one point, with a ray between neighbors.
    assert_eq!(part.partition().borders().len(), 4);
}

#[test]
fn a_clockwise_outline_keeps_its_numbers_and_has_inward_normals() {
    let part = Polygon::new(&[[0.0, 0.0], [0.0, 2.0], [2.0, 2.0], [2.0, 0.0]]).unwrap();
    assert_eq!(part.winding(), Winding::Clockwise);
    assert_eq!(part.edges()[0].inward_normal().to_array(), [1.0, 0.0]);
    assert_eq!(part.edges()[3].start().to_array(), [2.0, 0.0]);
    assert_eq!(part.hull(), [0, 3, 2, 1]);
    assert_eq!(part.area(), 4.0);
}

#[test]
fn places_at_corners_are_called_corners_up_to_rounding_only() {
    let part = Polygon::new(&[[1.0, 1.0], [3.0, 1.0], [3.0, 2.0]]).unwrap();
    let at = part.place([3.0 + 2.0 * f64::EPSILON, 1.0].into());
    assert_eq!((at.edge, at.along, at.corner), (1, 0.0, Some(1)));
    let beside = part.place([3.0 - 1e-14, 1.0].into());
    assert_eq!((beside.edge, beside.corner), (0, None));
}

#[test]
fn a_segment_without_length_is_one_stretch() {
    let part = Polygon::new(&[[0.0, 0.0], [3.0, 0.0], [0.0, 1.0]]).unwrap();
    let stretches: Vec<_> = part.farthest_along([0.5, 0.0].into(), [0.5, 0.0].into()).collect();
    assert_eq!(stretches.len(), 1);
    assert_eq!((stretches[0].corner, stretches[0].from, stretches[0].to), (1, 0.0, 1.0));
}
