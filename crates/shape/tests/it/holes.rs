//! Outlines with holes.

use clench_shape::{Polygon, PolygonError, Winding};
use clench_testkit::{Random, assert_close};

type Corners = Vec<[f64; 2]>;

fn square(low: f64, high: f64) -> Corners {
    vec![[low, low], [high, low], [high, high], [low, high]]
}

fn reversed(mut corners: Corners) -> Corners {
    corners.reverse();
    corners
}

#[track_caller]
fn refused(outline: &Corners, holes: &[Corners], expected: PolygonError) {
    assert_eq!(Polygon::with_holes(outline, holes), Err(expected));
}

#[test]
fn normals_point_into_the_material_whichever_way_round_the_loops_are() {
    let outer = square(0.0, 10.0);
    let hole = square(2.0, 5.0);
    for outer in [outer.clone(), reversed(outer)] {
        for hole in [hole.clone(), reversed(hole.clone())] {
            let part = Polygon::with_holes(&outer, &[hole]).unwrap();
            assert_eq!(part.loops(), [0..4, 4..8]);
            assert_close(part.area(), 91.0, 1e-15, 91.0, "area");
            for edge in part.edges() {
                let middle = part.signed_distance(edge.point_at(0.5 * edge.length()));
                assert!(middle.abs() < 1e-15, "{middle}");
                let inside = edge.point_at(0.5 * edge.length()) + edge.inward_normal() * 0.25;
                assert_eq!(part.signed_distance(inside).to_bits(), (-0.25_f64).to_bits());
            }
        }
    }
}

#[test]
fn a_hole_changes_neither_circle_nor_hull_nor_winding() {
    let outer = reversed(square(0.0, 10.0));
    let plain = Polygon::new(&outer).unwrap();
    let part = Polygon::with_holes(&outer, &[square(2.0, 5.0), square(6.0, 7.0)]).unwrap();
    assert_eq!(part.winding(), Winding::Clockwise);
    assert_eq!(part.enclosing_circle(), plain.enclosing_circle());
    assert_eq!(part.hull(), plain.hull());
    assert!(plain.is_convex() && !part.is_convex());
}

#[test]
fn places_in_holes_are_named_by_edges_and_corners_of_their_own_loop() {
    let part = Polygon::with_holes(&square(0.0, 10.0), &[square(2.0, 5.0), square(6.0, 7.0)]);
    let part = part.unwrap();
    let place = part.place([2.5, 3.0].into());
    assert_eq!((place.edge, place.corner), (7, None));
    assert_eq!(part.place([2.0, 2.0].into()).corner, Some(4));
    // The last edge of a loop ends at its first corner.
    assert_eq!(part.edges()[7].end(), part.edges()[4].start());
    assert_eq!(part.edges()[11].end(), part.edges()[8].start());
    assert_eq!(part.edges()[3].end(), part.edges()[0].start());
    // At a corner of a hole all around it but the hole is material.
    assert!(part.signed_distance([1.9, 1.9].into()) < 0.0);
    assert!(part.signed_distance([2.1, 2.1].into()) > 0.0);
}

/// A plate with random square holes against the definition: in the outline and in no hole.
#[test]
fn the_sign_of_a_distance_says_what_is_material() {
    let mut random = Random::new(11);
    let holes: Vec<Corners> = (0_u32..9)
        .map(|i| {
            let (x, y) = (f64::from(i % 3) + 0.5, f64::from(i / 3) + 0.5);
            let half = random.between(0.05, 0.45);
            vec![[x - half, y], [x, y - half], [x + half, y], [x, y + half]]
        })
        .collect();
    let part = Polygon::with_holes(&square(0.0, 3.0), &holes).unwrap();
    for _ in 0..2000 {
        let point = [random.between(-0.5, 3.5), random.between(-0.5, 3.5)];
        let inside = |hole: &Corners| {
            let center = [0.5 * (hole[0][0] + hole[2][0]), hole[0][1]];
            let half = 0.5 * (hole[2][0] - hole[0][0]);
            (point[0] - center[0]).abs() + (point[1] - center[1]).abs() < half
        };
        let material = point.iter().all(|x| (0.0..=3.0).contains(x)) && !holes.iter().any(inside);
        assert_eq!(part.signed_distance(point.into()) < 0.0, material, "{point:?}");
    }
}

#[test]
fn faults_of_holes_are_told_by_hole_or_by_corners_numbered_through() {
    let outer = square(0.0, 10.0);
    let hole = square(2.0, 5.0);
    let line = vec![[1.0, 1.0], [2.0, 2.0], [3.0, 3.0]];
    let few = PolygonError::TooFewCornersOfHole { hole: 1, count: 2 };
    refused(&outer, &[hole.clone(), line[..2].to_vec()], few);
    refused(
        &outer,
        &[hole.clone(), vec![]],
        PolygonError::TooFewCornersOfHole { hole: 1, count: 0 },
    );
    refused(&outer, &[line], PolygonError::ZeroAreaOfHole { hole: 0, count: 3 });
    refused(&outer, &[square(11.0, 12.0)], PolygonError::HoleOutside { hole: 0 });
    refused(&outer, &[square(-1.0, 11.0)], PolygonError::HoleOutside { hole: 0 });
    let nested = PolygonError::HoleInHole { hole: 1, within: 0 };
    refused(&outer, &[hole.clone(), square(3.0, 4.0)], nested);
    let crossing = PolygonError::CrossingEdges { first: 1, second: 4 };
    refused(&outer, &[square(8.0, 12.0)], crossing);
    refused(
        &outer,
        &[hole.clone(), hole.clone()],
        PolygonError::RepeatedCorner { first: 4, second: 8 },
    );
    let twice = vec![[1.0, 1.0], [2.0, 1.0], [2.0, 1.0], [1.0, 2.0]];
    refused(&outer, &[hole.clone(), twice], PolygonError::ZeroLengthEdge { start: 9, end: 10 });
    let closed = vec![[1.0, 1.0], [2.0, 1.0], [1.0, 2.0], [1.0, 1.0]];
    refused(&outer, &[closed], PolygonError::ZeroLengthEdge { start: 7, end: 4 });
    let bow = vec![[1.0, 1.0], [2.0, 2.0], [2.0, 1.0], [1.0, 2.0]];
    refused(&outer, &[bow], PolygonError::CrossingEdges { first: 4, second: 6 });
    // A hole that touches the outline in a point.
    let touching = vec![[0.0, 5.0], [1.0, 4.0], [1.0, 6.0]];
    refused(&outer, &[touching], PolygonError::CrossingEdges { first: 3, second: 4 });
}
