//! The tests of clench-optimize, in one binary.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::float_cmp,
    reason = "a test that cannot go on fails, and exact results are compared exactly"
)]

mod adversarial;
mod cases;
mod laws;
mod limits;
mod sampling;
mod solid_limits;
mod solid_tips;
mod solids;
