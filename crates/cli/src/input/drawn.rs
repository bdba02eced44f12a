//! Parts from drawings: what a drawing says takes its place in the part of the file.

use std::path::{Path, PathBuf};

use clench::drawing::{DrawingError, DrawnPart, Sheet, Unit};
use clench::shape::Polygon;

use super::document::Document;
use super::fault::{DrawingFault, PartFault};
use super::number::{Finite, Label, Name, PerPiece, Point, Whole};
use super::place::Place;
use super::schema::{self, File, Forbidden, Planar};
use super::shield::shielded;
use crate::failure::Failure;

/// A drawing that a part is from.
#[derive(Debug)]
pub(crate) struct Drawn {
    /// As the file names it.
    pub(crate) name: String,
    pub(crate) path: PathBuf,
    /// The unit of the drawing, if it names one, and what its lengths were multiplied with.
    pub(crate) unit: Option<Unit>,
    pub(crate) scale: f64,
    pub(crate) part: DrawnPart,
}

/// What the command line says of a drawing.
#[derive(Clone, Debug, Default)]
pub(crate) struct Asked {
    pub(crate) chord: Option<f64>,
    /// More than the file forbids; only layers count.
    pub(crate) forbidden: Vec<Forbidden>,
}

/// Puts the outline of the part's drawing, if it has one, into the file: its corners, the stiffness
/// of each edge, and edges for layers that are forbidden.
pub(crate) fn drawn(
    document: &Document,
    file: &mut File,
    asked: &Asked,
) -> Result<Option<Drawn>, Failure> {
    let planar = file.part.planar.as_mut();
    let Some((planar, name)) = planar.and_then(|p| p.drawing.take().map(|name| (p, name.0))) else {
        check_not_drawn(document, file, asked)?;
        return Ok(None);
    };
    check_alone(document, planar)?;
    let path = document.folder().join(&name);
    let chord = asked.chord.or(planar.chord.take().map(|chord| chord.0));
    let layers = std::mem::take(&mut planar.layers);
    let read = read(&path, &layers, &mut file.units, chord);
    let (unit, scale, part) = read.map_err(|fault| {
        let is_chord = matches!(fault, DrawingFault::Drawing(DrawingError::Chord { .. }));
        let at = Place::planar().field(if is_chord { "chord" } else { "drawing" });
        document.error(&at, PartFault::Drawing { name: name.clone(), fault: Box::new(fault) })
    })?;
    let mut contours = contours(part.polygon());
    planar.outline = contours.next();
    planar.holes = contours.collect();
    planar.stiffness = stiffness(document, planar.stiffness.take(), &part)?;
    planar.forbidden.extend(asked.forbidden.iter().cloned());
    planar.forbidden = forbidden(document, &planar.forbidden, &part)?;
    Ok(Some(Drawn { name, path, unit, scale, part }))
}

/// The drawing's unit, what its lengths are multiplied with to be in the `wanted` units, and the
/// part on it.
fn read(
    path: &Path,
    layers: &[Label],
    wanted: &mut schema::Units,
    chord: Option<f64>,
) -> Result<(Option<Unit>, f64, DrawnPart), DrawingFault> {
    let layers: Vec<&str> = layers.iter().map(|layer| layer.0.as_str()).collect();
    let sheet = shielded(|| Sheet::read(path, &layers)).ok_or(DrawingFault::Panicked)??;
    let scale = scale(sheet.unit(), wanted)?;
    Ok((sheet.unit(), scale, sheet.part(scale, chord)?))
}

/// The corners of the outline, then those of each hole.
fn contours(polygon: &Polygon) -> impl Iterator<Item = Vec<Point<2>>> {
    let corners = polygon.corners();
    polygon
        .loops()
        .iter()
        .map(|run| corners[run.clone()].iter().map(|corner| Point(corner.to_array())).collect())
}

/// What a length of the drawing has to be multiplied with; a file without a unit gets that of the
/// drawing.
fn scale(unit: Option<Unit>, wanted: &mut schema::Units) -> Result<f64, DrawingFault> {
    let named = wanted.length != schema::Units::default().length;
    match unit {
        None if named => Ok(1.0),
        None => Err(DrawingFault::NoUnit),
        Some(unit) if !named => {
            wanted.length = Name(unit.name().to_owned());
            Ok(1.0)
        }
        Some(unit) => {
            let wanted = &wanted.length.0;
            let size = Unit::named(wanted).ok_or_else(|| DrawingFault::UnknownUnit {
                found: unit.name(),
                wanted: wanted.clone(),
            })?;
            Ok(unit.micrometers() / size.micrometers())
        }
    }
}

/// The stiffness of each edge by that of its layer.
fn stiffness(
    document: &Document,
    given: Option<PerPiece>,
    part: &DrawnPart,
) -> Result<Option<PerPiece>, Failure> {
    let Some(PerPiece::ByLayer(layers)) = given else { return Ok(given) };
    let place = || Place::planar().field("stiffness");
    let fault = |place: &Place, fault| document.error(place, PartFault::Layer(Box::new(fault)));
    let names: Vec<&String> = layers.keys().collect();
    for (i, layer) in names.iter().enumerate() {
        if let Some(other) = names[..i].iter().find(|other| other.eq_ignore_ascii_case(layer)) {
            let layers = [*other, *layer].map(String::clone);
            return Err(fault(&place().field(layer), DrawingFault::LayerTwice { layers }));
        }
    }
    for (layer, value) in &layers {
        super::part::checked_stiffness(document, &place().field(layer), value.0)?;
        if part.edges_on(layer).next().is_none() {
            let layer = layer.clone();
            return Err(fault(&place().field(&layer), DrawingFault::NoEdgeOnLayer { layer }));
        }
    }
    let of_layer = |layer: &str| {
        let found = layers.iter().find(|(name, _)| name.eq_ignore_ascii_case(layer));
        found
            .map(|(_, value)| *value)
            .ok_or_else(|| fault(&place(), DrawingFault::NoStiffness { layer: layer.to_owned() }))
    };
    let each: Result<Vec<Finite>, _> =
        part.edge_sources().map(|source| of_layer(&source.layer)).collect();
    each.map(|each| Some(PerPiece::Each(each)))
}

/// The same list with edges in place of layers.
fn forbidden(
    document: &Document,
    given: &[Forbidden],
    part: &DrawnPart,
) -> Result<Vec<Forbidden>, Failure> {
    let mut forbidden = Vec::new();
    for (i, given) in given.iter().enumerate() {
        let Forbidden::Layer(schema::ForbiddenLayer { layer }) = given else {
            forbidden.push(given.clone());
            continue;
        };
        let before = forbidden.len();
        let edges = part.edges_on(&layer.0).map(|edge| Forbidden::Edge(Whole(edge as u64)));
        forbidden.extend(edges);
        if forbidden.len() == before {
            let fault = DrawingFault::NoEdgeOnLayer { layer: layer.0.clone() };
            let place = Place::planar().field("forbidden").item(i);
            return Err(document.error(&place, PartFault::Layer(Box::new(fault))));
        }
    }
    Ok(forbidden)
}

/// Checks that a part with a drawing has no other shape.
fn check_alone(document: &Document, planar: &Planar) -> Result<(), Failure> {
    let Planar { outline, ellipse, holes, .. } = planar;
    if outline.is_none() && ellipse.is_none() && holes.is_empty() {
        return Ok(());
    }
    let found = "a `drawing` and another shape";
    Err(document.error(&Place::planar(), PartFault::PlanarShape { found }))
}

/// Checks that nothing is said of a drawing where there is none.
fn check_not_drawn(document: &Document, file: &File, asked: &Asked) -> Result<(), Failure> {
    let only = |name, found| {
        Err(document.error(&Place::planar().field(name), PartFault::DrawingOnly { found }))
    };
    if asked.chord.is_some() {
        return Err(Failure::DrawingOption { option: "--chord" });
    }
    if asked.forbidden.iter().any(is_layer) {
        return Err(Failure::DrawingOption { option: "--forbid layer:NAME" });
    }
    let Some(planar) = &file.part.planar else { return Ok(()) };
    match planar {
        Planar { chord: Some(_), .. } => only("chord", "a `chord`"),
        Planar { layers, .. } if !layers.is_empty() => only("layers", "`layers`"),
        Planar { stiffness: Some(PerPiece::ByLayer(_)), .. } => {
            only("stiffness", "a stiffness for each layer")
        }
        Planar { forbidden, .. } if forbidden.iter().any(is_layer) => {
            only("forbidden", "a forbidden `layer`")
        }
        _ => Ok(()),
    }
}

const fn is_layer(forbidden: &Forbidden) -> bool {
    matches!(forbidden, Forbidden::Layer(_))
}
