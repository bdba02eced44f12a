//! Where an outline may not be touched.

use std::fmt;

use serde::de::value::{F64Deserializer, MapAccessDeserializer};
use serde::de::{Deserializer, Error, MapAccess, Visitor};
use serde::{Deserialize, Serialize};

use super::super::number::{Finite, Whole};

/// An edge, or a stretch of one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub(crate) enum Forbidden {
    Edge(Whole),
    Stretch(ForbiddenStretch),
}

/// A stretch along an edge, from its start [length].
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `edge`, `from` and `to`")]
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
        out.write_str("the number of an edge, or a table with `edge`, `from` and `to`")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Forbidden, E> {
        Whole::deserialize(F64Deserializer::new(value)).map(Forbidden::Edge)
    }

    fn visit_map<A: MapAccess<'de>>(self, fields: A) -> Result<Forbidden, A::Error> {
        let fields = MapAccessDeserializer::new(fields);
        ForbiddenStretch::deserialize(fields).map(Forbidden::Stretch)
    }
}
