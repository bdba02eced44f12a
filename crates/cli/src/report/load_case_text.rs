//! What load cases do, in words.

use super::analysis_text::AnalysisText;
use super::load_case::{ContactForce, LoadCaseReport};
use super::number::{beside, spot};
use super::page::Page;
use crate::wording::digits;

impl AnalysisText<'_> {
    /// The load cases, a block for each.
    pub(super) fn load_cases(&self, page: &mut Page) {
        for (number, case) in self.report.load_cases.iter().enumerate() {
            page.line("");
            let (units, title) = (self.units(), case.title(number));
            let (force, torque) = (spot(&case.force, 0.0), units.torques(&case.torque));
            page.line(format_args!(
                "{title}: on top of the state at rest, force {force} {}, torque {torque} about \
                 the frame's origin",
                units.0.force
            ));
            self.displacements(page, case);
            self.contact_forces(page, case);
            self.limits(page, case);
        }
    }

    /// The point that moves most, and the named points.
    fn displacements(&self, page: &mut Page, case: &LoadCaseReport) {
        let (length, largest) = (&self.report.units.length, &case.largest);
        let mut rows = vec![vec![
            "point".to_owned(),
            format!("at [{length}]"),
            format!("displacement [{length}]"),
            format!("distance [{length}]"),
        ]];
        let row = |name: &str, point: &[f64], displacement: &[f64], distance: f64| {
            vec![
                name.to_owned(),
                spot(point, self.report.size),
                spot(displacement, largest.distance),
                digits(distance),
            ]
        };
        let farthest = match largest.corner {
            Some(corner) => format!("{} {corner}, the largest", self.corner()),
            None => "the largest".to_owned(),
        };
        rows.push(row(&farthest, &largest.point, &largest.displacement, largest.distance));
        for named in &case.points {
            rows.push(row(&named.name, &named.point, &named.displacement, named.distance));
        }
        page.table(&rows);
    }

    fn contact_forces(&self, page: &mut Page, case: &LoadCaseReport) {
        let unit = &self.report.units.force;
        let head = ["contact".to_owned(), format!("change [{unit}]"), format!("force [{unit}]")];
        let mut rows = vec![head.to_vec()];
        let changes = case.contact_forces.iter().map(|contact| contact.change.abs());
        let largest = changes.fold(0.0, f64::max);
        for (i, &ContactForce { change, force }) in case.contact_forces.iter().enumerate() {
            rows.push(vec![i.to_string(), beside(largest, change), beside(largest, force)]);
        }
        page.table(&rows);
    }

    /// How far the load can grow.
    fn limits(&self, page: &mut Page, case: &LoadCaseReport) {
        match &case.first_to_lift_off {
            Some(first) => page.line(format_args!(
                "contact {} lifts off first, at {} times this load",
                first.contact,
                digits(first.load_factor)
            )),
            None => page.line("no contact lifts off, however large the load"),
        }
        let Some(tolerance) = case.tolerance.map(|tolerance| self.units().length(tolerance)) else {
            return;
        };
        page.line(match case.margin {
            Some(margin) => {
                let within = if margin < 1.0 { "beyond" } else { "within" };
                let allowed = digits(margin);
                format!(
                    "{within} the tolerance of {tolerance}, which allows {allowed} times this load"
                )
            }
            None => format!("within the tolerance of {tolerance}: nothing moves"),
        });
    }
}
