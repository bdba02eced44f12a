//! The tables of a DXF file that say what is visible: layers and line types.

use std::collections::HashMap;

use super::pairs::{Record, Value};

/// A layer is frozen by this flag.
const FROZEN: i64 = 1;

/// What never comes on paper, whatever the table of layers says.
const NEVER_PLOTTED: &str = "DEFPOINTS";

/// The line type without gaps, which every file has.
pub(super) const CONTINUOUS: &str = "CONTINUOUS";

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
    frozen: bool,
    /// Frozen, off or not plotted.
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
                    let frozen = record.flags(70) & FROZEN != 0;
                    let hidden = frozen || record.flags(62) < 0 || record.text(290) == Some("0");
                    let line_type = record.text(6);
                    tables.layers.insert(name, Layer { frozen, hidden, line_type });
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
        layer.eq_ignore_ascii_case(NEVER_PLOTTED)
            || self.layer(layer).is_some_and(|layer| layer.hidden)
    }

    /// Whether a layer is frozen: a block that is put on it is not drawn at all.
    pub(super) fn freezes(&self, layer: &str) -> bool {
        self.layer(layer).is_some_and(|layer| layer.frozen)
    }

    /// The line type of an entity by the one that it names: that of its layer, unless it says
    /// otherwise, or that of its block's place.
    pub(super) fn line_type(&self, named: Option<&'a str>, layer: &str, place: &'a str) -> &'a str {
        match named {
            Some(name) if name.eq_ignore_ascii_case("BYBLOCK") => place,
            Some(name) if !name.eq_ignore_ascii_case("BYLAYER") => name,
            _ => self.layer(layer).and_then(|layer| layer.line_type).unwrap_or(CONTINUOUS),
        }
    }

    /// Whether a line of this type has gaps.
    pub(super) fn is_broken(&self, line_type: &str) -> bool {
        let name = line_type.to_ascii_uppercase();
        // A type that the file does not describe is what its name says.
        let gaps = || !matches!(name.as_str(), "" | CONTINUOUS | "BYLAYER" | "BYBLOCK");
        self.line_types.get(&name).copied().unwrap_or_else(gaps)
    }

    fn layer(&self, name: &str) -> Option<&Layer<'a>> {
        self.layers.get(&name.to_ascii_uppercase())
    }
}
