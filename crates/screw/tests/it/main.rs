//! The tests of clench-screw, in one binary.

mod cases;
mod laws;
mod limits;
