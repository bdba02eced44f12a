//! The tangent plane of a contact, and matrices that act in it.

use clench_screw::{Mat, Vector};

/// An orthonormal basis of the directions across a unit normal: one in the plane, two in space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tangent<const N: usize> {
    normal: Vector<N>,
    /// The second one is zero in the plane.
    basis: [Vector<N>; 2],
}

impl<const N: usize> Tangent<N> {
    /// The tangent directions of a unit normal.
    pub(crate) fn of(normal: Vector<N>) -> Self {
        // From the coordinate axis that is farthest from the normal.
        let least = (0..N).fold(0, |k, i| if normal[i].abs() < normal[k].abs() { i } else { k });
        let axis = Vector::from_fn(|i| f64::from(u8::from(i == least)));
        let first = axis - normal * normal[least];
        let first = first * first.norm().recip();
        // In space the cross product with the normal, in the plane nothing.
        let third = |i: usize| {
            let (j, k) = ((i + 1) % N, (i + 2) % N);
            if N == 3 { normal[j] * first[k] - normal[k] * first[j] } else { 0.0 }
        };
        Self { normal, basis: [first, Vector::from_fn(third)] }
    }

    /// `I - n n^T`.
    pub(crate) fn projector(&self) -> Mat<N, N> {
        Mat::IDENTITY - Mat::outer(self.normal, self.normal)
    }

    /// The direction with these components.
    pub(crate) fn direction(&self, [s, t]: [f64; 2]) -> Vector<N> {
        self.basis[0] * s + self.basis[1] * t
    }

    /// The matrix in the basis; in the plane its second direction is neutral to products.
    pub(crate) fn entries(&self, w: &Mat<N, N>) -> [[f64; 2]; 2] {
        let [s, t] = self.basis;
        let (ws, wt) = (*w * s, *w * t);
        let last = if N == 2 { 1.0 } else { t.dot(wt) };
        [[s.dot(ws), s.dot(wt)], [t.dot(ws), last]]
    }

    /// The inverse in the tangent plane.
    pub(crate) fn inverse(&self, w: &Mat<N, N>) -> Mat<N, N> {
        let [[a, b], [c, d]] = self.entries(w);
        let scale = (a * d - b * c).recip();
        let [s, t] = self.basis;
        let across = Mat::outer(s, t) * -b + Mat::outer(t, s) * -c;
        (Mat::outer(s, s) * d + across + Mat::outer(t, t) * a) * scale
    }
}
