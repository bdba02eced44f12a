//! An arc of an ellipse, and the Bézier pieces that draw it.

use std::f64::consts::{FRAC_PI_6, TAU};

/// The points `center + axes[0] cos t + axes[1] sin t` for `t` between `from` and `to`.
///
/// The axes need not be perpendicular, so every affine image of a circle is one. Angles are
/// in radians and may run either way.
///
/// ```
/// use clench_draw::EllipseArc;
///
/// let circle = EllipseArc::circle([1.0, 2.0], 3.0);
/// assert_eq!(circle.point(0.0), [4.0, 2.0]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipseArc {
    /// The center.
    pub center: [f64; 2],
    /// Two conjugate half-diameters.
    pub axes: [[f64; 2]; 2],
    /// The angle it starts at.
    pub from: f64,
    /// The angle it ends at.
    pub to: f64,
}

impl EllipseArc {
    /// A whole circle.
    #[must_use]
    pub const fn circle(center: [f64; 2], radius: f64) -> Self {
        Self { center, axes: [[radius, 0.0], [0.0, radius]], from: 0.0, to: TAU }
    }

    /// A whole ellipse with these conjugate half-diameters.
    #[must_use]
    pub const fn ellipse(center: [f64; 2], axes: [[f64; 2]; 2]) -> Self {
        Self { center, axes, from: 0.0, to: TAU }
    }

    /// The same ellipse between other angles.
    #[must_use]
    pub const fn between(self, from: f64, to: f64) -> Self {
        Self { from, to, ..self }
    }

    /// The point at this angle.
    #[must_use]
    pub fn point(&self, angle: f64) -> [f64; 2] {
        self.combine(angle.cos(), angle.sin())
    }

    fn combine(&self, a: f64, b: f64) -> [f64; 2] {
        [0, 1].map(|i| self.center[i] + self.axes[0][i] * a + self.axes[1][i] * b)
    }

    /// Whether the arc goes once around.
    pub(crate) fn closes(&self) -> bool {
        (self.to - self.from).abs() >= TAU
    }

    /// Start point and cubic pieces, each two handles and an end. A piece spans at most 30
    /// degrees, where the radius is right to 1e-7.
    pub(crate) fn beziers(&self) -> Vec<[f64; 2]> {
        let turn = (self.to - self.from).clamp(-TAU, TAU);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped to between 1 and 12 before the cast"
        )]
        let pieces = (turn.abs() / FRAC_PI_6).ceil().clamp(1.0, 12.0) as u32;
        let step = turn / f64::from(pieces);
        let reach = 4.0 / 3.0 * (step / 4.0).tan();
        let mut points = vec![self.point(self.from)];
        for piece in 0..pieces {
            let start = self.from + step * f64::from(piece);
            let (s0, c0) = start.sin_cos();
            let (s1, c1) = (start + step).sin_cos();
            points.push(self.combine(c0 - reach * s0, s0 + reach * c0));
            points.push(self.combine(c1 + reach * s1, s1 - reach * c1));
            points.push(self.combine(c1, s1));
        }
        points
    }
}
