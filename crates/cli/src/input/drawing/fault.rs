//! What can be wrong with a drawing.

use std::io;

use clench::shape::PolygonError;

use super::sheet::{Aside, Source, layer_name};
use super::spline::SplineFault;
use crate::wording::{digits, quoted};

/// Why a drawing was refused.
#[derive(Debug, thiserror::Error)]
pub(crate) enum DrawingFault {
    /// The file cannot be read.
    #[error("cannot be read: {0}; expected a drawing, .dxf or .svg")]
    Unreadable(io::Error),
    /// The name does not say what it is.
    #[error("is not known by its ending, expected a drawing, .dxf or .svg")]
    UnknownEnding,
    /// The file has no bytes, or only spaces.
    #[error("is empty, expected a drawing")]
    Empty,
    /// The file has more bytes than any drawing of a part.
    #[error("has {size} bytes, expected a drawing of at most {most}")]
    TooLarge { size: u64, most: u64 },
    /// The reader gave up in a way that it should not.
    #[error("cannot be read: its reader failed; is the file damaged?")]
    Panicked,
    /// An SVG file that is no text.
    #[error("byte {offset} is not UTF-8, expected an SVG file in UTF-8")]
    NotText { offset: usize },
    /// An SVG file that is no XML.
    #[error("is not valid XML: {0}")]
    Xml(roxmltree::Error),
    /// Another document than a drawing.
    #[error("has the root element {}, expected svg", quoted(.found))]
    NotSvg { found: String },
    /// An attribute of an SVG file.
    #[error("line {line}: found {found}, expected {what} with finite numbers and known units")]
    Svg { line: usize, what: &'static str, found: String },
    /// The data of a path.
    #[error("line {line}: the data of the path is not valid")]
    Path { line: usize },
    /// Coordinates that are too large, or not finite.
    #[error("line {line}: the {kind} has coordinates beyond 1e100")]
    OutOfRange { kind: String, line: usize },
    /// Something that is used again, and nowhere to be found.
    #[error("line {line}: there is no element {}", quoted(.name))]
    NoSuchElement { name: String, line: usize },
    /// Groups within groups, or something within itself.
    #[error("line {line}: groups are nested more than {deepest} deep, or in themselves")]
    TooDeep { line: usize, deepest: usize },
    /// The other form of DXF.
    #[error("is a binary DXF file, expected one in text form")]
    BinaryDxf,
    /// The format of one drawing program.
    #[error("is a DWG file, expected DXF in text form")]
    Dwg,
    /// A DXF file without its last record.
    #[error("line {line}: the file ends here without `EOF`: is it cut off?")]
    CutOff { line: usize },
    /// Text where a DXF file has the code of a value.
    #[error("line {line}: found {found}, expected a group code: is it a DXF file?")]
    GroupCode { line: usize, found: String },
    /// A coordinate that is none.
    #[error("line {line}: found {found}, expected a number up to 1e100")]
    NotANumber { line: usize, found: String },
    /// An entity that lacks a coordinate.
    #[error("line {line}: the {kind} has no value with the group code {code}")]
    MissingValue { kind: String, line: usize, code: i32 },
    /// A circle without a size.
    #[error("line {line}: the {kind} has the radius {radius}, expected a positive one")]
    Radius { kind: String, line: usize, radius: f64 },
    /// A polyline all of whose vertices are at one point.
    #[error("line {line}: the {kind} has no length")]
    NoLength { kind: String, line: usize },
    /// A spline that is none.
    #[error("line {line}: the SPLINE {fault}")]
    Spline { line: usize, fault: SplineFault },
    /// A block that is put into the drawing, and nowhere to be found.
    #[error("line {line}: there is no block {}", quoted(.name))]
    NoSuchBlock { name: String, line: usize },
    /// A block within itself.
    #[error("line {line}: the block {} is within itself, or too deep in others", quoted(.name))]
    RecursiveBlock { name: String, line: usize },
    /// Blocks that multiply beyond all measure.
    #[error("draws more than {most} entities, those of blocks counted each time")]
    TooManyEntities { most: usize },
    /// A layer that was asked for.
    #[error(
        "has nothing on {}, expected one of its layers: {}", layer_name(.layer), listed(.known)
    )]
    NoSuchLayer { layer: String, known: Vec<String> },
    /// Nothing that could be an outline.
    #[error("has no curves that could be the outline{}", but(.aside))]
    NothingDrawn { aside: Aside },
    /// All at one point, or larger than numbers are.
    #[error("has the size {diagonal:e}, expected a finite one above 0")]
    Size { diagonal: f64 },
    /// A chord so small that chains would never end.
    #[error(
        "{curve} would bring the edges beyond {most}, with a chord of {}: expected a larger one",
        digits(*.chord)
    )]
    TooManyCorners { curve: Box<Source>, most: usize, chord: f64 },
    /// A curve shorter than what is taken for a gap.
    #[error(
        "{curve} is not longer than {}, up to which ends are joined: expected none so short",
        digits(*.within)
    )]
    TooShort { curve: Source, within: f64 },
    /// An outline that does not close.
    #[error("{curve} ends at {}, where nothing goes on{}", spot(*.at), beside(.nearest.as_deref()))]
    OpenEnd { curve: Box<Source>, at: (f64, f64), nearest: Option<Box<(Source, f64)>> },
    /// The same, where something was left aside.
    #[error("{fault}; left aside: {aside}")]
    Aside { fault: Box<DrawingFault>, aside: Aside },
    /// More than two ends at one point.
    #[error(
        "three ends meet at {}: {}, {} and {}; expected two", spot(*.at),
        .sources[0], .sources[1], .sources[2]
    )]
    Branch { sources: Box<[Source; 3]>, at: (f64, f64) },
    /// No contour at all.
    #[error("has no closed contour")]
    NoCurves,
    /// Two outlines beside each other.
    #[error(
        "has two parts, expected one: the contour with {} is not inside that with {}",
        .sources[1], .sources[0]
    )]
    SecondPart { sources: Box<[Source; 2]> },
    /// A contour within a hole.
    #[error(
        "the contour with {} is inside the hole with {}: expected one part, and nothing in its \
         holes", .sources[1], .sources[0]
    )]
    Island { sources: Box<[Source; 2]> },
    /// Contours that meet themselves or each other.
    #[error("{} and {} cross or touch near {}", .sources[0], .sources[1], spot(*.at))]
    Crossing { sources: Box<[Source; 2]>, at: (f64, f64) },
    /// The outline is not valid in another way.
    #[error(transparent)]
    Outline(PolygonError),
    /// A drawing without units, and none said elsewhere.
    #[error("does not name its unit of length")]
    NoUnit,
    /// A unit that the drawing's cannot be converted into.
    #[error(
        "is in {}, which cannot be converted into {}: expected um, mm, cm, m, in or ft",
        .found, quoted(.wanted)
    )]
    UnknownUnit { found: &'static str, wanted: String },
    /// A layer on which there is no edge.
    #[error("{} has no edge of the outline or a hole", layer_name(.layer))]
    NoEdgeOnLayer { layer: String },
    /// An edge without a stiffness.
    #[error("found no stiffness for {}, on which there are edges", layer_name(.layer))]
    NoStiffness { layer: String },
}

impl DrawingFault {
    pub(in crate::input) fn help(&self) -> Option<&'static str> {
        match self {
            Self::BinaryDxf | Self::Dwg => Some("most programs that draw can save text DXF or SVG"),
            Self::NoUnit => Some("give `units` in the part file, or --units mm"),
            Self::OpenEnd { .. } | Self::Aside { .. } | Self::Branch { .. } => {
                Some("`layers`, or --layer, takes the curves of some layers only")
            }
            _ => None,
        }
    }

    /// The same fault, with what was left aside: it may be what is missing.
    pub(super) fn with_aside(self, aside: &Aside) -> Self {
        if aside.is_empty() || !matches!(self, Self::OpenEnd { .. }) {
            return self;
        }
        Self::Aside { fault: Box::new(self), aside: aside.clone() }
    }
}

fn spot((x, y): (f64, f64)) -> String {
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

fn but(aside: &Aside) -> String {
    if aside.is_empty() { String::new() } else { format!(", only {aside}") }
}

fn listed(layers: &[String]) -> String {
    layers.iter().map(|layer| quoted(layer)).collect::<Vec<_>>().join(", ")
}
