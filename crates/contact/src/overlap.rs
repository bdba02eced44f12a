//! The overlap of a round finger with a flat face, its gradient and its Hessian.

use clench_screw::{Frame, Stiffness, Vector, Wrench, lever};

/// A disc on a straight edge, or a sphere on a plane face: where it touches, and how deep.
///
/// The overlap `delta` is the least translation that separates the finger from the body. With
/// `b` the deepest point of the body, `n` the unit normal into the body, `r` the radius of the
/// finger and `c = b - (r - delta) n` its center,
///
/// `delta(q) = r + R n . (c - d - R b)` for a body moved by `q = (d, R)`,
///
/// which is exact for any displacement that keeps the deepest point inside the face. A pointed
/// finger has `r = 0`; its tip is `c`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap<const N: usize, const M: usize> {
    point: Vector<N>,
    inward_normal: Vector<N>,
    center: Vector<N>,
    radius: f64,
    depth: f64,
}

impl<const N: usize, const M: usize> Overlap<N, M> {
    /// The overlap of depth `depth` at `point` on a face with the unit `inward_normal`.
    pub(crate) fn new(point: Vector<N>, inward_normal: Vector<N>, radius: f64, depth: f64) -> Self {
        let center = point - inward_normal * (radius - depth);
        Self { point, inward_normal, center, radius, depth }
    }

    /// `b`, the deepest point of the body (length).
    #[must_use]
    pub const fn point(&self) -> Vector<N> {
        self.point
    }

    /// `n`, the unit normal into the body.
    #[must_use]
    pub const fn inward_normal(&self) -> Vector<N> {
        self.inward_normal
    }

    /// `c`, the center of the finger's tip (length).
    #[must_use]
    pub const fn finger_center(&self) -> Vector<N> {
        self.center
    }

    /// `r`, the radius of the finger's tip (length); 0 for a pointed finger.
    #[must_use]
    pub const fn finger_radius(&self) -> f64 {
        self.radius
    }

    /// `delta`, the overlap at rest (length).
    #[must_use]
    pub const fn depth(&self) -> f64 {
        self.depth
    }

    /// The overlap after the body has moved: `displacement` is its frame seen from where that
    /// frame is at rest. Negative when the finger has come free, by the distance.
    #[must_use]
    pub fn depth_after(&self, displacement: &Frame<N, M>) -> f64 {
        let normal = displacement.direction_to_parent(self.inward_normal);
        let point = displacement.point_to_parent(self.point);
        self.radius + normal.dot(self.center - point)
    }

    /// `grad delta = -(n, b x n)` about `origin`, a covector.
    #[must_use]
    pub fn gradient(&self, origin: Vector<N>) -> Wrench<N, M> {
        Wrench::of_force_at(-self.inward_normal, self.point - origin)
    }

    /// `D^2 delta` about `origin`, in the chart `(d, phi)` with `R = exp(phi)`:
    /// `[[0, lever(n)], [., -sym(lever(n)^T lever(c))]]` (1 / length and so on).
    ///
    /// It depends on the chart; only the sum over the contacts of a grasp in equilibrium, weighted
    /// by the forces, does not. From expanding `delta(q)` with
    /// `R n = n + phi x n + phi x (phi x n) / 2`.
    #[must_use]
    pub fn hessian(&self, origin: Vector<N>) -> Stiffness<N, M> {
        let normal = lever::<N, M>(self.inward_normal);
        let center = lever::<N, M>(self.center - origin);
        Stiffness {
            coupling: normal,
            rotational: (normal.transpose() * center).symmetric_part() * -1.0,
            ..Stiffness::ZERO
        }
    }
}
