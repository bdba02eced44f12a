//! What can go wrong in this crate.

/// Why a matrix could not be factorized.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ScrewError {
    /// The matrix is not positive definite to working precision.
    #[error(
        "matrix is not positive definite: pivot {pivot} is {value:e}, \
         but has to exceed the rounding error of the diagonal entry {diagonal:e}"
    )]
    NotPositiveDefinite {
        /// The first row whose pivot is not positive.
        pivot: usize,
        /// The pivot that was found.
        value: f64,
        /// The diagonal entry of that row, the scale to judge the pivot by.
        diagonal: f64,
    },
    /// An entry is infinite or not a number.
    #[error("matrix entry in row {row}, column {column} is {value}, not a finite number")]
    NotFinite {
        /// The row of the first such entry.
        row: usize,
        /// Its column.
        column: usize,
        /// What was found.
        value: f64,
    },
}
