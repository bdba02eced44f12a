//! The piece of a file that a message shows: a window of one line, however long the line is.

use std::ops::Range;

use miette::{MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};

/// Characters that are shown on either side of the fault, and of the fault itself at most.
const WINDOW: usize = 60;

/// What stands for the rest of a line.
const ELLIPSIS: char = '…';

/// A window of the line that a fault is on, which knows its place in the file.
#[derive(Clone, Debug)]
pub(super) struct Excerpt {
    name: String,
    window: String,
    /// The bytes of the fault in the window.
    fault: SourceSpan,
    /// Lines of the file before this one.
    line: usize,
    /// Characters of the line before the fault.
    column: usize,
}

impl Excerpt {
    /// What to show of `text` for a fault at the bytes `span`, by its first line.
    pub(super) fn new(name: &str, text: &str, span: &Range<usize>) -> Self {
        let start = text.floor_char_boundary(span.start);
        let (before, rest) = text.split_at(start);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let before_fault = &before[line_start..];
        let rest = rest.lines().next().unwrap_or("");
        let fault = rest.get(..span.end - span.start.min(span.end)).unwrap_or(rest);
        let fault = first(fault, WINDOW);
        let lead = last(before_fault, WINDOW);
        let tail = first(&rest[fault.len()..], WINDOW);
        let mut window = String::new();
        if lead.len() < before_fault.len() {
            window.push(ELLIPSIS);
        }
        window.push_str(lead);
        let fault_span = (window.len(), fault.len()).into();
        window.push_str(fault);
        window.push_str(tail);
        if fault.len() + tail.len() < rest.len() {
            window.push(ELLIPSIS);
        }
        Self {
            name: name.to_owned(),
            window,
            fault: fault_span,
            line: before.matches('\n').count(),
            column: before_fault.chars().count(),
        }
    }

    /// The bytes of the fault in the window.
    pub(super) const fn fault(&self) -> SourceSpan {
        self.fault
    }

    /// Where the fault begins in the file, as people count: from 1.
    pub(super) const fn line_and_column(&self) -> (usize, usize) {
        (self.line + 1, self.column + 1)
    }
}

impl SourceCode for Excerpt {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        lines_before: usize,
        lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let inside = self.window.read_span(span, lines_before, lines_after)?;
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            inside.data(),
            *inside.span(),
            self.line,
            self.column,
            inside.line_count(),
        )))
    }
}

/// The first `count` characters.
fn first(text: &str, count: usize) -> &str {
    text.char_indices().nth(count).map_or(text, |(end, _)| &text[..end])
}

/// The last `count` characters.
fn last(text: &str, count: usize) -> &str {
    let start = text.char_indices().rev().nth(count.saturating_sub(1));
    start.map_or(text, |(start, _)| &text[start..])
}
