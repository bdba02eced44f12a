//! Random stiffnesses, as springs at random places, and the bodies that they hold.

use clench_metrics::{MetricsError, Principal};
use clench_screw::{Frame, Stiffness, Twist, Vector, Wrench};
use clench_testkit::Random;

/// A spring: its place, its direction and its stiffness.
pub(crate) type Spring<const N: usize> = (Vector<N>, Vector<N>, f64);

/// Springs at random places near the origin; seven of them leave nothing free.
pub(crate) fn springs<const N: usize>(count: usize, r: &mut Random) -> Vec<Spring<N>> {
    let spring = |r: &mut Random| (r.array(1.0).into(), r.array(1.0).into(), r.between(0.5, 2.0));
    (0..count).map(|_| spring(r)).collect()
}

/// Their stiffness about `origin`.
pub(crate) fn assembled<const N: usize, const M: usize>(
    springs: &[Spring<N>],
    origin: Vector<N>,
) -> Stiffness<N, M> {
    springs.iter().fold(Stiffness::ZERO, |sum, &(point, normal, k)| {
        sum + Stiffness::outer(&Wrench::of_force_at(normal, point - origin)) * k
    })
}

/// The same springs in another frame, coordinates and all.
pub(crate) fn moved<const N: usize, const M: usize>(
    springs: &[Spring<N>],
    frame: &Frame<N, M>,
) -> Vec<Spring<N>> {
    let place = |p| frame.point_to_parent(p);
    springs.iter().map(|&(p, n, k)| (place(p), frame.direction_to_parent(n), k)).collect()
}

/// The parameters of springs, formed near their mean.
pub(crate) fn principal<const N: usize, const M: usize>(
    springs: &[Spring<N>],
) -> Result<Principal<N, M>, MetricsError> {
    let share = 1.0 / springs.len() as f64;
    let start = springs.iter().fold(Vector::ZERO, |sum, spring| sum + spring.0 * share);
    Principal::near(start, |origin| assembled(springs, origin))
}

/// Corners of a body at random places near the origin.
pub(crate) fn corners<const N: usize>(count: usize, r: &mut Random) -> Vec<[f64; N]> {
    (0..count).map(|_| r.array(1.5)).collect()
}

/// The solution `q` of `K q = w`, by Gaussian elimination on the full matrix.
pub(crate) fn solve<const N: usize, const M: usize>(
    stiffness: &Stiffness<N, M>,
    load: &Wrench<N, M>,
) -> Twist<N, M> {
    let size = N + M;
    let mut a: Vec<Vec<f64>> = (0..size)
        .map(|i| {
            let right = if i < N { load.force[i] } else { load.torque[i - N] };
            (0..size).map(|j| stiffness.entry(i, j)).chain([right]).collect()
        })
        .collect();
    for p in 0..size {
        for i in (0..size).filter(|&i| i != p) {
            let factor = a[i][p] / a[p][p];
            for j in p..=size {
                a[i][j] -= factor * a[p][j];
            }
        }
    }
    let x = |i: usize| a[i][size] / a[i][i];
    Twist { linear: Vector::from_fn(x), angular: Vector::from_fn(|i| x(N + i)) }
}
