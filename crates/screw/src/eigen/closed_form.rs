//! Approximate eigenvectors of a symmetric 3 x 3 matrix, where iterations may start.

use crate::spatial::cross;
use crate::{Mat, Vector};

/// An orthonormal basis in which the off-diagonal entries beside the eigenvalue that is farthest
/// from the mean are a few units of rounding; `None` for a multiple of the identity.
///
/// With `B = A - m` for the mean `m` and `6 p^2 = |B|^2`, the eigenvalues of `B / p` are
/// `2 cos(phi + 2 pi k / 3)` with `cos(3 phi) = det(B / p) / 2`. The one farthest from the mean is
/// at least `sqrt(3) p` from the others, so that two rows of what is left of `B` span the plane
/// across its eigenvector.
pub(super) fn basis(a: &Mat<3, 3>) -> Option<[Vector<3>; 3]> {
    let mean = a.trace() / 3.0;
    let b = *a + Mat::IDENTITY * -mean;
    let squares: f64 = b.rows().as_flattened().iter().map(|x| x * x).sum();
    let p = (squares / 6.0).sqrt();
    let [x, y, z] = [0, 1, 2].map(|i| Vector::new(b[i]));
    let cosine = (x.dot(cross(y, z)) / (2.0 * p * p * p)).clamp(-1.0, 1.0);
    let farthest = (2.0 * p * cosine_of_third(cosine.abs())).copysign(cosine);
    let rest = b + Mat::IDENTITY * -farthest;
    let [x, y, z] = [0, 1, 2].map(|i| Vector::new(rest[i]));
    let candidates = [cross(x, y), cross(x, z), cross(y, z)];
    let sizes = candidates.map(Vector::norm_squared);
    let longest = if sizes[0] >= sizes[1] && sizes[0] >= sizes[2] {
        0
    } else if sizes[1] >= sizes[2] {
        1
    } else {
        2
    };
    if !sizes[longest].is_normal() {
        return None;
    }
    let first = candidates[longest] * sizes[longest].sqrt().recip();
    let [x, y, z] = first.to_array();
    // Across the two larger of its coordinates at least.
    let across =
        if x.abs() > y.abs() { Vector::new([-z, 0.0, x]) } else { Vector::new([0.0, z, -y]) };
    let second = across * across.norm().recip();
    Some([second, cross(first, second), first])
}

/// `cos(phi / 3)` for `cos(phi)` from 0 to 1, by Newton's method for `4 x^3 - 3 x = cos(phi)`: two
/// steps from a cubic that is right at 0, 1/2 and 1 and within 2e-4 between. With the same bits on
/// all machines, other than functions of the system.
fn cosine_of_third(cosine: f64) -> f64 {
    const CUBIC: [f64; 4] = [0.866_025_4, 0.166_666_7, -0.044_636_7, 0.011_944_6];
    let start = CUBIC.iter().rev().fold(0.0, |sum, factor| sum * cosine + factor);
    (0..2).fold(start, |x, _| {
        let square = x * x;
        x - (x * (4.0 * square - 3.0) - cosine) / (12.0 * square - 3.0)
    })
}
