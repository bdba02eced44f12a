//! The overlap of a finger and the part, its gradient and its Hessian.

use clench_screw::{Frame, Mat, Stiffness, Vector, Wrench, lever};

use crate::curvature::Radii;
use crate::{ContactError, Geometry};

/// A determinant below this part of what its terms could sum to is nothing but their rounding, a
/// few units each: finger and part are as flat, or as hollow, as each other.
const NO_RELATIVE_CURVATURE: f64 = 16.0 * f64::EPSILON;

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
/// that pointed and flat boundaries are no special cases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap<const N: usize, const M: usize> {
    geometry: Geometry<N>,
    depth: f64,
    /// `M^-1`: what sliding along the boundary costs.
    slide: Mat<N, N>,
    /// `M^-1 S_B`: how far the point of contact rolls.
    roll: Mat<N, N>,
    /// `S_B M^-1 Sigma`: what tilting costs.
    tilt: Mat<N, N>,
}

impl<const N: usize, const M: usize> Overlap<N, M> {
    /// The overlap of depth `depth` at the place `geometry`.
    pub(crate) fn new(geometry: Geometry<N>, depth: f64) -> Result<Self, ContactError> {
        let geometry = geometry.checked()?;
        let [a, b] = geometry.radii()?;
        check_apart(&a, &b)?;
        check_depth(&a, &b, depth)?;
        let tangent = geometry.tangent();
        // With S_A = x Y^-1, Sigma = X Y^-1 and S_B = Y_B^-1 x_B: M^-1 = Y W^-1 Y_B.
        let x = tangent * a.x - a.y * depth;
        let (inverse, _) = tangent_inverse(&(a.y * b.x + b.y * x), &tangent);
        Ok(Self {
            geometry,
            depth,
            slide: a.y * inverse * b.y,
            roll: a.y * inverse * b.x,
            tilt: x * inverse * b.x,
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
        match (self.geometry.finger.radius(), self.geometry.part.radius()) {
            (Some(r), Some(f64::INFINITY)) => {
                let center = self.geometry.point - n * (r - self.depth);
                r + turned.dot(center - moved)
            }
            (Some(r), Some(part)) if r.is_finite() => {
                let away = r - self.depth + part;
                let center = self.geometry.point - n * (r - self.depth);
                let between = moved + turned * part - center;
                self.depth + away - between.norm() * 1.0_f64.copysign(away)
            }
            _ => {
                let (shift, turn) = (moved - self.geometry.point, turned - n);
                let u = shift - n * n.dot(shift);
                let e = n * n.dot(turn) - turn;
                self.depth - n.dot(shift) - 0.5 * u.dot(self.slide * u)
                    + u.dot(self.roll * e)
                    + 0.5 * e.dot(self.tilt * e)
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
        let rolling = self.roll * normal;
        let half = rolling + (sliding + normal * -1.0) * 0.5;
        let tilting = normal.transpose() * (self.tilt * normal);
        Stiffness {
            translational: self.slide * -1.0,
            coupling: sliding + rolling,
            rotational: tilting + (arm.transpose() * half).symmetric_part() * -2.0,
        }
    }
}

/// Without overlap the gap has to open in all directions: `L_A + L_B > 0`.
fn check_apart<const N: usize>(a: &Radii<N>, b: &Radii<N>) -> Result<(), ContactError> {
    let relative = a.y * b.x + b.y * a.x;
    let size = a.y.max_abs() * b.x + b.y.max_abs() * a.x;
    let rounding = NO_RELATIVE_CURVATURE * if N == 2 { size } else { size * size };
    if relative.trace() > 0.0 && tangent_determinant(&relative) > rounding {
        return Ok(());
    }
    let radii = a.x * b.x;
    let scale = if radii > 0.0 { radii } else { 1.0 };
    Err(ContactError::NoGap { relative_curvature: least_eigenvalue(&relative) / scale })
}

/// The deepest points stay unique on the way from depth 0: the determinant of
/// `(L_A + L_B) - s L_B L_A`, a polynomial in `s`, has no root up to `s = depth`.
fn check_depth<const N: usize>(a: &Radii<N>, b: &Radii<N>, depth: f64) -> Result<(), ContactError> {
    let relative = a.y * b.x + b.y * a.x;
    let product = b.y * a.y;
    let (start, end) = (tangent_determinant(&relative), tangent_determinant(&product));
    let (slope, bend) = if N == 2 {
        (product.trace(), 0.0)
    } else {
        (relative.trace() * product.trace() - (relative * product).trace(), end)
    };
    // start - slope s + bend s^2 = 0 has its smaller root first.
    let discriminant = slope * slope - 4.0 * start * bend;
    if discriminant < 0.0 {
        return Ok(());
    }
    let below = slope + discriminant.sqrt();
    let limit = if below > 0.0 { 2.0 * start / below } else { f64::INFINITY };
    if depth < limit { Ok(()) } else { Err(ContactError::TooDeep { depth, limit }) }
}

/// The determinant in the tangent plane of a matrix that takes and gives tangent vectors.
fn tangent_determinant<const N: usize>(w: &Mat<N, N>) -> f64 {
    if N == 2 { w.trace() } else { 0.5 * (w.trace().powi(2) - (*w * *w).trace()) }
}

/// The inverse in the tangent plane, and the determinant there (Cayley and Hamilton).
fn tangent_inverse<const N: usize>(w: &Mat<N, N>, tangent: &Mat<N, N>) -> (Mat<N, N>, f64) {
    let determinant = tangent_determinant(w);
    let adjugate = if N == 2 { *tangent } else { *tangent * w.trace() - *w };
    (adjugate * determinant.recip(), determinant)
}

/// The smaller eigenvalue of a symmetric matrix in the tangent plane.
fn least_eigenvalue<const N: usize>(w: &Mat<N, N>) -> f64 {
    if N == 2 {
        return w.trace();
    }
    let half = 0.5 * w.trace();
    half - (half * half - tangent_determinant(w)).max(0.0).sqrt()
}
