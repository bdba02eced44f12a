//! Texts of a file and numbers, as messages show them.

use std::fmt;

/// More characters of a text than this are not shown.
const LONGEST: usize = 40;

/// As much of a text of a file as a message shows, on one line.
pub(crate) struct Quoted<'a>(pub(crate) &'a str);

/// A layer by its name, if it has one.
pub(crate) struct Layer<'a>(pub(crate) &'a str);

impl fmt::Display for Quoted<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let end = self.0.char_indices().nth(LONGEST).map(|(end, _)| end);
        let start = &self.0[..end.unwrap_or(self.0.len())];
        write!(out, "`{}{}`", start.escape_debug(), if end.is_some() { "…" } else { "" })
    }
}

impl fmt::Display for Layer<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() {
            return out.write_str("no layer");
        }
        write!(out, "layer {}", Quoted(self.0))
    }
}

/// `value` to six significant digits, as short as it gets.
pub(crate) fn digits(value: f64) -> String {
    let rounded = format!("{value:.5e}").parse().unwrap_or(value);
    // With a power of ten where that is shorter.
    let text = format!("{rounded:?}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}
