//! Inequalities that all placements of an objective fulfill, and how they are added up.

use clench_screw::Mat;

/// What all placements whose objective is `q` or more fulfill, on one node:
/// `sum over the contacts of p^T form p >= plain q + (sigma a q + 2 b q - c) / (sigma + q)`, with the
/// `sigma_min` of the node's combination.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cut {
    pub(crate) form: Mat<6, 6>,
    pub(crate) plain: f64,
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) c: f64,
}

impl Cut {
    /// That `p^T form p` sums up to `q` or more.
    pub(crate) const fn plain(form: Mat<6, 6>) -> Self {
        Self { form, plain: 1.0, a: 0.0, b: 0.0, c: 0.0 }
    }

    /// The mean of both cuts, with the weight `part` of the other one.
    pub(crate) fn mixed(&self, part: f64, other: &Self) -> Self {
        let mean = |x: f64, y: f64| x * (1.0 - part) + y * part;
        Self {
            form: self.form * (1.0 - part) + other.form * part,
            plain: mean(self.plain, other.plain),
            a: mean(self.a, other.a),
            b: mean(self.b, other.b),
            c: mean(self.c, other.c),
        }
    }

    /// The largest `q` for which the cut can be fulfilled by a sum of `total`: the positive root of
    /// `plain q^2 + (plain sigma + sigma a + 2 b - total) q = total sigma + c`, or infinite.
    pub(crate) fn largest_objective(&self, total: f64, sigma: f64) -> f64 {
        let Self { plain, a, b, c, .. } = *self;
        if a <= 0.0 {
            return (total / plain).max(0.0);
        }
        let linear = plain * sigma + sigma * a + 2.0 * b - total;
        let constant = (total * sigma + c).max(0.0);
        let root = (linear * linear + 4.0 * plain * constant).sqrt();
        let sum = linear + root;
        if sum > 0.0 { 2.0 * constant / sum } else { f64::INFINITY }
    }
}
