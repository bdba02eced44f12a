//! What a placement of spring fingers is worth.

use clench_screw::spatial::cross;
use clench_screw::{Mat, Vector};

use super::Fingers;
use super::bound::NO_TRANSLATION;
use super::scene::{Scene, largest_value};
use super::tips::Keeping;
use crate::Objective;

/// Distances may fall short by this many units of rounding of the moments.
pub(super) const DISTANCE_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A finger pushes if its share of the preload is at least this: far above the rounding of
/// directions of edges, which are short beside their distance from the origin.
pub(super) const PUSHING: f64 = 1e-9;

/// Determinants of three wrenches are rounded by this many units of their sizes.
const DETERMINANT: f64 = 64.0 * f64::EPSILON;

/// A place on a stretch: 0 at the end of least moment, 1 at the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    pub(super) stretch: usize,
    pub(super) along: f64,
}

/// What a placement is worth, in the scene's unit of stiffness.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rating {
    pub(super) sigma_min: f64,
    pub(super) equivalent: f64,
    /// `Q_pt` where it is the objective, else no less than it.
    pub(super) worst_point: f64,
}

/// The scaled moments at these spots.
pub(super) fn moments<const K: usize>(scene: &Scene, spots: &[Spot; K]) -> [f64; K] {
    spots.map(|spot| scene.supports[spot.stretch].moment(spot.along))
}

/// The rating of fingers on `stretches` with these scaled moments; `None` where they do not
/// balance with all shares above the least one, or are too near to each other, or where
/// `sigma_min` and `mu_eq` already say that it is not `wanted`.
pub(super) fn rate<const K: usize>(
    scene: &Scene,
    fingers: &Fingers,
    stretches: &[usize; K],
    moments: &[f64; K],
    wanted: impl Fn(&Rating) -> bool,
) -> Option<Rating> {
    let supports = stretches.map(|s| &scene.supports[s]);
    let (mut xx, mut xy, mut yy, mut first) = (0.0, 0.0, 0.0, Vector::<2>::ZERO);
    for (support, &moment) in supports.iter().zip(moments) {
        let [x, y] = support.arm.to_array();
        xx += x * x;
        xy += x * y;
        yy += y * y;
        first += support.arm * moment;
    }
    let sigma_min = scene.sigma_min(stretches);
    let sum = xx + yy;
    if sigma_min <= NO_TRANSLATION * sum {
        return None;
    }
    // The product of both eigenvalues, so that nothing cancels.
    let determinant = sigma_min * (sum - sigma_min);
    let per_determinant = determinant.recip();
    let d = Vector::new([yy * first[0] - xy * first[1], xx * first[1] - xy * first[0]])
        * per_determinant;
    let about: [f64; K] = std::array::from_fn(|i| moments[i] - supports[i].arm.dot(d));
    let mu: f64 = about.iter().map(|m| m * m).sum();
    let equivalent = mu / (d - scene.farthest(d)).norm_squared();
    let mut rating = Rating { sigma_min, equivalent, worst_point: sigma_min.min(equivalent) };
    if !wanted(&rating) {
        return None;
    }
    let wrenches: [Vector<3>; K] = std::array::from_fn(|i| {
        let [x, y] = supports[i].arm.to_array();
        Vector::new([x, y, about[i] / scene.radius]) * supports[i].weight.recip()
    });
    let shares = shares(&wrenches)?;
    if shares.least - shares.rounding < PUSHING || shares.least < fingers.least_share {
        return None;
    }
    let keeping = Keeping::asked(scene, fingers);
    if keeping.is_some_and(|keeping| keeping.is_crowded(stretches, moments)) {
        return None;
    }
    if fingers.objective == Objective::WorstPoint {
        let compliance = Mat::new([[yy, -xy], [-xy, xx]]) * per_determinant;
        let lever = scene.worst_corner(&compliance, d, mu) - d;
        let largest = largest_value(&(compliance + Mat::outer(lever, lever) * mu.recip()));
        rating.worst_point = largest.recip();
    }
    Some(rating)
}

/// A balanced preload.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shares<const K: usize> {
    /// They sum to 1.
    pub(super) all: [f64; K],
    pub(super) least: f64,
    /// How well they are known.
    rounding: f64,
}

/// The shares of the preload with which these wrenches balance, with the largest least share where
/// there is a choice; `None` where the wrenches do not span their space.
///
/// That is a linear program, and at a corner of what it allows all but three fingers have the least
/// share: so all triplets are tried, with the least share from the determinants of the three and
/// of the sum of all wrenches.
pub(super) fn shares<const K: usize>(wrenches: &[Vector<3>; K]) -> Option<Shares<K>> {
    let sum = wrenches.iter().fold(Vector::ZERO, |sum, &w| sum + w);
    let sizes = wrenches.map(Vector::norm);
    let size: f64 = sizes.iter().sum();
    let mut best: Option<Shares<K>> = None;
    for k in 0..K {
        for j in 0..k {
            for i in 0..j {
                let [p, q, r] = [wrenches[i], wrenches[j], wrenches[k]];
                let [a, b, c] = [sizes[i], sizes[j], sizes[k]];
                let mut all = [-p.dot(cross(q, r)); K];
                all[i] += q.dot(cross(r, sum));
                all[j] -= p.dot(cross(r, sum));
                all[k] += p.dot(cross(q, sum));
                let total: f64 = all.iter().sum();
                if total == 0.0 {
                    continue;
                }
                let all = all.map(|share| share / total);
                let least = all.iter().copied().fold(f64::INFINITY, f64::min);
                let size = size * (a * b + b * c + c * a) + a * b * c;
                let rounding = DETERMINANT * size / total.abs();
                if best.is_none_or(|best| least - rounding > best.least - best.rounding) {
                    best = Some(Shares { all, least, rounding });
                }
            }
        }
    }
    best
}
