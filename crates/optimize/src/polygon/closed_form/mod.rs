//! The best placement of four fingers on four stretches, by closed forms; [`super`] derives them.

mod convex;
mod quadruple;
mod ratio;

pub(crate) use convex::Convex;
pub(crate) use quadruple::Quadruple;
