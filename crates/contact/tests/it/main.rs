//! The tests of clench-contact, in one binary.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::float_cmp,
    reason = "a test that cannot go on fails, and exact results are compared exactly"
)]

mod cases;
mod changes;
mod known;
mod laws;
mod limits;
mod parry;
mod surfaces;
