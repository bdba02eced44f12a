//! Branch and bound over pieces of the boundary of a part, for any number of fingers.

pub(crate) mod boxes;
mod floor;
mod piece;

mod answer;
mod branch;
mod leaders;

pub(crate) use answer::{Matter, choose, outcome};
pub(crate) use branch::{Bounded, Problem, Settled, search};
pub(crate) use floor::{Floor, above, below};
pub(crate) use leaders::{Candidate, Leaders};
pub(crate) use piece::Piece;
