//! The report on the best placements, in words.

use std::fmt;

use clench::optimize::polygon::CROWDING_GAP;

use super::analysis_text::share;
use super::number::{UnitNames, counted, numbered, spot};
use super::optimum::{OptimumReport, PlacedFinger, PlacementReport};
use super::page::Page;
use super::subject::{Subject, in_words};
use super::words::{EndWord, LimitWord, ObjectiveWord};
use crate::input::schema::Forbidden;
use crate::wording::{self, digits, precise_digits, rough_digits};

/// A report, and the part and the name of the file that it is on.
#[derive(Debug)]
pub(crate) struct OptimumText<'a> {
    pub(crate) name: &'a str,
    pub(crate) subject: Subject<'a>,
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
    pub(super) fn units(&self) -> UnitNames<'_> {
        UnitNames(self.report.question.units)
    }

    fn size(&self) -> f64 {
        self.subject.size()
    }

    fn spot(&self, point: &[f64]) -> String {
        format!("{} {}", spot(point, self.size()), self.report.question.units.length)
    }

    fn place(&self, point: &[f64], corner: Option<usize>) -> String {
        numbered(self.spot(point), self.subject.corner(), corner)
    }

    /// The number of fingers that are placed, and of contacts beside them.
    fn count(&self) -> String {
        let count = in_words(self.report.question.fingers);
        match self.subject.fixed() {
            0 => count,
            fixed => format!("{count} beside {}", wording::counted(fixed, "fixed contact")),
        }
    }

    fn head(&self, page: &mut Page) {
        let (report, units) = (self.report, self.units());
        page.head("part", format_args!("{}, {}", self.name, self.subject.described()));
        if let Some(drawing) = report.question.drawing {
            drawing.facts(page, units);
            for warning in drawing.warnings() {
                page.head("warning", warning);
            }
        }
        page.head("units", units);
        for warning in report.question.warnings {
            page.head("warning", warning);
        }
        self.facts(page);
        let best = &report.best;
        let q = units.stiffness(best.quality);
        self.conditions(page);
        page.head("quality", format_args!("Q = {q}, limited by {}", best.limited_by));
        self.objective(page);
        self.certificate(page);
        self.ties(page);
        self.limits(page);
    }

    /// What was asked about.
    pub(super) fn facts(&self, page: &mut Page) {
        let (report, units) = (self.report, self.units());
        page.head("frame", "that of the file");
        if let Some(flatness) = report.question.flatness {
            let meaning = "how far off a plane its vertices may be";
            page.head("flatness", format_args!("{}, {meaning}", units.length(flatness)));
        }
        let tips = match report.question.finger_radius {
            radius if radius > 0.0 => format!("with tips of radius {}", units.length(radius)),
            _ => "pointed".to_owned(),
        };
        let preload = match report.question.total_preload {
            Some(force) => format!("total preload {}", units.force(force)),
            None => "no preload given".to_owned(),
        };
        page.head("fingers", format_args!("{}, frictionless, {tips}; {preload}", self.count()));
        if let Some(accessible) = &report.accessible {
            accessible.lines(page, units);
        }
    }

    /// The optimum is often a limit that no real finger reaches.
    pub(super) fn limits(&self, page: &mut Page) {
        let mut limits = Vec::new();
        for (finger, contact) in self.report.best.contacts.iter().enumerate() {
            let limit = || self.subject.limit_at(&contact.point).filter(|_| !contact.fixed);
            if contact.share <= self.subject.no_share() {
                limits.push(format!("finger {finger} barely presses"));
            } else if let Some(limit) = limit() {
                limits.push(format!("finger {finger} is at {limit}"));
            }
        }
        if limits.is_empty() {
            return;
        }
        let advice = "move such fingers in a little";
        if self.report.best.in_plane.is_some() {
            let limits = limits.join(", ");
            return page
                .head("warning", format_args!("the optimum is a limit: {limits}; {advice}"));
        }
        // Of many fingers in space the line would be too long to read.
        page.head("warning", format_args!("the optimum is a limit; {advice}:"));
        for limit in limits {
            page.head("", limit);
        }
    }

    /// What was asked of the placement besides that it holds the part.
    pub(super) fn conditions(&self, page: &mut Page) {
        let (question, units) = (self.report.question, self.units());
        let mut conditions = Vec::new();
        if let Some(least) = question.least_translation.filter(|least| *least > 0.0) {
            conditions.push(format!("sigma_min at least {}", units.stiffness(least)));
        }
        match question.clearance.filter(|clearance| *clearance > 0.0) {
            Some(clearance) => {
                conditions.push(format!("{} or more between tips", units.length(clearance)));
            }
            None if question.finger_radius > 0.0 => {
                conditions.push("tips that do not overlap".to_owned());
            }
            None => {}
        }
        if question.least_share > 0.0 {
            let least = digits(question.least_share);
            conditions.push(format!("{least} or more of the preload each"));
        }
        if let Some(most) = question.most_on_face.filter(|&most| most < question.fingers) {
            conditions.push(format!("at most {most} on one plane"));
        }
        let planar = question.part.planar.as_ref();
        if let Some(margin) = planar.and_then(|planar| planar.margin).filter(|m| m.0 > 0.0) {
            conditions.push(format!("{} or more from each corner", units.length(margin.0)));
        }
        if let Some(planar) = planar.filter(|planar| !planar.keep_out.is_empty()) {
            let regions = wording::counted(planar.keep_out.len(), "region");
            conditions.push(format!("out of {regions}"));
        }
        if planar.is_some_and(|planar| planar.plate.is_some()) {
            conditions.push("over a hole of the plate".to_owned());
        }
        let forbidden = planar.map_or(&[][..], |planar| &planar.forbidden);
        if !forbidden.is_empty() {
            conditions.push(format!("none on {}", in_runs(forbidden)));
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
            ObjectiveWord::AnyRotation => "least equivalent stiffness of all rotations",
        };
        let value = self.units().stiffness(report.best.value(objective));
        page.head("maximized", format_args!("{objective} = {value}, the {meaning}"));
    }

    /// How the search ended, and what is proved then.
    pub(super) fn certificate(&self, page: &mut Page) {
        let (certificate, question) = (self.report.certificate, self.report.question);
        let (effort, nodes) = (question.effort, self.report.combinations.nodes);
        let fingers = if question.fingers == 1 { "finger" } else { "fingers" };
        let (count, elsewhere) = (in_words(question.fingers), self.subject.elsewhere());
        let placement = format!("no placement of {count} {fingers} {elsewhere}");
        let bound = format!(
            "{placement} has {} above {}, a gap of {}",
            question.objective,
            self.units().stiffness(certificate.upper_bound),
            rough_digits(certificate.gap)
        );
        match certificate.ended {
            EndWord::Proved => page.head("proved", format_args!("{placement} does better")),
            EndWord::Gap => {
                // Fingers that are best where they touch each other have a gap of their own.
                let (gap, whose) = if certificate.gap > effort.gap {
                    (effort.gap.max(CROWDING_GAP), "is, where tips touch each other,")
                } else {
                    (effort.gap, "was")
                };
                let gap = rough_digits(gap);
                page.head("bounded", format_args!("{bound}; {gap} {whose} allowed"));
            }
            EndWord::Time => {
                let time = digits(effort.time.unwrap_or(0.0));
                self.stopped(page, &format!("after {time} s, the limit"), &bound);
            }
            EndWord::Nodes => {
                let nodes = wording::counted(usize::try_from(nodes).unwrap_or(usize::MAX), "node");
                self.stopped(page, &format!("after {nodes}, the limit"), &bound);
            }
            EndWord::Interrupted => self.stopped(page, "by an interrupt", &bound),
        }
        page.head("search", self.effort());
    }

    /// A search that was stopped; bounds on solids have lines of their own.
    fn stopped(&self, page: &mut Page, when: &str, bound: &str) {
        if self.report.best.in_plane.is_some() {
            return page.head("stopped", format_args!("{when}: {bound}"));
        }
        page.head("stopped", when);
        page.head("bound", bound);
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
            if cut { "stretches of edges" } else { self.subject.combined() },
            counted_sets(combinations.nodes)
        )
    }

    /// What was maximized among placements of the same quality.
    pub(super) fn ties(&self, page: &mut Page) {
        let report = self.report;
        let quality = report.question.objective == ObjectiveWord::Quality;
        let planar = report.best.in_plane.is_some();
        if planar && quality && report.best.limited_by == LimitWord::Translation {
            let known = if report.certificate.proved { "" } else { " that was found" };
            let ties = "placements on these edges are as good while mu_eq is at least sigma_min";
            let chosen = format!("this one has the largest mu_eq{known}");
            page.head("ties", format_args!("{ties}; {chosen}"));
        }
    }

    pub(super) fn fingers(&self, page: &mut Page) {
        let question = self.report.question;
        let (fixed, [place, _]) = (self.subject.fixed() > 0, self.subject.places());
        let mut head = vec!["finger".to_owned()];
        if fixed {
            head.push("is".to_owned());
        }
        head.extend([
            if fixed { "on".to_owned() } else { place.to_owned() },
            format!("point [{}]", question.units.length),
            "inward normal".to_owned(),
            format!("stiffness [{}]", self.units().per_length()),
            "share of preload".to_owned(),
        ]);
        let preloaded = question.total_preload.is_some();
        if preloaded {
            head.push(format!("preload [{}]", question.units.force));
        }
        let mut rows = vec![head];
        for (i, contact) in self.report.best.contacts.iter().enumerate() {
            let number = contact.number().map_or_else(String::new, |number| number.to_string());
            let mut row = vec![i.to_string()];
            if fixed {
                row.push(if contact.fixed { "fixed" } else { "placed" }.to_owned());
                let on = if contact.fixed { "face" } else { place };
                row.push(format!("{on} {number}"));
            } else {
                row.push(number);
            }
            row.extend([
                spot(&contact.point, self.size()),
                spot(&contact.inward_normal, 1.0),
                digits(contact.stiffness),
                share(contact.share),
            ]);
            if preloaded {
                row.push(precise_digits(contact.preload));
            }
            rows.push(row);
        }
        page.table(&rows);
    }

    pub(super) fn metrics(&self, page: &mut Page) {
        let (best, units) = (&self.report.best, self.units());
        page.row("sigma_min", units.stiffness(best.sigma_min), "least translational stiffness");
        let moved = if best.in_plane.is_some() { "reach" } else { "deflection" };
        let meaning = format!("rotational stiffness / {moved}^2: comparable to sigma_min");
        page.row("mu_eq", units.stiffness(best.mu_eq), meaning);
        if let Some(plane) = &best.in_plane {
            page.row("center of compliance", self.spot(&plane.center_of_compliance), "");
            let (reach, point) = (&plane.reach, &plane.reach.point);
            let meaning = format!("to {}, the farthest", self.place(point, reach.corner));
            page.row("reach", units.length(reach.distance), meaning);
        }
        if let Some(space) = &best.in_space {
            let value = units.stiffness(space.quality_rotational);
            page.row("Q_V", value, "least mu_eq of all rotations that need no force");
            let (label, meaning) = if space.true_center_exists {
                ("center of compliance", "")
            } else {
                ("canonical point", "where force and rotation couple symmetrically")
            };
            page.row(label, self.spot(&space.center), meaning);
        }
        self.worst_point(page);
        if let Some(quality) = best.quality_second_order {
            let meaning = "Q with all that preload and finger radius add";
            page.row("second order", units.stiffness(quality), meaning);
        }
        if let Some(reason) = &best.quality_second_order_missing {
            page.row("second order", "none", reason);
        }
    }

    fn worst_point(&self, page: &mut Page) {
        let best = &self.report.best;
        let value = self.units().stiffness(best.worst_point_stiffness);
        let meaning = "worst point, least force per deflection";
        let Some(space) = &best.in_space else {
            let at = self.place(&best.worst_point, best.worst_corner);
            return page.row("Q_pt", value, format_args!("{meaning}: at {at}"));
        };
        page.row("Q_pt", value, meaning);
        let corner = best.worst_corner.map(|v| format!("{} {v}, ", self.subject.corner()));
        let along = spot(&space.worst_direction, 1.0);
        let at = format!("{}moves along {along}", corner.unwrap_or_default());
        page.row("worst point", self.spot(&best.worst_point), at);
    }

    pub(super) fn top(&self, page: &mut Page) {
        let (report, unit) = (self.report, self.units().per_length());
        let objective = report.question.objective;
        let other = objective != ObjectiveWord::Quality;
        let mut heading = vec!["place".to_owned()];
        if other {
            heading.push(format!("{objective} [{unit}]"));
        }
        // Points of space would make lines too long to read.
        let with_points = report.best.in_plane.is_some();
        let [_, places] = self.subject.places();
        heading.extend([format!("Q [{unit}]"), "limited by".to_owned(), places.to_owned()]);
        if with_points {
            heading.push(format!("points [{}]", report.question.units.length));
        }
        let mut rows = vec![heading];
        for (i, placement) in report.top.iter().enumerate() {
            let mut row = vec![(i + 1).to_string()];
            if other {
                row.push(digits(placement.value(objective)));
            }
            let on = placement.placed().filter_map(PlacedFinger::number);
            row.extend([
                digits(placement.quality),
                placement.limited_by.to_string(),
                on.map(|number| number.to_string()).collect::<Vec<_>>().join(" "),
            ]);
            if with_points {
                row.push(self.points(placement));
            }
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

/// What is forbidden; edges that follow each other, such as those of a curve, in one.
fn in_runs(forbidden: &[Forbidden]) -> String {
    let follows = |one: &Forbidden, next: &Forbidden| match (one, next) {
        (Forbidden::Edge(one), Forbidden::Edge(next)) => one.0 + 1 == next.0,
        _ => false,
    };
    let runs = forbidden.chunk_by(follows).map(|run| match run {
        [first, _, .., last] => format!("{first} to {last}"),
        _ => run.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "),
    });
    runs.collect::<Vec<_>>().join(", ")
}

fn counted_sets(count: u64) -> String {
    if count == 1 { "1 set".to_owned() } else { format!("{count} sets") }
}
