//! Principal stiffnesses with their axes, in the frame of the report.

use clench::metrics::{EquivalentStiffness, Principal, REPEATED};
use clench::screw::Axis;
use serde::Serialize;

use crate::view::{View, components, plain};

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
    /// Whether another one is the same, so that the axis is one of many.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(crate) repeated: bool,
    /// Of the force that moves the part along it and does not turn it.
    #[serde(flatten)]
    pub(crate) axis: AxisReport,
}

/// A principal rotational stiffness.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Rotational {
    pub(crate) value: f64,
    /// Whether another one is the same, so that the axis is one of many.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(crate) repeated: bool,
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
    /// The axis of a rotation of a part of dimension `N`.
    fn of_rotation<const N: usize>(axis: &Axis) -> Self {
        let mut axis_point = components(axis.point);
        axis_point.truncate(N);
        Self { direction: components(axis.direction), axis_point, pitch: plain(axis.pitch) }
    }

    /// The axis of a force, whose direction is one of the plane for a planar part.
    fn of_force<const N: usize>(axis: &Axis) -> Self {
        let mut report = Self::of_rotation::<N>(axis);
        report.direction.truncate(N);
        report
    }
}

impl Translational {
    /// Those of `principal`, written in the frame of the report, ascending.
    pub(super) fn all<const N: usize, const M: usize>(principal: &Principal<N, M>) -> Vec<Self> {
        let (sigma, axes) = (principal.translational().values, principal.wrench_axes());
        let equal = |i: usize| sigma[i] - sigma[i - 1] <= REPEATED * sigma[N - 1];
        let one = |i: usize| Self {
            value: sigma[i],
            repeated: (i > 0 && equal(i)) || (i + 1 < N && equal(i + 1)),
            axis: AxisReport::of_force::<N>(&axes[i]),
        };
        (0..N).map(one).collect()
    }
}

impl Rotational {
    /// Those of `principal`, written in the frame of the report, ascending, with their equivalent
    /// stiffnesses in that of the file.
    pub(super) fn all<const N: usize, const M: usize>(
        principal: &Principal<N, M>,
        rotations: &[EquivalentStiffness<N, M>; M],
        view: &View<N, M>,
    ) -> Vec<Self> {
        let (mu, axes) = (principal.rotational().values, principal.twist_axes());
        let one = |i: usize| {
            let EquivalentStiffness { value, rotation, farthest, multiplicity, .. } = rotations[i];
            let repeated = multiplicity > 1;
            Self {
                value: mu[i],
                repeated,
                axis: AxisReport::of_rotation::<N>(&axes[i]),
                reach: rotations[i].reach,
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
