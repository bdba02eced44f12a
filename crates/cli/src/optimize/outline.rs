//! The placement of fingers on an outline.

use std::path::PathBuf;

use clench::contact::Geometry;
use clench::optimize::polygon::{Fingers, Part, ThreeFingers, fingers, three_fingers};
use clench::optimize::{Effort, OptimizeError, Outcome, Placement, Solution};
use clench::shape::{Edge, Extent};

use super::found::round;
use super::{Found, Held, On, OutOfRange, Shown};
use crate::answer::Answer;
use crate::arguments::OptimizeArguments;
use crate::failure::Failure;
use crate::input::schema::{self, Forbidden};
use crate::input::{self, Document, Drawn, Finite};
use crate::picture::{self, Figures, Picture};
use crate::report::{
    AccessReport, DrawingReport, OptimumReport, OptimumText, OutlineReport, PlacementReport,
    Question, Subject,
};
use crate::wording::digits;

/// Runs the command on an outline.
pub(super) fn optimize(
    arguments: &OptimizeArguments,
    (document, drawn): (&Document, Option<&Drawn>),
    mut file: schema::File,
    part: Part,
) -> Result<Answer, Failure> {
    arguments.check_for_outline().map_err(|message| Failure::Usage { message })?;
    let part = restricted(part, arguments)?;
    let part = with_room(document, part, file.part.planar.as_ref(), arguments.finger_radius)?;
    add_restrictions(&mut file.part, arguments);
    let effort = arguments.effort_on_outline();
    let drawing = drawn.map(DrawingReport::new);
    let besides: Vec<_> = drawn.map(|drawn| drawn.path.clone()).into_iter().collect();
    arguments.output.check_apart(besides.iter().map(PathBuf::as_path))?;
    let warnings = super::left_aside(document, &file);
    let question = Question {
        drawing: drawing.as_ref(),
        warnings: &warnings,
        ..super::question(arguments, &file, (2, &effort))
    };
    let outcome = match search(&part, &question, (arguments, &effort)) {
        Ok(outcome) => outcome,
        Err(error) if super::is_unanswered(&error) => {
            return super::unanswered(arguments, &question, &error);
        }
        Err(error) => return Err(super::refused(document.name(), error)),
    };
    let placement = |solution| {
        let found = examined(&part, solution, arguments)?;
        Ok(PlacementReport::planar(&question, &found))
    };
    let others = outcome.others.iter().map(placement).collect::<Result<Vec<_>, OutOfRange>>();
    let placements = placement(&outcome.best).and_then(|best| Ok((best, others?)));
    let placements = placements.map_err(super::out_of_range(document.name()))?;
    let accessible = access(&part);
    let report =
        OptimumReport { accessible, ..OptimumReport::new(&question, &outcome, placements) };
    let picture = picture::of_optimum(&report, &part);
    let figures =
        super::drawn(arguments, || Figures::of_optimum(&report, &outcome.best, &picture))?;
    let (picture, texts) = (Picture::Outline(picture), document.sources());
    let shown = Shown { picture, figures, texts, besides };
    let subject = Subject::Outline(&part);
    let words = OptimumText { name: document.name(), subject, report: &report };
    super::answered(arguments, &words, shown)
}

/// The part without what the command line forbids.
fn restricted(part: Part, arguments: &OptimizeArguments) -> Result<Part, Failure> {
    let failure = |option: String| move |error| Failure::Option { option, source: Box::new(error) };
    let mut part = part;
    if let Some(margin) = arguments.margin {
        part = part.with_margin(margin).map_err(failure(format!("--margin {}", digits(margin))))?;
    }
    for forbidden in &arguments.forbid {
        part = input::without(part, forbidden).map_err(failure(format!("--forbid {forbidden}")))?;
    }
    Ok(part)
}

/// The part where the tips of its fingers have room.
fn with_room(
    document: &Document,
    part: Part,
    planar: Option<&schema::Planar>,
    radius: f64,
) -> Result<Part, Failure> {
    let Some(planar) = planar else { return Ok(part) };
    let tip = input::disc_tip(document, planar, radius)?;
    part.accessible_to(&tip).map_err(|error| super::refused(document.name(), error))
}

/// How much of the outline fingers may touch; none if they may touch all of it.
fn access(part: &Part) -> Option<AccessReport> {
    let mut open = vec![0.0; part.outline().edges().len()];
    for stretch in part.stretches() {
        open[stretch.edge] += stretch.to - stretch.from;
    }
    let total: f64 = part.outline().edges().iter().map(Edge::length).sum();
    let sum: f64 = open.iter().sum();
    let closed_edges = (0..open.len()).filter(|&edge| open[edge] <= 0.0).collect();
    let outline = OutlineReport { share: sum / total, closed_edges };
    (sum < total).then(|| AccessReport { outline: Some(outline), ..AccessReport::default() })
}

/// The part of the file with what the command line forbids, so that a report repeats all of it.
fn add_restrictions(part: &mut schema::Part, arguments: &OptimizeArguments) {
    let Some(planar) = &mut part.planar else { return };
    if let Some(margin) = arguments.margin {
        let of_file = planar.margin.map_or(0.0, |margin| margin.0);
        planar.margin = Some(Finite(margin.max(of_file)));
    }
    // The edges of layers stand in the list already.
    let layer = |forbidden: &&Forbidden| matches!(forbidden, Forbidden::Layer(_));
    for forbidden in arguments.forbid.iter().filter(|forbidden| !layer(forbidden)) {
        if !planar.forbidden.contains(forbidden) {
            planar.forbidden.push(forbidden.clone());
        }
    }
}

fn search(
    part: &Part,
    question: &Question<'_>,
    (arguments, effort): (&OptimizeArguments, &Effort),
) -> Result<Outcome<2, 1>, OptimizeError> {
    let Question { fingers: count, finger_radius, least_share, .. } = *question;
    let clearance = question.clearance.unwrap_or(0.0);
    super::watched(question.units, |watch| {
        if count == 3 {
            let total_preload = arguments.preload.unwrap_or(0.0);
            let question = ThreeFingers { total_preload, finger_radius, clearance, least_share };
            return three_fingers(part, &question, effort, watch);
        }
        let objective = arguments.objective(2);
        let asked = Fingers { count, objective, finger_radius, clearance, least_share };
        fingers(part, &asked, effort, watch)
    })
}

/// What the search does not say about a placement.
fn examined<'a>(
    part: &Part,
    solution: &'a Solution<2, 1>,
    arguments: &OptimizeArguments,
) -> Result<Found<'a, 2, 1>, OutOfRange> {
    let radius = arguments.finger_radius;
    let held = |p: &Placement<2>| Held {
        on: Some(On::Edge(p.on)),
        fixed: false,
        geometry: Geometry::on_face(p.point, p.inward_normal, radius),
        finger: round(radius),
        stiffness: part.edge_stiffness()[p.on],
        // Shares are zero or more up to rounding.
        share: p.share.max(0.0),
    };
    let contacts = solution.placements.iter().map(held).collect();
    Found::new(solution, contacts, Extent::from(part.outline()), arguments.preload)
}
