//! How the measures change with the contacts, in words.

use super::analysis_text::AnalysisText;
use super::number::{beside, spot};
use super::page::Page;
use super::robustness::{Derivatives, MeasureReport, RobustnessReport, ToleranceReport};
use crate::wording::digits;

/// One of the changes of a contact, in the derivatives.
type Pick<'a> = &'a dyn Fn(&Derivatives) -> Option<[f64; 2]>;

impl AnalysisText<'_> {
    /// The section on robustness, if there is one.
    pub(super) fn robustness(&self, page: &mut Page) {
        let Some(report) = &self.report.robustness else { return };
        page.line("");
        let length = &self.report.units.length;
        page.line(format_args!(
            "robustness: change of the measures per {length} of a contact's place along the \
             boundary, and per 100 % of its stiffness or preload"
        ));
        self.slopes(page, report);
        for (name, measure) in report.measures() {
            if let Some(reason) = &measure.missing {
                page.line(format_args!("{name}: {reason}"));
            }
        }
        if report.measures().iter().any(|(_, measure)| measure.smooth == Some(false)) {
            page.line(
                "two numbers: the change along and against, where several places or directions \
                 are equally soft",
            );
        }
        self.best_moves(page, report);
        self.worst_cases(page, report);
    }

    /// A row for each change of each contact.
    fn slopes(&self, page: &mut Page, report: &RobustnessReport) {
        let unit = self.units().per_length();
        let mut rows = vec![vec!["contact".to_owned(), "change".to_owned()]];
        let names = report.measures().map(|(name, _)| format!("{name} [{unit}]"));
        rows[0].extend(names);
        for (i, contact) in report.contacts.iter().enumerate() {
            for (k, direction) in contact.directions.iter().enumerate() {
                let along = format!("along {}", spot(direction, 1.0));
                let size = self.report.size;
                let pick = |d: &Derivatives| d.placement.get(k).copied();
                rows.push(slopes_row(report, i, along, size, &pick));
            }
            let stiffness = |d: &Derivatives| Some(d.stiffness);
            rows.push(slopes_row(report, i, "stiffness".to_owned(), 1.0, &stiffness));
            if self.report.contacts[i].preload <= 0.0 {
                continue;
            }
            let preload = |d: &Derivatives| Some(d.preload);
            rows.push(slopes_row(report, i, "preload".to_owned(), 1.0, &preload));
        }
        page.table(&rows);
    }

    fn best_moves(&self, page: &mut Page, report: &RobustnessReport) {
        let (unit, length) = (self.units().per_length(), &self.report.units.length);
        for (name, measure) in report.measures() {
            let visible = measure.value / self.report.size;
            let best = measure.best_move.as_ref();
            let best = best.filter(|best| beside(visible, best.gain) != "0");
            match best {
                Some(best) => page.line(format_args!(
                    "{name} gains most when contact {} moves along {}: {} {unit} per {length}",
                    best.contact,
                    spot(&best.direction, 1.0),
                    digits(best.gain)
                )),
                None if measure.missing.is_none() => {
                    page.line(format_args!("{name} gains by no small move of one contact"));
                }
                None => {}
            }
        }
    }

    /// The measures at the worst of the tolerances.
    fn worst_cases(&self, page: &mut Page, report: &RobustnessReport) {
        let Some(first) = report.contacts.first().and_then(|contact| contact.tolerance) else {
            return;
        };
        let alike = report.contacts.iter().all(|contact| contact.tolerance == Some(first));
        let tolerances = if alike {
            let ToleranceReport { placement, stiffness, preload } = first;
            format!(
                "place {}, stiffness {} %, preload {} %",
                self.units().length(placement),
                digits(100.0 * stiffness),
                digits(100.0 * preload)
            )
        } else {
            "of each contact as in the file".to_owned()
        };
        page.line("");
        page.line(format_args!("with all tolerances at their worst ({tolerances})"));
        let unit = self.units().per_length();
        let head = [
            "measure".to_owned(),
            format!("at rest [{unit}]"),
            format!("worst, linear estimate [{unit}]"),
            format!("anew at that worst [{unit}]"),
        ];
        let mut rows = vec![head.to_vec()];
        for (name, measure) in report.measures() {
            let Some(worst) = &measure.worst_case else { continue };
            let anew = worst.anew.map_or_else(|| "not held".to_owned(), digits);
            rows.push(vec![name.to_owned(), digits(measure.value), digits(worst.linear), anew]);
        }
        page.table(&rows);
    }
}

/// A row for one change of contact `i`, whose unit is `size`.
fn slopes_row(
    report: &RobustnessReport,
    i: usize,
    change: String,
    size: f64,
    pick: Pick<'_>,
) -> Vec<String> {
    let cell = |measure: &MeasureReport| {
        let found = measure.derivatives.get(i).and_then(pick);
        let Some(sides) = found else { return "none".to_owned() };
        let [along, against] = sides.map(|slope| beside(measure.value / size, slope));
        if measure.smooth == Some(true) { along } else { format!("{along}, {against}") }
    };
    let cells = report.measures().map(|(_, measure)| cell(measure));
    [i.to_string(), change].into_iter().chain(cells).collect()
}
