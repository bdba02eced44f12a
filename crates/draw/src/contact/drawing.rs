//! The drawing of a contact, layer by layer.

use crate::arc::Piece;
use crate::caption;
use crate::contact::layout::{Boundary, End, Layout};
use crate::error::DrawError;
use crate::figure::Figure;
use crate::labels::{Labels, Weight};
use crate::page_box::PageBox;
use crate::paint::{Color, Paint, Stroke};

/// Boundaries, dimensions and their extensions, and the axis.
const OUTLINE: Stroke = Stroke::solid(Color::INK, 1.8);
const DIMENSION: Stroke = Stroke::solid(Color::INK, 1.0);
const EXTENSION: Stroke = Stroke::solid(Color::GREY, 0.8);

/// How far an extension line starts from its point and passes its dimension.
const EXTENSION_GAP: f64 = 6.0;
const EXTENSION_END: f64 = 5.0;

/// How far the normal's arrow passes the finger: the smallest part, whose radius is twice the
/// overlap, is deeper.
const NORMAL: f64 = 46.0;

/// Room between the dimension of the overlap and the lens, the bodies, and the end of the view.
const BESIDE_LENS: f64 = 22.0;
const OFF_BODIES: f64 = 8.0;
const BESIDE_VIEW: f64 = 34.0;

/// The height of the half width's dimension above `b`, or above the area of contact.
const HALF_WIDTH_RISE: f64 = 24.0;

/// The farthest angle at which a radius ends, in radians, and the length of its arrow where the
/// center is out of view.
const RADIUS_ANGLE: f64 = 1.9;
const RADIUS_LENGTH: f64 = 80.0;

/// A part below this radius is told it from outside: its center is hidden by the normal.
const SMALL_PART: f64 = 60.0;

/// Room between an arrow and the end of the view.
const OFF_VIEW: f64 = 8.0;

/// Half the length of the cross at a center.
const CROSS: f64 = 7.0;

/// The number of straight pieces that stand for a boundary where labels are placed.
const STEPS: i32 = 48;

/// The picture of a contact in the making.
pub(crate) struct Drawing<'a> {
    pub(crate) layout: &'a Layout,
    pub(crate) figure: Figure,
    pub(crate) labels: Labels,
}

pub(crate) fn draw(layout: &Layout, lines: &[String]) -> Result<Figure, DrawError> {
    let Layout { half, top, bottom, .. } = *layout;
    let figure = Figure::new([[-half, -bottom], [half, top]], [2.0 * half, top + bottom])?;
    let mut drawing = Drawing { layout, figure, labels: Labels::default() };
    drawing.bodies();
    drawing.lens();
    drawing.outlines();
    drawing.axis();
    drawing.overlap();
    drawing.contact_area();
    drawing.radii();
    drawing.normal();
    drawing.points();
    drawing.body_names();
    drawing.texts();
    caption::write(&mut drawing.figure, lines);
    Ok(drawing.figure)
}

impl Drawing<'_> {
    fn bodies(&mut self) {
        let Layout { finger, part, half, top, bottom, .. } = *self.layout;
        let end = self.layout.part_end();
        let mut shape = body(&part, end, half, -bottom);
        if part.bends_up && !end.beside {
            // What remains beside the hollow.
            let [_, y] = part.point(end.angle);
            shape.extend(
                [[half, y], [half, -bottom], [-half, -bottom], [-half, y]].map(Piece::Corner),
            );
        }
        self.figure.closed(&shape, &Paint::fill(Color::PART));
        let shape = body(&finger, self.layout.finger_end(), half, top);
        self.figure.closed(&shape, &Paint::fill(Color::BLUE.lightened(0.84)));
    }

    fn lens(&mut self) {
        let Layout { finger, part, .. } = *self.layout;
        let [a, b] = self.layout.lens_ends();
        let mut shape = finger.pieces(-a, a);
        shape.extend(part.pieces(b, -b));
        self.figure.closed(&shape, &Paint::fill(Color::BLUE.lightened(0.5)));
    }

    fn outlines(&mut self) {
        let Layout { finger, part, .. } = *self.layout;
        let ends = [self.layout.part_end(), self.layout.finger_end()];
        for (boundary, End { angle, .. }) in [part, finger].into_iter().zip(ends) {
            self.along(&boundary, angle, OUTLINE);
            let at = |step: i32| boundary.point(angle * f64::from(step) / f64::from(STEPS));
            for step in -STEPS..STEPS {
                self.avoid(at(step), at(step + 1));
            }
        }
    }

    /// The boundary from an angle on the left to the same on the right.
    fn along(&mut self, boundary: &Boundary, end: f64, stroke: Stroke) {
        if boundary.is_straight() {
            self.figure.polyline(&[boundary.point(-end), boundary.point(end)], stroke);
        } else {
            self.figure.arc(&boundary.arc(-end, end), &Paint::stroke(stroke));
        }
    }

    /// Where the centers are, dashed, with crosses at those in view.
    fn axis(&mut self) {
        let Layout { finger, part, top, bottom, .. } = *self.layout;
        let mut ends = [[0.0, top], [0.0, -bottom]];
        if self.layout.shows_finger_center() {
            ends[0] = finger.center();
            self.cross(finger.center());
        }
        if self.layout.shows_part_center() {
            ends[1] = part.center();
            if part.radius >= SMALL_PART {
                self.cross(part.center());
            }
        }
        self.line(ends, Stroke::dashed(Color::GREY, 0.8));
    }

    fn cross(&mut self, [x, y]: [f64; 2]) {
        self.line([[x - CROSS, y], [x + CROSS, y]], DIMENSION);
        self.line([[x, y - CROSS], [x, y + CROSS]], DIMENSION);
    }

    /// The dimension of the overlap, from the level of `b` to that of `a`.
    fn overlap(&mut self) {
        let (x, depth) = (self.overlap_at(), self.layout.overlap);
        for y in [0.0, -depth] {
            self.line([[EXTENSION_GAP, y], [x + EXTENSION_END, y]], EXTENSION);
        }
        self.dimension([x, 0.0], [x, -depth]);
    }

    /// Where the dimension of the overlap stands: in the open wedge between the bodies if that
    /// is near, else beside the lens.
    pub(crate) fn overlap_at(&self) -> f64 {
        let Layout { finger, part, overlap, lens, half, .. } = *self.layout;
        let open = finger.away(overlap + OFF_BODIES).max(part.away(overlap + OFF_BODIES));
        if !part.bends_up && open <= half - BESIDE_VIEW { open } else { lens + BESIDE_LENS }
    }

    /// The area of contact on the part, and its half width on the left.
    fn contact_area(&mut self) {
        let Layout { part, half_width, .. } = *self.layout;
        let Some(half_width) = half_width else {
            return;
        };
        let end = part.angle(half_width);
        self.along(&part, end, Stroke::solid(Color::ORANGE, 4.0));
        let [x, y] = part.point(-end);
        let rise = self.half_width_rise(half_width);
        self.line([[x, y + EXTENSION_GAP], [x, rise + EXTENSION_END]], EXTENSION);
        self.dimension([x, rise], [0.0, rise]);
    }

    /// The height of the dimension of the half width: above the area of contact in a hollow too.
    pub(crate) fn half_width_rise(&self, half_width: f64) -> f64 {
        let [_, y] = self.layout.part.point(self.layout.part.angle(half_width));
        y.max(0.0) + HALF_WIDTH_RISE
    }

    fn radii(&mut self) {
        for line in [Some(self.finger_radius()), self.part_radius()].into_iter().flatten() {
            self.figure.arrow(line[0], line[1], DIMENSION);
            self.avoid(line[0], line[1]);
        }
    }

    /// The arrow of the finger's radius: from the center, or from where there is room.
    pub(crate) fn finger_radius(&self) -> [[f64; 2]; 2] {
        let layout = self.layout;
        let [lens, _] = layout.lens_ends();
        let end = layout.finger.point(-radius_angle(lens, layout.finger_end().angle));
        let center = layout.finger.center();
        if layout.shows_finger_center() {
            return [center, end];
        }
        [self.away(end, [center[0] - end[0], center[1] - end[1]]), end]
    }

    /// The arrow of the part's radius, from inside the part or of a small one from outside; none
    /// where it is flat.
    pub(crate) fn part_radius(&self) -> Option<[[f64; 2]; 2]> {
        let Layout { part, .. } = *self.layout;
        if part.is_straight() {
            return None;
        }
        let (end, center) = (self.part_radius_end(), part.center());
        let tail = if part.bends_up || part.radius < SMALL_PART {
            self.away(end, [end[0] - center[0], end[1] - center[1]])
        } else if self.layout.shows_part_center() {
            center
        } else {
            self.away(end, [center[0] - end[0], center[1] - end[1]])
        };
        Some([tail, end])
    }

    /// The point of the part's boundary that its radius is told at.
    pub(crate) fn part_radius_end(&self) -> [f64; 2] {
        let Layout { part, .. } = *self.layout;
        if !part.bends_up && part.radius < SMALL_PART {
            return part.point(-RADIUS_ANGLE);
        }
        let [_, lens] = self.layout.lens_ends();
        part.point(-radius_angle(lens, self.layout.part_end().angle))
    }

    /// The other end of an arrow that starts here in a direction: in the view.
    fn away(&self, from: [f64; 2], run: [f64; 2]) -> [f64; 2] {
        let Layout { half, top, bottom, .. } = *self.layout;
        let length = run[0].hypot(run[1]);
        let way = run.map(|value| value / length);
        let room = |at: f64, way: f64, low: f64, high: f64| {
            let limit = if way < 0.0 { low + OFF_VIEW } else { high - OFF_VIEW };
            if way == 0.0 { f64::INFINITY } else { (limit - at) / way }
        };
        let room = room(from[0], way[0], -half, half).min(room(from[1], way[1], -bottom, top));
        let length = RADIUS_LENGTH.min(room);
        [from[0] + length * way[0], from[1] + length * way[1]]
    }

    fn normal(&mut self) {
        let tip = self.normal_tip();
        self.figure.arrow([0.0, 0.0], tip, Stroke::solid(Color::BLUE, 2.0));
        self.avoid([0.0, 0.0], tip);
    }

    /// Where the arrow of the normal ends.
    pub(crate) fn normal_tip(&self) -> [f64; 2] {
        [0.0, -self.layout.overlap - NORMAL]
    }

    fn points(&mut self) {
        for point in [[0.0, 0.0], [0.0, -self.layout.overlap]] {
            self.figure.disc(
                point,
                3.2,
                &Paint::both(Color::INK, Stroke::solid(Color::WHITE, 1.0)),
            );
            let page = self.figure.to_page(point);
            self.labels.avoid_box(PageBox::centered(page, [7.0, 7.0]));
        }
    }

    /// A line with a head at both ends.
    fn dimension(&mut self, from: [f64; 2], to: [f64; 2]) {
        let middle = [0, 1].map(|i| f64::midpoint(from[i], to[i]));
        self.figure.arrow(middle, from, DIMENSION);
        self.figure.arrow(middle, to, DIMENSION);
        self.avoid(from, to);
    }

    fn line(&mut self, ends: [[f64; 2]; 2], stroke: Stroke) {
        self.figure.polyline(&ends, stroke);
        self.avoid(ends[0], ends[1]);
    }

    fn avoid(&mut self, from: [f64; 2], to: [f64; 2]) {
        let (from, to) = (self.figure.to_page(from), self.figure.to_page(to));
        self.labels.avoid_line(from, to, Weight::Hard);
    }
}

/// The inside of a boundary, cut off level at the far side of the view.
fn body(boundary: &Boundary, end: End, half: f64, far: f64) -> Vec<Piece> {
    let mut shape = boundary.pieces(-end.angle, end.angle);
    if end.beside {
        shape.extend([[half, far], [-half, far]].map(Piece::Corner));
    }
    shape
}

/// The angle in the middle of what is seen of a boundary beside the lens.
fn radius_angle(lens: f64, end: f64) -> f64 {
    f64::midpoint(lens, end.min(RADIUS_ANGLE).max(lens))
}
