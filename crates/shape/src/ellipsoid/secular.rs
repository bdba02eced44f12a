//! The equation behind the nearest and the farthest points of an ellipsoid.

use clench_screw::Vector;

/// Newton's steps from below converge quadratically from a start at which the sum is between 1
/// and `N`; far fewer than ten were ever seen, and this is the end for any input.
const MAX_STEPS: usize = 64;

/// The unit vector `p` with `(s + gap_i) p_i = gradient_i` for the largest `s >= 0` that has one,
/// and this `s`; at least one of the gaps is 0, and none is negative.
///
/// No denominator cancels. At `s = 0` the other coordinates may leave room for the one whose gap is
/// 0 (the *hard case*): it fills the vector up, its sign free and here positive.
pub(super) fn on_sphere<const N: usize>(gradient: Vector<N>, gaps: Vector<N>) -> (Vector<N>, f64) {
    // A gradient that is no normal number is none: what it is divided by may be as small.
    let normal = |x: f64| if x.is_normal() { x.abs() } else { 0.0 };
    let numerators = Vector::<N>::from_fn(|i| normal(gradient[i]));
    let s = largest_root(numerators, gaps);
    let mut unit = quotients(numerators, gaps, s);
    if s <= 0.0 {
        let free = (0..N).find(|&i| gaps[i] <= 0.0).unwrap_or(0);
        unit[free] = (1.0 - unit.norm_squared()).max(0.0).sqrt();
    }
    (Vector::from_fn(|i| unit[i].copysign(gradient[i])), s)
}

/// The largest `s >= 0` at which the quotients have unit length; 0 if they are shorter for all.
///
/// Newton's method for `1 / |p(s)| = 1`, which is concave and increasing: from below it stays
/// below, so that it ends when a step no longer rises. The start is where the first quotient alone
/// reaches 1.
fn largest_root<const N: usize>(numerators: Vector<N>, gaps: Vector<N>) -> f64 {
    let mut s = (0..N).fold(0.0_f64, |start, i| start.max(numerators[i] - gaps[i]));
    for _ in 0..MAX_STEPS {
        let p = quotients(numerators, gaps, s);
        let squared = p.norm_squared();
        let norm = squared.sqrt();
        let decrease: f64 =
            (0..N).filter(|&i| p[i] > 0.0).map(|i| p[i] / (s + gaps[i]) * p[i]).sum();
        let next = s + (squared - 1.0) / (norm + 1.0) * squared / decrease;
        if next > s {
            s = next;
        } else {
            break;
        }
    }
    s
}

/// `numerator / (s + gap)`, or 0 where both are zero.
fn quotients<const N: usize>(numerators: Vector<N>, gaps: Vector<N>, s: f64) -> Vector<N> {
    Vector::from_fn(|i| if numerators[i] > 0.0 { numerators[i] / (s + gaps[i]) } else { 0.0 })
}
