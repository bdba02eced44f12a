//! The eigenvalues and eigenvectors of a small symmetric matrix.

mod closed_form;
mod largest;

use crate::{Mat, ScrewError, Vector};

/// Cyclic Jacobi converges quadratically: 3 x 3 matrices need five sweeps, and this is the end
/// for any input.
const MAX_SWEEPS: usize = 32;

/// An entry below this part of the geometric mean of its two diagonal entries rotates them by a few
/// units of rounding, which is what the rotations before it have left: it counts as zero.
const NO_ROTATION: f64 = 4.0 * f64::EPSILON;

/// Eigenvalues of like size are at least this part of the largest.
const ALIKE: f64 = 1.0 / 64.0;

/// The eigenvalues of a symmetric matrix, ascending, with orthonormal eigenvectors.
///
/// By cyclic Jacobi rotations, which stay accurate for repeated eigenvalues (the vectors are then
/// some orthonormal basis of the eigenspace) and for any scale, and find small eigenvalues of a
/// positive definite matrix to their own relative precision, as far as its entries determine them:
/// if it is well conditioned once its diagonal is scaled to 1. The component of largest magnitude
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
        Self::decomposed(a, 0.0)
    }

    /// Decomposes the symmetric part of `a`, each eigenvalue to a few units of rounding of the
    /// largest: quicker than [`Self::new`] where some are much smaller, which is then not seen.
    ///
    /// # Errors
    ///
    /// As [`Self::new`].
    pub fn beside_largest(a: &Mat<N, N>) -> Result<Self, ScrewError> {
        Self::decomposed(a, 1.0)
    }

    /// The matrix with the same eigenvectors whose eigenvalues are `function` of these.
    ///
    /// ```
    /// use clench_screw::{Mat, SymmetricEigen};
    /// let root = SymmetricEigen::new(&Mat::new([[4.0, 0.0], [0.0, 9.0]]))?.map(f64::sqrt);
    /// assert_eq!(root, Mat::new([[2.0, 0.0], [0.0, 3.0]]));
    /// # Ok::<(), clench_screw::ScrewError>(())
    /// ```
    #[must_use]
    pub fn map(&self, function: impl Fn(f64) -> f64) -> Mat<N, N> {
        let pairs = self.values.iter().zip(&self.vectors);
        pairs.fold(Mat::ZERO, |sum, (&value, &v)| sum + Mat::outer(v, v) * function(value))
    }

    /// The same in a basis whose vectors are the columns of `axes`, orthonormal.
    #[must_use]
    pub fn in_basis(&self, axes: &Mat<N, N>) -> Self {
        let vectors = self.vectors.map(|v| with_positive_peak(axes.transpose() * v));
        Self { values: self.values, vectors }
    }

    /// Diagonal entries below the part `floor` of the largest entry count as that.
    fn decomposed(a: &Mat<N, N>, floor: f64) -> Result<Self, ScrewError> {
        if !a.is_finite() {
            return Err(first_not_finite(a));
        }
        if N == 1 {
            return Ok(Self { values: [a[0][0]; N], vectors: [Vector::new([1.0; N]); N] });
        }
        // About 1, so that squares of entries stay in the range of numbers.
        let scale = power_of_two(a.max_abs());
        let a = (*a * scale.recip()).symmetric_part();
        let (mut a, mut vectors) =
            started(&a, floor).unwrap_or_else(|| (a, *Mat::<N, N>::IDENTITY.rows()));
        for _ in 0..MAX_SWEEPS {
            if !sweep(&mut a, &mut vectors, floor) {
                break;
            }
        }
        let mut pairs: [(f64, Vector<N>); N] =
            std::array::from_fn(|i| (a[i][i] * scale, with_positive_peak(vectors[i].into())));
        // By insertion: N is at most 3 in practice.
        for end in 1..N {
            for i in (1..=end).rev() {
                if pairs[i].0 < pairs[i - 1].0 {
                    pairs.swap(i, i - 1);
                }
            }
        }
        Ok(Self { values: pairs.map(|pair| pair.0), vectors: pairs.map(|pair| pair.1) })
    }
}

/// The matrix in a basis that is nearly its eigenvectors', for 3 x 3 matrices by a closed form.
///
/// The change of basis costs small eigenvalues digits, a few units of rounding of the largest:
/// matrices with eigenvalues of unlike size start from where they are.
fn started<const N: usize>(a: &Mat<N, N>, floor: f64) -> Option<(Mat<N, N>, [[f64; N]; N])> {
    let is_diagonal = (0..N).all(|i| (0..i).all(|j| a[i][j].abs() <= 0.0));
    if N != 3 || is_diagonal {
        return None;
    }
    let basis = closed_form::basis(&Mat::from_fn(|i, j| a[i][j]))?;
    let rows = Mat::<N, N>::from_fn(|i, j| basis[i][j]);
    let turned = rows * *a * rows.transpose();
    let sizes = (0..N).map(|i| turned[i][i].abs());
    let (least, largest) = sizes.fold((f64::INFINITY, 0.0_f64), |(l, m), x| (l.min(x), m.max(x)));
    (least.max(floor) > ALIKE * largest).then(|| (turned.symmetric_part(), *rows.rows()))
}

/// A power of two about as large as a size, whose inverse is a normal number too.
fn power_of_two(size: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    let power = f64::from_bits(size.to_bits() & EXPONENT);
    power.clamp(f64::MIN_POSITIVE, f64::MIN_POSITIVE.recip())
}

#[cold]
fn first_not_finite<const N: usize>(a: &Mat<N, N>) -> ScrewError {
    let mut places = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
    let (row, column) = places.find(|&(i, j)| !a[i][j].is_finite()).unwrap_or_default();
    ScrewError::NotFinite { row, column, value: a[row][column] }
}

/// One round of rotations; false when no entry was left to rotate away.
fn sweep<const N: usize>(a: &mut Mat<N, N>, vectors: &mut [[f64; N]; N], floor: f64) -> bool {
    let mut rotated = false;
    for p in 0..N {
        for q in p + 1..N {
            if !is_zero(a[p][q], a[p][p].abs().max(floor), a[q][q].abs().max(floor)) {
                rotate(a, vectors, p, q);
                rotated = true;
            }
        }
    }
    rotated
}

/// Whether the off-diagonal entry counts as zero beside two diagonal ones of these sizes.
fn is_zero(entry: f64, one: f64, other: f64) -> bool {
    let (square, product) = (entry * entry, one * other);
    if square > NO_ROTATION * NO_ROTATION * product {
        return false;
    }
    if square.is_normal() && product.is_normal() {
        return true;
    }
    // Roots where squares leave the range of numbers.
    let size = one.sqrt() * other.sqrt();
    entry.abs() <= (NO_ROTATION * size).max(f64::MIN_POSITIVE)
}

/// The rotation in the plane (p, q) that makes `a_pq` zero: of the two angles the smaller one, and
/// 45 degrees for equal diagonal entries.
///
/// With `d = a_qq - a_pp` and `h = |(d, 2 a_pq)|` its tangent is `2 a_pq / (d + h)` for a positive
/// `d`.
fn rotate<const N: usize>(a: &mut Mat<N, N>, vectors: &mut [[f64; N]; N], p: usize, q: usize) {
    let difference = a[q][q] - a[p][p];
    let doubled = 2.0 * a[p][q];
    let along = difference.abs() + length(difference, doubled);
    let across = if difference < 0.0 { -doubled } else { doubled };
    let size = 1.0 / length(along, across);
    let (c, s) = (along * size, across * size);
    let shift = across / along * a[p][q];
    a[p][p] -= shift;
    a[q][q] += shift;
    a[p][q] = 0.0;
    a[q][p] = 0.0;
    for k in (0..N).filter(|&k| k != p && k != q) {
        let (kp, kq) = (a[k][p], a[k][q]);
        (a[k][p], a[k][q]) = (c * kp - s * kq, s * kp + c * kq);
        (a[p][k], a[q][k]) = (a[k][p], a[k][q]);
    }
    for k in 0..N {
        let (kp, kq) = (vectors[p][k], vectors[q][k]);
        (vectors[p][k], vectors[q][k]) = (c * kp - s * kq, s * kp + c * kq);
    }
}

/// `|(x, y)|`.
fn length(x: f64, y: f64) -> f64 {
    let square = x * x + y * y;
    if square.is_normal() { square.sqrt() } else { x.hypot(y) }
}

fn with_positive_peak<const N: usize>(v: Vector<N>) -> Vector<N> {
    let peak = v.to_array().into_iter().fold(0.0_f64, |m, x| if x.abs() > m.abs() { x } else { m });
    if peak < 0.0 { -v } else { v }
}
