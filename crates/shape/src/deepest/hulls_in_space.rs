//! Convex polytopes against each other and against ellipsoids.

use clench_screw::{Mat, SymmetricEigen, Vector, spatial};
use parry3d_f64::math::{Pose, Vector as ParryVector};
use parry3d_f64::query::details::contact_support_map_support_map;
use parry3d_f64::shape::SupportMap;

use super::DeepestPair;
use super::convex::{
    Candidate, Convex, SHARE_ROUNDING, Supported, least_overlap, nearest_to_support, support,
};
use super::ellipsoids::normals_at_point;
use crate::Ellipsoid;

/// How many points next to the support plane are tried as corners of the feature that touches: a
/// face, an edge and a vertex of a polytope in general position have three together, and one of
/// each may be missed where many points are nearly level, which the next round makes up for.
const CANDIDATES: usize = 9;

/// Rounds of sharpening, each of which starts at what the last one found; two are usual.
const MAX_ROUNDS: usize = 20;

/// The deepest pair of an ellipsoid, the finger, and the hull of points, of about unit size.
///
/// Any normal gives a translation that separates the two. The approximate one of the third party
/// says which vertices of the hull are near; for each vertex, edge and face of them the normal of
/// least overlap is known: that of the point of the ellipsoid nearest to the vertex, the same in
/// the shadow along the edge, and that of the face.
pub(crate) fn ellipsoid_and_points(finger: &Ellipsoid<3>, part: &[Vector<3>]) -> DeepestPair<3> {
    let mut hull = Supported::new(part);
    let overlap = |m: Vector<3>, limit: f64| {
        let ours = finger.support(m);
        let can_be_less = ours + hull.at_least(-m) < limit;
        can_be_less.then(|| ours + hull.support(-m))
    };
    let normals = |m| candidates(finger, part, m).into_iter().map(|one| one.normal).collect();
    let approximate = third_party(&Convex::Ellipsoid(*finger), &Convex::Points(part.to_vec()));
    let toward = (part[0] - finger.center()).direction();
    let starts = approximate.into_iter().map(|pair| pair.inward_normal).chain(toward);
    let (_, normal) = sharpened(starts, overlap, normals);
    let mut last = candidates(finger, part, normal);
    last.push(Candidate { normal, feature: Vec::new() });
    least_overlap(finger, part, &last)
}

/// The normals that may separate an ellipsoid from the vertices, edges and faces of a hull near
/// its support plane against `m`.
fn candidates(finger: &Ellipsoid<3>, part: &[Vector<3>], m: Vector<3>) -> Vec<Candidate<3>> {
    let near = nearest_to_support(part, -m, CANDIDATES);
    let mut all = Vec::new();
    let mut push = |normals: &mut dyn Iterator<Item = Vector<3>>, feature: &[Vector<3>]| {
        all.extend(normals.map(|normal| Candidate { normal, feature: feature.to_vec() }));
    };
    for (i, &u) in near.iter().enumerate() {
        push(&mut normals_at_point(finger, u, m).into_iter(), &[u]);
        for (j, &v) in near.iter().enumerate().skip(i + 1) {
            push(&mut normals_at_line(finger, [u, v], m).into_iter(), &[u, v]);
            for &w in near.iter().skip(j + 1) {
                push(&mut both_normals(v - u, w - u), &[u, v, w]);
            }
        }
    }
    all
}

/// The deepest pair of two hulls of points, of about unit size.
///
/// The differences of their points span one polytope, and the overlap is how deep the origin is
/// inside. The approximate normal of the third party says which of its vertices are near.
pub(crate) fn points_in_space(finger: &[Vector<3>], part: &[Vector<3>]) -> DeepestPair<3> {
    let (mut one, mut other) = (Supported::new(finger), Supported::new(part));
    let overlap = |m: Vector<3>, limit: f64| {
        let can_be_less = one.at_least(m) + other.at_least(-m) < limit;
        can_be_less.then(|| one.support(m) + other.support(-m))
    };
    let normals = |m: Vector<3>| {
        let near = near_differences(finger, part, m);
        features(&near).into_iter().flat_map(|feature| normals_of(&feature)).collect()
    };
    let approximate = third_party(&Convex::Points(finger.to_vec()), &Convex::Points(part.to_vec()));
    let toward = (part[0] - finger[0]).direction().unwrap_or(Vector::new([1.0, 0.0, 0.0]));
    let starts = approximate.into_iter().map(|pair| pair.inward_normal).chain([toward]);
    let (depth, inward_normal) = sharpened(starts, overlap, normals);
    let [on_finger, on_part] = touching_points(finger, part, depth, inward_normal)
        .or(approximate.map(|pair| [pair.on_finger, pair.on_part]))
        .unwrap_or([finger[0], part[0]]);
    // Halfway between the two planes, so that the pair is apart by the depth along the normal.
    let middle = (on_finger + on_part) * 0.5;
    let level = support(finger, inward_normal) - 0.5 * depth;
    let middle = middle + inward_normal * (level - middle.dot(inward_normal));
    DeepestPair {
        depth,
        inward_normal,
        on_finger: middle + inward_normal * (0.5 * depth),
        on_part: middle - inward_normal * (0.5 * depth),
    }
}

/// The least overlap found from the starts, and its normal.
///
/// `overlap` is that of a normal, or none if that is known not to be below some limit.
fn sharpened(
    starts: impl Iterator<Item = Vector<3>>,
    mut overlap: impl FnMut(Vector<3>, f64) -> Option<f64>,
    normals: impl Fn(Vector<3>) -> Vec<Vector<3>>,
) -> (f64, Vector<3>) {
    let mut least = (f64::INFINITY, Vector::new([1.0, 0.0, 0.0]));
    for start in starts {
        let mut at = (f64::INFINITY, start);
        let mut tried = vec![start];
        for _ in 0..=MAX_ROUNDS {
            let before = at.0;
            for normal in tried {
                if let Some(depth) = overlap(normal, at.0).filter(|depth| *depth < at.0) {
                    at = (depth, normal);
                }
            }
            if at.0 >= before {
                break;
            }
            tried = normals(at.1);
        }
        least = if at.0 < least.0 { at } else { least };
    }
    least
}

/// As [`normals_at_point`] for a line: those of the ellipse that is the shadow along it.
fn normals_at_line(
    body: &Ellipsoid<3>,
    [from, to]: [Vector<3>; 2],
    m: Vector<3>,
) -> Vec<Vector<3>> {
    let Some(frame) = (to - from).direction().map(across) else {
        return Vec::new();
    };
    let flat = |v: Vector<3>| Vector::from_fn(|i| frame[i].dot(v));
    let Some(start) = (flat(m)).direction() else {
        return Vec::new();
    };
    let normals = shadow(body, frame).map(|shadow| normals_at_point(&shadow, flat(from), start));
    let lifted = |n: Vector<2>| frame[0] * n[0] + frame[1] * n[1];
    normals.into_iter().flatten().map(lifted).collect()
}

/// The ellipse that an ellipsoid covers in the plane of two unit vectors.
///
/// Its support function is that of the body: `|diag(a) axes^T frame m|`. None if it is so thin
/// that its width is lost.
fn shadow(body: &Ellipsoid<3>, frame: [Vector<3>; 2]) -> Option<Ellipsoid<2>> {
    let stretched: [Vector<3>; 2] = frame.map(|axis| {
        let local = body.axes().transpose() * axis;
        Vector::from_fn(|k| body.semi_axes()[k] * local[k])
    });
    let squares = Mat::<2, 2>::from_fn(|i, j| stretched[i].dot(stretched[j]));
    let eigen = SymmetricEigen::new(&squares).ok().filter(|eigen| eigen.values[0] > 0.0)?;
    let center = Vector::from_fn(|i| frame[i].dot(body.center()));
    let axes = Mat::from_fn(|i, j| eigen.vectors[j][i]);
    Some(Ellipsoid::from_parts(center, eigen.values.map(f64::sqrt), axes))
}

/// Two unit vectors across a unit vector and each other.
fn across(along: Vector<3>) -> [Vector<3>; 2] {
    let magnitudes = along.to_array().map(f64::abs);
    let least = (0..3).fold(0, |m, i| if magnitudes[i] < magnitudes[m] { i } else { m });
    let axis = Vector::from_fn(|i| f64::from(u8::from(i == least)));
    let one = spatial::cross(along, axis);
    let one = one * (1.0 / one.norm());
    [one, spatial::cross(along, one)]
}

/// The unit vectors across two vectors, unless these are parallel.
fn both_normals(u: Vector<3>, v: Vector<3>) -> impl Iterator<Item = Vector<3>> {
    (spatial::cross(u, v)).direction().into_iter().flat_map(|normal| [normal, -normal])
}

/// A point of the one hull less a point of the other, and the two.
#[derive(Clone, Copy)]
struct Difference {
    apart: Vector<3>,
    points: [Vector<3>; 2],
}

/// The differences nearest to the support plane with the normal `m`.
fn near_differences(finger: &[Vector<3>], part: &[Vector<3>], m: Vector<3>) -> Vec<Difference> {
    let ours = nearest_to_support(finger, m, CANDIDATES);
    let theirs = nearest_to_support(part, -m, CANDIDATES);
    let mut all: Vec<Difference> = ours
        .iter()
        .flat_map(|&a| theirs.iter().map(move |&b| Difference { apart: a - b, points: [a, b] }))
        .collect();
    all.sort_by(|x, y| y.apart.dot(m).total_cmp(&x.apart.dot(m)));
    all.truncate(2 * CANDIDATES);
    all
}

/// All vertices, edges and triangles of some differences.
fn features(near: &[Difference]) -> Vec<Vec<Difference>> {
    let mut features = Vec::new();
    for (i, &p) in near.iter().enumerate() {
        features.push(vec![p]);
        for (j, &q) in near.iter().enumerate().skip(i + 1) {
            features.push(vec![p, q]);
            features.extend(near.iter().skip(j + 1).map(|&r| vec![p, q, r]));
        }
    }
    features
}

/// The normals along which a feature of the polytope of differences may be nearest to the origin.
fn normals_of(feature: &[Difference]) -> Vec<Vector<3>> {
    match feature {
        [p] => (-p.apart).direction().into_iter().collect(),
        [p, q] => {
            let along = (q.apart - p.apart).direction();
            let level = along.map(|along| p.apart - along * along.dot(p.apart));
            level.and_then(|level| (-level).direction()).into_iter().collect()
        }
        [p, q, r] => both_normals(q.apart - p.apart, r.apart - p.apart).collect(),
        _ => Vec::new(),
    }
}

/// Points of the two hulls that are `depth` apart along `normal`: those shares of the points of
/// one feature whose difference is there.
fn touching_points(
    finger: &[Vector<3>],
    part: &[Vector<3>],
    depth: f64,
    normal: Vector<3>,
) -> Option<[Vector<3>; 2]> {
    let target = normal * depth;
    let miss = |feature: &Vec<Difference>| {
        let shares = shares_at(feature, target);
        let mix = |points: &dyn Fn(&Difference) -> Vector<3>| {
            feature.iter().zip(&shares).fold(Vector::ZERO, |sum, (d, &s)| sum + points(d) * s)
        };
        let outside = shares.iter().fold(0.0_f64, |m, &share| m.max(-share));
        let missed = (mix(&|d| d.apart) - target).norm();
        (outside, missed, [mix(&|d| d.points[0]), mix(&|d| d.points[1])])
    };
    let near = near_differences(finger, part, normal);
    features(&near)
        .iter()
        .map(miss)
        // Shares of a triangle without area are no numbers, and in no range.
        .filter(|(outside, missed, _)| *outside <= SHARE_ROUNDING && *missed <= SHARE_ROUNDING)
        .reduce(|best, next| if next.1 < best.1 { next } else { best })
        .map(|(_, _, points)| points)
}

/// The shares of a feature's points at its point nearest to `target`; they add up to 1.
fn shares_at(feature: &[Difference], target: Vector<3>) -> Vec<f64> {
    match feature {
        [p, q] => {
            let side = q.apart - p.apart;
            let share = (target - p.apart).dot(side) / side.norm_squared();
            vec![1.0 - share, share]
        }
        [p, q, r] => {
            let (u, v, w) = (q.apart - p.apart, r.apart - p.apart, target - p.apart);
            let normal = spatial::cross(u, v);
            let squared = normal.norm_squared();
            let second = normal.dot(spatial::cross(w, v)) / squared;
            let third = normal.dot(spatial::cross(u, w)) / squared;
            vec![1.0 - second - third, second, third]
        }
        _ => vec![1.0],
    }
}

/// What the third party says of two bodies of about unit size near the origin; it may give up.
fn third_party(finger: &Convex<3>, part: &Convex<3>) -> Option<DeepestPair<3>> {
    let pose = Pose::IDENTITY;
    let found = contact_support_map_support_map(&pose, finger, part, f64::MAX)?;
    let inward_normal = (from_parry(found.normal1)).direction()?;
    inward_normal.is_finite().then(|| DeepestPair {
        depth: -found.dist,
        inward_normal,
        on_finger: from_parry(found.point1),
        on_part: from_parry(found.point2),
    })
}

impl SupportMap for Convex<3> {
    fn local_support_point(&self, direction: ParryVector) -> ParryVector {
        let direction = from_parry(direction);
        let point = match self {
            Self::Ellipsoid(body) => {
                let unit = direction.direction().unwrap_or(Vector::new([1.0, 0.0, 0.0]));
                body.center() + body.support_offset(unit)
            }
            Self::Points(points) => points.iter().skip(1).fold(points[0], |best, &point| {
                if point.dot(direction) > best.dot(direction) { point } else { best }
            }),
        };
        ParryVector::from_array(point.to_array())
    }
}

fn from_parry(v: ParryVector) -> Vector<3> {
    v.to_array().into()
}
