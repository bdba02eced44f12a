//! Pictures of parts and solids, fingers, contacts and energy ellipsoids, and charts.
//!
//! | to draw | use |
//! | --- | --- |
//! | a planar part with its fingers, center of compliance and numbers | [`GraspPicture`] |
//! | a polyhedral solid with its fingers, screw axes and worst point | [`SolidPicture`] |
//! | the cross-section of one contact, to scale | [`ContactPicture`] |
//! | the energy ellipsoids of a planar grasp in two frames | [`EnergyEllipsoids`] |
//! | how numbers change along one variable | [`Chart`] |
//!
//! All give a [`Figure`].
//!
//! This crate computes no metric: every number it shows is given to it, and what it works out
//! itself is where things stand on the page. It takes plain arrays, so it draws what any
//! program found. Pictures are SVG text; with the feature `png` also PNG files, whose letters
//! come from a bundled font. The same input gives the same bytes.
//!
//! It is not a plotting library: a chart shows a few curves in one field, and a scene of several
//! solids other than the two ellipsoids is better served by a renderer.
//!
//! LBR is Lin, Burdick, Rimon, "A Quality Measure for Compliant Grasps".
//!
//! ```
//! use clench_draw::{Finger, GraspPicture, Mark};
//!
//! let finger = |label: &str, point, inward_normal| Finger {
//!     point,
//!     inward_normal,
//!     label: label.into(),
//!     ..Finger::default()
//! };
//! let picture = GraspPicture {
//!     outline: vec![[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]],
//!     fingers: vec![finger("1", [2.0, 0.0], [0.0, 1.0]), finger("2", [2.0, 2.0], [0.0, -1.0])],
//!     center: Some(Mark { point: [2.0, 1.0], label: "c".into() }),
//!     caption: vec!["σ_{min} = 0".into()],
//!     ..GraspPicture::default()
//! };
//! let svg = picture.figure()?.to_svg();
//! // The part is fitted into 440 page units: 110 a unit.
//! assert!(svg.contains("M0 300L440 300L440 80L0 80Z"));
//! # Ok::<(), clench_draw::DrawError>(())
//! ```

mod grasp;

mod solid;

mod contact;

mod energy;

mod chart;

mod figure;
#[cfg(feature = "png")]
mod png;

mod arc;
mod caption;
mod labels;
mod page_box;
mod paint;
mod text;
mod ticks;

mod error;
mod exaggeration;
mod number;
mod view;
mod world_map;

pub use chart::{Band, Chart, ChartAxis, ChartMark, Curve, LineStyle, Tick, Veil};
pub use contact::ContactPicture;
pub use energy::{EnergyEllipsoids, EnergySpace};
pub use error::{DrawError, Input};
pub use exaggeration::exaggeration;
pub use figure::Figure;
pub use grasp::{Direction, Displaced, Finger, GraspPicture, Load, Mark, Region, Way};
pub use paint::Color;
#[cfg(feature = "png")]
pub use png::RASTER_LIMIT;
pub use solid::{
    SolidAxis, SolidDisplaced, SolidFace, SolidFinger, SolidLoad, SolidMark, SolidPicture,
    SolidWorst,
};
