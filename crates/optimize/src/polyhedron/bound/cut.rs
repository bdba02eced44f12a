//! Inequalities that all placements of an objective fulfill, and how they are added up.

use clench_metrics::Principal;
use clench_screw::{Cholesky, Mat, Vector, Wrench};

use crate::polyhedron::vectors::joined;

/// What all placements whose objective is `q` or more fulfill, on one node: `sum over the contacts
/// of p^T form p >= plain q + (sigma a q + 2 b q - c) / (sigma + q)`, with the `sigma_min` of the
/// node's combination.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cut {
    pub(crate) form: Mat<6, 6>,
    pub(crate) limits: Limits,
}

/// The right side of a cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Limits {
    plain: f64,
    a: f64,
    b: f64,
    c: f64,
}

impl Cut {
    /// What is always fulfilled, and bounds nothing.
    pub(crate) const NONE: Self =
        Self { form: Mat::ZERO, limits: Limits { plain: 0.0, a: 0.0, b: 0.0, c: 0.0 } };

    /// That `(p . twist)^2` sums up to `q` or more.
    fn plain(twist: Vector<6>) -> Self {
        let limits = Limits { plain: 1.0, ..Self::NONE.limits };
        Self { form: Mat::outer(twist, twist), limits }
    }

    /// That a unit displacement along `direction` takes a force of `q`.
    pub(crate) fn translation(direction: Vector<3>) -> Self {
        Self::plain(joined(direction, Vector::ZERO))
    }

    /// That a rotation moves some point by the radius of a cylinder around the body.
    pub(crate) fn cylinder(
        principal: &Principal<3, 3>,
        rotation: Vector<3>,
        radius_squared: f64,
    ) -> Self {
        let twist = principal.force_free_twist(rotation);
        Self::plain(joined(twist.linear, twist.angular) * radius_squared.sqrt().recip())
    }

    /// That a force along `direction` at the point `x` moves that by no more than it may.
    pub(crate) fn worst_point(
        principal: &Principal<3, 3>,
        x: Vector<3>,
        direction: Vector<3>,
    ) -> Self {
        let twist = principal.displacement(Vector::ZERO, &Wrench::of_force_at(direction, x));
        let speed = twist.velocity_at(x).norm();
        Self::plain(joined(twist.linear, twist.angular) * speed.recip())
    }

    /// That a rotation moves the point `x`, where `translational` is `K_11`; sharpest for `q`.
    /// `None` where `K_11` is singular.
    pub(crate) fn rotation(
        principal: &Principal<3, 3>,
        translational: &Mat<3, 3>,
        (rotation, x): (Vector<3>, Vector<3>),
        q: f64,
    ) -> Option<Self> {
        let twist = principal.force_free_twist(rotation);
        let velocity = twist.velocity_at(x);
        let per_speed = velocity.norm().recip();
        let v = velocity * per_speed;
        let y = Cholesky::new(translational).ok()?.solve(v) * q;
        let t = joined(twist.linear, twist.angular) * per_speed;
        let form = Mat::outer(t, t + joined(y, Vector::ZERO) * 2.0).symmetric_part();
        let resisted = *translational * y;
        let (b, c) = (v.dot(resisted), resisted.norm_squared());
        Some(Self { form, limits: Limits { plain: 0.0, a: v.norm_squared(), b, c } })
    }

    /// The mean of both cuts, with the weight `part` of the other one.
    pub(crate) fn mixed(&self, part: f64, other: &Self) -> Self {
        Self {
            form: self.form * (1.0 - part) + other.form * part,
            limits: self.limits.mixed(part, &other.limits),
        }
    }
}

impl Limits {
    pub(crate) fn mixed(&self, part: f64, other: &Self) -> Self {
        let mean = |x: f64, y: f64| x * (1.0 - part) + y * part;
        Self {
            plain: mean(self.plain, other.plain),
            a: mean(self.a, other.a),
            b: mean(self.b, other.b),
            c: mean(self.c, other.c),
        }
    }

    /// The largest `q` for which the cut can be fulfilled by a sum of `total`: the positive root of
    /// `plain q^2 + (plain sigma + sigma a + 2 b - total) q = total sigma + c`, or infinite.
    pub(crate) fn largest_objective(&self, total: f64, sigma: f64) -> f64 {
        let Self { plain, a, b, c } = *self;
        if a <= 0.0 {
            return if plain > 0.0 { (total / plain).max(0.0) } else { f64::INFINITY };
        }
        let linear = plain * sigma + sigma * a + 2.0 * b - total;
        let constant = (total * sigma + c).max(0.0);
        let root = (linear * linear + 4.0 * plain * constant).sqrt();
        // Each form where nothing cancels.
        if linear > 0.0 {
            2.0 * constant / (linear + root)
        } else if plain > 0.0 {
            0.5 * (root - linear) / plain
        } else {
            f64::INFINITY
        }
    }
}
