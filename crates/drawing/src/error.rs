//! What can be wrong with a drawing.

use std::fmt;
use std::io;

use clench_shape::PolygonError;

use crate::source::{LeftAside, Source};
use crate::spline_error::SplineError;
use crate::wording::{Layer, Quoted, digits};

/// Why a drawing was refused.
///
/// Lines of the file count from 1. Coordinates are those of the part: of the drawing, times the
/// scale.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DrawingError {
    /// The file cannot be read.
    #[error("the file cannot be read: {0}; expected a drawing, .dxf or .svg")]
    Unreadable(io::Error),
    /// The name does not say what it is.
    #[error("the file is not known by its ending, expected a drawing, .dxf or .svg")]
    UnknownEnding,
    /// The file has no bytes, or only spaces.
    #[error("the file is empty, expected a drawing")]
    Empty,
    /// The file has more bytes than any drawing of a part.
    #[error("the file has {size} bytes, expected a drawing of at most {most}")]
    TooLarge {
        /// What was found (bytes).
        size: u64,
        /// What is allowed (bytes).
        most: u64,
    },
    /// Text of two bytes per letter.
    #[error("the file looks like text in UTF-16, expected it in UTF-8")]
    Utf16,
    /// An SVG file that is no text.
    #[error("byte {offset} is not UTF-8, expected an SVG file in UTF-8")]
    NotText {
        /// The first such byte, from 0.
        offset: usize,
    },
    /// An SVG file that is no XML.
    #[error("the file is not valid XML: {0}")]
    Xml(XmlError),
    /// Another document than a drawing.
    #[error("the file has the root element {}, expected svg", Quoted(.found))]
    NotSvg {
        /// The name of the root element.
        found: String,
    },
    /// An attribute of an SVG file.
    #[error(
        "line {line}: found {}, expected {expected} with finite numbers and known units",
        Quoted(.found)
    )]
    Attribute {
        /// The line of the element.
        line: usize,
        /// `"a length"`, `"transform"`, `"viewBox"` or `"preserveAspectRatio"`.
        expected: &'static str,
        /// The value of the attribute.
        found: String,
    },
    /// A size of an SVG file that is none.
    #[error("line {line}: found the {name} {}, expected {expected}", Quoted(.found))]
    SvgSize {
        /// The line of the element.
        line: usize,
        /// The name of the attribute: `"width"`, `"r"`.
        name: &'static str,
        /// Its value.
        found: String,
        /// What would be one.
        expected: &'static str,
    },
    /// The data of a path of an SVG file.
    #[error("line {line}: the data of the path {}, expected commands and finite numbers", .fault)]
    Path {
        /// The line of the path.
        line: usize,
        /// Where it is not valid.
        fault: PathFault,
    },
    /// Coordinates that are too large, or not finite.
    #[error("line {line}: the {kind} has coordinates beyond 1e100")]
    OutOfRange {
        /// The name of the element.
        kind: String,
        /// Its line.
        line: usize,
    },
    /// Something that is used again, and nowhere to be found.
    #[error("line {line}: there is no element {}", Quoted(.name))]
    NoSuchElement {
        /// The link to it.
        name: String,
        /// The line of the `use`.
        line: usize,
    },
    /// Groups within groups, or something within itself.
    #[error("line {line}: groups are nested more than {deepest} deep, or in themselves")]
    TooDeep {
        /// The line of the innermost.
        line: usize,
        /// What is allowed.
        deepest: usize,
    },
    /// The other form of DXF.
    #[error("the file is a binary DXF file, expected one in text form")]
    BinaryDxf,
    /// The format of one drawing program.
    #[error("the file is a DWG file, expected DXF in text form")]
    Dwg,
    /// A DXF file without its last record.
    #[error("line {line}: the file ends here without `EOF`: is it cut off?")]
    CutOff {
        /// The last line.
        line: usize,
    },
    /// Text where a DXF file has the code of a value.
    #[error("line {line}: found {}, expected a group code: is it a DXF file?", Quoted(.found))]
    GroupCode {
        /// Where it is.
        line: usize,
        /// What is there.
        found: String,
    },
    /// A coordinate of a DXF file that is none.
    #[error("line {line}: found {}, expected a number up to 1e100", Quoted(.found))]
    NotANumber {
        /// Where it is.
        line: usize,
        /// What is there.
        found: String,
    },
    /// A unit of length of a DXF file that is none, or none of a part.
    #[error(
        "line {line}: $INSUNITS is {}{}, expected the number of a unit of length, 1 to 16 or 21 \
         to 24, or 0 for none",
        Quoted(.found), called(*.named)
    )]
    UnitNumber {
        /// Where it is.
        line: usize,
        /// What is there.
        found: String,
        /// What this number stands for, if it is a unit.
        named: Option<&'static str>,
    },
    /// An entity that lacks a coordinate.
    #[error("line {line}: the {kind} has no value with the group code {code}")]
    MissingValue {
        /// The kind of entity.
        kind: String,
        /// Its line.
        line: usize,
        /// The code of what is missing.
        code: i32,
    },
    /// A circle or an arc without a size.
    #[error("line {line}: the {kind} has the radius {radius}, expected a positive one")]
    Radius {
        /// The kind of entity.
        kind: String,
        /// Its line.
        line: usize,
        /// What was found.
        radius: f64,
    },
    /// An ellipse without a width.
    #[error("line {line}: the ELLIPSE has the ratio of axes {ratio}, expected one above 0")]
    AxisRatio {
        /// Its line.
        line: usize,
        /// What was found.
        ratio: f64,
    },
    /// A curve all of whose points are one.
    #[error("line {line}: the {kind} has no length")]
    NoLength {
        /// The kind of entity or element.
        kind: String,
        /// Its line.
        line: usize,
    },
    /// A spline that is none.
    #[error("line {line}: the SPLINE {error}")]
    Spline {
        /// Its line.
        line: usize,
        /// What is wrong with it.
        error: SplineError,
    },
    /// A block that is put into the drawing, and nowhere to be found.
    #[error("line {line}: there is no block {}", Quoted(.name))]
    NoSuchBlock {
        /// The name of the block.
        name: String,
        /// The line of the INSERT.
        line: usize,
    },
    /// A block within itself.
    #[error("line {line}: the block {} is within itself", Quoted(.name))]
    RecursiveBlock {
        /// The name of the block.
        name: String,
        /// The line of the INSERT.
        line: usize,
    },
    /// Blocks within blocks.
    #[error(
        "line {line}: the block {} is within {deepest} others, one in the other, expected blocks \
         nested at most {deepest} deep", Quoted(.name)
    )]
    BlockTooDeep {
        /// The name of the block.
        name: String,
        /// The line of the INSERT.
        line: usize,
        /// What is allowed.
        deepest: usize,
    },
    /// Blocks or elements that multiply beyond all measure.
    #[error("the drawing has more than {most} entities, those used again counted each time")]
    TooManyEntities {
        /// What is allowed.
        most: usize,
    },
    /// A layer that was asked for.
    #[error(
        "the drawing has nothing on {}, expected one of its layers: {}",
        Layer(.layer), listed(.known.iter().map(|layer| Quoted(layer)))
    )]
    NoSuchLayer {
        /// What was asked for.
        layer: String,
        /// Those with something on them.
        known: Vec<String>,
    },
    /// Lengths cannot be multiplied with this.
    #[error("the scale is {scale}, expected a positive finite number")]
    Scale {
        /// What was given.
        scale: f64,
    },
    /// A chord that no chain of edges keeps.
    #[error("the chord is {chord}, expected a positive finite number")]
    Chord {
        /// What was given (length).
        chord: f64,
    },
    /// Nothing that could be an outline.
    #[error("the drawing has no curves that could be the outline{}", but(.left_aside))]
    NothingDrawn {
        /// What there is instead.
        left_aside: Vec<LeftAside>,
    },
    /// All at one point, or larger than numbers are.
    #[error("the drawing has the size {diagonal:e}, expected a finite one above 0")]
    Size {
        /// The diagonal of the smallest upright rectangle around it (length).
        diagonal: f64,
    },
    /// A chord so small that chains would never end.
    #[error(
        "{curve} would bring the edges beyond {most}, with a chord of {}: expected a larger one",
        digits(*.chord)
    )]
    TooManyCorners {
        /// The first curve for which there is no room.
        curve: Box<Source>,
        /// The corners that are allowed.
        most: usize,
        /// What was asked for, or taken (length).
        chord: f64,
    },
    /// A curve shorter than what is taken for a gap.
    #[error(
        "{curve} is not longer than {}, up to which ends are joined: expected none so short",
        digits(*.within)
    )]
    TooShort {
        /// The first such curve.
        curve: Box<Source>,
        /// The distance up to which ends are joined (length).
        within: f64,
    },
    /// An outline that does not close.
    #[error(
        "{curve} ends at {}, where nothing goes on{}{}", spot(*.at),
        beside(.nearest.as_deref()), missing(.left_aside)
    )]
    OpenEnd {
        /// The curve that ends there.
        curve: Box<Source>,
        /// Where it ends (length).
        at: [f64; 2],
        /// The curve with the nearest other end that is open, and how far that is (length).
        nearest: Option<Box<(Source, f64)>>,
        /// What is on the drawing besides: it may be what is missing.
        left_aside: Vec<LeftAside>,
    },
    /// More than two ends at one point.
    #[error(
        "three ends meet at {}: {}, {} and {}; expected two", spot(*.at),
        .curves[0], .curves[1], .curves[2]
    )]
    Branch {
        /// The curves that end there.
        curves: Box<[Source; 3]>,
        /// Where they end (length).
        at: [f64; 2],
    },
    /// Two outlines beside each other.
    #[error(
        "the drawing has two parts, expected one: the contour with {} is not inside that with {}",
        .curves[1], .curves[0]
    )]
    SecondPart {
        /// A curve of the larger contour, and one of the other.
        curves: Box<[Source; 2]>,
    },
    /// A contour within a hole.
    #[error(
        "the contour with {} is inside the hole with {}: expected one part, and nothing in its \
         holes", .curves[1], .curves[0]
    )]
    Island {
        /// A curve of the hole, and one of the contour in it.
        curves: Box<[Source; 2]>,
    },
    /// Contours that meet themselves or each other.
    #[error("{} and {} cross or touch near {}", .curves[0], .curves[1], spot(*.at))]
    Crossing {
        /// The curves whose edges meet; twice the same if it meets itself.
        curves: Box<[Source; 2]>,
        /// A corner of one of the edges (length).
        at: [f64; 2],
    },
    /// The outline is not valid in another way; corners are numbered as those of the polygon.
    #[error(transparent)]
    Outline(PolygonError),
}

/// Where the data of a path is not valid.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PathFault {
    /// It ends too early.
    Ends,
    /// Something else is there.
    At {
        /// The character of the data where it is, from 1.
        character: usize,
        /// What is there.
        found: String,
    },
}

/// Why a text is not XML.
#[derive(Debug)]
pub struct XmlError(pub(crate) roxmltree::Error);

impl DrawingError {
    /// The line of the file that it is about, from 1: of several the first that is named.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        match self {
            Self::Attribute { line, .. }
            | Self::SvgSize { line, .. }
            | Self::Path { line, .. }
            | Self::OutOfRange { line, .. }
            | Self::NoSuchElement { line, .. }
            | Self::TooDeep { line, .. }
            | Self::CutOff { line }
            | Self::GroupCode { line, .. }
            | Self::NotANumber { line, .. }
            | Self::UnitNumber { line, .. }
            | Self::MissingValue { line, .. }
            | Self::Radius { line, .. }
            | Self::AxisRatio { line, .. }
            | Self::NoLength { line, .. }
            | Self::Spline { line, .. }
            | Self::NoSuchBlock { line, .. }
            | Self::RecursiveBlock { line, .. }
            | Self::BlockTooDeep { line, .. } => Some(*line),
            Self::Xml(XmlError(error)) => usize::try_from(error.pos().row).ok(),
            Self::TooManyCorners { curve, .. }
            | Self::TooShort { curve, .. }
            | Self::OpenEnd { curve, .. } => Some(curve.line),
            Self::Branch { curves, .. } => Some(curves[0].line),
            // The contour that is too many.
            Self::SecondPart { curves } | Self::Island { curves } => Some(curves[1].line),
            Self::Crossing { curves, .. } => Some(curves[0].line),
            _ => None,
        }
    }

    /// The same error, with what was left aside: it may be what is missing.
    pub(crate) fn with_left_aside(mut self, aside: &[LeftAside]) -> Self {
        if let Self::OpenEnd { left_aside, .. } = &mut self {
            *left_aside = aside.to_vec();
        }
        self
    }
}

impl fmt::Display for PathFault {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ends => out.write_str("ends too early"),
            Self::At { character, found } => {
                write!(out, "has {} at its character {character}", Quoted(found))
            }
        }
    }
}

impl fmt::Display for XmlError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(out)
    }
}

impl std::error::Error for XmlError {}

fn called(unit: Option<&str>) -> String {
    unit.map_or_else(String::new, |unit| format!(" ({unit})"))
}

fn spot([x, y]: [f64; 2]) -> String {
    format!("({}, {})", digits(x), digits(y))
}

fn beside(nearest: Option<&(Source, f64)>) -> String {
    match nearest {
        Some((source, distance)) => {
            format!("; the nearest other end is {} away, that of {source}", digits(*distance))
        }
        None => String::new(),
    }
}

fn missing(aside: &[LeftAside]) -> String {
    if aside.is_empty() { String::new() } else { format!("; left aside: {}", listed(aside)) }
}

fn but(aside: &[LeftAside]) -> String {
    if aside.is_empty() { String::new() } else { format!(", only {}", listed(aside)) }
}

fn listed(things: impl IntoIterator<Item = impl fmt::Display>) -> String {
    things.into_iter().map(|thing| thing.to_string()).collect::<Vec<_>>().join(", ")
}
