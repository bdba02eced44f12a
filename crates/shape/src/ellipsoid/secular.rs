//! The equation behind the point of an ellipsoid nearest to a given point.

use clench_screw::Vector;

/// Newton's steps from below converge quadratically from a start at which the sum is between 1
/// and `N`; far fewer than ten were ever seen, and this is the end for any input.
const MAX_STEPS: usize = 64;

/// The nearest boundary point of an ellipsoid about the origin with semi-axes `a` along the axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot<const N: usize> {
    /// The foot divided by the semi-axes: of unit length.
    pub(super) direction: Vector<N>,
    /// How many gradients `x_i / a_i^2` the point is away from its foot (length squared):
    /// positive outside the ellipsoid.
    pub(super) steps: f64,
}

/// The foot of `point`, which may be anywhere.
///
/// The foot `x` has `y - x = t A^-1 x` with `A = diag(a^2)`, so that `p_i = x_i / a_i =
/// a_i y_i / (t + a_i^2)` must be of unit length, and of all such `t` the largest one is sought.
/// (D. Eberly, *Distance from a Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid*, 2013.)
/// In terms of `s = t + a_min^2 >= 0` no denominator cancels: each is `s + (a_i^2 - a_min^2)`.
pub(super) fn foot<const N: usize>(semi_axes: [f64; N], point: Vector<N>) -> Foot<N> {
    let least = semi_axes.into_iter().fold(f64::INFINITY, f64::min);
    let numerators = Vector::<N>::from_fn(|i| semi_axes[i] * point[i].abs());
    let gaps = Vector::<N>::from_fn(|i| (semi_axes[i] - least) * (semi_axes[i] + least));
    let s = largest_root(numerators, gaps);
    let mut direction = quotients(numerators, gaps, s);
    if s <= 0.0 {
        // A point of the plane of symmetry across the shortest axis, as near to both sides: what
        // the other axes leave goes along this one.
        let short = (0..N).find(|&i| gaps[i] <= 0.0).unwrap_or(0);
        direction[short] = (1.0 - direction.norm_squared()).max(0.0).sqrt();
    }
    Foot {
        direction: Vector::from_fn(|i| direction[i].copysign(point[i])),
        steps: s - least * least,
    }
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
