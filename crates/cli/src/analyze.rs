//! `clench analyze`: what a given grasp is worth.

use std::io;
use std::path::PathBuf;

use clench::contact::Order;
use clench::screw::{Stiffness, Vector};
use clench::shape::Extent;
use clench::stiffness::{Equilibrium, Grasp, Preloads};
use clench_draw::DrawError;

use crate::answer::Answer;
use crate::arguments::{AnalyzeArguments, Format, OrderArgument};
use crate::color::Paint;
use crate::failure::Failure;
use crate::held::{Classes, NotHeld, Slack, held};
use crate::input::{
    self, Asked, Document, FileGrasp, LoadFault, NamedPoint, Part, Piece, Place, SpatialShape,
    schema,
};
use crate::metrics::Metrics;
use crate::picture::{self, Figures, Picture};
use crate::report::html::{self, Inputs};
use crate::report::{self, AnalysisReport, AnalysisText, DrawingReport};
use crate::response::{Remedies, Response};
use crate::robustness::Robustness;
use crate::view::View;

/// All that is known of a grasp, in the frame of the file.
#[derive(Debug)]
pub(crate) struct Analysis<'a, const N: usize, const M: usize> {
    pub(crate) units: &'a schema::Units,
    pub(crate) grasp: &'a Grasp<N, M>,
    pub(crate) pieces: &'a [Option<Piece>],
    /// The size of the part: a radius.
    pub(crate) size: f64,
    /// The frame to write it in.
    pub(crate) view: View<N, M>,
    pub(crate) order: Order,
    /// Whether the order follows from the grasp rather than from the command line.
    pub(crate) order_chosen: bool,
    pub(crate) equilibrium: Equilibrium<N, M>,
    pub(crate) classes: Classes,
    pub(crate) preloads: Preloads,
    /// Whether loads press the part on its fingers: some act, and all balances.
    pub(crate) loaded: bool,
    pub(crate) slack: Option<Slack>,
    /// The numbers that a grasp has if it holds the part.
    pub(crate) metrics: Result<Metrics<N, M>, NotHeld>,
    pub(crate) points: &'a [NamedPoint<N>],
    /// How the measures change with the contacts, if that is asked for and the part is held.
    pub(crate) robustness: Option<Robustness<N>>,
    /// To the load cases, in their order; none if the part is not held.
    pub(crate) responses: Vec<Response<'a, N, M>>,
    /// The preloads that the load cases need, if there are any.
    pub(crate) needed: Option<Remedies>,
    /// How many load cases have no response, since the part is not held.
    pub(crate) unanswered: usize,
}

impl<const N: usize, const M: usize> Analysis<'_, N, M> {
    /// A stiffness in the frame asked for, formed there by `about`: without equilibrium a
    /// stiffness that was formed elsewhere could not be moved.
    pub(crate) fn stiffness(
        &self,
        about: impl Fn(Vector<N>) -> Stiffness<N, M>,
    ) -> Stiffness<N, M> {
        about(self.view.frame().origin()).in_frame(&self.view.turn())
    }
}

/// The command line, and the file that it names.
struct Question<'a> {
    arguments: &'a AnalyzeArguments,
    document: &'a Document,
    units: &'a schema::Units,
}

/// What a report shows besides its words, and what it was made from.
struct Shown {
    picture: Picture,
    /// The pictures of a page, if one is asked for.
    figures: Option<Figures>,
    /// The files that the grasp file names.
    besides: Vec<PathBuf>,
}

/// Runs the command.
pub(crate) fn analyze(arguments: &AnalyzeArguments) -> Result<Answer, Failure> {
    let (document, mut file) = Document::read(&arguments.grasp)?;
    if arguments.check && file.load_cases.is_empty() {
        return Err(Failure::NothingToCheck { name: document.name().to_owned() });
    }
    let drawn = input::drawn(&document, &mut file, &Asked::default())?;
    let question = Question { arguments, document: &document, units: &file.units };
    let frame = arguments.frame.as_ref();
    match input::part(&document, &file.part)? {
        Part::Planar(body) => {
            let found = input::planar_grasp(&document, &file, &body)?;
            let view = View::planar(frame)?;
            let analysis = question.analysis(&found, body.shape.extent(), view)?;
            let picture = picture::of_analysis(&analysis, &body.shape);
            let figures = question.shown(|| Figures::of_analysis(&analysis, &picture))?;
            let drawing = drawn.as_ref().map(DrawingReport::new);
            let besides = drawn.map(|drawn| drawn.path).into_iter().collect();
            let shown = Shown { picture: Picture::Outline(picture), figures, besides };
            question.answer(AnalysisReport { drawing, ..AnalysisReport::planar(&analysis) }, shown)
        }
        Part::Spatial(body) => {
            let found = input::spatial_grasp(&document, &file, &body)?;
            let view = View::spatial(frame)?;
            let analysis = question.analysis(&found, body.shape.extent(), view)?;
            let picture = picture::of_analysis_in_space(&analysis, &body.shape);
            let figures = question.shown(|| Figures::of_analysis_in_space(&analysis, &picture))?;
            let besides = input::mesh_file(&document, &file.part).into_iter().collect();
            let shown = Shown { picture: Picture::Solid(picture), figures, besides };
            let mut report = AnalysisReport::spatial(&analysis);
            if let SpatialShape::Polyhedron(solid) = &body.shape {
                report.warnings.extend(report::in_pieces(solid.polyhedron.pieces()));
            }
            question.answer(report, shown)
        }
    }
}

impl<'a> Question<'a> {
    fn analysis<const N: usize, const M: usize>(
        &self,
        found: &'a FileGrasp<N, M>,
        body: Extent<'_, N>,
        view: View<N, M>,
    ) -> Result<Analysis<'a, N, M>, Failure> {
        let grasp = &found.grasp;
        let equilibrium = grasp.equilibrium();
        let order = self.order(grasp);
        let name = || self.document.name().to_owned();
        let preloads = grasp.preloads();
        let preloads = preloads.map_err(|source| Failure::Preloads { name: name(), source })?;
        let loads = grasp.loads().iter().any(|load| load.force.max_abs() > 0.0);
        let loaded = loads && equilibrium.holds;
        let classes = Classes::of(grasp);
        let metrics = held(grasp, order, classes.to_order(order))
            .and_then(|principal| Metrics::of(principal, body).map_err(NotHeld::One));
        let needed = (metrics.is_ok() && !found.load_cases.is_empty()).then(|| {
            Remedies::of(found, self.arguments.reserve, |grasp| self.order(grasp))
                .map_err(|source| Failure::Preloads { name: name(), source })
        });
        let responses = match &metrics {
            Ok(metrics) => self.responses(found, metrics, body)?,
            Err(_) => Vec::new(),
        };
        let asked = self.arguments.robustness || found.tolerances.is_some();
        let robustness = metrics.as_ref().ok().filter(|_| asked);
        let robustness = robustness.and_then(|metrics| Robustness::of(found, metrics, body, order));
        Ok(Analysis {
            units: self.units,
            grasp,
            pieces: &found.pieces,
            size: found.radius,
            view,
            order,
            order_chosen: self.arguments.order.is_none(),
            equilibrium,
            classes,
            slack: Slack::of(grasp, &preloads, order, loaded),
            preloads,
            loaded,
            metrics,
            robustness,
            points: &found.points,
            needed: needed.transpose()?,
            unanswered: found.load_cases.len() - responses.len(),
            responses,
        })
    }

    /// What is in the stiffness of `grasp`.
    fn order<const N: usize, const M: usize>(&self, grasp: &Grasp<N, M>) -> Order {
        let forces = grasp.total_preload() > 0.0 || !grasp.loads().is_empty();
        match self.arguments.order {
            Some(OrderArgument::Second) => Order::Second,
            None if forces && grasp.equilibrium().holds => Order::Second,
            Some(OrderArgument::First) | None => Order::First,
        }
    }

    fn responses<const N: usize, const M: usize>(
        &self,
        found: &'a FileGrasp<N, M>,
        metrics: &Metrics<N, M>,
        body: Extent<'_, N>,
    ) -> Result<Vec<Response<'a, N, M>>, Failure> {
        let response = |(number, load)| {
            let case = Place::load_case(number);
            let response = Response::of(load, &found.grasp, &metrics.principal, body)
                .ok_or_else(|| self.document.error(&case, LoadFault::OutOfRange))?;
            let Some(lost) = response.out_of_range(&found.points) else { return Ok(response) };
            let fault = LoadFault::PointOutOfRange { case };
            Err(self.document.error(&Place::named_point(lost), fault))
        };
        found.load_cases.iter().enumerate().map(response).collect()
    }

    /// The pictures of a page, if one is asked for.
    fn shown(
        &self,
        figures: impl FnOnce() -> Result<Figures, DrawError>,
    ) -> Result<Option<Figures>, Failure> {
        Ok(self.arguments.output.report.as_ref().map(|_| figures()).transpose()?)
    }

    fn answer(
        &self,
        report: AnalysisReport<'_>,
        Shown { picture, figures, besides }: Shown,
    ) -> Result<Answer, Failure> {
        let output = &self.arguments.output;
        let words = |paint| AnalysisText { name: self.document.name(), report: &report, paint };
        let text = match output.format {
            Format::Text => words(output.color.paint(&io::stdout())).to_string(),
            Format::Json => report::json(&report)?,
        };
        let mut page = None;
        if let Some(figures) = &figures {
            let inputs = Inputs { texts: &self.document.sources(), others: &besides };
            page = Some(html::of_analysis(&words(Paint::Plain), figures, inputs)?);
        }
        let failed = report.verdict.filter(|verdict| self.arguments.check && !verdict.passes);
        let failed_check = failed.map(|verdict| verdict.reasons.join("; "));
        let (picture, reason) = (Some(picture), report.reason);
        Ok(Answer { report: text, page, picture, besides, reason, failed_check })
    }
}
