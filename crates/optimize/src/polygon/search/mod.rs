//! Branch and bound, for any number of fingers.

mod answer;
mod ascent;
mod branch;
mod leaders;

pub(crate) use answer::{Matter, choose, outcome};
pub(crate) use ascent::{ascents, climb};
pub(crate) use branch::{Problem, Settled, search};
pub(crate) use leaders::{Candidate, Leaders};
