//! Whether a list of corners is the outline of a part.

use std::cmp::Ordering;

use clench_screw::Vector;
use parry2d_f64::bounding_volume::Aabb;
use parry2d_f64::math::Vector as ParryVector;
use parry2d_f64::partitioning::{Bvh, BvhBuildStrategy};

use crate::PolygonError;
use crate::hull::{compare, hull, sorted};
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
pub(crate) fn checked_hull(corners: &[Vector<2>]) -> Result<Vec<usize>, PolygonError> {
    let count = corners.len();
    if count < 3 {
        return Err(PolygonError::TooFewCorners { count });
    }
    check_coordinates(corners)?;
    check_edge_lengths(corners)?;
    let order = sorted(corners);
    check_repetition(corners, &order)?;
    let hull = hull(corners, &order);
    if hull.len() < 3 {
        return Err(PolygonError::ZeroArea { count });
    }
    check_folds(corners)?;
    check_crossings(corners)?;
    Ok(hull)
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

fn check_edge_lengths(corners: &[Vector<2>]) -> Result<(), PolygonError> {
    for (start, &corner) in corners.iter().enumerate() {
        let end = (start + 1) % corners.len();
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
fn check_folds(corners: &[Vector<2>]) -> Result<(), PolygonError> {
    let n = corners.len();
    for edge in 0..n {
        let (before, at, after) =
            (corners[(edge + n - 1) % n], corners[edge], corners[(edge + 1) % n]);
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
fn check_crossings(corners: &[Vector<2>]) -> Result<(), PolygonError> {
    let n = corners.len();
    let boxes = edge_boxes(corners);
    let tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes);
    for (first, around) in boxes.iter().enumerate() {
        let crossing = tree
            .intersect_aabb(around)
            .map(|leaf| leaf as usize)
            .filter(|&second| second > first + 1 && (second + 1) % n != first)
            .filter(|&second| meet(edge(corners, first), edge(corners, second)))
            .min();
        if let Some(second) = crossing {
            return Err(PolygonError::CrossingEdges { first, second });
        }
    }
    Ok(())
}

fn edge(corners: &[Vector<2>], e: usize) -> [Vector<2>; 2] {
    [corners[e], corners[(e + 1) % corners.len()]]
}

/// The exact boxes of the edges, in units of about the part's own size.
fn edge_boxes(corners: &[Vector<2>]) -> Vec<Aabb> {
    let scale = unit_scale(corners.iter().fold(0.0_f64, |m, corner| m.max(corner.max_abs())));
    let point = |corner: Vector<2>| ParryVector::from_array((corner * scale).to_array());
    (0..corners.len())
        .map(|e| {
            let [start, end] = edge(corners, e).map(point);
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
