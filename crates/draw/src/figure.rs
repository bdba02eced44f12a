//! A small SVG canvas with a world-to-page map.

use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

use crate::arc::EllipseArc;
use crate::error::{DrawError, Place};
use crate::number::number;
use crate::page_box::PageBox;
use crate::paint::{Color, Paint, Stroke};
use crate::text::{Anchor, Text};
use crate::world_map::{PAGE_LIMIT, WorldMap, finite, on_page};

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

/// A picture in the making: shapes in world coordinates (y up), sizes of lines and letters in
/// page units (CSS pixels, y down).
///
/// The world bounds are fitted, with equal aspect, into a page rectangle from (0, 0) to the
/// size given. The finished page is what was drawn plus a white border, so nothing is cut off
/// and nothing is centerd by luck. Bounds without extent are drawn at one page unit per world
/// unit. Elements cover earlier ones.
///
/// ```
/// use clench_draw::{Color, Figure, Paint};
///
/// let mut figure = Figure::new([[0.0, 0.0], [2.0, 1.0]], [400.0, 400.0])?;
/// figure.polygon(&[[0.0, 0.0], [2.0, 0.0], [1.0, 1.0]], &Paint::fill(Color::PART))?;
/// // Two units on 400: 200 page units each, the bounds centerd.
/// assert_eq!(figure.to_page([2.0, 1.0])?, [400.0, 100.0]);
/// assert!(figure.to_svg().contains("M0 300L400 300L200 100Z"));
/// # Ok::<(), clench_draw::DrawError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Figure {
    map: WorldMap,
    ink: PageBox,
    body: String,
    gradients: usize,
}

impl Figure {
    /// An empty figure with the box between two opposite corners fitted into a page rectangle.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`] for the bounds or their extent, [`DrawError::NotASize`] for
    /// the page.
    pub fn new(bounds: [[f64; 2]; 2], size: [f64; 2]) -> Result<Self, DrawError> {
        let map = WorldMap::fit(bounds, size)?;
        Ok(Self { map, ink: PageBox::EMPTY, body: String::new(), gradients: 0 })
    }

    /// Where a world point stands on the page.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`] or [`DrawError::OffPage`].
    pub fn to_page(&self, point: [f64; 2]) -> Result<[f64; 2], DrawError> {
        self.map.to_page(point, Place::Text, 0)
    }

    /// The world point at a page position: for keys and captions.
    #[must_use]
    pub fn to_world(&self, page: [f64; 2]) -> [f64; 2] {
        self.map.to_world(page)
    }

    /// The world length that this many page units show.
    #[must_use]
    pub fn world_length(&self, page_units: f64) -> f64 {
        page_units / self.map.scale()
    }

    /// The rectangle that holds everything drawn so far.
    #[must_use]
    pub fn ink(&self) -> PageBox {
        self.ink
    }

    /// A filled or outlined polygon.
    ///
    /// # Errors
    /// [`DrawError::TooFewPoints`] below three corners; a corner that is
    /// [`DrawError::NotFinite`] or [`DrawError::OffPage`]; a line width that is
    /// [`DrawError::NotASize`].
    pub fn polygon(&mut self, corners: &[[f64; 2]], paint: &Paint) -> Result<(), DrawError> {
        self.polygon_with_holes(corners, &[], paint)
    }

    /// A polygon with holes, whichever way around its rings run.
    ///
    /// # Errors
    /// As [`Figure::polygon`], with [`Place::Hole`] for the holes.
    pub fn polygon_with_holes(
        &mut self,
        outline: &[[f64; 2]],
        holes: &[Vec<[f64; 2]>],
        paint: &Paint,
    ) -> Result<(), DrawError> {
        let width = line_width(paint)?;
        let mut path = self.lines(outline, Place::Polygon, 3, width)?;
        path.push('Z');
        for (index, hole) in holes.iter().enumerate() {
            path.push_str(&self.lines(hole, Place::Hole(index), 3, width)?);
            path.push('Z');
        }
        self.path(&path, paint);
        Ok(())
    }

    /// A line through points.
    ///
    /// # Errors
    /// As [`Figure::polygon`], but two points suffice.
    pub fn polyline(&mut self, points: &[[f64; 2]], stroke: Stroke) -> Result<(), DrawError> {
        let paint = Paint::stroke(stroke);
        let path = self.lines(points, Place::Polyline, 2, line_width(&paint)?)?;
        self.path(&path, &paint);
        Ok(())
    }

    /// An arc of an ellipse; a full turn is closed.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`], [`DrawError::OffPage`], or [`DrawError::NotASize`] for a
    /// line width.
    pub fn arc(&mut self, arc: &EllipseArc, paint: &Paint) -> Result<(), DrawError> {
        let path = self.arc_path(arc, line_width(paint)?)?;
        self.path(&path, paint);
        Ok(())
    }

    /// A polygon shaded like a piece of a ball lit from the upper left; the ball's outline is
    /// a whole ellipse.
    ///
    /// # Errors
    /// As [`Figure::polygon`], with [`Place::Arc`] for the ball; [`DrawError::NotASize`] if it
    /// has no area.
    pub fn shaded_polygon(
        &mut self,
        corners: &[[f64; 2]],
        ball: &EllipseArc,
        color: Color,
    ) -> Result<(), DrawError> {
        let path = self.lines(corners, Place::Polygon, 3, 0.0)?;
        let center = self.map.to_page(ball.center, Place::Arc, 0)?;
        let rim = [0.0, FRAC_PI_2].map(|angle| self.map.to_page(ball.point(angle), Place::Arc, 1));
        let (u, v) = (rim[0]?, rim[1]?);
        let (u, v) = ([u[0] - center[0], u[1] - center[1]], [v[0] - center[0], v[1] - center[1]]);
        // The light's direction in the coordinates in which the ellipse is the unit circle.
        let light = [LIGHT[0] * v[1] - LIGHT[1] * v[0], LIGHT[1] * u[0] - LIGHT[0] * u[1]];
        let area = u[0] * v[1] - u[1] * v[0];
        if area == 0.0 {
            return Err(DrawError::NotASize { place: Place::Arc, index: 1, value: area });
        }
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
        Ok(())
    }

    /// A disc of a radius in page units: a mark.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`], [`DrawError::OffPage`], or [`DrawError::NotASize`] for the
    /// radius or line width.
    pub fn disc(&mut self, at: [f64; 2], radius: f64, paint: &Paint) -> Result<(), DrawError> {
        let radius = positive(radius)?;
        let [x, y] = self.map.to_page(at, Place::Disc, 0)?;
        self.ink.include([x, y], radius + line_width(paint)? / 2.0);
        let (x, y, radius) = (number(x), number(y), number(radius));
        let _ = write!(self.body, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"");
        paint.write(&mut self.body);
        self.body.push_str("/>\n");
        Ok(())
    }

    /// An arrow whose point is exactly at its tip; a short one gets a smaller head.
    ///
    /// Tail and tip on one page point give a dot of the line's width.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`], [`DrawError::OffPage`], or [`DrawError::NotASize`] for the
    /// line width.
    pub fn arrow(
        &mut self,
        tail: [f64; 2],
        tip: [f64; 2],
        stroke: Stroke,
    ) -> Result<(), DrawError> {
        let a = self.map.to_page(tail, Place::Arrow, 0)?;
        let b = self.map.to_page(tip, Place::Arrow, 1)?;
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        if length < stroke.width {
            return self.disc(tip, stroke.width / 2.0, &Paint::fill(stroke.color));
        }
        let along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
        let share = (0.6 * length / HEAD[0]).min(1.0);
        let size = [HEAD[0], HEAD[1]].map(|side| side * share * stroke.width.max(1.0).sqrt());
        // The shaft ends inside the head, so that its square end never shows beside the tip.
        let at = |back: f64, aside: f64| {
            self.map.to_world([
                b[0] - back * along[0] - aside * along[1],
                b[1] - back * along[1] + aside * along[0],
            ])
        };
        let shaft = [tail, at(0.8 * size[0], 0.0)];
        let head = [tip, at(size[0], size[1]), at(0.8 * size[0], 0.0), at(size[0], -size[1])];
        self.polyline(&shaft, stroke)?;
        self.polygon(&head, &Paint::fill(stroke.color))
    }

    /// Text beside a world point, moved by an offset in page units (y down).
    ///
    /// # Errors
    /// [`DrawError::NotFinite`], [`DrawError::OffPage`], or [`DrawError::NotASize`] for the
    /// text size.
    pub fn text(&mut self, at: [f64; 2], offset: [f64; 2], text: &Text) -> Result<(), DrawError> {
        let [x, y] = self.map.to_page(at, Place::Text, 0)?;
        self.caption([x + offset[0], y + offset[1]], text)
    }

    /// Text at a page position.
    ///
    /// # Errors
    /// As [`Figure::text`].
    pub fn caption(&mut self, page: [f64; 2], text: &Text) -> Result<(), DrawError> {
        positive(text.size)?;
        for value in page {
            finite(value, Place::Text, 0)?;
        }
        on_page(page, Place::Text, 0)?;
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
        Ok(())
    }

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

    /// The page: what was drawn and a border, in whole units so that rasters have no seam.
    pub(crate) fn page(&self) -> (PageBox, [f64; 2]) {
        let mut ink = self.ink;
        if ink.min[0] > ink.max[0] {
            ink = PageBox { min: [0.0; 2], max: [0.0; 2] };
        }
        let grown = ink.grown(BORDER);
        let page = PageBox { min: grown.min.map(f64::floor), max: grown.max.map(f64::ceil) };
        (page, page.size())
    }

    fn lines(
        &mut self,
        points: &[[f64; 2]],
        place: Place,
        needed: usize,
        width: f64,
    ) -> Result<String, DrawError> {
        if points.len() < needed {
            return Err(DrawError::TooFewPoints { place, found: points.len(), needed });
        }
        let mut path = String::new();
        for (index, &point) in points.iter().enumerate() {
            let page = self.map.to_page(point, place, index)?;
            self.ink.include(page, width / 2.0);
            path.push(if index == 0 { 'M' } else { 'L' });
            push_point(&mut path, page);
        }
        Ok(path)
    }

    fn arc_path(&mut self, arc: &EllipseArc, width: f64) -> Result<String, DrawError> {
        finite(arc.from, Place::Arc, 3)?;
        finite(arc.to, Place::Arc, 3)?;
        for (index, point) in [arc.center, arc.axes[0], arc.axes[1]].into_iter().enumerate() {
            finite(point[0], Place::Arc, index)?;
            finite(point[1], Place::Arc, index)?;
        }
        let mut path = String::new();
        for (index, point) in arc.beziers().into_iter().enumerate() {
            let page = self.map.to_page(point, Place::Arc, 0)?;
            path.push_str(match (index, index % 3) {
                (0, _) => "M",
                (_, 1) => "C",
                _ => " ",
            });
            push_point(&mut path, page);
            if index % 3 == 0 {
                self.ink.include(page, width / 2.0);
            }
        }
        if arc.closes() {
            path.push('Z');
        }
        Ok(path)
    }

    fn path(&mut self, path: &str, paint: &Paint) {
        let _ = write!(self.body, "<path d=\"{path}\" fill-rule=\"evenodd\"");
        paint.write(&mut self.body);
        self.body.push_str("/>\n");
    }
}

fn push_point(path: &mut String, [x, y]: [f64; 2]) {
    let _ = write!(path, "{} {}", number(x), number(y));
}

fn line_width(paint: &Paint) -> Result<f64, DrawError> {
    paint.stroke.map_or(Ok(0.0), |stroke| positive(stroke.width))
}

fn positive(value: f64) -> Result<f64, DrawError> {
    if value > 0.0 && value <= PAGE_LIMIT {
        Ok(value)
    } else {
        Err(DrawError::NotASize { place: Place::PageLength, index: 0, value })
    }
}
