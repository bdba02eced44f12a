//! What goes to standard error at the end: for people, or as one JSON object.

use std::io::{self, Write};

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};
use serde::Serialize;

use crate::arguments::{Format, OutputArguments};
use crate::color::{ColorArgument, Paint};
use crate::failure::Failure;

/// What was wrong, at the end of a program whose exit code is not 0.
#[derive(Debug, Serialize)]
struct Complaint<'a> {
    error: Content<'a>,
}

#[derive(Debug, Serialize)]
struct Content<'a> {
    kind: Kind,
    message: String,
    /// The file that it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<&'a str>,
    /// Where in the file, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
    /// In characters, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    column: Option<usize>,
    /// The path of the value in the file.
    #[serde(skip_serializing_if = "Option::is_none")]
    field: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<String>,
    exit_code: u8,
}

/// What kind of thing was wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Kind {
    /// What a file says.
    Input,
    /// A file that cannot be read or written.
    File,
    /// The command line.
    Usage,
    /// A sound question that has no answer.
    NoAnswer,
    /// Load cases that had to pass.
    CheckFailed,
}

/// How to complain.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Voice {
    pub(crate) format: Format,
    pub(crate) color: ColorArgument,
}

impl Voice {
    /// As a command writes its report.
    pub(crate) const fn of(output: &OutputArguments) -> Self {
        Self { format: output.format, color: output.color }
    }

    /// Says why there is no answer, or that a check failed.
    pub(crate) fn unanswered(self, kind: Kind, message: &str, exit_code: u8) {
        let what = if kind == Kind::CheckFailed { "the check failed" } else { "no answer" };
        match self.format {
            Format::Text => complain(&format!("clench: {what}: {message}\n")),
            Format::Json => {
                json(Content { message: message.to_owned(), exit_code, ..Content::new(kind) });
            }
        }
    }

    /// Says why a command failed.
    pub(crate) fn failed(self, failure: &Failure, exit_code: u8) {
        if let Format::Text = self.format {
            return complain(&shown(failure, self.color.paint(&io::stderr())));
        }
        let at = failure.place();
        json(Content {
            message: failure.to_string(),
            file: failure.file(),
            line: at.as_ref().and_then(|at| at.line),
            column: at.as_ref().and_then(|at| at.column),
            field: at.and_then(|at| at.field),
            help: failure.help().map(|help| help.to_string()),
            exit_code,
            ..Content::new(failure.kind())
        });
    }
}

/// Says that the command line is wrong, in the words of clap, which has no form of its own for
/// programs.
pub(crate) fn misused(message: &str, exit_code: u8) {
    let message = message.trim().trim_start_matches("error: ").to_owned();
    json(Content { message, exit_code, ..Content::new(Kind::Usage) });
}

impl Content<'_> {
    const fn new(kind: Kind) -> Self {
        Self {
            kind,
            message: String::new(),
            file: None,
            line: None,
            column: None,
            field: None,
            help: None,
            exit_code: 0,
        }
    }
}

fn json(error: Content<'_>) {
    // Text and numbers are always JSON.
    if let Ok(mut text) = serde_json::to_string(&Complaint { error }) {
        text.push('\n');
        complain(&text);
    }
}

/// The failure with the lines of the file that it is about.
fn shown(failure: &Failure, paint: Paint) -> String {
    let theme = match paint {
        Paint::Plain => GraphicalTheme::unicode_nocolor(),
        Paint::Colored => GraphicalTheme::unicode(),
    };
    let mut text = String::new();
    // Long messages stay on one line, so that they can be searched for; causes are in them.
    let handler =
        GraphicalReportHandler::new_themed(theme).with_wrap_lines(false).without_cause_chain();
    match handler.render_report(&mut text, failure) {
        Ok(()) => text,
        Err(_) => format!("clench: {failure}\n"),
    }
}

/// Whether anybody reads standard error does not change the exit code.
fn complain(message: &str) {
    let _ = io::stderr().write_all(message.as_bytes());
}
