//! JSON text as a tree of values.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

use serde::Deserialize;
use serde::de::{MapAccess, Visitor};
use serde_json::value::RawValue;

use super::fault::{Fault, Located};
use super::node::{Entry, Node, Value};

/// Lists and tables within each other; a grasp needs four.
const DEEPEST: usize = 32;

/// The tree of a JSON file.
pub(super) fn parse(text: &str) -> Result<Node, Located> {
    let whole: &RawValue = serde_json::from_str(text).map_err(|e| syntax(text, 0, &e))?;
    node(text, whole, DEEPEST)
}

fn node(source: &str, raw: &RawValue, depth: usize) -> Result<Node, Located> {
    let text = raw.get();
    let span = span_in(source, text);
    let inside = |e: serde_json::Error| syntax(source, span.start, &e);
    let Some(depth) = depth.checked_sub(1) else {
        return Err(Located { span, fault: Fault::TooDeep { deepest: DEEPEST } });
    };
    let value = match text.as_bytes().first() {
        Some(b'{') => {
            let members: Members = serde_json::from_str(text).map_err(inside)?;
            Value::Table(fields(source, members, depth)?)
        }
        Some(b'[') => {
            let items: Vec<&RawValue> = serde_json::from_str(text).map_err(inside)?;
            let items = items.into_iter().map(|item| node(source, item, depth));
            Value::List(items.collect::<Result<_, _>>()?)
        }
        Some(b'"') => Value::Text(serde_json::from_str(text).map_err(inside)?),
        Some(b't') => Value::Flag(true),
        Some(b'f') => Value::Flag(false),
        Some(b'n') => Value::Null,
        // The grammar of JSON's numbers is part of that of `f64`.
        _ => Value::Number(text.parse().unwrap_or(f64::NAN)),
    };
    Ok(Node { value, span })
}

fn fields(source: &str, members: Members<'_>, depth: usize) -> Result<Vec<Entry>, Located> {
    let mut entries: Vec<Entry> = Vec::new();
    for (Key(key), raw) in members.0 {
        let node = node(source, raw, depth)?;
        let key_span = match &key {
            Cow::Borrowed(key) => span_in(source, key),
            // A key with escapes has no bytes of its own in the text.
            Cow::Owned(_) => node.span.clone(),
        };
        if entries.iter().any(|entry| *entry.key == *key) {
            let fault = Fault::RepeatedField { name: key.into_owned() };
            return Err(Located { span: key_span, fault });
        }
        entries.push(Entry { key: key.into_owned(), key_span, node });
    }
    Ok(entries)
}

/// Where `part`, a slice of `source`, begins and ends in it.
fn span_in(source: &str, part: &str) -> Range<usize> {
    let start = part.as_ptr().addr() - source.as_ptr().addr();
    start..start + part.len()
}

/// The place of a syntax error in the text that begins at `start`.
fn syntax(source: &str, start: usize, error: &serde_json::Error) -> Located {
    let mut lines = source[start..].split_inclusive('\n');
    let before: usize = lines.by_ref().take(error.line().saturating_sub(1)).map(str::len).sum();
    let offset = start + before + error.column().saturating_sub(1);
    let end = source.len();
    let shown = error.to_string();
    // The position is shown apart, with the text around it.
    let message = shown.split(" at line ").next().unwrap_or(&shown).to_owned();
    let span = offset.min(end)..(offset + 1).min(end);
    Located { span, fault: Fault::Syntax { language: "JSON", message } }
}

#[derive(Deserialize)]
struct Key<'a>(#[serde(borrow)] Cow<'a, str>);

/// A table's fields in the order of the file, repeated ones included.
struct Members<'a>(Vec<(Key<'a>, &'a RawValue)>);

impl<'de: 'a, 'a> Deserialize<'de> for Members<'a> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(MembersVisitor).map(Members)
    }
}

struct MembersVisitor;

impl<'de> Visitor<'de> for MembersVisitor {
    type Value = Vec<(Key<'de>, &'de RawValue)>;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("a table")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut members = Vec::new();
        while let Some(member) = map.next_entry()? {
            members.push(member);
        }
        Ok(members)
    }
}
