//! Lines of a text report as lists, tables and paragraphs.

use maud::{Markup, Render, html};

use super::typeset::typeset;
use crate::report::page::{Line, Page};

/// What `write` writes, set.
pub(super) fn written(write: impl FnOnce(&mut Page)) -> Markup {
    let mut page = Page::default();
    write(&mut page);
    html!((page))
}

impl Render for Page {
    fn render(&self) -> Markup {
        let blocks =
            self.lines().chunk_by(|one, next| kind(one) == kind(next) && kind(one).joins());
        html!(@for block in blocks { (rendered(block)) })
    }
}

/// What a line becomes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Text,
    Head,
    Row,
    Table,
}

impl Kind {
    /// Whether lines of this kind that follow each other are one thing.
    const fn joins(self) -> bool {
        matches!(self, Self::Head | Self::Row)
    }
}

const fn kind(line: &Line) -> Kind {
    match line {
        Line::Text(_) => Kind::Text,
        Line::Head { .. } => Kind::Head,
        Line::Row { .. } => Kind::Row,
        Line::Table(_) => Kind::Table,
    }
}

/// Lines of one kind.
fn rendered(block: &[Line]) -> Markup {
    match block {
        [Line::Text(text)] if text.is_empty() => html!(),
        [Line::Text(text)] => html!(p { (typeset(text)) }),
        [Line::Table(rows)] => table(rows),
        [Line::Head { .. }, ..] => html!(dl { @for line in block { (head(line)) } }),
        _ => html!(div.wide { table.rows { tbody { @for line in block { (row(line)) } } } }),
    }
}

fn head(line: &Line) -> Markup {
    let Line::Head { label, text } = line else { return html!() };
    html!(dt { (label) } dd { (typeset(text)) })
}

fn row(line: &Line) -> Markup {
    let Line::Row { label, value, meaning } = line else { return html!() };
    html! {
        tr {
            th scope="row" { (typeset(label)) }
            td { (typeset(value)) }
            td { (typeset(meaning)) }
        }
    }
}

/// Rows of cells with a heading; columns of numbers are set to the right.
pub(super) fn table(rows: &[Vec<String>]) -> Markup {
    let Some((heading, body)) = rows.split_first() else { return html!() };
    let columns = heading.len();
    let numeric: Vec<bool> = (0..columns).map(|column| is_numeric(body, column)).collect();
    let right = |column: usize| numeric.get(column).filter(|numeric| **numeric).map(|_| "n");
    html! {
        div.wide {
            table {
                thead {
                    tr {
                        @for (i, cell) in heading.iter().enumerate() {
                            th scope="col" class=[right(i)] { (typeset(cell)) }
                        }
                    }
                }
                tbody {
                    @for row in body {
                        tr {
                            @for (i, cell) in row.iter().enumerate() {
                                td class=[right(i)] { (typeset(cell)) }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn is_numeric(body: &[Vec<String>], column: usize) -> bool {
    let cells = body.iter().filter_map(|row| row.get(column));
    // Of a finger that is off, or of what does not exist, there is no number.
    let mut cells =
        cells.filter(|cell| !["", "-", "off", "none"].contains(&cell.as_str())).peekable();
    cells.peek().is_some() && cells.all(|cell| cell.parse::<f64>().is_ok())
}
