//! The values of a file as a tree, each with the bytes it was read from.

use std::ops::Range;

use super::place::{Place, Step};

/// A value and where it stands in the text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Node {
    pub(crate) value: Value,
    pub(crate) span: Range<usize>,
}

/// What TOML and JSON have in common.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    /// JSON's `null`.
    Null,
    Flag(bool),
    /// Any number; one that a double cannot hold is infinite.
    Number(f64),
    Text(String),
    /// A date or time of TOML: no field is one.
    Date,
    List(Vec<Node>),
    Table(Vec<Entry>),
}

/// A field of a table.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Entry {
    pub(crate) key: String,
    pub(crate) key_span: Range<usize>,
    pub(crate) node: Node,
}

impl Node {
    /// The bytes of the value at `place`, or of the innermost table or list on the way that exists.
    pub(crate) fn span_of(&self, place: &Place) -> Range<usize> {
        let mut node = self;
        for step in place.steps() {
            let next = match (step, &node.value) {
                (Step::Field(name), Value::Table(entries)) => {
                    entries.iter().find(|e| e.key == *name).map(|e| &e.node)
                }
                (Step::Item(i), Value::List(items)) => items.get(*i),
                _ => None,
            };
            match next {
                Some(next) => node = next,
                None => break,
            }
        }
        node.span.clone()
    }

    /// Takes the fields called `names` out, if this is a table.
    pub(crate) fn without(mut self, names: &[&str]) -> Self {
        if let Value::Table(entries) = &mut self.value {
            entries.retain(|entry| !names.contains(&entry.key.as_str()));
        }
        self
    }
}
