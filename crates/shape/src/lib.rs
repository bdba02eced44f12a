//! Shapes as the rest of Clench needs them: where to touch a part, how far it reaches, and how
//! deep two bodies overlap.
//!
//! A shape that exists is valid. A [`Polygon`] has at least three corners and a boundary that
//! meets itself nowhere, decided exactly; a [`Polyhedron`] is closed, consistently wound, and
//! does not pass through itself; an [`Ellipsoid`] has positive semi-axes. By purpose:
//!
//! | to ask | use |
//! | --- | --- |
//! | where a finger can touch, and along which normal | [`Polygon::edges`], [`Polyhedron::faces`] |
//! | the same where sides are cut into many faces, as in a mesh | [`Polyhedron::facets`] |
//! | the same on a round body, with the curvature | [`Ellipsoid::at_normal`], [`BoundaryPoint`] |
//! | where a round tip has room to touch | [`Polygon::accessible`], [`Polyhedron::accessible`] |
//! | what of the boundary a given point lies on | [`Polygon::place`], [`Polyhedron::place`] |
//! | the signed distance of a point | [`Ellipsoid::nearest`], [`Polyhedron::signed_distance`] |
//! | how deep two bodies overlap, `delta` | [`planar::deepest_pair`], [`spatial::deepest_pair`] |
//! | the geometric center and radius | [`Polygon::enclosing_circle`] |
//! | how far the part reaches from a point, `rho_max` | [`Polygon::farthest`] |
//! | how far a motion takes any body, its *deflection* | [`Extent::fastest`] |
//! | where anything convex is largest over a body | [`ExtremePoints::farthest_by`] |
//! | the same along a segment, piece by piece | [`Polygon::farthest_along`] |
//! | the regions with one farthest corner, `R_i` | [`Polygon::partition`] |
//!
//! The regions, the center and the radius are those of section 5 of Lin, Burdick and Rimon, *A
//! Quality Measure for Compliant Grasps* (LBR in all our documents).
//!
//! ```
//! use clench_shape::Polygon;
//!
//! // The quadrilateral of LBR, Example 5.1: center (6.5, 1.75), radius 6.7315.
//! let part = Polygon::new(&[[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]])?;
//! let circle = part.enclosing_circle();
//! assert_eq!(circle.center.to_array(), [6.5, 1.75]);
//! assert!((circle.radius - 45.3125_f64.sqrt()).abs() < 1e-14);
//!
//! // From the origin the corner (13, 0) is farthest; edge 0 has the inward normal +y.
//! let reach = part.farthest([0.0, 0.0].into());
//! assert_eq!((reach.corner, reach.distance), (1, 13.0));
//! assert_eq!(part.edges()[0].inward_normal().to_array(), [0.0, 1.0]);
//! # Ok::<(), clench_shape::PolygonError>(())
//! ```
//!
//! # When not to use it
//!
//! Nothing here cuts, offsets or joins shapes; for that use a geometry library. Nor does anything
//! look for contacts between many bodies, or follow them over time; for that use a physics engine.
//! Corners and faces are kept as they are given: an outline with a thousand corners per arc stays
//! one. A solid whose surface passes through itself is refused, not repaired.

mod error;

mod polygon;

mod edge;
mod place;

mod access_error;
mod accessible;
mod disc_tip;
mod plate;

mod circle;
mod extent;
mod extreme_points;
mod reach;
mod stretch;

mod boundary_point;
mod ellipsoid;

mod polyhedron;

mod ball;
mod deepest;
mod point_hull;

pub mod planar;
pub mod spatial;

mod border;
mod partition;

mod hull;
mod loops;
mod predicates;
mod solid_hull;
mod tree;
mod triangulation;
mod validity;

pub use access_error::AccessError;
pub use accessible::MOST_HOLES_AT_EDGE;
pub use ball::Ball;
pub use border::Border;
pub use boundary_point::{BoundaryPoint, Nearest};
pub use circle::Circle;
pub use deepest::{BodyError, DeepestPair, OverlapError, Side};
pub use disc_tip::DiscTip;
pub use edge::Edge;
pub use ellipsoid::{Ellipsoid, EllipsoidError, LARGEST_ASPECT};
pub use error::PolygonError;
pub use extent::Extent;
pub use extreme_points::{ExtremePoints, Farthest};
pub use partition::{FarthestPartition, Region};
pub use place::Place;
pub use plate::Plate;
pub use point_hull::PointHull;
pub use polygon::{Polygon, Winding};
pub use polyhedron::{
    ACCESS_TOLERANCE, AccessibleFacet, BallTip, Face, FaceFeature, FacePlace, Facet, KeepOut,
    LARGEST_SOLID_COORDINATE, MOST_HOLES, Obstruction, Polyhedron, PolyhedronError,
    SMALLEST_SOLID_COORDINATE,
};
pub use reach::Reach;
pub use stretch::Stretch;
pub use validity::{LARGEST_COORDINATE, SMALLEST_COORDINATE};
