//! What only the plane or only space knows about a contact: how fingers are curved, and which
//! area of contact follows from it.

use clench::contact::{Curvature, Geometry, Hertz};
use clench::screw::Vector;

use super::fault::ContactFault;
use super::schema::Finger;

/// The plane or space, as far as a contact is concerned.
pub(super) struct Dimension<const N: usize> {
    /// The curvature of a finger; `direction` is that of the file.
    pub(super) curvature:
        fn(&Finger, direction: Option<Vector<N>>) -> Result<Curvature<N>, ContactFault>,
    /// Hertz' law from the effective modulus and the curvatures.
    pub(super) hertz: fn(f64, &Geometry<N>) -> Result<HertzAndAxis<N>, ContactFault>,
}

/// Hertz' law, and the direction in which the area of contact is longest.
type HertzAndAxis<const N: usize> = (Hertz, Vector<N>);

/// The plane.
pub(super) const PLANE: Dimension<2> =
    Dimension { curvature: planar_curvature, hertz: |_, _| Err(ContactFault::PlanarHertz) };

/// Space.
pub(super) const SPACE: Dimension<3> = Dimension { curvature: spatial_curvature, hertz };

fn planar_curvature(
    finger: &Finger,
    _direction: Option<Vector<2>>,
) -> Result<Curvature<2>, ContactFault> {
    match *finger {
        Finger { radius: Some(radius), curvature: None, curvatures: None, direction: None } => {
            Ok(Curvature::round(radius.0))
        }
        Finger { radius: None, curvature: Some(curvature), curvatures: None, direction: None } => {
            // Zero has no sign: a straight finger has the radius infinity.
            Ok(Curvature::round((curvature.0 + 0.0).recip()))
        }
        _ => {
            let expected = "`radius` and `curvature`, in the plane";
            Err(ContactFault::FingerShape { found: found(finger), expected })
        }
    }
}

fn spatial_curvature(
    finger: &Finger,
    direction: Option<Vector<3>>,
) -> Result<Curvature<3>, ContactFault> {
    match (finger, direction) {
        (Finger { radius: Some(radius), curvature: None, curvatures: None, .. }, None) => {
            Ok(Curvature::round(radius.0))
        }
        (Finger { radius: None, curvature: None, curvatures: Some(both), .. }, direction) => {
            match (&both[..], direction) {
                (&[first, second], Some(along)) => {
                    let radii = [first, second].map(|k| (k.0 + 0.0).recip());
                    Ok(Curvature::principal(radii, along))
                }
                (_, Some(_)) => {
                    Err(ContactFault::Curvatures { found: format!("{} of them", both.len()) })
                }
                (_, None) => Err(ContactFault::Curvatures { found: "no `direction`".to_owned() }),
            }
        }
        _ => {
            let expected = "`radius`, and `curvatures` with their `direction`, in space";
            Err(ContactFault::FingerShape { found: found(finger), expected })
        }
    }
}

/// The fields that describe a finger, as they were found.
fn found(finger: &Finger) -> String {
    let fields = [
        ("`radius`", finger.radius.is_some()),
        ("`curvature`", finger.curvature.is_some()),
        ("`curvatures`", finger.curvatures.is_some()),
        ("`direction`", finger.direction.is_some()),
    ];
    super::fault::listed(&fields).unwrap_or_else(|| "none".to_owned())
}

fn hertz(modulus: f64, geometry: &Geometry<3>) -> Result<HertzAndAxis<3>, ContactFault> {
    let law = Hertz::of(modulus, geometry)?;
    Ok((law, geometry.relative_curvature()?.along))
}
