//! The report on a grasp.

use clench::contact::{Law, Order};
use clench::screw::Stiffness;
use clench::stiffness::Equilibrium;
use serde::Serialize;

use super::case_verdict::OverallVerdict;
use super::drawing::DrawingReport;
use super::load_case::LoadCaseReport;
use super::measures::{InPlane, InSpace, MetricsReport};
use super::needed::NeededReport;
use super::number::{UnitNames, in_plane_a_number};
use super::robustness::RobustnessReport;
use super::verdict::{FreeMotion, Verdict};
use super::words::{OrderWord, StabilityWord};
use crate::analyze::Analysis;
use crate::input::PieceKind;
use crate::input::schema::Units;
use crate::view::{Rows, plain};

/// A share of the preload this small is rounding: the forces that balance follow from products
/// of a few rounded numbers.
pub(crate) const NO_SHARE: f64 = 1e-12;

/// All that `analyze` reports, in the frame asked for.
#[derive(Debug, Serialize)]
pub(crate) struct AnalysisReport<'a> {
    pub(crate) dimension: usize,
    pub(crate) units: &'a Units,
    /// Where the part is from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) drawing: Option<DrawingReport>,
    pub(crate) frame: FrameReport,
    pub(crate) contacts: Vec<AnalyzedContact>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) loads: Vec<LoadReport>,
    pub(crate) order: OrderWord,
    pub(crate) stiffness: Rows,
    /// What does not depend on preloads, curvatures and loads.
    pub(crate) stiffness_first_order: Rows,
    /// What they add.
    pub(crate) stiffness_preload: Rows,
    pub(crate) equilibrium: EquilibriumReport,
    pub(crate) stability: StabilityWord,
    #[serde(flatten)]
    pub(crate) metrics: Option<MetricsReport>,
    /// If it is asked for, and the part is held.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) robustness: Option<RobustnessReport>,
    /// None in the file, or none that means anything, if the part is not held.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) load_cases: Vec<LoadCaseReport>,
    /// On the load cases, if the file has any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) verdict: Option<OverallVerdict>,
    /// For the load cases.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) needed_preloads: Option<NeededReport>,
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
#[derive(Clone, Debug, Serialize)]
pub(crate) struct FrameReport {
    pub(crate) origin: Vec<f64>,
    /// In the plane, counter-clockwise [rad].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) angle: Option<f64>,
    /// In space, axis times angle [rad].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) rotation_vector: Option<Vec<f64>>,
}

/// A contact as it was understood.
#[derive(Debug, Serialize)]
pub(crate) struct AnalyzedContact {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) edge: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) face: Option<usize>,
    pub(crate) point: Vec<f64>,
    pub(crate) inward_normal: Vec<f64>,
    pub(crate) overlap: f64,
    /// The slope of the law at rest.
    pub(crate) stiffness: f64,
    pub(crate) preload: f64,
    /// Of the balanced preload whose least share is largest.
    pub(crate) balanced_share: Option<f64>,
    /// The area of contact by Hertz' law.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) contact_ellipse: Option<ContactEllipse>,
    /// Of the area of contact along a line.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) half_width: Option<f64>,
    /// In the middle of that area.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) peak_pressure: Option<f64>,
}

/// The area of a Hertz contact.
#[derive(Debug, Serialize)]
pub(crate) struct ContactEllipse {
    /// The longer one first.
    pub(crate) semi_axes: [f64; 2],
    /// Of the first, in space.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) direction: Option<Vec<f64>>,
    /// In the middle.
    pub(crate) peak_pressure: f64,
}

/// A dead load.
#[derive(Debug, Serialize)]
pub(crate) struct LoadReport {
    pub(crate) point: Vec<f64>,
    pub(crate) force: Vec<f64>,
}

/// Whether preloads and loads balance.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct EquilibriumReport {
    pub(crate) holds: bool,
    pub(crate) residual_force: Vec<f64>,
    /// About the frame's origin.
    #[serde(serialize_with = "in_plane_a_number")]
    pub(crate) residual_torque: Vec<f64>,
    /// The residual force relative to the total of preloads and loads, 0 without any.
    pub(crate) relative_force: f64,
    /// The residual torque about the contacts' centroid, relative to the total preload times the
    /// grasp's length, the distance of the farthest contact from there, plus each load times its
    /// own distance.
    pub(crate) relative_torque: f64,
}

impl<'a> AnalysisReport<'a> {
    /// The report on the grasp of a planar part.
    pub(crate) fn planar(analysis: &Analysis<'a, 2, 1>) -> Self {
        let mut report = Self::new(analysis);
        if let (Ok(metrics), Some(numbers)) = (&analysis.metrics, &mut report.metrics) {
            numbers.in_plane = Some(InPlane::new(metrics, &analysis.view));
        }
        report
    }

    /// The report on the grasp of a spatial part.
    pub(crate) fn spatial(analysis: &Analysis<'a, 3, 3>) -> Self {
        let mut report = Self::new(analysis);
        if let (Ok(metrics), Some(numbers)) = (&analysis.metrics, &mut report.metrics) {
            let principal = metrics.principal.in_frame(analysis.view.frame());
            numbers.in_space = Some(InSpace::new(&principal));
        }
        for (contact, found) in analysis.grasp.contacts().iter().zip(&mut report.contacts) {
            let curvature = contact.overlap().geometry().relative_curvature();
            if let (Some(area), Ok(curvature)) = (&mut found.contact_ellipse, curvature) {
                area.direction = Some(analysis.view.direction(curvature.along));
            }
        }
        report
    }

    /// All but what only plane or space have.
    fn new<const N: usize, const M: usize>(analysis: &Analysis<'a, N, M>) -> Self {
        let grasp = analysis.grasp;
        let verdict = Verdict::on(analysis);
        let load_cases = LoadCaseReport::all(analysis);
        let cases = load_cases.iter().enumerate();
        let of_cases =
            cases.flat_map(|(i, case)| case.warnings(i, analysis.size, UnitNames(analysis.units)));
        let robustness = RobustnessReport::new(analysis);
        let units = UnitNames(analysis.units);
        let of_tolerances = robustness.as_ref().and_then(|r| r.warning(analysis.size, units));
        let warnings = verdict.warnings.into_iter().chain(of_cases).chain(of_tolerances).collect();
        let preload = |origin| grasp.preload_stiffness(origin);
        let formed = |order| rows(&analysis.stiffness(|origin| grasp.stiffness(origin, order)));
        Self {
            drawing: None,
            dimension: N,
            units: analysis.units,
            frame: FrameReport::new(analysis),
            contacts: contacts(analysis),
            loads: loads(analysis),
            order: analysis.order.into(),
            stiffness: formed(analysis.order),
            stiffness_first_order: formed(Order::First),
            stiffness_preload: rows(&analysis.stiffness(preload)),
            equilibrium: equilibrium(analysis),
            stability: analysis.classes.grasp.into(),
            metrics: analysis.metrics.as_ref().ok().map(|m| MetricsReport::new(m, &analysis.view)),
            verdict: OverallVerdict::on(
                &load_cases,
                analysis.unanswered,
                verdict.reason.as_deref(),
            ),
            needed_preloads: NeededReport::new(analysis, &load_cases),
            robustness,
            load_cases,
            force_closure: analysis.preloads.force_closure,
            preload_margin: analysis.preloads.best.as_ref().map(|best| plain(best.margin)),
            reason: verdict.reason,
            free_motion: verdict.free_motion,
            pulling_contacts: verdict.pulling_contacts,
            warnings,
            size: analysis.size,
        }
    }
}

impl FrameReport {
    /// Whether it is the frame of the file.
    pub(super) fn is_of_file(&self) -> bool {
        let rotation = self.rotation_vector.iter().flatten().chain(&self.angle);
        self.origin.iter().chain(rotation).all(|number| number.abs() <= 0.0)
    }

    fn new<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> Self {
        let (origin, rotation) = (analysis.view.origin().to_vec(), analysis.view.rotation());
        match rotation {
            [angle] => Self { origin, angle: Some(*angle), rotation_vector: None },
            _ => Self { origin, angle: None, rotation_vector: Some(rotation.to_vec()) },
        }
    }
}

fn rows<const N: usize, const M: usize>(stiffness: &Stiffness<N, M>) -> Rows {
    let row = |i| (0..N + M).map(|j| plain(stiffness.entry(i, j))).collect();
    (0..N + M).map(row).collect()
}

fn contacts<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> Vec<AnalyzedContact> {
    let shares = analysis.preloads.best.as_ref().map(|best| &best.shares);
    let contacts = analysis.grasp.contacts().iter().zip(analysis.pieces).enumerate();
    contacts
        .map(|(i, (contact, piece))| {
            let on = |wanted| piece.filter(|piece| piece.kind == wanted).map(|piece| piece.number);
            let overlap = contact.overlap();
            let line = match contact.law() {
                Law::Line(line) => Some(line),
                _ => None,
            };
            AnalyzedContact {
                edge: on(PieceKind::Edge),
                face: on(PieceKind::Face),
                point: analysis.view.point(overlap.point()),
                inward_normal: analysis.view.direction(overlap.inward_normal()),
                overlap: overlap.depth(),
                stiffness: contact.slope(),
                preload: contact.preload(),
                balanced_share: shares.map(|shares| plain(shares[i])),
                contact_ellipse: match contact.law() {
                    Law::Hertz(law) => Some(ContactEllipse {
                        semi_axes: law.semi_axes(overlap.depth()),
                        direction: None,
                        peak_pressure: law.peak_pressure(overlap.depth()),
                    }),
                    _ => None,
                },
                half_width: line.map(|line| line.half_width(contact.preload())),
                peak_pressure: line.map(|line| line.peak_pressure(contact.preload())),
            }
        })
        .collect()
}

fn loads<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> Vec<LoadReport> {
    let view = &analysis.view;
    let loads = analysis.grasp.loads().iter();
    loads
        .map(|load| LoadReport { point: view.point(load.point), force: view.direction(load.force) })
        .collect()
}

fn equilibrium<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> EquilibriumReport {
    let view = &analysis.view;
    let about = analysis.grasp.net_wrench(view.frame().origin());
    let Equilibrium { holds, relative_force, relative_torque, .. } = analysis.equilibrium;
    EquilibriumReport {
        holds,
        residual_force: view.direction(about.force),
        residual_torque: view.turning(about.torque),
        relative_force,
        relative_torque,
    }
}
