//! The level set of an energy as the affine image of the unit sphere.

use crate::error::{DrawError, Place};

/// How large an asymmetry may be against the diagonal: below what a picture shows.
const SYMMETRY_TOLERANCE: f64 = 1e-6;

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

/// An ellipse in space: `center + axes[0] cos t + axes[1] sin t`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpaceEllipse {
    /// The center.
    pub center: [f64; 3],
    /// Two conjugate half-diameters.
    pub axes: [[f64; 3]; 2],
}

impl SpaceEllipse {
    /// The point at an angle in radians.
    #[must_use]
    pub fn point(&self, angle: f64) -> [f64; 3] {
        let (sin, cos) = angle.sin_cos();
        [0, 1, 2].map(|i| self.center[i] + cos * self.axes[0][i] + sin * self.axes[1][i])
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
pub struct EnergySurface {
    /// The images of the sphere's axes.
    columns: [[f64; 3]; 3],
    /// Rows of the inverse map.
    inverse: [[f64; 3]; 3],
}

impl EnergySurface {
    pub(crate) fn new(
        matrix: [[f64; 3]; 3],
        space: EnergySpace,
        place: Place,
    ) -> Result<Self, DrawError> {
        check_entries(matrix, place)?;
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = matrix;
        let columns = match space {
            EnergySpace::Twist => {
                let planar = [[xx, xy], [xy, yy]];
                let [a, b] = semi_axes(planar, [0, 1], place)?;
                let lean = solve(planar, [xz, yz]);
                let schur = pivot(zz - xz * lean[0] - yz * lean[1], 2, place)?;
                let height = (2.0 / schur).sqrt();
                let pole = [-lean[0] * height, -lean[1] * height, height];
                [[a[0], a[1], 0.0], [b[0], b[1], 0.0], pole]
            }
            EnergySpace::Wrench => {
                pivot(zz, 0, place)?;
                let tilt = [-xz / zz, -yz / zz];
                let across = xy + xz * tilt[1];
                let projected = [[xx + xz * tilt[0], across], [across, yy + yz * tilt[1]]];
                let [a, b] = semi_axes(projected, [1, 2], place)?
                    .map(|[x, y]| [x, y, tilt[0] * x + tilt[1] * y]);
                [a, b, [0.0, 0.0, (2.0 / zz).sqrt()]]
            }
        };
        Ok(Self::of(columns))
    }

    fn of(columns: [[f64; 3]; 3]) -> Self {
        let [a, b, c] = columns;
        let volume = dot(a, cross(b, c));
        let inverse =
            [cross(b, c), cross(c, a), cross(a, b)].map(|row| row.map(|value| value / volume));
        Self { columns, inverse }
    }

    /// The image of a point of the unit sphere: it satisfies `x^T A x = 2`.
    #[must_use]
    pub fn point(&self, sphere: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.columns;
        [0, 1, 2].map(|i| a[i] * sphere[0] + b[i] * sphere[1] + c[i] * sphere[2])
    }

    /// The images of the sphere's axes: two semi-axes of the invariant ellipse and the pole.
    #[must_use]
    pub fn columns(&self) -> [[f64; 3]; 3] {
        self.columns
    }

    /// The half-width of the ellipsoid along each coordinate.
    #[must_use]
    pub fn half_extents(&self) -> [f64; 3] {
        let [a, b, c] = self.columns;
        [0, 1, 2].map(|i| a[i].hypot(b[i]).hypot(c[i]))
    }

    /// The image of the circle at this height on the sphere, from -1 to 1.
    #[must_use]
    pub fn latitude(&self, height: f64) -> SpaceEllipse {
        let radius = (1.0 - height * height).max(0.0).sqrt();
        let [a, b, pole] = self.columns;
        SpaceEllipse {
            center: pole.map(|value| height * value),
            axes: [a.map(|value| radius * value), b.map(|value| radius * value)],
        }
    }

    /// The image of the great circle through the poles at this longitude, in radians.
    #[must_use]
    pub fn meridian(&self, longitude: f64) -> SpaceEllipse {
        let (sin, cos) = longitude.sin_cos();
        SpaceEllipse { center: [0.0; 3], axes: [self.point([cos, sin, 0.0]), self.columns[2]] }
    }

    /// The curve where lines of sight along this direction touch the ellipsoid.
    #[must_use]
    pub fn silhouette(&self, direction: [f64; 3]) -> SpaceEllipse {
        let sight = unit(self.sphere_point(direction));
        // Any axis well away from the line of sight spans the plane across it.
        let far = if sight[2].abs() < 0.6 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
        let first = unit(cross(sight, far));
        let second = cross(sight, first);
        SpaceEllipse { center: [0.0; 3], axes: [self.point(first), self.point(second)] }
    }

    /// The point, or direction, in the coordinates in which the ellipsoid is the unit sphere.
    pub(crate) fn sphere_point(&self, point: [f64; 3]) -> [f64; 3] {
        self.inverse.map(|row| dot(row, point))
    }

    /// The matrix `A / 2`, row by row, rebuilt from the map.
    pub(crate) fn half_matrix(&self) -> [[f64; 3]; 3] {
        let entry = |i: usize, j: usize| self.inverse.iter().map(|row| row[i] * row[j]).sum();
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
    }

    /// The same surface with each coordinate multiplied by a factor.
    pub(crate) fn scaled(&self, factors: [f64; 3]) -> Self {
        Self::of(self.columns.map(|column| [0, 1, 2].map(|i| column[i] * factors[i])))
    }
}

fn check_entries(matrix: [[f64; 3]; 3], place: Place) -> Result<(), DrawError> {
    for (index, &value) in matrix.as_flattened().iter().enumerate() {
        crate::world_map::finite(value, place, index)?;
    }
    for (row, column) in [(0, 1), (0, 2), (1, 2)] {
        let difference = matrix[row][column] - matrix[column][row];
        let size = (matrix[row][row].abs() * matrix[column][column].abs()).sqrt();
        if difference.abs() > SYMMETRY_TOLERANCE * size {
            return Err(DrawError::NotSymmetric { place, row, column, difference });
        }
    }
    Ok(())
}

/// The solution of a symmetric positive definite 2 x 2 system, by elimination.
fn solve([[xx, xy], [_, yy]]: [[f64; 2]; 2], [a, b]: [f64; 2]) -> [f64; 2] {
    let ratio = xy / xx;
    let second = (b - ratio * a) / (yy - ratio * xy);
    [(a - xy * second) / xx, second]
}

/// The semi-axes of the ellipse `x^T S x = 2`, the shorter first, by one Jacobi rotation.
fn semi_axes(
    [[xx, xy], [_, yy]]: [[f64; 2]; 2],
    pivots: [usize; 2],
    place: Place,
) -> Result<[[f64; 2]; 2], DrawError> {
    let first = pivot(xx, pivots[0], place)?;
    let second = pivot(yy - xy * (xy / xx), pivots[1], place)?;
    let (sin, cos) = (0.5 * (2.0 * xy).atan2(xx - yy)).sin_cos();
    let large = xx * cos * cos + 2.0 * xy * sin * cos + yy * sin * sin;
    // The small eigenvalue from the determinant, which does not cancel.
    let small = first * (second / large);
    let (short, long) = ((2.0 / large).sqrt(), (2.0 / small).sqrt());
    Ok([[short * cos, short * sin], [-long * sin, long * cos]])
}

/// The value, if it can be a pivot of a positive definite matrix.
fn pivot(value: f64, pivot: usize, place: Place) -> Result<f64, DrawError> {
    if value > 0.0 {
        Ok(value)
    } else {
        Err(DrawError::NotPositiveDefinite { place, pivot, value })
    }
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt();
    a.map(|value| value / length)
}
