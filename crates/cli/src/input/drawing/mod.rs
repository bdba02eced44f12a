//! Drawings: the outline of a part and its holes, from DXF and SVG files.

mod chain;
mod curve;
mod dxf;
mod fault;
mod nest;
mod sheet;
mod spline;
mod svg;

use std::fs;
use std::path::Path;

use clench::shape::PolygonError;
use kurbo::{Affine, Point, Rect};

use self::chain::{Chain, Contour, Joined, joined, without_repeats};
use self::curve::{Corners, Curve};
use self::nest::nested;
use self::sheet::{Sheet, Strand};
use super::shield::shielded;

pub(crate) use fault::DrawingFault;
pub(crate) use sheet::{Aside, Source, Unit, layer_name};

/// Unless told otherwise, chains of corners deviate from their curves by at most this part of the
/// drawing's diagonal: on a sheet of paper it is a hair's breadth.
const CHORD: f64 = 1e-4;

/// Ends of curves that are nearer to each other than this part of the drawing's diagonal are
/// joined: coordinates with four digits after the point, and angles with as many, leave such gaps.
const JOIN: f64 = 1e-4;

/// The corners that a drawing may have.
const MOST_CORNERS: usize = 100_000;

/// Larger files are no drawings of a part (bytes).
const LARGEST_FILE: u64 = 1 << 25;

/// How a drawing is to be read.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reading {
    /// The largest distance of the corners' chain from a curve (length, in the unit asked for).
    pub(crate) chord: Option<f64>,
}

/// The part on a drawing.
#[derive(Clone, Debug)]
pub(crate) struct Drawing {
    /// The corners of the outline, then those of each hole.
    pub(crate) contours: Vec<Vec<[f64; 2]>>,
    /// Where each edge is from, by the number of its source.
    pub(crate) edges: Vec<usize>,
    pub(crate) sources: Vec<Source>,
    pub(crate) chord: f64,
    pub(crate) largest_gap: f64,
    /// Curves that were there twice: the one left out, and the one kept.
    pub(crate) repeats: Vec<[usize; 2]>,
    pub(crate) aside: Aside,
}

/// A drawing whose unit is known, and whose curves are not yet joined.
#[derive(Debug)]
pub(crate) struct Unjoined {
    sheet: Sheet,
}

/// Reads the file at `path`, a DXF or SVG file by its ending.
pub(crate) fn read(path: &Path, layers: &[String]) -> Result<Unjoined, DrawingFault> {
    let read = match ending(path).as_deref() {
        Some("dxf") => dxf::read,
        Some("svg") => svg::read,
        _ => return Err(DrawingFault::UnknownEnding),
    };
    let size = fs::metadata(path).map_err(DrawingFault::Unreadable)?.len();
    if size > LARGEST_FILE {
        return Err(DrawingFault::TooLarge { size, most: LARGEST_FILE });
    }
    let bytes = fs::read(path).map_err(DrawingFault::Unreadable)?;
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return Err(DrawingFault::Empty);
    }
    let sheet = shielded(|| read(&bytes, layers)).ok_or(DrawingFault::Panicked)??;
    let known = |layer: &&String| sheet.layers.iter().any(|name| name.eq_ignore_ascii_case(layer));
    match layers.iter().find(|layer| !known(layer)) {
        Some(layer) => {
            let (layer, known) = (layer.clone(), sheet.layers);
            Err(DrawingFault::NoSuchLayer { layer, known })
        }
        None => Ok(Unjoined { sheet }),
    }
}

/// The ending of a file name in lower case.
pub(crate) fn ending(path: &Path) -> Option<String> {
    path.extension().map(|ending| ending.to_string_lossy().to_lowercase())
}

impl Unjoined {
    /// The unit of the drawing's numbers, if it names one.
    pub(crate) const fn unit(&self) -> Option<Unit> {
        self.sheet.unit
    }

    /// The part, all lengths times `scale`.
    pub(crate) fn drawing(self, scale: f64, reading: &Reading) -> Result<Drawing, DrawingFault> {
        let Sheet { mut sources, strands, aside, .. } = self.sheet;
        if strands.is_empty() {
            return Err(DrawingFault::NothingDrawn { aside });
        }
        let scaled = |strand: Strand| {
            let map = Affine::scale(scale);
            let curves = strand.curves.iter().map(|curve| curve.mapped(map)).collect();
            Strand { curves, ..strand }
        };
        let strands: Vec<Strand> = strands.into_iter().map(scaled).collect();
        let diagonal = diagonal(&strands);
        if !(diagonal.is_finite() && diagonal > 0.0) {
            return Err(DrawingFault::Size { diagonal });
        }
        let chord = reading.chord.unwrap_or(CHORD * diagonal);
        let chains = flattened(&strands, &sources, chord)?;
        let (chains, repeats) = without_repeats(chains);
        let Joined { contours, largest_gap } =
            joined(&chains, &sources, JOIN * diagonal).map_err(|fault| fault.with_aside(&aside))?;
        let contours = nested(contours, &sources)?;
        let edges = contours.iter().flat_map(|contour| contour.sources.iter().copied()).collect();
        let corners = |contour: &Contour| contour.corners.iter().map(|p| [p.x, p.y]).collect();
        let contours = contours.iter().map(corners).collect();
        sources.shrink_to_fit();
        Ok(Drawing { contours, edges, sources, chord, largest_gap, repeats, aside })
    }
}

impl Drawing {
    /// The fault of the outline in terms of the drawing.
    pub(crate) fn fault(&self, error: PolygonError) -> DrawingFault {
        let source = |edge: usize| self.edges.get(edge).map(|&source| self.sources[source].clone());
        let edges = match error {
            PolygonError::CrossingEdges { first, second }
            | PolygonError::RepeatedCorner { first, second } => [first, second],
            PolygonError::FoldedEdge { edge } => [edge; 2],
            _ => return DrawingFault::Outline(error),
        };
        match edges.map(source) {
            [Some(one), Some(other)] => {
                let at = self.corner(edges[1]).unwrap_or_default();
                DrawingFault::Crossing { sources: Box::new([one, other]), at }
            }
            _ => DrawingFault::Outline(error),
        }
    }

    fn corner(&self, number: usize) -> Option<(f64, f64)> {
        self.contours.iter().flatten().nth(number).map(|&[x, y]| (x, y))
    }
}

/// The diagonal of the smallest upright rectangle around the curves, by points along them.
fn diagonal(strands: &[Strand]) -> f64 {
    let points = strands.iter().flat_map(|strand| &strand.curves).flat_map(Curve::samples);
    let around = |rect: Option<Rect>, point: Point| {
        Some(rect.map_or(Rect::from_points(point, point), |rect| rect.union_pt(point)))
    };
    points.fold(None, around).map_or(0.0, |rect| rect.width().hypot(rect.height()))
}

fn flattened(
    strands: &[Strand],
    sources: &[sheet::Source],
    chord: f64,
) -> Result<Vec<Chain>, DrawingFault> {
    let mut room = MOST_CORNERS;
    let chain = |strand: &Strand| {
        let mut corners = Corners::new(room);
        for curve in &strand.curves {
            curve.flatten(chord, &mut corners).map_err(|_| DrawingFault::TooManyCorners {
                curve: Box::new(sources[strand.source].clone()),
                most: MOST_CORNERS,
                chord,
            })?;
        }
        room -= corners.points.len();
        Ok(Chain { points: corners.points, source: strand.source })
    };
    strands.iter().map(chain).collect()
}
