//! Pictures as a caller sees them.
#![cfg(test)]

mod chart;
mod contact;
mod limits;
mod loaded;
mod paper;
#[cfg(feature = "png")]
mod png;
mod solid;
mod solid_limits;
mod solids;
mod svg;
