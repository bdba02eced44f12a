//! How far the points of a body are from any axis.

use clench_screw::{Mat, SymmetricEigen, Vector};

/// Steps in which weights move to the farthest points.
const STEPS: usize = 64;

/// A lower bound of the square of the radius of any cylinder around `points`.
///
/// For weights that sum to 1, the largest squared distance from a line is no less than the mean
/// one, which is least for the line through the mean along the longest principal axis: there it is
/// the sum of the two smallest eigenvalues of the covariance. Weights move towards the points that
/// are farthest from that axis; each gives a bound, and the largest is kept.
pub(crate) fn least_cylinder_squared(points: &[Vector<3>]) -> f64 {
    let mut weights = vec![(points.len().max(1) as f64).recip(); points.len()];
    let mut best = 0.0_f64;
    for step in 0..STEPS {
        let all = || points.iter().copied().zip(weights.iter().copied());
        let mean = all().fold(Vector::ZERO, |sum, (x, weight)| sum + x * weight);
        let covariance = all().fold(Mat::<3, 3>::ZERO, |sum, (x, weight)| {
            sum + Mat::outer(x - mean, x - mean) * weight
        });
        let Ok(eigen) = SymmetricEigen::new(&covariance) else { return best };
        best = best.max(eigen.values[0] + eigen.values[1]);
        let axis = eigen.vectors[2];
        let distance = |x: Vector<3>| {
            let offset = x - mean;
            offset.norm_squared() - axis.dot(offset).powi(2)
        };
        let by_distance = |&i: &usize, &j: &usize| {
            distance(points[i]).total_cmp(&distance(points[j])).then(j.cmp(&i))
        };
        let Some(farthest) = (0..points.len()).max_by(by_distance) else { return best };
        let part = 2.0 / (step as f64 + 3.0 + points.len() as f64);
        for weight in &mut weights {
            *weight *= 1.0 - part;
        }
        weights[farthest] += part;
    }
    best * (1.0 - super::ROUNDING)
}
