//! The tests of clench-drawing, in one binary.
#![cfg(test)]

mod dxf;
mod files;
mod refusals;
mod sketch;
mod svg;
