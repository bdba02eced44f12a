//! `clench optimize`: where the fingers go.

mod found;
mod outline;
mod room;
mod solid;

use std::ops::ControlFlow;
use std::path::PathBuf;

use clench::optimize::{Effort, OptimizeError, Progress};
use clench_draw::DrawError;

use crate::answer::Answer;
use crate::arguments::{Format, ObjectiveArgument, OptimizeArguments};
use crate::failure::Failure;
use crate::input::{self, Document, TouchablePart, schema};
use crate::interrupt::Interrupt;
use crate::picture::{Figures, Picture};
use crate::progress::ProgressLine;
use crate::report::html::{self, Inputs, Source};
use crate::report::{
    self, EffortReport, ObjectiveWord, OptimumText, Question, UnansweredReport, UnitNames,
};
use crate::wording::counted;

pub(crate) use found::{Found, Held, On, OutOfRange};

/// What a report shows besides its words, and what it was made from.
struct Shown {
    picture: Picture,
    /// The pictures of a page, if one is asked for.
    figures: Option<Figures>,
    /// The files of the command line.
    texts: Vec<Source>,
    /// The files that these name.
    besides: Vec<PathBuf>,
}

/// Runs the command.
pub(crate) fn optimize(arguments: &OptimizeArguments) -> Result<Answer, Failure> {
    let (document, mut file) = input::part_file(&arguments.part, &arguments.of_part.alone())?;
    let asked = arguments.of_part.asked(&arguments.forbid);
    let drawn = input::drawn(&document, &mut file, &asked)?;
    match input::touchable_part(&document, &file.part)? {
        TouchablePart::Outline(part) => {
            outline::optimize(arguments, (&document, drawn.as_ref()), file, *part)
        }
        TouchablePart::Solid(body) => solid::optimize(arguments, &document, file, &body),
    }
}

/// The question, but for what only an outline or only a solid has.
fn question<'a>(
    arguments: &OptimizeArguments,
    file: &'a schema::File,
    (dimension, effort): (u8, &Effort),
) -> Question<'a> {
    let maximized = arguments.maximized(dimension);
    let rotation = maximized == ObjectiveArgument::Rotation;
    Question {
        version: schema::VERSION,
        dimension,
        units: &file.units,
        part: &file.part,
        drawing: None,
        fingers: arguments.fingers,
        objective: match maximized {
            ObjectiveArgument::Quality => ObjectiveWord::Quality,
            ObjectiveArgument::WorstPoint => ObjectiveWord::WorstPoint,
            ObjectiveArgument::Rotation if dimension == 3 => ObjectiveWord::AnyRotation,
            ObjectiveArgument::Rotation => ObjectiveWord::Rotation,
        },
        least_translation: rotation.then(|| arguments.least_translation.unwrap_or(0.0)),
        total_preload: arguments.preload,
        finger_radius: arguments.finger_radius,
        least_share: arguments.least_share,
        most_on_face: None,
        roundness: None,
        flatness: None,
        clearance: arguments.clearance,
        warnings: &[],
        effort: EffortReport {
            top: effort.top,
            gap: effort.gap,
            time: effort.time.map(|time| time.as_secs_f64()),
            nodes: effort.nodes,
        },
    }
}

/// That what only `analyze` takes is left aside, if the file has any; a report has contacts as
/// its results.
fn left_aside(document: &Document, file: &schema::File) -> Vec<String> {
    let tolerances = usize::from(file.contact_tolerances.is_some());
    let fields = [
        ("contacts", file.contacts.len()),
        ("loads", file.loads.len()),
        ("points", file.points.len()),
        ("load_cases", file.load_cases.len()),
        ("contact_tolerances", tolerances),
    ];
    let given = fields.into_iter().filter(|(_, count)| *count > 0 && !document.is_report());
    let names: Vec<String> = given.map(|(name, _)| format!("`{name}`")).collect();
    if names.is_empty() {
        return Vec::new();
    }
    let names = names.join(", ");
    vec![format!("{names} of the file have no say in where fingers go: `analyze` takes them")]
}

/// What `search` finds while a line shows how far it is, and Ctrl-C ends it.
fn watched<R>(
    units: &schema::Units,
    search: impl FnOnce(&mut dyn FnMut(&Progress) -> ControlFlow<()>) -> R,
) -> R {
    let mut line = ProgressLine::start(UnitNames(units).per_length());
    let interrupt = Interrupt::awaited();
    search(&mut |progress| {
        line.show(progress);
        if interrupt.came() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })
}

/// Whether the question was sound, but has no answer.
const fn is_unanswered(error: &OptimizeError) -> bool {
    matches!(
        error,
        OptimizeError::NormalsNeverBalance { .. }
            | OptimizeError::TorquesNeverBalance { .. }
            | OptimizeError::ConditionsNeverMet { .. }
            | OptimizeError::MotionStaysFree { .. }
            | OptimizeError::AlwaysEscapes { .. }
            | OptimizeError::NeverHeld { .. }
            | OptimizeError::NothingFound { .. }
            | OptimizeError::NothingAccessible { .. }
            | OptimizeError::NowhereToTouch
            | OptimizeError::CandidatesObstructed { .. }
    )
}

/// What the search refused: by the option that it came from, if there is one.
fn refused(name: &str, error: OptimizeError) -> Failure {
    let option = match error {
        OptimizeError::FingerCount { .. } => "--fingers",
        OptimizeError::TooFewContacts { .. } | OptimizeError::TooManyContacts { .. } => {
            "--fingers and --fix"
        }
        OptimizeError::TooFewCandidates { .. } | OptimizeError::CandidatesObstructed { .. } => {
            "--candidates"
        }
        OptimizeError::Clearance { .. } => "--clearance",
        OptimizeError::TotalPreload { .. } => "--preload",
        OptimizeError::FingerRadius { .. } => "--finger-radius",
        OptimizeError::LeastShare { .. } => "--least-share",
        OptimizeError::LeastTranslation { .. } => "--least-translation",
        OptimizeError::Roundness { .. } => "--roundness",
        OptimizeError::Gap { .. } => "--gap",
        _ => return Failure::Search { name: name.to_owned(), source: Box::new(error) },
    };
    Failure::Option { option: option.to_owned(), source: Box::new(error) }
}

fn out_of_range(name: &str) -> impl Fn(OutOfRange) -> Failure {
    |error| Failure::Range { name: name.to_owned(), source: Box::new(error) }
}

/// The pictures of a page, if one is asked for.
fn drawn(
    arguments: &OptimizeArguments,
    figures: impl FnOnce() -> Result<Figures, DrawError>,
) -> Result<Option<Figures>, Failure> {
    Ok(arguments.output.report.as_ref().map(|_| figures()).transpose()?)
}

/// The answer with the best placement.
fn answered(
    arguments: &OptimizeArguments,
    words: &OptimumText<'_>,
    Shown { picture, figures, texts, besides }: Shown,
) -> Result<Answer, Failure> {
    let text = match arguments.output.format {
        Format::Text => words.to_string(),
        Format::Json => report::json(words.report)?,
    };
    let mut page = None;
    if let Some(figures) = &figures {
        let inputs = Inputs { texts: &texts, others: &besides };
        page = Some(html::of_optimum(words, figures, inputs)?);
    }
    let picture = Some(picture);
    Ok(Answer { report: text, page, picture, besides, reason: None, failed_check: None })
}

/// The answer that there is none: no picture and no page, which would replace those of before.
fn unanswered(
    arguments: &OptimizeArguments,
    question: &Question<'_>,
    error: &OptimizeError,
) -> Result<Answer, Failure> {
    let reason = match error {
        OptimizeError::NothingFound { fingers, upper_bound, .. } => format!(
            "the search for {} was stopped before it found a placement; none is better than {}",
            counted(*fingers, "finger"),
            UnitNames(question.units).stiffness(*upper_bound)
        ),
        _ => error.to_string(),
    };
    let report = match arguments.output.format {
        Format::Text => String::new(),
        Format::Json => report::json(&UnansweredReport { question, reason: &reason })?,
    };
    let (page, picture, besides) = (None, None, Vec::new());
    Ok(Answer { report, page, picture, besides, reason: Some(reason), failed_check: None })
}
