//! The tests of clench-stiffness, in one binary.

mod laws;
mod limits;
mod random;
