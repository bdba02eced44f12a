//! From the entities of a DXF file to curves.

use std::f64::consts::TAU;

use kurbo::{Affine, Point, Vec2};

use super::MOST_ENTITIES;
use super::blocks::Entity;
use super::pairs::Record;
use crate::curve::{Arc, Curve};
use crate::error::DrawingError;
use crate::spline::{Spline, through};
use crate::spline_error::SplineError;

/// The flags of polylines: closed, in space, a mesh of either kind.
const CLOSED: i64 = 1;
const IN_SPACE: i64 = 8;
const MESHES: i64 = 16 | 64;

/// A vertex that only steers a curve.
const CONTROL_VERTEX: i64 = 16;

/// An entity whose kind is a curve.
pub(super) enum Curves {
    InPlane(Vec<Curve>),
    OffPlane,
}

/// Which side of the plane an entity is drawn from.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Above,
    Below,
}

/// The curves of an entity; none if it is of a kind without any.
pub(super) fn curves(entity: &Entity<'_>) -> Result<Option<Curves>, DrawingError> {
    let record = entity.record;
    let drawn = match record.kind {
        "LINE" => line,
        "ARC" => arc,
        "CIRCLE" => circle,
        "ELLIPSE" => ellipse,
        "LWPOLYLINE" => light_polyline,
        "SPLINE" => spline,
        "POLYLINE" if record.flags(70) & MESHES == 0 => {
            return polyline(entity).map(Some);
        }
        _ => return Ok(None),
    };
    match side(record)? {
        None => Ok(Some(Curves::OffPlane)),
        Some(side) => drawn(record, side).map(Some),
    }
}

/// How copies of a block with this base point come to their places; none if not in the plane.
pub(super) fn places(
    record: &Record<'_>,
    base: Point,
) -> Result<Option<Vec<Affine>>, DrawingError> {
    let Some(side) = side(record)? else { return Ok(None) };
    let count = |code| -> Result<usize, DrawingError> {
        let count = record.flags(code).max(1);
        let most = MOST_ENTITIES;
        usize::try_from(count)
            .ok()
            .filter(|count| *count <= most)
            .ok_or(DrawingError::TooManyEntities { most })
    };
    let (columns, rows) = (count(70)?, count(71)?);
    if columns * rows > MOST_ENTITIES {
        return Err(DrawingError::TooManyEntities { most: MOST_ENTITIES });
    }
    let [dx, dy] = [record.number_or(44, 0.0)?, record.number_or(45, 0.0)?];
    let [sx, sy] = [record.number_or(41, 1.0)?, record.number_or(42, 1.0)?];
    let angle = record.number_or(50, 0.0)?.to_radians();
    let at = Vec2::new(record.number_or(10, 0.0)?, record.number_or(20, 0.0)?);
    let placed = side.map() * Affine::translate(at) * Affine::rotate(angle);
    let block = Affine::scale_non_uniform(sx, sy) * Affine::translate(-base.to_vec2());
    let copies = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let copy = |(column, row): (usize, usize)| {
        placed * Affine::translate((column as f64 * dx, row as f64 * dy)) * block
    };
    Ok(Some(copies.map(copy).collect()))
}

impl Side {
    /// From the entity's own coordinates to those of the drawing: what is drawn from below counts x
    /// the other way.
    fn map(self) -> Affine {
        match self {
            Self::Above => Affine::IDENTITY,
            Self::Below => Affine::scale_non_uniform(-1.0, 1.0),
        }
    }
}

/// From which side a thing is drawn; none if it is not in the plane.
fn side(record: &Record<'_>) -> Result<Option<Side>, DrawingError> {
    let normal =
        [record.number_or(210, 0.0)?, record.number_or(220, 0.0)?, record.number_or(230, 1.0)?];
    let flat = normal[0].abs() <= 0.0 && normal[1].abs() <= 0.0;
    Ok(match normal[2] {
        z if flat && z > 0.0 => Some(Side::Above),
        z if flat && z < 0.0 => Some(Side::Below),
        _ => None,
    })
}

/// A line has the coordinates of the drawing, from whichever side it is drawn.
fn line(record: &Record<'_>, _: Side) -> Result<Curves, DrawingError> {
    let start = Point::new(record.needed(10)?, record.needed(20)?);
    let end = Point::new(record.needed(11)?, record.needed(21)?);
    let heights = [record.number_or(30, 0.0)?, record.number_or(31, 0.0)?];
    if is_level(&heights, [start, end]) {
        return Ok(Curves::InPlane(vec![Curve::Line([start, end])]));
    }
    Ok(Curves::OffPlane)
}

fn circle(record: &Record<'_>, side: Side) -> Result<Curves, DrawingError> {
    let (center, radius) = center_and_radius(record)?;
    Ok(Curves::InPlane(vec![Curve::circle(center, radius).mapped(side.map())]))
}

fn arc(record: &Record<'_>, side: Side) -> Result<Curves, DrawingError> {
    let (center, radius) = center_and_radius(record)?;
    let [from, to] = [record.needed(50)?.to_radians(), record.needed(51)?.to_radians()];
    let arc = Arc {
        center,
        u: Vec2::new(radius, 0.0),
        v: Vec2::new(0.0, radius),
        from,
        sweep: counter_clockwise(from, to),
        ends: None,
    };
    Ok(Curves::InPlane(vec![Curve::Arc(arc).mapped(side.map())]))
}

/// An ellipse has the coordinates of the drawing; from below it runs the other way.
fn ellipse(record: &Record<'_>, side: Side) -> Result<Curves, DrawingError> {
    let center = Point::new(record.needed(10)?, record.needed(20)?);
    let u = Vec2::new(record.needed(11)?, record.needed(21)?);
    let ratio = record.needed(40)?;
    if ratio.abs() <= 0.0 {
        return Err(DrawingError::AxisRatio { line: record.line, ratio });
    }
    let turned = u.turn_90() * ratio;
    let v = if side == Side::Above { turned } else { -turned };
    let [from, to] = [record.number_or(41, 0.0)?, record.number_or(42, TAU)?];
    let sweep = counter_clockwise(from, to);
    let whole = sweep >= TAU;
    Ok(Curves::InPlane(vec![if whole {
        Curve::ellipse(center, u, v)
    } else {
        Curve::Arc(Arc { center, u, v, from, sweep, ends: None })
    }]))
}

fn center_and_radius(record: &Record<'_>) -> Result<(Point, f64), DrawingError> {
    let center = Point::new(record.needed(10)?, record.needed(20)?);
    let radius = record.needed(40)?;
    if radius > 0.0 {
        return Ok((center, radius));
    }
    let (kind, line) = (record.kind.to_owned(), record.line);
    Err(DrawingError::Radius { kind, line, radius })
}

/// How far it is from one angle on to another; a whole turn for none.
fn counter_clockwise(from: f64, to: f64) -> f64 {
    let sweep = (to - from).rem_euclid(TAU);
    // What is a whole turn up to the digits of the file has no start to be told from its end.
    if sweep <= WHOLE_TURN || TAU - sweep <= WHOLE_TURN { TAU } else { sweep }
}

/// Angles of files have at least nine digits: what is nearer to a whole turn is one (radian).
const WHOLE_TURN: f64 = 1e-9;

fn light_polyline(record: &Record<'_>, side: Side) -> Result<Curves, DrawingError> {
    let vertices = record.groups([10, 20, 42])?;
    let vertices = vertices.iter().map(|[x, y, bulge]| {
        (Point::new(x.unwrap_or(0.0), y.unwrap_or(0.0)), bulge.unwrap_or(0.0))
    });
    let closed = record.flags(70) & CLOSED != 0;
    let curves = chain(record, &vertices.collect::<Vec<_>>(), closed)?;
    Ok(Curves::InPlane(curves.iter().map(|curve| curve.mapped(side.map())).collect()))
}

fn polyline(entity: &Entity<'_>) -> Result<Curves, DrawingError> {
    let record = entity.record;
    let Some(side) = side(record)? else { return Ok(Curves::OffPlane) };
    let drawn = |part: &&Record<'_>| part.kind == "VERTEX" && part.flags(70) & CONTROL_VERTEX == 0;
    let (mut vertices, mut heights) = (Vec::new(), Vec::new());
    for part in entity.parts.iter().filter(drawn) {
        let point = Point::new(part.needed(10)?, part.needed(20)?);
        vertices.push((point, part.number_or(42, 0.0)?));
        heights.push(part.number_or(30, 0.0)?);
    }
    let in_space = record.flags(70) & IN_SPACE != 0;
    if in_space && !is_level(&heights, vertices.iter().map(|vertex| vertex.0)) {
        return Ok(Curves::OffPlane);
    }
    let curves = chain(record, &vertices, record.flags(70) & CLOSED != 0)?;
    let map = if in_space { Affine::IDENTITY } else { side.map() };
    Ok(Curves::InPlane(curves.iter().map(|curve| curve.mapped(map)).collect()))
}

/// The pieces between vertices, each with the bulge of what follows it; those of no length are
/// none.
fn chain(
    record: &Record<'_>,
    vertices: &[(Point, f64)],
    closed: bool,
) -> Result<Vec<Curve>, DrawingError> {
    let closing = vertices.last().zip(vertices.first()).filter(|_| closed);
    let pairs = vertices.windows(2).map(|pair| (&pair[0], &pair[1])).chain(closing);
    let pairs = pairs.filter(|(one, other)| one.0 != other.0);
    let curves: Vec<Curve> =
        pairs.map(|((p, bulge), (q, _))| Curve::bulged([*p, *q], *bulge)).collect();
    if curves.is_empty() {
        let (kind, line) = (record.kind.to_owned(), record.line);
        return Err(DrawingError::NoLength { kind, line });
    }
    Ok(curves)
}

/// A spline has the coordinates of the drawing.
fn spline(record: &Record<'_>, _: Side) -> Result<Curves, DrawingError> {
    let faulty = |error| DrawingError::Spline { line: record.line, error };
    let controls = record.groups([10, 20, 30])?;
    let fits = record.groups([11, 21, 31])?;
    let given = if controls.is_empty() { &fits } else { &controls };
    let heights: Vec<f64> = given.iter().map(|point| point[2].unwrap_or(0.0)).collect();
    let point = |p: &[Option<f64>; 3]| Point::new(p[0].unwrap_or(0.0), p[1].unwrap_or(0.0));
    if !is_level(&heights, given.iter().map(point)) {
        return Ok(Curves::OffPlane);
    }
    if controls.is_empty() {
        let tangent = |[x, y]: [i32; 2]| -> Result<Option<Vec2>, DrawingError> {
            match record.text(x) {
                None => Ok(None),
                Some(_) => Ok(Some(Vec2::new(record.needed(x)?, record.number_or(y, 0.0)?))),
            }
        };
        let ends = [tangent([12, 22])?, tangent([13, 23])?];
        let points: Vec<Point> = fits.iter().map(point).collect();
        let closed = record.flags(70) & CLOSED != 0;
        return through(&points, ends, closed).map(Curves::InPlane).map_err(faulty);
    }
    let weights = record.numbers(41)?;
    let points = controls.len();
    if !weights.is_empty() && weights.len() != points {
        return Err(faulty(SplineError::WeightCount { weights: weights.len(), points }));
    }
    if let Some(&weight) = weights.iter().find(|weight| **weight <= 0.0) {
        return Err(faulty(SplineError::Weight { weight }));
    }
    let weight = |i: usize| weights.get(i).copied().unwrap_or(1.0);
    let weighed = controls.iter().map(point).enumerate();
    let degree = record.flags(71);
    let spline = Spline {
        degree: usize::try_from(degree).unwrap_or(0),
        knots: record.numbers(40)?,
        points: weighed.map(|(i, p)| [p.x * weight(i), p.y * weight(i), weight(i)]).collect(),
    };
    spline.curves().map(Curves::InPlane).map_err(faulty)
}

/// Heights that differ by less than this part of the coordinates are rounding: files have nine
/// digits or more.
const LEVEL: f64 = 1e-8;

/// Whether all heights are the same, up to rounding of numbers as large as `points`.
fn is_level(heights: &[f64], points: impl IntoIterator<Item = Point>) -> bool {
    let size = points.into_iter().map(|p| p.x.abs().max(p.y.abs())).fold(0.0, f64::max);
    heights.iter().all(|height| (height - heights[0]).abs() <= LEVEL * size)
}
