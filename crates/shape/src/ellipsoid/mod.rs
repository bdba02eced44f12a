//! Ellipses and ellipsoids.

mod bending;
mod error;
mod farthest;
mod nearest;
mod secular;

use clench_screw::{Frame, Mat, Vector};

use crate::{BoundaryPoint, LARGEST_COORDINATE, Nearest, SMALLEST_COORDINATE};

pub use error::EllipsoidError;

/// The largest quotient of two semi-axes.
///
/// A curvature is at most `aspect / shortest`, so at most 1e230; its products with lengths of the
/// body stay below the largest double, 1.8e308.
pub const LARGEST_ASPECT: f64 = 1e100;

/// An ellipse (`N` = 2) or ellipsoid (`N` = 3): round or flat, anywhere, turned any way.
///
/// Made with its axes along those of the frame it is given in; [`Ellipsoid::placed`] turns it.
///
/// ```
/// use clench_shape::Ellipsoid;
/// let ellipse = Ellipsoid::new([10.0, 0.0].into(), [2.0, 1.0])?;
/// let tip = ellipse.at_normal([5.0, 0.0].into())?;
/// assert_eq!(tip.point.to_array(), [12.0, 0.0]);
/// assert_eq!(tip.inward_normal.to_array(), [-1.0, 0.0]);
/// // The curvature at the tip is a / b^2.
/// assert_eq!(tip.shape_operator[1][1], 2.0);
/// # Ok::<(), clench_shape::EllipsoidError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid<const N: usize> {
    center: Vector<N>,
    semi_axes: [f64; N],
    axes: Mat<N, N>,
}

impl<const N: usize> Ellipsoid<N> {
    /// The ellipsoid about `center` whose semi-axis `i` (length) lies along coordinate axis `i`.
    ///
    /// # Errors
    ///
    /// The variants of [`EllipsoidError`] about the center and the semi-axes, in that order.
    pub fn new(center: Vector<N>, semi_axes: [f64; N]) -> Result<Self, EllipsoidError> {
        check_center(center)?;
        check_semi_axes(semi_axes)?;
        Ok(Self { center, semi_axes, axes: Mat::IDENTITY })
    }

    /// The ellipsoid given in the frame `pose`, written in the parent of `pose`.
    ///
    /// ```
    /// use clench_screw::planar::Frame;
    /// use clench_shape::Ellipsoid;
    /// let quarter = Frame::new([1.0, 0.0], std::f64::consts::FRAC_PI_2);
    /// let upright = Ellipsoid::new([0.0, 0.0].into(), [3.0, 1.0])?.placed(&quarter);
    /// assert!((upright.support([0.0, 1.0].into()) - 3.0).abs() < 1e-15);
    /// # Ok::<(), clench_shape::EllipsoidError>(())
    /// ```
    #[must_use]
    pub fn placed<const M: usize>(&self, pose: &Frame<N, M>) -> Self {
        Self {
            center: pose.point_to_parent(self.center),
            semi_axes: self.semi_axes,
            axes: *pose.axes() * self.axes,
        }
    }

    /// The center.
    #[must_use]
    pub fn center(&self) -> Vector<N> {
        self.center
    }

    /// The semi-axes (length), in the order given.
    #[must_use]
    pub fn semi_axes(&self) -> [f64; N] {
        self.semi_axes
    }

    /// The unit vectors along the semi-axes, as columns.
    #[must_use]
    pub fn axes(&self) -> &Mat<N, N> {
        &self.axes
    }

    /// The largest semi-axis (length): the radius of the smallest ball around the body.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.semi_axes.into_iter().fold(0.0, f64::max)
    }

    /// The support function: the largest `x . direction` over the points `x` of the body.
    ///
    /// `h(m) = c . m + |diag(a) m|`, the second part along the body's axes. A length when
    /// `direction` is of unit length, and proportional to that length.
    #[must_use]
    pub fn support(&self, direction: Vector<N>) -> f64 {
        let along = self.axes.transpose() * direction;
        let stretched = Vector::<N>::from_fn(|i| self.semi_axes[i] * along[i]);
        self.center.dot(direction) + stretched.norm()
    }

    /// The boundary point whose outward normal is along `outward`, a vector of any length.
    ///
    /// # Errors
    ///
    /// [`EllipsoidError::DirectionNotFinite`] and [`EllipsoidError::ZeroDirection`].
    pub fn at_normal(&self, outward: Vector<N>) -> Result<BoundaryPoint<N>, EllipsoidError> {
        let named = (0..N).map(|component| (component, outward[component]));
        if let Some((component, value)) = named.into_iter().find(|(_, value)| !value.is_finite()) {
            return Err(EllipsoidError::DirectionNotFinite { component, value });
        }
        let unit = outward.direction().ok_or(EllipsoidError::ZeroDirection)?;
        Ok(self.boundary(self.axes.transpose() * unit))
    }

    /// The boundary point nearest to `point`, which may be anywhere, and the signed distance.
    ///
    /// `point` is finite, and its coordinates are up to [`LARGEST_COORDINATE`]. The distance is
    /// good to a few roundings of itself, of the smallest semi-axis and of the coordinates of
    /// `point`. Where several boundary points are nearest, as from the center, it is one of them,
    /// always the same.
    ///
    /// ```
    /// use clench_shape::Ellipsoid;
    /// let disk = Ellipsoid::new([0.0, 0.0, 0.0].into(), [5.0, 4.0, 1.0])?;
    /// let above = disk.nearest([0.0, 0.0, 3.0].into());
    /// assert_eq!(above.signed_distance, 2.0);
    /// assert_eq!(above.boundary.point.to_array(), [0.0, 0.0, 1.0]);
    /// assert_eq!(disk.nearest(disk.center()).signed_distance, -1.0);
    /// # Ok::<(), clench_shape::EllipsoidError>(())
    /// ```
    #[must_use]
    pub fn nearest(&self, point: Vector<N>) -> Nearest<N> {
        let from_center = self.axes.transpose() * (point - self.center);
        let foot = nearest::foot(self.semi_axes, from_center);
        let gradient = Vector::<N>::from_fn(|i| foot.direction[i] / self.semi_axes[i]);
        let norm = gradient.scaled_norm();
        Nearest {
            boundary: self.boundary(gradient * (1.0 / norm)),
            signed_distance: foot.steps * norm,
        }
    }

    /// The body with these axes (orthonormal columns), whose semi-axes are positive.
    pub(crate) fn from_parts(center: Vector<N>, semi_axes: [f64; N], axes: Mat<N, N>) -> Self {
        Self { center, semi_axes, axes }
    }

    /// The body seen from `origin`, in units `scale` times as small.
    pub(crate) fn in_units(&self, origin: Vector<N>, scale: f64) -> Self {
        Self {
            center: (self.center - origin) * scale,
            semi_axes: self.semi_axes.map(|axis| axis * scale),
            axes: self.axes,
        }
    }

    /// The boundary point with the outward unit normal `m`, seen from the center.
    pub(crate) fn support_offset(&self, m: Vector<N>) -> Vector<N> {
        let along = self.axes.transpose() * m;
        let stretched = Vector::<N>::from_fn(|i| self.semi_axes[i] * along[i]);
        let h = stretched.scaled_norm();
        self.axes * Vector::from_fn(|i| self.semi_axes[i] * (stretched[i] / h))
    }

    /// How the boundary point moves as the outward unit normal `m` turns (length): the second
    /// derivative of the support function, with null vector `m`.
    pub(crate) fn radii(&self, m: Vector<N>) -> Mat<N, N> {
        let along = self.axes.transpose() * m;
        let stretched = Vector::<N>::from_fn(|i| self.semi_axes[i] * along[i]);
        let h = stretched.scaled_norm();
        let unit = stretched * (1.0 / h);
        // diag(a) (I - u u^T) diag(a) / h with u = diag(a) m / h; the middle is a projection.
        let middle = across(unit);
        let (a, axes) = (self.semi_axes, &self.axes);
        let local = Mat::from_fn(|i, j| a[i] * middle[i][j] * (a[j] / h));
        (*axes * local * axes.transpose()).symmetric_part()
    }

    /// The boundary point with the outward unit normal `m`, given along the body's axes.
    ///
    /// With `A = diag(a^2)` and `h = |diag(a) m|`: the point `A m / h` and the shape operator
    /// `h P A^-1 P`, `P = I - m m^T`.
    fn boundary(&self, m: Vector<N>) -> BoundaryPoint<N> {
        let stretched = Vector::<N>::from_fn(|i| self.semi_axes[i] * m[i]);
        let h = stretched.scaled_norm();
        let from_center = Vector::<N>::from_fn(|i| self.semi_axes[i] * (stretched[i] / h));
        let across = across(m);
        let weighted = Mat::<N, N>::from_fn(|i, j| {
            (0..N)
                .map(|k| across[i][k] * (h / self.semi_axes[k] / self.semi_axes[k]) * across[k][j])
                .sum()
        });
        BoundaryPoint {
            point: self.center + self.axes * from_center,
            inward_normal: -(self.axes * m),
            shape_operator: (self.axes * weighted * self.axes.transpose()).symmetric_part(),
        }
    }
}

/// `I - m m^T` of a unit vector, each diagonal entry as the sum of the squares of the others.
///
/// The plain difference would lose the small curvatures of thin bodies: it errs by a rounding,
/// which is then divided by the square of the smallest semi-axis.
fn across<const N: usize>(m: Vector<N>) -> Mat<N, N> {
    let others = |i: usize| (0..N).filter(|&k| k != i).map(|k| m[k] * m[k]).sum();
    Mat::from_fn(|i, j| if i == j { others(i) } else { -m[i] * m[j] })
}

fn check_center<const N: usize>(center: Vector<N>) -> Result<(), EllipsoidError> {
    for component in 0..N {
        let value = center[component];
        if !value.is_finite() {
            return Err(EllipsoidError::CenterNotFinite { component, value });
        }
        if value.abs() > LARGEST_COORDINATE {
            return Err(EllipsoidError::CenterTooFar { component, value });
        }
    }
    Ok(())
}

fn check_semi_axes<const N: usize>(semi_axes: [f64; N]) -> Result<(), EllipsoidError> {
    for (axis, &value) in semi_axes.iter().enumerate() {
        if !(SMALLEST_COORDINATE..=LARGEST_COORDINATE).contains(&value) {
            return Err(EllipsoidError::SemiAxisOutOfRange { axis, value });
        }
    }
    let (mut long, mut short) = (0, 0);
    for axis in 1..N {
        long = if semi_axes[axis] > semi_axes[long] { axis } else { long };
        short = if semi_axes[axis] < semi_axes[short] { axis } else { short };
    }
    let aspect = semi_axes[long] / semi_axes[short];
    if aspect > LARGEST_ASPECT {
        return Err(EllipsoidError::TooThin { long, short, aspect });
    }
    Ok(())
}
