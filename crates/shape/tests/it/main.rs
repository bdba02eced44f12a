//! The tests of clench-shape, in one binary.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::float_cmp,
    reason = "a test that cannot go on fails, and exact results are compared exactly"
)]

mod accessible;
mod cases;
mod crossings;
mod deepest;
mod disc_tip;
mod ellipsoid;
mod facets;
mod holes;
mod laws;
mod limits;
mod polyhedron;
mod polyhedron_limits;
mod reach;
mod shells;
mod solids;
mod split_sides;
