//! The file schema, version 1: what a part file and a grasp file may say.

use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};

use super::node::Node;
use super::number::{Finite, Name, PerEdge, Point, Whole};
use super::place::{Place, Step};

/// The schema that this program reads.
pub(crate) const VERSION: u64 = 1;

/// The results of `optimize` at the top of its report: `analyze` reads the rest as a grasp file.
const RESULT_FIELDS: [&str; 20] = [
    "dimension",
    "fingers",
    "total_preload",
    "finger_radius",
    "quality",
    "sigma_min",
    "mu_eq",
    "limited_by",
    "center_of_compliance",
    "reach",
    "worst_point_stiffness",
    "worst_point",
    "worst_corner",
    "preload_margin",
    "quality_second_order",
    "quality_second_order_missing",
    "ties",
    "certificate",
    "combinations",
    "top",
];

/// The results at each contact of such a report.
const CONTACT_RESULT_FIELDS: [&str; 1] = ["share"];

/// Only reports of `optimize` have all of these.
const MARKS_OF_A_REPORT: [&str; 2] = ["certificate", "combinations"];

/// A part, and for a grasp its contacts.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table with `part`")]
pub(crate) struct File {
    pub(crate) version: Option<Whole>,
    #[serde(default)]
    pub(crate) units: Units,
    pub(crate) part: Part,
    #[serde(default)]
    pub(crate) contacts: Vec<Contact>,
}

/// The names of the units that all numbers of a file are in.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `length` and `force`")]
pub(crate) struct Units {
    pub(crate) length: Name,
    pub(crate) force: Name,
}

/// A file that names no units has one of length and one of force all the same.
impl Default for Units {
    fn default() -> Self {
        Self { length: Name("L".to_owned()), force: Name("F".to_owned()) }
    }
}

/// What is held.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `planar`")]
pub(crate) struct Part {
    pub(crate) planar: Option<Planar>,
    /// Known, so that the message can say that it is for a later version.
    #[serde(skip_serializing)]
    pub(crate) spatial: Option<IgnoredAny>,
}

/// A planar part.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `outline` and `stiffness`")]
pub(crate) struct Planar {
    /// The corners, either way round.
    pub(crate) outline: Vec<Point>,
    /// Of a contact on each edge [force / length].
    pub(crate) stiffness: PerEdge,
}

/// A finger at its place.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table with `point`")]
pub(crate) struct Contact {
    pub(crate) point: Point,
    pub(crate) inward_normal: Option<Point>,
    pub(crate) edge: Option<Whole>,
    pub(crate) law: Option<Law>,
    pub(crate) preload: Option<Finite>,
    pub(crate) finger: Option<Finger>,
}

/// Force as a function of overlap.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
#[serde(expecting = "a table with a `kind`, `linear` or `power`")]
pub(crate) enum Law {
    /// `f = stiffness * delta`.
    Linear { stiffness: Finite },
    /// `f = coefficient * delta^exponent`.
    Power { coefficient: Finite, exponent: Finite },
}

/// What touches the part.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table with `radius`")]
pub(crate) struct Finger {
    /// 0 for a pointed finger [length].
    pub(crate) radius: Finite,
}

/// The file without its results, if it is a report of `optimize`; any other file as it is, so
/// that none of its fields is overlooked.
pub(super) fn without_results(mut root: Node) -> Node {
    if MARKS_OF_A_REPORT.iter().all(|name| root.field(name).is_some()) {
        root.remove(&RESULT_FIELDS);
        for contact in root.items_of_field("contacts") {
            contact.remove(&CONTACT_RESULT_FIELDS);
        }
    }
    root
}

/// Where to put what is at `place` by mistake.
pub(super) fn help(place: &Place) -> Option<&'static str> {
    let [Step::Field(name)] = place.steps() else { return None };
    match name.as_str() {
        "finger_radius" => Some(
            "give `finger = { radius = .. }` in each contact, or --finger-radius to `optimize`",
        ),
        "total_preload" => Some("give `preload` in each contact, or --preload to `optimize`"),
        "fingers" => Some("give --fingers to `optimize`"),
        _ => None,
    }
}

/// What is expected of the field `name` of the table at `place`.
pub(super) fn expected(place: &Place, name: &str) -> &'static str {
    let planar = *place == Place::planar();
    match name {
        "part" => "a table with `planar`",
        "outline" => "a list of corners [x, y]",
        "stiffness" if planar => "a positive number, or a list of one per edge",
        "stiffness" | "coefficient" | "exponent" => "a positive number",
        "radius" => "a number, zero or more",
        "point" => "two numbers [x, y]",
        "kind" => "`linear` or `power`",
        _ => "the name of a unit, such as \"mm\"",
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on fails")]

    use std::collections::BTreeSet;

    use clap::Parser;

    use super::{CONTACT_RESULT_FIELDS, RESULT_FIELDS};
    use crate::arguments::{Arguments, Command};

    const PART: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../parts/quadrilateral.toml");

    fn report(preload: &str) -> serde_json::Value {
        let arguments = ["clench", "optimize", PART, "--fingers", "4", "--top", "2"];
        let arguments = arguments.into_iter().chain(["--format", "json", "--preload", preload]);
        let Command::Optimize(arguments) = Arguments::parse_from(arguments).command else {
            panic!("another command than `optimize`")
        };
        serde_json::from_str(&crate::optimize::optimize(&arguments).unwrap().report).unwrap()
    }

    fn keys(table: &serde_json::Value) -> BTreeSet<String> {
        table.as_object().unwrap().keys().cloned().collect()
    }

    /// A preload so large that its overlaps push the part away leaves no quality to second order.
    #[test]
    fn the_result_fields_are_those_of_a_report() {
        let reports = [report("0.1"), report("1000")];
        let mut found: BTreeSet<String> = reports.iter().flat_map(keys).collect();
        for read in ["version", "units", "part", "contacts"] {
            assert!(found.remove(read), "{read}");
        }
        assert_eq!(found, RESULT_FIELDS.map(str::to_owned).into());
        let mut found = keys(&reports[0]["contacts"][0]);
        for read in ["point", "inward_normal", "edge", "law", "preload", "finger"] {
            assert!(found.remove(read), "{read}");
        }
        assert_eq!(found, CONTACT_RESULT_FIELDS.map(str::to_owned).into());
    }
}
