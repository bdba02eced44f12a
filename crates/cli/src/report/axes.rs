//! Principal stiffnesses with their axes, in the frame of the report.

use clench::metrics::{EquivalentStiffness, Principal};
use clench::screw::Axis;
use serde::Serialize;

use crate::metrics::Metrics;
use crate::view::{View, plain};

/// The axis of a motion that needs no force, or of a force that turns nothing.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct AxisReport {
    /// Of a rotation in the plane that of z.
    pub(crate) direction: Vec<f64>,
    /// The point nearest to the frame's origin.
    pub(crate) axis_point: Vec<f64>,
    /// Length per rad, or torque per force.
    pub(crate) pitch: f64,
}

/// A principal translational stiffness.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Translational {
    pub(crate) value: f64,
    /// Of the force that moves the part along it and does not turn it.
    #[serde(flatten)]
    pub(crate) axis: AxisReport,
}

/// A principal rotational stiffness.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Rotational {
    pub(crate) value: f64,
    /// Of the rotation that needs no force.
    #[serde(flatten)]
    pub(crate) axis: AxisReport,
    /// From the axis to the point that moves most.
    pub(crate) reach: f64,
    /// How far that point moves per rad.
    pub(crate) deflection: f64,
    pub(crate) farthest_point: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) farthest_corner: Option<usize>,
    pub(crate) equivalent: f64,
    /// Of a repeated stiffness: the rotation that reach, deflection and equivalent are those of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) softest_direction: Option<Vec<f64>>,
}

impl AxisReport {
    /// The axis of a rotation, written in `view`.
    pub(super) fn of_rotation<const N: usize, const M: usize>(
        axis: &Axis,
        view: &View<N, M>,
    ) -> Self {
        let (direction, axis_point) = view.axis(axis);
        Self { direction, axis_point, pitch: plain(axis.pitch) }
    }

    /// The axis of a force, whose direction is one of the plane for a planar part.
    fn of_force<const N: usize, const M: usize>(axis: &Axis, view: &View<N, M>) -> Self {
        let mut report = Self::of_rotation(axis, view);
        report.direction.truncate(N);
        report
    }
}

impl Translational {
    /// Those of `principal`, ascending.
    pub(super) fn all<const N: usize, const M: usize>(
        principal: &Principal<N, M>,
        view: &View<N, M>,
    ) -> Vec<Self> {
        let found = principal.translational().values.into_iter().zip(principal.wrench_axes());
        found.map(|(value, axis)| Self { value, axis: AxisReport::of_force(&axis, view) }).collect()
    }
}

impl Rotational {
    /// Those of `metrics`, ascending.
    pub(super) fn all<const N: usize, const M: usize>(
        metrics: &Metrics<N, M>,
        view: &View<N, M>,
    ) -> Vec<Self> {
        let (values, axes) =
            (metrics.principal.rotational().values, metrics.principal.twist_axes());
        let rotations = &metrics.quality.rotations;
        let one = |i: usize| {
            let EquivalentStiffness { value, rotation, farthest, multiplicity, .. } = rotations[i];
            let repeated = multiplicity > 1;
            Self {
                value: values[i],
                axis: AxisReport::of_rotation(&axes[i], view),
                reach: rotations[i].reach(),
                deflection: farthest.value,
                farthest_point: view.point(farthest.point),
                farthest_corner: farthest.corner,
                equivalent: value,
                softest_direction: repeated.then(|| view.turning(rotation)),
            }
        };
        (0..M).map(one).collect()
    }
}
