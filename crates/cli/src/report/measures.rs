//! The numbers of a grasp that holds the part, in the frame of the report.

use clench::metrics::Principal;
use clench::screw::Vector;
use serde::Serialize;

use super::axes::{Rotational, Translational};
use super::quality::{QualityReport, ReachReport};
use crate::metrics::Metrics;
use crate::view::{Rows, View, components, rows};

/// The quality, the principal stiffnesses, and what else does not depend on the frame.
#[derive(Debug, Serialize)]
pub(crate) struct MetricsReport {
    #[serde(flatten)]
    pub(crate) quality: QualityReport,
    pub(crate) translational: Vec<Translational>,
    pub(crate) rotational: Vec<Rotational>,
    /// In space some grasps have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) center_of_compliance: Option<Vec<f64>>,
    #[serde(flatten)]
    pub(crate) in_plane: Option<InPlane>,
    #[serde(flatten)]
    pub(crate) in_space: Option<InSpace>,
    /// `K_V`.
    pub(crate) restricted_stiffness: Rows,
    /// `C_W`.
    pub(crate) translational_compliance: Rows,
    /// `P_1` about the frame's origin.
    pub(crate) twist_map: Rows,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) energy_ellipsoids: Option<EnergyEllipsoids>,
}

/// What only planar parts have.
#[derive(Debug, Serialize)]
pub(crate) struct InPlane {
    pub(crate) reach: ReachReport,
    /// Of a report in another frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) center_of_compliance_in_file_frame: Option<Vec<f64>>,
}

/// What only spatial parts have.
#[derive(Debug, Serialize)]
pub(crate) struct InSpace {
    /// The point about which force and rotation couple symmetrically.
    pub(crate) center: Vec<f64>,
    /// Whether it is the center of compliance.
    pub(crate) true_center_exists: bool,
    pub(crate) loncaric_center_of_stiffness: Vec<f64>,
    pub(crate) loncaric_center_of_compliance: Vec<f64>,
    /// `P_1` about the center.
    pub(crate) pitch_tensor: Rows,
}

/// Semi-axes of the ellipsoids of unit energy, in the order of the principal stiffnesses.
#[derive(Debug, Serialize)]
pub(crate) struct EnergyEllipsoids {
    pub(crate) displacement: SemiAxes,
    pub(crate) wrench: SemiAxes,
}

/// What of an ellipsoid does not depend on the frame.
#[derive(Debug, Serialize)]
pub(crate) struct SemiAxes {
    pub(crate) section: Vec<f64>,
    pub(crate) projection: Vec<f64>,
}

impl MetricsReport {
    /// The report on `metrics`, written in `view`, but for what only plane or space have.
    pub(super) fn new<const N: usize, const M: usize>(
        metrics: &Metrics<N, M>,
        view: &View<N, M>,
    ) -> Self {
        let principal = &metrics.principal.in_frame(view.frame());
        Self {
            quality: QualityReport::new(metrics, view),
            translational: Translational::all(principal),
            rotational: Rotational::all(principal, &metrics.quality.rotations, view),
            center_of_compliance: principal.center_of_compliance().map(components),
            in_plane: None,
            in_space: None,
            restricted_stiffness: rows(principal.restricted_stiffness()),
            translational_compliance: rows(principal.translational_compliance()),
            twist_map: rows(&principal.twist_map()),
            energy_ellipsoids: EnergyEllipsoids::new(principal),
        }
    }
}

impl InPlane {
    /// What `metrics` of a planar part say besides.
    pub(super) fn new(metrics: &Metrics<2, 1>, view: &View<2, 1>) -> Self {
        let center = metrics.principal.center();
        let [rotation] = &metrics.quality.rotations;
        Self {
            reach: ReachReport::new(&rotation.farthest, view),
            center_of_compliance_in_file_frame: (!view.is_of_file()).then(|| components(center)),
        }
    }
}

impl InSpace {
    /// What `principal` says besides, written in the frame of the report.
    pub(super) fn new(principal: &Principal<3, 3>) -> Self {
        Self {
            center: components(principal.center()),
            true_center_exists: principal.center_of_compliance().is_some(),
            loncaric_center_of_stiffness: components(principal.loncaric_center_of_stiffness()),
            loncaric_center_of_compliance: components(principal.loncaric_center_of_compliance()),
            pitch_tensor: rows(&principal.pitch_tensor()),
        }
    }
}

impl EnergyEllipsoids {
    /// Those of `principal`; the sections are at no rotation and no force, so that none is empty.
    fn new<const N: usize, const M: usize>(principal: &Principal<N, M>) -> Option<Self> {
        let translations = principal.displacement_section(Vector::ZERO)?;
        let torques = principal.wrench_section(Vector::ZERO)?;
        Some(Self {
            displacement: SemiAxes {
                section: translations.semi_axes.to_vec(),
                projection: principal.displacement_projection().semi_axes.to_vec(),
            },
            wrench: SemiAxes {
                section: torques.semi_axes.to_vec(),
                projection: principal.wrench_projection().semi_axes.to_vec(),
            },
        })
    }
}
