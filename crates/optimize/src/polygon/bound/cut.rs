//! Inequalities that all placements of a quality fulfill, and how they are added up.

use clench_screw::{Cholesky, Mat, SymmetricEigen, Vector};

use super::arm;
use super::demand::Demand;
use super::middle::Middle;
use crate::polygon::scene::Scene;

/// Steps of bisection for the weight of a cut: enough to come within a percent.
const BISECTIONS: usize = 8;

/// What all placements that meet a demand fulfill:
/// `sum over the fingers of (p^T form p + linear . p) + slack >= constant`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cut<const K: usize> {
    pub(crate) form: Mat<3, 3>,
    pub(crate) linear: [Vector<3>; K],
    pub(crate) constant: f64,
    /// The weight of the cuts by rotation in it, and the sums of their points `y` and of their
    /// corners, which decide their slack.
    pub(crate) turning: f64,
    y: Vector<2>,
    pub(super) corner: Vector<2>,
    /// Slack that is known already.
    pub(crate) slack: f64,
    /// The size of what is added up.
    pub(crate) size: f64,
    /// By how much `constant` grows with the demand, at least.
    pub(super) gain: f64,
}

impl<const K: usize> Cut<K> {
    /// `mu - q |d - corner|^2 >= 0`.
    pub(crate) fn by_rotation(
        scene: &Scene,
        middle: &Middle<K>,
        demand: &Demand,
        corner: Vector<2>,
    ) -> Self {
        let (about, q) = (middle.about, demand.rotation);
        let reach = about - corner;
        let y = middle.solve(reach * q);
        let second = about + y * 2.0;
        let a = Vector::new([-about[0], -about[1], 1.0]);
        let b = Vector::new([-second[0], -second[1], 1.0]);
        let form = (Mat::outer(a, b) + Mat::outer(b, a)) * 0.5;
        let radius = scene.radius;
        let gain = scene.radius_squared;
        Self {
            form,
            constant: q * reach.norm_squared(),
            turning: 1.0,
            y,
            corner,
            size: middle.trace * (radius + about.norm()) * (radius + second.norm()),
            gain,
            ..Self::NONE
        }
    }

    /// `sum of s^2 >= mu >= q reach^2`, with the geometric center as any point, and the reach at
    /// least the radius: all that there is to say of nearly round outlines.
    pub(crate) fn about_center(scene: &Scene, middle: &Middle<K>, demand: &Demand) -> Self {
        let spin = Vector::new([0.0, 0.0, 1.0]);
        Self {
            form: Mat::outer(spin, spin),
            constant: demand.rotation * scene.radius_squared,
            size: middle.trace * scene.radius_squared,
            gain: scene.radius_squared,
            ..Self::NONE
        }
    }

    /// `arm . H arm >= sigma_min`, for the softest direction in the middle.
    pub(crate) fn by_translation(middle: &Middle<K>, demand: &Demand) -> Self {
        let [x, y] = middle.softest().to_array();
        let direction = Vector::new([x, y, 0.0]);
        Self {
            form: Mat::outer(direction, direction),
            constant: demand.translation,
            size: middle.trace,
            gain: if demand.fixed_translation { 0.0 } else { 1.0 },
            ..Self::NONE
        }
    }

    /// That a force at the corner where these wrenches give most moves it little enough:
    /// `sum of (p . t)^2 >= q |deflection|^2` for the twist `t = (t_1, t_2, spin)` that it causes,
    /// with `(t_1, t_2) + spin v` the deflection of the corner `v`, a quarter turn from itself.
    pub(crate) fn by_worst_point(
        scene: &Scene,
        demand: &Demand,
        wrenches: &[Vector<3>; K],
    ) -> Option<Self> {
        let (mut gram, mut first) = (Mat::<2, 2>::ZERO, Vector::ZERO);
        for &p in wrenches {
            gram += Mat::outer(arm(p), arm(p));
            first += arm(p) * p[2];
        }
        let gram = Cholesky::new(&gram).ok()?;
        let about = gram.solve(first);
        let mu: f64 = wrenches.iter().map(|&p| (p[2] - arm(p).dot(about)).powi(2)).sum();
        if mu.is_nan() || mu <= 0.0 {
            return None;
        }
        let translation = gram.inverse();
        let compliance = |corner: Vector<2>| {
            let lever = corner - about;
            translation + Mat::outer(lever, lever) * mu.recip()
        };
        let corner = scene.worst_corner(&translation, about, mu);
        let softest = SymmetricEigen::new(&compliance(corner)).ok()?;
        let (force, deflection) = (softest.vectors[1], softest.values[1]);
        let spin = (corner - about).dot(force) / mu;
        let shift = gram.solve(force) - about * spin;
        // For a deflection of 1.
        let twist = Vector::new([shift[0], shift[1], spin]) * deflection.recip();
        let farthest = scene.radius * twist[2].abs() + shift.norm() / deflection;
        let stiffness: f64 = wrenches.iter().map(|&p| arm(p).norm_squared()).sum();
        Some(Self {
            form: Mat::outer(twist, twist),
            constant: demand.worst_point,
            size: stiffness * farthest * farthest,
            gain: 1.0,
            ..Self::NONE
        })
    }

    /// `linear . p` alone, at least `constant`.
    pub(crate) const fn of_linear(
        linear: [Vector<3>; K],
        constant: f64,
        slack: f64,
        size: f64,
    ) -> Self {
        Self { linear, constant, slack, size, ..Self::NONE }
    }

    /// What is always fulfilled.
    pub(crate) const NONE: Self = Self {
        form: Mat::ZERO,
        linear: [Vector::ZERO; K],
        constant: 0.0,
        turning: 0.0,
        y: Vector::ZERO,
        corner: Vector::ZERO,
        slack: 0.0,
        size: 0.0,
        gain: 0.0,
    };

    /// This cut and `weight` times the other one.
    pub(crate) fn plus(&self, weight: f64, other: &Self) -> Self {
        let linear = std::array::from_fn(|i| self.linear[i] + other.linear[i] * weight);
        Self {
            form: self.form + other.form * weight,
            linear,
            constant: self.constant + weight * other.constant,
            turning: self.turning + weight * other.turning,
            y: self.y + other.y * weight,
            corner: self.corner + other.corner * weight,
            slack: self.slack + weight * other.slack,
            size: self.size + weight * other.size,
            gain: self.gain + weight * other.gain,
        }
    }

    /// The mean of both cuts, with the weight `part` of the other one.
    pub(crate) fn mixed(&self, part: f64, other: &Self) -> Self {
        Self::NONE.plus(1.0 - part, self).plus(part, other)
    }

    /// What the middle exceeds the constant by, and the slopes along the axes of the boxes.
    pub(super) fn model(&self, middle: &Middle<K>) -> (f64, [[f64; 3]; K]) {
        let (mut base, mut slopes) = (self.slack - self.constant, [[0.0; 3]; K]);
        for i in 0..K {
            let w = &middle.ranges[i];
            let image = self.form * w.center;
            base += (image + self.linear[i]).dot(w.center);
            let slope = image * 2.0 + self.linear[i];
            slopes[i] = w.axes.map(|axis| axis.dot(slope));
        }
        (base, slopes)
    }
}

/// The slack of the cuts by rotation: the largest `2 g . e - e^T (H + q) e` over all `e`, with
/// `g = H y - q (about - corner)`, where `H` is at least the demanded `sigma_min`.
pub(crate) fn slack<const K: usize>(middle: &Middle<K>, demand: &Demand, cut: &Cut<K>) -> f64 {
    let q = demand.rotation;
    let off = (middle.apply(cut.y) - (middle.about * cut.turning - cut.corner) * q).norm()
        + 0.5 * middle.spread() * cut.y.norm();
    if off > 0.0 { off * off / (cut.turning * (demand.translation + q)) } else { 0.0 }
}

/// The weight in `[0, most]` that makes `weight * base + sum |slopes + weight * steps|` least.
pub(crate) fn best_weight<const K: usize>(
    slopes: &[[f64; 3]; K],
    steps: &[[f64; 3]; K],
    base: f64,
    most: f64,
) -> f64 {
    let growth = |weight: f64| {
        let pairs = slopes.as_flattened().iter().zip(steps.as_flattened());
        pairs.fold(base, |sum, (slope, step)| sum + step * (slope + weight * step).signum())
    };
    if growth(0.0) >= 0.0 {
        return 0.0;
    }
    if growth(most) <= 0.0 {
        return most;
    }
    let (mut low, mut high) = (0.0, most);
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        if growth(middle) > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}
