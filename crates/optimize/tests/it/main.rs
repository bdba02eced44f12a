//! The tests of clench-optimize, in one binary.

mod cases;
