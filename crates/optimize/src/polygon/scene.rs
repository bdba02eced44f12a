//! What the searches need to know of each edge, about the part's geometric center.

use std::f64::consts::{PI, TAU};

use clench_screw::planar::{cross, quarter_turn};
use clench_screw::{Cholesky, Mat, Vector, Wrench};
use clench_shape::Edge;

use super::bound::Pieces;
use super::closed_form::Convex;
use super::{Part, Stretch};
use crate::OptimizeError;

/// A place along an edge within this many units of rounding of an end, times the sizes that it
/// was computed from, is that end.
const AT_END: f64 = 64.0 * f64::EPSILON;

/// Two directions within this angle are parallel (radian).
pub(super) const PARALLEL: f64 = 8.0 * f64::EPSILON;

/// A stretch of an edge as a range of moments.
#[derive(Clone, Copy, Debug)]
pub(super) struct Support {
    pub(super) edge: usize,
    /// Its two ends.
    pub(super) ends: [Vector<2>; 2],
    direction: Vector<2>,
    /// The unit normal into the part.
    pub(super) normal: Vector<2>,
    /// `k`, in the scene's unit of stiffness.
    pub(super) stiffness: f64,
    /// `sqrt(k)`.
    pub(super) weight: f64,
    /// `a = sqrt(k) J n`: the scaled moment of the normal through `d` is `a . d`.
    pub(super) arm: Vector<2>,
    /// The least and the largest scaled moment `sqrt(k) gamma` of the normal on this stretch.
    pub(super) low: f64,
    pub(super) high: f64,
    /// `k (cos 2 phi, sin 2 phi)` for the normal's direction `phi`.
    pub(super) double_angle: Vector<2>,
}

/// A part seen from its geometric center.
#[derive(Clone, Debug)]
pub(super) struct Scene<'a> {
    pub(super) part: &'a Part,
    /// The geometric center: the center of the smallest enclosing circle.
    pub(super) center: Vector<2>,
    /// Its radius, and the square of that.
    pub(super) radius: f64,
    pub(super) radius_squared: f64,
    /// The power of four (force / length) that stiffnesses are divided by, so that the largest is
    /// near 1: exact, and no product of stiffnesses over- or underflows.
    pub(super) stiffness_unit: f64,
    pub(super) supports: Vec<Support>,
    /// Where two corners are equally far.
    borders: Vec<Border>,
    /// For each corner that can be the farthest, its place among the regions of the partition.
    region_of: Vec<usize>,
}

/// A border between two regions of the farthest-corner partition, relative to the center.
#[derive(Clone, Copy, Debug)]
pub(super) struct Border {
    /// One of its two corners.
    pub(super) corner: Vector<2>,
    /// A point and the unit direction of its line.
    pub(super) line: (Vector<2>, Vector<2>),
    /// The stretch of the line that it is.
    pub(super) stretch: (f64, f64),
    /// The places of its two regions in the partition.
    regions: (usize, usize),
}

impl<'a> Scene<'a> {
    fn new(part: &'a Part) -> Self {
        let outline = part.outline();
        let circle = outline.enclosing_circle();
        let center = circle.center;
        let stiffness_unit = power_of_four(part.edge_stiffness());
        let mut region_of = vec![0; outline.corners().len()];
        for (place, region) in outline.partition().regions().iter().enumerate() {
            region_of[region.corner] = place;
        }
        let borders = outline.partition().borders().iter().map(|b| Border {
            corner: outline.corners()[b.corners.0] - center,
            line: (b.middle - center, b.direction),
            stretch: (b.from, b.to),
            regions: (region_of[b.corners.0], region_of[b.corners.1]),
        });
        Self {
            part,
            center,
            radius: circle.radius,
            radius_squared: circle.radius * circle.radius,
            stiffness_unit,
            supports: part
                .stretches()
                .iter()
                .map(|stretch| {
                    let k = part.edge_stiffness()[stretch.edge] / stiffness_unit;
                    Support::new(stretch, &outline.edges()[stretch.edge], k, center)
                })
                .collect(),
            borders: borders.collect(),
            region_of,
        }
    }

    /// The scene of a part that can be touched somewhere.
    ///
    /// # Errors
    ///
    /// [`OptimizeError::NowhereToTouch`].
    pub(super) fn checked(part: &'a Part) -> Result<Self, OptimizeError> {
        if part.stretches().is_empty() {
            return Err(OptimizeError::NowhereToTouch);
        }
        Ok(Self::new(part))
    }

    /// The sets of stretches, ascending, with one on each of these edges.
    pub(super) fn stretches_of<const K: usize>(&self, edges: [usize; K]) -> Vec<[usize; K]> {
        let mut sets = vec![[0; K]];
        for (i, edge) in edges.into_iter().enumerate() {
            let on_edge = || (0..self.supports.len()).filter(|&s| self.supports[s].edge == edge);
            sets = sets
                .into_iter()
                .flat_map(|set| {
                    on_edge().map(move |stretch| {
                        let mut set = set;
                        set[i] = stretch;
                        set
                    })
                })
                .collect();
        }
        for set in &mut sets {
            set.sort_unstable();
        }
        sets
    }

    /// The pieces of the boundary, as scaled wrenches.
    pub(super) fn wrenches(&self) -> Pieces<3> {
        Pieces::new(&self.supports, Vector::new([1.0, 1.0, self.radius]), Support::wrench)
    }

    /// The farthest corner of the point `d`, relative to the center.
    pub(super) fn farthest(&self, d: Vector<2>) -> Vector<2> {
        let outline = self.part.outline();
        outline.corners()[outline.farthest(d + self.center).corner] - self.center
    }

    /// The center of compliance of fingers with these scaled moments, relative to the center:
    /// where `sum (s_i - a_i . d)^2` is least.
    pub(super) fn center_of_compliance(&self, stretches: &[usize], moments: &[f64]) -> Vector<2> {
        let (mut gram, mut first) = (Mat::<2, 2>::ZERO, Vector::ZERO);
        for (&stretch, &moment) in stretches.iter().zip(moments) {
            let arm = self.supports[stretch].arm;
            gram += Mat::outer(arm, arm);
            first += arm * moment;
        }
        // What was found holds the part, up to rounding.
        Cholesky::new(&gram).map_or(Vector::ZERO, |gram| gram.solve(first))
    }

    /// The largest sine of the angle between the first normal and another one.
    pub(super) fn largest_sine(&self) -> f64 {
        let normals = self.supports.iter().map(|s| s.normal);
        let first = self.supports[0].normal;
        normals.map(|normal| cross(first, normal).abs()).fold(0.0, f64::max)
    }

    /// Whether normals of `fingers` stretches can positively span the plane.
    ///
    /// They surround the origin when no gap between neighbors in angle is half a turn. Then three
    /// of them span the plane, unless there are only two opposite pairs.
    pub(super) fn normals_balance(&self, fingers: usize) -> bool {
        let mut angles: Vec<f64> =
            self.supports.iter().map(|s| s.normal[1].atan2(s.normal[0])).collect();
        angles.sort_by(f64::total_cmp);
        let apart = |a: f64, b: f64| b - a > PARALLEL;
        angles.dedup_by(|b, a| !apart(*a, *b));
        let Some(&first) = angles.first() else { return false };
        let next = angles.iter().skip(1).copied().chain([first + TAU]);
        let surround = angles.iter().zip(next).all(|(a, b)| b - a < PI - PARALLEL);
        let opposite = |i: usize| (angles[i + 2] - angles[i] - PI).abs() <= PARALLEL;
        let pairs = angles.len() == 4 && opposite(0) && opposite(1);
        surround && (fingers > 3 || !pairs)
    }

    /// The corner at which a force of the worst direction gives most, relative to the center, with
    /// the inverse of `sum of arm arm^T`, the center of compliance and the rotational stiffness.
    ///
    /// Compliances there are turned by a quarter turn, like arms: in that frame the lever of a
    /// corner is the way to it.
    pub(super) fn worst_corner(&self, arms: &Mat<2, 2>, about: Vector<2>, mu: f64) -> Vector<2> {
        let per_mu = mu.recip();
        let compliance = |corner: Vector<2>, _: f64| {
            let lever = corner - self.center - about;
            largest_value(&(*arms + Mat::outer(lever, lever) * per_mu))
        };
        let points = self.part.outline().extreme_points();
        points.farthest_by(per_mu.sqrt(), compliance).point - self.center
    }

    /// Hands over each border that crosses `area`, with the stretch of its line inside.
    ///
    /// Goes from region to region, from those of the area's vertices on: an area is small, and
    /// there are as many borders as corners.
    pub(super) fn borders_across(&self, area: &Convex, mut visit: impl FnMut(&Border, (f64, f64))) {
        let outline = self.part.outline();
        let regions = outline.partition().regions();
        let place = |d: &Vector<2>| self.region_of[outline.farthest(*d + self.center).corner];
        let mut open: Vec<usize> = area.vertices().iter().map(place).collect();
        open.sort_unstable();
        open.dedup();
        // The regions of equal farthest corner are convex: then the area meets no border.
        if open.len() < 2 {
            return;
        }
        let mut seen = vec![false; regions.len()];
        for &region in &open {
            seen[region] = true;
        }
        while let Some(region) = open.pop() {
            for &number in &regions[region].borders {
                let border = &self.borders[number];
                let Some(inside) = area.clip(border.line, border.stretch) else { continue };
                let (one, other) = border.regions;
                // Each border is met from its two regions.
                if region == one {
                    visit(border, inside);
                }
                let beyond = if region == one { other } else { one };
                if !std::mem::replace(&mut seen[beyond], true) {
                    open.push(beyond);
                }
            }
        }
    }

    /// `sigma_min = 2 det / (sum k + |sum k exp(2 i phi)|)` of fingers on the given stretches, with
    /// `det K_11 = sum over pairs of k_i k_j (n_i x n_j)^2`, so that nothing cancels.
    pub(super) fn sigma_min(&self, stretches: &[usize]) -> f64 {
        let (mut sum, mut turn, mut determinant) = (0.0, Vector::ZERO, 0.0);
        for (i, &stretch) in stretches.iter().enumerate() {
            let one = &self.supports[stretch];
            sum += one.stiffness;
            turn += one.double_angle;
            for &other in &stretches[..i] {
                let other = &self.supports[other];
                let sine = cross(one.normal, other.normal);
                determinant += one.stiffness * other.stiffness * sine * sine;
            }
        }
        2.0 * determinant / (sum + turn.norm())
    }
}

/// The larger eigenvalue of a symmetric matrix.
pub(super) fn largest_value(a: &Mat<2, 2>) -> f64 {
    let [[xx, xy], [_, yy]] = *a.rows();
    0.5 * (xx + yy + ((xx - yy) * (xx - yy) + 4.0 * xy * xy).sqrt())
}

/// Powers of four up to this one, and their inverses, are within the range of a double.
const LARGEST_EXPONENT: i32 = 500;

/// The largest power of four that is not above the largest stiffness, or one of its neighbors.
fn power_of_four(stiffness: &[f64]) -> f64 {
    let largest = stiffness.iter().copied().fold(0.0, f64::max);
    #[expect(clippy::cast_possible_truncation, reason = "an exponent of a double is small")]
    let exponent = (0.5 * largest.log2()).floor() as i32;
    4.0_f64.powi(exponent.clamp(-LARGEST_EXPONENT, LARGEST_EXPONENT))
}

impl Support {
    /// The scaled wrench of a finger with the scaled moment `s`.
    pub(super) fn wrench(&self, s: f64) -> Vector<3> {
        Vector::new([self.arm[0], self.arm[1], s])
    }

    /// The same with stiffness 1.
    pub(super) fn of_unit_stiffness(&self) -> Self {
        let (unit, per_stiffness) = (self.weight.recip(), self.stiffness.recip());
        Self {
            stiffness: 1.0,
            weight: 1.0,
            arm: self.arm * unit,
            low: self.low * unit,
            high: self.high * unit,
            double_angle: self.double_angle * per_stiffness,
            ..*self
        }
    }

    /// The scaled moment of the place `along` the stretch, 0 at the end of least moment and 1 at
    /// the other; of the ends exactly.
    pub(super) fn moment(&self, along: f64) -> f64 {
        self.low * (1.0 - along) + self.high * along
    }

    /// The part of it with scaled moments between `low` and `high`.
    pub(super) fn narrowed(&self, [low, high]: [f64; 2], center: Vector<2>) -> Self {
        let ends = [low, high].map(|s| self.point(s, center));
        // The first end of a stretch has the least moment, or the largest.
        let first_is_low = self.point(self.low, center) == self.ends[0];
        let ends = if first_is_low { ends } else { [ends[1], ends[0]] };
        Self { ends, low, high, ..*self }
    }

    /// Whether it is the same part of the same edge.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        self.edge == other.edge && self.ends == other.ends
    }

    /// The unit vector from its first end to the other.
    pub(super) fn direction(&self) -> Vector<2> {
        self.direction
    }

    pub(super) fn length(&self) -> f64 {
        (self.ends[1] - self.ends[0]).norm()
    }

    /// Whether the normal through `point` starts on the stretch.
    pub(super) fn faces(&self, point: Vector<2>) -> bool {
        (0.0..=self.length()).contains(&self.direction.dot(point - self.ends[0]))
    }

    /// The point of the stretch nearest to `point`.
    pub(super) fn foot(&self, point: Vector<2>) -> Vector<2> {
        let along = self.direction.dot(point - self.ends[0]);
        let rest = self.length() - along;
        if along <= 0.0 {
            self.ends[0]
        } else if rest <= 0.0 {
            self.ends[1]
        } else if along < rest {
            self.ends[0] + self.direction * along
        } else {
            self.ends[1] - self.direction * rest
        }
    }

    /// The point whose normal has the scaled moment `s`.
    pub(super) fn point(&self, s: f64, center: Vector<2>) -> Vector<2> {
        let [start, end] = self.ends;
        let span = self.high - self.low;
        let along = ((s - self.weight * cross(start - center, self.normal)) / span).abs();
        let near = AT_END * (self.low.abs().max(self.high.abs()) / span + 1.0);
        if along <= near {
            start
        } else if along >= 1.0 - near {
            end
        } else {
            start + (end - start) * along
        }
    }

    fn new(stretch: &Stretch, edge: &Edge, stiffness: f64, center: Vector<2>) -> Self {
        let normal = edge.inward_normal();
        let weight = stiffness.sqrt();
        let moment = |point: Vector<2>| {
            weight * Wrench::<2, 1>::of_force_at(normal, point - center).torque[0]
        };
        let ends = [edge.point_at(stretch.from), edge.point_at(stretch.to)];
        let [a, b] = ends.map(moment);
        let [x, y] = normal.to_array();
        Self {
            edge: stretch.edge,
            ends,
            direction: edge.direction(),
            normal,
            stiffness,
            weight,
            // J n is the quarter turn the other way.
            arm: -quarter_turn(normal) * weight,
            low: a.min(b),
            high: a.max(b),
            double_angle: Vector::new([x * x - y * y, 2.0 * x * y]) * stiffness,
        }
    }
}
