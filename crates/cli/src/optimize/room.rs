//! What tips of fingers on a solid meet.

use clench::optimize::polyhedron::Part;
use clench::screw::Vector;
use clench::shape::{ACCESS_TOLERANCE, AccessibleFacet, BallTip, Facet};

use crate::input::{GivenContact, Solid};
use crate::report::{AccessReport, MeetsReport, SurfaceReport};

/// Points of files are on the surface to a part of its radius; tips may sink in by ten times that.
const ALLOWED: f64 = 1e-5;

/// How much of a part is accessible; none if all of it is.
pub(super) fn surface(part: &Part) -> Option<SurfaceReport> {
    let accessible = part.accessible()?;
    let facets = part.facets().iter().zip(accessible);
    let is_whole = facets.clone().all(|(facet, some)| facet.triangles() == some.triangles());
    let total: f64 = part.facets().iter().map(Facet::area).sum();
    let closed = facets.filter(|(_, some)| some.triangles().is_empty());
    (!is_whole).then(|| SurfaceReport {
        share: accessible.iter().map(AccessibleFacet::area).sum::<f64>() / total,
        tolerance: ACCESS_TOLERANCE * part.solid().enclosing_radius(),
        closed_faces: closed.map(|(facet, _)| facet.faces()[0]).collect(),
    })
}

/// How deep tips may sink in (length).
fn allowed(solid: &Solid) -> f64 {
    2.0 * solid.flatness + ALLOWED * solid.polyhedron.enclosing_radius()
}

/// What the tip of a contact meets beside a solid, if anything.
fn met(solid: &Solid, contact: &GivenContact, tip: &BallTip, radius: f64) -> Option<String> {
    let (touch, tip) = (contact.touch(), tip.with_radius(radius).ok()?);
    let (point, normal) = (touch.point, touch.inward_normal);
    let met = solid.polyhedron.obstruction(point, normal, allowed(solid), &tip)?;
    Some(met.to_string())
}

/// The candidates whose tips meet something, each with a radius.
pub(super) fn obstructed(
    solid: &Solid,
    candidates: &[GivenContact],
    radii: &[f64],
    tip: &BallTip,
) -> Vec<MeetsReport> {
    let meets = |(contact, (candidate, &radius)): (usize, (&GivenContact, &f64))| {
        let meets = met(solid, candidate, tip, radius)?;
        Some(MeetsReport { contact, meets })
    };
    candidates.iter().zip(radii).enumerate().filter_map(meets).collect()
}

/// The given contacts whose tips overlap the part, what is kept out, or each other. They need be
/// over no hole of a plate.
pub(super) fn overlapping(
    solid: &Solid,
    fixed: &[GivenContact],
    radii: &[f64],
    tip: &BallTip,
) -> Vec<MeetsReport> {
    let bare = BallTip::new(0.0).map(|bare| bare.keeping_out(tip.keep_out().to_vec()));
    let mut found = bare.map_or_else(|_| Vec::new(), |bare| obstructed(solid, fixed, radii, &bare));
    let center = |i: usize| -> Vector<3> {
        let touch = fixed[i].touch();
        touch.point - touch.inward_normal * radii[i]
    };
    for contact in 0..fixed.len() {
        for other in 0..contact {
            let distance = (center(contact) - center(other)).norm();
            if distance < radii[contact] + radii[other] - allowed(solid) {
                found.push(MeetsReport { contact, meets: format!("fixed contact {other}") });
            }
        }
    }
    found
}

/// All that is worth a word.
pub(super) fn report(
    surface: Option<SurfaceReport>,
    left_out: &[MeetsReport],
    overlapping: &[MeetsReport],
) -> Option<AccessReport> {
    let (left_out, overlapping) = (left_out.to_vec(), overlapping.to_vec());
    let report = AccessReport { outline: None, surface, left_out, overlapping };
    (!report.is_empty()).then_some(report)
}
