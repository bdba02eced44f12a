//! Whether load cases pass: no contact lifts off, and every tolerance is kept.

use clench::stiffness::BALANCED;
use serde::Serialize;

use super::load_case::{LiftOffReport, LoadCaseReport, PointReport};
use super::number::{UnitNames, spot};
use crate::wording::{counted, digits};

/// Whether a load case passes, and if not, why.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct CaseVerdict {
    pub(crate) passes: bool,
    /// Whether the numbers hold: no contact lifts off, and the displacement is small.
    pub(crate) valid: bool,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) reasons: Vec<String>,
}

/// Whether all load cases pass, and if not, why.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct OverallVerdict {
    pub(crate) passes: bool,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) reasons: Vec<String>,
}

/// The tolerance of a named point under a load case.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct PointCheck {
    pub(crate) tolerance: f64,
    /// If only the displacement along it is bounded: a unit vector.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) direction: Option<Vec<f64>>,
    /// The displacement along it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) along: Option<f64>,
    /// How many times the load can grow until the point moves so far, if nothing lifts off.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) margin: Option<f64>,
    /// What is left of the tolerance, negative where it is exceeded.
    pub(crate) room: f64,
    pub(crate) passes: bool,
}

impl PointCheck {
    /// How far the point moves, as far as that is bounded; it moves by `distance` in all.
    pub(super) fn found(&self, distance: f64) -> f64 {
        self.along.map_or(distance, f64::abs)
    }
}

impl CaseVerdict {
    /// The verdict on `case`, whose points are then marked.
    pub(super) fn on(case: &mut LoadCaseReport, size: f64, units: UnitNames<'_>) -> Self {
        let invalid: Vec<String> = lifted(case)
            .map(|first| {
                let LiftOffReport { contact, load_factor } = first;
                let factor = digits(*load_factor);
                format!("contact {contact} lifts off at {factor} times the load")
            })
            .into_iter()
            .chain((!case.is_small(size)).then(|| "the displacement is not small".to_owned()))
            .collect();
        let valid = invalid.is_empty();
        for point in &mut case.points {
            if let Some(check) = &mut point.check {
                check.passes = valid && check.room >= 0.0;
            }
        }
        let of_part = case.room.filter(|room| *room < 0.0).zip(case.tolerance);
        let of_part = of_part.map(|(_, tolerance)| {
            exceeded("the part moves", case.largest.distance, (tolerance, units))
        });
        let of_points = case.points.iter().filter_map(|point| point.exceeded(units));
        let invalid = invalid.into_iter().map(|why| format!("not valid: {why}"));
        let reasons: Vec<String> = invalid.chain(of_part).chain(of_points).collect();
        Self { passes: reasons.is_empty(), valid, reasons }
    }
}

impl PointReport {
    /// That the tolerance of the point is exceeded, if it is.
    pub(super) fn exceeded(&self, units: UnitNames<'_>) -> Option<String> {
        let check = self.check.as_ref().filter(|check| check.room < 0.0)?;
        let name = &self.name;
        let what = match &check.direction {
            Some(direction) => format!("{name} moves along {}", spot(direction, 1.0)),
            None => format!("{name} moves"),
        };
        Some(exceeded(&what, check.found(self.distance), (check.tolerance, units)))
    }
}

impl OverallVerdict {
    /// The verdict on the load cases; none without any. `unheld` says why the part is not held.
    pub(super) fn on(
        cases: &[LoadCaseReport],
        unanswered: usize,
        unheld: Option<&str>,
    ) -> Option<Self> {
        if cases.is_empty() && unanswered == 0 {
            return None;
        }
        let of_case = |(number, case): (usize, &LoadCaseReport)| {
            let title = case.title(number);
            let reasons = case.verdict.reasons.iter();
            reasons.map(|reason| format!("{title}: {reason}")).collect::<Vec<_>>()
        };
        let of_cases = cases.iter().enumerate().flat_map(of_case);
        let reasons: Vec<String> = unheld.map(str::to_owned).into_iter().chain(of_cases).collect();
        Some(Self { passes: reasons.is_empty() && unanswered == 0, reasons })
    }

    /// The verdict in one line: how many of the load cases fail.
    pub(in crate::report) fn in_words(&self, cases: &[LoadCaseReport]) -> String {
        let (all, failed) = (counted(cases.len(), "load case"), failed(cases));
        match failed {
            _ if self.passes && cases.len() == 1 => "the load case passes".to_owned(),
            _ if self.passes => format!("all {all} pass"),
            0 => "no load case passes: the part is not held".to_owned(),
            1 if cases.len() == 1 => "the load case fails".to_owned(),
            1 => format!("1 of {all} fails"),
            _ => format!("{failed} of {all} fail"),
        }
    }
}

/// The contact that lifts off under the load of the case. Preloads are balanced to [`BALANCED`] at
/// best, and load factors are as good.
pub(super) fn lifted(case: &LoadCaseReport) -> Option<&LiftOffReport> {
    case.first_to_lift_off.as_ref().filter(|first| first.load_factor < 1.0 - BALANCED)
}

fn exceeded(what: &str, found: f64, (tolerance, units): (f64, UnitNames<'_>)) -> String {
    format!(
        "{what} by {}, beyond the tolerance of {}",
        units.length(found),
        units.length(tolerance)
    )
}

fn failed(cases: &[LoadCaseReport]) -> usize {
    cases.iter().filter(|case| !case.verdict.passes).count()
}
