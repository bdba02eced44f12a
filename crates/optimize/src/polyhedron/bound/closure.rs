//! When no contacts on some pieces of the surface can balance by pushing alone.

use clench_screw::Vector;
use clench_screw::spatial::cross;

use super::ROUNDING;
use super::pieces::Corners;

/// Steps in which a twist that all forces help is looked for.
const STEPS: usize = 12;

/// Normals within this of a half-space's border count as on it: the rounding of unit vectors.
const BORDER: f64 = 4.0 * f64::EPSILON;

/// A normal that is inside the half-space by more than this part cannot push: what the others,
/// outside by the rounding of a border, allow it is less than a millionth of the preload.
const INSIDE: f64 = 1e-8;

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
        // Unit wrenches about the middle of the part are no longer than about 1.5.
        power - ROUNDING * 4.0 * twist.norm()
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
/// The point of the hull of their wrenches that is nearest to the origin is approached, each time
/// towards the wrench that opposes it most.
pub(crate) fn helped_twist(contacts: &Contacts<'_>, steps: usize) -> Option<Vector<6>> {
    let mut twist = contacts.least_wrench(Vector::ZERO);
    for _ in 0..steps {
        if contacts.least_power(twist) > 0.0 {
            return Some(twist);
        }
        let way = contacts.least_wrench(twist) - twist;
        let part = (-twist.dot(way) / way.norm_squared()).clamp(0.0, 1.0);
        if !(part > 0.0 && part.is_finite()) {
            return None;
        }
        twist += way * part;
    }
    None
}

/// Whether some twist is helped by all forces of the contacts.
pub(crate) fn helps_all(contacts: &Contacts<'_>) -> bool {
    helped_twist(contacts, STEPS).is_some()
}
