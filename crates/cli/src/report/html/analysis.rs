//! The page on a grasp.

use maud::{Markup, PreEscaped, html};

use super::inputs::Inputs;
use super::page::table;
use super::sheet::{Headline, Section, Sheet, Tone};
use crate::picture::Figures;
use crate::report::analysis_text::AnalysisText;
use crate::report::load_case::{LiftOffReport, LoadCaseReport};
use crate::report::page::Page;
use crate::wording::digits;

/// The page on the grasp of `text`.
pub(crate) fn of_analysis(
    text: &AnalysisText<'_>,
    figures: &Figures,
    inputs: Inputs<'_>,
) -> String {
    let report = text.report;
    let set = |write: &dyn Fn(&mut Page)| {
        let mut page = Page::default();
        write(&mut page);
        html!((page))
    };
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
        Section::filled("Load cases", load_cases(text)),
        Section::filled("Contacts", set(&contacts)),
        Section::filled("Stiffness", set(&numbers)),
        Section::filled("Stiffness matrix", set(&|page| text.stiffness(page))),
    ];
    let mut facts = Page::default();
    text.facts(&mut facts);
    Sheet {
        title: text.name,
        units: text.units().to_string(),
        headline: headline(text),
        warnings: report.warnings.clone(),
        facts,
        sections: sections.into_iter().flatten().collect(),
        inputs,
    }
    .document()
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
    let badges = vec![(Tone::Good, "held".to_owned())];
    Some(Headline { text: format!("Q = {q}, limited by {by}{proved}"), badges })
}

fn grasp(text: &AnalysisText<'_>, figures: &Figures) -> Markup {
    let turned = !text.report.frame.is_of_file();
    html! {
        figure {
            (PreEscaped(&figures.grasp))
            @if turned { figcaption { "The picture is in the frame of the file." } }
        }
    }
}

/// All load cases in a table, and each by itself.
fn load_cases(text: &AnalysisText<'_>) -> Markup {
    let cases = &text.report.load_cases;
    html! {
        @if !cases.is_empty() { (table(&at_a_glance(text, cases))) }
        @for (number, case) in cases.iter().enumerate() {
            h3 { (case.title(number)) }
            (one(text, number, case))
        }
    }
}

fn one(text: &AnalysisText<'_>, number: usize, case: &LoadCaseReport) -> Markup {
    let mut page = Page::default();
    text.load_case(&mut page, number, case);
    html!((page))
}

fn at_a_glance(text: &AnalysisText<'_>, cases: &[LoadCaseReport]) -> Vec<Vec<String>> {
    let length = &text.report.units.length;
    let mut rows = vec![vec![
        "load case".to_owned(),
        format!("largest displacement [{length}]"),
        format!("allowed [{length}]"),
        "tolerance used up at".to_owned(),
        "first to lift off".to_owned(),
        "at times the load".to_owned(),
    ]];
    let number = |value: Option<f64>| value.map_or_else(String::new, digits);
    for (i, case) in cases.iter().enumerate() {
        let lift_off = case.first_to_lift_off.as_ref();
        rows.push(vec![
            case.name.clone().unwrap_or_else(|| i.to_string()),
            digits(case.largest.distance),
            number(case.tolerance),
            case.margin.map_or_else(String::new, |margin| format!("{} times", digits(margin))),
            lift_off.map_or_else(
                || "none".to_owned(),
                |LiftOffReport { contact, .. }| format!("contact {contact}"),
            ),
            number(lift_off.map(|first| first.load_factor)),
        ]);
    }
    rows
}
