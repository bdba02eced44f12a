//! The quality of a grasp, and its worst point, in the frame of the report.

use clench::shape::Farthest;
use serde::Serialize;

use super::words::LimitWord;
use crate::metrics::Metrics;
use crate::view::View;

/// What a grasp is worth.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct QualityReport {
    pub(crate) quality: f64,
    /// What is proved of it, if that is less.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) quality_at_least: Option<f64>,
    pub(crate) limited_by: LimitWord,
    pub(crate) sigma_min: f64,
    /// The least of all rotations.
    pub(crate) mu_eq: f64,
    /// Whether principal rotational stiffnesses are repeated; in the plane there is one.
    pub(crate) degenerate: bool,
    pub(crate) quality_rotational: f64,
    /// What is proved of it, if that is less.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) quality_rotational_at_least: Option<f64>,
    pub(crate) worst_point_stiffness: f64,
    /// What is proved of it, if that is less.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) worst_point_stiffness_at_least: Option<f64>,
    pub(crate) worst_point: Vec<f64>,
    /// None on a smooth part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) worst_corner: Option<usize>,
    pub(crate) worst_direction: Vec<f64>,
}

/// The point farthest from the center of compliance.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ReachReport {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) corner: Option<usize>,
    pub(crate) point: Vec<f64>,
    pub(crate) distance: f64,
}

impl QualityReport {
    /// The quality by `metrics`, written in `view`.
    pub(super) fn new<const N: usize, const M: usize>(
        metrics: &Metrics<N, M>,
        view: &View<N, M>,
    ) -> Self {
        let Metrics { quality, softest, worst, .. } = metrics;
        Self {
            quality: quality.value,
            quality_at_least: unproved(quality.value, quality.at_least()),
            limited_by: quality.limited_by.into(),
            sigma_min: quality.translational,
            mu_eq: quality.equivalent(),
            degenerate: quality.degenerate,
            quality_rotational: softest.value,
            quality_rotational_at_least: unproved(softest.value, softest.at_least),
            worst_point_stiffness: worst.stiffness,
            worst_point_stiffness_at_least: unproved(worst.stiffness, worst.at_least),
            worst_point: view.point(worst.point),
            worst_corner: worst.corner,
            worst_direction: view.direction(worst.direction),
        }
    }
}

impl ReachReport {
    /// The reach to the farthest point of a planar part.
    pub(super) fn new(farthest: &Farthest<2>, view: &View<2, 1>) -> Self {
        let (corner, distance) = (farthest.corner, farthest.value);
        Self { corner, point: view.point(farthest.point), distance }
    }
}

/// The proved bound of a value, unless it proves the value.
fn unproved(value: f64, at_least: f64) -> Option<f64> {
    (at_least < value).then_some(at_least)
}
