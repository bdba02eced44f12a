//! How far a body reaches: which of its points something moves most.

use clench_screw::{Mat, Twist, Vector};

use crate::{Ellipsoid, ExtremePoints, Farthest, Polygon, Polyhedron};

/// What decides how far a body reaches: its extreme points, or that it is an ellipsoid.
///
/// Made from a reference to a [`Polygon`], a [`Polyhedron`], an [`Ellipsoid`] or [`ExtremePoints`]
/// of one's own.
///
/// ```
/// use clench_screw::{Vector, planar::Twist};
/// use clench_shape::{Extent, Polygon};
/// let square = Polygon::new(&[[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0]])?;
/// // A turn about (-1, 0) moves the corner (3, 3) most.
/// let turn = Twist { linear: Vector::ZERO, angular: [1.0].into() };
/// let fastest = Extent::from(&square).fastest(Vector::new([-1.0, 0.0]), &turn);
/// assert_eq!((fastest.corner, fastest.value), (Some(2), 5.0));
/// # Ok::<(), clench_shape::PolygonError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent<'a, const N: usize> {
    /// The hull of points.
    Points(&'a ExtremePoints<N>),
    /// An ellipse or ellipsoid.
    Ellipsoid(&'a Ellipsoid<N>),
}

impl<const N: usize> Extent<'_, N> {
    /// The point that `twist`, written about `origin`, moves most, and how far it moves it: the
    /// *deflection* of the body (length per unit of the twist) [LBR, section 4].
    ///
    /// For a unit rotation it is the root of `rho_max^2 + h^2`, with the pitch `h` and the largest
    /// distance `rho_max` from the axis.
    #[must_use]
    pub fn fastest<const M: usize>(&self, origin: Vector<N>, twist: &Twist<N, M>) -> Farthest<N> {
        let gradient = twist.velocity_gradient();
        self.image(origin, twist.linear, &gradient, twist.angular.scaled_norm())
    }

    /// The point farthest from `point`, and its distance (length).
    #[must_use]
    pub fn farthest(&self, point: Vector<N>) -> Farthest<N> {
        self.image(point, Vector::ZERO, &Mat::<N, N>::IDENTITY, 1.0)
    }

    /// The point `x` at which `|offset + map (x - origin)|` is largest, and that length.
    ///
    /// Cost: on points that of [`ExtremePoints::farthest_by`], on an ellipsoid O(1).
    #[must_use]
    pub fn farthest_image<const R: usize>(
        &self,
        origin: Vector<N>,
        offset: Vector<R>,
        map: &Mat<R, N>,
    ) -> Farthest<N> {
        self.image(origin, offset, map, frobenius(map))
    }

    /// All points `x` where `|offset + map (x - origin)|` is as large as it gets, to the part
    /// `within`; `None` on an ellipsoid where they form a curve.
    #[must_use]
    pub fn all_farthest<const R: usize>(
        &self,
        origin: Vector<N>,
        offset: Vector<R>,
        map: &Mat<R, N>,
        within: f64,
    ) -> Option<Vec<Vector<N>>> {
        match self {
            Self::Points(extremes) => {
                let length = |x: Vector<N>| (offset + *map * (x - origin)).norm();
                let largest = self.farthest_image(origin, offset, map).value * (1.0 - within);
                let points = extremes.points().iter().copied();
                Some(points.filter(|&x| length(x) >= largest).collect())
            }
            Self::Ellipsoid(body) => body.all_farthest(origin, offset, map, within),
        }
    }

    /// All points that `twist`, written about `origin`, moves as far as any, to the part `within`;
    /// `None` on an ellipsoid where they form a curve.
    #[must_use]
    pub fn all_fastest<const M: usize>(
        &self,
        origin: Vector<N>,
        twist: &Twist<N, M>,
        within: f64,
    ) -> Option<Vec<Vector<N>>> {
        self.all_farthest(origin, twist.linear, &twist.velocity_gradient(), within)
    }

    /// [`Self::farthest_image`], where no vector grows by more than `growth`.
    fn image<const R: usize>(
        &self,
        origin: Vector<N>,
        offset: Vector<R>,
        map: &Mat<R, N>,
        growth: f64,
    ) -> Farthest<N> {
        match self {
            Self::Points(extremes) => {
                let image = |x: Vector<N>| offset + *map * (x - origin);
                extremes.farthest_by(growth, |x, _| image(x).norm_squared())
            }
            Self::Ellipsoid(body) => body.farthest_image(origin, offset, map),
        }
    }
}

/// The root of the sum of the squares of the entries: no vector grows by more.
fn frobenius<const R: usize, const C: usize>(map: &Mat<R, C>) -> f64 {
    map.rows().iter().flatten().map(|x| x * x).sum::<f64>().sqrt()
}

impl<'a> From<&'a Polygon> for Extent<'a, 2> {
    fn from(outline: &'a Polygon) -> Self {
        Self::Points(outline.extreme_points())
    }
}

impl<'a> From<&'a Polyhedron> for Extent<'a, 3> {
    fn from(solid: &'a Polyhedron) -> Self {
        Self::Points(solid.extreme_points())
    }
}

impl<'a, const N: usize> From<&'a ExtremePoints<N>> for Extent<'a, N> {
    fn from(extremes: &'a ExtremePoints<N>) -> Self {
        Self::Points(extremes)
    }
}

impl<'a, const N: usize> From<&'a Ellipsoid<N>> for Extent<'a, N> {
    fn from(body: &'a Ellipsoid<N>) -> Self {
        Self::Ellipsoid(body)
    }
}
