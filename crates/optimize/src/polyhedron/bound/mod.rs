//! Upper bounds over all placements on some pieces of the surface; [`super`] derives them.

mod closure;
mod cut;
mod cylinder;
mod node;
mod pieces;
mod relaxation;

pub(crate) use closure::{Contacts, helped_twist};
pub(crate) use cut::Cut;
pub(crate) use cylinder::least_cylinder_squared;
pub(crate) use pieces::Pieces;
pub(crate) use relaxation::{Hint, Relaxation};

/// Bounds and their tests are rounded by this many units times the sizes that they are made of.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
