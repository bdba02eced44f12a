//! What a drawing has on it: curves with their sources, and what was left aside.

use std::collections::BTreeMap;
use std::fmt;

use super::curve::Curve;
use crate::wording::quoted;

/// One drawing as its file has it.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    /// The unit of its numbers, if the file names one.
    pub(super) unit: Option<Unit>,
    pub(super) sources: Vec<Source>,
    pub(super) strands: Vec<Strand>,
    pub(super) aside: Aside,
    /// The names of all layers with something on them, in the order of the file.
    pub(super) layers: Vec<String>,
}

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Unit {
    pub(crate) name: &'static str,
    /// In micrometers, of which most units are whole numbers.
    pub(crate) micrometers: f64,
}

/// Where a curve is from.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Source {
    /// What the file calls such a thing: `LINE`, `path`.
    pub(crate) kind: String,
    /// Its handle or its `id`.
    pub(crate) name: Option<String>,
    pub(crate) layer: String,
    /// The line of the file that it starts on, from 1.
    pub(crate) line: usize,
}

/// Curves that follow each other.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Strand {
    /// The number of its source.
    pub(super) source: usize,
    pub(super) curves: Vec<Curve>,
}

/// What was left aside: how many of a kind on a layer, and why.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Aside(BTreeMap<(String, String, Reason), usize>);

/// Why something on a drawing is no part of the outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Reason {
    /// Text, dimensions, hatches, points, solids.
    NoCurve,
    /// On a layer that was not asked for.
    OtherLayer,
    /// On a layer that is off, frozen or not plotted, or hidden by itself.
    Hidden,
    /// Drawn with gaps, as center lines and hidden edges are.
    Broken,
    /// Not in the plane of the drawing.
    OffPlane,
    /// On a sheet of paper rather than in the model.
    Paper,
}

impl Reason {
    /// In words.
    pub(crate) const fn words(self) -> &'static str {
        match self {
            Self::NoCurve => "no curve",
            Self::OtherLayer => "another layer",
            Self::Hidden => "hidden",
            Self::Broken => "a broken line",
            Self::OffPlane => "not in the plane",
            Self::Paper => "on paper",
        }
    }
}

impl Aside {
    /// Takes note of one more.
    pub(super) fn note(&mut self, kind: &str, layer: &str, reason: Reason) {
        *self.0.entry((kind.to_owned(), layer.to_owned(), reason)).or_default() += 1;
    }

    /// Each kind, layer and reason with its number.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (&str, &str, Reason, usize)> {
        self.0
            .iter()
            .map(|((kind, layer, reason), count)| (kind.as_str(), layer.as_str(), *reason, *count))
    }

    /// Whether there was nothing.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl fmt::Display for Aside {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (kind, layer, reason, count)) in self.iter().enumerate() {
            let comma = if i == 0 { "" } else { ", " };
            write!(out, "{comma}{count} {kind} on {} ({})", layer_name(layer), reason.words())?;
        }
        Ok(())
    }
}

impl fmt::Display for Source {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, name, layer, line } = self;
        let name = name.as_ref().map(|name| format!(" {}", quoted(name))).unwrap_or_default();
        write!(out, "the {kind}{name} at line {line}, on {}", layer_name(layer))
    }
}

/// A layer in a message.
pub(crate) fn layer_name(layer: &str) -> String {
    if layer.is_empty() { "no layer".to_owned() } else { format!("layer {}", quoted(layer)) }
}
