//! A line of text with sub- and superscripts, and how wide it runs.

use std::fmt::Write;

use crate::number::number;
use crate::paint::Color;

/// Sizes of letters all pictures share, in page units: headings, names, numbers.
pub(crate) const TITLE_SIZE: f64 = 17.0;
pub(crate) const LABEL_SIZE: f64 = 15.0;
pub(crate) const SMALL_SIZE: f64 = 13.0;

/// Size of a script, and how far it is moved, in parts of the text size.
const SCRIPT_SIZE: f64 = 0.72;
const SUBSCRIPT_DROP: f64 = 0.24;
const SUPERSCRIPT_RISE: f64 = 0.36;

/// Height of a capital letter of the bundled font, in parts of the text size.
const CAP_HEIGHT: f64 = 0.73;

/// Which point of a text stands at its anchor point; vertically it is always the middle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Anchor {
    /// The left end.
    Start,
    /// The middle.
    #[default]
    Middle,
    /// The right end.
    End,
}

/// One line of text.
///
/// `_{…}` lowers and `^{…}` raises what is between the braces; anything else is shown as it
/// is, so `a_b` and `<&>` are safe.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Text {
    /// What to say.
    pub(crate) content: String,
    /// The size of the letters, in page units.
    pub(crate) size: f64,
    /// The color.
    pub(crate) color: Color,
    /// What stands at the anchor point.
    pub(crate) anchor: Anchor,
    /// Whether a white border sets it off from lines it crosses.
    pub(crate) halo: bool,
}

impl Text {
    /// Text in ink, centered, without a halo.
    pub(crate) fn new(content: impl Into<String>, size: f64) -> Self {
        Self {
            content: content.into(),
            size,
            color: Color::INK,
            anchor: Anchor::Middle,
            halo: false,
        }
    }

    /// The same text in another color.
    pub(crate) fn colored(self, color: Color) -> Self {
        Self { color, ..self }
    }

    /// The same text held at another point.
    pub(crate) fn anchored(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    /// The same text with a white border.
    pub(crate) fn with_halo(self) -> Self {
        Self { halo: true, ..self }
    }

    /// Width and height on the page, from rounded-up letter widths: an upper estimate.
    pub(crate) fn page_size(&self) -> [f64; 2] {
        let width: f64 = runs(&self.content)
            .into_iter()
            .map(|(script, run)| {
                let size = if script == Script::Normal { 1.0 } else { SCRIPT_SIZE };
                run.chars().map(advance).sum::<f64>() * size
            })
            .sum();
        [width * self.size, 1.2 * self.size]
    }

    /// Writes the element for a text whose anchor point is here.
    pub(crate) fn write(&self, svg: &mut String, at: [f64; 2]) {
        let baseline = at[1] + CAP_HEIGHT / 2.0 * self.size;
        let (x, y, size) = (number(at[0]), number(baseline), number(self.size));
        let _ = write!(svg, "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\"");
        match self.anchor {
            Anchor::Start => {}
            Anchor::Middle => svg.push_str(" text-anchor=\"middle\""),
            Anchor::End => svg.push_str(" text-anchor=\"end\""),
        }
        self.color.write(svg, "fill");
        if self.halo {
            Color::WHITE.with_opacity(0.9).write(svg, "stroke");
            let width = number(0.28 * self.size);
            let _ = write!(
                svg,
                " stroke-width=\"{width}\" stroke-linejoin=\"round\" paint-order=\"stroke\""
            );
        }
        svg.push('>');
        self.write_runs(svg);
        svg.push_str("</text>\n");
    }

    fn write_runs(&self, svg: &mut String) {
        let mut shift = 0.0;
        for (script, run) in runs(&self.content) {
            let wanted = script.shift() * self.size;
            if script == Script::Normal && shift == 0.0 {
                escape(run, svg);
                continue;
            }
            let _ = write!(svg, "<tspan dy=\"{}\"", number(wanted - shift));
            if script != Script::Normal {
                let _ = write!(svg, " font-size=\"{}\"", number(SCRIPT_SIZE * self.size));
            }
            svg.push('>');
            escape(run, svg);
            svg.push_str("</tspan>");
            shift = wanted;
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Script {
    Normal,
    Sub,
    Super,
}

impl Script {
    fn shift(self) -> f64 {
        match self {
            Self::Normal => 0.0,
            Self::Sub => SUBSCRIPT_DROP,
            Self::Super => -SUPERSCRIPT_RISE,
        }
    }
}

/// The text cut at its scripts; an opening without a closing brace is plain text.
fn runs(content: &str) -> Vec<(Script, &str)> {
    let mut runs = Vec::new();
    let mut rest = content;
    while let Some((start, script)) = next_script(rest) {
        let Some(length) = rest[start + 2..].find('}') else {
            break;
        };
        let (inner, end) = (start + 2, start + 2 + length);
        if start > 0 {
            runs.push((Script::Normal, &rest[..start]));
        }
        runs.push((script, &rest[inner..end]));
        rest = &rest[end + 1..];
    }
    if !rest.is_empty() {
        runs.push((Script::Normal, rest));
    }
    runs
}

fn next_script(text: &str) -> Option<(usize, Script)> {
    let sub = text.find("_{").map(|start| (start, Script::Sub));
    let sup = text.find("^{").map(|start| (start, Script::Super));
    match (sub, sup) {
        (Some(sub), Some(sup)) => Some(if sub.0 < sup.0 { sub } else { sup }),
        (sub, sup) => sub.or(sup),
    }
}

/// An upper estimate of a letter's width in the bundled font, in parts of the text size.
fn advance(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' | 'I' | '\'' | '|' | ' ' | '.' | ',' | ':' | ';' | '·' => 0.34,
        'f' | 'r' | 't' | '(' | ')' | '[' | ']' | '!' | '/' | '-' | '"' => 0.42,
        'm' | 'w' | 'M' | 'W' | '%' | '@' | 'ω' => 0.98,
        'A'..='Z' => 0.79,
        '+' | '=' | '<' | '>' | '±' | '~' | '×' | '\u{2212}' | '≈' | '≤' | '≥' => 0.84,
        'a'..='z' | '0'..='9' | 'α'..='ψ' => 0.64,
        _ => 1.0,
    }
}

/// XML text: markup is escaped, and what XML forbids becomes the replacement character.
fn escape(text: &str, svg: &mut String) {
    for letter in text.chars() {
        match letter {
            '&' => svg.push_str("&amp;"),
            '<' => svg.push_str("&lt;"),
            '>' => svg.push_str("&gt;"),
            '\t' | '\n' | '\r' => svg.push(' '),
            '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => svg.push('\u{fffd}'),
            _ => svg.push(letter),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(text: &Text) -> String {
        let mut svg = String::new();
        text.write(&mut svg, [0.0, 0.0]);
        svg
    }

    #[test]
    fn markup_is_escaped_and_scripts_are_not_markup() {
        let text = Text::new("<a> & \"b\" \u{1} x_{<i>} y^{2} z_{open", 10.0);
        let svg = written(&text.with_halo());
        assert!(svg.contains("&lt;a&gt; &amp; \"b\" \u{fffd} x<tspan"));
        assert!(svg.contains(">&lt;i&gt;</tspan>"));
        assert!(svg.contains(" z_{open"));
    }

    #[test]
    fn a_script_moves_the_baseline_and_the_next_run_moves_it_back() {
        // Down by 0.24 of the size, from there up to 0.36 above, and back.
        let expected = "σ<tspan dy=\"2.4\" font-size=\"7.2\">min</tspan>\
                        <tspan dy=\"-6\" font-size=\"7.2\">2</tspan><tspan dy=\"3.6\"> = 1</tspan>";
        let svg = written(&Text::new("σ_{min}^{2} = 1", 10.0));
        assert!(svg.contains(expected), "{svg}");
    }

    #[cfg(feature = "png")]
    #[test]
    fn texts_are_no_wider_than_estimated() {
        use std::sync::Arc;

        use resvg::usvg::{Node, Options, Tree, fontdb};

        let mut fonts = fontdb::Database::new();
        fonts.load_font_data(include_bytes!("../fonts/DejaVuSans.ttf").to_vec());
        let options = Options { fontdb: Arc::new(fonts), ..Options::default() };
        let alphabet: String = ('!'..='~').filter(|letter| !"<>&".contains(*letter)).collect();
        for content in [
            "MMMMwwww",
            "0123456789",
            "ill-fitted jigs",
            "ω = −√(2/μ) = −0.152",
            "σ_{min} = 1.684",
            "frame at the center of compliance",
            alphabet.as_str(),
        ] {
            let text = Text::new(content, 20.0);
            let svg = format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\">\
                 <g font-family=\"DejaVu Sans\">{}</g></svg>",
                written(&text)
            );
            let tree = Tree::from_str(&svg, &options).expect("an SVG");
            let mut width = 0.0;
            let mut nodes: Vec<&Node> = tree.root().children().iter().collect();
            while let Some(node) = nodes.pop() {
                match node {
                    Node::Group(group) => nodes.extend(group.children()),
                    Node::Text(text) => width = f64::from(text.bounding_box().width()),
                    _ => {}
                }
            }
            let [estimate, _] = text.page_size();
            assert!(width > 0.7 * estimate && width <= estimate, "{content}: {width} {estimate}");
        }
    }
}
