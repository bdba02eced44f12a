//! The numbers of a grasp that holds the part, in the frame of the report.

use clench::screw::{Screw, Twist, Vector, spatial};
use serde::Serialize;

use super::words::LimitWord;
use crate::analyze::{Metrics, OutlineQuality};
use crate::view::View;

/// The principal stiffnesses and their centers, and the quality where there is one.
#[derive(Debug, Serialize)]
pub(crate) struct MetricsReport {
    #[serde(flatten)]
    pub(crate) quality: Option<QualityReport>,
    pub(crate) translational: Vec<Translational>,
    pub(crate) rotational: Vec<Rotational>,
    /// In the plane.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) center_of_compliance: Option<Vec<f64>>,
    /// In space: the center of compliance, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) center: Option<Vec<f64>>,
}

/// The quality of a grasp of an outline.
#[derive(Debug, Serialize)]
pub(crate) struct QualityReport {
    pub(crate) quality: f64,
    pub(crate) limited_by: LimitWord,
    pub(crate) sigma_min: f64,
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
    pub(crate) direction: Vec<f64>,
    /// The point of the axis nearest to the center.
    pub(crate) axis_point: Vec<f64>,
    /// How far the part moves along the axis per turn of one radian, when no force acts.
    pub(crate) pitch: f64,
    /// To the corner farthest from the axis, of an outline.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) reach: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) equivalent: Option<f64>,
}

/// The corner farthest from the center of compliance.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ReachReport {
    pub(crate) corner: usize,
    pub(crate) point: Vec<f64>,
    pub(crate) distance: f64,
}

/// The axis about which a part turns.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    pub(super) direction: Vec<f64>,
    /// The point nearest to where the motion was given.
    pub(super) point: Vec<f64>,
    pub(super) pitch: f64,
}

impl MetricsReport {
    /// The report on `metrics`, written in `view`.
    pub(super) fn new<const N: usize, const M: usize>(
        metrics: &Metrics<N, M>,
        view: &View<N, M>,
    ) -> Self {
        let principal = &metrics.principal;
        let (center, planar) = (principal.center(), N == 2);
        let quality = metrics.quality.as_ref();
        let translational = principal.translational();
        let rotational = principal.rotational();
        let turn = |i: usize| {
            let twist = principal.forceless_twist(rotational.vectors[i]);
            let at_center = Twist { linear: twist.velocity_at(center), angular: twist.angular };
            let axis = Axis::of(&at_center, center, view);
            Rotational {
                value: rotational.values[i],
                direction: axis.direction,
                axis_point: axis.point,
                pitch: axis.pitch,
                reach: quality.map(|q| q.quality.reach.distance),
                equivalent: quality.map(|q| q.quality.equivalent),
            }
        };
        Self {
            quality: quality.map(|quality| QualityReport::new(quality, view)),
            translational: (0..N)
                .map(|i| Translational {
                    value: translational.values[i],
                    direction: view.direction(translational.vectors[i]),
                })
                .collect(),
            rotational: (0..M).map(turn).collect(),
            center_of_compliance: planar.then(|| view.point(center)),
            center: (!planar).then(|| view.point(center)),
        }
    }
}

impl QualityReport {
    fn new<const N: usize, const M: usize>(found: &OutlineQuality, view: &View<N, M>) -> Self {
        let OutlineQuality { quality, farthest, worst, worst_point } = found;
        // Of the plane, where alone outlines are.
        let lifted = |v: Vector<2>| Vector::from_fn(|i| if i < 2 { v[i] } else { 0.0 });
        Self {
            quality: quality.value,
            limited_by: quality.limited_by.into(),
            sigma_min: quality.translational,
            mu_eq: quality.equivalent,
            reach: ReachReport {
                corner: quality.reach.corner,
                point: view.point(lifted(*farthest)),
                distance: quality.reach.distance,
            },
            degenerate: false,
            quality_rotational: quality.equivalent,
            worst_point_stiffness: worst.stiffness,
            worst_point: view.point(lifted(*worst_point)),
            worst_corner: worst.corner,
            worst_direction: view.direction(lifted(worst.direction)),
        }
    }
}

impl Axis {
    /// The axis of the motion `twist` about `center`; in the plane it goes through the center of
    /// compliance, since nothing else is about a rotation that needs no force.
    pub(super) fn of<const N: usize, const M: usize>(
        twist: &Twist<N, M>,
        center: Vector<N>,
        view: &View<N, M>,
    ) -> Self {
        let planar =
            || Self { direction: vec![0.0, 0.0, 1.0], point: view.point(center), pitch: 0.0 };
        if M < 3 {
            return planar();
        }
        let spatial = spatial::Twist {
            linear: Vector::from_fn(|i| twist.linear[i]),
            angular: Vector::from_fn(|i| twist.angular[i]),
        };
        let Screw::Axis { direction, point, pitch, .. } = spatial.screw() else { return planar() };
        let from_center = Vector::<N>::from_fn(|i| point[i]);
        Self {
            direction: view.turning(Vector::from_fn(|i| direction[i])),
            point: view.point(center + from_center),
            pitch: pitch + 0.0,
        }
    }
}
