//! Parts that are a drawing or a mesh alone, without a part file.

use std::collections::BTreeMap;
use std::path::Path;

use super::document::Document;
use super::number::{FileName, Finite, Label, Name, PerPiece};
use super::schema::{self, File, Part, Planar, Spatial, Units};
use crate::failure::Failure;

/// The force unit of numbers whose unit of length alone is named.
pub(crate) const FORCE: &str = "N";

/// What the command line says of such a part.
#[derive(Clone, Debug, Default)]
pub(crate) struct Alone {
    pub(crate) stiffness: Vec<LayerStiffness>,
    pub(crate) units: Option<Units>,
    /// Only the curves on these.
    pub(crate) layers: Vec<String>,
}

/// The stiffness of contacts, everywhere or on one layer.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LayerStiffness {
    pub(crate) layer: Option<String>,
    pub(crate) stiffness: Finite,
}

/// The part file at `path`; a drawing or a mesh is as good as one, with what `alone` says.
pub(crate) fn part_file(path: &Path, alone: &Alone) -> Result<(Document, File), Failure> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let planar = match ending.as_deref() {
        Some("dxf" | "svg") => true,
        Some("stl" | "obj") => false,
        _ => {
            check_unsaid(alone)?;
            return Document::read(path);
        }
    };
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let stiffness = stiffness(alone, planar)?;
    let layers: Vec<Label> = alone.layers.iter().cloned().map(Label).collect();
    let part = if planar {
        let drawing = Some(FileName(name));
        let planar = Planar { drawing, layers, stiffness, ..Planar::default() };
        Part { planar: Some(planar), spatial: None }
    } else {
        if !layers.is_empty() {
            return Err(Failure::DrawingOption { option: "--layer" });
        }
        let spatial = Spatial { mesh: Some(FileName(name)), stiffness, ..Spatial::default() };
        Part { planar: None, spatial: Some(spatial) }
    };
    let default = Units { force: Name(FORCE.to_owned()), ..Units::default() };
    let units = match (&alone.units, planar) {
        (Some(units), _) => units.clone(),
        (None, true) => default,
        (None, false) => Units::default(),
    };
    Ok((Document::of_part_alone(path), File::of_part(part, units)))
}

/// The stiffness of all edges or faces, or by their layers.
fn stiffness(alone: &Alone, planar: bool) -> Result<Option<PerPiece>, Failure> {
    match &alone.stiffness[..] {
        [] if planar => Err(Failure::NoStiffness),
        [] => Ok(None),
        [LayerStiffness { layer: None, stiffness }] => Ok(Some(PerPiece::All(*stiffness))),
        several => {
            let mut layers: BTreeMap<String, Finite> = BTreeMap::new();
            for LayerStiffness { layer, stiffness } in several {
                let Some(layer) = layer.clone().filter(|_| planar) else {
                    return Err(Failure::StiffnessTwice);
                };
                if let Some(other) = layers.keys().find(|other| other.eq_ignore_ascii_case(&layer))
                {
                    return Err(Failure::LayerTwice { layers: [other.clone(), layer] });
                }
                layers.insert(layer, *stiffness);
            }
            Ok(Some(PerPiece::ByLayer(layers)))
        }
    }
}

/// Checks that nothing is said that a part file says itself.
fn check_unsaid(alone: &Alone) -> Result<(), Failure> {
    let said = [
        ("--stiffness", !alone.stiffness.is_empty()),
        ("--units", alone.units.is_some()),
        ("--layer", !alone.layers.is_empty()),
    ];
    match said.into_iter().find(|(_, said)| *said) {
        Some((option, _)) => Err(Failure::AloneOption { option }),
        None => Ok(()),
    }
}

impl schema::File {
    /// A file with a part and nothing else.
    fn of_part(part: Part, units: Units) -> Self {
        Self {
            version: None,
            units,
            part,
            contacts: Vec::new(),
            loads: Vec::new(),
            points: Vec::new(),
            load_cases: Vec::new(),
            contact_tolerances: None,
        }
    }
}
