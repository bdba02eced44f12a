//! The point of an ellipsoid that an affine map takes farthest.

use clench_screw::{Mat, SymmetricEigen, Vector};

use super::Ellipsoid;
use super::secular::on_sphere;
use crate::Farthest;

/// What an affine map does to the unit sphere that the ellipsoid is stretched from.
struct Image<const N: usize, const R: usize> {
    /// `w` and `B`, divided by `size`.
    start: Vector<R>,
    stretched: Mat<R, N>,
    size: f64,
    /// Of `B^T B`.
    eigen: SymmetricEigen<N>,
    /// Where the image is farthest, along the eigenvectors.
    farthest: Vector<N>,
}

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
        let Some(image) = self.image(origin, offset, map) else {
            // What is not a number has no largest value.
            return Farthest { point: self.center, corner: None, value: f64::NAN };
        };
        let y = image.on_sphere(image.farthest);
        Farthest { point: self.stretched(y), corner: None, value: image.length(y) * image.size }
    }

    /// All points where it is as long, to the part `within`; `None` where they form a curve.
    ///
    /// In the hard case, where `B^T w` has no part in the eigenspace of the largest eigenvalue, the
    /// part of `y` in it may point any way: two ways on a line.
    pub(crate) fn all_farthest<const R: usize>(
        &self,
        origin: Vector<N>,
        offset: Vector<R>,
        map: &Mat<R, N>,
        within: f64,
    ) -> Option<Vec<Vector<N>>> {
        let image = self.image(origin, offset, map)?;
        let values = &image.eigen.values;
        let among = (0..N).filter(|&i| values[i] >= values[N - 1] * (1.0 - within)).count();
        let (along, other) = (
            image.farthest,
            Vector::from_fn(|i| if i + among < N { image.farthest[i] } else { -image.farthest[i] }),
        );
        let [y, opposite] = [along, other].map(|y| image.on_sphere(y));
        if (y - opposite).norm() <= within
            || image.length(opposite) < image.length(y) * (1.0 - within)
        {
            return Some(vec![self.stretched(y)]);
        }
        (among == 1).then(|| vec![self.stretched(y), self.stretched(opposite)])
    }

    /// The point of the boundary that the point `y` of the unit sphere is stretched to.
    fn stretched(&self, y: Vector<N>) -> Vector<N> {
        self.center + self.axes * Vector::from_fn(|i| self.semi_axes[i] * y[i])
    }

    /// `None` for what is not a number.
    fn image<const R: usize>(
        &self,
        origin: Vector<N>,
        offset: Vector<R>,
        map: &Mat<R, N>,
    ) -> Option<Image<N, R>> {
        let along = *map * self.axes;
        let stretched = Mat::<R, N>::from_fn(|i, j| along[i][j] * self.semi_axes[j]);
        let start = offset + *map * (self.center - origin);
        // Squares of unlike sizes stay in the range of numbers.
        let size = stretched.max_abs().max(start.max_abs());
        let unit = if size > 0.0 { size.recip() } else { 0.0 };
        let (stretched, start) = (stretched * unit, start * unit);
        let eigen = SymmetricEigen::beside_largest(&(stretched.transpose() * stretched)).ok()?;
        let gradient = stretched.transpose() * start;
        let along_axes = Vector::<N>::from_fn(|i| eigen.vectors[i].dot(gradient));
        let gaps = Vector::<N>::from_fn(|i| eigen.values[N - 1] - eigen.values[i]);
        let (farthest, _) = on_sphere(along_axes, gaps);
        Some(Image { start, stretched, size, eigen, farthest })
    }
}

impl<const N: usize, const R: usize> Image<N, R> {
    /// The point of the unit sphere with these components along the eigenvectors.
    fn on_sphere(&self, along: Vector<N>) -> Vector<N> {
        (0..N).fold(Vector::ZERO, |sum, i| sum + self.eigen.vectors[i] * along[i])
    }

    /// How far its image is, in units of `size`.
    fn length(&self, y: Vector<N>) -> f64 {
        (self.start + self.stretched * y).norm()
    }
}
