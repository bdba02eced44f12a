//! Frame-invariant quality of a compliant grasp.
//!
//! From the stiffness of a grasp, and nothing else about it, follow numbers that do not depend on
//! the frame [LBR, section 3]; with the body's shape they become comparable to each other and to a
//! tolerance [LBR, section 4]. All is one text for the plane, `<2, 1>`, and for space, `<3, 3>`,
//! and for any body that [`clench_shape::Extent`] can be made from. By purpose:
//!
//! | to get | use |
//! | --- | --- |
//! | principal stiffnesses `sigma_i`, `mu_i`, and what they follow from | [`Principal`] |
//! | their axes, and centers | [`Principal::twist_axes`], [`Principal::center`] |
//! | displacements and wrenches of unit energy | [`EnergyEllipsoid`] |
//! | the quality `Q` of the paper | [`Quality`] |
//! | the same over all force-free rotations, `Q_V` | [`EquivalentStiffness::least`] |
//! | the least force per deflection anywhere on the body, `Q_pt` | [`WorstPoint`] |
//! | what a given load does | [`Displacement`] |
//! | how the measures change with the stiffness | [`Sensitivity`] |
//! | the worst of many small changes | [`Sensitivity::worst_case`] |
//! | the one that gains most | [`Sensitivity::best_gain`] |
//!
//! `min(sigma_min, Q_V) / 2 <= Q_pt <= min(sigma_min, Q_V) <= Q`.
//!
//! ```
//! use clench_metrics::{LimitedBy, Principal, Quality};
//! use clench_screw::{Frame, Mat, Vector, planar::Stiffness};
//! use clench_shape::Polygon;
//!
//! // A square of side 2 on four springs: 2 along x, 3 along y, 1 against rotation about (1, 0).
//! let about_center = Stiffness {
//!     translational: Mat::new([[2.0, 0.0], [0.0, 3.0]]),
//!     coupling: Mat::ZERO,
//!     rotational: Mat::new([[1.0]]),
//! };
//! let stiffness = about_center.to_parent(&Frame::at([1.0, 0.0].into()));
//! let principal = Principal::of(Vector::ZERO, &stiffness)?;
//! assert_eq!(principal.center(), Vector::new([1.0, 0.0]));
//! assert_eq!(principal.translational().values, [2.0, 3.0]);
//!
//! let square = Polygon::new(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])?;
//! let quality = Quality::of(&principal, &square)?;
//! // The farthest corner is (-1, +-1), at a squared distance of 5.
//! assert_eq!(quality.limited_by, LimitedBy::Rotation);
//! assert!((quality.value - 1.0 / 5.0).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # When not to use it
//!
//! Everything is proportional to small displacements. A stiffness to second order whose contact
//! forces do not balance depends on the origin, and so do its numbers. That fingers only push is
//! not seen here: whether a grasp can hold at all is asked of the contacts.

mod principal;

mod axes;
mod energy;
mod load;

mod equivalent;
mod quality;
mod worst_point;

mod sensitivity;
mod variation;

mod directions;
mod softness;

mod error;

pub use energy::EnergyEllipsoid;
pub use equivalent::EquivalentStiffness;
pub use error::MetricsError;
pub use load::Displacement;
pub use principal::Principal;
pub use quality::{LimitedBy, Quality, REPEATED};
pub use sensitivity::{Sensitivity, TIED};
pub use variation::{Freedom, Gain, Steepest, Variation, WorstCase};
pub use worst_point::WorstPoint;
