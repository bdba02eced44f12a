//! Where the tips of fingers may be beside a part.

use clench::shape::{AccessError, BallTip, DiscTip, KeepOut, Plate, Polygon};

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
    if let Some(given) = &spatial.plate {
        tip = tip.over(plate(given).map_err(refused(here("plate")))?);
    }
    Ok(tip)
}

/// The tip of a finger of this radius on an outline, with what the file of the part says about
/// where it may be.
pub(crate) fn disc_tip(
    document: &Document,
    planar: &schema::Planar,
    radius: f64,
) -> Result<DiscTip, Failure> {
    let here = |name: &str| Place::planar().field(name);
    let refused =
        |place: Place| move |fault: AccessError| document.error(&place, PartFault::Access(fault));
    let regions = planar.keep_out.iter().enumerate().map(|(number, corners)| {
        let corners: Vec<[f64; 2]> = corners.iter().map(|corner| corner.0).collect();
        let place = here("keep_out").item(number);
        Polygon::new(&corners).map_err(|fault| document.error(&place, PartFault::Outline(fault)))
    });
    let mut tip = DiscTip::new(radius).map_err(refused(Place::planar()))?;
    tip = tip.keeping_out(regions.collect::<Result<_, _>>()?);
    if let Some(given) = &planar.plate {
        tip = tip.over(plate(given).map_err(refused(here("plate")))?);
    }
    Ok(tip)
}

fn plate(given: &schema::ModularPlate) -> Result<Plate, AccessError> {
    let offset = given.offset.map_or([0.0; 2], |offset| offset.0);
    Plate::new(given.pitch.0, offset, given.travel.0)
}
