//! Why a command failed: what was given is bad, or a file cannot be read or written.

use std::io;

use clench::optimize::OptimizeError;
use clench::stiffness::GraspError;
use clench_draw::DrawError;
use miette::Diagnostic;

use crate::complaint::Kind;
use crate::input::{InputError, Position};
use crate::optimize::OutOfRange;
use crate::wording::quoted;

/// The end of a command that wrote nothing.
#[derive(Debug, thiserror::Error, Diagnostic)]
pub(crate) enum Failure {
    /// The text or the numbers of a file.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Input(Box<InputError>),
    /// A file that cannot be read.
    #[error("{name}: cannot be read: {source}; expected a TOML or JSON file")]
    Unreadable { name: String, source: io::Error },
    /// A file that is no text.
    #[error("{name}: byte {offset} is not UTF-8; expected a TOML or JSON file in UTF-8")]
    NotText { name: String, offset: usize },
    /// A file without an end, or nearly so.
    #[error("{name}: has more than {most} bytes, the size of the largest file that is read")]
    TooLarge { name: String, most: u64 },
    /// A picture that would overwrite the input.
    #[error("{name}: is the input file; expected another name for what is written")]
    SameFile { name: String },
    /// A file to write in a folder that is not there.
    #[error("{name}: cannot be written: there is no folder {folder}")]
    NoFolder { name: String, folder: String },
    /// A picture that cannot be written; what was there before still is.
    #[error("{name}: cannot be written: {source}")]
    Unwritable { name: String, source: io::Error },
    /// Standard output that cannot be written.
    #[error("the report cannot be written to standard output: {0}")]
    Output(io::Error),
    /// Options that do not go with the part.
    #[error("{message}")]
    Usage { message: String },
    /// A drawing without a part file, and no option in its place.
    #[error(
        "a drawing in place of a part file needs --stiffness <K>, that of a contact (force / \
         length)"
    )]
    NoStiffness,
    /// Stiffnesses that contradict each other.
    #[error(
        "--stiffness: found several, expected one number, or LAYER=K once for each layer of a \
         drawing"
    )]
    StiffnessTwice,
    /// Two stiffnesses for one layer.
    #[error(
        "--stiffness: found one for layer {} and one for layer {}, expected one: they are the same \
         layer, whose case does not count",
        quoted(&.layers[0]), quoted(&.layers[1])
    )]
    LayerTwice { layers: [String; 2] },
    /// An option that says what the part file has to say.
    #[error(
        "{option} goes with a drawing or a mesh in place of a part file, expected the same in the \
         part file"
    )]
    AloneOption { option: &'static str },
    /// An option about drawings where there is none.
    #[error("{option} goes with a drawing only")]
    DrawingOption { option: &'static str },
    /// The frame of the command line has another dimension than the part.
    #[error("--frame has {found} numbers, expected three for a planar part: x,y,angle")]
    PlanarFrame { found: usize },
    /// The frame of the command line has another dimension than the part.
    #[error("--frame has {found} numbers, expected six for a spatial part: x,y,z,rx,ry,rz")]
    SpatialFrame { found: usize },
    /// A check of load cases that do not exist.
    #[error("--check: {name} has no load cases, expected at least one [[load_cases]]")]
    NothingToCheck { name: String },
    /// A grasp that no page can show.
    #[error("the picture cannot be drawn: {0}")]
    Picture(#[from] DrawError),
    /// A report that is no JSON.
    #[error("the report cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// A number of the command line that does not go with the file, or is out of range.
    #[error("{option}: {source}")]
    Option { option: String, source: Box<OptimizeError> },
    /// Numbers that the search cannot work with.
    #[error("{name}: {source}")]
    Search { name: String, source: Box<OptimizeError> },
    /// A question about the preloads that was not decided.
    #[error("{name}: {source}")]
    Preloads { name: String, source: GraspError },
    /// A result out of the range of the numbers.
    #[error("{name}: {source}{}", nearer_to_1(.source))]
    Range { name: String, source: Box<OutOfRange> },
}

impl Failure {
    /// Whether the command line is wrong rather than the file: together they make no sense.
    pub(crate) const fn is_usage(&self) -> bool {
        matches!(
            self,
            Self::Usage { .. }
                | Self::NoStiffness
                | Self::StiffnessTwice
                | Self::LayerTwice { .. }
                | Self::AloneOption { .. }
                | Self::DrawingOption { .. }
                | Self::PlanarFrame { .. }
                | Self::SpatialFrame { .. }
                | Self::NothingToCheck { .. }
                | Self::Option { .. }
        )
    }
}

impl Failure {
    /// What kind of thing is wrong.
    pub(crate) const fn kind(&self) -> Kind {
        match self {
            _ if self.is_usage() => Kind::Usage,
            Self::Unreadable { .. }
            | Self::NotText { .. }
            | Self::TooLarge { .. }
            | Self::SameFile { .. }
            | Self::NoFolder { .. }
            | Self::Unwritable { .. }
            | Self::Output(_) => Kind::File,
            _ => Kind::Input,
        }
    }

    /// The file that it is about.
    pub(crate) fn file(&self) -> Option<&str> {
        match self {
            Self::Input(error) => Some(error.file()),
            Self::Unreadable { name, .. }
            | Self::NotText { name, .. }
            | Self::TooLarge { name, .. }
            | Self::SameFile { name }
            | Self::NoFolder { name, .. }
            | Self::Unwritable { name, .. }
            | Self::NothingToCheck { name }
            | Self::Search { name, .. }
            | Self::Preloads { name, .. }
            | Self::Range { name, .. } => Some(name),
            _ => None,
        }
    }

    /// Where in the file.
    pub(crate) fn place(&self) -> Option<Position> {
        match self {
            Self::Input(error) => Some(error.position()),
            _ => None,
        }
    }
}

impl From<InputError> for Failure {
    fn from(error: InputError) -> Self {
        Self::Input(Box::new(error))
    }
}

/// What to do, where the `source` does not say it.
const fn nearer_to_1(source: &OutOfRange) -> &'static str {
    match source {
        OutOfRange::Grasp(GraspError::OutOfRange { .. }) => "",
        _ => "; choose units in which lengths and forces are nearer to 1",
    }
}
