//! The report on a grasp.

use clench::screw::Vector;
use clench::stiffness::Equilibrium;
use serde::Serialize;

use super::verdict::{free, pulling, reason, warnings};
use super::words::{LimitWord, OrderWord, StabilityWord};
use crate::analyze::{Analysis, Metrics};
use crate::input::schema::Units;

/// A share of the preload this small is rounding: the forces that balance follow from products
/// of a few rounded numbers.
pub(crate) const NO_SHARE: f64 = 1e-12;

/// All that `analyze` reports, in the frame asked for.
#[derive(Debug, Serialize)]
pub(crate) struct AnalysisReport<'a> {
    pub(crate) dimension: u8,
    pub(crate) units: &'a Units,
    pub(crate) frame: FrameReport,
    pub(crate) contacts: Vec<AnalyzedContact>,
    pub(crate) order: OrderWord,
    pub(crate) stiffness: [[f64; 3]; 3],
    pub(crate) equilibrium: EquilibriumReport,
    pub(crate) stability: StabilityWord,
    #[serde(flatten)]
    pub(crate) metrics: Option<MetricsReport>,
    pub(crate) force_closure: bool,
    /// `t*`, the least share of the balanced preload whose least share is largest.
    pub(crate) preload_margin: Option<f64>,
    /// Why there is no quality, or why the fingers cannot hold the part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) reason: Option<String>,
    /// The motion that costs no energy, or releases some.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) free_motion: Option<FreeMotion>,
    /// The contacts that would have to pull.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) pulling_contacts: Vec<usize>,
    pub(crate) warnings: Vec<String>,
    /// The size of the part, for the text.
    #[serde(skip)]
    pub(crate) size: f64,
}

/// The frame that a report is written in, seen from that of the file.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct FrameReport {
    pub(crate) origin: [f64; 2],
    /// Counter-clockwise [rad].
    pub(crate) angle: f64,
}

/// A contact as it was understood.
#[derive(Debug, Serialize)]
pub(crate) struct AnalyzedContact {
    pub(crate) edge: usize,
    pub(crate) point: [f64; 2],
    pub(crate) inward_normal: [f64; 2],
    /// The slope of the law at rest.
    pub(crate) stiffness: f64,
    pub(crate) preload: f64,
    /// Of the balanced preload whose least share is largest.
    pub(crate) balanced_share: Option<f64>,
}

/// Whether the preloads balance.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct EquilibriumReport {
    pub(crate) holds: bool,
    pub(crate) residual_force: [f64; 2],
    /// About the frame's origin.
    pub(crate) residual_torque: f64,
    /// The residual force relative to the total preload, 0 without one.
    pub(crate) relative_force: f64,
    /// The residual torque about the contacts' centroid, relative to the total preload times the
    /// distance of the farthest contact from there.
    pub(crate) relative_torque: f64,
}

/// The numbers that a grasp has if it holds the part.
#[derive(Debug, Serialize)]
pub(crate) struct MetricsReport {
    pub(crate) quality: f64,
    pub(crate) limited_by: LimitWord,
    pub(crate) sigma_min: f64,
    pub(crate) mu_eq: f64,
    pub(crate) translational: [Translational; 2],
    pub(crate) rotational: [Rotational; 1],
    pub(crate) center_of_compliance: [f64; 2],
    pub(crate) reach: ReachReport,
    /// Principal rotational stiffnesses that repeat make the quality ambiguous in space; in the
    /// plane there is one.
    pub(crate) degenerate: bool,
    pub(crate) quality_rotational: f64,
    pub(crate) worst_point_stiffness: f64,
    pub(crate) worst_point: [f64; 2],
    pub(crate) worst_corner: usize,
    pub(crate) worst_direction: [f64; 2],
}

/// A principal translational stiffness.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Translational {
    pub(crate) value: f64,
    pub(crate) direction: [f64; 2],
}

/// A principal rotational stiffness.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Rotational {
    pub(crate) value: f64,
    pub(crate) direction: [f64; 3],
    pub(crate) axis_point: [f64; 2],
    pub(crate) pitch: f64,
    pub(crate) reach: f64,
    pub(crate) equivalent: f64,
}

/// The corner farthest from the center of compliance.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct ReachReport {
    pub(crate) corner: usize,
    pub(crate) point: [f64; 2],
    pub(crate) distance: f64,
}

/// What the fingers do not resist.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub(crate) enum FreeMotion {
    Translation { direction: [f64; 2] },
    Rotation { center: [f64; 2] },
}

impl<'a> AnalysisReport<'a> {
    /// The report on `analysis`.
    pub(crate) fn new(analysis: &Analysis<'a>) -> Self {
        let size = analysis.part.outline().enclosing_circle().radius;
        let pulling_contacts = pulling(analysis);
        let free_motion = analysis.metrics.as_ref().err().and_then(|e| free(analysis, e));
        let stiffness = analysis.stiffness();
        Self {
            dimension: 2,
            units: analysis.units,
            frame: FrameReport { origin: analysis.frame.origin, angle: analysis.frame.angle },
            contacts: contacts(analysis),
            order: analysis.order.into(),
            stiffness: [0, 1, 2].map(|i| [0, 1, 2].map(|j| plain(stiffness.entry(i, j)))),
            equilibrium: equilibrium(analysis),
            stability: analysis.stability.into(),
            metrics: analysis.metrics.as_ref().ok().map(|m| metrics(analysis, m)),
            force_closure: analysis.preloads.force_closure,
            preload_margin: analysis.preloads.best.as_ref().map(|best| plain(best.margin)),
            reason: reason(analysis, free_motion.as_ref(), &pulling_contacts, size),
            free_motion,
            pulling_contacts,
            warnings: warnings(analysis),
            size,
        }
    }
}

/// Zero without a sign.
pub(crate) fn plain(value: f64) -> f64 {
    value + 0.0
}

/// A point in the frame of the report.
pub(super) fn point(analysis: &Analysis<'_>, point: Vector<2>) -> [f64; 2] {
    analysis.frame.frame().point_in_frame(point).to_array().map(plain)
}

/// A direction in the frame of the report.
pub(super) fn direction(analysis: &Analysis<'_>, direction: Vector<2>) -> [f64; 2] {
    analysis.frame.frame().direction_in_frame(direction).to_array().map(plain)
}

fn contacts(analysis: &Analysis<'_>) -> Vec<AnalyzedContact> {
    let shares = analysis.preloads.best.as_ref().map(|best| &best.shares);
    let contacts = analysis.grasp.contacts().iter().zip(analysis.edges).enumerate();
    contacts
        .map(|(i, (contact, &edge))| AnalyzedContact {
            edge,
            point: point(analysis, contact.overlap().point()),
            inward_normal: direction(analysis, contact.overlap().inward_normal()),
            stiffness: contact.slope(),
            preload: contact.preload(),
            balanced_share: shares.map(|shares| plain(shares[i])),
        })
        .collect()
}

fn equilibrium(analysis: &Analysis<'_>) -> EquilibriumReport {
    let about = analysis.grasp.net_wrench(analysis.frame.origin.into());
    let Equilibrium { holds, relative_force, relative_torque, .. } = analysis.equilibrium;
    EquilibriumReport {
        holds,
        residual_force: direction(analysis, about.force),
        residual_torque: plain(about.torque[0]),
        relative_force,
        relative_torque,
    }
}

fn metrics(analysis: &Analysis<'_>, metrics: &Metrics) -> MetricsReport {
    let Metrics { principal, quality, worst } = metrics;
    let corner = |number: usize| point(analysis, analysis.part.outline().corners()[number]);
    let translational = principal.translational();
    let center = point(analysis, principal.center());
    MetricsReport {
        quality: quality.value,
        limited_by: quality.limited_by.into(),
        sigma_min: quality.translational,
        mu_eq: quality.equivalent,
        translational: [0, 1].map(|i| Translational {
            value: translational.values[i],
            direction: direction(analysis, translational.vectors[i]),
        }),
        rotational: [Rotational {
            value: principal.rotational().values[0],
            direction: [0.0, 0.0, 1.0],
            axis_point: center,
            pitch: 0.0,
            reach: quality.reach.distance,
            equivalent: quality.equivalent,
        }],
        center_of_compliance: center,
        reach: ReachReport {
            corner: quality.reach.corner,
            point: corner(quality.reach.corner),
            distance: quality.reach.distance,
        },
        degenerate: false,
        quality_rotational: quality.equivalent,
        worst_point_stiffness: worst.stiffness,
        worst_point: corner(worst.corner),
        worst_corner: worst.corner,
        worst_direction: direction(analysis, worst.direction),
    }
}
