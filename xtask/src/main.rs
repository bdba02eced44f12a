//! The chores of the repository: `cargo xtask TASK`, one module per task.
#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a chore talks to the person at the terminal"
)]

mod browser;
mod ci;
mod failure;
mod guide;
mod made;
mod paper;
mod peers;
mod tidy;
mod workspace;

use std::process::ExitCode;

use made::Mode;

const USAGE: &str = "\
usage: cargo xtask TASK

  ci      everything a change must pass, in the order of the printed steps
  tidy    the rules of the repository that no compiler checks
  paper   the paper's numbers and figures, into docs/paper; --check writes nothing
  guide   the pictures of the guide, into docs/guide; --check writes nothing
  browser the pages of --report in a browser without a screen; needs Chromium and its driver
  peers   the library beside SCIP and NumPy, on standard output; needs Python 3; not part of ci
";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let done = match words.as_slice() {
        ["ci"] => ci::run(),
        ["tidy"] => tidy::run(),
        ["paper"] => paper::run(Mode::Write),
        ["paper", "--check"] => paper::run(Mode::Check),
        ["guide"] => guide::run(Mode::Write),
        ["guide", "--check"] => guide::run(Mode::Check),
        ["browser"] => browser::run(),
        ["peers"] => peers::run(),
        _ => {
            eprint!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("xtask: {failure}");
            ExitCode::FAILURE
        }
    }
}
