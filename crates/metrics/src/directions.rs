//! The largest value of a norm over all directions.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use clench_screw::Vector;

/// Where a norm counts as bounded: its bound exceeds the largest value found by this part of it,
/// a few roundings.
const PROVED: f64 = 16.0 * f64::EPSILON;

/// The search ends after this many directions: in general fewer prove the result, but where many
/// directions tie, as on a ball, no number would.
const MAX_DIRECTIONS: usize = 4_096;

/// Steps of the ascent from one direction, each with all its doublings.
const MAX_STEPS: usize = 64;

/// The largest value of a norm over the unit sphere.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Largest<const N: usize> {
    pub(crate) direction: Vector<N>,
    pub(crate) value: f64,
    /// What no value exceeds.
    pub(crate) bound: f64,
}

/// The directions between `N` unit vectors.
#[derive(Clone, Copy, Debug)]
struct Simplex<const N: usize> {
    corners: [Vector<N>; N],
    /// The norm at the corners.
    values: [f64; N],
    bound: f64,
}

/// The largest value of `norm` over the unit vectors of the plane or of space.
///
/// `norm(u)` is the value at `u`, and a direction at which it is not smaller, where an ascent goes
/// on; `starts` are directions to begin with. A norm is convex: within a flat simplex it is at most
/// as large as at the corners, and the directions through the simplex are longer than its points by
/// at most the inverse of its distance from the origin. So each simplex has a bound that is off by
/// the square of its size; the one with the largest is halved until none exceeds what was found.
pub(crate) fn largest_norm<const N: usize>(
    norm: impl Fn(Vector<N>) -> (f64, Vector<N>),
    starts: impl IntoIterator<Item = Vector<N>>,
) -> Largest<N> {
    let mut best = Largest { direction: Vector::ZERO, value: -1.0, bound: 0.0 };
    for start in starts {
        raised(&norm, start, &mut best);
    }
    let mut heap = BinaryHeap::new();
    // One of each pair of opposite orthants.
    for signs in 0..1 << (N - 1) {
        let corner = |k: usize| {
            let size = if k > 0 && signs >> (k - 1) & 1 == 1 { -1.0 } else { 1.0 };
            Vector::from_fn(|i| if i == k { size } else { 0.0 })
        };
        let corners: [Vector<N>; N] = std::array::from_fn(corner);
        let values = corners.map(|u| raised(&norm, u, &mut best));
        heap.push(Simplex::new(corners, values));
    }
    for _ in 0..MAX_DIRECTIONS {
        let Some(top) = heap.pop() else { break };
        best.bound = top.bound;
        if top.bound <= best.value * (1.0 + PROVED) {
            // Proved, to rounding.
            best.bound = best.value;
            break;
        }
        let (one, other) = top.longest_edge();
        let between = top.corners[one] + top.corners[other];
        let middle = between * between.norm().recip();
        let value = raised(&norm, middle, &mut best);
        for replaced in [one, other] {
            let Simplex { mut corners, mut values, .. } = top;
            (corners[replaced], values[replaced]) = (middle, value);
            let half = Simplex::new(corners, values);
            heap.push(Simplex { bound: half.bound.min(top.bound), ..half });
        }
    }
    best.bound = best.bound.max(best.value);
    best
}

/// The norm at `start`; where it is the best so far, so is what an ascent from there comes to.
///
/// Where directions nearly tie, the steps of the ascent are small parts of the way: each is doubled
/// while that raises the norm.
fn raised<const N: usize>(
    norm: impl Fn(Vector<N>) -> (f64, Vector<N>),
    start: Vector<N>,
    best: &mut Largest<N>,
) -> f64 {
    let (value, mut next) = norm(start);
    if value <= best.value || value.is_nan() {
        return value;
    }
    (best.value, best.direction) = (value, start);
    for _ in 0..MAX_STEPS {
        let from = best.direction;
        // The direction and its opposite are the same.
        let next_to = if from.dot(next) < 0.0 { -next } else { next };
        let mut step = next_to - from;
        let mut raised = false;
        while let Some(to) = (from + step).direction() {
            let (higher, after) = norm(to);
            if higher <= best.value || higher.is_nan() {
                break;
            }
            (best.value, best.direction, next, raised) = (higher, to, after, true);
            step = step * 2.0;
        }
        if !raised {
            break;
        }
    }
    value
}

impl<const N: usize> Simplex<N> {
    /// A point of it with weights `t` has the squared length
    /// `1 - sum over pairs of t_i t_j |u_i - u_j|^2`, and the sum of the products of two different
    /// weights is at most `(1 - 1/N) / 2`.
    fn new(corners: [Vector<N>; N], values: [f64; N]) -> Self {
        let mut simplex = Self { corners, values, bound: 0.0 };
        let (one, other) = simplex.longest_edge();
        let longest = (corners[one] - corners[other]).norm_squared();
        let least = 1.0 - longest * 0.5 * (1.0 - 1.0 / N as f64);
        simplex.bound = values.into_iter().fold(0.0, f64::max) / least.sqrt();
        simplex
    }

    fn longest_edge(&self) -> (usize, usize) {
        let mut longest = (0, N - 1, -1.0);
        for i in 0..N {
            for j in i + 1..N {
                let length = (self.corners[i] - self.corners[j]).norm_squared();
                if length > longest.2 {
                    longest = (i, j, length);
                }
            }
        }
        (longest.0, longest.1)
    }
}

/// By the bound.
impl<const N: usize> Ord for Simplex<N> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

impl<const N: usize> PartialOrd for Simplex<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const N: usize> PartialEq for Simplex<N> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<const N: usize> Eq for Simplex<N> {}
