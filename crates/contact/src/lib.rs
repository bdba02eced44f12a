//! Compliant contacts: force laws, overlap, its gradient and Hessian, one contact's stiffness.
//!
//! A finger and a body that are pressed together are modeled by the overlap `delta` of their
//! undeformed shapes, and a [`Law`] that gives the contact force as a function of it. From the
//! gradient and the Hessian of the [`Overlap`] follows the [`Contact`]'s share
//!
//! `f'(delta) grad grad^T + f(delta) D^2 delta`
//!
//! of the stiffness of a grasp [LBR, eq. 6]. This crate knows one contact at a time. LBR is Lin,
//! Burdick and Rimon, *A Quality Measure for Compliant Grasps*; Johnson is *Contact Mechanics*.
//!
//! | to get | use |
//! | --- | --- |
//! | a force law with given numbers | [`Law::linear`], [`Law::power`], [`ForceLaw`] for your own |
//! | one from materials and curvatures | [`Elastic`], [`Material`], [`Law::hertz`], [`Law::line`] |
//! | area and pressure of an elliptic contact | [`Hertz`], [`Geometry::relative_curvature`] |
//! | the overlap's gradient and Hessian | [`Geometry`] with [`Curvature`]s, [`Overlap`] |
//! | one contact's stiffness | [`Contact`] |
//! | how it changes with place, law and preload | [`Contact::stiffness_rate`], [`Law::scaled`] |
//!
//! ```
//! use clench_contact::{Contact, Geometry, Law, Order};
//! use clench_screw::Vector;
//!
//! // A disc of radius 0.5 mm on an edge along x, at (2, 0) mm, k = 10 N/mm, pressed by 1 N.
//! let law = Law::linear(10.0)?;
//! let place = Geometry::on_face(Vector::new([2.0, 0.0]), Vector::new([0.0, 1.0]), 0.5);
//! let contact = Contact::<2, 1>::new(place, law, 1.0)?;
//! assert_eq!(contact.overlap().depth(), 0.1);
//!
//! // About the origin: k * 2^2 from the lever arm, and the force times the distance of the
//! // finger's center behind the origin, 0.4 mm.
//! let share = contact.stiffness(Vector::ZERO, Order::Second);
//! assert_eq!(share.rotational[0][0], 10.0 * 2.0 * 2.0 + 1.0 * 0.4);
//! # Ok::<(), clench_contact::ContactError>(())
//! ```
//!
//! # When not to use it
//!
//! Contacts are frictionless, and elastic constants those of small strains. Where finger and part
//! touch has to be known: `clench-shape` finds the deepest points of two bodies. A pair that
//! touches in more than one point, flat on flat, has no smooth overlap and is refused.

mod elastic;
mod law;
mod material;

mod curvature;
mod geometry;
mod tangent;

mod overlap;

mod change;
mod contact;
mod moving;

mod error;

pub use change::Change;
pub use contact::{Contact, Order};
pub use curvature::Curvature;
pub use elastic::{Elastic, effective_modulus};
pub use error::ContactError;
pub use geometry::{Geometry, RelativeCurvature};
pub use law::{CustomLaw, ForceLaw, Hertz, Law, Line, LineContact, Linear, Power};
pub use material::{Material, Units};
pub use overlap::Overlap;
