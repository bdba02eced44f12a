//! Boxes around vectors, and quadratic functions over them.

use clench_screw::{Mat, SymmetricEigen, Vector};

/// A box is drawn wider by this many units of rounding of the sizes that it was computed from.
pub(crate) const BOX_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// `p^T form p + linear . p`.
pub(crate) fn value<const D: usize>(form: &Mat<D, D>, linear: Vector<D>, p: Vector<D>) -> f64 {
    (*form * p + linear).dot(p)
}

/// How much `linear . p` changes from the center of a box to an end.
pub(crate) fn spread<const D: usize>(axes: &[Vector<D>; D], linear: Vector<D>) -> f64 {
    axes.iter().map(|axis| axis.dot(linear).abs()).sum()
}

/// An upper bound of `p^T form p + linear . p` over a box; `form` is symmetric.
pub(crate) fn largest_in_box<const D: usize>(
    form: &Mat<D, D>,
    linear: Vector<D>,
    center: Vector<D>,
    axes: &[Vector<D>; D],
) -> f64 {
    let images = axes.map(|axis| *form * axis);
    let mut rise = spread(axes, *form * center * 2.0 + linear);
    for j in 0..D {
        rise += axes[j].dot(images[j]).max(0.0);
        for i in 0..j {
            rise += 2.0 * axes[i].dot(images[j]).abs();
        }
    }
    value(form, linear, center) + rise
}

/// Sorts the numbers of points so that halving the list again and again keeps neighbors together:
/// each time by the place along the longest principal axis.
pub(crate) fn arrange<const D: usize>(points: &[Vector<D>], order: &mut [usize]) {
    if order.len() < 3 {
        return;
    }
    let of = |order: &[usize]| order.iter().map(|&i| points[i]).collect::<Vec<_>>();
    let (_, axes) = principal_axes(of(order).into_iter());
    let axis = axes[D - 1];
    let along = |i: usize| points[i].dot(axis);
    let middle = usize::midpoint(0, order.len());
    order.select_nth_unstable_by(middle, |&i, &j| along(i).total_cmp(&along(j)).then(i.cmp(&j)));
    let (left, right) = order.split_at_mut(middle);
    arrange(points, left);
    arrange(points, right);
}

/// The mean of points and their principal axes, the longest one last.
fn principal_axes<const D: usize>(
    points: impl Iterator<Item = Vector<D>> + Clone,
) -> (Vector<D>, [Vector<D>; D]) {
    let count = points.clone().count() as f64;
    let mean = points.clone().fold(Vector::ZERO, |sum, p| sum + p) * count.recip();
    let covariance = points.fold(Mat::<D, D>::ZERO, |sum, p| sum + Mat::outer(p - mean, p - mean));
    // Any axes will do; principal ones make thin boxes.
    let axes = SymmetricEigen::new(&covariance).map_or_else(
        |_| std::array::from_fn(|j| Vector::from_fn(|i| if i == j { 1.0 } else { 0.0 })),
        |eigen| eigen.vectors,
    );
    (mean, axes)
}

/// The box around `points` along their principal axes, each component in its unit.
pub(crate) fn principal_box<const D: usize>(
    points: &[Vector<D>],
    units: Vector<D>,
) -> (Vector<D>, [Vector<D>; D]) {
    let unscaled = |p: Vector<D>| Vector::from_fn(|i| p[i] * units[i]);
    let points = points.iter().map(|p| Vector::<D>::from_fn(|i| p[i] / units[i]));
    let (mean, axes) = principal_axes(points.clone());
    let (mut low, mut high, mut size) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D], 0.0_f64);
    for p in points {
        size = size.max(p.max_abs());
        for j in 0..D {
            let along = axes[j].dot(p - mean);
            low[j] = low[j].min(along);
            high[j] = high[j].max(along);
        }
    }
    let center = (0..D).fold(mean, |sum, j| sum + axes[j] * (0.5 * (low[j] + high[j])));
    let half = |j: usize| 0.5 * (high[j] - low[j]) + BOX_ROUNDING * size;
    (unscaled(center), std::array::from_fn(|j| unscaled(axes[j] * half(j))))
}
