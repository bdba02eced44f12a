//! The part on a drawing: a polygon whose edges know where they are from.

use clench_shape::{Polygon, PolygonError};
use kurbo::{Point, Rect};

use crate::chain::{Chain, Contour, Joined, joined, without_repeats};
use crate::curve::{Corners, Curve};
use crate::error::DrawingError;
use crate::sheet::{Sheet, Strand};
use crate::source::{LeftAside, Source};

/// Unless told otherwise, chains of corners deviate from their curves by at most this part of the
/// drawing's diagonal: on a sheet of paper it is a hair's breadth.
const CHORD: f64 = 1e-4;

/// Ends of curves that are nearer to each other than this part of the drawing's diagonal are
/// joined: coordinates with four digits after the point, and angles with as many, leave such gaps.
const JOIN: f64 = 1e-4;

/// The corners that a drawing may have.
const MOST_CORNERS: usize = 100_000;

/// A part by its drawing, from [`Sheet::part`]; lengths are those of the drawing times the scale.
#[derive(Clone, Debug)]
pub struct DrawnPart {
    polygon: Polygon,
    sources: Vec<Source>,
    /// Of each edge, the number of its source.
    edges: Vec<usize>,
    chord: f64,
    largest_gap: f64,
    repeats: Vec<Repeat>,
    left_aside: Vec<LeftAside>,
}

/// A curve that is on the drawing twice, in either direction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repeat {
    /// The one that is left out.
    pub left_out: Source,
    /// The one before it, which the part has.
    pub kept: Source,
}

impl DrawnPart {
    pub(crate) fn of(sheet: &Sheet, scale: f64, chord: Option<f64>) -> Result<Self, DrawingError> {
        check(scale, chord)?;
        let (sources, left_aside) = (&sheet.sources[..], sheet.aside.list());
        if sheet.strands.is_empty() {
            return Err(DrawingError::NothingDrawn { left_aside });
        }
        let strands: Vec<Strand> =
            sheet.strands.iter().map(|strand| strand.scaled(scale)).collect();
        let diagonal = diagonal(&strands);
        if !(diagonal.is_finite() && diagonal > 0.0) {
            return Err(DrawingError::Size { diagonal });
        }
        let chord = chord.unwrap_or(CHORD * diagonal);
        let (chains, repeats) = without_repeats(flattened(&strands, sources, chord)?);
        let Joined { contours, largest_gap } = joined(&chains, sources, JOIN * diagonal)
            .map_err(|error| error.with_left_aside(&left_aside))?;
        let contours = outline_first(contours);
        let polygon = polygon(&contours, sources)?;
        let repeat = |[one, other]: &[usize; 2]| Repeat {
            left_out: sources[*one].clone(),
            kept: sources[*other].clone(),
        };
        let repeats = repeats.iter().map(repeat).collect();
        let chord = if is_flattened(&contours, &strands) { chord } else { 0.0 };
        let (sources, edges) = numbered(&contours, sources);
        Ok(Self { polygon, sources, edges, chord, largest_gap, repeats, left_aside })
    }

    /// The outline and its holes.
    #[must_use]
    pub const fn polygon(&self) -> &Polygon {
        &self.polygon
    }

    /// Where each edge of the polygon is from, in the order of the edges.
    #[must_use]
    pub fn edge_sources(&self) -> impl ExactSizeIterator<Item = &Source> {
        self.edges.iter().map(|&source| &self.sources[source])
    }

    /// The numbers of the edges on a layer, without regard to the case of ASCII letters.
    pub fn edges_on(&self, layer: &str) -> impl Iterator<Item = usize> {
        let on = move |(_, source): &(usize, &Source)| source.layer.eq_ignore_ascii_case(layer);
        self.edge_sources().enumerate().filter(on).map(|(edge, _)| edge)
    }

    /// The curves that the outline and its holes consist of, in the order of the file.
    #[must_use]
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// No edge is farther than this from its curve (length): 0 if all curves are straight. Corners
    /// are on their curves.
    #[must_use]
    pub const fn chord(&self) -> f64 {
        self.chord
    }

    /// The largest distance between two ends that were joined (length).
    #[must_use]
    pub const fn largest_gap(&self) -> f64 {
        self.largest_gap
    }

    /// The curves that were there twice.
    #[must_use]
    pub fn repeats(&self) -> &[Repeat] {
        &self.repeats
    }

    /// What is on the drawing and no part of the outline or a hole, by kind, layer and reason.
    #[must_use]
    pub fn left_aside(&self) -> &[LeftAside] {
        &self.left_aside
    }
}

fn check(scale: f64, chord: Option<f64>) -> Result<(), DrawingError> {
    let is_positive = |x: f64| x > 0.0 && x.is_finite();
    match chord {
        _ if !is_positive(scale) => Err(DrawingError::Scale { scale }),
        Some(chord) if !is_positive(chord) => Err(DrawingError::Chord { chord }),
        _ => Ok(()),
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
    sources: &[Source],
    chord: f64,
) -> Result<Vec<Chain>, DrawingError> {
    let mut room = MOST_CORNERS;
    let chain = |strand: &Strand| {
        let mut corners = Corners::new(room);
        for curve in &strand.curves {
            curve.flatten(chord, &mut corners).map_err(|_| DrawingError::TooManyCorners {
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

/// The contours, the largest one, which is the outline, first.
fn outline_first(mut contours: Vec<Contour>) -> Vec<Contour> {
    let areas: Vec<f64> = contours.iter().map(|contour| area(&contour.corners).abs()).collect();
    let largest = (0..areas.len()).max_by(|&one, &other| areas[one].total_cmp(&areas[other]));
    // Of equals the first one is the outline.
    let largest = largest.and_then(|one| areas.iter().position(|area| *area >= areas[one]));
    if let Some(outline) = largest {
        contours[..=outline].rotate_right(1);
    }
    contours
}

/// The area within a contour, positive if it runs counter-clockwise; about its first corner, so
/// that it does not suffer far away from the origin.
fn area(corners: &[Point]) -> f64 {
    let first = corners[0];
    let doubled: f64 =
        corners.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first)).sum();
    doubled * 0.5
}

/// Whether a curve of a contour is not straight.
fn is_flattened(contours: &[Contour], strands: &[Strand]) -> bool {
    let is_bent = |curve: &Curve| !matches!(curve, Curve::Line(_));
    let mut bent: Vec<usize> = strands
        .iter()
        .filter(|strand| strand.curves.iter().any(is_bent))
        .map(|strand| strand.source)
        .collect();
    bent.sort_unstable();
    let sources = contours.iter().flat_map(|contour| &contour.sources);
    sources.into_iter().any(|source| bent.binary_search(source).is_ok())
}

/// The contours as a polygon, or what is wrong with them in terms of the drawing.
fn polygon(contours: &[Contour], sources: &[Source]) -> Result<Polygon, DrawingError> {
    let corners = |contour: &Contour| contour.corners.iter().map(|p| [p.x, p.y]).collect();
    let mut loops = contours.iter().map(corners);
    let outline: Vec<[f64; 2]> = loops.next().unwrap_or_default();
    let holes: Vec<Vec<[f64; 2]>> = loops.collect();
    Polygon::with_holes(&outline, &holes).map_err(|error| {
        // The outline is contour 0, and the holes follow it.
        let contour = |number: usize| sources[contours[number].sources[0]].clone();
        let edges = match error {
            PolygonError::CrossingEdges { first, second }
            | PolygonError::RepeatedCorner { first, second } => [first, second],
            PolygonError::FoldedEdge { edge } => [edge; 2],
            PolygonError::HoleOutside { hole } => {
                let curves = Box::new([contour(0), contour(hole + 1)]);
                return DrawingError::SecondPart { curves };
            }
            PolygonError::HoleInHole { hole, within } => {
                let curves = Box::new([contour(within + 1), contour(hole + 1)]);
                return DrawingError::Island { curves };
            }
            _ => return DrawingError::Outline(error),
        };
        let source = |edge: usize| {
            let number = contours.iter().flat_map(|contour| &contour.sources).nth(edge)?;
            Some(sources[*number].clone())
        };
        let at = outline.iter().chain(holes.iter().flatten()).nth(edges[1]);
        match (edges.map(source), at) {
            ([Some(one), Some(other)], Some(&at)) => {
                DrawingError::Crossing { curves: Box::new([one, other]), at }
            }
            _ => DrawingError::Outline(error),
        }
    })
}

/// The sources that edges are from, and the number among them of that of each edge.
fn numbered(contours: &[Contour], sources: &[Source]) -> (Vec<Source>, Vec<usize>) {
    let edges = contours.iter().flat_map(|contour| contour.sources.iter().copied());
    let mut used: Vec<usize> = edges.clone().collect();
    used.sort_unstable();
    used.dedup();
    let number = |source: usize| used.partition_point(|other| *other < source);
    let edges = edges.map(number).collect();
    (used.iter().map(|&source| sources[source].clone()).collect(), edges)
}
