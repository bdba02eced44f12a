//! The scalars of the schema, each with words for what is expected of it.

use std::collections::BTreeMap;
use std::fmt;

use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Unexpected, Visitor};
use serde::{Deserialize, Serialize, Serializer};

/// Whole numbers up to here are exact as doubles.
const LARGEST_WHOLE: f64 = 9_007_199_254_740_992.0;

/// A finite number.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Finite(pub(crate) f64);

/// A number of something: a version, an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Whole(pub(crate) u64);

impl Whole {
    /// The number, if it is whole and a double has all of its digits.
    pub(crate) fn exactly(value: f64) -> Option<Self> {
        let exact = (0.0..=LARGEST_WHOLE).contains(&value) && value.fract() <= 0.0;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number that a double holds exactly"
        )]
        exact.then_some(Self(value as u64))
    }
}

/// The name of a unit: it goes into reports as it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Name(pub(crate) String);

/// What the user calls something: it goes into reports as it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Label(pub(crate) String);

/// The path of another file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct FileName(pub(crate) String);

/// A point or a direction of the plane (`N` = 2) or of space (`N` = 3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Point<const N: usize>(pub(crate) [f64; N]);

/// A point or a direction of the plane or of space: which of them, the part says.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Coordinates(pub(crate) Vec<f64>);

/// A torque: one number in the plane, three in space; which of them, the part says.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Torque(pub(crate) Vec<f64>);

/// One number for all edges or faces, or one for each.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub(crate) enum PerPiece {
    All(Finite),
    Each(Vec<Finite>),
    /// One for each layer of a drawing.
    ByLayer(BTreeMap<String, Finite>),
}

impl PerPiece {
    /// The number of each of `pieces` edges or faces.
    pub(crate) fn each(&self, pieces: usize) -> Vec<f64> {
        match self {
            Self::All(value) => vec![value.0; pieces],
            Self::Each(values) => values.iter().map(|value| value.0).collect(),
            // Without a drawing there are no layers, and none of them has an edge.
            Self::ByLayer(_) => Vec::new(),
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
        Whole::exactly(value).ok_or_else(|| E::invalid_value(Unexpected::Float(value), &self))
    }
}

impl fmt::Display for Name {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}

impl<'de> Deserialize<'de> for Name {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let expected = "the name of a unit, such as \"mm\"";
        deserializer.deserialize_str(WordsVisitor { expected }).map(Self)
    }
}

impl<'de> Deserialize<'de> for Label {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let expected = "a name, of at least one letter and on one line";
        deserializer.deserialize_str(WordsVisitor { expected }).map(Self)
    }
}

/// Text that can stand in a line of a report.
struct WordsVisitor {
    expected: &'static str,
}

impl Visitor<'_> for WordsVisitor {
    type Value = String;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.expected)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<String, E> {
        if text.trim().is_empty() || text.contains(char::is_control) {
            return Err(E::invalid_value(Unexpected::Str(text), &self));
        }
        Ok(text.to_owned())
    }
}

impl<'de> Deserialize<'de> for FileName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(FileNameVisitor)
    }
}

struct FileNameVisitor;

impl Visitor<'_> for FileNameVisitor {
    type Value = FileName;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("the name of a file, such as \"part.stl\"")
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<FileName, E> {
        Ok(FileName(text.to_owned()))
    }
}

impl<'de, const N: usize> Deserialize<'de> for Point<N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let numbers = deserializer.deserialize_seq(NumbersVisitor { counts: &[N] })?;
        numbers.try_into().map(Point).map_err(|_| D::Error::custom(in_words(&[N])))
    }
}

impl<const N: usize> Serialize for Point<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.as_slice().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Coordinates {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(NumbersVisitor { counts: &[2, 3] }).map(Coordinates)
    }
}

/// As many coordinates as one of `counts`.
struct NumbersVisitor {
    counts: &'static [usize],
}

impl<'de> Visitor<'de> for NumbersVisitor {
    type Value = Vec<f64>;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(in_words(self.counts))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Vec<f64>, A::Error> {
        let mut numbers = Vec::with_capacity(3);
        while let Some(Finite(number)) = items.next_element()? {
            numbers.push(number);
        }
        if self.counts.contains(&numbers.len()) {
            return Ok(numbers);
        }
        Err(A::Error::invalid_length(numbers.len(), &self))
    }
}

/// Coordinates of these numbers, as messages call them.
pub(super) fn in_words(counts: &[usize]) -> &'static str {
    match counts {
        [2] => "two numbers [x, y]",
        [3] => "three numbers [x, y, z]",
        _ => "two numbers [x, y], or three numbers [x, y, z]",
    }
}

impl<'de> Deserialize<'de> for Torque {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(TorqueVisitor).map(Torque)
    }
}

struct TorqueVisitor;

impl<'de> Visitor<'de> for TorqueVisitor {
    type Value = Vec<f64>;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("a finite number, or three numbers [x, y, z]")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Vec<f64>, E> {
        FiniteVisitor.visit_f64(value).map(|torque| vec![torque.0])
    }

    fn visit_seq<A: SeqAccess<'de>>(self, items: A) -> Result<Vec<f64>, A::Error> {
        NumbersVisitor { counts: &[3] }.visit_seq(items)
    }
}

impl<'de> Deserialize<'de> for PerPiece {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PerPieceVisitor)
    }
}

struct PerPieceVisitor;

impl<'de> Visitor<'de> for PerPieceVisitor {
    type Value = PerPiece;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("a finite number, or a list of one per edge or face")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<PerPiece, A::Error> {
        let mut layers = BTreeMap::new();
        while let Some((layer, number)) = entries.next_entry()? {
            layers.insert(layer, number);
        }
        Ok(PerPiece::ByLayer(layers))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<PerPiece, E> {
        FiniteVisitor.visit_f64(value).map(PerPiece::All)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<PerPiece, A::Error> {
        let mut numbers = Vec::new();
        while let Some(number) = items.next_element()? {
            numbers.push(number);
        }
        Ok(PerPiece::Each(numbers))
    }
}
