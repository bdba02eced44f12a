//! Whether load cases pass, in words: the head of the text.

use super::analysis_text::AnalysisText;
use super::case_verdict::{OverallVerdict, PointCheck};
use super::load_case::{LiftOffReport, LoadCaseReport, PointReport};
use super::number::spot;
use super::page::Page;
use crate::wording::digits;

/// What stands where there is no number.
const NONE: &str = "-";

impl AnalysisText<'_> {
    /// Whether the load cases pass, in one line.
    pub(super) fn verdict(&self, page: &mut Page) {
        let Some(verdict) = &self.report.verdict else { return };
        let OverallVerdict { passes, .. } = verdict;
        let words = verdict.in_words(&self.report.load_cases);
        let word = if *passes { self.paint.good("PASS") } else { self.paint.bad("FAIL") };
        page.head("verdict", format_args!("{word}: {words}"));
    }

    /// The load cases at a glance, a row for each with each of the points.
    pub(super) fn load_case_heads(&self, page: &mut Page) {
        if self.report.load_cases.is_empty() {
            return;
        }
        page.line("");
        page.table(&self.load_case_rows());
        page.line("margin: how many times the load can grow, until a contact lifts off at most");
    }

    /// The rows of that table, with their heading.
    pub(in crate::report) fn load_case_rows(&self) -> Vec<Vec<String>> {
        let length = &self.report.units.length;
        let [moves, allowed] = ["moves", "allowed"].map(|what| format!("{what} [{length}]"));
        let head = ["load case", "of", &moves, &allowed, "margin", "verdict"];
        let mut rows = vec![head.map(str::to_owned).to_vec()];
        for (number, case) in self.report.load_cases.iter().enumerate() {
            rows.push(self.of_part(number, case));
            rows.extend(case.points.iter().map(|point| self.of_point(case, point)));
        }
        rows
    }

    /// The row of the part as a whole.
    fn of_part(&self, number: usize, case: &LoadCaseReport) -> Vec<String> {
        let title = match &case.name {
            Some(name) => format!("{number} ({name})"),
            None => number.to_string(),
        };
        let verdict = match (case.verdict.valid, case.tolerance, case.room) {
            (false, ..) => self.paint.bad(&case.verdict.reasons[0]),
            (true, Some(_), Some(room)) => self.pass(room >= 0.0),
            (true, ..) => self.paint.good("holds"),
        };
        vec![
            title,
            "the part".to_owned(),
            digits(case.largest.distance),
            case.tolerance.map_or_else(|| NONE.to_owned(), digits),
            margin(case, case.margin),
            verdict,
        ]
    }

    fn of_point(&self, case: &LoadCaseReport, point: &PointReport) -> Vec<String> {
        let name = point.name.clone();
        let Some(check) = &point.check else {
            let none = || NONE.to_owned();
            return vec![String::new(), name, digits(point.distance), none(), none(), none()];
        };
        let PointCheck { tolerance, direction, .. } = check;
        let along = direction.as_ref().map(|direction| format!(" along {}", spot(direction, 1.0)));
        let verdict =
            if case.verdict.valid { self.pass(check.passes) } else { self.paint.bad("not valid") };
        vec![
            String::new(),
            format!("{name}{}", along.unwrap_or_default()),
            digits(check.found(point.distance)),
            digits(*tolerance),
            margin(case, check.margin),
            verdict,
        ]
    }

    fn pass(&self, passes: bool) -> String {
        if passes { self.paint.good("pass") } else { self.paint.bad("FAIL") }
    }
}

/// How many times the load can grow: until the tolerance is used up, or until a contact lifts off.
fn margin(case: &LoadCaseReport, margin: Option<f64>) -> String {
    let first = case.first_to_lift_off.as_ref();
    let lifts_off = first.filter(|first| margin.is_none_or(|margin| margin > first.load_factor));
    match (lifts_off, margin) {
        (Some(LiftOffReport { contact, load_factor }), _) => {
            format!("{} (contact {contact} off)", digits(*load_factor))
        }
        (None, Some(margin)) => digits(margin),
        (None, None) => "any".to_owned(),
    }
}
