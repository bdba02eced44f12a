//! `clench optimize`: where the fingers go.

use clench::contact::{Contact, ContactError, Geometry, Law, Order};
use clench::metrics::{MetricsError, Quality, WorstPoint};
use clench::optimize::polygon::{FourFingers, Part, ThreeFingers, four_fingers, three_fingers};
use clench::optimize::{OptimizeError, Outcome, Solution};
use clench::stiffness::{Grasp, GraspError};

use crate::answer::Answer;
use crate::arguments::{Fingers, Format, OptimizeArguments};
use crate::failure::Failure;
use crate::held::principal;
use crate::input::{self, Document, schema};
use crate::picture;
use crate::progress::ProgressLine;
use crate::report::{self, OptimumReport, OptimumText, Question, UnansweredReport};

/// A placement that the search found, as a grasp.
#[derive(Debug)]
pub(crate) struct Found<'a> {
    pub(crate) solution: &'a Solution,
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
    let (document, file) = Document::read(&arguments.part)?;
    let part = input::outline_part(&document, &file.part)?;
    let question = question(arguments, &file);
    let outcome = match search(&part, arguments) {
        Ok(outcome) => outcome,
        Err(
            e @ (OptimizeError::NormalsNeverBalance { .. }
            | OptimizeError::TorquesNeverBalance { .. }),
        ) => return unanswered(arguments, &question, &part, &e),
        Err(error) => {
            let (name, source) = (document.name().to_owned(), Box::new(error));
            return Err(Failure::Search { name, source });
        }
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

fn question<'a>(arguments: &OptimizeArguments, file: &'a schema::File) -> Question<'a> {
    Question {
        version: schema::VERSION,
        dimension: 2,
        units: &file.units,
        part: &file.part,
        fingers: match arguments.fingers {
            Fingers::Three => 3,
            Fingers::Four => 4,
        },
        total_preload: arguments.preload,
        finger_radius: arguments.finger_radius,
    }
}

fn search(part: &Part, arguments: &OptimizeArguments) -> Result<Outcome, OptimizeError> {
    let top = arguments.top;
    let mut line = ProgressLine::start();
    match arguments.fingers {
        Fingers::Three => {
            let options = ThreeFingers {
                total_preload: arguments.preload.unwrap_or(0.0),
                finger_radius: arguments.finger_radius,
                top,
            };
            three_fingers(part, &options, |progress| line.watch(progress))
        }
        Fingers::Four => four_fingers(part, &FourFingers { top }, |progress| line.watch(progress)),
    }
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
    solution: &'a Solution,
    arguments: &OptimizeArguments,
) -> Result<Found<'a>, OutOfRange> {
    let force = arguments.preload.unwrap_or(0.0);
    let contacts = solution.placements.iter().map(|p| {
        let law = Law::linear(part.edge_stiffness()[p.edge])?;
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
