//! Where a body gives way most: the largest of a compliance over its points and directions.

use clench_screw::{Mat, SymmetricEigen, Vector, Wrench, lever};
use clench_shape::{Extent, Farthest};

use crate::directions::{Largest, largest_norm};
use crate::{MetricsError, Principal};

/// Steps that polish a direction: each leaves a part of its error, of which half of the digits are
/// to go.
const POLISHING: usize = 64;

/// The compliance `base + G G^T` felt at a body point, with `G = X(x) spread` and
/// `X(x) = P_1 - lever(x)`, of which the rotations that it allows are the columns of `spread`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Softness<'a, const N: usize, const M: usize> {
    principal: &'a Principal<N, M>,
    base: Mat<N, N>,
    spread: Mat<M, M>,
    /// The largest singular value of `spread`.
    growth: f64,
}

/// Where a compliance is largest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Softest<const N: usize> {
    pub(crate) point: Vector<N>,
    pub(crate) corner: Option<usize>,
    /// The unit direction in which the point gives way.
    pub(crate) direction: Vector<N>,
    /// The compliance there (length / force).
    pub(crate) compliance: f64,
    /// What no compliance exceeds; equal to it on bodies with corners.
    pub(crate) bound: f64,
}

impl<'a, const N: usize, const M: usize> Softness<'a, N, M> {
    /// The compliance of the body to forces: all of `C_x`.
    pub(crate) fn whole(principal: &'a Principal<N, M>) -> Self {
        Self { base: *principal.translational_compliance(), ..Self::of_rotations(principal, 0, M) }
    }

    /// That part of it that comes from the principal rotations `first` to `end`, exclusive.
    pub(crate) fn of_rotations(principal: &'a Principal<N, M>, first: usize, end: usize) -> Self {
        let mu = principal.rotational();
        let scaled: [Vector<M>; M] = std::array::from_fn(|i| {
            let allowed = (first..end).contains(&i);
            if allowed { mu.vectors[i] * mu.values[i].sqrt().recip() } else { Vector::ZERO }
        });
        let spread = Mat::from_fn(|i, j| scaled[j][i]);
        Self { principal, base: Mat::ZERO, spread, growth: mu.values[first].sqrt().recip() }
    }

    /// Where on the body it is largest: its root, as a norm of `[base^(1/2), G]`, grows from place
    /// to place no faster than `G`.
    pub(crate) fn largest(&self, body: Extent<'_, N>) -> Result<Softest<N>, MetricsError> {
        match body {
            Extent::Points(extremes) => {
                let largest = |x: Vector<N>, floor: f64| self.largest_above(x, floor);
                self.at(extremes.farthest_by(self.growth, largest))
            }
            Extent::Ellipsoid(_) => self.largest_over_directions(body),
        }
    }

    /// All places where it is as large as `largest`, its largest value, to the part `within`, each
    /// with an orthonormal basis of the directions in which the place gives way so.
    ///
    /// On an ellipsoid those that belong to one direction.
    pub(crate) fn all_softest(
        &self,
        body: Extent<'_, N>,
        largest: f64,
        within: f64,
    ) -> Result<Vec<(Vector<N>, Vec<Vector<N>>)>, MetricsError> {
        let floor = largest * (1.0 - within);
        let points = match body {
            Extent::Points(extremes) => {
                let soft = |x: &&Vector<N>| self.largest_above(**x, floor) > floor;
                extremes.points().iter().filter(soft).copied().collect()
            }
            Extent::Ellipsoid(_) => {
                let found = self.largest_over_directions(body)?;
                let direction = self.polished(body, found.direction);
                let all = self.all_farthest_along(body, direction, within);
                all.ok_or(MetricsError::TiesWithoutEnd)?
            }
        };
        let directions = |x: Vector<N>| {
            let eigen = SymmetricEigen::beside_largest(&self.matrix(x)).ok()?;
            let soft = (0..N).filter(|&i| eigen.values[i] >= floor);
            Some((x, soft.map(|i| eigen.vectors[i]).collect()))
        };
        Ok(points.into_iter().filter_map(directions).collect())
    }

    /// A softest direction to all its digits: a search ends when the compliance is, which knows
    /// half of those.
    fn polished(&self, body: Extent<'_, N>, start: Vector<N>) -> Vector<N> {
        let mut direction = start;
        for _ in 0..POLISHING {
            let point = self.farthest_along(body, direction).point;
            let Ok(eigen) = SymmetricEigen::beside_largest(&self.matrix(point)) else { break };
            direction = eigen.vectors[N - 1];
        }
        direction
    }

    /// The rotation that belongs to a displacement of `point` along `direction`: unit length.
    pub(crate) fn rotation(&self, point: Vector<N>, direction: Vector<N>) -> Option<Vector<M>> {
        let spread = self.spread;
        (spread * (self.moved(point).transpose() * direction)).direction()
    }

    /// `G` at a point.
    fn moved(&self, point: Vector<N>) -> Mat<N, M> {
        let x = *self.principal.near_map() - lever(point - self.principal.origin());
        x * self.spread
    }

    fn matrix(&self, point: Vector<N>) -> Mat<N, N> {
        let moved = self.moved(point);
        self.base + moved * moved.transpose()
    }

    /// The largest eigenvalue of the compliance at a point, or the floor where it is below.
    fn largest_above(&self, point: Vector<N>, floor: f64) -> f64 {
        let matrix = self.matrix(point);
        if is_below(&matrix, floor) {
            return floor;
        }
        // What overflows is largest.
        SymmetricEigen::largest_value(&matrix).unwrap_or(f64::INFINITY)
    }

    fn at(&self, found: Farthest<N>) -> Result<Softest<N>, MetricsError> {
        let Farthest { point, corner, .. } = found;
        let overflow = MetricsError::OutOfRange { stiffness: 0.0, deflection: f64::INFINITY };
        let eigen = SymmetricEigen::beside_largest(&self.matrix(point)).map_err(|_| overflow)?;
        let (compliance, direction) = (eigen.values[N - 1], eigen.vectors[N - 1]);
        Ok(Softest { point, corner, direction, compliance, bound: compliance })
    }

    /// For a direction `u` the largest of `|[base^(1/2) u, G(x)^T u]|` over the points `x` of an
    /// ellipsoid is that of an affine map; the largest of all `u` is searched for.
    fn largest_over_directions(&self, body: Extent<'_, N>) -> Result<Softest<N>, MetricsError> {
        let norm = |u: Vector<N>| {
            let farthest = self.farthest_along(body, u);
            let base = u.dot(self.base * u);
            let square = base + farthest.value * farthest.value;
            let eigen = SymmetricEigen::beside_largest(&self.matrix(farthest.point));
            let next = eigen.map_or(u, |eigen| eigen.vectors[N - 1]);
            (square.sqrt(), next)
        };
        // Where the principal rotations move the body most: none of them is softer than the result.
        let origin = self.principal.origin();
        let moved = |rotation| {
            let twist = self.principal.near_twist(rotation);
            twist.velocity_at(body.fastest(origin, &twist).point - origin).direction()
        };
        let starts = self.principal.rotational().vectors.into_iter().filter_map(moved);
        let found = largest_norm(norm, starts);
        let Largest { direction, value, bound } = found;
        let point = self.farthest_along(body, direction);
        let softest = self.at(point)?;
        if bound <= value {
            return Ok(softest);
        }
        Ok(Softest { bound: softest.compliance.max(bound * bound), ..softest })
    }

    /// The point `x` with the largest `|G(x)^T u|`: `G^T u = spread^T (P_1^T u + y x u)` with `y`
    /// from the near origin to `x`.
    fn farthest_along(&self, body: Extent<'_, N>, u: Vector<N>) -> Farthest<N> {
        let (offset, map) = self.image_along(u);
        body.farthest_image(self.principal.origin(), offset, &map)
    }

    /// All of them, to the part `within`; `None` if they form a curve.
    fn all_farthest_along(
        &self,
        body: Extent<'_, N>,
        u: Vector<N>,
        within: f64,
    ) -> Option<Vec<Vector<N>>> {
        let (offset, map) = self.image_along(u);
        body.all_farthest(self.principal.origin(), offset, &map, within)
    }

    /// `G(x)^T u` as an affine map of `x` from the near origin.
    fn image_along(&self, u: Vector<N>) -> (Vector<M>, Mat<M, N>) {
        let spread = self.spread.transpose();
        let offset = spread * (self.principal.near_map().transpose() * u);
        let axes: [Vector<M>; N] = std::array::from_fn(|j| {
            let axis = Vector::from_fn(|i| if i == j { 1.0 } else { 0.0 });
            Wrench::of_force_at(u, axis).torque
        });
        let torque = Mat::<M, N>::from_fn(|i, j| axes[j][i]);
        (offset, spread * torque)
    }
}

/// Whether all eigenvalues of a symmetric matrix are below `floor`, to rounding: whether the
/// pivots of `floor - matrix` are positive.
fn is_below<const N: usize>(matrix: &Mat<N, N>, floor: f64) -> bool {
    let mut rest =
        Mat::<N, N>::from_fn(|i, j| if i == j { floor - matrix[i][j] } else { -matrix[i][j] });
    for p in 0..N {
        let pivot = rest[p][p];
        if pivot <= 0.0 || pivot.is_nan() {
            return false;
        }
        let inverse = pivot.recip();
        for i in p + 1..N {
            let factor = rest[i][p] * inverse;
            for j in p + 1..N {
                rest[i][j] -= factor * rest[p][j];
            }
        }
    }
    true
}
