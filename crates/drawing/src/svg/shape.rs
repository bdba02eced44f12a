//! The shapes of SVG files that are no paths.

use std::f64::consts::{FRAC_PI_2, PI};

use kurbo::{Point, Vec2};
use roxmltree::Node;
use svgtypes::PointsParser;

use super::attribute;
use super::place::Size;
use crate::curve::{Arc, Curve};
use crate::error::DrawingError;

/// The curves of a shape, which follow each other.
pub(super) fn curves(
    node: Node<'_, '_>,
    size: Size,
    line: usize,
) -> Result<Vec<Curve>, DrawingError> {
    let along = |name| Ok(attribute(node, name, size.width(), line)?.unwrap_or(0.0));
    let down = |name| Ok(attribute(node, name, size.height(), line)?.unwrap_or(0.0));
    let kind = node.tag_name().name();
    let no_size = || DrawingError::NoLength { kind: kind.to_owned(), line };
    match kind {
        "line" => {
            let ends =
                [Point::new(along("x1")?, down("y1")?), Point::new(along("x2")?, down("y2")?)];
            Ok(vec![Curve::Line(ends)])
        }
        "circle" => {
            let center = Point::new(along("cx")?, down("cy")?);
            let radius = attribute(node, "r", size.mean(), line)?.unwrap_or(0.0);
            let radius = Some(radius).filter(|radius| *radius > 0.0).ok_or_else(no_size)?;
            Ok(vec![Curve::circle(center, radius)])
        }
        "ellipse" => {
            let center = Point::new(along("cx")?, down("cy")?);
            let (rx, ry) = (along("rx")?, down("ry")?);
            if !(rx > 0.0 && ry > 0.0) {
                return Err(no_size());
            }
            Ok(vec![Curve::ellipse(center, Vec2::new(rx, 0.0), Vec2::new(0.0, ry))])
        }
        "rect" => {
            let (corner, extent) =
                (Point::new(along("x")?, down("y")?), Vec2::new(along("width")?, down("height")?));
            if !(extent.x > 0.0 && extent.y > 0.0) {
                return Err(no_size());
            }
            let rx = attribute(node, "rx", size.width(), line)?;
            let ry = attribute(node, "ry", size.height(), line)?;
            let rx = rx.or(ry).unwrap_or(0.0).clamp(0.0, extent.x * 0.5);
            let ry = ry.or(Some(rx)).unwrap_or(0.0).clamp(0.0, extent.y * 0.5);
            Ok(rectangle(corner, extent, Vec2::new(rx, ry)))
        }
        _ => {
            let points: Vec<Point> = PointsParser::from(node.attribute("points").unwrap_or(""))
                .map(|(x, y)| Point::new(x, y))
                .collect();
            let closing = points.last().zip(points.first()).filter(|_| kind == "polygon");
            let sides = points.windows(2).map(|pair| [pair[0], pair[1]]);
            let sides = sides.chain(closing.map(|(last, first)| [*last, *first]));
            let curves: Vec<Curve> =
                sides.filter(|[start, end]| start != end).map(Curve::Line).collect();
            if curves.is_empty() { Err(no_size()) } else { Ok(curves) }
        }
    }
}

/// A rectangle with rounded corners, from the left end of its upper side on.
fn rectangle(corner: Point, extent: Vec2, round: Vec2) -> Vec<Curve> {
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
