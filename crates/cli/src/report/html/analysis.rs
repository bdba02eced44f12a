//! The page on a grasp.

use maud::{Markup, PreEscaped, html};

use super::inputs::Inputs;
use super::legend;
use super::page::{table, written};
use super::sheet::{Headline, Section, Sheet, Tone};
use super::viewer;
use crate::failure::Failure;
use crate::picture::{Figures, Scene};
use crate::report::UnitNames;
use crate::report::analysis_text::AnalysisText;
use crate::report::drawing::DrawingReport;
use crate::report::load_case::{LoadCaseReport, Turning};
use crate::report::page::Page;
use crate::wording::digits;

/// The page on the grasp of `text`.
pub(crate) fn of_analysis(
    text: &AnalysisText<'_>,
    figures: &Figures,
    inputs: Inputs<'_>,
) -> Result<String, Failure> {
    let report = text.report;
    let contacts = |page: &mut Page| {
        text.contacts(page);
        text.areas(page);
        text.loads(page);
    };
    let numbers = |page: &mut Page| {
        text.metrics(page);
        text.holding(page);
        text.axes(page);
    };
    let sections = [
        Section::filled("Grasp", grasp(text, figures)),
        Section::filled("Load cases", load_cases(text, figures)),
        Section::filled("Preloads that the load cases need", needed(text)),
        Section::filled("Contacts", written(contacts)),
        Section::filled("Stiffness", written(numbers)),
        Section::filled("Robustness", written(|page| text.robustness(page))),
        Section::filled("Stiffness matrix", written(|page| text.stiffness(page))),
    ];
    let mut facts = Page::default();
    if let Some(drawing) = &report.drawing {
        drawing.facts(&mut facts, text.units());
    }
    text.facts(&mut facts);
    let drawn = report.drawing.iter().flat_map(DrawingReport::warnings);
    let scene = figures.scene.as_ref().map(Scene::json).transpose()?;
    let sheet = Sheet {
        title: text.name,
        units: text.units().to_string(),
        headline: headline(text),
        warnings: drawn.chain(report.warnings.iter().cloned()).collect(),
        facts,
        sections: sections.into_iter().flatten().collect(),
        scene,
        inputs,
    };
    Ok(sheet.document())
}

fn headline(text: &AnalysisText<'_>) -> Option<Headline> {
    let report = text.report;
    if let Some(reason) = &report.reason {
        let badges = vec![(Tone::Bad, "no answer".to_owned())];
        return Some(Headline { text: reason.clone(), badges });
    }
    let quality = &report.metrics.as_ref()?.quality;
    let q = text.units().stiffness(quality.quality);
    let (by, proved) = (quality.limited_by, text.proved(quality.quality_at_least));
    let verdict = report.verdict.as_ref().map(|verdict| {
        let tone = if verdict.passes { Tone::Good } else { Tone::Bad };
        (tone, verdict.in_words(&report.load_cases))
    });
    let badges = std::iter::once((Tone::Good, "held".to_owned())).chain(verdict).collect();
    Some(Headline { text: format!("Q = {q}, limited by {by}{proved}"), badges })
}

fn grasp(text: &AnalysisText<'_>, figures: &Figures) -> Markup {
    let cases = text.report.load_cases.iter().zip(&figures.cases).enumerate();
    let cases: Vec<_> = cases
        .map(|(i, (case, figure))| format!("{}, {}", case.title(i), drawn(figure.exaggeration)))
        .collect();
    let turned = !text.report.frame.is_of_file();
    let caption = html! {
        (legend::grasp(text.planar(), text.report.metrics.is_some()))
        @if turned { " The picture is in the frame of the file." }
    };
    viewer::figure(figures, &cases, &caption)
}

/// How the displacement of a load case is drawn.
fn drawn(exaggeration: Option<f64>) -> String {
    exaggeration.map_or_else(
        || "nothing moves".to_owned(),
        |times| format!("displacement drawn {} times as large", digits(times)),
    )
}

/// What of the load is drawn.
fn acting(case: &LoadCaseReport, units: UnitNames<'_>) -> String {
    let force =
        if case.point.is_some() || !case.forces.is_empty() { "Purple: the force." } else { "" };
    let couple = case.couple.as_ref().map_or_else(String::new, |Turning(couple)| {
        format!(" Not drawn: the couple, {}.", units.torques(couple))
    });
    format!("{force}{couple}")
}

/// All load cases in a table, and each by itself.
fn load_cases(text: &AnalysisText<'_>, figures: &Figures) -> Markup {
    let cases = &text.report.load_cases;
    html! {
        @if !cases.is_empty() { (table(&text.load_case_rows())) }
        @for (number, (case, figure)) in cases.iter().zip(&figures.cases).enumerate() {
            h3 { (case.title(number)) }
            figure {
                (PreEscaped(&figure.svg))
                figcaption {
                    "Orange: the part under the load, " (drawn(figure.exaggeration))
                    ". " (acting(case, text.units())) " " (legend::forces(text.planar()))
                }
            }
            (one(text, number, case))
        }
    }
}

fn needed(text: &AnalysisText<'_>) -> Markup {
    let mut page = Page::default();
    text.needed_preloads(&mut page);
    html!((page))
}

fn one(text: &AnalysisText<'_>, number: usize, case: &LoadCaseReport) -> Markup {
    let mut page = Page::default();
    text.load_case(&mut page, number, case);
    html!((page))
}
