//! Convex polygons against each other and against ellipses.

use std::cmp::Ordering;

use clench_screw::{Vector, planar};

use super::DeepestPair;
use super::convex::{Candidate, least_overlap};
use super::ellipsoids::normals_at_point;
use crate::Ellipsoid;
use crate::hull::{compare, hull, sorted};

/// The deepest pair of two hulls of points.
///
/// The differences of their points are the corners of one polygon: the overlap is how deep the
/// origin is inside it. Cost: O(n log n) in the product `n` of the numbers of hull corners.
pub(crate) fn points_in_plane(finger: &[Vector<2>], part: &[Vector<2>]) -> DeepestPair<2> {
    let (finger, part) = (corners(finger), corners(part));
    let pairs: Vec<[Vector<2>; 2]> =
        finger.iter().flat_map(|&a| part.iter().map(move |&b| [a, b])).collect();
    let apart: Vec<Vector<2>> = pairs.iter().map(|[a, b]| *a - *b).collect();
    let around = distinct_hull(&apart);
    let sides = (0..around.len()).map(|i| [around[i], around[(i + 1) % around.len()]]);
    let on_side = |[from, to]: [usize; 2]| {
        let (share, depth, inward_normal) = foot_of_origin(apart[from], apart[to]);
        let mix = |k: usize| pairs[from][k] + (pairs[to][k] - pairs[from][k]) * share;
        DeepestPair { depth, inward_normal, on_finger: mix(0), on_part: mix(1) }
    };
    let nearer = |best: DeepestPair<2>, next: DeepestPair<2>| {
        // Outside the polygon, where some depth is negative, only such sides count.
        let better = match (best.depth < 0.0, next.depth < 0.0) {
            (true, true) => next.depth > best.depth,
            (false, false) => next.depth < best.depth,
            (_, apart) => apart,
        };
        if better { next } else { best }
    };
    sides.map(on_side).reduce(nearer).unwrap_or(on_side([0, 0]))
}

/// Where the side from `p` to `q` of a counter-clockwise polygon is nearest to the origin: as a
/// share of the side, with the depth of the origin behind it and the outward direction.
fn foot_of_origin(p: Vector<2>, q: Vector<2>) -> (f64, f64, Vector<2>) {
    let side = q - p;
    let length = side.norm();
    let share = if length > 0.0 { -p.dot(side) / (length * length) } else { 0.0 };
    let outward = (-planar::quarter_turn(side)).direction().unwrap_or(Vector::new([1.0, 0.0]));
    let depth = outward.dot(p);
    if (depth < 0.0 || length <= 0.0) && !(share > 0.0 && share < 1.0) {
        let (share, end) = if share >= 1.0 { (1.0, q) } else { (0.0, p) };
        let toward = (-end).direction().unwrap_or(outward);
        return (share, -end.norm(), toward);
    }
    (share.clamp(0.0, 1.0), depth, outward)
}

/// The deepest pair of an ellipse, the finger, and the hull of points.
///
/// Any normal gives a translation that separates the two, and the least is that of a side or that
/// of a corner: locally least among those of its corner, from either side or from between.
/// Cost: O(n^2) for `n` hull corners.
pub(crate) fn ellipse_and_points(finger: &Ellipsoid<2>, part: &[Vector<2>]) -> DeepestPair<2> {
    let part = corners(part);
    let n = part.len();
    let sides: Vec<Vector<2>> = (0..n).map(|i| part[(i + 1) % n] - part[i]).collect();
    let of_corner = |i: usize| {
        let [before, after] = [(i + n - 1) % n, i].map(|side| (sides[side]).direction());
        let across = [before, after].map(|side| side.map(planar::quarter_turn));
        let between = before.zip(after).and_then(|(one, other)| (other - one).direction());
        let starts = across.into_iter().chain([between]).flatten();
        let first = (part[i] - finger.center()).direction();
        let own = starts.chain(first).flat_map(|start| normals_at_point(finger, part[i], start));
        let own = own.map(|normal| Candidate { normal, feature: vec![part[i]] });
        let side = vec![part[i], part[(i + 1) % n]];
        let side = across[1].map(|normal| Candidate { normal, feature: side });
        own.chain(side).collect::<Vec<_>>()
    };
    let candidates: Vec<Candidate<2>> = (0..n).flat_map(of_corner).collect();
    least_overlap(finger, &part, &candidates)
}

/// The corners of the hull, counter-clockwise.
fn corners(points: &[Vector<2>]) -> Vec<Vector<2>> {
    distinct_hull(points).into_iter().map(|i| points[i]).collect()
}

/// The numbers of the corners of the hull of points that may repeat; one or two on a line.
fn distinct_hull(points: &[Vector<2>]) -> Vec<usize> {
    let mut order = sorted(points);
    order.dedup_by(|i, j| compare(points[*i], points[*j]) == Ordering::Equal);
    if order.len() < 2 { order } else { hull(points, &order) }
}
