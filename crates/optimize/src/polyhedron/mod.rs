//! Best placements on the faces of a solid.

mod part;
mod touch;

mod fingers;

mod spatial_search;

mod ascent;
mod bound;

mod rating;
mod round;
mod scene;
mod solution;

use clench_screw::Screw;

pub use fingers::{
    FEWEST_CONTACTS, Fingers, MOST_CONTACTS, MOST_FINGERS, ROUNDNESS, fingers, fingers_among,
};
pub use part::Part;
pub use touch::Touch;

/// A motion in words.
pub(crate) fn described(motion: &Screw) -> String {
    let list = |v: clench_screw::Vector<3>| {
        let [x, y, z] = v.to_array().map(|c| if c.abs() < 5e-7 { 0.0 } else { c });
        format!("({x:.4}, {y:.4}, {z:.4})")
    };
    match motion {
        Screw::Zero => "any motion".to_owned(),
        Screw::Free { direction, .. } => format!("a translation along {}", list(*direction)),
        Screw::Axis { axis, .. } => format!(
            "a turn about the axis through {} along {} with the pitch {:.4}",
            list(axis.point),
            list(axis.direction),
            axis.pitch
        ),
    }
}

#[cfg(test)]
mod tests;
