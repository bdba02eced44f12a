//! Contact forces that follow from equilibrium alone.

use clench_contact::Geometry;
use clench_screw::{Vector, Wrench};
use faer::Mat;

use crate::equilibrium::relative;
use crate::{BALANCED, DeadLoad, GraspError};

/// A singular value below this part of the largest counts as zero: a file gives points with about
/// as many digits, and supports that are independent only by what is left out are not.
const DEPENDENT: f64 = BALANCED;

/// The forces of `supports` that balance `loads`: of a part on six locators, what each carries.
///
/// Contacts whose force is known are loads like any other: their forces, at their points. A
/// negative force is that of a support that would have to pull. What is less than the part
/// [`BALANCED`] of all forces, per support, is 0. Without supports there are no forces.
///
/// # Errors
///
/// [`GraspError::Undetermined`] when the supports could press against one another, so that the
/// loads do not say how hard they do; [`GraspError::Unresisted`] when no forces of the supports
/// balance the loads; [`GraspError::Load`] and [`GraspError::Support`] for a number that is not
/// finite, or a normal that is none.
///
/// ```
/// use clench_contact::Geometry;
/// use clench_stiffness::{DeadLoad, reactions};
/// // A beam on supports at 0 and 4, its weight of 20 at 1: three quarters are near it.
/// let support = |x: f64| Geometry::on_face([x, 0.0].into(), [0.0, 1.0].into(), 0.0);
/// let weight = DeadLoad { point: [1.0, 0.5].into(), force: [0.0, -20.0].into() };
/// let forces = reactions::<2, 1>(&[support(0.0), support(4.0)], &[weight])?;
/// assert!((forces[0] - 15.0).abs() < 1e-12 && (forces[1] - 5.0).abs() < 1e-12);
/// # Ok::<(), clench_stiffness::GraspError>(())
/// ```
pub fn reactions<const N: usize, const M: usize>(
    supports: &[Geometry<N>],
    loads: &[DeadLoad<N>],
) -> Result<Vec<f64>, GraspError> {
    let lines = Lines::<N, M>::of(supports)?;
    let mut sum = Wrench::ZERO;
    let mut sizes = [0.0, 0.0];
    for (load, given) in loads.iter().enumerate() {
        sum += given.wrench(lines.origin);
        let [force, torque] = given.sizes(lines.origin);
        sizes = [sizes[0] + force, sizes[1] + torque];
        if !sizes.iter().all(|size| size.is_finite()) {
            return Err(GraspError::Load { load });
        }
    }
    let mut forces = lines.against(&sum)?;
    let total: f64 = forces.iter().map(|force| force.abs()).sum();
    let left = lines.wrenches.iter().zip(&forces).fold(sum, |left, (&unit, &f)| left + unit * f);
    let force = relative(left.force, sizes[0] + total);
    let torque = relative(left.torque, sizes[1] + (sizes[0] + total) * lines.length);
    if force > BALANCED || torque > BALANCED {
        return Err(GraspError::Unresisted { force, torque });
    }
    let none = BALANCED / forces.len() as f64 * (total + sizes[0]);
    for force in forces.iter_mut().filter(|force| force.abs() <= none) {
        *force = 0.0;
    }
    Ok(forces)
}

/// The lines along which supports push.
struct Lines<const N: usize, const M: usize> {
    /// The mean of the supports' points.
    origin: Vector<N>,
    /// The distance of the farthest support from there; 1 if all are in one place.
    length: f64,
    /// Of unit forces, about the origin.
    wrenches: Vec<Wrench<N, M>>,
}

impl<const N: usize, const M: usize> Lines<N, M> {
    fn of(supports: &[Geometry<N>]) -> Result<Self, GraspError> {
        let share = (supports.len() as f64).recip();
        let origin = supports.iter().fold(Vector::ZERO, |sum, place| sum + place.point * share);
        let mut length: f64 = 0.0;
        let mut wrenches = Vec::with_capacity(supports.len());
        for (support, place) in supports.iter().enumerate() {
            let arm = place.point - origin;
            let normal = place.inward_normal.direction().filter(|_| arm.is_finite());
            let normal = normal.ok_or(GraspError::Support { support })?;
            length = length.max(arm.norm());
            wrenches.push(Wrench::of_force_at(normal, arm));
        }
        Ok(Self { origin, length: if length > 0.0 { length } else { 1.0 }, wrenches })
    }

    /// The forces whose sum is nearest to the opposite of `load`, about the origin.
    fn against(&self, load: &Wrench<N, M>) -> Result<Vec<f64>, GraspError> {
        let row = |wrench: &Wrench<N, M>, i: usize| {
            if i < N { wrench.force[i] } else { wrench.torque[i - N] / self.length }
        };
        let (rows, count) = (N + M, self.wrenches.len());
        let map = Mat::from_fn(rows, count, |i, j| row(&self.wrenches[j], i));
        #[expect(clippy::expect_used, reason = "arms and unit normals are finite")]
        let svd = map.svd().expect("the singular values of a finite matrix converge");
        let values = svd.S().column_vector();
        let rank = (0..count.min(rows)).filter(|&k| values[k] > DEPENDENT * values[0]).count();
        if rank < count {
            return Err(GraspError::Undetermined { contacts: count, rank });
        }
        let along = |k: usize| (0..rows).map(|i| svd.U()[(i, k)] * row(load, i)).sum::<f64>();
        let weights: Vec<f64> = (0..rank).map(|k| -along(k) / values[k]).collect();
        let force = |j: usize| weights.iter().enumerate().map(|(k, w)| svd.V()[(j, k)] * w).sum();
        Ok((0..count).map(force).collect())
    }
}
