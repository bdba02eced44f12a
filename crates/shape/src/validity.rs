//! Whether a list of corners is the outline of a part.

use std::cmp::Ordering;
use std::ops::Range;

use clench_screw::Vector;
use parry2d_f64::bounding_volume::Aabb;
use parry2d_f64::math::Vector as ParryVector;
use parry2d_f64::partitioning::{Bvh, BvhBuildStrategy};

use crate::PolygonError;
use crate::hull::{compare, hull, sorted};
use crate::loops::Loops;
use crate::predicates::{turn, unit_scale};

/// The largest magnitude of a coordinate (length).
///
/// Areas are products of two differences of coordinates, at most 4e260, so that they and their
/// split into exact parts stay far below the largest double, 1.8e308.
pub const LARGEST_COORDINATE: f64 = 1e130;

/// The smallest magnitude of a coordinate that is not zero (length).
///
/// A difference of two such coordinates is zero or at least `1e-130 * 2^-53`, 1e-146; its square
/// is a normal double with all digits, and products of rounding errors are exact.
pub const SMALLEST_COORDINATE: f64 = 1e-130;

/// The convex hull of a valid outline, counter-clockwise, or what is wrong with the outline.
///
/// The faults are looked for in the order of [`PolygonError`]'s variants; each check may rely on
/// those before it.
pub(crate) fn checked_hull(
    corners: &[Vector<2>],
    loops: &Loops,
) -> Result<Vec<usize>, PolygonError> {
    check_counts(loops)?;
    check_coordinates(corners)?;
    check_edge_lengths(corners, loops)?;
    let order = sorted(corners);
    check_repetition(corners, &order)?;
    let hull = checked_areas(corners, loops, &order)?;
    check_folds(corners, loops)?;
    check_crossings(corners, loops)?;
    check_nesting(corners, loops)?;
    Ok(hull)
}

fn check_counts(loops: &Loops) -> Result<(), PolygonError> {
    match loops.runs().iter().position(|run| run.len() < 3) {
        None => Ok(()),
        Some(0) => Err(PolygonError::TooFewCorners { count: loops.runs()[0].len() }),
        Some(place) => {
            let count = loops.runs()[place].len();
            Err(PolygonError::TooFewCornersOfHole { hole: place - 1, count })
        }
    }
}

/// The hull of the outer loop, if each loop encloses an area; `order` sorts all corners.
fn checked_areas(
    corners: &[Vector<2>],
    loops: &Loops,
    order: &[usize],
) -> Result<Vec<usize>, PolygonError> {
    let hull_of = |run: &Range<usize>| {
        let order: Vec<usize> = order.iter().copied().filter(|i| run.contains(i)).collect();
        hull(corners, &order)
    };
    let [outer, holes @ ..] = loops.runs() else { return Ok(Vec::new()) };
    let around = hull_of(outer);
    if around.len() < 3 {
        return Err(PolygonError::ZeroArea { count: outer.len() });
    }
    let all_on_a_line = |run: &Range<usize>| {
        let mut others = run.clone().skip(2);
        others.all(|i| turn(corners[run.start], corners[run.start + 1], corners[i]) == 0.0)
    };
    match holes.iter().position(all_on_a_line) {
        None => Ok(around),
        Some(hole) => Err(PolygonError::ZeroAreaOfHole { hole, count: holes[hole].len() }),
    }
}

fn check_coordinates(corners: &[Vector<2>]) -> Result<(), PolygonError> {
    let named = |(corner, v): (usize, &Vector<2>)| {
        v.to_array().into_iter().zip(['x', 'y']).map(move |(value, axis)| (corner, axis, value))
    };
    for (corner, axis, value) in corners.iter().enumerate().flat_map(named) {
        if !value.is_finite() {
            return Err(PolygonError::NotFinite { corner, axis, value });
        }
        if value.abs() > LARGEST_COORDINATE {
            return Err(PolygonError::TooLarge { corner, axis, value });
        }
        if value.abs() > 0.0 && value.abs() < SMALLEST_COORDINATE {
            return Err(PolygonError::TooSmall { corner, axis, value });
        }
    }
    Ok(())
}

fn check_edge_lengths(corners: &[Vector<2>], loops: &Loops) -> Result<(), PolygonError> {
    for (start, &corner) in corners.iter().enumerate() {
        let end = loops.after(start);
        if corner == corners[end] {
            return Err(PolygonError::ZeroLengthEdge { start, end });
        }
    }
    Ok(())
}

/// Equal points are neighbors in the sorted order, the lower number first.
fn check_repetition(corners: &[Vector<2>], order: &[usize]) -> Result<(), PolygonError> {
    let equal = |pair: &&[usize]| compare(corners[pair[0]], corners[pair[1]]) == Ordering::Equal;
    match order.windows(2).filter(equal).min() {
        Some(pair) => Err(PolygonError::RepeatedCorner { first: pair[0], second: pair[1] }),
        None => Ok(()),
    }
}

/// An edge folds back when it is on the line of the edge before it, in the opposite direction.
fn check_folds(corners: &[Vector<2>], loops: &Loops) -> Result<(), PolygonError> {
    for edge in 0..corners.len() {
        let (before, at, after) =
            (corners[loops.before(edge)], corners[edge], corners[loops.after(edge)]);
        // On one line, the neighbors are on the same side of the corner if the order says so.
        let folded = compare(before, at) != compare(at, after);
        if folded && turn(before, at, after) == 0.0 {
            return Err(PolygonError::FoldedEdge { edge });
        }
    }
    Ok(())
}

/// Looks for the first edge that meets another one that is not its neighbor.
///
/// Cost: O(n log n) when few boxes of edges overlap, as on the outlines of parts.
fn check_crossings(corners: &[Vector<2>], loops: &Loops) -> Result<(), PolygonError> {
    let edge = |e: usize| [corners[e], corners[loops.after(e)]];
    let boxes = edge_boxes(corners, edge);
    let tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes);
    for (first, around) in boxes.iter().enumerate() {
        let crossing = tree
            .intersect_aabb(around)
            .map(|leaf| leaf as usize)
            .filter(|&second| second > first)
            .filter(|&second| loops.after(first) != second && loops.after(second) != first)
            .filter(|&second| meet(edge(first), edge(second)))
            .min();
        if let Some(second) = crossing {
            return Err(PolygonError::CrossingEdges { first, second });
        }
    }
    Ok(())
}

/// Each hole has to be within the outer loop, and within no other hole.
///
/// The loops meet nowhere, so one corner tells for all. Cost: O(n) per hole.
fn check_nesting(corners: &[Vector<2>], loops: &Loops) -> Result<(), PolygonError> {
    let [outer, holes @ ..] = loops.runs() else { return Ok(()) };
    let ends = |run: &Range<usize>| run.clone().map(|e| [corners[e], corners[loops.after(e)]]);
    for (hole, run) in holes.iter().enumerate() {
        let corner = corners[run.start];
        if !surround(ends(outer), corner) {
            return Err(PolygonError::HoleOutside { hole });
        }
        let around = holes.iter().position(|other| other != run && surround(ends(other), corner));
        if let Some(within) = around {
            return Err(PolygonError::HoleInHole { hole, within });
        }
    }
    Ok(())
}

/// Whether closed chains of `edges` that `point` is not on enclose it, an odd number of times;
/// exactly.
pub(crate) fn surround(edges: impl Iterator<Item = [Vector<2>; 2]>, point: Vector<2>) -> bool {
    // Edges that the ray from the point to the right crosses.
    let crossed = edges.filter(|&[start, end]| {
        let upward = start[1] <= point[1] && end[1] > point[1];
        let downward = end[1] <= point[1] && start[1] > point[1];
        (upward && turn(start, end, point) > 0.0) || (downward && turn(start, end, point) < 0.0)
    });
    crossed.count() % 2 == 1
}

/// The exact boxes of the edges, in units of about the part's own size.
fn edge_boxes(corners: &[Vector<2>], edge: impl Fn(usize) -> [Vector<2>; 2]) -> Vec<Aabb> {
    let scale = unit_scale(corners.iter().fold(0.0_f64, |m, corner| m.max(corner.max_abs())));
    let point = |corner: Vector<2>| ParryVector::from_array((corner * scale).to_array());
    (0..corners.len())
        .map(|e| {
            let [start, end] = edge(e).map(point);
            Aabb::new(start.min(end), start.max(end))
        })
        .collect()
}

/// Whether two edges whose boxes have a point in common have one themselves, ends included.
///
/// Neither edge may have both its ends strictly on one side of the other's line. If all four turns
/// vanish, both are on one line and meet where their boxes do.
fn meet([p, q]: [Vector<2>; 2], [r, s]: [Vector<2>; 2]) -> bool {
    let apart = |a: f64, b: f64| (a > 0.0 && b > 0.0) || (a < 0.0 && b < 0.0);
    !apart(turn(p, q, r), turn(p, q, s)) && !apart(turn(r, s, p), turn(r, s, q))
}
