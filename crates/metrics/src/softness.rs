//! Where a body gives way most: the largest of a compliance over its points and directions.

use clench_screw::{Mat, SymmetricEigen, Vector, Wrench, lever};
use clench_shape::{Extent, Extreme};

use crate::directions::{Largest, largest_norm};
use crate::{MetricsError, Principal};

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

    /// Where on the body it is largest.
    pub(crate) fn largest(&self, body: Extent<'_, N>) -> Result<Softest<N>, MetricsError> {
        match body {
            Extent::Extremes(extremes) => {
                let root = |x: Vector<N>, floor: f64| self.root_above(x, floor);
                self.at(extremes.farthest_by(self.growth, root))
            }
            Extent::Ellipsoid(_) => self.largest_over_directions(body),
        }
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

    /// The root of the compliance at a point, or an upper bound of it that is below the floor: as a
    /// norm of `[base^(1/2), G]` it grows no faster than `G`.
    fn root_above(&self, point: Vector<N>, floor: f64) -> f64 {
        let matrix = self.matrix(point);
        let bound = eigenvalue_bound(&matrix).sqrt();
        if bound <= floor {
            return bound;
        }
        SymmetricEigen::new(&matrix).map_or(f64::NAN, |eigen| eigen.values[N - 1].sqrt())
    }

    fn at(&self, found: Extreme<N>) -> Result<Softest<N>, MetricsError> {
        let Ok(eigen) = SymmetricEigen::new(&self.matrix(found.point)) else {
            let (stiffness, deflection) = (0.0, f64::INFINITY);
            return Err(MetricsError::OutOfRange { stiffness, deflection });
        };
        let (compliance, direction) = (eigen.values[N - 1], eigen.vectors[N - 1]);
        let Extreme { point, corner, .. } = found;
        Ok(Softest { point, corner, direction, compliance, bound: compliance })
    }

    /// For a direction `u` the largest of `|[base^(1/2) u, G(x)^T u]|` over the points `x` of an
    /// ellipsoid is that of an affine map; the largest of all `u` is searched for.
    fn largest_over_directions(&self, body: Extent<'_, N>) -> Result<Softest<N>, MetricsError> {
        let found = largest_norm(|u| {
            let farthest = self.farthest_along(body, u);
            let base = u.dot(self.base * u);
            let norm = base + farthest.value * farthest.value;
            let eigen = SymmetricEigen::new(&self.matrix(farthest.point));
            let next = eigen.map_or(u, |eigen| eigen.vectors[N - 1]);
            (norm.sqrt(), next)
        });
        let Largest { direction, bound, .. } = found;
        let point = self.farthest_along(body, direction);
        let softest = self.at(point)?;
        Ok(Softest { bound: softest.compliance.max(bound * bound), ..softest })
    }

    /// The point `x` with the largest `|G(x)^T u|`: `G^T u = spread^T (P_1^T u + y x u)` with `y`
    /// from the near origin to `x`.
    fn farthest_along(&self, body: Extent<'_, N>, u: Vector<N>) -> Extreme<N> {
        let spread = self.spread.transpose();
        let offset = spread * (self.principal.near_map().transpose() * u);
        let axes: [Vector<M>; N] = std::array::from_fn(|j| {
            let axis = Vector::from_fn(|i| if i == j { 1.0 } else { 0.0 });
            Wrench::of_force_at(u, axis).torque
        });
        let torque = Mat::<M, N>::from_fn(|i, j| axes[j][i]);
        body.farthest_image(self.principal.origin(), offset, &(spread * torque))
    }
}

/// An upper bound of the largest eigenvalue of a symmetric matrix, from its trace `t` and the sum
/// `s` of the squares of its entries: `t / N + sqrt((N - 1) / N (s - t^2 / N))`, which it attains
/// where all other eigenvalues are equal.
fn eigenvalue_bound<const N: usize>(matrix: &Mat<N, N>) -> f64 {
    /// The rounding of the sums, in units of the bound: each has at most nine terms.
    const ROUNDING: f64 = 1.0 + 32.0 * f64::EPSILON;
    let (trace, share) = (matrix.trace(), 1.0 / N as f64);
    // The spread of the diagonal about its mean, which the difference would lose.
    let mean = trace * share;
    let entry = |i: usize, j: usize| if i == j { matrix[i][j] - mean } else { matrix[i][j] };
    let squares: f64 =
        (0..N).flat_map(|i| (0..N).map(move |j| (i, j))).map(|(i, j)| entry(i, j).powi(2)).sum();
    (mean + ((1.0 - share) * squares).sqrt()) * ROUNDING
}
