//! Serde's view of a tree of values: one set of messages for TOML and JSON.

use std::fmt;
use std::ops::Range;

use serde::de::value::BorrowedStrDeserializer;
use serde::de::{DeserializeSeed, Error, Expected, MapAccess, SeqAccess, Unexpected, Visitor};
use serde::forward_to_deserialize_any;

use super::node::{Entry, Node, Value};
use super::place::{Place, Step};
use super::schema;
use crate::wording::quoted;

/// What does not fit the schema, and where.
#[derive(Debug)]
pub(super) struct Mismatch {
    what: What,
    /// Steps from the innermost value outwards.
    steps: Vec<Step>,
    span: Option<Range<usize>>,
}

#[derive(Debug)]
enum What {
    /// In words already.
    Said(String),
    /// What is expected depends on the table that it is missing in.
    Missing(&'static str),
}

impl Mismatch {
    /// The message, the place, and the bytes when it is about less than the whole file.
    pub(super) fn into_parts(self) -> (String, Place, Option<Range<usize>>) {
        let place = Place::from_reversed(self.steps);
        let message = match self.what {
            What::Said(message) => message,
            What::Missing(field) => {
                format!("missing field `{field}`, expected {}", schema::expected(&place, field))
            }
        };
        (message, place, self.span)
    }

    fn inside(mut self, step: Step, span: &Range<usize>) -> Self {
        self.steps.push(step);
        self.span.get_or_insert_with(|| span.clone());
        self
    }

    fn found(what: impl fmt::Display, expected: &dyn Expected) -> Self {
        // Serde's own words, for a `Vec` and for the tag of an enum.
        let expected = expected.to_string().replace("a sequence", "a list");
        let expected = expected.replace("variant identifier", "the name of a kind");
        Self::custom(format_args!("found {what}, expected {expected}"))
    }
}

impl Error for Mismatch {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self { what: What::Said(message.to_string()), steps: Vec::new(), span: None }
    }

    fn missing_field(field: &'static str) -> Self {
        Self { what: What::Missing(field), steps: Vec::new(), span: None }
    }

    fn invalid_type(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        match found {
            Unexpected::Float(_) => Self::found("a number", expected),
            _ => Self::found(Found(found), expected),
        }
    }

    fn invalid_value(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Self::found(Found(found), expected)
    }

    fn invalid_length(count: usize, expected: &dyn Expected) -> Self {
        Self::found(format_args!("a list of {count}"), expected)
    }
}

/// A value in the words of TOML and JSON.
struct Found<'a>(Unexpected<'a>);

impl fmt::Display for Found<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Unexpected::Unit | Unexpected::Option => out.write_str("null"),
            Unexpected::Bool(flag) => write!(out, "{flag}"),
            Unexpected::Float(number) => write!(out, "{number}"),
            Unexpected::Str(text) => write!(out, "text {}", quoted(text)),
            Unexpected::Seq => out.write_str("a list"),
            Unexpected::Map => out.write_str("a table"),
            Unexpected::Other(what) => out.write_str(what),
            // The tree has no other values.
            other => write!(out, "{other}"),
        }
    }
}

impl std::error::Error for Mismatch {}

impl fmt::Display for Mismatch {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.what {
            What::Said(message) => out.write_str(message),
            What::Missing(field) => write!(out, "missing field `{field}`"),
        }
    }
}

/// A value about to be read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reader<'a>(pub(super) &'a Node);

impl<'de> serde::Deserializer<'de> for Reader<'de> {
    type Error = Mismatch;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        match &self.0.value {
            Value::Null => visitor.visit_unit(),
            Value::Flag(flag) => visitor.visit_bool(*flag),
            Value::Number(number) => visitor.visit_f64(*number),
            Value::Text(text) => visitor.visit_borrowed_str(text),
            Value::Date => Err(Mismatch::invalid_type(Unexpected::Other("a date"), &visitor)),
            Value::List(items) => visitor.visit_seq(Items { items, next: 0 }),
            Value::Table(entries) => visitor.visit_map(Fields { entries, next: 0 }),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        match &self.0.value {
            Value::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Mismatch> {
        visitor.visit_newtype_struct(self)
    }

    /// Serde would take the items of a list for the fields of a table, in their order.
    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Mismatch> {
        match &self.0.value {
            Value::List(_) => Err(Mismatch::invalid_type(Unexpected::Seq, &visitor)),
            _ => self.deserialize_any(visitor),
        }
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit
        unit_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}

struct Items<'a> {
    items: &'a [Node],
    next: usize,
}

impl<'de> SeqAccess<'de> for Items<'de> {
    type Error = Mismatch;

    fn next_element_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Mismatch> {
        let Some(item) = self.items.get(self.next) else { return Ok(None) };
        let step = Step::Item(self.next);
        self.next += 1;
        seed.deserialize(Reader(item)).map(Some).map_err(|e| e.inside(step, &item.span))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.items.len() - self.next)
    }
}

struct Fields<'a> {
    entries: &'a [Entry],
    next: usize,
}

impl<'de> MapAccess<'de> for Fields<'de> {
    type Error = Mismatch;

    fn next_key_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Mismatch> {
        let Some(entry) = self.entries.get(self.next) else { return Ok(None) };
        let key = BorrowedStrDeserializer::new(&entry.key);
        let step = Step::Field(entry.key.clone());
        seed.deserialize(key).map(Some).map_err(|e: Mismatch| e.inside(step, &entry.key_span))
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, Mismatch> {
        let entry = &self.entries[self.next];
        self.next += 1;
        let step = Step::Field(entry.key.clone());
        seed.deserialize(Reader(&entry.node)).map_err(|e| e.inside(step, &entry.node.span))
    }
}
