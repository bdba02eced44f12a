//! The heading of a drawing, and the lines of text that go with it.

use crate::figure::Figure;
use crate::text::{Anchor, SMALL_SIZE, TITLE_SIZE, Text};

/// The width of what is drawn over its height from which the caption goes below.
const WIDE: f64 = 1.7;

/// Beside what is drawn, or below it where that is wide; so it never covers anything.
pub(crate) fn write(figure: &mut Figure, lines: &[String]) {
    let ink = figure.ink();
    let [width, height] = ink.size();
    let line = 1.55 * SMALL_SIZE;
    let block = line * lines.len().saturating_sub(1) as f64;
    let start = if width > WIDE * height {
        [ink.min[0], ink.max[1] + 1.8 * line]
    } else {
        [ink.max[0] + 2.0 * SMALL_SIZE, f64::midpoint(ink.min[1], ink.max[1]) - block / 2.0]
    };
    for (i, content) in lines.iter().enumerate() {
        let text = Text::new(content.as_str(), SMALL_SIZE).anchored(Anchor::Start);
        figure.caption([start[0], start[1] + line * i as f64], &text);
    }
}

/// The heading, if there is one, above all that is drawn.
pub(crate) fn heading(figure: &mut Figure, title: Option<&str>) {
    if let Some(title) = title {
        let ink = figure.ink();
        let text = Text::new(title, TITLE_SIZE).anchored(Anchor::Start);
        figure.caption([ink.min[0], ink.min[1] - 1.4 * TITLE_SIZE], &text);
    }
}
