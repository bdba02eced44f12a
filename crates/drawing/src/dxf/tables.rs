//! The tables of a DXF file that say what is visible: layers and line types.

use std::collections::HashMap;

use super::pairs::{Record, Value};

/// A layer is frozen by this flag.
const FROZEN: i64 = 1;

/// What never comes on paper, whatever the table of layers says.
const NEVER_PLOTTED: &str = "DEFPOINTS";

/// What the tables and the head of a file say of its entities.
#[derive(Debug, Default)]
pub(super) struct Tables<'a> {
    layers: HashMap<String, Layer<'a>>,
    /// Whether the line type has gaps.
    line_types: HashMap<String, bool>,
    /// The number of the unit of length, if there is one.
    pub(super) unit: Option<Value<'a>>,
}

#[derive(Debug)]
struct Layer<'a> {
    hidden: bool,
    line_type: Option<&'a str>,
}

impl<'a> Tables<'a> {
    pub(super) fn of(records: &[Record<'a>]) -> Self {
        let mut tables = Self::default();
        for record in records {
            let name = record.text(2).unwrap_or("").to_ascii_uppercase();
            match record.kind {
                "SECTION" => {
                    if let Some(unit) = record.variable("$INSUNITS", 70) {
                        tables.unit = Some(unit);
                    }
                }
                "LAYER" => {
                    let hidden = record.flags(70) & FROZEN != 0
                        || record.flags(62) < 0
                        || record.text(290) == Some("0");
                    tables.layers.insert(name, Layer { hidden, line_type: record.text(6) });
                }
                "LTYPE" => {
                    let gaps = record.flags(73) > 0 || record.text(49).is_some();
                    tables.line_types.insert(name, gaps);
                }
                _ => {}
            }
        }
        tables
    }

    /// Whether what is on a layer is not seen, or not plotted.
    pub(super) fn hides(&self, layer: &str) -> bool {
        let layer = layer.to_ascii_uppercase();
        layer == NEVER_PLOTTED || self.layers.get(&layer).is_some_and(|layer| layer.hidden)
    }

    /// Whether a line of this type, or of that of its layer, has gaps.
    pub(super) fn is_broken(&self, line_type: Option<&str>, layer: &str) -> bool {
        let by_layer = line_type.is_none_or(|name| name.eq_ignore_ascii_case("BYLAYER"));
        let name = if by_layer {
            self.layers.get(&layer.to_ascii_uppercase()).and_then(|layer| layer.line_type)
        } else {
            line_type
        };
        let name = name.unwrap_or("CONTINUOUS").to_ascii_uppercase();
        // A type that the file does not describe is what its name says.
        let gaps = || !matches!(name.as_str(), "" | "CONTINUOUS" | "BYLAYER" | "BYBLOCK");
        self.line_types.get(&name).copied().unwrap_or_else(gaps)
    }
}
