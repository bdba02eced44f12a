//! The middle of a node, about which its bounds are derived.

use clench_screw::{Mat, SymmetricEigen, Vector};

use super::pieces::Range;
use super::{NO_TRANSLATION, ROUNDING, arm};

/// The middle of a node is made as stiff against translation as this part of its stiffnesses, where
/// it is softer: no more than a choice of test forms.
const SOFTEST: f64 = 0.01;

/// The pieces of a node, and the middle of the stiffnesses that fingers on them can have.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Middle<const K: usize> {
    pub(crate) ranges: [Range<3>; K],
    /// The sum of the normals' double-angle vectors, and of the stiffnesses: `2 H`, with
    /// `H = sum of arm arm^T`, has the eigenvalues `trace +- |turn|`.
    turn: Vector<2>,
    pub(crate) trace: f64,
    /// How far the turn, and the trace, can be from their middles.
    turn_spread: f64,
    trace_spread: f64,
    /// Added to `H` where it is nearly singular.
    shift: f64,
    /// The point about which twists and moments are taken: near the centers of compliance.
    pub(crate) about: Vector<2>,
}

impl<const K: usize> Middle<K> {
    pub(crate) fn new(ranges: [Range<3>; K], softest: f64) -> Self {
        let (mut turn, mut trace) = (Vector::ZERO, 0.0);
        let (mut turn_spread, mut trace_spread) = (0.0, 0.0);
        let mut first = Vector::ZERO;
        for w in &ranges {
            turn += w.turn;
            trace += w.stiffness;
            turn_spread += w.turn_radius;
            trace_spread += w.stiffness_spread;
            first += arm(w.center) * w.center[2];
        }
        let least = 0.5 * (trace - turn.norm());
        let shift = (softest.max(SOFTEST * trace) - least).max(0.0);
        let about = Vector::ZERO;
        let mut middle = Self { ranges, turn, trace, turn_spread, trace_spread, shift, about };
        middle.about = middle.solve(first);
        middle
    }

    /// How far `2 H` can be from its middle, in the spectral norm.
    pub(super) fn spread(&self) -> f64 {
        self.turn_spread + self.trace_spread
    }

    /// No placement has a larger `sigma_min`: that is half of `sum of k` minus the length of the
    /// sum of the double-angle vectors, and each of these is in its disc.
    pub(crate) fn largest_translation(&self) -> f64 {
        let sure = (self.turn.norm() - self.turn_spread).max(0.0);
        0.5 * (self.trace + self.trace_spread - sure) + ROUNDING * self.trace
    }

    /// A `sigma_min` of less is none, up to rounding, of all placements.
    pub(crate) fn no_translation(&self) -> f64 {
        NO_TRANSLATION * (self.trace - self.trace_spread)
    }

    /// No placement has a smaller `sigma_min`.
    pub(crate) fn least_translation(&self) -> f64 {
        0.5 * (self.trace - self.spread() - self.turn.norm())
    }

    /// `H v` in the middle.
    pub(crate) fn apply(&self, v: Vector<2>) -> Vector<2> {
        // The arms are a quarter turn from the normals, which turns the double angle by a half.
        let [c, s] = self.turn.to_array();
        Vector::new([(self.trace - c) * v[0] - s * v[1], (self.trace + c) * v[1] - s * v[0]]) * 0.5
    }

    /// `(H + shift)^-1 v` in the middle.
    pub(crate) fn solve(&self, v: Vector<2>) -> Vector<2> {
        let [c, s] = self.turn.to_array();
        let trace = self.trace + 2.0 * self.shift;
        let factor = 2.0 / (trace * trace - c * c - s * s);
        Vector::new([(trace + c) * v[0] + s * v[1], (trace - c) * v[1] + s * v[0]]) * factor
    }

    /// The direction of least translational stiffness, of arms.
    pub(crate) fn softest(&self) -> Vector<2> {
        let [c, s] = self.turn.to_array();
        let h = Mat::new([[self.trace - c, -s], [-s, self.trace + c]]);
        SymmetricEigen::new(&h).map_or(Vector::ZERO, |eigen| eigen.vectors[0])
    }
}
