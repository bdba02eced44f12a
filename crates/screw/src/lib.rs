//! Frames, twists, wrenches, screws and stiffness, in the plane and in space.
//!
//! A rigid body's small displacement is a [`Twist`], the load on it a [`Wrench`], and the
//! symmetric form between them a [`Stiffness`]. Each is written in some [`Frame`], and this
//! crate changes the frame: eqs. (1), (2) and (7) of Lin, Burdick and Rimon, *A Quality
//! Measure for Compliant Grasps* (LBR in all our documents).
//!
//! Everything is generic over `N` translations and `M` rotations, with two instances:
//! [`planar`] is `<2, 1>` and [`spatial`] is `<3, 3>`. Only their constructors differ.
//!
//! ```
//! use clench_screw::{Stiffness, Vector, Wrench, planar};
//!
//! // A unit force along y that acts at (3, 0) has the torque 3 about the origin ...
//! let at = planar::Frame::at([3.0, 0.0].into());
//! let force = Wrench { force: Vector::new([0.0, 1.0]), torque: Vector::new([0.0]) };
//! assert_eq!(force.to_parent(&at).torque[0], 3.0);
//!
//! // ... and a spring there resists a turn about the origin with k * 3^2.
//! let spring = Stiffness::outer(&force.to_parent(&at)) * 2.0;
//! assert_eq!(spring.rotational[0][0], 18.0);
//! ```
//!
//! # When not to use it
//!
//! The matrices are fixed-size and tiny (3 x 3 at most is ever factorized). For anything
//! larger, or of a size known only at run time, use a linear-algebra library.

mod vector;

mod mat;

mod cholesky;
mod eigen;
mod error;

mod lever;

mod frame;
mod stiffness;
mod twist;
mod wrench;

mod axis;

pub mod planar;
pub mod spatial;

pub use axis::{Axis, Screw};
pub use cholesky::Cholesky;
pub use eigen::SymmetricEigen;
pub use error::ScrewError;
pub use frame::Frame;
pub use lever::{lever, lever_center};
pub use mat::Mat;
pub use stiffness::Stiffness;
pub use twist::Twist;
pub use vector::Vector;
pub use wrench::Wrench;
