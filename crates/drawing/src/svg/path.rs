//! The paths of SVG files.

use std::f64::consts::TAU;

use kurbo::{Affine, Point, Vec2};
use svgtypes::{PathParser, PathSegment};

use crate::curve::{Arc, Bezier, Curve};
use crate::error::{DrawingError, PathFault};

/// The curves of each part of a path, which follow each other; none if it has no length.
pub(super) fn strands(data: &str, line: usize) -> Result<Vec<Vec<Curve>>, DrawingError> {
    let mut pen = Pen::default();
    for segment in PathParser::from(data) {
        pen.draw(segment.map_err(|e| DrawingError::Path { line, fault: fault(&e, data) })?);
    }
    pen.lift();
    Ok(pen.strands)
}

/// Where the data is not valid, with the word that is there.
fn fault(error: &svgtypes::Error, data: &str) -> PathFault {
    let (svgtypes::Error::UnexpectedData(character)
    | svgtypes::Error::InvalidChar(_, character)
    | svgtypes::Error::InvalidString(_, character)
    | svgtypes::Error::InvalidNumber(character)) = *error
    else {
        return PathFault::Ends;
    };
    let rest = data.chars().skip(character.saturating_sub(1));
    let found: String = rest.take_while(|c| !c.is_whitespace() && *c != ',').collect();
    if found.is_empty() { PathFault::Ends } else { PathFault::At { character, found } }
}

/// What draws a path.
#[derive(Debug, Default)]
struct Pen {
    at: Point,
    /// Where this part of the path began.
    start: Point,
    /// The last control point of the curve before, by the number of control points that it has.
    control: Option<(usize, Point)>,
    curves: Vec<Curve>,
    strands: Vec<Vec<Curve>>,
}

impl Pen {
    fn draw(&mut self, segment: PathSegment) {
        let from = if segment.is_abs() { Vec2::ZERO } else { self.at.to_vec2() };
        let point = |x: f64, y: f64| Point::new(x, y) + from;
        match segment {
            PathSegment::MoveTo { x, y, .. } => {
                self.lift();
                self.at = point(x, y);
                self.start = self.at;
                self.control = None;
            }
            PathSegment::LineTo { x, y, .. } => self.straight(point(x, y)),
            PathSegment::HorizontalLineTo { x, .. } => {
                self.straight(Point::new(x + from.x, self.at.y));
            }
            PathSegment::VerticalLineTo { y, .. } => {
                self.straight(Point::new(self.at.x, y + from.y));
            }
            PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => {
                self.curve(&[point(x1, y1), point(x2, y2), point(x, y)]);
            }
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                self.curve(&[self.mirrored(2), point(x2, y2), point(x, y)]);
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => {
                self.curve(&[point(x1, y1), point(x, y)]);
            }
            PathSegment::SmoothQuadratic { x, y, .. } => {
                self.curve(&[self.mirrored(1), point(x, y)]);
            }
            PathSegment::EllipticalArc {
                rx, ry, x_axis_rotation, large_arc, sweep, x, y, ..
            } => {
                let radii = Vec2::new(rx.abs(), ry.abs());
                let turn = x_axis_rotation.to_radians();
                self.arc(point(x, y), radii, turn, [large_arc, sweep]);
            }
            PathSegment::ClosePath { .. } => {
                self.straight(self.start);
                self.lift();
            }
        }
    }

    /// Ends a part of the path.
    fn lift(&mut self) {
        if !self.curves.is_empty() {
            self.strands.push(std::mem::take(&mut self.curves));
        }
    }

    fn straight(&mut self, to: Point) {
        if to != self.at {
            self.curves.push(Curve::Line([self.at, to]));
        }
        self.at = to;
        self.control = None;
    }

    /// A Bézier curve from where the pen is, with these further control points.
    fn curve(&mut self, points: &[Point]) {
        let all: Vec<Point> = std::iter::once(self.at).chain(points.iter().copied()).collect();
        if let [inner @ .., end] = points {
            self.control = inner.last().map(|control| (inner.len(), *control));
            self.at = *end;
        }
        if all.iter().any(|point| *point != all[0]) {
            self.curves.push(Curve::Bezier(Bezier::plain(&all)));
        }
    }

    /// The control point that goes on smoothly after a curve with as many of them.
    fn mirrored(&self, inner: usize) -> Point {
        match self.control {
            Some((count, control)) if count == inner => self.at + (self.at - control),
            _ => self.at,
        }
    }

    /// An arc of an ellipse by its half axes, its turn, whether it is the longer one, and whether
    /// angles grow along it: by the notes on implementation of the SVG specification.
    fn arc(&mut self, to: Point, radii: Vec2, turn: f64, [large, growing]: [bool; 2]) {
        let from = self.at;
        if !(radii.x > 0.0 && radii.y > 0.0) || from == to {
            return self.straight(to);
        }
        let turned = Affine::rotate(turn);
        let vector = |v: Vec2| (turned * v.to_point()).to_vec2();
        let half = (Affine::rotate(-turn) * ((from - to) * 0.5).to_point()).to_vec2();
        // On the unit circle that the ellipse is an image of.
        let half = Vec2::new(half.x / radii.x, half.y / radii.y);
        let size = half.hypot();
        // Half axes that do not reach are made longer.
        let (radii, half) = if size > 1.0 { (radii * size, half / size) } else { (radii, half) };
        let square = half.hypot2();
        let away = ((1.0 - square).max(0.0) / square).sqrt();
        let side = if large == growing { -1.0 } else { 1.0 };
        let center = Vec2::new(half.y, -half.x) * (side * away);
        let [start, end] = [half - center, -half - center].map(Vec2::atan2);
        let sweep =
            if growing { (end - start).rem_euclid(TAU) } else { -(start - end).rem_euclid(TAU) };
        self.curves.push(Curve::Arc(Arc {
            center: from.midpoint(to) + vector(Vec2::new(center.x * radii.x, center.y * radii.y)),
            u: vector(Vec2::new(radii.x, 0.0)),
            v: vector(Vec2::new(0.0, radii.y)),
            from: start,
            sweep,
            ends: Some([from, to]),
        }));
        self.at = to;
        self.control = None;
    }
}
