//! The report on the drawing that a part is from.

use clench::drawing::{DrawnPart, Reason, Repeat, Source, Unit};
use serde::Serialize;

use super::number::UnitNames;
use super::page::Page;
use crate::input::Drawn;
use crate::wording::{counted, digits, layer_name};

/// Smaller parts of the size are not worth a word: ends that meet differ so by rounding.
const SMALLEST_GAP: f64 = 1e-10;

/// What was read from a drawing, and what was not.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct DrawingReport {
    pub(crate) name: String,
    /// As the drawing names it; none if it does not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) unit: Option<&'static str>,
    /// What lengths of the drawing were multiplied with.
    pub(crate) scale: f64,
    /// The curves that the outline and its holes consist of.
    pub(crate) curves: usize,
    pub(crate) layers: Vec<String>,
    /// How far edges are from their curves at most (length); 0 if all curves are straight.
    pub(crate) chord: f64,
    /// The largest distance of ends that were joined (length).
    pub(crate) largest_gap: f64,
    /// Curves that repeat another one, each in words.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) repeated: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) left_aside: Vec<LeftAside>,
    /// The largest gap that is worth no word (length).
    #[serde(skip)]
    rounding: f64,
    /// What is to be said of style sheets, which are named among what was left aside.
    #[serde(skip)]
    styles: Option<String>,
}

/// What is no part of the outline.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct LeftAside {
    pub(crate) kind: String,
    pub(crate) layer: String,
    pub(crate) reason: String,
    pub(crate) count: usize,
}

impl DrawingReport {
    /// The report on this drawing.
    pub(crate) fn new(drawn: &Drawn) -> Self {
        let part = &drawn.part;
        let mut layers: Vec<String> = Vec::new();
        for Source { layer, .. } in part.sources() {
            if !layers.contains(layer) {
                layers.push(layer.clone());
            }
        }
        let aside = part.left_aside().iter().map(|aside| LeftAside {
            kind: aside.kind.clone(),
            layer: aside.layer.clone(),
            reason: aside.reason.to_string(),
            count: aside.count,
        });
        let repeated = part.repeats().iter();
        let repeated =
            repeated.map(|Repeat { left_out, kept }| format!("{left_out} repeats {kept}"));
        Self {
            name: drawn.name.clone(),
            unit: drawn.unit.map(Unit::name),
            scale: drawn.scale,
            curves: part.sources().len(),
            layers,
            chord: part.chord(),
            largest_gap: part.largest_gap(),
            repeated: repeated.collect(),
            left_aside: aside.collect(),
            rounding: SMALLEST_GAP * part.polygon().enclosing_circle().radius,
            styles: styles(part),
        }
    }

    /// What might be wrong with what was read.
    pub(super) fn warnings(&self) -> impl Iterator<Item = String> {
        let repeated = self.repeated.iter().map(|repeated| format!("{repeated}: left out"));
        repeated.chain(self.styles.clone())
    }

    /// The same in words, without the warnings.
    pub(super) fn facts(&self, page: &mut Page, units: UnitNames<'_>) {
        let curves = counted(self.curves, "curve");
        let layers = match &self.layers[..] {
            [layer] => layer_name(layer),
            layers => format!("layers {}", layers.join(", ")),
        };
        let unit = match self.unit {
            None => "its unit as given".to_owned(),
            Some(unit) if unit == units.0.length.0 => format!("in {unit}"),
            Some(unit) => format!("in {unit}: lengths times {}", digits(self.scale)),
        };
        page.head("drawing", format_args!("{}, {unit}; {curves} on {layers}", self.name));
        let chord = (self.chord > 0.0)
            .then(|| format!("edges are within {} of its curves", units.length(self.chord)));
        let gap = (self.largest_gap > self.rounding)
            .then(|| format!("gaps up to {} are closed", units.length(self.largest_gap)));
        let read: Vec<String> = chord.into_iter().chain(gap).collect();
        if !read.is_empty() {
            page.head("", read.join("; "));
        }
        for (i, LeftAside { kind, layer, reason, count }) in self.left_aside.iter().enumerate() {
            let label = if i == 0 { "aside" } else { "" };
            page.head(label, format_args!("{count} {kind} on {}: {reason}", layer_name(layer)));
        }
    }
}

/// What is to be said of style sheets.
fn styles(part: &DrawnPart) -> Option<String> {
    let count = |reason| {
        let found = part.left_aside().iter().filter(|aside| aside.reason == reason);
        found.map(|aside| aside.count).sum::<usize>()
    };
    let classes = match count(Reason::Class) {
        0 => String::new(),
        count => format!(", such as {} with a class,", counted(count, "shape")),
    };
    let taken = "is taken as it is without them";
    (count(Reason::StyleSheet) > 0)
        .then(|| format!("style sheets are not read: what they hide or change{classes} {taken}"))
}
