//! What decides whether an element of an SVG file is seen.

use roxmltree::Node;

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
            let gap = |part: &str| {
                part.trim().starts_with(|c: char| ('1'..='9').contains(&c) || c == '.' || c == '0')
            };
            style.broken = value != "none" && value.split([',', ' ']).any(gap);
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

/// A property by the `style` of an element, or else by an attribute.
fn property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let styled = node.attribute("style").and_then(|style| {
        let mut pairs = style.split(';').filter_map(|pair| pair.split_once(':'));
        pairs.rfind(|(key, _)| key.trim() == name).map(|(_, value)| value.trim())
    });
    styled.or_else(|| node.attribute(name).map(str::trim))
}
