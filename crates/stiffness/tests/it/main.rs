//! The tests of clench-stiffness, in one binary.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::float_cmp,
    reason = "a test that cannot go on fails, and exact results are compared exactly"
)]

mod laws;
mod limits;
mod needed_preloads;
mod random;
mod reactions;
mod response;
