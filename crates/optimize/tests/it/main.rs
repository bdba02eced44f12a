//! The tests of clench-optimize, in one binary.

mod cases;
mod laws;
mod limits;
mod sampling;
