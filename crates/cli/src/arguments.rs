//! The command line.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::error::ErrorKind;
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};

const FILE: &str = r#"A part file, in TOML (or the same in JSON):

  units = { length = "mm", force = "N" }     # of all numbers; any names; L and F if left out

  [part.planar]
  outline = [[0, 0], [13, 0], [9, 8], [2, 6]] # corners, either way round
  stiffness = 1.0                            # of a contact on each edge; or a list, one per edge

`analyze` knows more parts, one shape each:

  [part.planar]                              # instead of an outline:
  ellipse = [40, 25]                         # semi-axes; center = [x, y] if not the origin
  [part.spatial]
  vertices = [[0, 0, 0], ..]                 # with
  faces = [[0, 3, 2, 1], ..]                 # counter-clockwise seen from outside; or
  mesh = "bracket.stl"                       # STL or OBJ, beside this file; or
  ellipsoid = [30, 20, 15]

A grasp file has contacts besides:

  [[contacts]]
  point = [6, 0]                             # or the center of a round finger, without a preload
  preload = 9.81                             # 0 if left out
  edge = 0                                   # or face; needed where several meet; or
  # inward_normal = [0, 1]
  finger = { radius = 0.5 }                  # a pointed finger if left out; in space also
  # finger = { curvatures = [0.1, 0], direction = [1, 0, 0] }
  law = { kind = "linear", stiffness = 3.0 } # that of the part if left out; or
  # law = { kind = "power", coefficient = 3.0, exponent = 1.5 }
  # law = { kind = "hertz", finger = "steel", part = "aluminum 6061", relative_radius = 0.5 }
  # law = { kind = "line", thickness = 5, reference_depth = 4, finger = "steel", part = "ptfe" }

  [[loads]]                                  # at rest, such as the weight
  point = [6, 4]
  force = [0, -9.81]

  [[points]]                                 # whose displacement is reported
  name = "bore"
  point = [6, 5]

  [[load_cases]]                             # on top of that, such as the force of a tool
  name = "milling"
  force = [0.5, 0]
  point = [9, 8]                             # the origin if left out
  torque = 2                                 # in space [x, y, z]
  tolerance = 0.05                           # largest displacement of any point of the part

docs/files.md has all fields. Corners, vertices, edges, faces and contacts count from 0; edge e
joins corner e to corner e + 1. A contact has to be on the boundary up to 1e-6 of the part's
radius. `-` reads standard input.

Not checked: fingers may overlap each other or the part away from their contacts, and nothing says
whether there is room for them. With four fingers the radius does not enter the optimum.

Exit codes: 0 an answer; 1 bad input, nothing written; 2 wrong usage; 3 no answer, with the reason.

Examples:
  clench optimize bracket.toml --fingers 4 --svg bracket.svg
  clench optimize bracket.toml --fingers 3 --preload 200 --format json > grasp.json
  clench analyze grasp.json --frame 20,10,0.5
  clench analyze cube-grasp.toml --frame 50,50,50,0,0,0"#;

/// How well a compliant grasp or fixture holds a part, and where to put the fingers.
///
/// The quality Q is the least characteristic stiffness of the part on its fingers, force per
/// deflection: it does not depend on the frame (Lin, Burdick, Rimon: A Quality Measure for
/// Compliant Grasps).
#[derive(Debug, Parser)]
#[command(name = "clench", version, after_long_help = FILE, after_help = "More with --help.")]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Report stiffness, stability, quality and centers of a grasp, and what load cases do to it.
    #[command(after_long_help = FILE)]
    Analyze(AnalyzeArguments),
    /// Find the placement of fingers with the greatest quality, and prove that it is.
    #[command(after_long_help = FILE)]
    Optimize(OptimizeArguments),
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
    #[arg(long, value_name = "X,Y,ANGLE", value_parser = frame, allow_hyphen_values = true)]
    pub(crate) frame: Option<FrameArgument>,
    #[command(flatten)]
    pub(crate) output: OutputArguments,
}

/// What to optimize, and how.
#[derive(Debug, Args)]
pub(crate) struct OptimizeArguments {
    /// The part file.
    pub(crate) part: PathBuf,
    /// The number of frictionless fingers.
    #[arg(long, value_enum)]
    pub(crate) fingers: Fingers,
    /// The sum of all contact forces. Three fingers need it: they resist rotation by it alone.
    /// With four, the report adds the quality to second order.
    #[arg(long, value_name = "F", value_parser = positive)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) preload: Option<f64>,
    /// The radius of the fingers' tips. With four it does not change the optimum, only the quality
    /// to second order.
    #[arg(long, value_name = "R", value_parser = not_negative, default_value = "0")]
    #[arg(allow_hyphen_values = true)]
    pub(crate) finger_radius: f64,
    /// Report the best placements on this many combinations of edges: 1 or more.
    #[arg(long, value_name = "T", value_parser = one_or_more, default_value = "1")]
    pub(crate) top: NonZeroUsize,
    #[command(flatten)]
    pub(crate) output: OutputArguments,
}

/// Where the answer goes, and in which form.
#[derive(Debug, Args)]
pub(crate) struct OutputArguments {
    /// The form of the report.
    #[arg(long, value_enum, default_value = "text")]
    pub(crate) format: Format,
    /// Draw the grasp into this file, always in the frame of the input file; planar parts only.
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
}

/// The terms of the stiffness.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum OrderArgument {
    First,
    Second,
}

/// How many fingers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Fingers {
    #[value(name = "3")]
    Three,
    #[value(name = "4")]
    Four,
}

/// The form of a report.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Format {
    Text,
    Json,
}

/// A frame as it is written on the command line: of the plane by three numbers, of space by six.
#[derive(Clone, Debug)]
pub(crate) struct FrameArgument(pub(crate) Vec<f64>);

impl Arguments {
    /// The command line; wrong usage ends the program, with code 2.
    pub(crate) fn parse_checked() -> Self {
        let arguments = Self::parse();
        if let Command::Optimize(OptimizeArguments {
            fingers: Fingers::Three, preload: None, ..
        }) = &arguments.command
        {
            let message = "--fingers 3 needs --preload <F>, the sum of all contact forces: three \
                           frictionless fingers resist rotation by their preload alone";
            Self::command().error(ErrorKind::MissingRequiredArgument, message).exit();
        }
        arguments
    }
}

/// Coordinates of a frame up to here leave products of three of them in the range of numbers.
const LARGEST_FRAME: f64 = 1e90;

fn frame(text: &str) -> Result<FrameArgument, String> {
    let numbers: Vec<f64> = text.split(',').map(finite).collect::<Result<_, _>>()?;
    if let Some(number) = numbers.iter().find(|number| number.abs() > LARGEST_FRAME) {
        return Err(format!("found {number:e}, expected numbers up to {LARGEST_FRAME:e}"));
    }
    match numbers.len() {
        3 | 6 => Ok(FrameArgument(numbers)),
        count => Err(format!(
            "found {count} numbers, expected three in the plane: x,y,angle; \
             or six in space: x,y,z,rx,ry,rz"
        )),
    }
}

fn positive(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    if value > 0.0 { Ok(value) } else { Err(format!("found {value}, expected more than 0")) }
}

fn not_negative(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    if value >= 0.0 { Ok(value) } else { Err(format!("found {value}, expected 0 or more")) }
}

fn one_or_more(text: &str) -> Result<NonZeroUsize, String> {
    let count: Option<usize> = text.trim().parse().ok();
    count.and_then(NonZeroUsize::new).ok_or_else(|| format!("found {text}, expected 1 or more"))
}

fn finite(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("found `{text}`, expected a finite number"))
}
