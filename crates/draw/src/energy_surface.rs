//! The level set of an energy as the affine image of the unit sphere.

use clench_screw::spatial::cross;
use clench_screw::{Cholesky, Mat, ScrewError, SymmetricEigen, Vector};

use crate::error::{DrawError, Input};
use crate::world_map::{UNSEEN, finite};

/// Which energy is drawn, and so which curves of its level set no change of frame alters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnergySpace {
    /// Coordinates `(v_x, v_y, ω)`, matrix `K`: horizontal sections keep their shape, and the
    /// height is the same in all frames [LBR, Fig. 1].
    Twist,
    /// Coordinates `(f_x, f_y, τ)`, matrix `C`: vertical chords keep their length, and the
    /// horizontal projection is the same in all frames [LBR, Fig. 2].
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

/// The ellipsoid `x^T A x = 2` as the image of the unit sphere under a linear map.
///
/// The map is triangular by blocks, so that the sphere's circles of latitude become the
/// curves that matter in each space. Twists: latitude `h` is the section at height
/// `h sqrt(2 / s)`, `s` the Schur complement of the translational block, and the poles touch
/// the bounding planes. Wrenches: the equator touches the vertical cylinder over the
/// horizontal projection, and the poles lie on the vertical axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EnergySurface {
    /// The images of the sphere's axes.
    columns: [Vector<3>; 3],
    /// Rows of the inverse map.
    inverse: [Vector<3>; 3],
}

impl EnergySurface {
    pub(crate) fn new(
        matrix: [[f64; 3]; 3],
        space: EnergySpace,
        input: Input,
    ) -> Result<Self, DrawError> {
        check_entries(matrix, input)?;
        // The order of elimination: the block that the space divides by comes first.
        let order = match space {
            EnergySpace::Twist => [0, 1, 2],
            EnergySpace::Wrench => [2, 0, 1],
        };
        let factors = Cholesky::new(&Mat::from_fn(|i, j| matrix[order[i]][order[j]]))
            .map_err(|fault| not_positive_definite(&fault, input))?;
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = matrix;
        let columns = match space {
            EnergySpace::Twist => {
                let [a, b] = semi_axes([[xx, xy], [xy, yy]]);
                // Highest where the gradient is vertical.
                let top = factors.solve(Vector::new([0.0, 0.0, 1.0]));
                [[a[0], a[1], 0.0].into(), [b[0], b[1], 0.0].into(), top * (2.0 / top[2]).sqrt()]
            }
            EnergySpace::Wrench => {
                let tilt = [-xz / zz, -yz / zz];
                let across = xy + xz * tilt[1];
                let projected = [[xx + xz * tilt[0], across], [across, yy + yz * tilt[1]]];
                let [a, b] = semi_axes(projected)
                    .map(|axis| [axis[0], axis[1], tilt[0] * axis[0] + tilt[1] * axis[1]].into());
                [a, b, Vector::new([0.0, 0.0, (2.0 / zz).sqrt()])]
            }
        };
        Ok(Self::of(columns))
    }

    fn of(columns: [Vector<3>; 3]) -> Self {
        let [a, b, c] = columns;
        let volume = a.dot(cross(b, c));
        let inverse = [cross(b, c), cross(c, a), cross(a, b)].map(|row| row * (1.0 / volume));
        Self { columns, inverse }
    }

    /// The image of a point of the unit sphere: it satisfies `x^T A x = 2`.
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

    /// The matrix `A / 2`, rebuilt from the map.
    pub(crate) fn half_matrix(&self) -> Mat<3, 3> {
        Mat::from_fn(|i, j| self.inverse.iter().map(|row| row[i] * row[j]).sum())
    }

    /// The same surface with each coordinate multiplied by a factor.
    pub(crate) fn scaled(&self, factors: [f64; 3]) -> Self {
        Self::of(self.columns.map(|column| Vector::from_fn(|i| column[i] * factors[i])))
    }
}

fn check_entries(matrix: [[f64; 3]; 3], input: Input) -> Result<(), DrawError> {
    for (index, &value) in matrix.as_flattened().iter().enumerate() {
        finite(value, input, index)?;
    }
    for (row, column) in [(0, 1), (0, 2), (1, 2)] {
        let difference = matrix[row][column] - matrix[column][row];
        let size = (matrix[row][row].abs() * matrix[column][column].abs()).sqrt();
        if difference.abs() > UNSEEN * size {
            return Err(DrawError::NotSymmetric { input, row, column, difference });
        }
    }
    Ok(())
}

/// The semi-axes of the ellipse `x^T S x = 2` of a positive definite matrix, the shorter first.
fn semi_axes(matrix: [[f64; 2]; 2]) -> [Vector<2>; 2] {
    #[expect(clippy::expect_used, reason = "entries were checked, or bounded by checked ones")]
    let eigen = SymmetricEigen::new(&matrix.into()).expect("entries are finite");
    [1, 0].map(|i| eigen.vectors[i] * (2.0 / eigen.values[i]).sqrt())
}

fn not_positive_definite(fault: &ScrewError, input: Input) -> DrawError {
    match *fault {
        ScrewError::NotPositiveDefinite { pivot, value, .. } => {
            DrawError::NotPositiveDefinite { input, pivot, value }
        }
        _ => unreachable!("the entries are finite"),
    }
}

fn unit(a: Vector<3>) -> Vector<3> {
    a * (1.0 / a.norm())
}

#[cfg(test)]
mod tests;
