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
                "a turn about the axis through {point} along {direction} with the pitch {}",
                digits(if axis.pitch.abs() <= ZERO * axis.point.max_abs().max(1.0) {
                    0.0
                } else {
                    axis.pitch
                })
            )
        }
    }
}

fn list(vector: Vector<3>) -> String {
    let largest = vector.max_abs();
    let [x, y, z] = vector.to_array().map(|c| if c.abs() <= ZERO * largest { 0.0 } else { c });
    format!("({}, {}, {})", digits(x), digits(y), digits(z))
}

/// A number with four digits.
fn digits(value: f64) -> String {
    let size = value.abs();
    if size > 0.0 && !(1e-3..1e5).contains(&size) {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
