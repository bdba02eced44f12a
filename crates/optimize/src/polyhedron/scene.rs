//! What the search needs to know of a part: places to touch, in units of the part's size.

use clench_screw::spatial::cross;
use clench_screw::{Twist, Vector};
use clench_shape::ExtremePoints;

use super::tips::Tips;
use super::vectors::{first, joined, second};
use super::{Fingers, Part, Touch, round};
use crate::OptimizeError;

/// Where a body has more extreme points, so many of them stand for it in bounds and first looks.
const COARSE: usize = 64;

/// A flat place to touch: a facet, or a candidate.
#[derive(Clone, Debug)]
pub(super) struct Patch {
    /// The unit normal into the part.
    pub(super) normal: Vector<3>,
    /// `sqrt(k)`, in the scene's unit of stiffness.
    pub(super) weight: f64,
    /// The triangles that cover it; none if it is a point.
    pub(super) triangles: Vec<[Vector<3>; 3]>,
    /// The corners of its convex hull, one after the other; of a point, the point.
    pub(super) corners: Vec<Vector<3>>,
}

impl Patch {
    fn of_facet(
        normal: Vector<3>,
        triangles: &[[Vector<3>; 3]],
        stiffness: f64,
        scaled: impl Fn(Vector<3>) -> Vector<3>,
    ) -> Self {
        let triangles: Vec<[Vector<3>; 3]> =
            triangles.iter().map(|triangle| triangle.map(&scaled)).collect();
        let corners = hull(triangles.as_flattened(), normal);
        Self { normal, weight: stiffness.sqrt(), triangles, corners }
    }

    fn of_touch(touch: &Touch, stiffness: f64, scaled: impl Fn(Vector<3>) -> Vector<3>) -> Self {
        Self {
            normal: touch.inward_normal,
            weight: stiffness.sqrt(),
            triangles: Vec::new(),
            corners: vec![scaled(touch.point)],
        }
    }

    pub(super) const fn is_point(&self) -> bool {
        self.triangles.is_empty()
    }

    /// The unit wrench of a force at `point`.
    pub(super) fn unit_wrench(&self, point: Vector<3>) -> Vector<6> {
        joined(self.normal, cross(point, self.normal))
    }

    /// The scaled wrench `p = sqrt(k) (n, x x n)`.
    pub(super) fn wrench(&self, point: Vector<3>) -> Vector<6> {
        self.unit_wrench(point) * self.weight
    }

    /// A point in the middle: of the largest triangle.
    pub(super) fn middle(&self) -> Vector<3> {
        let size = |t: &&[Vector<3>; 3]| cross(t[1] - t[0], t[2] - t[0]).norm_squared();
        let largest = self.triangles.iter().max_by(|a, b| size(a).total_cmp(&size(b)));
        largest.map_or(self.corners[0], |[a, b, c]| (*a + *b + *c) * (1.0 / 3.0))
    }

    /// The edges of its convex hull, seen from `point`: the unit normal away from it, in the plane
    /// of the patch, and how far the edge is.
    pub(super) fn borders(&self, point: Vector<3>) -> impl Iterator<Item = (Vector<3>, f64)> + '_ {
        let count = if self.is_point() { 0 } else { self.corners.len() };
        let middle = self.corners.iter().fold(Vector::ZERO, |sum, &x| sum + x);
        let middle = middle * (self.corners.len() as f64).recip();
        (0..count).filter_map(move |i| {
            let (a, b) = (self.corners[i], self.corners[(i + 1) % count]);
            let across = cross(b - a, self.normal).direction()?;
            let out = if across.dot(middle - a) > 0.0 { -across } else { across };
            Some((out, out.dot(a - point).max(0.0)))
        })
    }

    /// The point of the patch nearest to `point`, which is in its plane.
    pub(super) fn nearest(&self, point: Vector<3>) -> Vector<3> {
        let mut best = (f64::INFINITY, self.corners[0]);
        for triangle in &self.triangles {
            let foot = nearest_in_triangle(triangle, self.normal, point);
            let distance = (foot - point).norm_squared();
            if distance < best.0 {
                best = (distance, foot);
            }
        }
        best.1
    }
}

/// A part seen from the middle of its box, with its radius as the unit of length.
#[derive(Clone, Debug)]
pub(super) struct Scene<'a> {
    /// The part's own extreme points.
    pub(super) body: &'a ExtremePoints<3>,
    center: Vector<3>,
    radius: f64,
    /// The power of four (force / length) that stiffnesses are divided by.
    pub(super) stiffness_unit: f64,
    /// The same in the scene's units.
    pub(super) extremes: ExtremePoints<3>,
    /// A few of them, far from each other; all if they are few.
    pub(super) coarse: ExtremePoints<3>,
    pub(super) patches: Vec<Patch>,
    /// The facet that each patch is on; none for candidates.
    pub(super) facets: Vec<usize>,
    /// The balls at the ends of the fingers, if they have to be apart.
    pub(super) tips: Option<Tips>,
    /// The fixed contacts: unit wrench, and `sqrt(k)`.
    pub(super) fixed: Vec<(Vector<6>, f64)>,
    /// The length of the longest unit wrench, at least 1.
    pub(super) longest_wrench: f64,
    /// How many fingers may be on one patch.
    pub(super) most_on_patch: usize,
}

impl<'a> Scene<'a> {
    /// The facets of a part.
    pub(super) fn of_part(part: &'a Part, fingers: &Fingers) -> Result<Self, OptimizeError> {
        let solid = part.solid();
        let body = solid.extreme_points();
        let frame =
            Scale::new(body.points(), part.face_stiffness().iter().copied(), &fingers.fixed);
        let touched = |&facet: &usize| !part.triangles(facet).is_empty();
        let facets: Vec<usize> = (0..part.facets().len()).filter(touched).collect();
        let patches = facets.iter().map(|&number| {
            let facet = &part.facets()[number];
            let stiffness = part.face_stiffness()[facet.faces()[0]] / frame.stiffness;
            let (normal, triangles) = (facet.inward_normal(), part.triangles(number));
            Patch::of_facet(normal, triangles, stiffness, |x| frame.scaled(x))
        });
        let scene = Self::new(&frame, body, patches.collect(), fingers, fingers.most_on_face)?;
        Ok(Self { facets, ..scene })
    }

    /// Candidates on a body.
    pub(super) fn of_candidates(
        body: &'a ExtremePoints<3>,
        candidates: &[Touch],
        fingers: &Fingers,
    ) -> Result<Self, OptimizeError> {
        let stiffness = candidates.iter().map(|touch| touch.stiffness);
        let frame = Scale::new(body.points(), stiffness, &fingers.fixed);
        let patches = candidates.iter().map(|touch| {
            Patch::of_touch(touch, touch.stiffness / frame.stiffness, |x| frame.scaled(x))
        });
        Self::new(&frame, body, patches.collect(), fingers, 1)
    }

    fn new(
        frame: &Scale,
        body: &'a ExtremePoints<3>,
        patches: Vec<Patch>,
        fingers: &Fingers,
        most_on_patch: usize,
    ) -> Result<Self, OptimizeError> {
        let scaled: Vec<[f64; 3]> =
            body.points().iter().map(|&x| frame.scaled(x).to_array()).collect();
        let extremes = ExtremePoints::new(&scaled).map_err(|_| OptimizeError::Extent)?;
        let spacing = fingers.checked_spacing();
        let given: Vec<_> =
            fingers.fixed.iter().map(|t| (frame.scaled(t.point), t.inward_normal)).collect();
        let tips = spacing.map(|spacing| Tips::new(spacing, patches.len(), &given, frame.radius));
        let fixed = fingers.fixed.iter().map(|touch| {
            let patch =
                Patch::of_touch(touch, touch.stiffness / frame.stiffness, |x| frame.scaled(x));
            (patch.unit_wrench(patch.corners[0]), patch.weight)
        });
        let fixed: Vec<(Vector<6>, f64)> = fixed.collect();
        let of_patches = patches
            .iter()
            .flat_map(|patch: &Patch| patch.corners.iter().map(|&x| patch.unit_wrench(x).norm()));
        let lengths = of_patches.chain(fixed.iter().map(|(wrench, _)| wrench.norm()));
        let longest_wrench = lengths.fold(1.0, f64::max);
        let scene = Self {
            longest_wrench,
            body,
            center: frame.center,
            radius: frame.radius,
            stiffness_unit: frame.stiffness,
            coarse: coarse(&extremes),
            extremes,
            patches,
            facets: Vec::new(),
            tips,
            fixed,
            most_on_patch,
        };
        round::check(&scene, fingers.roundness)?;
        Ok(scene)
    }

    /// A point in the frame of the part.
    pub(super) fn unscaled(&self, point: Vector<3>) -> Vector<3> {
        self.center + point * self.radius
    }

    /// A twist about the frame's origin, in the units of the part, from one in the scene's.
    pub(super) fn unscaled_twist(&self, twist: Vector<6>) -> Twist<3, 3> {
        let (linear, angular) = (first(twist) * self.radius, second(twist));
        // The velocity of the point that is at the frame's origin.
        Twist { linear: linear - cross(angular, self.center), angular }
    }
}

/// Where and how large a part is, and how stiff its contacts are.
#[derive(Clone, Copy, Debug)]
struct Scale {
    center: Vector<3>,
    radius: f64,
    stiffness: f64,
}

impl Scale {
    fn new(points: &[Vector<3>], faces: impl Iterator<Item = f64>, fixed: &[Touch]) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in points {
            for i in 0..3 {
                low[i] = low[i].min(point[i]);
                high[i] = high[i].max(point[i]);
            }
        }
        let center = Vector::from_fn(|i| 0.5 * (low[i] + high[i]));
        let radius = points.iter().map(|&x| (x - center).scaled_norm()).fold(0.0, f64::max);
        let all = faces.chain(fixed.iter().map(|touch| touch.stiffness));
        let exponent = all.fold(0.0, f64::max).log2() * 0.5;
        let stiffness = (2.0 * exponent.round()).exp2();
        Self { center, radius, stiffness }
    }

    fn scaled(&self, point: Vector<3>) -> Vector<3> {
        let offset = point - self.center;
        if self.radius > 0.0 { Vector::from_fn(|i| offset[i] / self.radius) } else { offset }
    }
}

/// Some of the extreme points, each time the one that is farthest from those before.
fn coarse(extremes: &ExtremePoints<3>) -> ExtremePoints<3> {
    let points = extremes.points();
    if points.len() <= COARSE {
        return extremes.clone();
    }
    let mut distances = vec![f64::INFINITY; points.len()];
    let mut next = 0;
    let mut chosen = Vec::with_capacity(COARSE);
    while chosen.len() < COARSE {
        chosen.push(points[next].to_array());
        for (distance, &x) in distances.iter_mut().zip(points) {
            *distance = distance.min((x - points[next]).norm_squared());
        }
        let farther = |i: usize, j: usize| if distances[j] > distances[i] { j } else { i };
        next = (0..points.len()).fold(0, farther);
    }
    ExtremePoints::new(&chosen).unwrap_or_else(|_| extremes.clone())
}

/// The corners of the convex hull of points in the plane across `normal`.
fn hull(points: &[Vector<3>], normal: Vector<3>) -> Vec<Vector<3>> {
    let [u, v] = across(normal);
    let flat: Vec<[f64; 2]> = points.iter().map(|p| [p.dot(u), p.dot(v)]).collect();
    // What has no hull is kept as it is.
    ExtremePoints::<2>::new(&flat).map_or_else(
        |_| points.to_vec(),
        |extremes| {
            let mut corners: Vec<_> = extremes.numbers().iter().map(|&n| points[n]).collect();
            let count = (corners.len() as f64).recip();
            let middle = corners.iter().fold(Vector::ZERO, |sum, &x| sum + x) * count;
            let angle = |x: Vector<3>| (x - middle).dot(v).atan2((x - middle).dot(u));
            corners.sort_by(|&a, &b| angle(a).total_cmp(&angle(b)));
            corners
        },
    )
}

/// Two unit vectors across `normal` and each other.
pub(super) fn across(normal: Vector<3>) -> [Vector<3>; 2] {
    let least = (0..3).fold(0, |i, j| if normal[j].abs() < normal[i].abs() { j } else { i });
    let axis = Vector::from_fn(|i| if i == least { 1.0 } else { 0.0 });
    let u = cross(normal, axis);
    let u = u * u.norm().recip();
    [u, cross(normal, u)]
}

/// The point of a triangle nearest to a point of its plane.
fn nearest_in_triangle(
    triangle: &[Vector<3>; 3],
    normal: Vector<3>,
    point: Vector<3>,
) -> Vector<3> {
    let turned = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]).dot(normal);
    let mut best = (f64::INFINITY, point);
    let mut inside = true;
    for i in 0..3 {
        let (a, b) = (triangle[i], triangle[(i + 1) % 3]);
        let (edge, offset) = (b - a, point - a);
        inside &= cross(edge, offset).dot(normal) * turned >= 0.0;
        let along = (offset.dot(edge) / edge.norm_squared()).clamp(0.0, 1.0);
        let foot = a + edge * along;
        let distance = (foot - point).norm_squared();
        if distance < best.0 {
            best = (distance, foot);
        }
    }
    if inside { point } else { best.1 }
}
