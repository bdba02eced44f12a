//! Which parts of a curve the ellipsoids hide.

use clench_screw::Vector;

use crate::energy::surface::EnergySurface;

/// How far off the unit sphere the image of a point of the surface may be by rounding: some 2^5
/// operations, each wrong by the condition of the map, which is below 2^17 for any ellipsoid
/// that shows as more than a line.
pub(crate) const ON_SURFACE: f64 = (1u32 << 22) as f64 * f64::EPSILON;

/// Places at which a curve's visibility is sampled before the changes are bisected.
const SAMPLES: u32 = 180;
const BISECTIONS: u32 = 30;

/// A piece of a curve that is seen, or hidden, throughout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Run {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) seen: bool,
}

/// Cuts a curve where solids begin or cease to hide it.
pub(crate) fn runs(
    curve: impl Fn(f64) -> Vector<3>,
    [from, to]: [f64; 2],
    solids: &[EnergySurface],
    eye: Vector<3>,
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
pub(crate) fn hides(solid: &EnergySurface, point: Vector<3>, eye: Vector<3>) -> bool {
    let (y, u) = (solid.sphere_point(point), solid.sphere_point(eye));
    let (along, length) = (y.dot(u), u.norm_squared());
    let outside = y.norm_squared() - 1.0;
    if outside < -ON_SURFACE {
        return true;
    }
    // The silhouette itself, and what lies on the near side, is in sight.
    along < -ON_SURFACE.sqrt() * length.sqrt() && along * along - length * outside.max(0.0) > 0.0
}
