//! Compliant grasps: energy, equilibrium, preload, stiffness and stability.
//!
//! A [`Grasp`] is a body held by contacts. From their laws and geometry follow its potential
//! energy [LBR, eq. 4], whether they balance [LBR, eq. 5], its stiffness to first and second
//! order [LBR, eq. 6], how stable it is, which preloads could balance, and whether the contacts
//! can hold the body at all when they can only push ([`Preloads::force_closure`]). The last is
//! decided apart from the stiffness: a stiffness can be positive definite while the body can be
//! pulled out.
//!
//! ```
//! use clench_contact::{Contact, Geometry, Law, Order};
//! use clench_screw::Vector;
//! use clench_stiffness::{Grasp, Stability};
//!
//! // Four pointed fingers on a square of side 2, a little off the middle of its sides.
//! let finger = |x: f64, y: f64, nx: f64, ny: f64| {
//!     let place = Geometry::on_face(Vector::new([x, y]), Vector::new([nx, ny]), 0.0);
//!     Contact::<2, 1>::new(place, Law::linear(1.0)?, 0.1)
//! };
//! let grasp = Grasp::new(vec![
//!     finger(0.5, -1.0, 0.0, 1.0)?,
//!     finger(1.0, 0.5, -1.0, 0.0)?,
//!     finger(-0.5, 1.0, 0.0, -1.0)?,
//!     finger(-1.0, -0.5, 1.0, 0.0)?,
//! ])?;
//! let about_center = grasp.stiffness(Vector::ZERO, Order::First);
//! assert_eq!(about_center.translational[0], [2.0, 0.0]);
//! assert_eq!(about_center.rotational[0][0], 4.0 * 0.5 * 0.5);
//! assert_eq!(grasp.stability(), Stability::FirstOrder);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod grasp;
mod load;

mod equilibrium;
mod needed_preloads;
mod preloads;
mod reactions;
mod response;
mod stability;

mod error;

pub use equilibrium::{BALANCED, Equilibrium};
pub use error::GraspError;
pub use grasp::Grasp;
pub use load::DeadLoad;
pub use needed_preloads::{Basis, LeastPreloads, Needed, NeededPreloads, Remedy};
pub use preloads::{BestPreload, Preloads};
pub use reactions::reactions;
pub use response::LiftOff;
pub use stability::Stability;
