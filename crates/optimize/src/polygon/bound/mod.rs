//! Upper bounds over all placements on some pieces of the boundary; [`super`] derives them.

mod closure;
mod cut;
mod demand;
mod floor;
mod middle;
mod pieces;
mod relaxation;

use clench_screw::Vector;

#[cfg(test)]
pub(crate) use closure::cuts as closure_cuts;
pub(crate) use closure::is_excluded;
pub(crate) use cut::Cut;
#[cfg(test)]
pub(crate) use cut::slack;
pub(crate) use demand::{Demand, Verdict};
pub(crate) use middle::Middle;
pub(crate) use pieces::{Pieces, Range};
pub(crate) use relaxation::Relaxation;

/// Bounds and their tests are rounded by this many units times the sizes that they are made of.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A `sigma_min` of this part of the stiffnesses is rounding: that of a bound, and as much again.
pub(crate) const NO_TRANSLATION: f64 = 4.0 * ROUNDING;

/// The first two components of a scaled wrench.
fn arm(p: Vector<3>) -> Vector<2> {
    Vector::new([p[0], p[1]])
}
