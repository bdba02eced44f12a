//! Where the tips of fingers may be beside a solid.

use clench::shape::{AccessError, BallTip, KeepOut, Plate};

use super::document::Document;
use super::fault::PartFault;
use super::place::Place;
use super::schema;
use crate::failure::Failure;

/// The tip of a pointed finger, with what the file of the part says about where it may be.
pub(crate) fn tip(document: &Document, spatial: &schema::Spatial) -> Result<BallTip, Failure> {
    let here = |name: &str| Place::spatial().field(name);
    let refused =
        |place: Place| move |fault: AccessError| document.error(&place, PartFault::Access(fault));
    let given = [
        ("margin", spatial.margin.is_some()),
        ("keep_out", !spatial.keep_out.is_empty()),
        ("plate", spatial.plate.is_some()),
    ];
    if let Some((name, _)) = given.iter().find(|(_, is)| *is && spatial.ellipsoid.is_some()) {
        return Err(document.error(&here(name), PartFault::FacesOnly { found: name }));
    }
    let mut tip = BallTip::new(0.0).map_err(refused(Place::spatial()))?;
    if let Some(margin) = spatial.margin {
        tip = tip.with_margin(margin.0).map_err(refused(here("margin")))?;
    }
    let boxes = spatial.keep_out.iter().enumerate().map(|(number, given)| {
        let place = here("keep_out").item(number);
        KeepOut::new(given.from.0, given.to.0).map_err(refused(place))
    });
    tip = tip.keeping_out(boxes.collect::<Result<_, _>>()?);
    if let Some(plate) = &spatial.plate {
        let offset = plate.offset.map_or([0.0; 2], |offset| offset.0);
        let plate = Plate::new(plate.pitch.0, offset, plate.travel.0);
        tip = tip.over(plate.map_err(refused(here("plate")))?);
    }
    Ok(tip)
}
