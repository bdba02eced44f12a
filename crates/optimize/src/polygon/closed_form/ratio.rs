//! Where a ratio of two squared distances is stationary along a line.

use clench_screw::Vector;

/// The parameters at which `|p + t u|^2 / |q + t w|^2` is stationary; those that are not numbers
/// do not exist.
///
/// The derivative's numerator is quadratic, since the cubic terms cancel.
pub(crate) fn stationary(
    (p, u): (Vector<2>, Vector<2>),
    (q, w): (Vector<2>, Vector<2>),
) -> [f64; 2] {
    // The scale of each line does not matter: brought to size 1, no product over- or underflows.
    let unit = |p: Vector<2>, u: Vector<2>| {
        let size = p.max_abs().max(u.max_abs()).recip();
        (p * size, u * size)
    };
    let ((p, u), (q, w)) = (unit(p, u), unit(q, w));
    let (a0, a1, a2) = (p.norm_squared(), 2.0 * p.dot(u), u.norm_squared());
    let (b0, b1, b2) = (q.norm_squared(), 2.0 * q.dot(w), w.norm_squared());
    quadratic_roots(a2 * b1 - a1 * b2, 2.0 * (a2 * b0 - a0 * b2), a1 * b0 - a0 * b1)
}

/// The roots of `a t^2 + b t + c`, without cancellation; NaN or infinite where there is none.
fn quadratic_roots(a: f64, b: f64, c: f64) -> [f64; 2] {
    let half = -0.5 * (b + (b * b - 4.0 * a * c).sqrt().copysign(b));
    [half / a, c / half]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_keep_their_digits_when_one_is_small() {
        // (t - 1e-9) (t - 1e9)
        let mut roots = quadratic_roots(1.0, -(1e9 + 1e-9), 1.0);
        roots.sort_by(f64::total_cmp);
        assert!((roots[0] - 1e-9).abs() < 1e-24 && (roots[1] - 1e9).abs() < 1e-6);
    }

    #[test]
    fn a_linear_equation_has_its_one_root() {
        let roots = quadratic_roots(0.0, 2.0, -3.0);
        assert!(roots.contains(&1.5) && roots.iter().any(|t| !t.is_finite()));
    }

    #[test]
    fn the_ratio_is_flat_at_the_stationary_parameters() {
        let line = |p: [f64; 2], u: [f64; 2]| (Vector::new(p), Vector::new(u));
        let (top, bottom) = (line([1.0, 2.0], [0.5, -1.0]), line([3.0, -1.0], [1.0, 1.0]));
        let ratio =
            |t: f64| (top.0 + top.1 * t).norm_squared() / (bottom.0 + bottom.1 * t).norm_squared();
        for t in stationary(top, bottom) {
            let slope = (ratio(t + 1e-6) - ratio(t - 1e-6)) / 2e-6;
            assert!(slope.abs() < 1e-8, "slope {slope} at {t}");
        }
    }
}
