//! Where the edges of a part are from, and what on a drawing is no part of it.

use std::collections::BTreeMap;
use std::fmt;

use crate::wording::{Layer, Quoted};

/// A curve of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// What the file calls such a thing: `LINE`, `path`.
    pub kind: String,
    /// Its handle in DXF, its `id` in SVG.
    pub name: Option<String>,
    /// The layer that it is on; empty if it is on none, as in SVG outside of groups.
    pub layer: String,
    /// The line of the file that it starts on, from 1.
    pub line: usize,
}

/// Things on the drawing that are no part of the outline or a hole, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftAside {
    /// What the file calls such a thing: `TEXT`, `image`.
    pub kind: String,
    /// The layer that they are on; empty for none.
    pub layer: String,
    /// Why they are left aside.
    pub reason: Reason,
    /// How many there are of this kind, on this layer, for this reason.
    pub count: usize,
}

/// Why something on a drawing is no part of the outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Reason {
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
    /// A shape of SVG without a width, a height or a path, which SVG does not draw.
    NoSize,
    /// A style sheet, which could hide what was read.
    StyleSheet,
    /// The class of a shape that is on the part all the same, though a style sheet could hide it.
    Class,
}

/// How many of a kind on a layer are left aside for a reason.
#[derive(Clone, Debug, Default)]
pub(crate) struct Aside(BTreeMap<(String, String, Reason), usize>);

impl Aside {
    /// Takes note of one more.
    pub(crate) fn note(&mut self, kind: &str, layer: &str, reason: Reason) {
        *self.0.entry((kind.to_owned(), layer.to_owned(), reason)).or_default() += 1;
    }

    /// By kind, layer and reason.
    pub(crate) fn list(&self) -> Vec<LeftAside> {
        let entry = |((kind, layer, reason), count): (&(String, String, Reason), &usize)| {
            let (kind, layer) = (kind.clone(), layer.clone());
            LeftAside { kind, layer, reason: *reason, count: *count }
        };
        self.0.iter().map(entry).collect()
    }
}

impl fmt::Display for Source {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, name, layer, line } = self;
        write!(out, "the {kind}")?;
        if let Some(name) = name {
            write!(out, " {}", Quoted(name))?;
        }
        write!(out, " at line {line}, on {}", Layer(layer))
    }
}

impl fmt::Display for LeftAside {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, layer, reason, count } = self;
        write!(out, "{count} {kind} on {} ({reason})", Layer(layer))
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::NoCurve => "no curve",
            Self::OtherLayer => "another layer",
            Self::Hidden => "hidden",
            Self::Broken => "a broken line",
            Self::OffPlane => "not in the plane",
            Self::Paper => "on paper",
            Self::NoSize => "without a size",
            Self::StyleSheet => "style sheets are not read",
            Self::Class => "classes are not read",
        })
    }
}
