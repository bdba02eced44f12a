//! The report on the best placements, in words.

use std::fmt;

use clench::optimize::polygon::Part;

use super::analysis::NO_SHARE;
use super::analysis_text::share;
use super::number::{UnitNames, numbered, spot};
use super::optimum::{OptimumReport, PlacementReport};
use super::page::Page;
use super::words::LimitWord;
use crate::wording::{counted, digits, precise_digits};

/// A report, and the part and the name of the file that it is on.
#[derive(Debug)]
pub(crate) struct OptimumText<'a> {
    pub(crate) name: &'a str,
    pub(crate) part: &'a Part,
    pub(crate) report: &'a OptimumReport<'a>,
}

impl fmt::Display for OptimumText<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut page = Page::default();
        self.head(&mut page);
        page.line("");
        self.fingers(&mut page);
        page.line("");
        self.metrics(&mut page);
        if !self.report.top.is_empty() {
            page.line("");
            self.top(&mut page);
        }
        page.fmt(out)
    }
}

impl OptimumText<'_> {
    fn units(&self) -> UnitNames<'_> {
        UnitNames(self.report.question.units)
    }

    fn size(&self) -> f64 {
        self.part.outline().enclosing_circle().radius
    }

    fn spot(&self, point: &[f64]) -> String {
        format!("{} {}", spot(point, self.size()), self.report.question.units.length)
    }

    fn place(&self, point: &[f64], corner: Option<usize>) -> String {
        numbered(self.spot(point), "corner", corner)
    }

    fn count(&self) -> &'static str {
        if self.report.question.fingers == 3 { "three" } else { "four" }
    }

    fn head(&self, page: &mut Page) {
        let (report, units) = (self.report, self.units());
        let corners = self.part.outline().corners().len();
        page.head("part", format_args!("{}, {corners} corners", self.name));
        page.head("units", units);
        page.head("frame", "that of the file");
        let tips = match report.question.finger_radius {
            radius if radius > 0.0 => format!("with tips of radius {}", units.length(radius)),
            _ => "pointed".to_owned(),
        };
        let preload = match report.question.total_preload {
            Some(force) => format!("total preload {}", units.force(force)),
            None => "no preload given".to_owned(),
        };
        page.head("fingers", format_args!("{}, frictionless, {tips}; {preload}", self.count()));
        let best = &report.best;
        let q = units.stiffness(best.quality);
        page.head("quality", format_args!("Q = {q}, limited by {}", best.limited_by));
        self.certificate(page);
        self.limits(page);
    }

    /// The optimum is often a limit that no real finger reaches.
    fn limits(&self, page: &mut Page) {
        let outline = self.part.outline();
        let mut limits = Vec::new();
        for (finger, contact) in self.report.best.contacts.iter().enumerate() {
            if contact.share <= NO_SHARE {
                limits.push(format!("finger {finger} barely presses"));
            } else if let Some(corner) = outline.place(contact.point.into()).corner {
                limits.push(format!("finger {finger} is at corner {corner}"));
            }
        }
        if !limits.is_empty() {
            let limits = limits.join(", ");
            let them = format!("the optimum is a limit: {limits}; move such fingers in a little");
            page.head("warning", them);
        }
    }

    fn certificate(&self, page: &mut Page) {
        let report = self.report;
        page.head(
            "proved",
            format_args!(
                "no placement of {} fingers on this outline does better; \
                 {} combinations of edges, {} solved exactly",
                self.count(),
                report.combinations.total,
                report.combinations.examined
            ),
        );
        if report.best.limited_by == LimitWord::Translation {
            page.head(
                "ties",
                "placements on these edges are as good while mu_eq is at least sigma_min; \
                 this one has the largest mu_eq",
            );
        }
        if report.ties > 0 {
            let others = counted(report.ties, "other combination");
            let are = if report.ties == 1 { "is" } else { "are" };
            page.head("ties", format_args!("{others} of edges {are} as good"));
        }
    }

    fn fingers(&self, page: &mut Page) {
        let (question, part) = (self.report.question, self.part);
        let mut rows = vec![vec![
            "finger".to_owned(),
            "edge".to_owned(),
            format!("point [{}]", question.units.length),
            "inward normal".to_owned(),
            format!("stiffness [{}]", self.units().per_length()),
            "share of preload".to_owned(),
        ]];
        let preloaded = question.total_preload.is_some();
        if preloaded {
            rows[0].push(format!("preload [{}]", question.units.force));
        }
        for (i, contact) in self.report.best.contacts.iter().enumerate() {
            let mut row = vec![
                i.to_string(),
                contact.edge.to_string(),
                spot(&contact.point, self.size()),
                spot(&contact.inward_normal, 1.0),
                digits(part.edge_stiffness()[contact.edge]),
                share(contact.share),
            ];
            if preloaded {
                row.push(precise_digits(contact.preload));
            }
            rows.push(row);
        }
        page.table(&rows);
    }

    fn metrics(&self, page: &mut Page) {
        let (best, units) = (&self.report.best, self.units());
        page.row("sigma_min", units.stiffness(best.sigma_min), "least translational stiffness");
        page.row(
            "mu_eq",
            units.stiffness(best.mu_eq),
            "rotational stiffness / reach^2: comparable to sigma_min",
        );
        page.row("center of compliance", self.spot(&best.center_of_compliance), "");
        let (reach, farthest) = (&best.reach, self.place(&best.reach.point, best.reach.corner));
        let meaning = format!("to {farthest}, the farthest");
        page.row("reach", units.length(reach.distance), meaning);
        let worst = self.place(&best.worst_point, best.worst_corner);
        let meaning = format!("worst point, least force per deflection: at {worst}");
        page.row("Q_pt", units.stiffness(best.worst_point_stiffness), meaning);
        if let Some(quality) = best.quality_second_order {
            let meaning = "Q with all that preload and finger radius add";
            page.row("second order", units.stiffness(quality), meaning);
        }
        if let Some(reason) = &best.quality_second_order_missing {
            page.row("second order", "none", reason);
        }
    }

    fn top(&self, page: &mut Page) {
        let unit = self.units().per_length();
        let mut rows = vec![vec![
            "place".to_owned(),
            format!("Q [{unit}]"),
            "limited by".to_owned(),
            "edges".to_owned(),
            format!("points [{}]", self.report.question.units.length),
        ]];
        for (i, placement) in self.report.top.iter().enumerate() {
            rows.push(vec![
                (i + 1).to_string(),
                digits(placement.quality),
                placement.limited_by.to_string(),
                placement.edges().iter().map(ToString::to_string).collect::<Vec<_>>().join(" "),
                self.points(placement),
            ]);
        }
        page.table(&rows);
    }

    fn points(&self, placement: &PlacementReport) -> String {
        let points = placement.contacts.iter().map(|c| spot(&c.point, self.size()));
        points.collect::<Vec<_>>().join(" ")
    }
}
