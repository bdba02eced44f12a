//! The point of an ellipsoid that an affine map takes farthest.

use clench_screw::{Mat, SymmetricEigen, Vector};

use super::Ellipsoid;
use super::secular::on_sphere;
use crate::Farthest;

impl<const N: usize> Ellipsoid<N> {
    /// The point `x` at which `|offset + map (x - origin)|` is largest, and that length.
    ///
    /// With `x = c + A y` for a unit vector `y`, `|w + B y|` is largest where
    /// `(lambda - B^T B) y = B^T w` for a `lambda` not below the largest eigenvalue of `B^T B`: a
    /// trust-region problem (Moré and Sorensen).
    pub(crate) fn farthest_image<const R: usize>(
        &self,
        origin: Vector<N>,
        offset: Vector<R>,
        map: &Mat<R, N>,
    ) -> Farthest<N> {
        let (a, axes) = (self.semi_axes, &self.axes);
        let along = *map * *axes;
        let stretched = Mat::<R, N>::from_fn(|i, j| along[i][j] * a[j]);
        let start = offset + *map * (self.center - origin);
        // Squares of unlike sizes stay in the range of numbers.
        let size = stretched.max_abs().max(start.max_abs());
        let unit = if size > 0.0 { size.recip() } else { 0.0 };
        let (stretched, start) = (stretched * unit, start * unit);
        let Ok(eigen) = SymmetricEigen::beside_largest(&(stretched.transpose() * stretched)) else {
            // What is not a number has no largest value.
            return Farthest { point: self.center, corner: None, value: f64::NAN };
        };
        let gradient = stretched.transpose() * start;
        let along_axes = Vector::<N>::from_fn(|i| eigen.vectors[i].dot(gradient));
        let gaps = Vector::<N>::from_fn(|i| eigen.values[N - 1] - eigen.values[i]);
        let (direction, _) = on_sphere(along_axes, gaps);
        let y = (0..N).fold(Vector::ZERO, |sum, i| sum + eigen.vectors[i] * direction[i]);
        Farthest {
            point: self.center + *axes * Vector::from_fn(|i| a[i] * y[i]),
            corner: None,
            value: (start + stretched * y).norm() * size,
        }
    }
}
