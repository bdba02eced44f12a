//! Where the fingers may not touch an outline: margins and forbidden stretches.

use clench::optimize::OptimizeError;
use clench::optimize::polygon::{Part, Stretch};

use super::document::Document;
use super::fault::PartFault;
use super::place::Place;
use super::schema::{self, Forbidden, ForbiddenStretch};
use super::tip::disc_tip;
use crate::failure::Failure;

/// The part without what its file forbids.
pub(super) fn allowed(
    document: &Document,
    part: Part,
    planar: &schema::Planar,
) -> Result<Part, Failure> {
    // What is said about tips has to be sound, whoever asks.
    disc_tip(document, planar, 0.0)?;
    let mut part = part;
    if let Some(margin) = planar.margin {
        let place = Place::planar().field("margin");
        part = part
            .with_margin(margin.0)
            .map_err(|e| document.error(&place, PartFault::Forbidden(Box::new(e))))?;
    }
    let list = Place::planar().field("forbidden");
    for (i, forbidden) in planar.forbidden.iter().enumerate() {
        part = without(part, forbidden).map_err(|e| {
            document.error(&list.clone().item(i), PartFault::Forbidden(Box::new(e)))
        })?;
    }
    Ok(part)
}

/// The part without an edge, or a stretch of one.
pub(crate) fn without(part: Part, forbidden: &Forbidden) -> Result<Part, OptimizeError> {
    // Numbers that are too large for an edge are refused as any other that is.
    let number = |edge: u64| usize::try_from(edge).unwrap_or(usize::MAX);
    match *forbidden {
        Forbidden::Edge(edge) => part.without_edge(number(edge.0)),
        Forbidden::Stretch(ForbiddenStretch { edge, from, to }) => {
            part.without(Stretch { edge: number(edge.0), from: from.0, to: to.0 })
        }
        // Its edges stand in the list by themselves.
        Forbidden::Layer(_) => Ok(part),
    }
}
