//! The tests of clench-metrics, in one binary.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::float_cmp,
    reason = "a test that cannot go on fails, and exact results are compared exactly"
)]

mod beam_section;
mod definitions;
mod laws;
mod limits;
mod sensitivity;
mod springs;
mod trials;
