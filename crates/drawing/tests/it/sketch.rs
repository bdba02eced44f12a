//! Parts of drawings for the tests of this crate.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use clench_drawing::{DrawnPart, Sheet};

/// The part on a DXF drawing, in its own unit.
pub(crate) fn of_dxf(text: &str, chord: Option<f64>) -> DrawnPart {
    Sheet::from_dxf(text.as_bytes(), &[]).unwrap().part(1.0, chord).unwrap()
}

/// The same of an SVG drawing.
pub(crate) fn of_svg(text: &str, chord: Option<f64>) -> DrawnPart {
    Sheet::from_svg(text.as_bytes(), &[]).unwrap().part(1.0, chord).unwrap()
}

/// The corners of the outline and of each hole.
pub(crate) fn contours(part: &DrawnPart) -> Vec<Vec<[f64; 2]>> {
    let polygon = part.polygon();
    let corners = |run: &std::ops::Range<usize>| {
        polygon.corners()[run.clone()].iter().map(|corner| corner.to_array()).collect()
    };
    polygon.loops().iter().map(corners).collect()
}

/// What was left aside, each in words.
pub(crate) fn aside(part: &DrawnPart) -> Vec<String> {
    part.left_aside().iter().map(ToString::to_string).collect()
}

/// The layers that edges are from, each once.
pub(crate) fn layers(part: &DrawnPart) -> Vec<&str> {
    let mut layers: Vec<&str> = part.sources().iter().map(|s| s.layer.as_str()).collect();
    layers.dedup();
    layers
}
