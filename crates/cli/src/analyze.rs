//! `clench analyze`: what a given grasp is worth.

use clench::contact::Order;
use clench::metrics::{MetricsError, Principal, Quality, WorstPoint};
use clench::screw::{Stiffness, Vector};
use clench::shape::Polygon;
use clench::stiffness::{Equilibrium, Grasp, Preloads, Stability};
use clench_draw::GraspPicture;

use crate::answer::Answer;
use crate::arguments::{AnalyzeArguments, Format, OrderArgument};
use crate::failure::Failure;
use crate::input::{self, Document, FileGrasp, Part, PlanarShape, Touch, schema};
use crate::picture;
use crate::report::{self, AnalysisReport, AnalysisText};
use crate::view::View;

/// All that is known of a grasp, in the frame of the file.
#[derive(Debug)]
pub(crate) struct Analysis<'a, const N: usize, const M: usize> {
    pub(crate) units: &'a schema::Units,
    pub(crate) grasp: &'a Grasp<N, M>,
    pub(crate) touches: &'a [Touch<N>],
    /// The size of the part: a radius.
    pub(crate) size: f64,
    /// The frame to write it in.
    pub(crate) view: View<N, M>,
    pub(crate) order: Order,
    /// Whether the order follows from the grasp rather than from the command line.
    pub(crate) order_chosen: bool,
    pub(crate) equilibrium: Equilibrium<N, M>,
    pub(crate) stability: Stability,
    pub(crate) preloads: Preloads,
    /// The numbers that a grasp has if it holds the part.
    pub(crate) metrics: Result<Metrics<N, M>, MetricsError>,
}

/// The principal stiffnesses, and what the shape of the part makes of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Metrics<const N: usize, const M: usize> {
    pub(crate) principal: Principal<N, M>,
    /// Only an outline has one so far.
    pub(crate) quality: Option<OutlineQuality>,
}

/// The quality of a grasp of an outline, and its worst point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OutlineQuality {
    pub(crate) quality: Quality,
    pub(crate) farthest: Vector<2>,
    pub(crate) worst: WorstPoint,
    pub(crate) worst_point: Vector<2>,
}

impl OutlineQuality {
    fn of(principal: &Principal<2, 1>, outline: &Polygon) -> Result<Self, MetricsError> {
        let quality = Quality::of(principal, outline);
        let worst = WorstPoint::of(principal, outline)?;
        let [farthest, worst_point] =
            [quality.reach.corner, worst.corner].map(|corner| outline.corners()[corner]);
        Ok(Self { quality, farthest, worst, worst_point })
    }
}

/// The principal stiffnesses of a grasp, formed near the part.
pub(crate) fn principal<const N: usize, const M: usize>(
    grasp: &Grasp<N, M>,
    order: Order,
) -> Result<Principal<N, M>, MetricsError> {
    Principal::near(grasp.centroid(), |origin| grasp.stiffness(origin, order))
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

/// Runs the command.
pub(crate) fn analyze(arguments: &AnalyzeArguments) -> Result<Answer, Failure> {
    let (document, file) = Document::read(&arguments.grasp)?;
    let question = Question { arguments, document: &document, units: &file.units };
    let frame = arguments.frame.as_ref();
    match input::part(&document, &file.part)? {
        Part::Planar(body) => {
            let found = input::planar_grasp(&document, &file, &body)?;
            let view = View::planar(frame)?;
            let analysis = question.analysis(&found, view, |principal| match &body.shape {
                PlanarShape::Outline(outline) => OutlineQuality::of(principal, outline).map(Some),
                PlanarShape::Ellipse(_) => Ok(None),
            })?;
            let picture = picture::of_analysis(&analysis, &body.shape);
            question.answer(&analysis, Some(picture))
        }
        Part::Spatial(body) => {
            let found = input::spatial_grasp(&document, &file, &body)?;
            let analysis = question.analysis(&found, View::spatial(frame)?, |_| Ok(None))?;
            question.answer(&analysis, None)
        }
    }
}

impl<'a> Question<'a> {
    fn analysis<const N: usize, const M: usize>(
        &self,
        found: &'a FileGrasp<N, M>,
        view: View<N, M>,
        quality: impl FnOnce(&Principal<N, M>) -> Result<Option<OutlineQuality>, MetricsError>,
    ) -> Result<Analysis<'a, N, M>, Failure> {
        let grasp = &found.grasp;
        let equilibrium = grasp.equilibrium();
        let forces = grasp.total_preload() > 0.0 || !grasp.loads().is_empty();
        let order = match self.arguments.order {
            Some(OrderArgument::Second) => Order::Second,
            None if equilibrium.holds && forces => Order::Second,
            Some(OrderArgument::First) | None => Order::First,
        };
        let name = || self.document.name().to_owned();
        Ok(Analysis {
            units: self.units,
            grasp,
            touches: &found.touches,
            size: found.radius,
            view,
            order,
            order_chosen: self.arguments.order.is_none(),
            equilibrium,
            stability: grasp.stability(),
            preloads: grasp
                .preloads()
                .map_err(|source| Failure::Preloads { name: name(), source })?,
            metrics: principal(grasp, order)
                .and_then(|principal| Ok(Metrics { quality: quality(&principal)?, principal })),
        })
    }

    fn answer<const N: usize, const M: usize>(
        &self,
        analysis: &Analysis<'_, N, M>,
        picture: Option<GraspPicture>,
    ) -> Result<Answer, Failure> {
        let report = AnalysisReport::new(analysis);
        let text = match self.arguments.output.format {
            Format::Text => {
                AnalysisText { name: self.document.name(), report: &report }.to_string()
            }
            Format::Json => report::json(&report)?,
        };
        Ok(Answer { report: text, picture, reason: report.reason })
    }
}
