//! The Cholesky factorisation of a small positive definite matrix.

use crate::{Mat, ScrewError, Vector};

/// A pivot counts as positive above this many units of rounding of its diagonal entry, per row.
///
/// The pivot of row `j` is `a_jj` less `j` squares whose sum is at most `a_jj`; each of the at
/// most `2 N` operations errs by half a unit of `a_jj`, and `a_jj` itself is a rounded sum of
/// products, for which we grant as much again.
const PIVOT_ROUNDING: f64 = 2.0 * f64::EPSILON;

/// `A = L L^T` of a symmetric positive definite `N` x `N` matrix; reads its lower triangle.
///
/// ```
/// use clench_screw::{Cholesky, Mat, Vector};
/// let a = Mat::new([[4.0, 2.0], [2.0, 5.0]]);
/// assert_eq!(Cholesky::new(&a)?.solve(Vector::new([8.0, 12.0])), Vector::new([1.0, 2.0]));
/// # Ok::<(), clench_screw::ScrewError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cholesky<const N: usize> {
    lower: Mat<N, N>,
}

impl<const N: usize> Cholesky<N> {
    /// Factorizes `a`.
    ///
    /// # Errors
    ///
    /// [`ScrewError::NotPositiveDefinite`] when a pivot does not exceed the rounding error of its
    /// diagonal entry; that covers entries that are not numbers. The decision does not depend on
    /// the unit of `a`, nor on the units of its single rows.
    pub fn new(a: &Mat<N, N>) -> Result<Self, ScrewError> {
        let mut lower = Mat::ZERO;
        for j in 0..N {
            let squares: f64 = (0..j).map(|k| lower[j][k] * lower[j][k]).sum();
            let diagonal = a[j][j];
            let value = diagonal - squares;
            let floor = PIVOT_ROUNDING * N as f64 * diagonal;
            if !(value > floor && value.is_finite()) {
                return Err(ScrewError::NotPositiveDefinite { pivot: j, value, diagonal });
            }
            lower[j][j] = value.sqrt();
            for i in j + 1..N {
                let products: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
                lower[i][j] = (a[i][j] - products) / lower[j][j];
            }
        }
        Ok(Self { lower })
    }

    /// The solution `x` of `A x = b`.
    #[must_use]
    pub fn solve(&self, b: Vector<N>) -> Vector<N> {
        let l = &self.lower;
        let mut x = b;
        for i in 0..N {
            let known: f64 = (0..i).map(|k| l[i][k] * x[k]).sum();
            x[i] = (x[i] - known) / l[i][i];
        }
        for i in (0..N).rev() {
            let known: f64 = (i + 1..N).map(|k| l[k][i] * x[k]).sum();
            x[i] = (x[i] - known) / l[i][i];
        }
        x
    }

    /// The solution `X` of `A X = B`.
    #[must_use]
    pub fn solve_mat<const C: usize>(&self, b: &Mat<N, C>) -> Mat<N, C> {
        let columns: [Vector<N>; C] = std::array::from_fn(|j| self.solve(b.column(j)));
        Mat::from_fn(|i, j| columns[j][i])
    }

    /// `A^-1`, exactly symmetric.
    #[must_use]
    pub fn inverse(&self) -> Mat<N, N> {
        self.solve_mat(&Mat::IDENTITY).symmetric_part()
    }
}
