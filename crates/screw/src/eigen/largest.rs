//! The largest eigenvalue alone.

use crate::spatial::cross;
use crate::{Mat, ScrewError, SymmetricEigen, Vector};

/// More steps are needed only near a double root.
const MAX_STEPS: usize = 8;

/// A last step of this part of the root is rounding.
const ARRIVED: f64 = 8.0 * f64::EPSILON;

/// The least slope at the root, in units of its square: the inverse multiplies the rounding.
const LEAST_SLOPE: f64 = 1.0 / 32.0;

/// Beside a product of three entries, its roundings have to be in the range of numbers too.
const ROUNDING: f64 = f64::EPSILON;

impl<const N: usize> SymmetricEigen<N> {
    /// The largest eigenvalue of the symmetric part of `a`, if none is negative: within about a
    /// hundred units of rounding, in less than half of the time of a decomposition unless another
    /// is near it.
    ///
    /// ```
    /// use clench_screw::{Mat, SymmetricEigen};
    /// let largest = SymmetricEigen::largest_value(&Mat::new([[2.0, 1.0], [1.0, 2.0]]))?;
    /// assert!((largest - 3.0).abs() < 1e-15);
    /// # Ok::<(), clench_screw::ScrewError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As [`SymmetricEigen::new`].
    pub fn largest_value(a: &Mat<N, N>) -> Result<f64, ScrewError> {
        let a = &a.symmetric_part();
        let size = a.trace();
        let in_range = (size * size * size * ROUNDING).is_normal();
        let quick = match N {
            2 if in_range => Some(of_two(a)),
            3 if in_range => of_three(&Mat::from_fn(|i, j| a[i][j])),
            _ => None,
        };
        match quick {
            Some(value) if value.is_finite() => Ok(value),
            _ => Self::beside_largest(a).map(|eigen| eigen.values[N - 1]),
        }
    }
}

fn of_two<const N: usize>(a: &Mat<N, N>) -> f64 {
    let [mean, half] = [1.0, -1.0].map(|sign| 0.5 * (a[0][0] + sign * a[1][1]));
    mean + (half * half + a[0][1] * a[0][1]).sqrt()
}

/// By Newton's method for the characteristic polynomial; `None` where digits would be lost.
///
/// From above the steps never pass the root. They start where the root is if the other two
/// eigenvalues are equal: `t / 3 + sqrt(2 / 3 (s - t^2 / 3))` with the trace `t` and the sum `s` of
/// the squares of the entries.
fn of_three(a: &Mat<3, 3>) -> Option<f64> {
    let [x, y, z] = [0, 1, 2].map(|i| Vector::new(a[i]));
    let (minors, determinant) = ([cross(y, z), cross(z, x), cross(x, y)], x.dot(cross(y, z)));
    let (trace, sum) = (a.trace(), minors[0][0] + minors[1][1] + minors[2][2]);
    // s - t^2 / 3 = 2 (t^2 / 3 - m) with the sum m of the principal minors.
    let spread = (trace * trace / 3.0 - sum).max(0.0);
    let mut root = trace / 3.0 + 2.0 / 3.0 * (3.0 * spread).sqrt();
    for _ in 0..MAX_STEPS {
        let value = ((root - trace) * root + sum) * root - determinant;
        let slope = (3.0 * root - 2.0 * trace) * root + sum;
        let step = value / slope;
        root -= step;
        if step.abs() <= ARRIVED * root {
            return (slope >= LEAST_SLOPE * root * root).then_some(root);
        }
    }
    None
}
