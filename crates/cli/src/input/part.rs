//! From the numbers of a file to a part.

use clench::optimize::OptimizeError;
use clench::optimize::polygon::Part;
use clench::shape::{Polygon, PolygonError};

use super::document::Document;
use super::fault::Fault;
use super::number::PerEdge;
use super::place::Place;
use super::schema;
use crate::failure::Failure;

/// The part of a file.
pub(crate) fn planar_part(document: &Document, part: &schema::Part) -> Result<Part, Failure> {
    let here = Place::default().field("part");
    if part.spatial.is_some() {
        return Err(document.error(&here.field("spatial"), Fault::SpatialPart));
    }
    let planar = part.planar.as_ref().ok_or_else(|| document.error(&here, Fault::NoPart))?;
    let corners: Vec<[f64; 2]> = planar.outline.iter().map(|corner| corner.0).collect();
    let outline = Polygon::new(&corners).map_err(|e| {
        let place = corner_at_fault(&e);
        let fault = match e {
            PolygonError::TooFewCorners { count } => Fault::TooFewCorners { count },
            _ => Fault::Outline(e),
        };
        document.error(&place, fault)
    })?;
    let stiffness = planar.stiffness.each(corners.len());
    let each = matches!(planar.stiffness, PerEdge::Each(_));
    Part::new(outline, stiffness).map_err(|e| {
        let place = Place::planar().field("stiffness");
        let place = match e {
            OptimizeError::Stiffness { edge, .. } if each => place.item(edge),
            _ => place,
        };
        document.error(&place, Fault::Stiffness(e))
    })
}

/// The corner of the file that an outline's fault is about; the outline when it is about all.
fn corner_at_fault(fault: &PolygonError) -> Place {
    let outline = Place::outline();
    match *fault {
        PolygonError::NotFinite { corner, .. }
        | PolygonError::TooLarge { corner, .. }
        | PolygonError::TooSmall { corner, .. }
        | PolygonError::ZeroLengthEdge { end: corner, .. }
        | PolygonError::RepeatedCorner { second: corner, .. }
        | PolygonError::FoldedEdge { edge: corner }
        | PolygonError::CrossingEdges { second: corner, .. } => outline.item(corner),
        _ => outline,
    }
}
