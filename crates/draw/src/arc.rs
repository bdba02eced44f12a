//! An arc of an ellipse, and the Bézier pieces that draw it.

use std::f64::consts::{FRAC_PI_6, TAU};

/// The points `center + axes[0] cos t + axes[1] sin t` for `t` between `from` and `to`.
///
/// The axes need not be perpendicular, so every affine image of a circle is one. Angles are
/// in radians and may run either way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EllipseArc {
    /// The center.
    pub(crate) center: [f64; 2],
    /// Two conjugate half-diameters.
    pub(crate) axes: [[f64; 2]; 2],
    /// The angle it starts at.
    pub(crate) from: f64,
    /// The angle it ends at.
    pub(crate) to: f64,
}

/// A piece of a closed boundary; straight lines join the end of one to the start of the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Piece {
    /// A corner between straight lines.
    Corner([f64; 2]),
    /// An arc, from its start to its end.
    Arc(EllipseArc),
}

impl EllipseArc {
    /// A whole circle.
    pub(crate) const fn circle(center: [f64; 2], radius: f64) -> Self {
        Self { center, axes: [[radius, 0.0], [0.0, radius]], from: 0.0, to: TAU }
    }

    /// A whole ellipse with these conjugate half-diameters.
    pub(crate) const fn ellipse(center: [f64; 2], axes: [[f64; 2]; 2]) -> Self {
        Self { center, axes, from: 0.0, to: TAU }
    }

    /// The same ellipse between other angles.
    pub(crate) const fn between(self, from: f64, to: f64) -> Self {
        Self { from, to, ..self }
    }

    /// The point at this angle.
    pub(crate) fn point(&self, angle: f64) -> [f64; 2] {
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
    /// degrees, where the radius is right to 4e-7: a quarter turn errs by 2.7e-4, and the error
    /// falls with the sixth power of the angle.
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
