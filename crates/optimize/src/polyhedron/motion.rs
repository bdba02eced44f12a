//! A motion in words.

use clench_screw::{Screw, Vector};

/// A component below this part of the largest is rounding of 0.
const ZERO: f64 = 1e-9;

/// A motion in words, for messages.
pub(crate) fn described(motion: &Screw) -> String {
    match motion {
        Screw::Zero => "any motion".to_owned(),
        Screw::Free { direction, .. } => format!("a translation along {}", list(*direction)),
        Screw::Axis { axis, .. } => {
            let (point, direction) = (list(axis.point), list(axis.direction));
            format!(
                "a turn about the axis through {point} along {direction} with the pitch {:.3e}",
                axis.pitch
            )
        }
    }
}

fn list(vector: Vector<3>) -> String {
    let largest = vector.max_abs();
    let [x, y, z] = vector.to_array().map(|c| if c.abs() <= ZERO * largest { 0.0 } else { c });
    format!("({x:.4e}, {y:.4e}, {z:.4e})")
}
