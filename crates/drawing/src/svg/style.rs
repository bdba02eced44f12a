//! What decides whether an element of an SVG file is seen.

use roxmltree::{Document, Node};

use crate::source::Reason;

/// The properties of an element that are its own or those of what is around it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Style {
    /// Not displayed, with all that is in it.
    absent: bool,
    invisible: bool,
    broken: bool,
}

impl Style {
    /// The properties of what is in `node`, or of itself.
    pub(super) fn within(self, node: Node<'_, '_>) -> Self {
        let mut style = self;
        if property(node, "display").is_some_and(|value| value == "none") {
            style.absent = true;
        }
        if let Some(value) = property(node, "visibility") {
            style.invisible = value != "visible" && value != "inherit";
        }
        if let Some(value) = property(node, "stroke-dasharray") {
            style.broken = is_broken(value);
        }
        style
    }

    /// Why such an element is no part of the outline, if it is none.
    pub(super) const fn reason(self) -> Option<Reason> {
        if self.absent || self.invisible {
            Some(Reason::Hidden)
        } else if self.broken {
            Some(Reason::Broken)
        } else {
            None
        }
    }
}

/// Whether a line with these dashes and gaps has any: if all are 0 it is solid, and so it is if one
/// is negative.
fn is_broken(dashes: &str) -> bool {
    let is_unit = |c: char| c.is_ascii_alphabetic() || c == '%';
    let number = |dash: &str| dash.trim_end_matches(is_unit).parse::<f64>().ok();
    let parts = dashes.split(|c: char| c == ',' || c.is_ascii_whitespace());
    let numbers: Vec<f64> = parts.filter_map(number).collect();
    numbers.iter().any(|dash| *dash > 0.0) && !numbers.iter().any(|dash| *dash < 0.0)
}

/// What the style sheets of a file are in, each by its name; those without rules are none.
pub(super) fn sheets<'a>(document: &'a Document<'_>) -> impl Iterator<Item = &'a str> {
    let has_rules = |node: Node<'_, '_>| {
        let mut texts = node.children().filter_map(|child| child.text());
        texts.any(|text| !text.trim().is_empty())
    };
    document.descendants().filter_map(move |node| {
        let linked = node.pi().map(|instruction| instruction.target);
        let own = (node.tag_name().name() == "style" && has_rules(node)).then_some("style");
        linked.filter(|target| *target == "xml-stylesheet").or(own)
    })
}

/// A property by the `style` of an element, or else by an attribute.
fn property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let styled = node.attribute("style").and_then(|style| {
        let mut pairs = style.split(';').filter_map(|pair| pair.split_once(':'));
        pairs.rfind(|(key, _)| key.trim() == name).map(|(_, value)| value.trim())
    });
    styled.or_else(|| node.attribute(name).map(str::trim))
}
