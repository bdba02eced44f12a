//! Where an outline may not be touched.

use std::fmt;

use serde::de::value::{F64Deserializer, MapAccessDeserializer};
use serde::de::{Deserializer, Error, MapAccess, Visitor};
use serde::{Deserialize, Serialize};

use super::super::number::{Finite, Label, Whole};

/// An edge, a stretch of one, or all edges on a layer of a drawing.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub(crate) enum Forbidden {
    Edge(Whole),
    Stretch(ForbiddenStretch),
    Layer(ForbiddenLayer),
}

/// The edges on a layer of a drawing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct ForbiddenLayer {
    pub(crate) layer: Label,
}

/// A table in a list of what is forbidden.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table with `edge`, `from` and `to`, or with `layer`")]
struct Fields {
    edge: Option<Whole>,
    from: Option<Finite>,
    to: Option<Finite>,
    layer: Option<Label>,
}

/// A stretch along an edge, from its start [length].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct ForbiddenStretch {
    pub(crate) edge: Whole,
    pub(crate) from: Finite,
    pub(crate) to: Finite,
}

/// As `--forbid` takes it.
impl fmt::Display for Forbidden {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Edge(edge) => write!(out, "{}", edge.0),
            Self::Stretch(ForbiddenStretch { edge, from, to }) => {
                write!(out, "{}:{}-{}", edge.0, from.0, to.0)
            }
            Self::Layer(ForbiddenLayer { layer }) => write!(out, "layer:{}", layer.0),
        }
    }
}

impl<'de> Deserialize<'de> for Forbidden {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ForbiddenVisitor)
    }
}

struct ForbiddenVisitor;

impl<'de> Visitor<'de> for ForbiddenVisitor {
    type Value = Forbidden;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(
            "the number of an edge, or a table with `edge`, `from` and `to`, or with `layer`",
        )
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Forbidden, E> {
        Whole::deserialize(F64Deserializer::new(value)).map(Forbidden::Edge)
    }

    fn visit_map<A: MapAccess<'de>>(self, fields: A) -> Result<Forbidden, A::Error> {
        let missing = A::Error::missing_field;
        match Fields::deserialize(MapAccessDeserializer::new(fields))? {
            Fields { edge: None, from: None, to: None, layer: Some(layer) } => {
                Ok(Forbidden::Layer(ForbiddenLayer { layer }))
            }
            Fields { layer: Some(_), .. } => Err(A::Error::custom(
                "found a `layer` beside a stretch of an edge, expected one of them",
            )),
            Fields { edge, from, to, layer: None } => Ok(Forbidden::Stretch(ForbiddenStretch {
                edge: edge.ok_or_else(|| missing("edge"))?,
                from: from.ok_or_else(|| missing("from"))?,
                to: to.ok_or_else(|| missing("to"))?,
            })),
        }
    }
}
