//! The command line.

mod optimize;
mod part;
mod value;

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};

use crate::color::ColorArgument;
use crate::failure::Failure;
use crate::{WRONG_USAGE, complaint, output};

pub(crate) use optimize::{ObjectiveArgument, OptimizeArguments};
pub(crate) use value::FrameArgument;

const FILE: &str = r#"A part file, in TOML (or the same in JSON):

  units = { length = "mm", force = "N" }     # of all numbers; any names; L and F if left out

  [part.planar]
  outline = [[0, 0], [13, 0], [9, 8], [2, 6]] # corners, either way round
  stiffness = 1.0                            # of a contact on each edge; or a list, one per edge
  margin = 0.5                               # no finger nearer to a corner; 0 if left out
  forbidden = [2, { edge = 1, from = 0, to = 3 }] # edges, and stretches along them
  keep_out = [[[10, 9], [14, 9], [14, 12]]]  # polygons without fingers
  plate = { pitch = [5, 5], offset = [0, 0], travel = 2 } # centers of tips near its holes

Other parts, one shape each; `optimize` takes outlines, and solids with faces:

  [part.planar]                              # instead of an outline:
  drawing = "bracket.dxf"                    # DXF or SVG, beside this file; with, if needed,
  layers = ["OUTLINE", "BORES"]              # only these, and
  chord = 0.01                               # how far edges may be from its curves; or
  ellipse = [40, 25]                         # semi-axes; center = [x, y] if not the origin
  [part.spatial]
  vertices = [[0, 0, 0], ..]                 # with
  faces = [[0, 3, 2, 1], ..]                 # counter-clockwise seen from outside; or
  mesh = "bracket.stl"                       # STL or OBJ, beside this file; or
  ellipsoid = [30, 20, 15]
  margin = 2                                 # of solids with faces: no finger nearer to an edge
  plate = { pitch = [25, 25], travel = 5 }   # tips over its holes; boxes without fingers:
  keep_out = [{ from = [0, 0, 0], to = [9, 9, 9] }]

A grasp file has contacts besides; so have the files of --fix and --candidates, without a part:

  [[contacts]]
  point = [6, 0]                             # or the center of a round finger, without a preload
  preload = 9.81                             # 0 if left out; "balanced": follows from the rest
  edge = 0                                   # or face; needed where several meet; or
  # inward_normal = [0, 1]
  finger = { radius = 0.5 }                  # a pointed finger if left out; in space also
  # finger = { curvatures = [0.1, 0], direction = [1, 0, 0] }
  law = { kind = "linear", stiffness = 3.0 } # that of the part if left out; or
  # law = { kind = "power", coefficient = 3.0, exponent = 1.5 }
  # law = { kind = "hertz", finger = "steel", part = "aluminum 6061", relative_radius = 0.5 }
  # law = { kind = "line", thickness = 5, reference_depth = 4, finger = "steel", part = "ptfe" }

  tolerance = { placement = 0.2 }            # instead of that of all contacts

  [contact_tolerances]                       # how far contacts may be off; 0 what is left out
  placement = 0.1                            # along the boundary
  stiffness = 0.05                           # relative
  preload = 0.1                              # relative

  [[loads]]                                  # at rest, such as the weight
  point = [6, 4]
  force = [0, -9.81]

  [[points]]                                 # whose displacement is reported
  name = "bore"
  point = [6, 5]
  tolerance = 0.02                           # its largest displacement; none if left out
  direction = [0, 1]                         # only along this direction; any if left out

  [[load_cases]]                             # on top of that, such as the force of a tool
  name = "milling"
  force = [0.5, 0]
  point = [9, 8]                             # the origin if left out
  forces = [{ force = [0, -1], point = [2, 6] }] # more of them, each at its point
  torque = 2                                 # in space [x, y, z]
  tolerance = 0.05                           # largest displacement of any point of the part

docs/files.md has all fields. Corners, vertices, edges, faces and contacts count from 0; edge e
joins corner e to corner e + 1. A contact has to be on the boundary up to 1e-6 of the part's
radius. `-` reads standard input.

Fingers with a --finger-radius touch only where the disc, on a solid the ball, at their end has
room beside the part, and do not overlap each other; shanks and clamps behind them are not checked.

Exit codes: 0 an answer; 1 bad input, nothing written; 2 wrong usage; 3 no answer, or a check that
failed, with the reason."#;

const SHORT: &str = "More with --help.";

const ANALYZE: &str = "\
Examples of analyze:
  clench analyze grasp.toml                  # a report to read
  clench analyze grasp.toml --check          # exit code 3 unless all load cases pass
  clench analyze grasp.toml --format json    # all digits, for programs
  clench analyze grasp.toml --svg grasp.svg
  clench analyze grasp.json --frame 20,10,0.5
  clench analyze cube-grasp.toml --frame 50,50,50,0,0,0
  clench optimize bracket.toml --fingers 4 --format json | clench analyze -";

const OPTIMIZE: &str = "\
Examples of optimize:
  clench optimize bracket.dxf --fingers 4 --stiffness 5e4 --units mm
  clench optimize bracket.toml --fingers 4 --svg bracket.svg
  clench optimize bracket.toml --fingers 3 --preload 200 --format json > grasp.json
  clench optimize bracket.toml --fingers 6 --finger-radius 4 --margin 5 --forbid 2 --time 60
  clench optimize bracket.toml --fingers 4 --objective rotation --least-translation 3e4
  clench optimize block.toml --fix locators.toml --fingers 2 --least-share 0.02 --svg clamps.svg
  clench optimize block.toml --fix locators.toml --candidates places.toml --fingers 3";

const COMPLETIONS: &str = "\
Examples of completions:
  clench completions bash > ~/.local/share/bash-completion/completions/clench
  clench completions zsh > ~/.zfunc/_clench
  clench completions fish > ~/.config/fish/completions/clench.fish";

/// How well a compliant grasp or fixture holds a part, and where to put the fingers.
///
/// The quality Q is the least characteristic stiffness of the part on its fingers, force per
/// deflection: it does not depend on the frame (Lin, Burdick, Rimon: A Quality Measure for
/// Compliant Grasps).
#[derive(Debug, Parser)]
#[command(name = "clench", version, after_help = SHORT)]
#[command(after_long_help = format!("{FILE}\n\n{ANALYZE}\n{OPTIMIZE}\n{COMPLETIONS}"))]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Report stiffness, stability, quality and centers of a grasp, and whether load cases keep
    /// their tolerances.
    #[command(after_help = SHORT, after_long_help = format!("{FILE}\n\n{ANALYZE}"))]
    Analyze(AnalyzeArguments),
    /// Find the best placement of fingers, with a bound that no other placement surpasses.
    ///
    /// On an outline the placement has the greatest quality, and the search goes on until that is
    /// proved. On a solid it has the greatest worst-point stiffness, and the search ends when the
    /// bound is near enough, or after some time: see --objective, --gap and --time. The bound holds
    /// however the search ends.
    #[command(after_help = SHORT, after_long_help = format!("{FILE}\n\n{OPTIMIZE}"))]
    Optimize(Box<OptimizeArguments>),
    /// Write the script that makes a shell complete the options of clench.
    #[command(after_help = SHORT, after_long_help = COMPLETIONS)]
    Completions(CompletionsArguments),
}

/// Which shell to complete for.
#[derive(Debug, Args)]
pub(crate) struct CompletionsArguments {
    /// The shell.
    #[arg(value_enum)]
    shell: clap_complete::Shell,
}

/// What to analyze, and how.
#[derive(Debug, Args)]
pub(crate) struct AnalyzeArguments {
    /// The grasp file, or what `optimize --format json` wrote.
    pub(crate) grasp: PathBuf,
    /// Leave out (first) or take in (second) what preloads, curvatures and loads add to the
    /// stiffness; second if there are forces and they balance.
    #[arg(long, value_enum)]
    pub(crate) order: Option<OrderArgument>,
    /// The frame to write everything in: its origin, and its angle in radians, counter-clockwise;
    /// in space X,Y,Z,RX,RY,RZ with a rotation vector, axis times angle; the file's own if left
    /// out.
    #[arg(long, value_name = "X,Y,ANGLE", value_parser = value::frame, allow_hyphen_values = true)]
    pub(crate) frame: Option<FrameArgument>,
    /// End with the exit code 3 unless all load cases pass: no contact lifts off, and every
    /// tolerance is kept.
    #[arg(long)]
    pub(crate) check: bool,
    /// The part of its preload, from 0 to below 1, that each contact keeps at least under every
    /// load case with the preloads that the report says are needed.
    #[arg(long, value_name = "R", value_parser = value::reserve, default_value = "0")]
    #[arg(allow_hyphen_values = true)]
    pub(crate) reserve: f64,
    /// Report how the measures change with each contact's place, stiffness and preload, also if the
    /// file has no tolerances of contacts.
    #[arg(long)]
    pub(crate) robustness: bool,
    #[command(flatten)]
    pub(crate) output: OutputArguments,
}

/// Where the answer goes, and in which form.
#[derive(Debug, Args)]
pub(crate) struct OutputArguments {
    /// The form of the report.
    #[arg(long, value_enum, default_value = "text")]
    pub(crate) format: Format,
    /// Draw the grasp into this file, always in the frame of the input file. A search without an
    /// answer writes no file.
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// Write a page with pictures, tables and the inputs into this HTML file: it needs nothing
    /// besides, and opens offline. The pictures are in the frame of the input file.
    #[arg(long, value_name = "FILE")]
    pub(crate) report: Option<PathBuf>,
    /// Whether words that say good or bad have a color.
    #[arg(long, value_enum, value_name = "WHEN", default_value = "auto")]
    pub(crate) color: ColorArgument,
}

impl OutputArguments {
    /// The files to write.
    pub(crate) fn files(&self) -> impl Iterator<Item = &Path> {
        [&self.svg, &self.report].into_iter().flatten().map(PathBuf::as_path)
    }

    /// Checks that none of them is one of the `inputs`.
    pub(crate) fn check_apart<'a>(
        &self,
        inputs: impl IntoIterator<Item = &'a Path>,
    ) -> Result<(), Failure> {
        let mut inputs = inputs.into_iter();
        inputs.try_for_each(|input| {
            self.files().try_for_each(|path| output::check_apart(path, input))
        })
    }

    /// Checks that the files to write have names, and are not one.
    fn checked(&self) -> Result<(), (ErrorKind, String)> {
        for (option, path) in [("--svg", &self.svg), ("--report", &self.report)] {
            let Some(path) = path else { continue };
            if path.as_os_str() == "-" {
                let message = format!(
                    "{option}: found `-`, expected the name of a file: standard output has the \
                     report; a file of this name is `./-`"
                );
                return Err((ErrorKind::ValueValidation, message));
            }
        }
        if self.svg.is_some() && self.svg == self.report {
            let message = "--svg and --report have the same file, expected one each".to_owned();
            return Err((ErrorKind::ArgumentConflict, message));
        }
        Ok(())
    }
}

/// The terms of the stiffness.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum OrderArgument {
    First,
    Second,
}

/// The form of a report.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Format {
    Text,
    Json,
}

impl Arguments {
    /// The command line. If it is wrong, that is said, in JSON where the report would be; if it
    /// asks for help, that is written: the program then ends with this code.
    pub(crate) fn parsed() -> Result<Self, ExitCode> {
        let words: Vec<OsString> = env::args_os().collect();
        Self::try_parse_from(&words).and_then(Self::checked).map_err(|error| {
            if error.use_stderr() && asks_for_json(&words) {
                complaint::misused(&error.render().to_string(), WRONG_USAGE);
                return ExitCode::from(WRONG_USAGE);
            }
            error.exit()
        })
    }

    fn checked(self) -> Result<Self, clap::Error> {
        let checked = match &self.command {
            Command::Analyze(question) => question.output.checked(),
            Command::Optimize(question) => question.checked().and(question.output.checked()),
            Command::Completions(_) => Ok(()),
        };
        checked.map_err(|(kind, message)| Self::command().error(kind, message))?;
        Ok(self)
    }
}

impl CompletionsArguments {
    /// The script for the shell.
    pub(crate) fn script(&self) -> String {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut Arguments::command(), "clench", &mut script);
        String::from_utf8_lossy(&script).into_owned()
    }
}

/// Whether a command line that may be wrong has `--format json`.
fn asks_for_json(words: &[OsString]) -> bool {
    let pair = |pair: &[OsString]| pair[0] == "--format" && pair[1] == "json";
    words.windows(2).any(pair) || words.iter().any(|word| word == "--format=json")
}
