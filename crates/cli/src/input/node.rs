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
    /// The bytes of the value at `place`, and that it exists; if it does not, those of the
    /// innermost table or list on the way that does.
    pub(crate) fn span_of(&self, place: &Place) -> (Range<usize>, bool) {
        let mut node = self;
        for step in place.steps() {
            let next = match step {
                Step::Field(name) => node.field(name),
                Step::Item(i) => node.items().get(*i),
            };
            match next {
                Some(next) => node = next,
                None => return (node.span.clone(), false),
            }
        }
        (node.span.clone(), true)
    }

    /// The field `name`, if this is a table that has it.
    pub(crate) fn field(&self, name: &str) -> Option<&Self> {
        let Value::Table(entries) = &self.value else { return None };
        entries.iter().find(|entry| entry.key == name).map(|entry| &entry.node)
    }

    fn items(&self) -> &[Self] {
        if let Value::List(items) = &self.value { items } else { &[] }
    }

    /// Takes the fields called `names` out, if this is a table.
    pub(crate) fn remove(&mut self, names: &[&str]) {
        if let Value::Table(entries) = &mut self.value {
            entries.retain(|entry| !names.contains(&entry.key.as_str()));
        }
    }

    /// The items of the list in the field `name`; none if there is no such list.
    pub(crate) fn items_of_field(&mut self, name: &str) -> &mut [Self] {
        let Value::Table(entries) = &mut self.value else { return &mut [] };
        match entries.iter_mut().find(|entry| entry.key == name).map(|e| &mut e.node.value) {
            Some(Value::List(items)) => items,
            _ => &mut [],
        }
    }
}
