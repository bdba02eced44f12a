//! From the numbers of a file to a part.

use clench::optimize::OptimizeError;
use clench::optimize::polygon;
use clench::screw::Vector;
use clench::shape::{Ellipsoid, EllipsoidError, Extent, Polygon, PolygonError};

use super::boundary::PieceKind;
use super::document::Document;
use super::fault::PartFault;
use super::number::{Finite, PerPiece, Point};
use super::place::Place;
use super::schema;
use super::solid;
use super::touch::allowed;
use crate::failure::Failure;

pub(crate) use super::solid::{Solid, SpatialShape};

/// A part, and how stiff a contact on it is unless it has a law.
#[derive(Debug)]
pub(crate) enum Part {
    Planar(Body<PlanarShape>),
    Spatial(Body<SpatialShape>),
}

/// A shape, and the stiffness of a contact on each edge or face of it.
#[derive(Debug)]
pub(crate) struct Body<S> {
    pub(crate) shape: S,
    pub(super) stiffness: Option<Vec<f64>>,
}

/// What fingers can be placed on.
#[derive(Debug)]
pub(crate) enum TouchablePart {
    Outline(Box<polygon::Part>),
    /// A solid, and the stiffness of a contact on it, if it has any.
    Solid(Box<Body<Solid>>),
}

/// A planar part.
#[derive(Debug)]
pub(crate) enum PlanarShape {
    Outline(Box<Polygon>),
    Ellipse(Ellipsoid<2>),
}

impl PlanarShape {
    /// What decides how far it reaches.
    pub(crate) fn extent(&self) -> Extent<'_, 2> {
        match self {
            Self::Outline(outline) => Extent::from(&**outline),
            Self::Ellipse(ellipse) => Extent::from(ellipse),
        }
    }
}

/// The part of a file, for analysis.
pub(crate) fn part(document: &Document, part: &schema::Part) -> Result<Part, Failure> {
    match (&part.planar, &part.spatial) {
        (Some(planar), None) => planar_body(document, planar).map(Part::Planar),
        (None, Some(spatial)) => solid::body(document, spatial).map(Part::Spatial),
        (None, None) => Err(document.error(&Place::part(), PartFault::None)),
        (Some(_), Some(_)) => Err(document.error(&Place::part(), PartFault::Two)),
    }
}

/// The part of a file, for the placement of fingers.
pub(crate) fn touchable_part(
    document: &Document,
    part: &schema::Part,
) -> Result<TouchablePart, Failure> {
    match (&part.planar, &part.spatial) {
        (Some(planar), None) => {
            outline_part(document, planar).map(Box::new).map(TouchablePart::Outline)
        }
        (None, Some(spatial)) => {
            let Body { shape, stiffness } = solid::body(document, spatial)?;
            match shape {
                SpatialShape::Polyhedron(solid) => {
                    Ok(TouchablePart::Solid(Box::new(Body { shape: *solid, stiffness })))
                }
                SpatialShape::Ellipsoid(_) => {
                    let place = Place::spatial().field("ellipsoid");
                    Err(document.error(&place, PartFault::SmoothSolidOptimum))
                }
            }
        }
        (None, None) => Err(document.error(&Place::part(), PartFault::None)),
        (Some(_), Some(_)) => Err(document.error(&Place::part(), PartFault::Two)),
    }
}

/// An outline with its stiffness.
fn outline_part(document: &Document, planar: &schema::Planar) -> Result<polygon::Part, Failure> {
    let here = |fault| document.error(&Place::planar(), fault);
    match (&planar.outline, &planar.stiffness) {
        (None, _) => Err(here(PartFault::SmoothOptimum)),
        (Some(_), _) if planar.ellipse.is_some() => {
            Err(here(PartFault::PlanarShape { found: "both" }))
        }
        (Some(_), None) => Err(here(PartFault::NoStiffness { piece: PieceKind::Edge })),
        (Some(corners), Some(stiffness)) => {
            check_no_center(document, planar)?;
            let outline = outline(document, corners, &planar.holes)?;
            let part = with_stiffness(document, outline, stiffness)?;
            allowed(document, part, planar)
        }
    }
}

fn planar_body(document: &Document, planar: &schema::Planar) -> Result<Body<PlanarShape>, Failure> {
    match (&planar.outline, &planar.ellipse) {
        (Some(corners), None) => {
            check_no_center(document, planar)?;
            let outline = outline(document, corners, &planar.holes)?;
            // Where fingers may not touch depends on no stiffness.
            let given = planar.stiffness.as_ref();
            let any = PerPiece::All(Finite(1.0));
            let part = with_stiffness(document, outline, given.unwrap_or(&any))?;
            let part = allowed(document, part, planar)?;
            let shape = PlanarShape::Outline(Box::new(part.outline().clone()));
            Ok(Body { shape, stiffness: given.map(|_| part.edge_stiffness().to_vec()) })
        }
        (None, Some(semi_axes)) => {
            check_no_margin(document, planar)?;
            let (place, center) = (Place::planar(), planar.center);
            let ellipse = ellipsoid(document, &place, "ellipse", *semi_axes, center)?;
            let reason = "an ellipse has no edges";
            let stiffness = one_stiffness(document, &place, planar.stiffness.as_ref(), reason)?;
            Ok(Body { shape: PlanarShape::Ellipse(ellipse), stiffness })
        }
        (found, _) => {
            let found = if found.is_some() { "both" } else { "no shape" };
            Err(document.error(&Place::planar(), PartFault::PlanarShape { found }))
        }
    }
}

fn check_no_center(document: &Document, planar: &schema::Planar) -> Result<(), Failure> {
    match planar.center {
        Some(_) => {
            let fault = PartFault::Center { smooth: "ellipse" };
            Err(document.error(&Place::planar().field("center"), fault))
        }
        None => Ok(()),
    }
}

fn check_no_margin(document: &Document, planar: &schema::Planar) -> Result<(), Failure> {
    let only = |name, found| {
        document.error(&Place::planar().field(name), PartFault::OutlineOnly { found })
    };
    match planar {
        schema::Planar { holes, .. } if !holes.is_empty() => Err(only("holes", "`holes`")),
        schema::Planar { margin: Some(_), .. } => Err(only("margin", "a `margin`")),
        schema::Planar { plate: Some(_), .. } => Err(only("plate", "a `plate`")),
        schema::Planar { keep_out, .. } if !keep_out.is_empty() => {
            Err(only("keep_out", "a `keep_out`"))
        }
        schema::Planar { forbidden, .. } if !forbidden.is_empty() => {
            Err(only("forbidden", "`forbidden` edges"))
        }
        _ => Ok(()),
    }
}

fn outline(
    document: &Document,
    outline: &[Point<2>],
    holes: &[Vec<Point<2>>],
) -> Result<Polygon, Failure> {
    let array = |corners: &[Point<2>]| corners.iter().map(|corner| corner.0).collect();
    let corners: Vec<[f64; 2]> = array(outline);
    let cut: Vec<Vec<[f64; 2]>> = holes.iter().map(|hole| array(hole)).collect();
    Polygon::with_holes(&corners, &cut).map_err(|e| {
        let place = place_of(&e, outline.len(), holes);
        let fault = match e {
            PolygonError::TooFewCorners { count }
            | PolygonError::TooFewCornersOfHole { count, .. } => PartFault::TooFewCorners { count },
            _ => PartFault::Outline(e),
        };
        document.error(&place, fault)
    })
}

fn with_stiffness(
    document: &Document,
    outline: Polygon,
    stiffness: &PerPiece,
) -> Result<polygon::Part, Failure> {
    let each = matches!(stiffness, PerPiece::Each(_));
    let stiffness = stiffness.each(outline.corners().len());
    polygon::Part::new(outline, stiffness).map_err(|e| {
        let place = Place::planar().field("stiffness");
        let place = match e {
            OptimizeError::Stiffness { side: edge, .. } if each => place.item(edge),
            _ => place,
        };
        document.error(&place, PartFault::PieceStiffness(Box::new(e)))
    })
}

/// The corner or the hole of the file that an outline's fault is about; the outline when it is
/// about all.
fn place_of(fault: &PolygonError, outer: usize, holes: &[Vec<Point<2>>]) -> Place {
    let outline = || Place::planar().field("outline");
    let corner_at = |corner: usize| {
        if corner < outer {
            return outline().item(corner);
        }
        let mut rest = corner - outer;
        for (i, hole) in holes.iter().enumerate() {
            if rest < hole.len() {
                return hole_at(i).item(rest);
            }
            rest -= hole.len();
        }
        outline()
    };
    match *fault {
        PolygonError::NotFinite { corner, .. }
        | PolygonError::TooLarge { corner, .. }
        | PolygonError::TooSmall { corner, .. }
        | PolygonError::ZeroLengthEdge { end: corner, .. }
        | PolygonError::RepeatedCorner { second: corner, .. }
        | PolygonError::FoldedEdge { edge: corner }
        | PolygonError::CrossingEdges { second: corner, .. } => corner_at(corner),
        PolygonError::TooFewCornersOfHole { hole, .. }
        | PolygonError::ZeroAreaOfHole { hole, .. }
        | PolygonError::HoleOutside { hole }
        | PolygonError::HoleInHole { hole, .. } => hole_at(hole),
        _ => outline(),
    }
}

/// The place of hole number `i`.
fn hole_at(i: usize) -> Place {
    Place::planar().field("holes").item(i)
}

/// The ellipse or ellipsoid with `semi_axes` in the field `name` of the part at `place`.
pub(super) fn ellipsoid<const N: usize>(
    document: &Document,
    place: &Place,
    name: &str,
    semi_axes: Point<N>,
    center: Option<Point<N>>,
) -> Result<Ellipsoid<N>, Failure> {
    let center = center.map_or(Vector::ZERO, |center| center.0.into());
    Ellipsoid::new(center, semi_axes.0).map_err(|e| {
        let axes = || place.clone().field(name);
        let place = match e {
            EllipsoidError::CenterNotFinite { component, .. }
            | EllipsoidError::CenterTooFar { component, .. } => {
                place.clone().field("center").item(component)
            }
            EllipsoidError::SemiAxisOutOfRange { axis, .. } => axes().item(axis),
            _ => axes(),
        };
        let fault = match e {
            EllipsoidError::SemiAxisOutOfRange { axis, value } => {
                PartFault::SemiAxis { axis, value }
            }
            _ => PartFault::Ellipsoid(e),
        };
        document.error(&place, fault)
    })
}

/// The stiffness of a contact anywhere on a part whose pieces have none of their own.
pub(super) fn one_stiffness(
    document: &Document,
    part: &Place,
    stiffness: Option<&PerPiece>,
    reason: &'static str,
) -> Result<Option<Vec<f64>>, Failure> {
    let place = || part.clone().field("stiffness");
    match stiffness {
        None => Ok(None),
        Some(PerPiece::Each(_) | PerPiece::ByLayer(_)) => {
            Err(document.error(&place(), PartFault::StiffnessList { reason }))
        }
        Some(PerPiece::All(value)) => {
            checked_stiffness(document, &place(), value.0).map(|value| Some(vec![value]))
        }
    }
}

/// A stiffness, if it is positive.
pub(super) fn checked_stiffness(
    document: &Document,
    place: &Place,
    value: f64,
) -> Result<f64, Failure> {
    if value > 0.0 {
        return Ok(value);
    }
    Err(document.error(place, PartFault::Stiffness { value }))
}
