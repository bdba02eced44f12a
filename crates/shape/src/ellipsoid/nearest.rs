//! The point of an ellipsoid nearest to a given point.

use clench_screw::Vector;

use super::secular::on_sphere;

/// The nearest boundary point of an ellipsoid about the origin with semi-axes `a` along the axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot<const N: usize> {
    /// The foot divided by the semi-axes: of unit length.
    pub(super) direction: Vector<N>,
    /// How many gradients `x_i / a_i^2` the point is away from its foot (length squared):
    /// positive outside the ellipsoid.
    pub(super) steps: f64,
}

/// The foot of `point`, which may be anywhere.
///
/// The foot `x` has `y - x = t A^-1 x` with `A = diag(a^2)`, so that `p_i = x_i / a_i =
/// a_i y_i / (t + a_i^2)` must be of unit length, and of all such `t` the largest one is sought.
/// (D. Eberly, *Distance from a Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid*, 2013.)
/// In terms of `s = t + a_min^2 >= 0` the denominators are `s + (a_i^2 - a_min^2)`. In the plane of
/// symmetry across the shortest axis a point may be as near to both sides.
pub(super) fn foot<const N: usize>(semi_axes: [f64; N], point: Vector<N>) -> Foot<N> {
    let least = semi_axes.into_iter().fold(f64::INFINITY, f64::min);
    let gradient = Vector::<N>::from_fn(|i| semi_axes[i] * point[i]);
    let gaps = Vector::<N>::from_fn(|i| (semi_axes[i] - least) * (semi_axes[i] + least));
    let (direction, s) = on_sphere(gradient, gaps);
    Foot { direction, steps: s - least * least }
}
