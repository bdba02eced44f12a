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
        Command::Analyze(a) => (finish(analyze::analyze(a), &[&a.grasp], &a.output), &a.output),
        Command::Optimize(a) => (finish(optimize::optimize(a), &a.files(), &a.output), &a.output),
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
