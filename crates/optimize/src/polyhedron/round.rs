//! Motions that no force on a surface resists, as those of round bodies.

use clench_screw::spatial::cross;
use clench_screw::{Mat, SymmetricEigen, Vector};

use super::scene::Scene;
use super::vectors::{first, second};
use crate::OptimizeError;

/// Levers below this part are none, whatever roundness is asked for: rounding.
const NO_LEVER: f64 = 1e-9;

/// Refuses a body on some motion of which no force on its surface has a lever.
///
/// Looks at the six motions for which the mean square of the powers of unit forces is stationary
/// beside the mean square of the velocities of the body's extreme points.
///
/// # Errors
///
/// [`OptimizeError::MotionStaysFree`].
pub(super) fn check(scene: &Scene<'_>, roundness: f64) -> Result<(), OptimizeError> {
    let of_patches =
        scene.patches.iter().flat_map(|patch| patch.corners.iter().map(|&x| patch.unit_wrench(x)));
    let of_fixed = scene.fixed.iter().map(|&(wrench, _)| wrench);
    let forces: Vec<Vector<6>> = of_patches.chain(of_fixed).collect();
    let points = scene.extremes.points();
    let mut powers = Mat::<6, 6>::ZERO;
    for &p in &forces {
        powers += Mat::outer(p, p);
    }
    let mut velocities = Mat::<6, 6>::ZERO;
    for &x in points {
        for row in 0..3 {
            let row = Vector::from_fn(|j| velocity(axis(j), x)[row]);
            velocities += Mat::outer(row, row);
        }
    }
    let Some(motions) = stationary(&powers, &velocities) else { return Ok(()) };
    let deflection =
        |t: Vector<6>| points.iter().map(|&x| velocity(t, x).norm()).fold(0.0, f64::max);
    let lever = |t: &Vector<6>| {
        let largest = forces.iter().map(|p| p.dot(*t).abs()).fold(0.0, f64::max);
        largest / deflection(*t)
    };
    let levers = motions.each_ref().map(lever);
    let count = levers.iter().filter(|&&lever| lever <= roundness.max(NO_LEVER)).count();
    let least = (0..6).fold(0, |i, j| if levers[j] < levers[i] { j } else { i });
    if count == 0 {
        return Ok(());
    }
    let motion = scene.unscaled_twist(motions[least]).screw();
    Err(OptimizeError::MotionStaysFree { motion, count, lever: levers[least], roundness })
}

/// The velocity of the point `x` by a twist `(v, omega)`.
fn velocity(twist: Vector<6>, x: Vector<3>) -> Vector<3> {
    first(twist) + cross(second(twist), x)
}

fn axis(j: usize) -> Vector<6> {
    Vector::from_fn(|i| if i == j { 1.0 } else { 0.0 })
}

/// The vectors for which one form is stationary beside another, positive definite one; `None` if
/// that is not the case, as for a body in a line, which the metrics refuse.
fn stationary(form: &Mat<6, 6>, beside: &Mat<6, 6>) -> Option<[Vector<6>; 6]> {
    let beside = SymmetricEigen::new(beside).ok()?;
    if beside.values[0] <= NO_LEVER * beside.values[5] {
        return None;
    }
    let root = beside.map(|value| value.sqrt().recip());
    let eigen = SymmetricEigen::new(&(root * *form * root)).ok()?;
    Some(eigen.vectors.map(|v| root * v))
}
