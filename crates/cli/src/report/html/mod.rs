//! A report as one page for a browser: it opens offline and asks nobody for anything.
//!
//! Words and numbers are those of the text report, whose pages are set as tables and lists here;
//! only the head, the pictures and the inputs are the page's own.

mod analysis;
mod inputs;
mod legend;
mod optimum;
mod page;
mod sheet;
mod typeset;
mod viewer;

pub(crate) use analysis::of_analysis;
pub(crate) use inputs::{Inputs, Source};
pub(crate) use optimum::of_optimum;
