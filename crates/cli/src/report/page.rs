//! Lines of text in columns.

use std::fmt::{self, Display};

/// The width of the label of a head.
const HEAD: usize = 10;

/// The width of the first column: the words of a row.
const LABEL: usize = 22;

/// The least width of the second column: a number with its unit.
const VALUE: usize = 24;

/// The space between the columns of a table.
const GAP: &str = "  ";

/// A text that grows downwards.
#[derive(Debug, Default)]
pub(crate) struct Page(Vec<Line>);

/// A part of a page, as a text or a page in a browser shows it.
#[derive(Debug)]
pub(super) enum Line {
    Text(String),
    /// A label and what it stands for.
    Head {
        label: String,
        text: String,
    },
    /// A number with its name, and what it means.
    Row {
        label: String,
        value: String,
        meaning: String,
    },
    /// Rows of cells; the first is the heading.
    Table(Vec<Vec<String>>),
}

impl Page {
    /// A line as it is.
    pub(crate) fn line(&mut self, line: impl Display) {
        self.0.push(Line::Text(line.to_string()));
    }

    /// A label and what it stands for.
    pub(crate) fn head(&mut self, label: &str, text: impl Display) {
        self.0.push(Line::Head { label: label.to_owned(), text: text.to_string() });
    }

    /// A number with its name, and what it means.
    pub(crate) fn row(&mut self, label: &str, value: impl Display, meaning: impl Display) {
        let [label, value, meaning] =
            [&label as &dyn Display, &value, &meaning].map(ToString::to_string);
        self.0.push(Line::Row { label, value, meaning });
    }

    /// Rows of cells; the first is the heading.
    pub(crate) fn table(&mut self, rows: &[Vec<String>]) {
        self.0.push(Line::Table(rows.to_vec()));
    }

    /// What is on the page, downwards.
    pub(super) fn lines(&self) -> &[Line] {
        &self.0
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

    /// Writes the line, or the lines of a table; the value of a row is so wide.
    fn write(&self, width: usize, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = match self {
            Self::Text(text) => text.clone(),
            Self::Head { label, text } => format!("{label:<HEAD$}{text}"),
            Self::Row { label, value, meaning } => {
                format!("{label:<LABEL$}{value:<width$}{meaning}")
            }
            Self::Table(rows) => return write_table(rows, out),
        };
        writeln!(out, "{}", text.trim_end())
    }
}

impl Display for Page {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        // The meanings of rows that follow each other stand in one column.
        for block in self.0.chunk_by(|one, next| one.is_row() && next.is_row()) {
            let width = block.iter().map(Line::value_width).fold(VALUE, usize::max);
            for line in block {
                line.write(width, out)?;
            }
        }
        Ok(())
    }
}

fn write_table(rows: &[Vec<String>], out: &mut fmt::Formatter<'_>) -> fmt::Result {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    for row in rows {
        let cells = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}"));
        writeln!(out, "{}", cells.collect::<Vec<_>>().join(GAP).trim_end())?;
    }
    Ok(())
}
