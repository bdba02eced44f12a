//! What the tests of all crates share: reference cases, random input, close-enough asserts.
//!
//! Knows none of the other crates, so that each of them can be tested alone.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on fails"
)]

pub mod cases;
mod close;
pub mod drawings;
mod random;
pub mod solids;

pub use close::{assert_all_close, assert_close};
pub use random::Random;
