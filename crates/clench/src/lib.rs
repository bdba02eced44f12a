//! How well a compliant grasp or fixture holds a part, and where to put the fingers.
//!
//! This crate is the front door: it holds no code of its own, and re-exports the layers under
//! their short names. Pick a single one when you need no more:
//!
//! | to ... | use |
//! | --- | --- |
//! | change the frame of twists, wrenches and stiffnesses | [`screw`] |
//! | validate outlines and solids, find where to touch them and how far they reach | [`shape`] |
//! | take an outline with its holes from a DXF or SVG file | [`drawing`] |
//! | get the stiffness of one contact from materials, curvatures and preload | [`contact`] |
//! | get energy, equilibrium, preload, stiffness and stability of a grasp | [`stiffness`] |
//! | get frame-invariant numbers from any stiffness | [`metrics`] |
//! | find the best placement of fingers | [`optimize`] |
//!
//! ```
//! use clench::contact::{Contact, Geometry, Law, Order};
//! use clench::metrics::{Principal, Quality};
//! use clench::shape::Polygon;
//! use clench::stiffness::Grasp;
//!
//! // LBR, figure 1: four pointed fingers on a quadrilateral.
//! let outline = Polygon::new(&[[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]])?;
//! let mut contacts = Vec::new();
//! for (edge, along) in [(0, 0.0), (0, 13.0), (1, 80.0_f64.sqrt()), (3, 0.0)] {
//!     let edge = &outline.edges()[edge];
//!     let (point, normal) = (edge.point_at(along), edge.inward_normal());
//!     let place = Geometry::on_face(point, normal, 0.0);
//!     contacts.push(Contact::<2, 1>::new(place, Law::linear(1.0)?, 0.0)?);
//! }
//! let grasp = Grasp::new(contacts)?;
//! let principal =
//!     Principal::near(grasp.centroid(), |origin| grasp.stiffness(origin, Order::First))?;
//! let quality = Quality::of(&principal, &outline)?;
//!
//! let center = principal.center();
//! assert!((center[0] - 80.0 / 13.0).abs() < 1e-14 && (center[1] - 72.0 / 13.0).abs() < 1e-14);
//! assert!((quality.translational - (2.0 - 0.1_f64.sqrt())).abs() < 1e-14);
//! assert!((quality.value - 1.1138).abs() < 5e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The guide is in `docs/guide` of the repository: *From material and geometry to stiffness* goes
//! from elastic constants to the stability of a pinched bar; *What does not depend on the frame*
//! from a stiffness to the measures of how well it holds; *Where to put fingers on a solid* on to
//! placements with a bound.

pub use clench_contact as contact;
pub use clench_drawing as drawing;
pub use clench_metrics as metrics;
pub use clench_optimize as optimize;
pub use clench_screw as screw;
pub use clench_shape as shape;
pub use clench_stiffness as stiffness;

/// The examples of the documents run as tests.
#[cfg(doctest)]
mod documents {
    #[doc = include_str!("../../../README.md")]
    struct Readme;

    #[doc = include_str!("../../../docs/guide/stiffness.md")]
    struct Stiffness;

    #[doc = include_str!("../../../docs/guide/measures.md")]
    struct Measures;

    #[doc = include_str!("../../../docs/guide/solids.md")]
    struct Solids;
}
