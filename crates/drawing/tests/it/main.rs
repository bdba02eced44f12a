//! The tests of clench-drawing, in one binary.
#![cfg(test)]

mod dxf;
mod dxf_rules;
mod files;
mod refusals;
mod sketch;
mod svg;
mod svg_rules;
