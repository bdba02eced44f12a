//! Two ellipsoids, or two ellipses: a smooth function of the normal, minimized.

use clench_screw::{Cholesky, Mat, Vector};

use super::DeepestPair;
use crate::Ellipsoid;

/// Newton's steps; with its line search fewer than thirty were ever seen.
const MAX_STEPS: usize = 100;

/// Each halves the step: below this the direction does not change any more.
const MAX_HALVINGS: usize = 52;

/// A step is taken when the overlap falls by this share of what its slope promises, or when the
/// slope itself falls by half: near the minimum the overlap is flat to rounding, the slope is not.
const SUFFICIENT_DECREASE: f64 = 1.0 / 1024.0;

/// A change of the overlap below this many roundings of the bodies' size is none: the overlap is
/// the sum of three terms of that size, each good to a few roundings.
const LEVEL: f64 = 8.0 * f64::EPSILON;

/// A finger and a part whose centers are `apart`, the finger's less the part's.
#[derive(Clone, Copy)]
pub(super) struct Pair<'a, const N: usize> {
    pub(super) finger: &'a Ellipsoid<N>,
    /// None for a point.
    pub(super) part: Option<&'a Ellipsoid<N>>,
    pub(super) apart: Vector<N>,
}

/// The translation along a unit normal `m` that separates the two, `h_A(m) + h_B(-m)`.
#[derive(Clone, Copy)]
struct Trial<const N: usize> {
    normal: Vector<N>,
    overlap: f64,
    /// How the overlap changes as the normal turns.
    slope: Vector<N>,
}

/// The deepest pair of two ellipsoids of about unit size.
///
/// When they are apart there is one local minimum. When they overlap each way out may be one, and
/// the least is taken of those found from the line of centers and from all axes.
pub(crate) fn deepest_of_ellipsoids<const N: usize>(
    finger: &Ellipsoid<N>,
    part: &Ellipsoid<N>,
) -> DeepestPair<N> {
    let pair = Pair { finger, part: Some(part), apart: finger.center() - part.center() };
    let axes = [finger, part].into_iter().flat_map(|body| (0..N).map(|i| body.axes().column(i)));
    let starts = (-pair.apart).direction().into_iter().chain(axes.flat_map(|axis| [axis, -axis]));
    let least = starts
        .map(|start| pair.trial(pair.minimum(start)))
        .reduce(|best, trial| if trial.overlap < best.overlap { trial } else { best });
    let (depth, inward_normal) = least.map_or((0.0, Vector::ZERO), |t| (t.overlap, t.normal));
    let on_finger = finger.center() + finger.support_offset(inward_normal);
    let on_part = part.center() + part.support_offset(-inward_normal);
    DeepestPair { depth, inward_normal, on_finger, on_part }
}

impl<const N: usize> Pair<'_, N> {
    fn trial(&self, normal: Vector<N>) -> Trial<N> {
        let ours = self.finger.support_offset(normal);
        let theirs = self.part.map_or(Vector::ZERO, |part| part.support_offset(-normal));
        let overlap = self.apart.dot(normal) + ours.dot(normal) - theirs.dot(normal);
        let offset = self.apart + ours - theirs;
        Trial { normal, overlap, slope: offset - normal * normal.dot(offset) }
    }

    /// The normal of the local minimum that Newton's method finds from `start`.
    ///
    /// On the sphere of normals the second derivative is `S_A + S_B - delta P`, the sum of the
    /// radii of curvature less the overlap; where it is not positive the radii alone still show
    /// downhill.
    pub(super) fn minimum(&self, start: Vector<N>) -> Vector<N> {
        let size =
            self.finger.radius() + self.part.map_or(0.0, Ellipsoid::radius) + self.apart.norm();
        let mut at = self.trial(start);
        for _ in 0..MAX_STEPS {
            let along = Mat::outer(at.normal, at.normal);
            let across = Mat::IDENTITY + along * -1.0;
            let theirs = self.part.map_or(Mat::ZERO, |part| part.radii(-at.normal));
            let radii = self.finger.radii(at.normal) + theirs + along * size;
            let newton = Cholesky::new(&(radii + across * -at.overlap));
            let Ok(factors) = newton.or_else(|_| Cholesky::new(&radii)) else {
                break;
            };
            match self.line_search(&at, factors.solve(-at.slope), size) {
                Some(next) => at = next,
                None => break,
            }
        }
        at.normal
    }

    /// The first of ever shorter steps that is better, if any is.
    fn line_search(&self, at: &Trial<N>, step: Vector<N>, size: f64) -> Option<Trial<N>> {
        let promised = -at.slope.dot(step);
        let mut share = 1.0;
        for _ in 0..MAX_HALVINGS {
            let next = self.trial((at.normal + step * share).direction()?);
            let due = SUFFICIENT_DECREASE * share * promised;
            let falls = due > LEVEL * size && next.overlap < at.overlap - due;
            let levels = next.overlap <= at.overlap + LEVEL * size
                && next.slope.norm() < 0.5 * at.slope.norm();
            if falls || levels {
                return Some(next);
            }
            share *= 0.5;
        }
        None
    }
}

/// The normals by which an ellipsoid may be separated from a point: the one of least overlap, the
/// local minimum on the other side of the longer axes, and the one that is found from `m`.
pub(super) fn normals_at_point<const N: usize>(
    body: &Ellipsoid<N>,
    point: Vector<N>,
    m: Vector<N>,
) -> [Vector<N>; 3] {
    let pair = Pair { finger: body, part: None, apart: body.center() - point };
    let nearest = -body.nearest(point).boundary.inward_normal;
    let axes = body.semi_axes();
    let short = (1..N).fold(0, |short, i| if axes[i] < axes[short] { i } else { short });
    let across = body.axes().column(short);
    let mirrored = nearest - across * (2.0 * across.dot(nearest));
    [nearest, pair.minimum(mirrored), pair.minimum(m)]
}
