//! The report on the drawing that a part is from.

use clench::drawing::{Repeat, Source, Unit};
use serde::Serialize;

use super::number::UnitNames;
use super::page::Page;
use crate::input::Drawn;
use crate::wording::{counted, digits, layer_name};

/// Smaller parts of the chord are not worth a word: ends that meet differ so by rounding.
const SMALLEST_GAP: f64 = 1e-6;

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
    /// How far edges are from their curves at most (length).
    pub(crate) chord: f64,
    /// The largest distance of ends that were joined (length).
    pub(crate) largest_gap: f64,
    /// Curves that repeat another one, each in words.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) repeated: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) left_aside: Vec<LeftAside>,
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
        }
    }

    /// The same in words.
    pub(super) fn head(&self, page: &mut Page, units: UnitNames<'_>) {
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
        let chord = units.length(self.chord);
        let gap = match self.largest_gap {
            gap if gap > SMALLEST_GAP * self.chord => {
                format!("; gaps up to {} are closed", units.length(gap))
            }
            _ => String::new(),
        };
        page.head("", format_args!("edges are within {chord} of its curves{gap}"));
        for repeated in &self.repeated {
            page.head("warning", format_args!("{repeated}: left out"));
        }
        for (i, LeftAside { kind, layer, reason, count }) in self.left_aside.iter().enumerate() {
            let label = if i == 0 { "aside" } else { "" };
            page.head(label, format_args!("{count} {kind} on {}: {reason}", layer_name(layer)));
        }
    }
}
