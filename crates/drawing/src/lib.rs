//! Drawings of parts: outlines with holes from DXF and SVG.
//!
//! A [`Sheet`] is what a file has on it: curves, on layers, in a unit. Its [`part`](Sheet::part)
//! is a validated [`Polygon`](clench_shape::Polygon): curves become chains of edges, ends that
//! meet are joined, the largest contour is the outline and those within it are holes. The
//! [`DrawnPart`] knows where each edge is from, and what of the file is no part of it.
//!
//! ```
//! use std::f64::consts::PI;
//!
//! use clench_drawing::Sheet;
//!
//! let svg = br#"<svg xmlns="http://www.w3.org/2000/svg" width="80mm" height="60mm"
//!                    viewBox="0 0 80 60">
//!   <rect id="plate" width="80" height="60"/>
//!   <circle id="bore" cx="20" cy="30" r="5"/>
//!   <text x="5" y="5">4 mm steel</text>
//! </svg>"#;
//! let sheet = Sheet::from_svg(svg, &[])?; // or Sheet::read("plate.svg", &["OUTLINE", "BORES"])
//! let unit = sheet.unit().ok_or("without a unit")?;
//! assert_eq!(unit.name(), "mm");
//!
//! // In centimeters, and no edge farther than 0.001 cm from its curve.
//! let part = sheet.part(unit.micrometers() / 1e4, Some(0.001))?;
//! let polygon = part.polygon();
//! assert_eq!((polygon.loops().len(), polygon.loops()[0].clone()), (2, 0..4));
//! // The chords of the bore leave less than a ring as wide as they may deviate.
//! let bore = PI * 0.25;
//! assert!((polygon.area() - (48.0 - bore)).abs() < PI * 0.001);
//!
//! let names: Vec<_> = part.edge_sources().filter_map(|source| source.name.as_deref()).collect();
//! assert_eq!(names[..5], ["plate", "plate", "plate", "plate", "bore"]);
//! assert_eq!(part.left_aside()[0].to_string(), "1 text on no layer (no curve)");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # When not to use it
//!
//! This is no viewer: text, dimensions, hatches, styles and whatever is not seen are left aside,
//! and the curves themselves are gone once they are edges. Nor does it guess: an outline that
//! does not close up to small gaps, branches or crosses itself is refused, with curves and place.
//! Of DXF the text form is read, and what is in the plane.

mod sheet;

mod part;

mod source;
mod unit;

mod error;
mod spline_error;

mod dxf;
mod svg;

mod curve;
mod spline;

mod chain;

mod wording;

pub use error::{DrawingError, PathFault, XmlError};
pub use part::{DrawnPart, Repeat};
pub use sheet::Sheet;
pub use source::{LeftAside, Reason, Source};
pub use spline_error::SplineError;
pub use unit::Unit;
