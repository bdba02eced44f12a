//! Three fingers whose tips keep a distance: where their normals may meet.
//!
//! The tip on stretch `i` follows the meeting point `m` along the stretch's direction `d_i`, so the
//! way from one tip to another is `A m + b` with `A = d_i d_i^T - d_j d_j^T`. `A` is symmetric
//! without a trace, `A^2 = sin^2 I` with the angle between the stretches, so the tips are nearer
//! than `D` exactly for the meeting points within `D / |sin|` of one of them: in a disc. The reach
//! is convex, so where its least value is in a disc, the least one outside is on a circle.

use clench_screw::Vector;
use clench_screw::planar::{chord, cross, quarter_turn};

use super::closed_form::Convex;
use super::scene::{PARALLEL, Scene, Support};

/// Points may be outside a region by this many roundings of the lengths they are made of.
const OUTSIDE: f64 = 256.0 * f64::EPSILON;

/// Meeting points for which two tips are too near to each other, relative to the part's center.
#[derive(Clone, Copy, Debug)]
struct Crowd {
    center: Vector<2>,
    radius: f64,
    /// What points on its circle may be off by.
    rounding: f64,
}

/// The meeting points of fingers on three stretches, and what of them is crowded.
#[derive(Debug)]
pub(super) struct Apart<'a> {
    scene: &'a Scene<'a>,
    region: &'a Convex,
    crowds: Vec<Crowd>,
}

impl<'a> Apart<'a> {
    /// Fingers on `supports` with tips of this `radius`, whose centers are at least `least` apart,
    /// and whose normals meet in `region`; `None` if parallel ones are always too near.
    pub(super) fn new(
        scene: &'a Scene<'a>,
        region: &'a Convex,
        supports: [&Support; 3],
        (radius, least): (f64, f64),
    ) -> Option<Self> {
        let size = scene.radius + radius + least;
        let least = least - OUTSIDE * size;
        let mut crowds = Vec::new();
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let (one, other) = (supports[i], supports[j]);
            // The way between the tips when the normals meet in the geometric center.
            let tip = |s: &Support| {
                let start = s.ends[0] - scene.center;
                start - s.direction() * s.direction().dot(start) - s.normal * radius
            };
            let between = tip(one) - tip(other);
            let sine = cross(one.direction(), other.direction());
            if sine.abs() <= PARALLEL {
                if between.norm() < least {
                    return None;
                }
                continue;
            }
            let turned = one.direction() * one.direction().dot(between)
                - other.direction() * other.direction().dot(between);
            let center = -turned * (sine * sine).recip();
            let radius = least / sine.abs();
            let rounding = OUTSIDE * (size + radius + center.norm());
            crowds.push(Crowd { center, radius, rounding });
        }
        Some(Self { scene, region, crowds })
    }

    /// Whether two tips are too near when the normals meet in `point`.
    pub(super) fn is_crowded(&self, point: Vector<2>) -> bool {
        let point = point - self.scene.center;
        self.crowds.iter().any(|crowd| crowd.surrounds(point, crowd.rounding))
    }

    /// The point of least reach on the circles around what is crowded, and the square of its reach.
    pub(super) fn nearest(&self) -> Option<(Vector<2>, f64)> {
        let outline = self.scene.part.outline();
        let reach_squared = |point: Vector<2>| {
            (outline.corners()[outline.farthest(point).corner] - point).norm_squared()
        };
        let points = (0..self.crowds.len()).flat_map(|own| {
            self.candidates(own).into_iter().filter(move |&point| self.is_allowed(point, own))
        });
        let reaches = points.map(|point| {
            let point = point + self.scene.center;
            (point, reach_squared(point))
        });
        reaches.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Where the reach can be least on a circle: where that enters the region, or leaves another
    /// circle; where two corners are equally far; where the way to a corner is shortest.
    fn candidates(&self, own: usize) -> Vec<Vector<2>> {
        let (outline, crowd) = (self.scene.part.outline(), &self.crowds[own]);
        let from = self.scene.center;
        let sides = self.region.edges().filter_map(|(a, b)| Some((a - from, (b - a).direction()?)));
        let borders = outline.partition().borders().iter().map(|b| (b.middle - from, b.direction));
        // Two circles meet on a line.
        let others = self.crowds.iter().filter_map(|other| crowd.meets(other));
        let on_lines = sides.chain(borders).chain(others).flat_map(|line| crowd.crossings(line));
        let corners = outline.hull().iter().map(|&corner| outline.corners()[corner] - from);
        let nearest = corners.filter_map(|v| (v - crowd.center).direction());
        let toward = nearest.map(|way| crowd.center + way * crowd.radius);
        on_lines.chain(toward).collect()
    }

    /// Whether a point on the circle `own` is in the region, and in no other crowd.
    fn is_allowed(&self, point: Vector<2>, own: usize) -> bool {
        let rounding = self.crowds[own].rounding;
        let inside = |(a, b): (Vector<2>, Vector<2>)| {
            let side = b - a;
            cross(side, point - (a - self.scene.center)) >= -rounding * side.norm()
        };
        let others = self.crowds.iter().enumerate().filter(|(place, _)| *place != own);
        let mut others = others.map(|(_, other)| (other, rounding.max(other.rounding)));
        self.region.edges().all(inside)
            && !others.any(|(other, rounding)| other.surrounds(point, rounding))
    }
}

impl Crowd {
    /// Whether `point` is in it by more than `rounding`.
    fn surrounds(&self, point: Vector<2>, rounding: f64) -> bool {
        (point - self.center).norm() < self.radius - rounding
    }

    /// Where the circle crosses a line through a point with a unit direction.
    fn crossings(
        &self,
        (point, direction): (Vector<2>, Vector<2>),
    ) -> impl Iterator<Item = Vector<2>> {
        let ends = chord(self.center - point, direction, self.radius);
        ends.into_iter().flatten().map(move |along| point + direction * along)
    }

    /// The line through the points that both circles have in common.
    fn meets(&self, other: &Self) -> Option<(Vector<2>, Vector<2>)> {
        let way = other.center - self.center;
        let apart = way.norm();
        let along = way.direction()?;
        let radii = (self.radius - other.radius) * (self.radius + other.radius);
        let foot = 0.5 * (apart + radii / apart);
        Some((self.center + along * foot, quarter_turn(along)))
    }
}
