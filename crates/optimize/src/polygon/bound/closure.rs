//! When no fingers on some pieces of the boundary can balance by pushing alone.

use clench_screw::Vector;
use clench_screw::spatial::cross;

use super::cut::Cut;
use super::middle::Middle;
use super::{ROUNDING, arm};

/// Powers of less than this part of their size count as none when a test twist is looked for; what
/// is found is tested.
const NEARLY: f64 = 1e6 * f64::EPSILON;

/// The wrenches of a node about its middle, brought to like sizes.
#[derive(Clone, Copy, Debug)]
struct Balance<const K: usize> {
    about: Vector<2>,
    radius: f64,
    /// What each wrench is divided by: the root of the stiffness, where shares matter.
    roots: [f64; K],
    centers: [Vector<3>; K],
    /// The extents of the boxes.
    extents: [f64; K],
    least_share: f64,
}

impl<const K: usize> Balance<K> {
    /// Shares are left out of account where a piece has several stiffnesses.
    fn new(middle: &Middle<K>, radius: f64, least_share: f64) -> Self {
        let known = middle.ranges.iter().all(|w| w.stiffness_spread <= 0.0);
        let least_share = if known { least_share } else { 0.0 };
        let about = middle.about;
        let roots = middle.ranges.map(|w| if least_share > 0.0 { w.stiffness.sqrt() } else { 1.0 });
        let scaled = |i: usize, p: Vector<3>| {
            let moment = (p[2] - arm(p).dot(about)) / radius;
            Vector::new([p[0], p[1], moment]) * roots[i].recip()
        };
        Self {
            about,
            radius,
            roots,
            centers: std::array::from_fn(|i| scaled(i, middle.ranges[i].center)),
            extents: std::array::from_fn(|i| {
                middle.ranges[i].axes.iter().map(|&axis| scaled(i, axis).norm()).sum()
            }),
            least_share,
        }
    }

    /// The linear function of the unscaled wrench `i` that is `twist . p` of the scaled one.
    fn unscaled(&self, i: usize, twist: Vector<3>) -> Vector<3> {
        let spin = twist[2] / self.radius;
        let [x, y] = self.about.to_array();
        Vector::new([twist[0] - spin * x, twist[1] - spin * y, spin]) * self.roots[i].recip()
    }

    /// A twist that all middle wrenches help, if there is one: the mean of the extreme ones.
    fn helped_twist(&self) -> Option<Vector<3>> {
        let sum = self.centers.iter().fold(Vector::ZERO, |sum, &p| sum + p) * self.least_share;
        let rest = 1.0 - K as f64 * self.least_share;
        let wrenches = self.centers.map(|p| p * rest + sum);
        let mut mean = Vector::<3>::ZERO;
        for i in 0..K {
            for j in 0..i {
                let twist = cross(wrenches[i], wrenches[j]);
                let (mut helped, mut hindered) = (true, true);
                for (k, wrench) in wrenches.iter().enumerate() {
                    if k != i && k != j {
                        // Fingers on one piece have the same wrench.
                        let power = wrench.dot(twist);
                        let none = NEARLY * wrench.norm() * twist.norm();
                        helped &= power >= -none;
                        hindered &= power <= none;
                    }
                }
                if helped != hindered {
                    mean += twist * (if helped { 1.0 } else { -1.0 } / twist.norm());
                }
            }
        }
        if mean == Vector::ZERO {
            // Fewer than three different wrenches: what they have in common helps them.
            let unit = wrenches.iter().filter_map(|w| w.direction());
            mean = unit.fold(Vector::ZERO, |sum, w| sum + w);
        }
        (mean != Vector::ZERO).then_some(mean)
    }
}

/// Whether some twist is helped by all forces that fingers on the node can have: then they cannot
/// balance.
pub(crate) fn is_excluded<const K: usize>(
    middle: &Middle<K>,
    radius: f64,
    least_share: f64,
) -> bool {
    let balance = Balance::new(middle, radius, least_share);
    let pushed = balance.centers.iter().fold(Vector::ZERO, |sum, &p| sum + p);
    // Normals in a half-plane are told from the translation that helps them all, on large pieces
    // too, which a twist that turns would not.
    let translation = Vector::new([pushed[0], pushed[1], 0.0]);
    [Some(translation), balance.helped_twist()]
        .into_iter()
        .flatten()
        .any(|twist| helps_all(middle, &balance, twist))
}

/// Whether forces that fingers on the node can have all help `twist`.
fn helps_all<const K: usize>(middle: &Middle<K>, balance: &Balance<K>, twist: Vector<3>) -> bool {
    let (mut sum, mut least, mut size) = (0.0, f64::INFINITY, 0.0);
    for (i, w) in middle.ranges.iter().enumerate() {
        let linear = balance.unscaled(i, twist);
        let power = w.center.dot(linear) - w.spread(linear);
        sum += power;
        least = least.min(power);
        let far = balance.about.norm() / balance.radius;
        size += balance.centers[i].norm() + balance.extents[i] + far;
    }
    let shared = balance.least_share;
    let worst = shared * sum + (1.0 - K as f64 * shared) * least;
    worst > ROUNDING * size * twist.norm()
}

/// For four fingers whose forces balance with a known sign, that each of them pushes, to first
/// order and with what is left out as slack.
///
/// The balancing forces are `F_m = (-1)^m det(the three other wrenches)`.
pub(crate) fn cuts<const K: usize>(
    middle: &Middle<K>,
    radius: f64,
    least_share: f64,
) -> impl Iterator<Item = Cut<K>> {
    let balance = (K == 4).then(|| Balance::new(middle, radius, least_share));
    let forces: Option<[Force<K>; K]> =
        balance.map(|balance| std::array::from_fn(|m| Force::new(&balance, m)));
    let sign = forces.and_then(|forces| {
        let sure = forces.iter().find(|force| force.value.abs() > force.reach(middle));
        sure.map(|force| force.value.signum())
    });
    let shared = balance.map_or(0.0, |balance| balance.least_share);
    forces.zip(sign).into_iter().flat_map(move |(forces, sign)| {
        (0..K).map(move |l| {
            let mut cut = Force { value: 0.0, linear: [Vector::ZERO; K], rest: 0.0, size: 0.0 };
            for (m, force) in forces.iter().enumerate() {
                cut.add(force, sign * (if m == l { 1.0 } else { 0.0 } - shared));
            }
            cut.pushes(middle)
        })
    })
}

/// A balancing force as a function of the wrenches: `value` in the middle, `linear . p` from there,
/// and the rest at most `rest`.
#[derive(Clone, Copy, Debug)]
struct Force<const K: usize> {
    value: f64,
    linear: [Vector<3>; K],
    rest: f64,
    size: f64,
}

impl<const K: usize> Force<K> {
    fn new(balance: &Balance<K>, m: usize) -> Self {
        let others = |place: usize| if place < m { place } else { place + 1 };
        let [a, b, c] = [0, 1, 2].map(others);
        let [p, q, r] = [a, b, c].map(|i| balance.centers[i]);
        let [u, v, w] = [a, b, c].map(|i| balance.extents[i]);
        let sign = if m.is_multiple_of(2) { 1.0 } else { -1.0 };
        let mut linear = [Vector::ZERO; K];
        for (i, twist) in [(a, cross(q, r)), (b, cross(r, p)), (c, cross(p, q))] {
            linear[i] = balance.unscaled(i, twist) * sign;
        }
        let far = balance.about.norm() / balance.radius;
        Self {
            value: sign * p.dot(cross(q, r)),
            linear,
            rest: u * v * r.norm() + v * w * p.norm() + w * u * q.norm() + u * v * w,
            size: [p, q, r].iter().map(|x| x.norm() + far).product(),
        }
    }

    fn add(&mut self, other: &Self, weight: f64) {
        self.value += weight * other.value;
        for (sum, term) in self.linear.iter_mut().zip(other.linear) {
            *sum += term * weight;
        }
        self.rest += weight.abs() * other.rest;
        self.size += weight.abs() * other.size;
    }

    /// How far it can be from its middle.
    fn reach(&self, middle: &Middle<K>) -> f64 {
        let boxes = middle.ranges.iter().zip(self.linear);
        let along = boxes.map(|(w, linear)| w.spread(linear));
        along.sum::<f64>() + self.rest + ROUNDING * self.size
    }

    /// That it is not negative.
    fn pushes(&self, middle: &Middle<K>) -> Cut<K> {
        let boxes = middle.ranges.iter().zip(self.linear);
        let centers: f64 = boxes.map(|(w, linear)| linear.dot(w.center)).sum();
        Cut::of_linear(self.linear, 0.0, self.value - centers + self.rest, self.size)
    }
}
