//! What the searches need to know of each edge, about the part's geometric center.

use clench_screw::planar::{cross, quarter_turn};
use clench_screw::{Vector, Wrench};
use clench_shape::Edge;

use super::Part;

/// A place along an edge within this many units of rounding of an end, times the sizes that it
/// was computed from, is that end.
const AT_END: f64 = 64.0 * f64::EPSILON;

/// An edge as a range of moments.
#[derive(Clone, Copy, Debug)]
pub(super) struct Support {
    /// The unit normal into the part.
    pub(super) normal: Vector<2>,
    /// `k`, in the scene's unit of stiffness.
    pub(super) stiffness: f64,
    /// `sqrt(k)`.
    pub(super) weight: f64,
    /// `a = sqrt(k) J n`: the scaled moment of the normal through `d` is `a . d`.
    pub(super) arm: Vector<2>,
    /// The least and the largest scaled moment `sqrt(k) gamma` of the normal on this edge.
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
    /// The square of its radius.
    pub(super) radius_squared: f64,
    /// The power of four (force / length) that stiffnesses are divided by, so that the largest is
    /// near 1: exact, and no product of stiffnesses over- or underflows.
    pub(super) stiffness_unit: f64,
    pub(super) supports: Vec<Support>,
    /// Where two corners are equally far.
    pub(super) borders: Vec<Border>,
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
}

impl<'a> Scene<'a> {
    pub(super) fn new(part: &'a Part) -> Self {
        let outline = part.outline();
        let circle = outline.enclosing_circle();
        let center = circle.center;
        let stiffness_unit = power_of_four(part.edge_stiffness());
        let edges = outline.edges().iter().zip(part.edge_stiffness());
        let borders = outline.partition().borders().iter().map(|b| Border {
            corner: outline.corners()[b.corners.0] - center,
            line: (b.middle - center, b.direction),
            stretch: (b.from, b.to),
        });
        Self {
            part,
            center,
            radius_squared: circle.radius * circle.radius,
            stiffness_unit,
            supports: edges
                .map(|(edge, &k)| Support::new(edge, k / stiffness_unit, center))
                .collect(),
            borders: borders.collect(),
        }
    }

    /// The farthest corner of the point `d`, relative to the center.
    pub(super) fn farthest(&self, d: Vector<2>) -> Vector<2> {
        let outline = self.part.outline();
        outline.corners()[outline.farthest(d + self.center).corner] - self.center
    }

    /// The first corner of `edge`.
    pub(super) fn start(&self, edge: usize) -> Vector<2> {
        self.part.outline().edges()[edge].start()
    }

    /// The point on `edge` whose normal has the scaled moment `s`.
    pub(super) fn point_of_moment(&self, edge: usize, s: f64) -> Vector<2> {
        let support = &self.supports[edge];
        let edge = &self.part.outline().edges()[edge];
        let start = support.weight * cross(edge.start() - self.center, support.normal);
        let span = support.high - support.low;
        let along = ((s - start) / span).abs();
        let near = AT_END * (support.low.abs().max(support.high.abs()) / span + 1.0);
        if along <= near {
            return edge.start();
        }
        if along >= 1.0 - near {
            return edge.end();
        }
        edge.start() + (edge.end() - edge.start()) * along
    }

    /// `sigma_min = 2 det / (sum k + |sum k exp(2 i phi)|)` of fingers on the given edges, with
    /// `det K_11 = sum over pairs of k_i k_j (n_i x n_j)^2`, so that nothing cancels.
    pub(super) fn sigma_min(&self, edges: &[usize]) -> f64 {
        let (mut sum, mut turn, mut determinant) = (0.0, Vector::ZERO, 0.0);
        for (i, &edge) in edges.iter().enumerate() {
            let one = &self.supports[edge];
            sum += one.stiffness;
            turn += one.double_angle;
            for &other in &edges[..i] {
                let other = &self.supports[other];
                let sine = cross(one.normal, other.normal);
                determinant += one.stiffness * other.stiffness * sine * sine;
            }
        }
        2.0 * determinant / (sum + turn.norm())
    }
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
    fn new(edge: &Edge, stiffness: f64, center: Vector<2>) -> Self {
        let normal = edge.inward_normal();
        let weight = stiffness.sqrt();
        let moment = |point: Vector<2>| {
            weight * Wrench::<2, 1>::of_force_at(normal, point - center).torque[0]
        };
        let (a, b) = (moment(edge.start()), moment(edge.end()));
        let [x, y] = normal.to_array();
        Self {
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
