//! Where to put the fingers: placements of best quality, with a certificate.
//!
//! [`polygon::three_fingers`] and [`polygon::four_fingers`] find the placement of frictionless
//! fingers on the edges of a polygonal part that maximizes the quality measure of
//! `clench-metrics` over all edges and all places on them. Both enumerate closed forms: there is
//! no starting point, no sampling and nothing to tune, so the answer is the optimum.
//!
//! ```
//! use clench_optimize::polygon::{FourFingers, Part, four_fingers};
//! use clench_shape::Polygon;
//!
//! // LBR, Example 5.2: a quadrilateral, all stiffnesses 1.
//! let outline = Polygon::new(&[[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]])?;
//! let part = Part::uniform(outline, 1.0)?;
//! let best = four_fingers(&part, &FourFingers::default(), |_| {})?.best;
//! assert!((best.quality.value - (2.0 - 0.1_f64.sqrt())).abs() < 1e-12);
//! assert_eq!(best.edges(), [0, 0, 1, 3]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod polygon;

mod outcome;

mod error;

pub use error::OptimizeError;
pub use outcome::{Certificate, Combinations, Outcome, Placement, Progress, Solution};
