//! The `clench` command: files in, reports and pictures out.

mod arguments;

mod analyze;
mod optimize;

mod held;
mod interrupt;
mod metrics;
mod response;
mod robustness;

mod answer;
mod color;
mod failure;

mod input;

mod picture;
mod report;

mod output;
mod progress;
mod view;
mod wording;

use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use miette::{GraphicalReportHandler, GraphicalTheme};

use crate::answer::Answer;
use crate::arguments::{Arguments, Command, OutputArguments};
use crate::failure::Failure;

/// Bad input; nothing was written.
const BAD_INPUT: u8 = 1;

/// A command line that does not go with the file; nothing was written. Clap uses it too.
const WRONG_USAGE: u8 = 2;

/// A sound question without an answer, or whose answer fails a check.
const NO_ANSWER: u8 = 3;

fn main() -> ExitCode {
    let arguments = Arguments::parse_checked();
    let answer = match &arguments.command {
        Command::Analyze(a) => finish(analyze::analyze(a), &[&a.grasp], &a.output),
        Command::Optimize(a) => finish(optimize::optimize(a), &a.files(), &a.output),
    };
    match answer {
        Ok(Answer { reason: Some(reason), .. }) => {
            complain(&format!("clench: no answer: {reason}\n"));
            ExitCode::from(NO_ANSWER)
        }
        Ok(Answer { failed_check: Some(reasons), .. }) => {
            complain(&format!("clench: the check failed: {reasons}\n"));
            ExitCode::from(NO_ANSWER)
        }
        Ok(_) => ExitCode::SUCCESS,
        Err(failure) => {
            complain(&shown(&failure));
            ExitCode::from(if failure.is_usage() { WRONG_USAGE } else { BAD_INPUT })
        }
    }
}

/// Draws the picture, writes the report, then the files: one that cannot be written must not cost
/// the answer.
fn finish(
    answer: Result<Answer, Failure>,
    inputs: &[&Path],
    output: &OutputArguments,
) -> Result<Answer, Failure> {
    let answer = answer?;
    let picture = match &output.svg {
        None => None,
        Some(path) => Some((path, answer.picture.figure()?.to_svg())),
    };
    let page = output.report.as_ref().zip(answer.page.clone());
    let files: Vec<_> = picture.into_iter().chain(page).collect();
    for (path, _) in &files {
        let meshes = answer.meshes.iter().map(PathBuf::as_path);
        inputs.iter().copied().chain(meshes).try_for_each(|i| output::check_apart(path, i))?;
    }
    output::write_report(&answer.report)?;
    files.iter().try_for_each(|(path, content)| output::write_file(path, content))?;
    Ok(answer)
}

/// The failure with the lines of the file that it is about.
fn shown(failure: &Failure) -> String {
    let plain = std::env::var_os("NO_COLOR").is_some() || !io::stderr().is_terminal();
    let theme = if plain { GraphicalTheme::unicode_nocolor() } else { GraphicalTheme::unicode() };
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
