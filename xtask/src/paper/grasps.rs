//! The paper's examples, computed through the public crates.

use clench::contact::{Contact, ContactError, Geometry, Law, Order};
use clench::metrics::{MetricsError, Principal};
use clench::optimize::polygon::{
    Fingers, Part, ThreeFingers, fingers, three_fingers, three_fingers_on,
};
use clench::optimize::{Effort, OptimizeError, Outcome, Solution, unwatched};
use clench::screw::Vector;
use clench::shape::{Edge, Polygon, PolygonError};
use clench::stiffness::{Grasp, GraspError};

/// The quadrilateral ABCD of Examples 5.1 and 5.2.
const QUADRILATERAL: [[f64; 2]; 4] = [[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]];

/// The edge triplets of Figure 4: (AB, BC, CD) and (AB, BC, DA).
const TRIPLETS: [[usize; 3]; 2] = [[0, 1, 2], [0, 1, 3]];

/// Why a number of the paper could not be computed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub(crate) enum PaperError {
    /// The outline was refused.
    #[error(transparent)]
    Outline(#[from] PolygonError),
    /// A contact was refused.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// A grasp was refused.
    #[error(transparent)]
    Grasp(#[from] GraspError),
    /// A grasp has no quality.
    #[error(transparent)]
    Metrics(#[from] MetricsError),
    /// A search found nothing.
    #[error(transparent)]
    Optimize(#[from] OptimizeError),
    /// An edge triplet holds nothing.
    #[error("no placement on the edges {edges:?} holds the quadrilateral")]
    Triplet {
        /// The edges.
        edges: [usize; 3],
    },
}

/// Everything that the paper prints a number or draws a figure of.
#[derive(Debug)]
pub(crate) struct Paper {
    /// The quadrilateral with stiffness 1 on each edge.
    pub(crate) part: Part,
    /// Of the grasp of Figures 1 and 2.
    pub(crate) figure_1: Principal<2, 1>,
    /// Grasps I and II of Example 5.1, for a total preload of 1.
    pub(crate) triplets: [Solution<2, 1>; 2],
    /// The best of all triplets.
    pub(crate) three: Outcome<2, 1>,
    /// Example 5.2.
    pub(crate) four: Outcome<2, 1>,
}

impl Paper {
    pub(crate) fn compute() -> Result<Self, PaperError> {
        let part = Part::uniform(Polygon::new(&QUADRILATERAL)?, 1.0)?;
        let options = ThreeFingers::with_preload(1.0);
        let on = |edges| -> Result<Solution<2, 1>, PaperError> {
            three_fingers_on(&part, edges, &options)?.ok_or(PaperError::Triplet { edges })
        };
        Ok(Self {
            figure_1: figure_1(part.outline())?,
            triplets: [on(TRIPLETS[0])?, on(TRIPLETS[1])?],
            three: three_fingers(&part, &options, &Effort::default(), unwatched)?,
            four: fingers(&part, &Fingers::new(4), &Effort::default(), unwatched)?,
            part,
        })
    }
}

/// Fingers at A and B on AB, at C on BC and at D on DA.
fn figure_1(outline: &Polygon) -> Result<Principal<2, 1>, PaperError> {
    let edges = outline.edges();
    let ends = [(0, 0.0), (0, edges[0].length()), (1, edges[1].length()), (3, 0.0)];
    let fingers = ends.map(|(edge, along)| finger(edges[edge].point_at(along), &edges[edge]));
    principal(&Grasp::new(fingers.into_iter().collect::<Result<_, _>>()?)?)
}

/// A pointed finger with `k = 1` and no preload, at a point of an edge.
pub(super) fn finger(point: Vector<2>, edge: &Edge) -> Result<Contact<2, 1>, ContactError> {
    Contact::new(Geometry::on_face(point, edge.inward_normal(), 0.0), Law::linear(1.0)?, 0.0)
}

/// The principal parameters to first order.
pub(super) fn principal(grasp: &Grasp<2, 1>) -> Result<Principal<2, 1>, PaperError> {
    let about = |origin| grasp.stiffness(origin, Order::First);
    Ok(Principal::near(grasp.centroid(), about)?)
}
