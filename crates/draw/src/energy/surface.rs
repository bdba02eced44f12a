//! The level set of an energy as the affine image of the unit sphere.

use std::f64::consts::FRAC_1_SQRT_2;

use clench_screw::spatial::cross;
use clench_screw::{Mat, Vector};

use crate::error::{DrawError, Input};
use crate::world_map::{UNSEEN, finite};

/// Which energy is drawn, and so which curves of its surface no shift of the frame alters.
///
/// An ellipsoid is told by three of its points, which are the images of the axes of the unit
/// sphere under a linear map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnergySpace {
    /// The surface `q^T K q = 2` in coordinates `(v_x, v_y, ω)`: horizontal sections keep their
    /// shape, and the height is the same in all frames [LBR, Fig. 1].
    ///
    /// Its points: on the two semi-axes of the section without rotation, and the highest.
    Twist,
    /// The surface `w^T C w = 2` in coordinates `(f_x, f_y, τ)`: vertical chords keep their
    /// length, and the horizontal projection is the same in all frames [LBR, Fig. 2].
    ///
    /// Its points: over the two semi-axes of the projection, and that without force.
    Wrench,
}

/// An ellipse in space: `center + axes[0] cos t + axes[1] sin t`, with two conjugate
/// half-diameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpaceEllipse {
    pub(crate) center: Vector<3>,
    pub(crate) axes: [Vector<3>; 2],
}

impl SpaceEllipse {
    /// The point at an angle in radians.
    pub(crate) fn point(&self, angle: f64) -> Vector<3> {
        let (sin, cos) = angle.sin_cos();
        self.center + self.axes[0] * cos + self.axes[1] * sin
    }
}

/// An ellipsoid about the origin as the image of the unit sphere under a linear map.
///
/// The map is triangular by blocks, so that the sphere's circles of latitude become the
/// curves that matter in each space. Twists: latitude `h` is the section at `h` times the height
/// of the pole, and the poles touch the bounding planes. Wrenches: the equator touches the
/// vertical cylinder over the horizontal projection, and the poles lie on the vertical axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EnergySurface {
    /// The images of the sphere's axes.
    columns: [Vector<3>; 3],
    /// Rows of the inverse map.
    inverse: [Vector<3>; 3],
}

impl EnergySurface {
    /// The surface through the images of the sphere's axes, which are checked.
    pub(crate) fn new(
        points: [[f64; 3]; 3],
        space: EnergySpace,
        input: Input,
    ) -> Result<Self, DrawError> {
        for (index, point) in points.iter().enumerate() {
            point.iter().try_for_each(|&value| finite(value, input, index).map(|_| ()))?;
        }
        check_triangular(&points, space, input)?;
        check_semi_axes(&points, input)?;
        let [a, b, pole] = points.map(Vector::new);
        // The surface holds the opposite of each point too; the pole is the upper one.
        Ok(Self::of([a, b, pole * pole[2].signum()]))
    }

    fn of(columns: [Vector<3>; 3]) -> Self {
        let [a, b, c] = columns;
        let volume = a.dot(cross(b, c));
        let inverse = [cross(b, c), cross(c, a), cross(a, b)].map(|row| row * (1.0 / volume));
        Self { columns, inverse }
    }

    /// The image of a point of the unit sphere.
    pub(crate) fn point(&self, sphere: Vector<3>) -> Vector<3> {
        let [a, b, c] = self.columns;
        a * sphere[0] + b * sphere[1] + c * sphere[2]
    }

    /// The images of the sphere's axes: two semi-axes of the invariant ellipse and the pole.
    pub(crate) fn columns(&self) -> [Vector<3>; 3] {
        self.columns
    }

    /// The half-width of the ellipsoid along each coordinate.
    pub(crate) fn half_extents(&self) -> [f64; 3] {
        let [a, b, c] = self.columns;
        [0, 1, 2].map(|i| a[i].hypot(b[i]).hypot(c[i]))
    }

    /// Lengths that no shift of the frame alters: three half-widths of the invariant ellipse,
    /// which no other ellipse shares, and the height of the pole.
    pub(crate) fn invariants(&self) -> [f64; 4] {
        let [a, b, pole] = self.columns;
        let along = |x: f64, y: f64| (a[0] * x + a[1] * y).hypot(b[0] * x + b[1] * y);
        [along(1.0, 0.0), along(0.0, 1.0), along(FRAC_1_SQRT_2, FRAC_1_SQRT_2), pole[2]]
    }

    /// The semi-axes of the invariant ellipse, the shorter first.
    pub(crate) fn semi_axes(&self) -> [f64; 2] {
        let [a, b, _] = self.columns;
        let (a, b) = (a[0].hypot(a[1]), b[0].hypot(b[1]));
        [a.min(b), a.max(b)]
    }

    /// The image of the circle at this height on the sphere, from -1 to 1.
    pub(crate) fn latitude(&self, height: f64) -> SpaceEllipse {
        let radius = (1.0 - height * height).max(0.0).sqrt();
        let [a, b, pole] = self.columns;
        SpaceEllipse { center: pole * height, axes: [a * radius, b * radius] }
    }

    /// The image of the great circle through the poles at this longitude, in radians.
    pub(crate) fn meridian(&self, longitude: f64) -> SpaceEllipse {
        let (sin, cos) = longitude.sin_cos();
        let across = self.point(Vector::new([cos, sin, 0.0]));
        SpaceEllipse { center: Vector::ZERO, axes: [across, self.columns[2]] }
    }

    /// The curve where lines of sight along this direction touch the ellipsoid.
    pub(crate) fn silhouette(&self, direction: Vector<3>) -> SpaceEllipse {
        let sight = unit(self.sphere_point(direction));
        // Any axis well away from the line of sight spans the plane across it.
        let far = if sight[2].abs() < 0.6 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
        let first = unit(cross(sight, far.into()));
        let second = cross(sight, first);
        SpaceEllipse { center: Vector::ZERO, axes: [self.point(first), self.point(second)] }
    }

    /// The point, or direction, in the coordinates in which the ellipsoid is the unit sphere.
    pub(crate) fn sphere_point(&self, point: Vector<3>) -> Vector<3> {
        Vector::new(self.inverse.map(|row| row.dot(point)))
    }

    /// The matrix of the form that is 1 on the surface.
    pub(crate) fn half_matrix(&self) -> Mat<3, 3> {
        Mat::from_fn(|i, j| self.inverse.iter().map(|row| row[i] * row[j]).sum())
    }

    /// The same surface with each coordinate multiplied by a factor.
    pub(crate) fn scaled(&self, factors: [f64; 3]) -> Self {
        Self::of(self.columns.map(|column| Vector::from_fn(|i| column[i] * factors[i])))
    }
}

/// Sections are horizontal and the wrench's pole is vertical: the other coordinates have to be 0.
fn check_triangular(
    points: &[[f64; 3]; 3],
    space: EnergySpace,
    input: Input,
) -> Result<(), DrawError> {
    let [a, b, pole] = points;
    let (zeros, size): (&[(usize, usize)], f64) = match space {
        EnergySpace::Twist => (&[(0, 2), (1, 2)], pole[2].abs()),
        EnergySpace::Wrench => (&[(2, 0), (2, 1)], a[0].hypot(a[1]).max(b[0].hypot(b[1]))),
    };
    for &(point, coordinate) in zeros {
        let value = points[point][coordinate];
        if value.abs() > UNSEEN * size {
            return Err(DrawError::NotTriangular { input, point, coordinate, value });
        }
    }
    Ok(())
}

/// The first two points lie over the semi-axes of an ellipse, and the third is off the floor.
fn check_semi_axes(points: &[[f64; 3]; 3], input: Input) -> Result<(), DrawError> {
    let [a, b, pole] = points;
    let length_a = finite(a[0].hypot(a[1]), input, 0)?;
    let length_b = finite(b[0].hypot(b[1]), input, 1)?;
    for (point, length, other) in [(0, length_a, length_b), (1, length_b, length_a)] {
        if length <= UNSEEN * other {
            return Err(DrawError::Flat { input, point });
        }
    }
    if pole[2] == 0.0 {
        return Err(DrawError::Flat { input, point: 2 });
    }
    let cosine = a[0] / length_a * (b[0] / length_b) + a[1] / length_a * (b[1] / length_b);
    if cosine.abs() > UNSEEN {
        return Err(DrawError::NotSemiAxes { input, cosine });
    }
    Ok(())
}

fn unit(a: Vector<3>) -> Vector<3> {
    a * (1.0 / a.norm())
}

#[cfg(test)]
mod tests;
