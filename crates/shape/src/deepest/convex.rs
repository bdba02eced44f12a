//! Convex bodies by their support functions, in units of their own size.

use clench_screw::Vector;

use super::DeepestPair;
use crate::Ellipsoid;
use crate::predicates::unit_scale;

/// A convex body of a pair that has no ball in it.
#[derive(Clone, Debug)]
pub(crate) enum Convex<const N: usize> {
    Ellipsoid(Ellipsoid<N>),
    /// The hull of at least one point.
    Points(Vec<Vector<N>>),
}

impl<const N: usize> Convex<N> {
    /// A point of the body.
    fn middle(&self) -> Vector<N> {
        match self {
            Self::Ellipsoid(body) => body.center(),
            Self::Points(points) => points[0],
        }
    }

    /// At least the largest distance of a point of the body from `center`, at most twice that.
    fn extent(&self, center: Vector<N>) -> f64 {
        match self {
            Self::Ellipsoid(body) => (body.center() - center).max_abs() + body.radius(),
            Self::Points(points) => {
                points.iter().fold(0.0, |m: f64, &point| m.max((point - center).max_abs()))
            }
        }
    }

    fn in_units(&self, center: Vector<N>, scale: f64) -> Self {
        match self {
            Self::Ellipsoid(body) => Self::Ellipsoid(body.in_units(center, scale)),
            Self::Points(points) => {
                let mut points: Vec<Vector<N>> =
                    points.iter().map(|&point| (point - center) * scale).collect();
                // Repeated points, as of triangles, would crowd out the others near a plane.
                let key = |v: &Vector<N>| v.to_array().map(|x| (x + 0.0).to_bits());
                points.sort_unstable_by_key(key);
                points.dedup_by_key(|v| key(v));
                Self::Points(points)
            }
        }
    }
}

/// Solves for two bodies of about unit size near the origin, and writes the answer back.
///
/// Tolerances of the third party are absolute. The factor is a power of two, so that the unit of
/// length decides nothing.
pub(crate) fn in_own_units<const N: usize>(
    finger: &Convex<N>,
    part: &Convex<N>,
    solve: impl FnOnce(Convex<N>, Convex<N>) -> DeepestPair<N>,
) -> DeepestPair<N> {
    let center = finger.middle();
    let size = finger.extent(center).max(part.extent(center));
    // Two points at one place have no size.
    let scale = if size > 0.0 { unit_scale(size) } else { 1.0 };
    let found = solve(finger.in_units(center, scale), part.in_units(center, scale));
    DeepestPair {
        depth: found.depth / scale,
        inward_normal: found.inward_normal,
        on_finger: center + found.on_finger * (1.0 / scale),
        on_part: center + found.on_part * (1.0 / scale),
    }
}

/// The support function of a hull: the largest `p . direction`.
pub(super) fn support<const N: usize>(points: &[Vector<N>], direction: Vector<N>) -> f64 {
    points.iter().fold(f64::NEG_INFINITY, |m, point| m.max(point.dot(direction)))
}

/// A hull whose support function is asked for in many directions, most of which do not matter.
///
/// The largest product over a few of its points, those that were farthest before, is never more
/// than over all, and rounds to no more: a direction that it rules out is ruled out.
#[derive(Clone, Debug)]
pub(super) struct Supported<'a, const N: usize> {
    points: &'a [Vector<N>],
    farthest: Vec<Vector<N>>,
}

impl<'a, const N: usize> Supported<'a, N> {
    pub(super) fn new(points: &'a [Vector<N>]) -> Self {
        Self { points, farthest: Vec::new() }
    }

    /// At most the support function. Cost: that of the points that were ever farthest.
    pub(super) fn at_least(&self, direction: Vector<N>) -> f64 {
        support(&self.farthest, direction)
    }

    /// The support function. Cost: O(n) for `n` points.
    pub(super) fn support(&mut self, direction: Vector<N>) -> f64 {
        let none = (f64::NEG_INFINITY, None);
        let (largest, farthest) = self.points.iter().fold(none, |best, &point| {
            let product = point.dot(direction);
            if product > best.0 { (product, Some(point)) } else { best }
        });
        self.farthest.extend(farthest.filter(|_| largest > self.at_least(direction)));
        largest
    }
}

/// The `count` points nearest to the support plane of a hull in some direction, nearest first.
pub(super) fn nearest_to_support<const N: usize>(
    points: &[Vector<N>],
    direction: Vector<N>,
    count: usize,
) -> Vec<Vector<N>> {
    let mut sorted: Vec<(f64, Vector<N>)> =
        points.iter().map(|&point| (-point.dot(direction), point)).collect();
    if sorted.len() > count {
        sorted.select_nth_unstable_by(count, |a, b| a.0.total_cmp(&b.0));
        sorted.truncate(count);
    }
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    sorted.into_iter().map(|(_, point)| point).collect()
}

/// Overlaps of bodies of about unit size that differ by less are the same: each is the sum of
/// support functions of up to that size, good to a few roundings.
const LEVEL: f64 = 16.0 * f64::EPSILON;

/// A point may be outside a triangle by this share of its height, as a quotient of products of
/// coordinates that were rounded before.
pub(super) const SHARE_ROUNDING: f64 = 1024.0 * f64::EPSILON;

/// A normal that may separate an ellipsoid from a hull, and the corners of the hull, up to three,
/// that it would be separated from.
#[derive(Clone, Debug)]
pub(super) struct Candidate<const N: usize> {
    pub(super) normal: Vector<N>,
    pub(super) feature: Vec<Vector<N>>,
}

/// The pair of an ellipsoid, the finger, and a hull with the candidate of least overlap.
///
/// Near its minimum the overlap is flat to rounding while the normal still turns. Of candidates
/// with the same overlap that one is best whose point of the part is on its feature.
pub(super) fn least_overlap<const N: usize>(
    finger: &Ellipsoid<N>,
    part: &[Vector<N>],
    candidates: &[Candidate<N>],
) -> DeepestPair<N> {
    let mut hull = Supported::new(part);
    let mut least = f64::INFINITY;
    let mut pairs = Vec::new();
    for Candidate { normal, feature } in candidates {
        let (inward_normal, ours) = (*normal, finger.support(*normal));
        if ours + hull.at_least(-inward_normal) > least + LEVEL {
            continue;
        }
        let depth = ours + hull.support(-inward_normal);
        least = least.min(depth);
        let on_finger = finger.center() + finger.support_offset(inward_normal);
        let on_part = on_finger - inward_normal * depth;
        let pair = DeepestPair { depth, inward_normal, on_finger, on_part };
        pairs.push((distance_to(feature, on_part), pair));
    }
    let none = DeepestPair {
        depth: least,
        inward_normal: Vector::ZERO,
        on_finger: finger.center(),
        on_part: part[0],
    };
    pairs
        .into_iter()
        .filter(|(_, pair)| pair.depth <= least + LEVEL)
        .reduce(|best, next| if next.0 < best.0 { next } else { best })
        .map_or(none, |(_, pair)| pair)
}

/// The distance of `point` from a corner, an edge or a triangle; infinite beside the triangle,
/// where its edges tell, and from nothing.
fn distance_to<const N: usize>(feature: &[Vector<N>], point: Vector<N>) -> f64 {
    match *feature {
        [p] => (point - p).norm(),
        [p, q] => {
            let (u, w) = (q - p, point - p);
            let share = (w.dot(u) / u.norm_squared()).clamp(0.0, 1.0);
            (w - u * share).norm()
        }
        [p, q, r] => {
            let (u, v, w) = (q - p, r - p, point - p);
            let (uu, uv, vv) = (u.norm_squared(), u.dot(v), v.norm_squared());
            let area = uu * vv - uv * uv;
            let second = (vv * w.dot(u) - uv * w.dot(v)) / area;
            let third = (uu * w.dot(v) - uv * w.dot(u)) / area;
            let inside = second.min(third).min(1.0 - second - third) >= -SHARE_ROUNDING;
            if inside { (w - u * second - v * third).norm() } else { f64::INFINITY }
        }
        _ => f64::INFINITY,
    }
}

#[cfg(test)]
mod tests {
    use clench_testkit::Random;

    use super::{Supported, Vector, support};

    #[test]
    fn a_bound_from_few_points_rules_out_no_direction_below_it() {
        let r = &mut Random::new(58);
        let points: Vec<Vector<3>> = (0..20_000).map(|_| Vector::new(r.array(1.0))).collect();
        let mut hull = Supported::new(&points);
        let (mut least, mut expected, mut asked) = (f64::INFINITY, f64::INFINITY, 0);
        for _ in 0..2000 {
            let direction = Vector::new(r.array(1.0));
            expected = expected.min(support(&points, direction));
            if hull.at_least(direction) < least {
                least = least.min(hull.support(direction));
                asked += 1;
            }
        }
        assert_eq!(least.to_bits(), expected.to_bits());
        assert!(asked < 100, "all points were asked {asked} times");
    }
}
