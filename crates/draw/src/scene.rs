//! Solids seen in parallel projection, and which parts of a curve they hide.

use crate::arc::EllipseArc;
use crate::energy_surface::{EnergySurface, SpaceEllipse, cross, dot};

/// Rounding of a point that lies on a surface, in units of the surface's size.
const ON_SURFACE: f64 = 1e-9;

/// Places at which a curve's visibility is sampled before the changes are bisected.
const SAMPLES: u32 = 180;
const BISECTIONS: u32 = 30;

/// A direction to look from, at the origin, with the third coordinate up.
#[derive(Debug, Clone, Copy)]
pub(crate) struct View {
    pub(crate) right: [f64; 3],
    pub(crate) up: [f64; 3],
    /// From the scene to the eye.
    pub(crate) eye: [f64; 3],
}

impl View {
    /// The view from an azimuth about the vertical and an elevation, in degrees.
    pub(crate) fn from_angles(azimuth: f64, elevation: f64) -> Self {
        let (sin_a, cos_a) = azimuth.to_radians().sin_cos();
        let (sin_e, cos_e) = elevation.to_radians().sin_cos();
        let right = [-sin_a, cos_a, 0.0];
        let eye = [cos_e * cos_a, cos_e * sin_a, sin_e];
        Self { right, up: cross(eye, right), eye }
    }

    pub(crate) fn project(&self, point: [f64; 3]) -> [f64; 2] {
        [dot(self.right, point), dot(self.up, point)]
    }

    /// The projection of an ellipse is an ellipse with the projected half-diameters.
    pub(crate) fn project_ellipse(&self, ellipse: &SpaceEllipse) -> EllipseArc {
        let axes = ellipse.axes.map(|axis| self.project(axis));
        EllipseArc::ellipse(self.project(ellipse.center), axes)
    }
}

/// A piece of a curve that is seen, or hidden, throughout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Run {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) seen: bool,
}

/// Cuts a curve where solids begin or cease to hide it.
pub(crate) fn runs(
    curve: impl Fn(f64) -> [f64; 3],
    [from, to]: [f64; 2],
    solids: &[EnergySurface],
    eye: [f64; 3],
) -> Vec<Run> {
    let seen = |at: f64| !solids.iter().any(|solid| hides(solid, curve(at), eye));
    let mut runs = Vec::new();
    let mut run = Run { from, to: from, seen: seen(from) };
    for sample in 1..=SAMPLES {
        let next = from + (to - from) * f64::from(sample) / f64::from(SAMPLES);
        if seen(next) != run.seen {
            let change = bisect(seen, run.to, next, run.seen);
            runs.push(Run { to: change, ..run });
            run = Run { from: change, to: change, seen: !run.seen };
        }
        run.to = next;
    }
    runs.push(run);
    runs
}

/// The place between two of different visibility where it changes.
fn bisect(seen: impl Fn(f64) -> bool, mut low: f64, mut high: f64, at_low: bool) -> f64 {
    for _ in 0..BISECTIONS {
        let middle = f64::midpoint(low, high);
        if seen(middle) == at_low {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::midpoint(low, high)
}

/// Whether the solid lies between a point and the eye, or holds the point inside. The line
/// of sight meets the unit sphere where `|y + t u|^2 = 1`.
pub(crate) fn hides(solid: &EnergySurface, point: [f64; 3], eye: [f64; 3]) -> bool {
    let (y, u) = (solid.sphere_point(point), solid.sphere_point(eye));
    let (along, length) = (dot(y, u), dot(u, u));
    let outside = dot(y, y) - 1.0;
    if outside < -ON_SURFACE {
        return true;
    }
    // The silhouette itself, and what lies on the near side, is in sight.
    along < -ON_SURFACE.sqrt() * length.sqrt() && along * along - length * outside.max(0.0) > 0.0
}
