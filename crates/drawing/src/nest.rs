//! Which contour is the outline, and which are holes in it.

use kurbo::{Point, Rect};

use crate::chain::Contour;
use crate::error::DrawingError;
use crate::source::Source;

/// The contours, the largest one, which is the outline, first.
pub(super) fn outline_first(mut contours: Vec<Contour>) -> Vec<Contour> {
    let areas: Vec<f64> = contours.iter().map(|contour| area(&contour.corners).abs()).collect();
    let largest = (0..areas.len()).max_by(|&one, &other| areas[one].total_cmp(&areas[other]));
    // Of equals the first one is the outline.
    let largest = largest.and_then(|one| areas.iter().position(|area| *area >= areas[one]));
    if let Some(outline) = largest {
        contours[..=outline].rotate_right(1);
    }
    contours
}

/// Checks that all others are holes of the first.
pub(super) fn check_nesting(contours: &[Contour], sources: &[Source]) -> Result<(), DrawingError> {
    let boxes: Vec<Rect> = contours.iter().map(|contour| around(&contour.corners)).collect();
    let source = |contour: usize| sources[contours[contour].sources[0]].clone();
    for hole in 1..contours.len() {
        let corner = contours[hole].corners[0];
        if !is_inside(corner, &contours[0].corners) {
            let curves = Box::new([source(0), source(hole)]);
            return Err(DrawingError::SecondPart { curves });
        }
        let within = (1..contours.len()).filter(|&other| other != hole);
        let mut within = within.filter(|&other| boxes[other].contains(corner));
        if let Some(other) = within.find(|&other| is_inside(corner, &contours[other].corners)) {
            let curves = Box::new([source(other), source(hole)]);
            return Err(DrawingError::Island { curves });
        }
    }
    Ok(())
}

/// The area within a contour, positive if it runs counter-clockwise; about its first corner, so
/// that it does not suffer far away from the origin.
fn area(corners: &[Point]) -> f64 {
    let first = corners[0];
    let doubled: f64 =
        corners.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first)).sum();
    doubled * 0.5
}

fn around(corners: &[Point]) -> Rect {
    let first = Rect::from_points(corners[0], corners[0]);
    corners.iter().fold(first, |rect, corner| rect.union_pt(*corner))
}

/// Whether a ray from the point to the right leaves the contour: it crosses it an odd number of
/// times. Points on the contour count as either.
fn is_inside(point: Point, corners: &[Point]) -> bool {
    let next = corners.iter().cycle().skip(1);
    let crossings = corners.iter().zip(next).filter(|(start, end)| {
        let spans = (start.y > point.y) != (end.y > point.y);
        let turn = (**end - **start).cross(point - **start);
        spans && (turn > 0.0) == (end.y > start.y)
    });
    crossings.count() % 2 == 1
}
