//! A finished picture, and the small SVG canvas it was drawn on.

use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

use crate::arc::{EllipseArc, Piece};
use crate::error::DrawError;
use crate::number::number;
use crate::page_box::PageBox;
use crate::paint::{Color, Paint, Stroke};
use crate::text::{Anchor, Text};
use crate::world_map::WorldMap;

/// The family of the bundled font, and what stands in for it elsewhere.
const FONT_FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

/// Length and half-width of an arrow head, in page units.
const HEAD: [f64; 2] = [9.0, 3.2];

/// Where the light of shaded shapes comes from on the page, and how far off the middle of a
/// ball of radius 1 it is brightest.
const LIGHT: [f64; 2] = [-0.5, -0.85];
const HIGHLIGHT: f64 = 0.4;

/// White border around what is drawn, in page units.
const BORDER: f64 = 12.0;

/// A finished picture, from [`GraspPicture::figure`](crate::GraspPicture::figure),
/// [`SolidPicture::figure`](crate::SolidPicture::figure),
/// [`ContactPicture::figure`](crate::ContactPicture::figure),
/// [`EnergyEllipsoids::figure`](crate::EnergyEllipsoids::figure) or
/// [`Chart::figure`](crate::Chart::figure).
///
/// The page is what was drawn plus a white border, so nothing is cut off. Its unit is the CSS
/// pixel.
#[derive(Debug, Clone)]
pub struct Figure {
    // Shapes come in world coordinates (y up), sizes of lines and letters in page units (y
    // down). Later elements cover earlier ones.
    map: WorldMap,
    ink: PageBox,
    body: String,
    gradients: usize,
}

impl Figure {
    /// The picture as an SVG document.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let (page, [width, height]) = self.page();
        let [left, top] = page.min.map(number);
        let (width, height) = (number(width), number(height));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" xml:space=\"preserve\" \
             width=\"{width}\" height=\"{height}\" \
             viewBox=\"{left} {top} {width} {height}\">\n\
             <rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" \
             fill=\"#ffffff\"/>\n\
             <g font-family=\"{FONT_FAMILY}\" stroke-linejoin=\"round\">\n{}</g>\n</svg>\n",
            self.body
        )
    }

    /// An empty figure with the box between two opposite corners fitted, with equal aspect and
    /// centered, into the page rectangle from (0, 0) to this size.
    ///
    /// Bounds without extent are drawn at one page unit per world unit.
    pub(crate) fn new(bounds: [[f64; 2]; 2], size: [f64; 2]) -> Result<Self, DrawError> {
        Self::within(bounds, PageBox { min: [0.0, 0.0], max: size })
    }

    /// The same with any page rectangle.
    pub(crate) fn within(bounds: [[f64; 2]; 2], frame: PageBox) -> Result<Self, DrawError> {
        Ok(Self { map: WorldMap::fit(bounds, frame)?, ..Self::blank() })
    }

    /// An empty figure in page units, y up.
    pub(crate) const fn blank() -> Self {
        Self { map: WorldMap::PAGE, ink: PageBox::EMPTY, body: String::new(), gradients: 0 }
    }

    /// The figure to go on in page units, y up.
    pub(crate) fn on_page(self) -> Self {
        Self { map: WorldMap::PAGE, ..self }
    }

    /// From the world to the page.
    pub(crate) fn map(&self) -> &WorldMap {
        &self.map
    }

    /// Where a world point stands on the page.
    pub(crate) fn to_page(&self, point: [f64; 2]) -> [f64; 2] {
        self.map.to_page(point)
    }

    /// The world point at a page position: for keys and captions.
    pub(crate) fn to_world(&self, page: [f64; 2]) -> [f64; 2] {
        self.map.to_world(page)
    }

    /// The world length that this many page units show.
    pub(crate) fn world_length(&self, page_units: f64) -> f64 {
        page_units / self.map.scale()
    }

    /// The rectangle that holds everything drawn so far.
    pub(crate) fn ink(&self) -> PageBox {
        self.ink
    }

    /// A filled or outlined polygon.
    pub(crate) fn polygon(&mut self, corners: &[[f64; 2]], paint: &Paint) {
        let path = self.lines(corners, line_width(paint));
        self.path(&(path + "Z"), paint);
    }

    /// Polygons as one shape: what is inside an odd number of them.
    pub(crate) fn area<'a>(&mut self, loops: impl Iterator<Item = &'a [[f64; 2]]>, paint: &Paint) {
        let path: String =
            loops.map(|corners| self.lines(corners, line_width(paint)) + "Z").collect();
        // Whichever way round the loops are.
        let _ = write!(self.body, "<path fill-rule=\"evenodd\" d=\"{path}\"");
        paint.write(&mut self.body);
        self.body.push_str("/>\n");
    }

    /// A line through points.
    pub(crate) fn polyline(&mut self, points: &[[f64; 2]], stroke: Stroke) {
        let path = self.lines(points, stroke.width);
        self.path(&path, &Paint::stroke(stroke));
    }

    /// An arc of an ellipse; a full turn is closed.
    pub(crate) fn arc(&mut self, arc: &EllipseArc, paint: &Paint) {
        let path = self.arc_path(arc, line_width(paint));
        self.path(&path, paint);
    }

    /// A closed shape bounded by arcs and straight lines, in order.
    pub(crate) fn closed(&mut self, pieces: &[Piece], paint: &Paint) {
        let mut path = String::new();
        for piece in pieces {
            match piece {
                Piece::Corner(corner) => self.push_lines(&mut path, &[*corner], line_width(paint)),
                Piece::Arc(arc) => self.push_arc(&mut path, arc, line_width(paint)),
            }
        }
        self.path(&(path + "Z"), paint);
    }

    /// A polygon shaded like a piece of a ball lit from the upper left; the ball's outline is
    /// a whole ellipse. A ball seen as a line has no inside to shade.
    pub(crate) fn shaded_polygon(&mut self, corners: &[[f64; 2]], ball: &EllipseArc, color: Color) {
        let center = self.to_page(ball.center);
        let [u, v] = [0.0, FRAC_PI_2].map(|angle| {
            let rim = self.to_page(ball.point(angle));
            [rim[0] - center[0], rim[1] - center[1]]
        });
        let area = u[0] * v[1] - u[1] * v[0];
        if area == 0.0 {
            return;
        }
        let path = self.lines(corners, 0.0);
        // The light's direction in the coordinates in which the ellipse is the unit circle.
        let light = [LIGHT[0] * v[1] - LIGHT[1] * v[0], LIGHT[1] * u[0] - LIGHT[0] * u[1]];
        let side = area.signum() * HIGHLIGHT / light[0].hypot(light[1]);
        let numbers = [u[0], u[1], v[0], v[1], center[0], center[1]].map(number).join(" ");
        self.gradients += 1;
        let id = self.gradients;
        let _ = write!(
            self.body,
            "<radialGradient id=\"ball{id}\" gradientUnits=\"userSpaceOnUse\" \
             gradientTransform=\"matrix({numbers})\" cx=\"{}\" cy=\"{}\" r=\"{}\">",
            number(side * light[0]),
            number(side * light[1]),
            number(1.0 + HIGHLIGHT)
        );
        for (offset, share) in [("0", 0.9), ("0.5", 0.66), ("1", 0.34)] {
            let _ = write!(self.body, "<stop offset=\"{offset}\"");
            color.lightened(share).write(&mut self.body, "stop-color");
            self.body.push_str("/>");
        }
        let _ = writeln!(self.body, "</radialGradient>");
        let _ = writeln!(self.body, "<path d=\"{path}Z\" fill=\"url(#ball{id})\"/>");
    }

    /// A disc of a radius in page units: a mark.
    pub(crate) fn disc(&mut self, at: [f64; 2], radius: f64, paint: &Paint) {
        let [x, y] = self.to_page(at);
        self.ink.include([x, y], radius + line_width(paint) / 2.0);
        let (x, y, radius) = (number(x), number(y), number(radius));
        let _ = write!(self.body, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"");
        paint.write(&mut self.body);
        self.body.push_str("/>\n");
    }

    /// An arrow whose point is exactly at its tip; a short one gets a smaller head.
    ///
    /// Tail and tip on one page point give a dot of the line's width.
    pub(crate) fn arrow(&mut self, tail: [f64; 2], tip: [f64; 2], stroke: Stroke) {
        let (a, b) = (self.to_page(tail), self.to_page(tip));
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        if length < stroke.width {
            return self.disc(tip, stroke.width / 2.0, &Paint::fill(stroke.color));
        }
        let along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
        let share = (0.6 * length / HEAD[0]).min(1.0);
        let size = [HEAD[0], HEAD[1]].map(|side| side * share * stroke.width.max(1.0).sqrt());
        // The shaft ends inside the head, so that its square end never shows beside the tip.
        let at = |back: f64, aside: f64| {
            self.to_world([
                b[0] - back * along[0] - aside * along[1],
                b[1] - back * along[1] + aside * along[0],
            ])
        };
        let shaft = [tail, at(0.8 * size[0], 0.0)];
        let head = [tip, at(size[0], size[1]), at(0.8 * size[0], 0.0), at(size[0], -size[1])];
        self.polyline(&shaft, stroke);
        self.polygon(&head, &Paint::fill(stroke.color));
    }

    /// Text beside a world point, moved by an offset in page units (y down).
    pub(crate) fn text(&mut self, at: [f64; 2], offset: [f64; 2], text: &Text) {
        let [x, y] = self.to_page(at);
        self.caption([x + offset[0], y + offset[1]], text);
    }

    /// Text at a page position.
    pub(crate) fn caption(&mut self, page: [f64; 2], text: &Text) {
        let [width, height] = text.page_size();
        let middle = match text.anchor {
            Anchor::Start => page[0] + width / 2.0,
            Anchor::Middle => page[0],
            Anchor::End => page[0] - width / 2.0,
        };
        let area = PageBox::centered([middle, page[1]], [width, height]);
        self.ink.include(area.min, 0.0);
        self.ink.include(area.max, 0.0);
        text.write(&mut self.body, page);
    }

    /// The page: what was drawn and a border, in whole units so that rasters have no seam.
    pub(crate) fn page(&self) -> (PageBox, [f64; 2]) {
        let grown = self.ink.grown(BORDER);
        let page = PageBox { min: grown.min.map(f64::floor), max: grown.max.map(f64::ceil) };
        (page, page.size())
    }

    fn lines(&mut self, points: &[[f64; 2]], width: f64) -> String {
        let mut path = String::new();
        self.push_lines(&mut path, points, width);
        path
    }

    fn arc_path(&mut self, arc: &EllipseArc, width: f64) -> String {
        let mut path = String::new();
        self.push_arc(&mut path, arc, width);
        if arc.closes() {
            path.push('Z');
        }
        path
    }

    fn push_lines(&mut self, path: &mut String, points: &[[f64; 2]], width: f64) {
        for &point in points {
            let page = self.to_page(point);
            self.ink.include(page, width / 2.0);
            path.push(if path.is_empty() { 'M' } else { 'L' });
            push_point(path, page);
        }
    }

    fn push_arc(&mut self, path: &mut String, arc: &EllipseArc, width: f64) {
        let points = arc.beziers();
        self.push_lines(path, &points[..1], width);
        for (index, &point) in points.iter().enumerate().skip(1) {
            let page = self.to_page(point);
            path.push(if index % 3 == 1 { 'C' } else { ' ' });
            push_point(path, page);
            if index % 3 == 0 {
                self.ink.include(page, width / 2.0);
            }
        }
    }

    fn path(&mut self, path: &str, paint: &Paint) {
        let _ = write!(self.body, "<path d=\"{path}\"");
        paint.write(&mut self.body);
        self.body.push_str("/>\n");
    }
}

fn push_point(path: &mut String, [x, y]: [f64; 2]) {
    let _ = write!(path, "{} {}", number(x), number(y));
}

fn line_width(paint: &Paint) -> f64 {
    paint.stroke.map_or(0.0, |stroke| stroke.width)
}

#[cfg(test)]
mod tests {
    use super::*;

    const INK: Stroke = Stroke::solid(Color::INK, 1.0);

    fn figure(bounds: [[f64; 2]; 2], size: [f64; 2]) -> Figure {
        Figure::new(bounds, size).expect("finite bounds")
    }

    #[test]
    #[expect(clippy::float_cmp, reason = "every number here is exact in binary")]
    fn both_axes_have_one_scale_and_y_points_up() {
        // Eight by two into 400 by 400: 50 a unit, so 100 high and 150 free above and below.
        let figure = figure([[-4.0, 1.0], [4.0, 3.0]], [400.0, 400.0]);
        assert_eq!(figure.to_page([-4.0, 1.0]), [0.0, 250.0]);
        assert_eq!(figure.to_page([4.0, 3.0]), [400.0, 150.0]);
        assert_eq!(figure.to_world([0.0, 250.0]), [-4.0, 1.0]);
        assert_eq!(figure.world_length(25.0), 0.5);
    }

    #[test]
    fn an_arrow_ends_at_its_tip_and_a_short_one_keeps_a_shaft() {
        let mut long = figure([[0.0, 0.0], [10.0, 10.0]], [100.0, 100.0]);
        let mut short = long.clone();
        long.arrow([0.0, 5.0], [10.0, 5.0], INK);
        // The head of 9 by 6.4 has its notch at 0.8 of its length, where the shaft ends.
        assert!(long.body.contains("M0 50L92.8 50"));
        assert!(long.body.contains("M100 50L91 53.2L92.8 50L91 46.8Z"));
        short.arrow([0.0, 5.0], [0.5, 5.0], INK);
        assert!(short.body.contains("M5 50L2 "), "{}", short.body);
    }

    #[test]
    fn an_arrow_without_length_is_a_dot() {
        let mut figure = figure([[0.0, 0.0], [10.0, 10.0]], [100.0, 100.0]);
        figure.arrow([5.0, 5.0], [5.0, 5.0], INK);
        assert!(figure.body.contains("<circle cx=\"50\" cy=\"50\" r=\"0.5\""));
    }

    #[test]
    fn a_full_turn_is_closed_and_passes_the_quarter_points() {
        let mut figure = figure([[-1.0, -1.0], [1.0, 1.0]], [200.0, 200.0]);
        figure.arc(&EllipseArc::circle([0.0, 0.0], 1.0), &Paint::fill(Color::PART));
        for quarter in ["M200 100", " 100 0C", " 0 100C", " 100 200C", " 200 100Z"] {
            assert!(figure.body.contains(quarter), "{quarter} in {}", figure.body);
        }
    }

    #[test]
    fn a_closed_shape_goes_straight_to_where_an_arc_begins() {
        let mut figure = figure([[-1.0, -1.0], [1.0, 1.0]], [200.0, 200.0]);
        let quarter = EllipseArc::circle([0.0, 0.0], 1.0).between(0.0, FRAC_PI_2);
        let pieces = [Piece::Corner([0.0, 0.0]), Piece::Arc(quarter)];
        figure.closed(&pieces, &Paint::fill(Color::PART));
        assert!(figure.body.starts_with("<path d=\"M100 100L200 100C"), "{}", figure.body);
        assert!(figure.body.contains(" 100 0Z\""), "{}", figure.body);
    }

    #[test]
    fn a_ball_seen_as_a_line_is_not_shaded() {
        let mut figure = figure([[-1.0, -1.0], [1.0, 1.0]], [200.0, 200.0]);
        let line = EllipseArc::ellipse([0.0, 0.0], [[1.0, 0.0], [-2.0, 0.0]]);
        figure.shaded_polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], &line, Color::BLUE);
        assert_eq!(figure.body, "");
    }
}
