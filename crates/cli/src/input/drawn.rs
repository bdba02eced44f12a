//! Parts from drawings: what a drawing says takes its place in the part of the file.

use std::path::PathBuf;

use clench::shape::Polygon;

use super::document::Document;
use super::drawing::{self, Drawing, DrawingFault, Reading, Unit, Unjoined};
use super::fault::PartFault;
use super::number::{Finite, Name, PerPiece, Point, Whole};
use super::place::Place;
use super::schema::{self, File, Forbidden, Planar};
use super::units;
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
    pub(crate) drawing: Drawing,
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
    let at = Place::planar().field("drawing");
    let fault = |fault| {
        document.error(&at, PartFault::Drawing { name: name.clone(), fault: Box::new(fault) })
    };
    let path = document.folder().join(&name);
    let chord = chord(document, planar, asked)?;
    let layers: Vec<String> =
        std::mem::take(&mut planar.layers).into_iter().map(|layer| layer.0).collect();
    let unjoined = drawing::read(&path, &layers).map_err(&fault)?;
    let unit = unjoined.unit();
    let scale = scale(unit, &mut file.units).map_err(&fault)?;
    let drawing = part_of(unjoined, scale, &Reading { chord }).map_err(&fault)?;
    let points = |corners: &Vec<[f64; 2]>| corners.iter().map(|c| Point(*c)).collect();
    let mut contours = drawing.contours.iter().map(points);
    planar.outline = contours.next();
    planar.holes = contours.collect();
    planar.stiffness = stiffness(document, planar.stiffness.take(), &drawing)?;
    planar.forbidden.extend(asked.forbidden.iter().cloned());
    planar.forbidden = forbidden(document, &planar.forbidden, &drawing)?;
    Ok(Some(Drawn { name, path, unit, scale, drawing }))
}

/// The part of a drawing, which is a valid outline.
fn part_of(unjoined: Unjoined, scale: f64, reading: &Reading) -> Result<Drawing, DrawingFault> {
    let drawing = unjoined.drawing(scale, reading)?;
    let [outline, holes @ ..] = &drawing.contours[..] else { return Err(DrawingFault::NoCurves) };
    match Polygon::with_holes(outline, holes) {
        Ok(_) => Ok(drawing),
        Err(error) => Err(drawing.fault(error)),
    }
}

/// What a length of the drawing has to be multiplied with; a file without a unit gets that of the
/// drawing.
fn scale(unit: Option<Unit>, wanted: &mut schema::Units) -> Result<f64, DrawingFault> {
    let named = wanted.length != schema::Units::default().length;
    match unit {
        None if named => Ok(1.0),
        None => Err(DrawingFault::NoUnit),
        Some(unit) if !named => {
            wanted.length = Name(unit.name.to_owned());
            Ok(1.0)
        }
        Some(unit) if unit.name == wanted.length.0 => Ok(1.0),
        Some(unit) => {
            let wanted = &wanted.length.0;
            let size = units::micrometers(wanted).ok_or_else(|| DrawingFault::UnknownUnit {
                found: unit.name,
                wanted: wanted.clone(),
            })?;
            Ok(unit.micrometers / size)
        }
    }
}

fn chord(document: &Document, planar: &mut Planar, asked: &Asked) -> Result<Option<f64>, Failure> {
    let chord = asked.chord.or(planar.chord.take().map(|chord| chord.0));
    match chord {
        Some(chord) if chord <= 0.0 => {
            Err(document.error(&Place::planar().field("chord"), PartFault::Chord { chord }))
        }
        _ => Ok(chord),
    }
}

/// The stiffness of each edge by that of its layer.
fn stiffness(
    document: &Document,
    given: Option<PerPiece>,
    drawing: &Drawing,
) -> Result<Option<PerPiece>, Failure> {
    let Some(PerPiece::ByLayer(layers)) = given else { return Ok(given) };
    let place = || Place::planar().field("stiffness");
    let fault = |place: &Place, fault| document.error(place, PartFault::Layer(Box::new(fault)));
    for (layer, value) in &layers {
        super::part::checked_stiffness(document, &place().field(layer), value.0)?;
        if drawing.edges_on(layer).next().is_none() {
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
    let each: Result<Vec<Finite>, _> = drawing.layers().map(of_layer).collect();
    each.map(|each| Some(PerPiece::Each(each)))
}

/// The same list with edges in place of layers.
fn forbidden(
    document: &Document,
    given: &[Forbidden],
    drawing: &Drawing,
) -> Result<Vec<Forbidden>, Failure> {
    let mut forbidden = Vec::new();
    for (i, given) in given.iter().enumerate() {
        let Forbidden::Layer(schema::ForbiddenLayer { layer }) = given else {
            forbidden.push(given.clone());
            continue;
        };
        let before = forbidden.len();
        let edges = drawing.edges_on(&layer.0).map(|edge| Forbidden::Edge(Whole(edge as u64)));
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

impl Drawing {
    /// The layer of each edge.
    fn layers(&self) -> impl Iterator<Item = &str> {
        self.edges.iter().map(|&source| self.sources[source].layer.as_str())
    }

    /// The edges on a layer.
    fn edges_on(&self, layer: &str) -> impl Iterator<Item = usize> {
        let on = move |(_, own): &(usize, &str)| own.eq_ignore_ascii_case(layer);
        self.layers().enumerate().filter(on).map(|(edge, _)| edge)
    }
}
