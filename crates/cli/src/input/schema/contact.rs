//! What holds it: fingers with their laws.

use std::fmt;

use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error, MapAccess, Unexpected, Visitor};
use serde::{Deserialize, Serialize};

use super::super::number::{Coordinates, Finite, Whole};
use super::Tolerance;

/// A finger at its place.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table with `point` or `center`")]
pub(crate) struct Contact {
    pub(crate) point: Option<Coordinates>,
    /// The center of a round finger, instead of a point and a preload.
    pub(crate) center: Option<Coordinates>,
    pub(crate) inward_normal: Option<Coordinates>,
    pub(crate) edge: Option<Whole>,
    pub(crate) face: Option<Whole>,
    #[serde(default, deserialize_with = "law_of_table")]
    pub(crate) law: Option<Law>,
    pub(crate) preload: Option<Preload>,
    pub(crate) finger: Option<Finger>,
    pub(crate) tolerance: Option<Tolerance>,
}

/// The contact force at rest.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Preload {
    Force(Finite),
    /// What balances the loads and the other preloads.
    Balanced,
}

/// Force as a function of overlap.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub(crate) enum Law {
    /// `f = stiffness * delta`.
    Linear { stiffness: Finite },
    /// `f = coefficient * delta^exponent`.
    Power { coefficient: Finite, exponent: Finite },
    /// Hertz' law, by the effective modulus or by both materials.
    Hertz {
        effective_modulus: Option<Finite>,
        finger: Option<Material>,
        part: Option<Material>,
        /// Of a circular contact [length]; from the curvatures if left out.
        relative_radius: Option<Finite>,
    },
    /// A disc on an edge, in plane strain.
    Line { thickness: Finite, reference_depth: Finite, finger: Material, part: Material },
}

/// What a finger or a part is made of.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub(crate) enum Material {
    Named(String),
    Elastic(Constants),
}

/// Elastic constants in the units of the file.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `young` and `poisson`")]
pub(crate) struct Constants {
    /// Young's modulus [force / length^2].
    pub(crate) young: Finite,
    /// Poisson's ratio.
    pub(crate) poisson: Finite,
}

/// What touches the part: round, or curved differently in two directions.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `radius` or curvatures")]
pub(crate) struct Finger {
    /// 0 for a pointed finger, negative for a hollow one [length].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) radius: Option<Finite>,
    /// In the plane: 0 for a straight finger, negative for a hollow one [1 / length].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) curvature: Option<Finite>,
    /// In space: the first along `direction`, the second across it [1 / length].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) curvatures: Option<Vec<Finite>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) direction: Option<Coordinates>,
}

/// A law is a table; serde would take a list for one too, its items for the fields.
fn law_of_table<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Law>, D::Error> {
    deserializer.deserialize_any(LawVisitor).map(Some)
}

struct LawVisitor;

impl<'de> Visitor<'de> for LawVisitor {
    type Value = Law;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("a table with a `kind`: `linear`, `power`, `hertz` or `line`")
    }

    fn visit_map<A: MapAccess<'de>>(self, fields: A) -> Result<Law, A::Error> {
        Law::deserialize(MapAccessDeserializer::new(fields))
    }
}

impl<'de> Deserialize<'de> for Preload {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PreloadVisitor)
    }
}

struct PreloadVisitor;

impl Visitor<'_> for PreloadVisitor {
    type Value = Preload;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("a finite number, or \"balanced\"")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Preload, E> {
        if value.is_finite() {
            return Ok(Preload::Force(Finite(value)));
        }
        Err(E::invalid_value(Unexpected::Float(value), &self))
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<Preload, E> {
        match word {
            "balanced" => Ok(Preload::Balanced),
            _ => Err(E::invalid_value(Unexpected::Str(word), &self)),
        }
    }
}

impl<'de> Deserialize<'de> for Material {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(MaterialVisitor)
    }
}

struct MaterialVisitor;

impl<'de> Visitor<'de> for MaterialVisitor {
    type Value = Material;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("the name of a material, or a table with `young` and `poisson`")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<Material, E> {
        Ok(Material::Named(name.to_owned()))
    }

    fn visit_map<A: MapAccess<'de>>(self, fields: A) -> Result<Material, A::Error> {
        Constants::deserialize(MapAccessDeserializer::new(fields)).map(Material::Elastic)
    }
}
