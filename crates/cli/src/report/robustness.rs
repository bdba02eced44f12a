//! The report on how the measures change with the contacts, in the frame of the report.

use serde::Serialize;

use super::number::UnitNames;
use crate::analyze::Analysis;
use crate::input::Tolerance;
use crate::robustness::{Measure, Robust, Slope, Slopes};
use crate::view::{View, plain};

/// How the measures change with the contacts.
#[derive(Debug, Serialize)]
pub(crate) struct RobustnessReport {
    pub(crate) contacts: Vec<Freedoms>,
    pub(crate) quality: MeasureReport,
    pub(crate) quality_rotational: MeasureReport,
    pub(crate) worst_point_stiffness: MeasureReport,
}

/// How a contact can change.
#[derive(Debug, Serialize)]
pub(crate) struct Freedoms {
    /// Along the boundary: unit vectors, one in the plane, two in space.
    pub(crate) directions: Vec<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) tolerance: Option<ToleranceReport>,
}

/// By how much a contact may be off.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct ToleranceReport {
    pub(crate) placement: f64,
    pub(crate) stiffness: f64,
    pub(crate) preload: f64,
}

/// How one measure changes.
#[derive(Debug, Serialize)]
pub(crate) struct MeasureReport {
    /// Whether the derivatives are two-sided; none if there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) smooth: Option<bool>,
    /// By each contact.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) derivatives: Vec<Derivatives>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) worst_case: Option<WorstCaseReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) best_move: Option<MoveReport>,
    /// Why there are no derivatives.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) missing: Option<String>,
    /// Of the measure, for the text.
    #[serde(skip)]
    pub(crate) value: f64,
}

/// The derivatives by one contact, each along the change and against it.
#[derive(Debug, Serialize)]
pub(crate) struct Derivatives {
    /// By its place along each direction, per length.
    pub(crate) placement: Vec<[f64; 2]>,
    /// By its stiffness, per relative change.
    pub(crate) stiffness: [f64; 2],
    /// By its preload, per relative change.
    pub(crate) preload: [f64; 2],
}

/// The worst case within the tolerances.
#[derive(Debug, Serialize)]
pub(crate) struct WorstCaseReport {
    /// By the derivatives.
    pub(crate) linear: f64,
    /// Of the grasp by the contacts there, if they hold the part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) anew: Option<f64>,
    pub(crate) contacts: Vec<DisplacedReport>,
}

/// A contact at the worst of its tolerances.
#[derive(Debug, Serialize)]
pub(crate) struct DisplacedReport {
    pub(crate) point: Vec<f64>,
    pub(crate) stiffness_factor: f64,
    pub(crate) preload_factor: f64,
}

/// The move of one contact that gains most.
#[derive(Debug, Serialize)]
pub(crate) struct MoveReport {
    pub(crate) contact: usize,
    pub(crate) direction: Vec<f64>,
    /// Per length.
    pub(crate) gain: f64,
}

impl RobustnessReport {
    /// The report, if robustness was looked at.
    pub(super) fn new<const N: usize, const M: usize>(
        analysis: &Analysis<'_, N, M>,
    ) -> Option<Self> {
        let (robustness, view) = (analysis.robustness.as_ref()?, &analysis.view);
        let metrics = analysis.metrics.as_ref().ok()?;
        let tolerance = |i: usize| robustness.tolerances.as_ref().map(|all| all[i].into());
        let freedoms = |(i, directions): (usize, &Vec<_>)| Freedoms {
            directions: directions.iter().map(|&along| view.direction(along)).collect(),
            tolerance: tolerance(i),
        };
        let measure = |robust: &Robust<N>, value| MeasureReport::new(robust, value, view);
        Some(Self {
            contacts: robustness.directions.iter().enumerate().map(freedoms).collect(),
            quality: measure(&robustness.quality, metrics.quality.value),
            quality_rotational: measure(&robustness.rotational, metrics.softest.value),
            worst_point_stiffness: measure(&robustness.worst_point, metrics.worst.stiffness),
        })
    }

    /// That tolerances are too large for the linear estimate, for a part of this `size`, a radius.
    pub(super) fn warning(&self, size: f64, units: UnitNames<'_>) -> Option<String> {
        let not_positive = |measure: &MeasureReport| {
            measure.worst_case.as_ref().is_some_and(|worst| worst.linear <= 0.0)
        };
        let measures = self.measures().into_iter().filter(|(_, measure)| not_positive(measure));
        let names: Vec<&str> = measures.map(|(name, _)| name).collect();
        let placements = self.contacts.iter().filter_map(|contact| contact.tolerance);
        let off = placements.map(|tolerance| tolerance.placement).fold(0.0, f64::max);
        let why = if off >= size {
            let (off, size) = (units.length(off), units.length(size));
            format!("a contact may be off by {off}, but the part's radius is {size}")
        } else if names.is_empty() {
            return None;
        } else {
            format!("by it the worst of {} is not positive", names.join(" and "))
        };
        Some(format!("the tolerances of contacts are too large for the linear estimate: {why}"))
    }

    /// The measures with their symbols.
    pub(super) fn measures(&self) -> [(&'static str, &MeasureReport); 3] {
        [
            ("Q", &self.quality),
            ("Q_V", &self.quality_rotational),
            ("Q_pt", &self.worst_point_stiffness),
        ]
    }
}

impl From<Tolerance> for ToleranceReport {
    fn from(tolerance: Tolerance) -> Self {
        let Tolerance { placement, stiffness, preload } = tolerance;
        Self { placement, stiffness, preload }
    }
}

impl From<&Tolerance> for ToleranceReport {
    fn from(tolerance: &Tolerance) -> Self {
        (*tolerance).into()
    }
}

impl MeasureReport {
    fn new<const N: usize, const M: usize>(
        robust: &Robust<N>,
        value: f64,
        view: &View<N, M>,
    ) -> Self {
        let none = Self {
            smooth: None,
            derivatives: Vec::new(),
            worst_case: None,
            best_move: None,
            missing: None,
            value,
        };
        let Measure { smooth, slopes, worst, gain, .. } = match robust {
            Ok(measure) => measure,
            Err(reason) => return Self { missing: Some(reason.to_string()), ..none },
        };
        Self {
            smooth: Some(*smooth),
            derivatives: slopes.iter().map(Derivatives::new).collect(),
            worst_case: worst.as_ref().map(|worst| WorstCaseReport {
                linear: worst.linear,
                anew: worst.anew,
                contacts: worst
                    .contacts
                    .iter()
                    .map(|contact| DisplacedReport {
                        point: view.point(contact.point),
                        stiffness_factor: contact.stiffness_factor,
                        preload_factor: contact.preload_factor,
                    })
                    .collect(),
            }),
            best_move: gain.as_ref().map(|best| MoveReport {
                contact: best.contact,
                direction: view.direction(best.direction),
                gain: best.gain,
            }),
            ..none
        }
    }
}

impl Derivatives {
    fn new(slopes: &Slopes) -> Self {
        let sides = |slope: &Slope| [slope.along, slope.against].map(plain);
        Self {
            placement: slopes.placement.iter().map(sides).collect(),
            stiffness: sides(&slopes.stiffness),
            preload: sides(&slopes.preload),
        }
    }
}
