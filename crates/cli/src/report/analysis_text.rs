//! The report on a grasp, in words.

use std::fmt;

use super::analysis::{AnalysisReport, MetricsReport, NO_SHARE};
use super::number::{UnitNames, spot};
use super::page::Page;
use super::words::{OrderWord, StabilityWord};
use crate::wording::{counted, digits, precise_digits};

/// A report and the name of the file that it is on.
#[derive(Debug)]
pub(crate) struct AnalysisText<'a> {
    pub(crate) name: &'a str,
    pub(crate) report: &'a AnalysisReport<'a>,
}

impl fmt::Display for AnalysisText<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut page = Page::default();
        self.head(&mut page);
        page.line("");
        self.contacts(&mut page);
        page.line("");
        if let Some(metrics) = &self.report.metrics {
            self.metrics(&mut page, metrics);
        }
        self.holding(&mut page);
        page.line("");
        self.stiffness(&mut page);
        page.fmt(out)
    }
}

impl AnalysisText<'_> {
    fn units(&self) -> UnitNames<'_> {
        UnitNames(self.report.units)
    }

    fn spot(&self, point: [f64; 2]) -> String {
        format!("{} {}", spot(point, self.report.size), self.report.units.length)
    }

    fn head(&self, page: &mut Page) {
        let report = self.report;
        let contacts = counted(report.contacts.len(), "contact");
        page.head("grasp", format_args!("{}, {contacts}", self.name));
        page.head("units", self.units());
        let frame = report.frame;
        let turned = frame.origin.iter().chain([&frame.angle]).any(|v| v.abs() > 0.0);
        if turned {
            let (origin, angle) = (spot(frame.origin, 0.0), digits(frame.angle));
            let length = &report.units.length;
            page.head(
                "frame",
                format_args!("origin at {origin} {length} of the file's, turned by {angle} rad"),
            );
        } else {
            page.head("frame", "that of the file");
        }
        page.head(
            "order",
            match report.order {
                OrderWord::Second => "second: with what preload and finger radius add",
                OrderWord::First => "first: without what preload and finger radius add",
            },
        );
        match (&report.metrics, &report.reason) {
            (Some(metrics), None) => {
                let q = self.units().stiffness(metrics.quality);
                page.head("quality", format_args!("Q = {q}, limited by {}", metrics.limited_by));
            }
            (_, Some(reason)) => page.head("no answer", reason),
            (None, None) => {}
        }
        for warning in &report.warnings {
            page.head("warning", warning);
        }
    }

    fn contacts(&self, page: &mut Page) {
        let units = self.report.units;
        let mut rows = vec![vec![
            "contact".to_owned(),
            "edge".to_owned(),
            format!("point [{}]", units.length),
            "inward normal".to_owned(),
            format!("stiffness [{}]", self.units().per_length()),
            format!("preload [{}]", units.force),
            "balanced share".to_owned(),
        ]];
        for (i, contact) in self.report.contacts.iter().enumerate() {
            rows.push(vec![
                i.to_string(),
                contact.edge.to_string(),
                spot(contact.point, self.report.size),
                spot(contact.inward_normal, 1.0),
                digits(contact.stiffness),
                precise_digits(contact.preload),
                contact.balanced_share.map_or_else(|| "none".to_owned(), share),
            ]);
        }
        page.table(&rows);
    }

    fn metrics(&self, page: &mut Page, metrics: &MetricsReport) {
        let units = self.units();
        let [least, largest] = metrics.translational;
        let along = |direction| format!("along {}", spot(direction, 1.0));
        page.row(
            "sigma_min",
            units.stiffness(least.value),
            format_args!("least translational stiffness, {}", along(least.direction)),
        );
        page.row("sigma_max", units.stiffness(largest.value), along(largest.direction));
        let [turn] = metrics.rotational;
        page.row("mu", units.torque(turn.value), "rotational stiffness");
        page.row(
            "mu_eq",
            units.stiffness(turn.equivalent),
            "mu / reach^2: comparable to sigma_min",
        );
        page.row("center of compliance", self.spot(metrics.center_of_compliance), "");
        let reach = metrics.reach;
        page.row(
            "reach",
            units.length(reach.distance),
            format_args!("to corner {} at {}, the farthest", reach.corner, self.spot(reach.point)),
        );
        page.row(
            "worst point",
            units.stiffness(metrics.worst_point_stiffness),
            format_args!(
                "least force per deflection: at corner {}, {}",
                metrics.worst_corner,
                along(metrics.worst_direction)
            ),
        );
    }

    fn holding(&self, page: &mut Page) {
        let report = self.report;
        let stability = match report.stability {
            StabilityWord::FirstOrder => "stable to first order, whatever the preload",
            StabilityWord::SecondOrder => "stable to second order, by its preload",
            StabilityWord::Marginal => "marginal: some motion costs no energy",
            StabilityWord::Unstable => "unstable: some motion releases energy",
        };
        page.row("stability", report.stability, stability);
        let preloaded = report.contacts.iter().any(|contact| contact.preload > 0.0);
        let (holds, residual) = (report.equilibrium.holds, &report.equilibrium);
        let left = format!(
            "force {} {} and torque {} are left: {:.1e} of the total preload, {:.1e} of that times \
             the contacts' size",
            spot(residual.residual_force, 0.0),
            report.units.force,
            self.units().torque(residual.residual_torque),
            residual.relative_force,
            residual.relative_torque
        );
        match (holds, preloaded) {
            (true, false) => page.row("equilibrium", "holds", "there is no preload"),
            (true, true) => page.row("equilibrium", "holds", "the preloads balance"),
            (false, _) => page.row("equilibrium", "fails", left),
        }
        let closure = if report.force_closure { "yes" } else { "no" };
        let margin = match report.preload_margin {
            Some(margin) if margin > NO_SHARE && !report.force_closure => format!(
                "a preload balances, its largest least share is {}; but some load cannot be \
                 balanced by any forces of these contacts",
                share(margin)
            ),
            Some(margin) => format!("largest least share of a balanced preload: {}", share(margin)),
            None => {
                "no preload of these contacts balances: some load pulls the part off".to_owned()
            }
        };
        page.row("force closure", closure, margin);
    }

    fn stiffness(&self, page: &mut Page) {
        let units = self.report.units;
        page.line(format_args!(
            "stiffness matrix about the frame's origin, of (x, y, rotation) [{}, {}, {} {}]",
            self.units().per_length(),
            units.force,
            units.force,
            units.length
        ));
        let row = |row: &[f64; 3]| row.iter().map(|&value| digits(value)).collect();
        page.table(&self.report.stiffness.iter().map(row).collect::<Vec<_>>());
    }
}

/// A share of a total, zero when it is nothing but rounding.
pub(super) fn share(value: f64) -> String {
    if value.abs() <= NO_SHARE { "0".to_owned() } else { precise_digits(value) }
}
