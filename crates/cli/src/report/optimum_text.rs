//! The report on the best placements, in words.

use std::fmt;

use clench::optimize::polygon::Part;

use super::analysis::NO_SHARE;
use super::analysis_text::share;
use super::number::{UnitNames, counted, numbered, spot};
use super::optimum::{OptimumReport, PlacementReport};
use super::page::Page;
use super::words::{EndWord, LimitWord, ObjectiveWord};
use crate::wording::{digits, precise_digits, rough_digits};

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
        match self.report.question.fingers {
            3 => "three",
            4 => "four",
            5 => "five",
            6 => "six",
            7 => "seven",
            _ => "eight",
        }
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
        self.conditions(page);
        page.head("quality", format_args!("Q = {q}, limited by {}", best.limited_by));
        self.objective(page);
        self.certificate(page);
        self.ties(page);
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

    /// What was asked of the placement besides that it holds the part.
    fn conditions(&self, page: &mut Page) {
        let (question, units) = (self.report.question, self.units());
        let mut conditions = Vec::new();
        if let Some(least) = question.least_translation.filter(|least| *least > 0.0) {
            conditions.push(format!("sigma_min at least {}", units.stiffness(least)));
        }
        if let Some(least) = question.least_distance.filter(|least| *least > 0.0) {
            conditions.push(format!("{} or more apart on one edge", units.length(least)));
        }
        if question.least_share > 0.0 {
            let least = digits(question.least_share);
            conditions.push(format!("{least} or more of the preload each"));
        }
        let planar = question.part.planar.as_ref();
        if let Some(margin) = planar.and_then(|planar| planar.margin).filter(|m| m.0 > 0.0) {
            conditions.push(format!("{} or more from each corner", units.length(margin.0)));
        }
        let forbidden = planar.map_or(&[][..], |planar| &planar.forbidden);
        if !forbidden.is_empty() {
            let edges = forbidden.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
            conditions.push(format!("none on {edges}"));
        }
        if !conditions.is_empty() {
            page.head("asked for", conditions.join("; "));
        }
    }

    /// What was maximized, where it is not the quality.
    fn objective(&self, page: &mut Page) {
        let (report, objective) = (self.report, self.report.question.objective);
        let meaning = match objective {
            ObjectiveWord::Quality => return,
            ObjectiveWord::WorstPoint => "least force per deflection",
            ObjectiveWord::Rotation => "equivalent rotational stiffness",
        };
        let value = self.units().stiffness(report.best.value(objective));
        page.head("maximized", format_args!("{objective} = {value}, the {meaning}"));
    }

    /// How the search ended, and what is proved then.
    fn certificate(&self, page: &mut Page) {
        let (certificate, question) = (self.report.certificate, self.report.question);
        let (effort, nodes) = (question.effort, self.report.combinations.nodes);
        let placement = format!("no placement of {} fingers on this outline", self.count());
        let bound = format!(
            "{placement} has {} above {}, a gap of {}",
            question.objective,
            self.units().stiffness(certificate.upper_bound),
            rough_digits(certificate.gap)
        );
        match certificate.ended {
            EndWord::Proved => page.head("proved", format_args!("{placement} does better")),
            EndWord::Gap => {
                let gap = rough_digits(effort.gap);
                page.head("bounded", format_args!("{bound}; {gap} was allowed"));
            }
            EndWord::Time => {
                let time = digits(effort.time.unwrap_or(0.0));
                page.head("stopped", format_args!("after {time} s, as asked for: {bound}"));
            }
            EndWord::Nodes => {
                let plural = if nodes == 1 { "" } else { "s" };
                page.head(
                    "stopped",
                    format_args!("after {nodes} node{plural}, as asked for: {bound}"),
                );
            }
            EndWord::Interrupted => {
                page.head("stopped", format_args!("by an interrupt: {bound}"));
            }
        }
        page.head("search", self.effort());
    }

    fn effort(&self) -> String {
        let combinations = self.report.combinations;
        let planar = self.report.question.part.planar.as_ref();
        let cut = planar.is_some_and(|planar| !planar.forbidden.is_empty());
        // More than four fingers, and the worst point, are closed in on.
        let solved = match combinations.examined {
            0 => String::new(),
            examined => format!(", {examined} solved exactly"),
        };
        format!(
            "{} combinations of {}{solved}; {} of them bounded",
            counted(combinations.total),
            if cut { "stretches of edges" } else { "edges" },
            counted_sets(combinations.nodes)
        )
    }

    /// What was maximized among placements of the same quality.
    fn ties(&self, page: &mut Page) {
        let report = self.report;
        let quality = report.question.objective == ObjectiveWord::Quality;
        if quality && report.best.limited_by == LimitWord::Translation {
            let known = if report.certificate.proved { "" } else { " that was found" };
            let ties = "placements on these edges are as good while mu_eq is at least sigma_min";
            let chosen = format!("this one has the largest mu_eq{known}");
            page.head("ties", format_args!("{ties}; {chosen}"));
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
        let (report, unit) = (self.report, self.units().per_length());
        let objective = report.question.objective;
        let other = objective != ObjectiveWord::Quality;
        let mut heading = vec!["place".to_owned()];
        if other {
            heading.push(format!("{objective} [{unit}]"));
        }
        heading.extend([
            format!("Q [{unit}]"),
            "limited by".to_owned(),
            "edges".to_owned(),
            format!("points [{}]", report.question.units.length),
        ]);
        let mut rows = vec![heading];
        for (i, placement) in report.top.iter().enumerate() {
            let mut row = vec![(i + 1).to_string()];
            if other {
                row.push(digits(placement.value(objective)));
            }
            row.extend([
                digits(placement.quality),
                placement.limited_by.to_string(),
                placement.edges().iter().map(ToString::to_string).collect::<Vec<_>>().join(" "),
                self.points(placement),
            ]);
            rows.push(row);
        }
        page.table(&rows);
        page.line(match report.certificate.ended {
            EndWord::Proved => {
                "proved: on no other combination is a placement better than the last"
            }
            EndWord::Gap => "better ones on other combinations are within the gap",
            _ => "stopped: other combinations may have better placements than these",
        });
    }

    fn points(&self, placement: &PlacementReport) -> String {
        let points = placement.contacts.iter().map(|c| spot(&c.point, self.size()));
        points.collect::<Vec<_>>().join(" ")
    }
}

fn counted_sets(count: u64) -> String {
    if count == 1 { "1 set".to_owned() } else { format!("{count} sets") }
}
