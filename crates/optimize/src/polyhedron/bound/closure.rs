//! When no contacts on some pieces of the surface can balance by pushing alone.

use clench_screw::Vector;
use clench_screw::spatial::cross;

use super::ROUNDING;
use super::pieces::Corners;
use crate::polyhedron::PUSHING;

/// Steps in which a twist that all forces help is looked for.
const STEPS: usize = 32;

/// Wrenches that are nearer to the origin than a point by no more than this part are as near.
const NEARER: f64 = 1e-9;

/// Normals within this of a half-space's border count as on it: the rounding of unit vectors.
const BORDER: f64 = 4.0 * f64::EPSILON;

/// A normal that is inside the half-space by more than this part cannot push: what the others,
/// outside by the rounding of a border, allow it is less than what counts as pushing.
const INSIDE: f64 = 0.01 * PUSHING;

/// Whether unit normals can balance with all of them pushing.
///
/// They cannot if all are in a half-space and one is not on its border. If there is such a
/// half-space, the plane through two of the normals borders one.
pub(crate) fn normals_balance(normals: &[Vector<3>]) -> bool {
    for (i, &a) in normals.iter().enumerate() {
        for &b in &normals[..i] {
            let Some(across) = cross(a, b).direction() else { continue };
            // Nearly parallel normals have a border that rounding turns.
            let border = BORDER / cross(a, b).norm();
            let (mut low, mut high) = (0.0_f64, 0.0_f64);
            for &n in normals {
                low = low.min(across.dot(n));
                high = high.max(across.dot(n));
            }
            let beyond = |this: f64, other: f64| this <= border && other > INSIDE + border / INSIDE;
            if beyond(-low, high) || beyond(high, -low) {
                return false;
            }
        }
    }
    true
}

/// Contacts that have to balance: pieces of the surface, and fixed unit wrenches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contacts<'a> {
    pub(crate) fingers: &'a [Corners<'a>],
    /// What the wrenches of each finger are divided by to be unit wrenches.
    pub(crate) weights: &'a [f64],
    pub(crate) fixed: &'a [(Vector<6>, f64)],
    /// The least share of each.
    pub(crate) least_share: f64,
    /// The length of the longest unit wrench.
    pub(crate) longest: f64,
}

impl Contacts<'_> {
    fn count(&self) -> f64 {
        (self.fingers.len() + self.fixed.len()) as f64
    }

    /// The least power on `twist` of a preload of 1 with these shares, less the rounding.
    fn least_power(&self, twist: Vector<6>) -> f64 {
        let placed = self.fingers.iter().zip(self.weights);
        let placed = placed.map(|(corners, weight)| corners.least_linear(twist) / weight);
        let fixed = self.fixed.iter().map(|(wrench, _)| wrench.dot(twist));
        let (mut sum, mut least) = (0.0, f64::INFINITY);
        for power in placed.chain(fixed) {
            sum += power;
            least = least.min(power);
        }
        let shared = self.least_share;
        let power = shared * sum + (1.0 - self.count() * shared) * least;
        power - ROUNDING * 2.0 * self.longest * twist.norm()
    }

    /// The wrench of a preload of 1 with the least power on `twist`, of those at corners.
    fn least_wrench(&self, twist: Vector<6>) -> Vector<6> {
        let (mut sum, mut least) = (Vector::ZERO, (f64::INFINITY, Vector::ZERO));
        let mut consider = |wrench: Vector<6>| {
            let power = wrench.dot(twist);
            if power < least.0 {
                least = (power, wrench);
            }
            sum += wrench;
        };
        for (corners, weight) in self.fingers.iter().zip(self.weights) {
            let by_power = |p: &&Vector<6>, q: &&Vector<6>| p.dot(twist).total_cmp(&q.dot(twist));
            if let Some(&wrench) = corners.all().iter().min_by(by_power) {
                consider(wrench * weight.recip());
            }
        }
        self.fixed.iter().for_each(|&(wrench, _)| consider(wrench));
        sum * self.least_share + least.1 * (1.0 - self.count() * self.least_share)
    }
}

/// A twist that all forces of the contacts help, if one is found: then they cannot balance.
///
/// It is the point nearest to the origin of the hull of their wrenches, by Wolfe's algorithm: again
/// and again the wrench that opposes it most joins a few that span it, and those that are not
/// needed leave. P. Wolfe, Finding the nearest point in a polytope, Mathematical Programming 11
/// (1976).
pub(crate) fn helped_twist(contacts: &Contacts<'_>, steps: usize) -> Option<Vector<6>> {
    let mut span = Span::new(contacts.least_wrench(Vector::ZERO));
    for _ in 0..steps {
        let twist = span.nearest();
        if contacts.least_power(twist) > 0.0 {
            return Some(twist);
        }
        let wrench = contacts.least_wrench(twist);
        let square = twist.norm_squared();
        if wrench.dot(twist) > (1.0 - NEARER) * square || !span.join(wrench) {
            return None;
        }
    }
    None
}

/// Up to seven points that span the part of their hull nearest to the origin.
#[derive(Clone, Debug)]
struct Span {
    points: [Vector<6>; 7],
    /// Of the nearest point so far; they sum to 1.
    weights: [f64; 7],
    count: usize,
}

impl Span {
    fn new(point: Vector<6>) -> Self {
        let mut weights = [0.0; 7];
        weights[0] = 1.0;
        Self { points: [point; 7], weights, count: 1 }
    }

    fn nearest(&self) -> Vector<6> {
        let pairs = self.points.iter().zip(self.weights).take(self.count);
        pairs.fold(Vector::ZERO, |sum, (&point, weight)| sum + point * weight)
    }

    /// Takes a point in, and leaves those behind that the nearest point does not need then; `false`
    /// where the points are in one plane to rounding.
    fn join(&mut self, point: Vector<6>) -> bool {
        if self.count == 7 {
            return false;
        }
        self.points[self.count] = point;
        self.weights[self.count] = 0.0;
        self.count += 1;
        while let Some(target) = self.affine_weights() {
            let n = self.count;
            let part = (0..n)
                .filter(|&i| target[i] <= 0.0)
                .map(|i| self.weights[i] / (self.weights[i] - target[i]))
                .fold(1.0, f64::min);
            for i in 0..n {
                self.weights[i] += part * (target[i] - self.weights[i]);
            }
            if part >= 1.0 {
                return true;
            }
            let least =
                (1..n).fold(0, |i, j| if self.weights[j] < self.weights[i] { j } else { i });
            self.count -= 1;
            self.points.swap(least, self.count);
            self.weights.swap(least, self.count);
        }
        false
    }

    /// The weights, of any sign, of the point nearest to the origin in the plane of the points.
    fn affine_weights(&self) -> Option<[f64; 7]> {
        let n = self.count;
        let mut rows = [[0.0; 8]; 7];
        for i in 0..n {
            for j in 0..n {
                rows[i][j] = self.points[i].dot(self.points[j]) + 1.0;
            }
            rows[i][7] = 1.0;
        }
        // Positive definite where the points are affinely independent.
        for p in 0..n {
            let pivot = rows[p][p];
            if pivot <= ROUNDING {
                return None;
            }
            let row = rows[p];
            for below in rows.iter_mut().take(n).skip(p + 1) {
                let factor = below[p] / pivot;
                for j in p..8 {
                    below[j] -= factor * row[j];
                }
            }
        }
        let mut weights = [0.0; 7];
        for p in (0..n).rev() {
            let known: f64 = (p + 1..n).map(|j| rows[p][j] * weights[j]).sum();
            weights[p] = (rows[p][7] - known) / rows[p][p];
        }
        let sum: f64 = weights.iter().sum();
        Some(weights.map(|weight| weight / sum))
    }
}

/// Whether some twist is helped by all forces of the contacts.
pub(crate) fn helps_all(contacts: &Contacts<'_>) -> bool {
    helped_twist(contacts, STEPS).is_some()
}
