//! Convex bodies given by points.

use clench_screw::{Frame, Vector};

use crate::BodyError;

/// The convex hull of points: a convex polygon (`N` = 2) or polytope (`N` = 3).
///
/// The points may be in any order, and not all need be extreme. One point, or points on a line or
/// in a plane, are fine.
///
/// ```
/// use clench_shape::PointHull;
/// let triangle = PointHull::new(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]])?;
/// assert_eq!(triangle.points().len(), 3);
/// # Ok::<(), clench_shape::BodyError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PointHull<const N: usize> {
    points: Vec<Vector<N>>,
}

impl<const N: usize> PointHull<N> {
    /// The hull of `points` (length).
    ///
    /// # Errors
    ///
    /// [`BodyError::NoPoints`] and [`BodyError::PointOutOfRange`].
    pub fn new(points: &[[f64; N]]) -> Result<Self, BodyError> {
        Ok(Self { points: BodyError::checked_points(points)? })
    }

    /// The hull given in the frame `pose`, written in the parent of `pose`.
    #[must_use]
    pub fn placed<const M: usize>(&self, pose: &Frame<N, M>) -> Self {
        Self { points: self.points.iter().map(|&point| pose.point_to_parent(point)).collect() }
    }

    /// The points, in the order given.
    #[must_use]
    pub fn points(&self) -> &[Vector<N>] {
        &self.points
    }
}
