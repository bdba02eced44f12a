//! Part outlines as the rest of Clench needs them: edges to touch, and how far the part reaches.
//!
//! A [`Polygon`] is valid by construction: at least three corners, a boundary that meets itself
//! nowhere, decided exactly. From it come, by purpose:
//!
//! | to ask | use |
//! | --- | --- |
//! | where a finger can touch, and along which normal | [`Polygon::edges`], [`Edge`] |
//! | which edge a given point lies on | [`Polygon::place`] |
//! | the geometric center and radius | [`Polygon::enclosing_circle`] |
//! | how far the part reaches from a point, `rho_max` | [`Polygon::farthest`] |
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
//! Nothing here cuts, offsets or joins outlines; for that use a polygon library. The corners are
//! kept as they are given: an outline with a thousand corners per arc stays one.

mod error;

mod polygon;

mod edge;
mod place;

mod circle;
mod reach;
mod stretch;

mod border;
mod partition;

mod hull;
mod predicates;
mod tree;
mod triangulation;
mod validity;

pub use border::Border;
pub use circle::Circle;
pub use edge::Edge;
pub use error::PolygonError;
pub use partition::{FarthestPartition, Region};
pub use place::Place;
pub use polygon::{Polygon, Winding};
pub use reach::Reach;
pub use stretch::Stretch;
pub use validity::{LARGEST_COORDINATE, SMALLEST_COORDINATE};
