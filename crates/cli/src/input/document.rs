//! An input file: its text, its values, and the errors that point into it.

use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde::de::DeserializeOwned;

use super::fault::{Fault, InputError, Located};
use super::node::{Node, Value};
use super::place::Place;
use super::reader::Reader;
use super::schema::{self, File, VERSION};
use super::text::text_of;
use super::{json_tree, toml_tree};
use crate::failure::Failure;
use crate::report::html::Source;

/// A file that was read, and what it says.
#[derive(Debug)]
pub(crate) struct Document {
    name: String,
    folder: PathBuf,
    text: String,
    root: Node,
    /// Whether there is no file of this schema, only a drawing or a mesh and options.
    alone: bool,
    is_report: bool,
}

impl Document {
    /// Reads the file at `path`, or standard input for `-`, and checks it against the schema.
    ///
    /// The ending `.toml` or `.json` says what it is; without one, a file that starts with a brace
    /// is JSON.
    pub(crate) fn read<P: DeserializeOwned>(path: &Path) -> Result<(Self, File<P>), Failure> {
        let (name, text) = text_of(path)?;
        let parsed = match language(path, &text) {
            _ if text.trim().is_empty() => Err(Located { span: 0..0, fault: Fault::Empty }),
            Language::Toml => toml_tree::parse(&text),
            Language::Json => json_tree::parse(&text),
        };
        let root = parsed.map_err(|Located { span, fault }| {
            InputError::new(&name, &text, &Place::default(), &span, fault)
        })?;
        let folder = path.parent().map(Path::to_owned).unwrap_or_default();
        let is_report = schema::is_report(&root);
        let root = schema::without_results(root);
        let document = Self { name, folder, text, root, alone: false, is_report };
        let file = document.checked()?;
        Ok((document, file))
    }

    /// What stands for the part file where the drawing or mesh at `path` is the part alone.
    pub(super) fn of_part_alone(path: &Path) -> Self {
        Self {
            name: path.display().to_string(),
            folder: path.parent().map(Path::to_owned).unwrap_or_default(),
            text: String::new(),
            root: Node { value: Value::Null, span: 0..0 },
            alone: true,
            is_report: false,
        }
    }

    /// How reports call the file.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// The file as it was read.
    pub(crate) fn source(&self) -> Source {
        Source { name: self.name.clone(), text: self.text.clone() }
    }

    /// The same, or nothing if a drawing or a mesh stands for it.
    pub(crate) fn sources(&self) -> Vec<Source> {
        if self.alone { Vec::new() } else { vec![self.source()] }
    }

    /// Whether it is a report of `optimize`, whose contacts are results.
    pub(crate) const fn is_report(&self) -> bool {
        self.is_report
    }

    /// The folder from which the file names others: its own, or the current one for standard
    /// input.
    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    /// The error that the value at `place` has a fault.
    pub(crate) fn error(&self, place: &Place, fault: impl Into<Fault>) -> Failure {
        if self.alone {
            return InputError::of_option(&self.name, place, fault.into()).into();
        }
        let (span, exists) = self.root.span_of(place);
        let error = InputError::new(&self.name, &self.text, place, &span, fault.into());
        if exists { error.into() } else { error.without_excerpt().into() }
    }

    fn checked<P: DeserializeOwned>(&self) -> Result<File<P>, Failure> {
        let file = File::<P>::deserialize(Reader(&self.root)).map_err(|mismatch| {
            let (message, place, span) = mismatch.into_parts();
            let whole = span.is_none();
            let span = span.unwrap_or_else(|| self.root.span.clone());
            let fault = Fault::Schema { message, help: schema::help(&place) };
            let error = InputError::new(&self.name, &self.text, &place, &span, fault);
            // What is missing at the top of a file is at none of its lines.
            if whole { error.without_excerpt() } else { error }
        })?;
        match file.version {
            Some(version) if version.0 != VERSION => {
                let place = Place::default().field("version");
                Err(self.error(&place, Fault::Version { found: version.0 }))
            }
            _ => Ok(file),
        }
    }
}

enum Language {
    Toml,
    Json,
}

fn language(path: &Path, text: &str) -> Language {
    let ends = |ending: &str| path.extension().is_some_and(|e| e.eq_ignore_ascii_case(ending));
    let json = ends("json") || (!ends("toml") && text.trim_start().starts_with('{'));
    if json { Language::Json } else { Language::Toml }
}
