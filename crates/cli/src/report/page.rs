//! Lines of text in columns.

use std::fmt::{self, Display};

/// The width of the first column: the words of a row.
const LABEL: usize = 22;

/// The width of the second column: a number with its unit.
const VALUE: usize = 24;

/// The space between the columns of a table.
const GAP: &str = "  ";

/// A text that grows downwards.
#[derive(Debug, Default)]
pub(crate) struct Page(String);

impl Page {
    /// A line as it is.
    pub(crate) fn line(&mut self, line: impl Display) {
        self.0.push_str(line.to_string().trim_end());
        self.0.push('\n');
    }

    /// A label and what it stands for.
    pub(crate) fn head(&mut self, label: &str, text: impl Display) {
        self.line(format_args!("{label:<10}{text}"));
    }

    /// A number with its name, and what it means.
    pub(crate) fn row(&mut self, label: &str, value: impl Display, meaning: impl Display) {
        let mut value = value.to_string();
        if value.chars().count() >= VALUE {
            value.push_str(GAP);
        }
        self.line(format_args!("{label:<LABEL$}{value:<VALUE$}{meaning}"));
    }

    /// Rows of cells; the first is the heading.
    pub(crate) fn table(&mut self, rows: &[Vec<String>]) {
        let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
        let width = |column: usize| {
            let cells = rows.iter().filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..columns).map(width).collect();
        for row in rows {
            let cells = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}"));
            self.line(cells.collect::<Vec<_>>().join(GAP));
        }
    }
}

impl Display for Page {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}
