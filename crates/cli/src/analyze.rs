//! `clench analyze`: what a given grasp is worth.

use clench::contact::Order;
use clench::metrics::{MetricsError, Principal, Quality, WorstPoint};
use clench::optimize::polygon::Part;
use clench::screw::planar::{Frame, Stiffness};
use clench::stiffness::{Equilibrium, Grasp, Preloads, Stability};

use crate::answer::Answer;
use crate::arguments::{AnalyzeArguments, Format, FrameArgument, OrderArgument};
use crate::failure::Failure;
use crate::input::{self, Document, schema};
use crate::picture;
use crate::report::{self, AnalysisReport, AnalysisText};

/// All that is known of a grasp, in the frame of the file.
#[derive(Debug)]
pub(crate) struct Analysis<'a> {
    pub(crate) units: &'a schema::Units,
    pub(crate) part: &'a Part,
    pub(crate) grasp: &'a Grasp<2, 1>,
    /// The edge of each contact.
    pub(crate) edges: &'a [usize],
    /// The frame to write it in.
    pub(crate) frame: FrameArgument,
    pub(crate) order: Order,
    /// Whether the order follows from the grasp rather than from the command line.
    pub(crate) order_chosen: bool,
    pub(crate) equilibrium: Equilibrium<2, 1>,
    pub(crate) stability: Stability,
    pub(crate) preloads: Preloads,
    pub(crate) metrics: Result<Metrics, MetricsError>,
}

/// The numbers that a grasp has if it holds the part.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Metrics {
    pub(crate) principal: Principal<2, 1>,
    pub(crate) quality: Quality,
    pub(crate) worst: WorstPoint,
}

impl Metrics {
    /// The metrics of a grasp, formed near the part.
    pub(crate) fn of(grasp: &Grasp<2, 1>, order: Order, part: &Part) -> Result<Self, MetricsError> {
        let principal = Principal::near(grasp.centroid(), |o| grasp.stiffness(o, order))?;
        Ok(Self {
            quality: Quality::of(&principal, part.outline()),
            worst: WorstPoint::of(&principal, part.outline())?,
            principal,
        })
    }
}

impl Analysis<'_> {
    /// The stiffness in the frame asked for, formed there: without equilibrium a stiffness that
    /// was formed elsewhere could not be moved.
    pub(crate) fn stiffness(&self) -> Stiffness {
        let about_origin = self.grasp.stiffness(self.frame.origin.into(), self.order);
        about_origin.in_frame(&Frame::new([0.0; 2], self.frame.angle))
    }
}

/// Runs the command.
pub(crate) fn analyze(arguments: &AnalyzeArguments) -> Result<Answer, Failure> {
    let (document, file) = Document::read(&arguments.grasp)?;
    let part = input::planar_part(&document, &file.part)?;
    let found = input::grasp(&document, &file, &part)?;
    let grasp = &found.grasp;
    let equilibrium = grasp.equilibrium();
    let order = match arguments.order {
        Some(OrderArgument::Second) => Order::Second,
        None if equilibrium.holds && grasp.total_preload() > 0.0 => Order::Second,
        Some(OrderArgument::First) | None => Order::First,
    };
    let analysis = Analysis {
        units: &file.units,
        part: &part,
        grasp,
        edges: &found.edges,
        frame: arguments.frame.unwrap_or(FrameArgument::FILE),
        order,
        order_chosen: arguments.order.is_none(),
        equilibrium,
        stability: grasp.stability(),
        preloads: grasp
            .preloads()
            .map_err(|source| Failure::Preloads { name: document.name().to_owned(), source })?,
        metrics: Metrics::of(grasp, order, &part),
    };
    let report = AnalysisReport::new(&analysis);
    let text = match arguments.output.format {
        Format::Text => AnalysisText { name: document.name(), report: &report }.to_string(),
        Format::Json => report::json(&report)?,
    };
    Ok(Answer { report: text, picture: picture::of_analysis(&analysis), reason: report.reason })
}
