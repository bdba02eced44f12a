//! Convex polygons against each other and against ellipses.

use std::cmp::Ordering;

use clench_screw::{Vector, planar};

use super::DeepestPair;
use super::convex::{Candidate, least_overlap};
use super::ellipsoids::normals_at_point;
use crate::Ellipsoid;
use crate::hull::{compare, hull, sorted};
use crate::predicates::turn;

/// Depths that differ by less are the same: each is the product of a unit vector, good to 1.5
/// roundings, and the difference of two points of bodies of about unit size, up to 6 long; with
/// one more rounding for the product that is 15, so that two of them are up to 30 apart.
const LEVEL: f64 = 32.0 * f64::EPSILON;

/// The deepest pair of two hulls of points, of about unit size.
///
/// The differences of their points are the corners of one polygon: the overlap is how deep the
/// origin is inside it. Cost: O(n log n) in the product `n` of the numbers of hull corners.
pub(crate) fn points_in_plane(finger: &[Vector<2>], part: &[Vector<2>]) -> DeepestPair<2> {
    let (finger, part) = (corners(finger), corners(part));
    let pairs: Vec<[Vector<2>; 2]> =
        finger.iter().flat_map(|&a| part.iter().map(move |&b| [a, b])).collect();
    let apart: Vec<Vector<2>> = pairs.iter().map(|[a, b]| *a - *b).collect();
    let ([from, to], foot) = nearest_side(&apart, &distinct_hull(&apart));
    let mix = |k: usize| pairs[from][k] + (pairs[to][k] - pairs[from][k]) * foot.share;
    DeepestPair {
        depth: foot.depth,
        inward_normal: foot.toward,
        on_finger: mix(0),
        on_part: mix(1),
    }
}

/// The side of a polygon that the origin is nearest to, by the numbers of its ends, and its foot
/// there. From outside, only sides that are seen count.
///
/// Rounding breaks a straight side into pieces of the same depth, of which one has the foot. Of
/// sides of the same depth that one is taken whose foot is least beyond its ends: a side that has
/// it, or else one that ends at the corner that the origin is nearest to.
fn nearest_side(points: &[Vector<2>], around: &[usize]) -> ([usize; 2], Foot) {
    let sides: Vec<([usize; 2], f64)> = (0..around.len())
        .map(|i| [around[i], around[(i + 1) % around.len()]])
        .map(|[p, q]| ([p, q], turn(points[p], points[q], Vector::ZERO)))
        .collect();
    let is_outside = sides.len() < 3 || sides.iter().any(|(_, turn)| *turn < 0.0);
    let foot_on = |&([p, q], turn): &([usize; 2], f64)| {
        let foot = Foot::on_side(points[p], points[q], is_outside);
        (!is_outside || turn <= 0.0).then_some(([p, q], foot))
    };
    let feet: Vec<([usize; 2], Foot)> = sides.iter().filter_map(foot_on).collect();
    let distance = |foot: &Foot| if is_outside { -foot.depth } else { foot.depth };
    let least = feet.iter().fold(f64::INFINITY, |least, (_, foot)| least.min(distance(foot)));
    let order = |one: &Foot, other: &Foot| {
        one.beyond.total_cmp(&other.beyond).then(distance(one).total_cmp(&distance(other)))
    };
    let level = feet.iter().filter(|(_, foot)| distance(foot) <= least + LEVEL);
    let nearest = level.min_by(|(_, one), (_, other)| order(one, other)).copied();
    // Never: a side of a polygon that the origin is outside of is seen.
    nearest.unwrap_or(([around[0]; 2], Foot::at_corner(points[around[0]])))
}

/// Where a side of a polygon is nearest to the origin.
#[derive(Clone, Copy, Debug)]
struct Foot {
    /// As a share of the side.
    share: f64,
    /// How far the origin is behind it, or minus its distance.
    depth: f64,
    /// The unit normal of the side, out of the polygon, or the direction to the origin outside.
    toward: Vector<2>,
    /// How far the foot on the side's line is beyond the nearer end; 0 on the side.
    beyond: f64,
}

impl Foot {
    /// On the side from `p` to `q` of a counter-clockwise polygon, seen from outside or inside.
    ///
    /// Distances along the side are measured from both ends, so that they keep their digits near
    /// either.
    fn on_side(p: Vector<2>, q: Vector<2>, is_outside: bool) -> Self {
        let Some(along) = (q - p).direction() else {
            return Self::at_corner(p);
        };
        let outward = -planar::quarter_turn(along);
        let (before, past) = (p.dot(along), -q.dot(along));
        let (beyond, end, share) = if past > before { (past, q, 1.0) } else { (before, p, 0.0) };
        // On a side that is lost in rounding the ends are as good.
        if beyond <= 0.0 && before + past < 0.0 {
            let share = before / (before + past);
            return Self { share, depth: outward.dot(end), toward: outward, beyond: 0.0 };
        }
        if is_outside {
            let toward = (-end).direction().unwrap_or(outward);
            return Self { share, depth: -end.norm(), toward, beyond };
        }
        Self { share, depth: outward.dot(end), toward: outward, beyond }
    }

    /// At the only corner of a polygon that is a point; at the origin, any direction is as good.
    fn at_corner(corner: Vector<2>) -> Self {
        let toward = (-corner).direction().unwrap_or(Vector::new([1.0, 0.0]));
        Self { share: 0.0, depth: -corner.norm(), toward, beyond: 0.0 }
    }
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
