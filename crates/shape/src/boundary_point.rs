//! A place on a body's surface, with what a contact there must know.

use clench_screw::{Mat, Vector};

/// A point of a body's boundary, with the direction and the curvature of the boundary there.
///
/// All in one frame, that of the body it was asked of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundaryPoint<const N: usize> {
    /// The point (length).
    pub point: Vector<N>,
    /// The unit normal `n` that points into the body.
    pub inward_normal: Vector<N>,
    /// How the outward normal turns as the point moves along the boundary (1/length): symmetric,
    /// with null vector `n`, positive for convex bodies, 0 where the boundary is flat.
    ///
    /// Its other eigenvalues are the principal curvatures; in the plane there is one.
    pub shape_operator: Mat<N, N>,
}

/// The boundary point of a body that is nearest to some point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest<const N: usize> {
    /// The nearest point of the boundary.
    pub boundary: BoundaryPoint<N>,
    /// The distance to it (length): positive outside the body, negative inside.
    pub signed_distance: f64,
}
