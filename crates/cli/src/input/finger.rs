//! How the finger of a file is curved.

use clench::contact::Curvature;
use clench::screw::Vector;

use super::fault::{ContactFault, listed};
use super::schema::Finger;

/// The curvature of a finger in the plane.
pub(super) fn planar(finger: &Finger) -> Result<Curvature<2>, ContactFault> {
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

/// The curvature of a finger in space, whose `direction` is that of the file.
pub(super) fn spatial(
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
                    Ok(Curvature::principal_curvatures([first.0, second.0], along))
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
    listed(&fields).unwrap_or_else(|| "none".to_owned())
}
