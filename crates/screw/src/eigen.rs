//! The eigenvalues and eigenvectors of a small symmetric matrix.

use crate::{Mat, ScrewError, Vector};

/// Cyclic Jacobi converges quadratically: 3 x 3 matrices need five sweeps, and this is the end
/// for any input.
const MAX_SWEEPS: usize = 32;

/// An entry below this part of the geometric mean of its two diagonal entries rotates them by less
/// than a unit of rounding, so it counts as zero.
const NO_ROTATION: f64 = f64::EPSILON;

/// The eigenvalues of a symmetric matrix, ascending, with orthonormal eigenvectors.
///
/// By cyclic Jacobi rotations, which stay accurate for repeated eigenvalues (the vectors are then
/// some orthonormal basis of the eigenspace) and for any scale, and find small eigenvalues of a
/// positive definite matrix to their own relative precision. The component of largest magnitude
/// of each vector is positive.
///
/// ```
/// use clench_screw::{Mat, SymmetricEigen};
/// let eigen = SymmetricEigen::new(&Mat::new([[2.0, 1.0], [1.0, 2.0]]))?;
/// assert!((eigen.values[0] - 1.0).abs() < 1e-15 && (eigen.values[1] - 3.0).abs() < 1e-15);
/// # Ok::<(), clench_screw::ScrewError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetricEigen<const N: usize> {
    /// The eigenvalues, ascending, in the unit of the matrix.
    pub values: [f64; N],
    /// Unit eigenvectors; `vectors[i]` belongs to `values[i]`.
    pub vectors: [Vector<N>; N],
}

impl<const N: usize> SymmetricEigen<N> {
    /// Decomposes the symmetric part of `a`.
    ///
    /// # Errors
    ///
    /// [`ScrewError::NotFinite`] with the place of the first entry that is not a finite number.
    pub fn new(a: &Mat<N, N>) -> Result<Self, ScrewError> {
        if let Some((row, column)) = first_not_finite(a) {
            return Err(ScrewError::NotFinite { row, column, value: a[row][column] });
        }
        let mut a = a.symmetric_part();
        let mut basis = Mat::IDENTITY;
        for _ in 0..MAX_SWEEPS {
            if !sweep(&mut a, &mut basis) {
                break;
            }
        }
        let mut order: [usize; N] = std::array::from_fn(|i| i);
        order.sort_by(|&i, &j| a[i][i].total_cmp(&a[j][j]));
        Ok(Self {
            values: order.map(|i| a[i][i]),
            vectors: order.map(|i| with_positive_peak(basis.column(i))),
        })
    }
}

fn first_not_finite<const N: usize>(a: &Mat<N, N>) -> Option<(usize, usize)> {
    let places = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
    places.into_iter().find(|&(i, j)| !a[i][j].is_finite())
}

/// One round of rotations; false when no entry was left to rotate away.
fn sweep<const N: usize>(a: &mut Mat<N, N>, basis: &mut Mat<N, N>) -> bool {
    let mut rotated = false;
    for p in 0..N {
        for q in p + 1..N {
            let (one, other) = (a[p][p].abs(), a[q][q].abs());
            let product = one * other;
            // Two roots where the product leaves the range of numbers.
            let scale =
                if product.is_normal() { product.sqrt() } else { one.sqrt() * other.sqrt() };
            if a[p][q].abs() > NO_ROTATION * scale {
                rotate(a, basis, p, q);
                rotated = true;
            }
        }
    }
    rotated
}

/// The rotation in the plane (p, q) that makes `a_pq` zero.
fn rotate<const N: usize>(a: &mut Mat<N, N>, basis: &mut Mat<N, N>, p: usize, q: usize) {
    let half_cotangent = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    // The smaller of the two angles; copysign keeps 45 degrees for equal diagonal entries,
    // and an overflowing square gives the angle 0.
    let t = 1.0_f64.copysign(half_cotangent)
        / (half_cotangent.abs() + (half_cotangent * half_cotangent + 1.0).sqrt());
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    let shift = t * a[p][q];
    a[p][p] -= shift;
    a[q][q] += shift;
    a[p][q] = 0.0;
    a[q][p] = 0.0;
    for k in 0..N {
        if k != p && k != q {
            let (kp, kq) = (a[k][p], a[k][q]);
            (a[k][p], a[k][q]) = (c * kp - s * kq, s * kp + c * kq);
            (a[p][k], a[q][k]) = (a[k][p], a[k][q]);
        }
        let (kp, kq) = (basis[k][p], basis[k][q]);
        (basis[k][p], basis[k][q]) = (c * kp - s * kq, s * kp + c * kq);
    }
}

fn with_positive_peak<const N: usize>(v: Vector<N>) -> Vector<N> {
    let peak = v.to_array().into_iter().fold(0.0_f64, |m, x| if x.abs() > m.abs() { x } else { m });
    if peak < 0.0 { -v } else { v }
}
