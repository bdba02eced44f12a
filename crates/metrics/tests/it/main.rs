//! The tests of clench-metrics, in one binary.

mod laws;
mod limits;
