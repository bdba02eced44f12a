//! Reports: what is known, as JSON and as text. The text is made from the same numbers.

mod access;
mod analysis;
mod analysis_text;
mod verdict;

mod axes;
mod measures;
mod measures_text;
mod quality;
mod stiffness_text;

mod case_verdict;
mod case_verdict_text;
mod load_case;
mod load_case_text;
mod needed;
mod needed_text;

mod robustness;
mod robustness_text;

mod optimum;
mod optimum_text;
mod second_order;
mod subject;

pub(crate) mod html;

mod drawing;
mod number;
mod page;
mod words;

use serde::Serialize;

use crate::failure::Failure;

pub(crate) use access::{AccessReport, MeetsReport, OutlineReport, SurfaceReport};
pub(crate) use analysis::AnalysisReport;
pub(crate) use analysis_text::AnalysisText;
pub(crate) use drawing::DrawingReport;
pub(crate) use number::{UnitNames, spot};
pub(crate) use optimum::{
    EffortReport, OptimumInPlane, OptimumReport, PlacementReport, Question, UnansweredReport,
};
pub(crate) use optimum_text::OptimumText;
pub(crate) use subject::{SolidSubject, Subject, in_pieces};
pub(crate) use words::{LimitWord, ObjectiveWord};

/// A report as JSON.
pub(crate) fn json(report: &impl Serialize) -> Result<String, Failure> {
    let mut text = serde_json::to_string_pretty(report)?;
    text.push('\n');
    Ok(text)
}
