//! The report on a grasp, in words.

use std::fmt;

use super::analysis::{AnalysisReport, NO_SHARE};
use super::measures::MetricsReport;
use super::number::{UnitNames, numbered, spot};
use super::page::Page;
use super::words::{OrderWord, StabilityWord};
use crate::color::Paint;
use crate::wording::{counted, digits, precise_digits, rough_digits};

/// A report and the name of the file that it is on.
#[derive(Debug)]
pub(crate) struct AnalysisText<'a> {
    pub(crate) name: &'a str,
    pub(crate) report: &'a AnalysisReport<'a>,
    pub(crate) paint: Paint,
}

impl fmt::Display for AnalysisText<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut page = Page::default();
        self.head(&mut page);
        page.line("");
        self.contacts(&mut page);
        self.areas(&mut page);
        self.loads(&mut page);
        page.line("");
        self.metrics(&mut page);
        self.holding(&mut page);
        self.axes(&mut page);
        self.robustness(&mut page);
        self.load_cases(&mut page);
        self.needed_preloads(&mut page);
        page.line("");
        self.stiffness(&mut page);
        page.fmt(out)
    }
}

impl AnalysisText<'_> {
    pub(super) fn units(&self) -> UnitNames<'_> {
        UnitNames(self.report.units)
    }

    pub(super) fn spot(&self, point: &[f64]) -> String {
        format!("{} {}", spot(point, self.report.size), self.report.units.length)
    }

    /// A point of the part, and its number if it is a corner.
    pub(super) fn place(&self, point: &[f64], corner: Option<usize>) -> String {
        numbered(self.spot(point), self.corner(), corner)
    }

    /// What a corner of the part is called.
    pub(super) fn corner(&self) -> &'static str {
        if self.planar() { "corner" } else { "vertex" }
    }

    pub(super) fn planar(&self) -> bool {
        self.report.dimension == 2
    }

    fn head(&self, page: &mut Page) {
        let report = self.report;
        let contacts = counted(report.contacts.len(), "contact");
        page.head("grasp", format_args!("{}, {contacts}", self.name));
        if let Some(drawing) = &report.drawing {
            drawing.facts(page, self.units());
            for warning in drawing.warnings() {
                page.head("warning", warning);
            }
        }
        page.head("units", self.units());
        self.facts(page);
        match (&report.metrics, &report.reason) {
            (Some(MetricsReport { quality, .. }), None) => {
                let q = self.units().stiffness(quality.quality);
                let (by, proved) = (quality.limited_by, self.proved(quality.quality_at_least));
                page.head("quality", format_args!("Q = {q}, limited by {by}{proved}"));
            }
            (_, Some(reason)) => page.head("no answer", reason),
            (None, None) => {}
        }
        self.verdict(page);
        for warning in &report.warnings {
            page.head("warning", warning);
        }
        self.load_case_heads(page);
    }

    /// What the numbers are about.
    pub(super) fn facts(&self, page: &mut Page) {
        page.head("frame", self.frame());
        page.head(
            "order",
            match self.report.order {
                OrderWord::Second => "second: with what preloads, curvatures and loads add",
                OrderWord::First => "first: without what preloads, curvatures and loads add",
            },
        );
    }

    fn frame(&self) -> String {
        let frame = &self.report.frame;
        let angle = frame.angle.unwrap_or(0.0);
        if frame.is_of_file() {
            return "that of the file".to_owned();
        }
        let (origin, length) = (spot(&frame.origin, 0.0), &self.report.units.length);
        let turn = match &frame.rotation_vector {
            Some(rotation) => format!("turned by the rotation vector {}", spot(rotation, 0.0)),
            None => format!("turned by {}", digits(angle)),
        };
        format!("origin at {origin} {length} of the file's, {turn} rad")
    }

    pub(super) fn contacts(&self, page: &mut Page) {
        let units = self.report.units;
        let edges = self.report.contacts.iter().any(|contact| contact.edge.is_some());
        let faces = self.report.contacts.iter().any(|contact| contact.face.is_some());
        let mut head = vec!["contact".to_owned()];
        if edges || faces {
            head.push(if edges { "edge" } else { "face" }.to_owned());
        }
        head.extend([
            format!("point [{}]", units.length),
            "inward normal".to_owned(),
            format!("overlap [{}]", units.length),
            format!("stiffness [{}]", self.units().per_length()),
            format!("preload [{}]", units.force),
            "balanced share".to_owned(),
        ]);
        let mut rows = vec![head];
        for (i, contact) in self.report.contacts.iter().enumerate() {
            let mut row = vec![i.to_string()];
            row.extend(contact.edge.or(contact.face).map(|piece| piece.to_string()));
            row.extend([
                spot(&contact.point, self.report.size),
                spot(&contact.inward_normal, 1.0),
                digits(contact.overlap),
                digits(contact.stiffness),
                precise_digits(contact.preload),
                contact.balanced_share.map_or_else(|| "none".to_owned(), share),
            ]);
            rows.push(row);
        }
        page.table(&rows);
        if self.report.preload_margin.is_some() {
            page.line(
                "balanced share: how a preload is shared to balance, the least share as large as \
                 can be",
            );
        }
    }

    /// The areas of contact, where the laws say how large they are.
    pub(super) fn areas(&self, page: &mut Page) {
        let units = self.report.units;
        let mut rows = Vec::new();
        for (i, contact) in self.report.contacts.iter().enumerate() {
            if let Some(area) = &contact.contact_ellipse {
                let [a, b] = area.semi_axes.map(digits);
                // A circle is longest nowhere.
                let direction = area.direction.as_ref().filter(|_| a != b);
                let mut row = vec![i.to_string(), format!("{a} x {b}"), digits(area.peak_pressure)];
                row.extend(direction.map(|direction| spot(direction, 1.0)));
                rows.push(row);
            }
            if let Some((half_width, pressure)) = contact.half_width.zip(contact.peak_pressure) {
                rows.push(vec![i.to_string(), digits(half_width), digits(pressure)]);
            }
        }
        let Some(columns) = rows.iter().map(Vec::len).max() else { return };
        let mut head = vec![
            "contact".to_owned(),
            format!("half the area's size [{}]", units.length),
            format!("peak pressure [{}]", self.units().pressure()),
            "longest along".to_owned(),
        ];
        head.truncate(columns);
        rows.insert(0, head);
        page.line("");
        page.table(&rows);
    }

    pub(super) fn loads(&self, page: &mut Page) {
        let units = self.report.units;
        if self.report.loads.is_empty() {
            return;
        }
        let head = [
            "load".to_owned(),
            format!("point [{}]", units.length),
            format!("force [{}]", units.force),
        ];
        let mut rows = vec![head.to_vec()];
        for (i, load) in self.report.loads.iter().enumerate() {
            let point = spot(&load.point, self.report.size);
            rows.push(vec![i.to_string(), point, spot(&load.force, 0.0)]);
        }
        page.line("");
        page.table(&rows);
    }

    pub(super) fn holding(&self, page: &mut Page) {
        let report = self.report;
        let stability = match report.stability {
            StabilityWord::FirstOrder => "stable to first order, whatever the preload",
            StabilityWord::SecondOrder => "stable to second order, by its preload",
            StabilityWord::Marginal => "marginal: some motion costs no energy",
            StabilityWord::Unstable => "unstable: some motion releases energy",
        };
        page.row("stability", report.stability, stability);
        self.equilibrium(page);
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

    fn equilibrium(&self, page: &mut Page) {
        let (report, units) = (self.report, self.units());
        let residual = &report.equilibrium;
        if residual.holds {
            let preloaded = report.contacts.iter().any(|contact| contact.preload > 0.0);
            let meaning = match (preloaded, report.loads.is_empty()) {
                (false, true) => "there is no preload",
                (true, true) => "the preloads balance",
                (_, false) => "preloads and loads balance",
            };
            return page.row("equilibrium", "holds", meaning);
        }
        let [total, moments] = if report.loads.is_empty() {
            ["the total preload", "the total preload times the grasp's length"]
        } else {
            ["the total of all forces", "all forces times their arms"]
        };
        let force = format!("{} {}", spot(&residual.residual_force, 0.0), units.0.force);
        let torque = units.torques(&residual.residual_torque);
        let share = rough_digits(residual.relative_force);
        page.row("equilibrium", "fails", format_args!("left: force {force}, {share} of {total}"));
        let share = rough_digits(residual.relative_torque);
        let torque =
            format!("left: torque {torque}; about the contacts' centroid {share} of {moments}");
        page.row("", "", torque);
    }
}

/// A share of a total, zero when it is nothing but rounding.
pub(super) fn share(value: f64) -> String {
    if value.abs() <= NO_SHARE { "0".to_owned() } else { precise_digits(value) }
}
