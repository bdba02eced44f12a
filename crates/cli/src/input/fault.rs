//! What can be wrong with a file's text and numbers.

use std::ops::Range;

use clench::contact::ContactError;
use clench::optimize::OptimizeError;
use clench::shape::PolygonError;
use clench::stiffness::GraspError;
use miette::Diagnostic;

use super::excerpt::Excerpt;
use super::place::Place;
use super::schema::VERSION;
use crate::wording::{counted, digits};

/// A fault of the text, before there are any fields to name.
#[derive(Debug)]
pub(super) struct Located {
    pub(super) span: Range<usize>,
    pub(super) fault: Fault,
}

/// Why an input file was refused, and at which of its bytes.
#[derive(Debug, thiserror::Error)]
#[error("{at}: {fault}")]
pub(crate) struct InputError {
    /// The file, the line and the column, and the field.
    at: String,
    #[source]
    fault: Fault,
    /// Nothing to show where something is missing.
    excerpt: Option<Excerpt>,
}

impl InputError {
    /// The fault of the value at `place`, which stands at `span` of the file's text.
    pub(super) fn new(
        name: &str,
        text: &str,
        place: &Place,
        span: &Range<usize>,
        fault: Fault,
    ) -> Self {
        let excerpt = Excerpt::new(name, text, span);
        let (line, column) = excerpt.line_and_column();
        let at = if place.steps().is_empty() {
            format!("{name}:{line}:{column}")
        } else {
            format!("{name}:{line}:{column}: {place}")
        };
        Self { at, fault, excerpt: Some(excerpt) }
    }

    /// The same error, without the text around it: what it is about is not in the file.
    pub(super) fn without_excerpt(self) -> Self {
        Self { excerpt: None, ..self }
    }
}

impl Diagnostic for InputError {
    fn help<'a>(&'a self) -> Option<Box<dyn std::fmt::Display + 'a>> {
        self.fault.help().map(|help| Box::new(help) as Box<_>)
    }

    fn source_code(&self) -> Option<&dyn miette::SourceCode> {
        self.excerpt.as_ref().map(|excerpt| excerpt as &dyn miette::SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = miette::LabeledSpan> + '_>> {
        let span = self.excerpt.as_ref()?.fault();
        let label = miette::LabeledSpan::new_with_span(Some("here".to_owned()), span);
        Some(Box::new(std::iter::once(label)))
    }
}

/// What is wrong at a place of a file.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Fault {
    /// There is no text.
    #[error("the file is empty, expected a part")]
    Empty,
    /// Neither TOML nor JSON.
    #[error("not valid {language}: {message}")]
    Syntax { language: &'static str, message: String },
    /// A field is given twice in one table of a JSON file.
    #[error("the field `{name}` is given twice")]
    RepeatedField { name: String },
    /// Lists within lists without end.
    #[error("lists and tables are nested more than {deepest} deep")]
    TooDeep { deepest: usize },
    /// The text is fine, but not what the schema asks for.
    #[error("{message}")]
    Schema { message: String, help: Option<&'static str> },
    /// The schema of another version.
    #[error("found schema version {found}, expected {VERSION}")]
    Version { found: u64 },
    /// A part in space.
    #[error("found a spatial part, expected a planar one: this version knows the plane only")]
    SpatialPart,
    /// Neither a planar nor a spatial part.
    #[error("found no `planar` in the part, expected it, with an `outline` and a `stiffness`")]
    NoPart,
    /// A grasp without contacts.
    #[error("found no contacts, expected at least one [[contacts]]")]
    NoContacts,
    /// Too few points for an outline.
    #[error("found {}, expected at least 3", counted(*.count, "corner"))]
    TooFewCorners { count: usize },
    /// The outline is not valid.
    #[error(transparent)]
    Outline(PolygonError),
    /// The edge stiffnesses are not valid.
    #[error(transparent)]
    Stiffness(OptimizeError),
    /// A law or a contact is not valid.
    #[error(transparent)]
    Contact(ContactError),
    /// The grasp cannot be formed.
    #[error(transparent)]
    Grasp(GraspError),
    /// An edge number is too large.
    #[error("found edge {found}, expected one from 0 to {last}")]
    NoSuchEdge { found: u64, last: usize },
    /// A contact floats beside the part, or lies within it.
    #[error(
        "contact {contact} is off the boundary: found it {} {unit} away from edge {edge}, \
         the nearest, expected at most {allowed:.1e} {unit}",
        digits(*.distance)
    )]
    OffBoundary { contact: usize, distance: f64, edge: usize, allowed: f64, unit: String },
    /// A contact is on another edge than it says.
    #[error(
        "contact {contact} is not on edge {edge}: found it {} {unit} away, \
         expected at most {allowed:.1e} {unit}; the nearest edge is {nearest}",
        digits(*.distance)
    )]
    OffEdge {
        contact: usize,
        edge: usize,
        distance: f64,
        allowed: f64,
        unit: String,
        nearest: usize,
    },
    /// A contact at a corner, which has no normal.
    #[error(
        "contact {contact} is at the corner of edges {first} and {second}: \
         expected an `edge` or an `inward_normal` that says which of them it presses on"
    )]
    AmbiguousEdge { contact: usize, first: usize, second: usize },
    /// A normal that is not that of the edge.
    #[error(
        "found the inward normal {} of contact {contact}, \
         expected {}, that of edge {edge}",
        direction(.found), direction(.expected)
    )]
    OtherNormal { contact: usize, edge: usize, found: [f64; 2], expected: [f64; 2] },
}

impl Fault {
    fn help(&self) -> Option<&'static str> {
        match self {
            Self::Schema { help, .. } => *help,
            Self::SpatialPart => Some("give an `outline` under [part.planar]"),
            Self::NoContacts => Some("`clench optimize` finds where to put the fingers"),
            Self::OtherNormal { .. } => {
                Some("leave `inward_normal` out: it follows from the outline")
            }
            Self::Empty | Self::NoPart => Some("`clench --help` shows a file"),
            _ => None,
        }
    }
}

fn direction(components: &[f64; 2]) -> String {
    let [x, y] = components.map(digits);
    format!("[{x}, {y}]")
}
