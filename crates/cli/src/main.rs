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
mod complaint;
mod failure;

mod input;

mod picture;
mod report;

mod output;
mod progress;
mod view;
mod wording;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use crate::answer::Answer;
use crate::arguments::{Arguments, Command, CompletionsArguments, Format, OutputArguments};
use crate::color::ColorArgument;
use crate::complaint::{Kind, Voice};
use crate::failure::Failure;
use crate::output::Draft;

/// Bad input; nothing was written.
const BAD_INPUT: u8 = 1;

/// A command line that does not go with the file; nothing was written. Clap uses it too.
pub(crate) const WRONG_USAGE: u8 = 2;

/// A sound question without an answer, or whose answer fails a check.
const NO_ANSWER: u8 = 3;

fn main() -> ExitCode {
    let arguments = match Arguments::parsed() {
        Ok(arguments) => arguments,
        Err(code) => return code,
    };
    let (answer, output) = match &arguments.command {
        Command::Analyze(a) => (run(|| analyze::analyze(a), &[&a.grasp], &a.output), &a.output),
        Command::Optimize(a) => (run(|| optimize::optimize(a), &a.files(), &a.output), &a.output),
        Command::Completions(a) => return completed(a),
    };
    let voice = Voice::of(output);
    match answer {
        Ok(Answer { reason: Some(reason), .. }) => {
            voice.unanswered(Kind::NoAnswer, &reason, NO_ANSWER);
            ExitCode::from(NO_ANSWER)
        }
        Ok(Answer { failed_check: Some(reasons), .. }) => {
            voice.unanswered(Kind::CheckFailed, &reasons, NO_ANSWER);
            ExitCode::from(NO_ANSWER)
        }
        Ok(_) => ExitCode::SUCCESS,
        Err(failure) => failed(voice, &failure),
    }
}

fn failed(voice: Voice, failure: &Failure) -> ExitCode {
    let code = if failure.is_usage() { WRONG_USAGE } else { BAD_INPUT };
    voice.failed(failure, code);
    ExitCode::from(code)
}

/// Writes what makes a shell complete the command line.
fn completed(arguments: &CompletionsArguments) -> ExitCode {
    match output::write_report(&arguments.script()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failed(Voice { format: Format::Text, color: ColorArgument::Auto }, &failure)
        }
    }
}

/// Finds the answer, if it can be written then: a search may take long.
fn run(
    answer: impl FnOnce() -> Result<Answer, Failure>,
    inputs: &[&Path],
    output: &OutputArguments,
) -> Result<Answer, Failure> {
    output.check_apart(inputs.iter().copied())?;
    output::check_writable(output.files())?;
    let answer = answer()?;
    output.check_apart(answer.besides.iter().map(PathBuf::as_path))?;
    finish(&answer, output)?;
    Ok(answer)
}

/// Writes the files but for their names, then the report: what has become unwritable must not cost
/// the answer. Files get their names when all else is written.
fn finish(answer: &Answer, output: &OutputArguments) -> Result<(), Failure> {
    let picture = answer.picture.as_ref().zip(output.svg.as_ref());
    let picture = picture.map(|(picture, path)| Ok((path, picture.figure()?.to_svg())));
    let page = output.report.as_ref().zip(answer.page.clone());
    let files = picture.into_iter().chain(page.map(Ok)).collect::<Result<Vec<_>, Failure>>()?;
    let drafts = files.iter().map(|(path, content)| Draft::new(path, content));
    let drafts = drafts.collect::<Result<Vec<_>, Failure>>();
    output::write_report(&answer.report)?;
    drafts?.into_iter().try_for_each(Draft::publish)
}
