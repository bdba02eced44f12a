//! The numbers of a grasp that holds the part, in the frame of the report.

use clench::metrics::{MetricsError, Principal, Quality, WorstPoint};
use clench::screw::Axis;
use clench::shape::Polygon;
use serde::Serialize;

use super::words::LimitWord;
use crate::held::Metrics;
use crate::view::{View, plain};

/// The principal stiffnesses and their centers, and the quality where there is one.
#[derive(Debug, Serialize)]
pub(crate) struct MetricsReport {
    #[serde(flatten)]
    pub(crate) quality: Option<QualityReport>,
    pub(crate) sigma_min: f64,
    pub(crate) translational: Vec<Translational>,
    pub(crate) rotational: Vec<Rotational>,
    /// In the plane.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) center_of_compliance: Option<Vec<f64>>,
    /// In space: the point about which force and rotation couple symmetrically.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) center: Option<Vec<f64>>,
}

/// The quality of a grasp of an outline.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct QualityReport {
    pub(crate) quality: f64,
    pub(crate) limited_by: LimitWord,
    pub(crate) mu_eq: f64,
    pub(crate) reach: ReachReport,
    /// Principal rotational stiffnesses that repeat make the quality ambiguous in space; in the
    /// plane there is one.
    pub(crate) degenerate: bool,
    pub(crate) quality_rotational: f64,
    pub(crate) worst_point_stiffness: f64,
    pub(crate) worst_point: Vec<f64>,
    pub(crate) worst_corner: usize,
    pub(crate) worst_direction: Vec<f64>,
}

/// A principal translational stiffness.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Translational {
    pub(crate) value: f64,
    pub(crate) direction: Vec<f64>,
}

/// A principal rotational stiffness.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Rotational {
    pub(crate) value: f64,
    #[serde(flatten)]
    pub(crate) axis: AxisReport,
    /// To the corner farthest from the axis, of an outline.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) reach: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) equivalent: Option<f64>,
}

/// The axis of a motion that no force drives.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct AxisReport {
    /// In the plane that of z.
    pub(crate) direction: Vec<f64>,
    /// The point nearest to the frame's origin.
    pub(crate) axis_point: Vec<f64>,
    /// How far the part moves along the axis per turn of one radian.
    pub(crate) pitch: f64,
}

/// The corner farthest from the center of compliance.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ReachReport {
    pub(crate) corner: usize,
    pub(crate) point: Vec<f64>,
    pub(crate) distance: f64,
}

impl MetricsReport {
    /// The report on `metrics`, written in `view`.
    pub(super) fn new<const N: usize, const M: usize>(
        metrics: &Metrics<N, M>,
        view: &View<N, M>,
    ) -> Self {
        let Metrics { principal, quality } = metrics;
        let (center, planar) = (view.point(principal.center()), N == 2);
        let (translational, rotational) = (principal.translational(), principal.rotational());
        let axes = principal.twist_axes();
        let slide = |i: usize| Translational {
            value: translational.values[i],
            direction: view.direction(translational.vectors[i]),
        };
        let turn = |i: usize| Rotational {
            value: rotational.values[i],
            axis: AxisReport::new(&axes[i], view),
            reach: quality.as_ref().map(|quality| quality.reach.distance),
            equivalent: quality.as_ref().map(|quality| quality.mu_eq),
        };
        Self {
            quality: quality.clone(),
            sigma_min: translational.values[0],
            translational: (0..N).map(slide).collect(),
            rotational: (0..M).map(turn).collect(),
            center_of_compliance: planar.then(|| center.clone()),
            center: (!planar).then_some(center),
        }
    }
}

impl QualityReport {
    /// The quality of a grasp of `outline`, and its worst point.
    pub(crate) fn of(
        principal: &Principal<2, 1>,
        outline: &Polygon,
        view: &View<2, 1>,
    ) -> Result<Self, MetricsError> {
        let Quality { value, limited_by, equivalent, reach, .. } = Quality::of(principal, outline);
        let worst = WorstPoint::of(principal, outline)?;
        let corner = |number: usize| view.point(outline.corners()[number]);
        Ok(Self {
            quality: value,
            limited_by: limited_by.into(),
            mu_eq: equivalent,
            reach: ReachReport {
                corner: reach.corner,
                point: corner(reach.corner),
                distance: reach.distance,
            },
            degenerate: false,
            quality_rotational: equivalent,
            worst_point_stiffness: worst.stiffness,
            worst_point: corner(worst.corner),
            worst_corner: worst.corner,
            worst_direction: view.direction(worst.direction),
        })
    }
}

impl AxisReport {
    /// The axis, written in `view`.
    pub(super) fn new<const N: usize, const M: usize>(axis: &Axis, view: &View<N, M>) -> Self {
        let (direction, axis_point) = view.axis(axis);
        Self { direction, axis_point, pitch: plain(axis.pitch) }
    }
}
