//! What the marks of a picture mean.

use maud::{Markup, html};

use super::typeset::typeset;

/// The marks of the picture of a grasp, or of a placement; only a part that is held has more than
/// fingers.
pub(super) fn grasp(planar: bool, held: bool) -> Markup {
    let fingers = if planar {
        "F: the fingers to scale, thin lines along their inward normals, arrows in proportion to \
         their forces."
    } else {
        "F: the fingers, pressing along their inward normals; in the view that turns round tips \
         are to scale and arrows in proportion to forces; given contacts are green."
    };
    let marks = match (planar, held) {
        (_, false) => "",
        (true, true) => {
            " c: center of compliance, with the principal directions of translation in green, if \
             they differ, and the farthest point on the arc; w: the point that gives way most."
        }
        (false, true) => {
            " c: center; dash-dotted: the axes of the principal rotations, the softest in orange; \
             w: the point that gives way most, and where to."
        }
    };
    html!((fingers)(typeset(marks)))
}

/// What the fingers say under a load.
pub(super) const fn forces(planar: bool) -> &'static str {
    if planar { "F: the forces of the fingers then." } else { "" }
}
