//! The overlap of a finger and the part, its gradient and its Hessian.

use clench_screw::{Frame, Mat, Stiffness, Vector, Wrench, lever};

use crate::curvature::Radii;
use crate::geometry::ROUNDING;
use crate::tangent::Tangent;
use crate::{ContactError, Geometry};

/// Where a finger and the part touch, how deep, and how the depth changes with the pose.
///
/// The overlap `delta` is the least translation that separates the finger from the part. With `b`
/// the deepest point of the part, `n` the unit normal into the part, `S` and `L = S^-1` radii and
/// curvatures in the tangent plane, `A` the finger and `B` the part, and
/// `Sigma = S_A - delta`, `M = Sigma + S_B`,
///
/// ```text
/// grad delta    = -(n, b x n)
/// q^T D^2 delta q = -u^T M^-1 u + 2 u^T M^-1 S_B e + e^T S_B M^-1 Sigma e
///                 - (b . omega) (n . omega) + (b . n) omega^2
/// u = P (v + omega x b),   e = n x omega,   P = I - n n^T
/// ```
///
/// It holds for any depth, not only to first order in it, since the surface parallel to the finger
/// through `b` has the radii `S_A - delta`. No inverse of a radius or a curvature is formed, so
/// that pointed and flat boundaries are no special cases. Principal radii of one body in a ratio
/// of 1e6 and more, skewed to those of the other, cost digits: about the square of that ratio in
/// units of rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap<const N: usize, const M: usize> {
    geometry: Geometry<N>,
    depth: f64,
    /// `M^-1`: what sliding along the boundary costs.
    slide: Mat<N, N>,
    /// `M^-1 S_B lever(n)`: how turning makes the point of contact roll.
    roll: Mat<N, M>,
    /// `lever(n)^T S_B M^-1 Sigma lever(n)`: what tilting gains.
    tilt: Mat<M, M>,
}

impl<const N: usize, const M: usize> Overlap<N, M> {
    /// The overlap of depth `depth` at the place `geometry`.
    pub(crate) fn new(geometry: Geometry<N>, depth: f64) -> Result<Self, ContactError> {
        let geometry = geometry.checked()?;
        let tangent = Tangent::of(geometry.inward_normal);
        let [a, b] = geometry.radii(&tangent)?;
        check_apart(&tangent, &a, &b)?;
        check_depth(&tangent, &a, &b, depth)?;
        // With S_A = x Y^-1, Sigma = X Y^-1 and S_B = Y_B^-1 x_B: M^-1 = Y W^-1 Y_B.
        let x = tangent.projector() * a.x - a.y * depth;
        let inverse = tangent.inverse(&(a.y * b.x + b.y * x));
        let normal = lever::<N, M>(geometry.inward_normal);
        Ok(Self {
            geometry,
            depth,
            slide: a.y * inverse * b.y,
            roll: a.y * inverse * normal * b.x,
            tilt: (normal.transpose() * (x * inverse * normal)).symmetric_part() * b.x,
        })
    }

    /// The place, with a normal of unit length.
    #[must_use]
    pub const fn geometry(&self) -> &Geometry<N> {
        &self.geometry
    }

    /// `b`, the deepest point of the part (length).
    #[must_use]
    pub const fn point(&self) -> Vector<N> {
        self.geometry.point
    }

    /// `a = b + delta n`, the deepest point of the finger (length).
    #[must_use]
    pub fn finger_point(&self) -> Vector<N> {
        self.geometry.point + self.geometry.inward_normal * self.depth
    }

    /// `n`, the unit normal into the part.
    #[must_use]
    pub const fn inward_normal(&self) -> Vector<N> {
        self.geometry.inward_normal
    }

    /// Unit directions along the boundary of the part: in the plane one, with the part on the left
    /// of it; in space two at a right angle.
    #[must_use]
    pub fn tangents(&self) -> Vec<Vector<N>> {
        let n = self.geometry.inward_normal;
        if N == 2 {
            return vec![Vector::from_fn(|i| if i == 0 { n[1] } else { -n[0] })];
        }
        let tangent = Tangent::of(n);
        [[1.0, 0.0], [0.0, 1.0]].map(|along| tangent.direction(along)).to_vec()
    }

    /// `delta`, the overlap at rest (length).
    #[must_use]
    pub const fn depth(&self) -> f64 {
        self.depth
    }

    /// The overlap after the part has moved: `displacement` is its frame seen from where that
    /// frame is at rest. Negative when the finger has come free, by the distance.
    ///
    /// Exact for round and pointed fingers on flat and round boundaries, as long as the deepest
    /// points stay on them; otherwise right to second order in the displacement.
    #[must_use]
    pub fn depth_after(&self, displacement: &Frame<N, M>) -> f64 {
        let n = self.geometry.inward_normal;
        let turned = displacement.direction_to_parent(n);
        let moved = displacement.point_to_parent(self.geometry.point);
        let (shift, turn) = (moved - self.geometry.point, turned - n);
        // All in small differences: radii may be many times larger than the depth.
        let nod = 0.5 * turn.norm_squared();
        match (self.geometry.finger.radius(), self.geometry.part.radius()) {
            (Some(r), Some(f64::INFINITY)) => {
                self.depth - turned.dot(shift) + (r - self.depth) * nod
            }
            (Some(r), Some(part)) if r.is_finite() => {
                // The centers, apart by `away` n at rest, move by v.
                let away = r - self.depth + part;
                let v = shift + turn * part;
                let along = n.dot(shift) - part * nod;
                let between = (n * away + v).norm();
                let more = (2.0 * away * along + v.norm_squared()) / (away.abs() + between);
                self.depth - more * 1.0_f64.copysign(away)
            }
            _ => {
                // u is taken in the tangent plane by the matrices, e = -turn is lever(n) omega.
                let omega = lever::<N, M>(n).transpose() * -turn;
                self.depth - n.dot(shift) - 0.5 * shift.dot(self.slide * shift)
                    + shift.dot(self.roll * omega)
                    + 0.5 * omega.dot(self.tilt * omega)
            }
        }
    }

    /// `grad delta = -(n, b x n)` about `origin`, a covector.
    #[must_use]
    pub fn gradient(&self, origin: Vector<N>) -> Wrench<N, M> {
        Wrench::of_force_at(-self.geometry.inward_normal, self.geometry.point - origin)
    }

    /// `D^2 delta` about `origin`, in the chart `(d, phi)` with `R = exp(phi)` (1 / length and so
    /// on).
    ///
    /// It depends on the chart; only the sum over the contacts of a grasp in equilibrium, weighted
    /// by the forces, does not.
    #[must_use]
    pub fn hessian(&self, origin: Vector<N>) -> Stiffness<N, M> {
        // u = v - lever(b) omega and e = lever(n) omega.
        let arm = lever::<N, M>(self.geometry.point - origin);
        let normal = lever::<N, M>(self.geometry.inward_normal);
        let sliding = self.slide * arm;
        let half = self.roll + (sliding - normal) * 0.5;
        Stiffness {
            translational: self.slide * -1.0,
            coupling: sliding + self.roll,
            rotational: self.tilt - (arm.transpose() * half).symmetric_part() * 2.0,
        }
    }
}

/// Without overlap the gap has to open in all directions: `L_A + L_B > 0`.
fn check_apart<const N: usize>(
    tangent: &Tangent<N>,
    a: &Radii<N>,
    b: &Radii<N>,
) -> Result<(), ContactError> {
    let (finger, part) = (a.y * b.x, b.y * a.x);
    let [[p, q], [_, s]] = tangent.entries(&(finger + part));
    let least = if N == 2 { p } else { 0.5 * (p + s) - (0.5 * (p - s)).hypot(q) };
    if least > ROUNDING * (finger.max_abs() + part.max_abs()) {
        return Ok(());
    }
    // Between pointed boundaries there are no radii to divide by.
    let radii = a.x * b.x;
    let scale = if radii > 0.0 { radii } else { 1.0 };
    Err(ContactError::NoGap { relative_curvature: least / scale })
}

/// The deepest points stay unique on the way from depth 0: the determinant of
/// `(L_A + L_B) - s L_B L_A`, a polynomial in `s`, has no root up to `s = depth`.
///
/// Its roots are real, where `S_A + S_B - s` loses its inverse: a negative discriminant is
/// rounding.
fn check_depth<const N: usize>(
    tangent: &Tangent<N>,
    a: &Radii<N>,
    b: &Radii<N>,
    depth: f64,
) -> Result<(), ContactError> {
    let relative = tangent.entries(&(a.y * b.x + b.y * a.x));
    let product = tangent.entries(&(b.y * a.y));
    let [[p, q], [r, s]] = relative;
    let [[t, u], [v, w]] = product;
    let start = p * s - q * r;
    // 1 - slope x + bend x^2 with x = s / depth; the plane has no second direction to multiply.
    let (slope, bend) = if N == 2 {
        (t * depth / start, 0.0)
    } else {
        ((p * w + s * t - q * v - r * u) * depth / start, (t * w - u * v) * depth * depth / start)
    };
    let below = slope + (slope * slope - 4.0 * bend).max(0.0).sqrt();
    // The smaller root is 2 / below.
    if below < 2.0 {
        Ok(())
    } else {
        Err(ContactError::TooDeep { depth, limit: depth * 2.0 / below })
    }
}
