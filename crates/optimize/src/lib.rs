//! Where to put the fingers: placements of best quality, with a certificate.
//!
//! [`polygon::fingers`] and [`polygon::three_fingers`] find the placement of frictionless fingers
//! on the edges of a polygonal part that maximizes the quality measure of `clench-metrics`, or
//! another objective, over all edges and all places on them, under conditions if there are any.
//! Branch and bound leaves out what cannot be best, closed forms solve what is left, and the answer
//! comes with an upper bound that holds, whenever the search is stopped.
//!
//! ```
//! use clench_optimize::polygon::{Fingers, Part, fingers};
//! use clench_optimize::{Effort, Ended, unwatched};
//! use clench_shape::Polygon;
//!
//! // LBR, Example 5.2: a quadrilateral, all stiffnesses 1.
//! let outline = Polygon::new(&[[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]])?;
//! let part = Part::uniform(outline, 1.0)?;
//! let found = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched)?;
//! assert_eq!(found.certificate.ended, Ended::Proved);
//! let best = found.best;
//! assert!((best.quality.value - (2.0 - 0.1_f64.sqrt())).abs() < 1e-12);
//! assert_eq!(best.touched(), [0, 0, 1, 3]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod polygon;
pub mod polyhedron;

mod search;
mod shares;

mod effort;
mod objective;
mod outcome;

mod error;

pub use effort::{Effort, Ended, unwatched};
pub use error::OptimizeError;
pub use objective::Objective;
pub use outcome::{Certificate, Combinations, Outcome, Placement, Progress, Solution};
