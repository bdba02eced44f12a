//! Why a placement has no quality to second order, in words.

use clench::metrics::MetricsError;

use super::number::{UnitNames, spot};
use crate::view::components;

/// What the stiffness of a placement in `N` dimensions does not resist.
pub(super) fn missing<const N: usize>(error: &MetricsError, units: UnitNames<'_>) -> String {
    let verb = |value: f64, pushed: &'static str, free: &'static str| {
        if value < 0.0 { pushed } else { free }
    };
    match error {
        MetricsError::TranslationNotHeld { direction, value, .. } => {
            let slides = verb(*value, "is pushed away", "is free to slide");
            let (along, value) = (&components(*direction)[..N], units.stiffness(*value));
            format!("the part {slides} along {}: the stiffness is {value}", spot(along, 1.0))
        }
        MetricsError::RotationNotHeld { axis, value, .. } => {
            let turns = verb(*value, "turns away", "is free to turn");
            let (point, value) = (&components(axis.point)[..N], units.torque(*value));
            let through = format!("{} {}", spot(point, 0.0), units.0.length);
            let about = if N == 2 {
                through
            } else {
                let along = spot(&components(axis.direction), 1.0);
                format!("the axis along {along} through {through}")
            };
            format!("the part {turns} about {about}: the stiffness is {value}")
        }
        other => other.to_string(),
    }
}
