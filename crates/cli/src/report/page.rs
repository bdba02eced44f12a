//! Lines of text in columns.

use std::fmt::{self, Display};

/// The width of the first column: the words of a row.
const LABEL: usize = 22;

/// The least width of the second column: a number with its unit.
const VALUE: usize = 24;

/// The space between the columns of a table.
const GAP: &str = "  ";

/// A text that grows downwards.
#[derive(Debug, Default)]
pub(crate) struct Page(Vec<Line>);

#[derive(Debug)]
enum Line {
    Text(String),
    /// A number with its name, and what it means.
    Row {
        label: String,
        value: String,
        meaning: String,
    },
}

impl Page {
    /// A line as it is.
    pub(crate) fn line(&mut self, line: impl Display) {
        self.0.push(Line::Text(line.to_string()));
    }

    /// A label and what it stands for.
    pub(crate) fn head(&mut self, label: &str, text: impl Display) {
        self.line(format_args!("{label:<10}{text}"));
    }

    /// A number with its name, and what it means.
    pub(crate) fn row(&mut self, label: &str, value: impl Display, meaning: impl Display) {
        let [label, value, meaning] =
            [&label as &dyn Display, &value, &meaning].map(ToString::to_string);
        self.0.push(Line::Row { label, value, meaning });
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

impl Line {
    /// The room that the value of a row needs before its meaning.
    fn value_width(&self) -> usize {
        match self {
            Self::Row { value, meaning, .. } if !meaning.is_empty() => {
                value.chars().count() + GAP.len()
            }
            _ => 0,
        }
    }

    const fn is_row(&self) -> bool {
        matches!(self, Self::Row { .. })
    }
}

impl Display for Page {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        // The meanings of rows that follow each other stand in one column.
        for block in self.0.chunk_by(|one, next| one.is_row() && next.is_row()) {
            let width = block.iter().map(Line::value_width).fold(VALUE, usize::max);
            for line in block {
                let text = match line {
                    Line::Text(text) => text.clone(),
                    Line::Row { label, value, meaning } => {
                        format!("{label:<LABEL$}{value:<width$}{meaning}")
                    }
                };
                writeln!(out, "{}", text.trim_end())?;
            }
        }
        Ok(())
    }
}
