//! The shapes of SVG files that are no paths.

use std::f64::consts::{FRAC_PI_2, PI};

use kurbo::{Point, Vec2};
use roxmltree::Node;
use svgtypes::PointsParser;

use super::attribute;
use super::place::{self, Size};
use crate::curve::{Arc, Curve};
use crate::error::DrawingError;

/// The curves of a shape, which follow each other; none if it has no size, and is not drawn.
pub(super) fn curves(
    node: Node<'_, '_>,
    size: Size,
    line: usize,
) -> Result<Option<Vec<Curve>>, DrawingError> {
    let along = |name| Ok(attribute(node, name, size.width(), line)?.unwrap_or(0.0));
    let down = |name| Ok(attribute(node, name, size.height(), line)?.unwrap_or(0.0));
    let wide = |name| place::size(node, name, size.width(), line);
    let high = |name| place::size(node, name, size.height(), line);
    let curves = match node.tag_name().name() {
        "line" => {
            chain(&[Point::new(along("x1")?, down("y1")?), Point::new(along("x2")?, down("y2")?)])
        }
        "circle" => {
            let center = Point::new(along("cx")?, down("cy")?);
            let radius = place::size(node, "r", size.mean(), line)?.unwrap_or(0.0);
            whole(center, Vec2::new(radius, radius))
        }
        "ellipse" => {
            let center = Point::new(along("cx")?, down("cy")?);
            whole(center, radii(wide("rx")?, high("ry")?))
        }
        "rect" => {
            let corner = Point::new(along("x")?, down("y")?);
            let extent = Vec2::new(wide("width")?.unwrap_or(0.0), high("height")?.unwrap_or(0.0));
            let round = radii(wide("rx")?, high("ry")?);
            let drawn = extent.x > 0.0 && extent.y > 0.0;
            if drawn { rectangle(corner, extent, round) } else { Vec::new() }
        }
        kind => {
            let points = PointsParser::from(node.attribute("points").unwrap_or(""));
            let mut points: Vec<Point> = points.map(|(x, y)| Point::new(x, y)).collect();
            let first = points.first().copied().filter(|_| kind == "polygon");
            points.extend(first);
            chain(&points)
        }
    };
    Ok(Some(curves).filter(|curves| !curves.is_empty()))
}

/// The sides between points that follow each other; those of no length are none.
fn chain(points: &[Point]) -> Vec<Curve> {
    let sides = points.windows(2).map(|pair| [pair[0], pair[1]]);
    sides.filter(|[start, end]| start != end).map(Curve::Line).collect()
}

/// A whole circle or ellipse, if it has a size.
fn whole(center: Point, radii: Vec2) -> Vec<Curve> {
    if radii.x > 0.0 && radii.y > 0.0 {
        return vec![Curve::ellipse(center, Vec2::new(radii.x, 0.0), Vec2::new(0.0, radii.y))];
    }
    Vec::new()
}

/// The radii as given; where one is not, it is the other.
fn radii(rx: Option<f64>, ry: Option<f64>) -> Vec2 {
    Vec2::new(rx.or(ry).unwrap_or(0.0), ry.or(rx).unwrap_or(0.0))
}

/// A rectangle with rounded corners, from the left end of its upper side on. Radii reach to the
/// middle of a side at most; if either is 0, the corners are square.
fn rectangle(corner: Point, extent: Vec2, radii: Vec2) -> Vec<Curve> {
    let round = Vec2::new(radii.x.min(extent.x * 0.5), radii.y.min(extent.y * 0.5));
    let round = if round.x > 0.0 && round.y > 0.0 { round } else { Vec2::ZERO };
    let [left, top, right, bottom] = [corner.x, corner.y, corner.x + extent.x, corner.y + extent.y];
    let (u, v) = (Vec2::new(round.x, 0.0), Vec2::new(0.0, round.y));
    // Each side with its ends, and the center of the arc after it with the angle where it begins.
    let corners = [
        ([Point::new(left, top) + u, Point::new(right, top) - u], [right, top], -FRAC_PI_2),
        ([Point::new(right, top) + v, Point::new(right, bottom) - v], [right, bottom], 0.0),
        ([Point::new(right, bottom) - u, Point::new(left, bottom) + u], [left, bottom], FRAC_PI_2),
        ([Point::new(left, bottom) - v, Point::new(left, top) + v], [left, top], PI),
    ];
    let mut curves = Vec::new();
    for (i, (side, [x, y], from)) in corners.iter().enumerate() {
        if side[0] != side[1] {
            curves.push(Curve::Line(*side));
        }
        let next = corners[(i + 1) % 4].0[0];
        if side[1] != next {
            let sign = |at: f64, low: f64| if at > low { -1.0 } else { 1.0 };
            let center = Point::new(x + sign(*x, left) * round.x, y + sign(*y, top) * round.y);
            let ends = Some([side[1], next]);
            curves.push(Curve::Arc(Arc { center, u, v, from: *from, sweep: FRAC_PI_2, ends }));
        }
    }
    curves
}
