//! What load cases do, in words.

use super::analysis_text::AnalysisText;
use super::load_case::{ContactForce, LoadCaseReport, Turning};
use super::number::{INVISIBLE, beside, spot};
use super::page::Page;
use crate::wording::digits;

impl AnalysisText<'_> {
    /// The load cases, a block for each.
    pub(super) fn load_cases(&self, page: &mut Page) {
        for (number, case) in self.report.load_cases.iter().enumerate() {
            page.line("");
            self.load_case(page, number, case);
        }
    }

    /// What one load case does.
    pub(super) fn load_case(&self, page: &mut Page, number: usize, case: &LoadCaseReport) {
        let (title, load) = (case.title(number), self.load(case));
        page.line(format_args!("{title}: on top of the state at rest, {load}"));
        self.displacements(page, case);
        self.turn(page, case);
        self.contact_forces(page, case);
        self.limits(page, case);
    }

    /// What the file says that acts.
    fn load(&self, case: &LoadCaseReport) -> String {
        let units = self.units();
        let at = |force: &[f64], point: &[f64]| {
            format!("force {} {} at {}", spot(force, 0.0), units.0.force, self.spot(point))
        };
        let one = case.point.as_ref().map(|point| at(&case.force, point));
        let several = case.forces.iter().map(|of| at(&of.force, &of.point));
        let couple = case.couple.as_ref();
        let couple = couple.map(|Turning(couple)| format!("couple {}", units.torques(couple)));
        one.into_iter().chain(several).chain(couple).collect::<Vec<_>>().join(", ")
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

    fn turn(&self, page: &mut Page, case: &LoadCaseReport) {
        let visible = case.largest.distance / self.report.size;
        let turn = match &case.displacement.rotation.0[..] {
            [angle] => beside(visible, *angle),
            rotation => spot(rotation, visible),
        };
        page.line(format_args!("the part turns by {turn} rad"));
    }

    fn contact_forces(&self, page: &mut Page, case: &LoadCaseReport) {
        let unit = &self.report.units.force;
        let head = ["contact".to_owned(), format!("change [{unit}]"), format!("force [{unit}]")];
        let mut rows = vec![head.to_vec()];
        let changes = case.contact_forces.iter().map(|contact| contact.change.abs());
        let largest = changes.fold(0.0, f64::max);
        for (i, &ContactForce { change, force }) in case.contact_forces.iter().enumerate() {
            // A finger cannot pull.
            let off = force < -INVISIBLE * largest;
            let force = if off { "off".to_owned() } else { beside(largest, force) };
            rows.push(vec![i.to_string(), beside(largest, change), force]);
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
            None => page.line("no contact loses force under this load"),
        }
        let Some(tolerance) = case.tolerance.map(|tolerance| self.units().length(tolerance)) else {
            return;
        };
        page.line(match (case.margin, &case.first_to_lift_off) {
            (Some(margin), Some(first)) if margin > first.load_factor => format!(
                "the tolerance of {tolerance} is kept at least until contact {} lifts off, at {} \
                 times this load",
                first.contact,
                digits(first.load_factor)
            ),
            (Some(margin), _) => {
                let within = if margin < 1.0 { "beyond" } else { "within" };
                let allowed = digits(margin);
                format!(
                    "{within} the tolerance of {tolerance}, which allows {allowed} times this load"
                )
            }
            (None, _) => format!("within the tolerance of {tolerance}: nothing moves"),
        });
    }
}
