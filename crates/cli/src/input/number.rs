//! The scalars of the schema, each with words for what is expected of it.

use std::fmt;

use serde::de::{Deserializer, Error, SeqAccess, Unexpected, Visitor};
use serde::{Deserialize, Serialize};

/// Whole numbers up to here are exact as doubles.
const LARGEST_WHOLE: f64 = 9_007_199_254_740_992.0;

/// A finite number.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Finite(pub(crate) f64);

/// A number of something: a version, an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Whole(pub(crate) u64);

/// The name of a unit: it goes into reports as it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Name(pub(crate) String);

/// A point or a direction of the plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Point(pub(crate) [f64; 2]);

/// One number for all edges, or one for each.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub(crate) enum PerEdge {
    All(Finite),
    Each(Vec<Finite>),
}

impl PerEdge {
    /// The number of each of `edges` edges.
    pub(crate) fn each(&self, edges: usize) -> Vec<f64> {
        match self {
            Self::All(value) => vec![value.0; edges],
            Self::Each(values) => values.iter().map(|value| value.0).collect(),
        }
    }
}

impl<'de> Deserialize<'de> for Finite {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_f64(FiniteVisitor)
    }
}

struct FiniteVisitor;

impl Visitor<'_> for FiniteVisitor {
    type Value = Finite;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("a finite number")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Finite, E> {
        if value.is_finite() {
            return Ok(Finite(value));
        }
        Err(E::invalid_value(Unexpected::Float(value), &self))
    }
}

impl<'de> Deserialize<'de> for Whole {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_u64(WholeVisitor)
    }
}

struct WholeVisitor;

impl Visitor<'_> for WholeVisitor {
    type Value = Whole;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("a whole number, zero or more")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Whole, E> {
        let exact = (0.0..=LARGEST_WHOLE).contains(&value) && value.fract() <= 0.0;
        if !exact {
            return Err(E::invalid_value(Unexpected::Float(value), &self));
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number that a double holds exactly"
        )]
        Ok(Whole(value as u64))
    }
}

impl fmt::Display for Name {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}

impl<'de> Deserialize<'de> for Name {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(NameVisitor)
    }
}

struct NameVisitor;

impl Visitor<'_> for NameVisitor {
    type Value = Name;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("the name of a unit, such as \"mm\"")
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Name, E> {
        if text.trim().is_empty() || text.contains(char::is_control) {
            return Err(E::invalid_value(Unexpected::Str(text), &self));
        }
        Ok(Name(text.to_owned()))
    }
}

impl<'de> Deserialize<'de> for Point {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(PointVisitor)
    }
}

struct PointVisitor;

impl<'de> Visitor<'de> for PointVisitor {
    type Value = Point;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("two numbers [x, y]")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Point, A::Error> {
        let mut numbers = Vec::with_capacity(2);
        while let Some(Finite(number)) = items.next_element()? {
            numbers.push(number);
        }
        let count = numbers.len();
        numbers.try_into().map(Point).map_err(|_| A::Error::invalid_length(count, &self))
    }
}

impl<'de> Deserialize<'de> for PerEdge {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PerEdgeVisitor)
    }
}

struct PerEdgeVisitor;

impl<'de> Visitor<'de> for PerEdgeVisitor {
    type Value = PerEdge;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("a finite number, or a list of one per edge")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<PerEdge, E> {
        FiniteVisitor.visit_f64(value).map(PerEdge::All)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<PerEdge, A::Error> {
        let mut numbers = Vec::new();
        while let Some(number) = items.next_element()? {
            numbers.push(number);
        }
        Ok(PerEdge::Each(numbers))
    }
}
