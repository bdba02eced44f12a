//! The lever map: how an arm turns rotation into translation.

use crate::{Mat, Vector};

/// `r x omega` as a matrix that acts on `omega`.
///
/// The plane is read as the slice z = 0 of space: its translations are the first `N` of three,
/// its rotations the last `M`. So one text serves both: `hat(r)` in space, `J r` in the plane,
/// `J = [[0, 1], [-1, 0]]`. The velocity of the point `x` of a body is `v - lever(x) omega`, and
/// the torque of a force `f` at `x` is `-lever(x)^T f`.
///
/// ```
/// use clench_screw::{Mat, Vector, lever};
/// assert_eq!(lever(Vector::new([3.0, 5.0])), Mat::new([[5.0], [-3.0]]));
/// ```
#[must_use]
pub fn lever<const N: usize, const M: usize>(r: Vector<N>) -> Mat<N, M> {
    const { assert!((N == 2 && M == 1) || (N == 3 && M == 3), "the plane or space") }
    let z = if N == 3 { r[2] } else { 0.0 };
    let hat = [[0.0, -z, r[1]], [z, 0.0, -r[0]], [-r[1], r[0], 0.0]];
    Mat::from_fn(|i, j| hat[i][j + 3 - M])
}

/// The point `c` whose lever map is nearest to `p` (least squares).
///
/// In the plane every `p` is a lever map and `lever(c) = p`; in space `lever(c)` is the
/// antisymmetric part of `p`. Same unit as `p`.
///
/// ```
/// use clench_screw::{Vector, lever, lever_center};
/// let c = Vector::new([1.0, 2.0, 3.0]);
/// assert_eq!(lever_center::<3, 3>(&lever(c)), c);
/// ```
#[must_use]
pub fn lever_center<const N: usize, const M: usize>(p: &Mat<N, M>) -> Vector<N> {
    let first = 3 - M;
    Vector::from_fn(|k| {
        // Component k stands at (i, j) with a plus sign when (j, i, k) is cyclic; in the plane
        // only one of its two places exists.
        let (i, j) = ((k + 2) % 3, (k + 1) % 3);
        let mut places = 0.0;
        let mut sum = 0.0;
        if i < N && j >= first {
            sum += p[i][j - first];
            places += 1.0;
        }
        if j < N && i >= first {
            sum -= p[j][i - first];
            places += 1.0;
        }
        sum / places
    })
}
