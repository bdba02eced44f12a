//! What can be wrong with a file's text and numbers.

mod balance;
mod contact;
mod drawing;
mod load;
mod mesh;
mod part;

use std::borrow::Cow;
use std::ops::Range;

use clench::stiffness::GraspError;
use miette::Diagnostic;

use super::excerpt::Excerpt;
use super::number::in_words;
use super::place::{Place, Step};
use super::schema::{Units, VERSION};

pub(crate) use balance::{BalanceFault, Pull};
pub(crate) use contact::{ContactFault, Coordinates, Nearest};
pub(crate) use drawing::DrawingFault;
pub(crate) use load::LoadFault;
pub(crate) use mesh::MeshFault;
pub(crate) use part::PartFault;

/// A fault of the text, before there are any fields to name.
#[derive(Debug)]
pub(super) struct Located {
    pub(super) span: Range<usize>,
    pub(super) fault: Fault,
}

/// Why an input file was refused, and at which of its bytes.
#[derive(Debug, thiserror::Error)]
#[error("{at}{fault}")]
pub(crate) struct InputError {
    /// The file, the line and the column, and the field, if the fault does not name them itself.
    at: String,
    file: String,
    position: Position,
    #[source]
    fault: Fault,
    /// Nothing to show where something is missing.
    excerpt: Option<Excerpt>,
}

/// A place in the text of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Position {
    /// From 1; none if the fault is of the file as a whole.
    pub(crate) line: Option<usize>,
    /// In characters, from 1.
    pub(crate) column: Option<usize>,
    /// The path of the value, if it is about one.
    pub(crate) field: Option<String>,
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
            format!("{name}:{line}:{column}: ")
        } else {
            format!("{name}:{line}:{column}: {place}: ")
        };
        let field = (!place.steps().is_empty()).then(|| place.to_string());
        let position = Position { line: Some(line), column: Some(column), field };
        Self { at, file: name.to_owned(), position, fault, excerpt: Some(excerpt) }
    }

    /// The name of the file.
    pub(crate) fn file(&self) -> &str {
        &self.file
    }

    /// Where in the file.
    pub(crate) fn position(&self) -> Position {
        self.position.clone()
    }

    /// The fault of the option that stands for the field at `place`, or of the part `name` alone.
    pub(super) fn of_option(name: &str, place: &Place, fault: Fault) -> Self {
        let field = place.steps().iter().rev().find_map(|step| match step {
            Step::Field(field) => Some(field.as_str()),
            Step::Item(_) => None,
        });
        let at = match field {
            Some("drawing" | "mesh") => String::new(),
            Some("chord") => "--chord: ".to_owned(),
            Some("forbidden") => "--forbid: ".to_owned(),
            _ => format!("{name}: "),
        };
        let position = Position { line: fault.line(), column: None, field: None };
        Self { at, file: name.to_owned(), position, fault, excerpt: None }
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
    /// A point or a direction of space in a planar part, or the other way round.
    #[error("found {found} numbers, expected {}, as the part has", in_words(&[*.expected]))]
    Dimension { found: usize, expected: usize },
    /// Contacts for the part of another file, in other units.
    #[error(
        "found the units {} and {}, expected those of {name}: {} and {}",
        .units[0].length.0, .units[0].force.0, .units[1].length.0, .units[1].force.0
    )]
    OtherUnits { name: String, units: Box<[Units; 2]> },
    /// Loads where only contacts count.
    #[error("found loads, which `optimize` does not take into account; expected none")]
    Loads,
    /// What is held.
    #[error(transparent)]
    Part(#[from] PartFault),
    /// A grasp without contacts.
    #[error("found no contacts, expected at least one [[contacts]]")]
    NoContacts,
    /// What holds it.
    #[error(transparent)]
    Contact(#[from] ContactFault),
    /// How hard that presses.
    #[error(transparent)]
    Balance(#[from] BalanceFault),
    /// What acts on it.
    #[error(transparent)]
    Load(#[from] LoadFault),
    /// The grasp cannot be formed.
    #[error(transparent)]
    Grasp(GraspError),
}

impl Fault {
    /// The line of the drawing or the mesh that it is about.
    fn line(&self) -> Option<usize> {
        match self {
            Self::Part(PartFault::Mesh { fault, .. }) => fault.line(),
            Self::Part(PartFault::Drawing { fault, .. }) => fault.line(),
            _ => None,
        }
    }

    fn help(&self) -> Option<Cow<'static, str>> {
        let fixed = match self {
            Self::Contact(fault) => return fault.help(),
            Self::Balance(fault) => return fault.help().map(Cow::Owned),
            Self::Schema { help, .. } => *help,
            Self::NoContacts => Some("`clench optimize` finds where to put the fingers"),
            Self::Part(fault) => fault.help(),
            Self::Empty => Some("`clench --help` shows a file"),
            _ => None,
        };
        fixed.map(Cow::Borrowed)
    }
}

/// The names of those that are given, if any is.
pub(in crate::input) fn listed(fields: &[(&str, bool)]) -> Option<String> {
    let names: Vec<&str> = fields.iter().filter(|(_, given)| *given).map(|(n, _)| *n).collect();
    (!names.is_empty()).then(|| names.join(" and "))
}
