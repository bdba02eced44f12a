//! The layers together: the grasps of an independent program, the printed paper, and bodies that
//! are really moved.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::float_cmp,
    reason = "a test that cannot go on fails, and exact results are compared exactly"
)]

mod bodies;
mod case;
mod cases;
mod metrics;
mod sensitivity;
