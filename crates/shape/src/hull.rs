//! The convex hull of the corners.

use std::cmp::Ordering;

use clench_screw::Vector;

use crate::predicates::turn;

/// The indices of `points` from left to right, and from below among those above one another.
pub(crate) fn sorted(points: &[Vector<2>]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| compare(points[i], points[j]).then(i.cmp(&j)));
    order
}

/// From left to right, then from below; the coordinates are finite.
pub(crate) fn compare(a: Vector<2>, b: Vector<2>) -> Ordering {
    // Adding zero makes the two zeros equal.
    (a[0] + 0.0).total_cmp(&(b[0] + 0.0)).then((a[1] + 0.0).total_cmp(&(b[1] + 0.0)))
}

/// The vertices of the convex hull, counter-clockwise from the leftmost; strictly convex.
///
/// `order` lists distinct points as [`sorted`] does. Fewer than three points on one line only.
/// Andrew's monotone chain with exact turns.
pub(crate) fn hull(points: &[Vector<2>], order: &[usize]) -> Vec<usize> {
    let mut lower = chain(points, order.iter().copied());
    let upper = chain(points, order.iter().rev().copied());
    lower.pop();
    lower.extend(&upper[..upper.len() - 1]);
    lower
}

/// The left turns from the first point to the last.
fn chain(points: &[Vector<2>], order: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut kept: Vec<usize> = Vec::new();
    for i in order {
        while let [.., a, b] = kept[..] {
            if turn(points[a], points[b], points[i]) > 0.0 {
                break;
            }
            kept.pop();
        }
        kept.push(i);
    }
    kept
}
