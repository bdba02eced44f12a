//! `clench optimize`: where the fingers go.

use std::ops::ControlFlow;

use clench::contact::{Contact, ContactError, Geometry, Law, Order};
use clench::metrics::{MetricsError, Quality, WorstPoint};
use clench::optimize::polygon::{Fingers, Part, ThreeFingers, fingers, three_fingers};
use clench::optimize::{Effort, Objective, OptimizeError, Outcome, Progress, Solution};
use clench::stiffness::{Grasp, GraspError};

use crate::answer::Answer;
use crate::arguments::{Format, ObjectiveArgument, OptimizeArguments};
use crate::failure::Failure;
use crate::held::principal;
use crate::input::{self, Document, Finite, schema};
use crate::interrupt::Interrupt;
use crate::picture;
use crate::progress::ProgressLine;
use crate::report::{
    self, EffortReport, ObjectiveWord, OptimumReport, OptimumText, Question, UnansweredReport,
    UnitNames,
};

/// A placement that the search found, as a grasp.
#[derive(Debug)]
pub(crate) struct Found<'a> {
    pub(crate) solution: &'a Solution<2, 1>,
    /// The worst point by the stiffness that was optimized.
    pub(crate) worst: WorstPoint<2>,
    /// The quality with all that preload and finger radius add; only with a preload.
    pub(crate) second_order: Option<Result<Quality<2, 1>, MetricsError>>,
}

/// Why a placement that was found has no numbers.
#[derive(Debug, thiserror::Error)]
pub(crate) enum OutOfRange {
    /// The contact forces or the laws.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The stiffness of a contact.
    #[error(transparent)]
    Grasp(#[from] GraspError),
    /// The principal stiffnesses.
    #[error(transparent)]
    Metrics(#[from] MetricsError),
}

/// Runs the command.
pub(crate) fn optimize(arguments: &OptimizeArguments) -> Result<Answer, Failure> {
    let (document, mut file) = Document::read(&arguments.part)?;
    let part = input::outline_part(&document, &file.part)?;
    let part = restricted(part, arguments)?;
    add_restrictions(&mut file.part, arguments);
    let question = question(arguments, &file);
    let outcome = match search(&part, &question, arguments) {
        Ok(outcome) => outcome,
        Err(
            e @ (OptimizeError::NormalsNeverBalance { .. }
            | OptimizeError::TorquesNeverBalance { .. }
            | OptimizeError::ConditionsNeverMet { .. }
            | OptimizeError::NothingFound { .. }),
        ) => return unanswered(arguments, &question, &part, &e),
        Err(error) => return Err(refused(document.name(), error)),
    };
    let range = |error| {
        let (name, source) = (document.name().to_owned(), Box::new(error));
        Failure::Range { name, source }
    };
    let best = examine(&part, &outcome.best, arguments).map_err(range)?;
    let others = outcome.others.iter().map(|other| examine(&part, other, arguments));
    let others = others.collect::<Result<Vec<_>, _>>().map_err(range)?;
    let report = OptimumReport::new(&question, &part, &outcome, (&best, &others));
    let text = match arguments.output.format {
        Format::Text => {
            OptimumText { name: document.name(), part: &part, report: &report }.to_string()
        }
        Format::Json => report::json(&report)?,
    };
    let picture = picture::of_optimum(&report, &part);
    Ok(Answer { report: text, picture: Some(picture), reason: None })
}

/// The part without what the command line forbids.
fn restricted(part: Part, arguments: &OptimizeArguments) -> Result<Part, Failure> {
    let failure = |option: String| move |error| Failure::Option { option, source: Box::new(error) };
    let mut part = part;
    if let Some(margin) = arguments.margin {
        part = part.with_margin(margin).map_err(failure(format!("--margin {margin}")))?;
    }
    for forbidden in &arguments.forbid {
        part = input::without(part, forbidden).map_err(failure(format!("--forbid {forbidden}")))?;
    }
    if part.stretches().is_empty() {
        let option = match (arguments.margin, &arguments.forbid[..]) {
            (Some(_), []) => "--margin",
            (None, _) => "--forbid",
            (Some(_), _) => "--margin and --forbid",
        };
        return Err(failure(option.to_owned())(OptimizeError::NowhereToTouch));
    }
    Ok(part)
}

/// The part of the file with what the command line forbids, so that a report repeats all of it.
fn add_restrictions(part: &mut schema::Part, arguments: &OptimizeArguments) {
    let Some(planar) = &mut part.planar else { return };
    if let Some(margin) = arguments.margin {
        let of_file = planar.margin.map_or(0.0, |margin| margin.0);
        planar.margin = Some(Finite(margin.max(of_file)));
    }
    for forbidden in &arguments.forbid {
        if !planar.forbidden.contains(forbidden) {
            planar.forbidden.push(*forbidden);
        }
    }
}

fn question<'a>(arguments: &OptimizeArguments, file: &'a schema::File) -> Question<'a> {
    let rotation = arguments.objective == ObjectiveArgument::Rotation;
    Question {
        version: schema::VERSION,
        dimension: 2,
        units: &file.units,
        part: &file.part,
        fingers: arguments.fingers,
        objective: match arguments.objective {
            ObjectiveArgument::Quality => ObjectiveWord::Quality,
            ObjectiveArgument::WorstPoint => ObjectiveWord::WorstPoint,
            ObjectiveArgument::Rotation => ObjectiveWord::Rotation,
        },
        least_translation: rotation.then(|| arguments.least_translation.unwrap_or(0.0)),
        total_preload: arguments.preload,
        finger_radius: arguments.finger_radius,
        least_distance: arguments.least_distance(),
        least_share: arguments.least_share,
        effort: EffortReport {
            top: arguments.top,
            gap: arguments.gap(),
            time: arguments.time.map(|time| time.as_secs_f64()),
            nodes: arguments.nodes,
        },
    }
}

fn search(
    part: &Part,
    question: &Question<'_>,
    arguments: &OptimizeArguments,
) -> Result<Outcome<2, 1>, OptimizeError> {
    let Question { fingers: count, finger_radius, least_share, .. } = *question;
    let OptimizeArguments { top, time, nodes, .. } = *arguments;
    let effort = Effort { top, gap: arguments.gap(), time, nodes };
    let mut line = ProgressLine::start(UnitNames(question.units).per_length());
    let interrupt = Interrupt::awaited();
    let watch = |progress: &Progress| {
        line.show(progress);
        if interrupt.came() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    if count == 3 {
        let total_preload = arguments.preload.unwrap_or(0.0);
        let question = ThreeFingers { total_preload, finger_radius, least_share };
        return three_fingers(part, &question, &effort, watch);
    }
    let objective = match arguments.objective {
        ObjectiveArgument::Quality => Objective::Quality,
        ObjectiveArgument::WorstPoint => Objective::WorstPoint,
        ObjectiveArgument::Rotation => {
            let least_translation = arguments.least_translation.unwrap_or(0.0);
            Objective::Rotation { least_translation }
        }
    };
    let least_distance = question.least_distance.unwrap_or(0.0);
    fingers(part, &Fingers { count, objective, least_distance, least_share }, &effort, watch)
}

/// What the search refused: by the option that it came from, if there is one.
fn refused(name: &str, error: OptimizeError) -> Failure {
    let option = match error {
        OptimizeError::FingerCount { .. } => "--fingers",
        OptimizeError::TotalPreload { .. } => "--preload",
        OptimizeError::FingerRadius { .. } => "--finger-radius",
        OptimizeError::LeastDistance { .. } => "--least-distance, or else twice --finger-radius",
        OptimizeError::LeastShare { .. } => "--least-share",
        OptimizeError::LeastTranslation { .. } => "--least-translation",
        OptimizeError::Gap { .. } => "--gap",
        _ => return Failure::Search { name: name.to_owned(), source: Box::new(error) },
    };
    Failure::Option { option: option.to_owned(), source: Box::new(error) }
}

fn unanswered(
    arguments: &OptimizeArguments,
    question: &Question<'_>,
    part: &Part,
    error: &OptimizeError,
) -> Result<Answer, Failure> {
    let reason = error.to_string();
    let report = match arguments.output.format {
        Format::Text => String::new(),
        Format::Json => report::json(&UnansweredReport { question, reason: &reason })?,
    };
    let picture = picture::of_outline(part.outline());
    Ok(Answer { report, picture: Some(picture), reason: Some(reason) })
}

/// What the search does not say about a placement.
fn examine<'a>(
    part: &Part,
    solution: &'a Solution<2, 1>,
    arguments: &OptimizeArguments,
) -> Result<Found<'a>, OutOfRange> {
    let force = arguments.preload.unwrap_or(0.0);
    let contacts = solution.placements.iter().map(|p| {
        let law = Law::linear(part.edge_stiffness()[p.on])?;
        // Shares are zero or more up to rounding.
        let preload = (force * p.share).max(0.0);
        Contact::new(
            Geometry::on_face(p.point, p.inward_normal, arguments.finger_radius),
            law,
            preload,
        )
    });
    let grasp = Grasp::new(contacts.collect::<Result<_, _>>()?)?;
    let worst = WorstPoint::of(&solution.principal, part.outline())?;
    let second_order = arguments.preload.map(|_| {
        principal(&grasp, Order::Second)
            .and_then(|principal| Quality::of(&principal, part.outline()))
    });
    Ok(Found { solution, worst, second_order })
}
