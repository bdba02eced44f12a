//! A fixed-size matrix.

use std::ops::{Add, AddAssign, Index, IndexMut, Mul, Sub};

use crate::Vector;

/// An `R` x `C` matrix, stored by rows.
///
/// ```
/// use clench_screw::{Mat, Vector};
/// let a = Mat::new([[1.0, 2.0], [3.0, 4.0]]);
/// assert_eq!(a * Vector::new([1.0, 1.0]), Vector::new([3.0, 7.0]));
/// assert_eq!(a * Mat::IDENTITY, a);
/// assert_eq!(a.transpose()[0][1], 3.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mat<const R: usize, const C: usize>([[f64; C]; R]);

impl<const R: usize, const C: usize> Mat<R, C> {
    /// The zero matrix.
    pub const ZERO: Self = Self([[0.0; C]; R]);

    /// The matrix with the given rows.
    #[must_use]
    pub const fn new(rows: [[f64; C]; R]) -> Self {
        Self(rows)
    }

    /// The matrix whose entry in row `i` and column `j` is `entry(i, j)`.
    #[must_use]
    pub fn from_fn(mut entry: impl FnMut(usize, usize) -> f64) -> Self {
        Self(std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))))
    }

    /// The rows as plain arrays.
    #[must_use]
    pub const fn rows(&self) -> &[[f64; C]; R] {
        &self.0
    }

    /// Column `j`.
    #[must_use]
    pub fn column(&self, j: usize) -> Vector<R> {
        Vector::from_fn(|i| self.0[i][j])
    }

    /// The transposed matrix.
    #[must_use]
    pub fn transpose(&self) -> Mat<C, R> {
        Mat::from_fn(|i, j| self.0[j][i])
    }

    /// `a b^T`.
    #[must_use]
    pub fn outer(a: Vector<R>, b: Vector<C>) -> Self {
        Self::from_fn(|i, j| a[i] * b[j])
    }

    /// The largest magnitude of an entry.
    #[must_use]
    pub fn max_abs(&self) -> f64 {
        self.0.iter().flatten().fold(0.0, |largest, x| largest.max(x.abs()))
    }

    /// Whether each entry is a finite number.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.0.iter().flatten().all(|x| x.is_finite())
    }
}

impl<const N: usize> Mat<N, N> {
    /// The identity.
    pub const IDENTITY: Self = {
        let mut rows = [[0.0; N]; N];
        let mut i = 0;
        while i < N {
            rows[i][i] = 1.0;
            i += 1;
        }
        Self(rows)
    };

    /// The sum of the diagonal.
    #[must_use]
    pub fn trace(&self) -> f64 {
        (0..N).map(|i| self.0[i][i]).sum()
    }

    /// The symmetric part, `(A + A^T) / 2`.
    #[must_use]
    pub fn symmetric_part(&self) -> Self {
        Self::from_fn(|i, j| 0.5 * self.0[i][j] + 0.5 * self.0[j][i])
    }
}

impl<const R: usize, const C: usize> From<[[f64; C]; R]> for Mat<R, C> {
    fn from(rows: [[f64; C]; R]) -> Self {
        Self(rows)
    }
}

impl<const R: usize, const C: usize> Index<usize> for Mat<R, C> {
    type Output = [f64; C];
    fn index(&self, i: usize) -> &[f64; C] {
        &self.0[i]
    }
}

impl<const R: usize, const C: usize> IndexMut<usize> for Mat<R, C> {
    fn index_mut(&mut self, i: usize) -> &mut [f64; C] {
        &mut self.0[i]
    }
}

impl<const R: usize, const C: usize> Add for Mat<R, C> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::from_fn(|i, j| self.0[i][j] + other.0[i][j])
    }
}

impl<const R: usize, const C: usize> AddAssign for Mat<R, C> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const R: usize, const C: usize> Sub for Mat<R, C> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::from_fn(|i, j| self.0[i][j] - other.0[i][j])
    }
}

impl<const R: usize, const C: usize> Mul<f64> for Mat<R, C> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self::from_fn(|i, j| self.0[i][j] * factor)
    }
}

impl<const R: usize, const C: usize> Mul<Vector<C>> for Mat<R, C> {
    type Output = Vector<R>;
    fn mul(self, v: Vector<C>) -> Vector<R> {
        Vector::from_fn(|i| (0..C).map(|j| self.0[i][j] * v[j]).sum())
    }
}

impl<const R: usize, const K: usize, const C: usize> Mul<Mat<K, C>> for Mat<R, K> {
    type Output = Mat<R, C>;
    fn mul(self, other: Mat<K, C>) -> Mat<R, C> {
        Mat::from_fn(|i, j| (0..K).map(|k| self.0[i][k] * other.0[k][j]).sum())
    }
}
