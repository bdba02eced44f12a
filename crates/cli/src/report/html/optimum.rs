//! The page on the best placements.

use maud::{Markup, PreEscaped, html};

use super::inputs::Inputs;
use super::legend;
use super::page::written;
use super::sheet::{Headline, Section, Sheet, Tone};
use super::typeset::typeset;
use super::viewer;
use crate::failure::Failure;
use crate::picture::{Figures, Scene};
use crate::report::drawing::DrawingReport;
use crate::report::optimum_text::OptimumText;
use crate::report::page::{Line, Page};
use crate::report::words::{EndWord, ObjectiveWord};
use crate::wording::rough_digits;

/// The page on the placements of `text`.
pub(crate) fn of_optimum(
    text: &OptimumText<'_>,
    figures: &Figures,
    inputs: Inputs<'_>,
) -> Result<String, Failure> {
    let certificate = |page: &mut Page| {
        text.certificate(page);
        text.conditions(page);
        text.ties(page);
    };
    let planar = text.report.best.in_plane.is_some();
    let placement = viewer::figure(figures, &[], &legend::grasp(planar, true));
    let sections = [
        Section::filled("Placement", placement),
        Section::filled("Certificate", written(certificate)),
        Section::filled("Fingers", written(|page| text.fingers(page))),
        Section::filled("Stiffness", written(|page| text.metrics(page))),
        Section::filled("Ranking", ranking(text, figures)),
    ];
    let mut facts = Page::default();
    if let Some(drawing) = text.report.question.drawing {
        drawing.facts(&mut facts, text.units());
    }
    text.facts(&mut facts);
    let scene = figures.scene.as_ref().map(Scene::json).transpose()?;
    let sheet = Sheet {
        title: text.name,
        units: text.units().to_string(),
        headline: Some(headline(text)),
        warnings: warnings(text),
        facts,
        sections: sections.into_iter().flatten().collect(),
        scene,
        inputs,
    };
    Ok(sheet.document())
}

/// The best combinations, in a table and in small pictures.
fn ranking(text: &OptimumText<'_>, figures: &Figures) -> Markup {
    if text.report.top.is_empty() {
        return html!();
    }
    let mut page = Page::default();
    text.top(&mut page);
    let objective = text.report.question.objective;
    let value = |i: usize| {
        let placement = text.report.top.get(i)?;
        let value = text.units().stiffness(placement.value(objective));
        Some(format!("{}: {objective} = {value}", i + 1))
    };
    html! {
        (page)
        div.places {
            @for (i, picture) in figures.places.iter().enumerate() {
                figure {
                    (PreEscaped(picture))
                    figcaption { @if let Some(value) = value(i) { (typeset(&value)) } }
                }
            }
        }
    }
}

/// What was maximized, and what is proved of it.
fn headline(text: &OptimumText<'_>) -> Headline {
    let (report, units) = (text.report, text.units());
    let (objective, certificate) = (report.question.objective, report.certificate);
    let value = units.stiffness(report.best.value(objective));
    let quality = match objective {
        ObjectiveWord::Quality => format!(", limited by {}", report.best.limited_by),
        _ => format!("; Q = {}", units.stiffness(report.best.quality)),
    };
    let gap = rough_digits(certificate.gap);
    let badge = match certificate.ended {
        EndWord::Proved => (Tone::Good, "proved best".to_owned()),
        EndWord::Gap => (Tone::Good, format!("proved best but for a gap of {gap}")),
        _ => (Tone::Fair, format!("stopped at a gap of {gap}")),
    };
    Headline { text: format!("{objective} = {value}{quality}"), badges: vec![badge] }
}

/// The warnings of the text, whose limits on a solid are lines of their own.
fn warnings(text: &OptimumText<'_>) -> Vec<String> {
    let drawn = text.report.question.drawing.into_iter().flat_map(DrawingReport::warnings);
    let mut page = Page::default();
    text.limits(&mut page);
    let texts = page.lines().iter().filter_map(|line| match line {
        Line::Head { text, .. } => Some(text.clone()),
        _ => None,
    });
    drawn.chain(text.report.question.warnings.iter().cloned()).chain(texts).collect()
}
