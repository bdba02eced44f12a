//! Pictures as a caller sees them.
#![cfg(test)]

mod limits;
mod paper;
#[cfg(feature = "png")]
mod png;
mod svg;
