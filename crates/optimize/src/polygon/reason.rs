//! Why no placement holds a part.

use super::scene::Scene;
use crate::OptimizeError;
use crate::search::Matter;

/// Where all normals are parallel up to this, `sigma_min`, of the order of its square, is lost in
/// the rounding of the stiffnesses.
const THIN: f64 = 1e-6;

/// Why a search through all placements found none; `conditions` tells whether placements had to
/// fulfill some beside holding the part.
pub(super) fn nothing(scene: &Scene, matter: Matter, conditions: bool) -> OptimizeError {
    let Matter { fingers, combinations } = matter;
    let sine = scene.largest_sine();
    if sine > 0.0 && sine <= THIN {
        OptimizeError::TooThin { fingers, sine }
    } else if conditions {
        OptimizeError::ConditionsNeverMet { fingers, combinations }
    } else if !scene.normals_balance(fingers) {
        OptimizeError::NormalsNeverBalance { fingers, combinations }
    } else {
        OptimizeError::TorquesNeverBalance { fingers, combinations }
    }
}
