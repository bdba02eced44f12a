//! The drawing of a chart, layer by layer: in page units about the lower left corner, y up.

use crate::chart::{Chart, ChartMark, LineStyle};
use crate::error::DrawError;
use crate::figure::Figure;
use crate::grasp::GraspPicture;
use crate::labels::{Labels, Spot, Weight};
use crate::page_box::PageBox;
use crate::paint::{Color, Paint, Stroke};
use crate::text::{Anchor, LABEL_SIZE, SMALL_SIZE, TITLE_SIZE, Text};

/// Width and height of the field that the curves are in.
const FIELD: [f64; 2] = [580.0, 340.0];

/// Where the column with part and key begins, right of the field.
const COLUMN: f64 = FIELD[0] + 34.0;

/// The box that a part is fitted into, without its fingers.
const PART: [f64; 2] = [230.0, 150.0];

/// Length of a tick, and of the sample of a curve in the key.
const TICK: f64 = 5.0;
const SAMPLE: f64 = 24.0;

/// The radius of a mark.
const DOT: f64 = 4.4;

/// Height of a line of the key.
const KEY_LINE: f64 = 1.6 * SMALL_SIZE;

const FRAME: Stroke = Stroke::solid(Color::GREY, 1.0);

pub(crate) fn draw(chart: &Chart) -> Figure {
    let figure = chart.part.clone().unwrap_or_else(Figure::blank).on_page();
    let mut drawing = Drawing { chart, figure, labels: Labels::default() };
    let below_part = drawing.below_part();
    drawing.bands();
    drawing.grid();
    drawing.curves(LineStyle::Broad);
    drawing.curves(LineStyle::Plain);
    drawing.veils();
    drawing.frame();
    drawing.marks();
    drawing.key(below_part);
    drawing.title();
    drawing.figure
}

/// The part at the top of the column: drawn once to see how far its fingers and names reach.
pub(crate) fn part(picture: &GraspPicture) -> Result<Figure, DrawError> {
    let frame = |min: [f64; 2]| PageBox { min, max: [min[0] + PART[0], min[1] + PART[1]] };
    let ink = picture.figure_in(frame([0.0, 0.0]))?.ink();
    picture.figure_in(frame([COLUMN - ink.min[0], -FIELD[1] - ink.min[1]]))
}

/// A chart in the making.
struct Drawing<'a> {
    chart: &'a Chart,
    figure: Figure,
    labels: Labels,
}

impl Drawing<'_> {
    fn below_part(&self) -> f64 {
        let top = FIELD[1] - 0.5 * SMALL_SIZE;
        if self.chart.part.is_some() { -self.figure.ink().max[1] - 2.0 * KEY_LINE } else { top }
    }

    /// Where a point of the axes stands.
    fn at(&self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| FIELD[i] * self.chart.axes[i].share(point[i]))
    }

    fn bands(&mut self) {
        for band in &self.chart.bands {
            for piece in &band.pieces {
                let low = piece.iter().map(|&[at, low, _]| self.at([at, low]));
                let high = piece.iter().rev().map(|&[at, _, high]| self.at([at, high]));
                let ring: Vec<_> = low.chain(high).collect();
                self.figure.polygon(&ring, &Paint::fill(band_color(band.color)));
            }
        }
    }

    /// A thin line across the field at each tick.
    fn grid(&mut self) {
        for axis in [0, 1] {
            for tick in self.chart.axes[axis].ticks() {
                let mut ends = [[0.0, 0.0], FIELD];
                for end in &mut ends {
                    end[axis] = FIELD[axis] * self.chart.axes[axis].share(tick.at);
                }
                self.figure.polyline(&ends, Stroke::solid(Color::GREY.with_opacity(0.3), 0.8));
            }
        }
    }

    fn curves(&mut self, line: LineStyle) {
        for curve in self.chart.curves.iter().filter(|curve| curve.line == line) {
            for piece in &curve.pieces {
                let points: Vec<_> = piece.iter().map(|&point| self.at(point)).collect();
                self.figure.polyline(&points, stroke(curve.line, curve.color));
                for ends in points.windows(2) {
                    self.avoid(ends[0], ends[1], Weight::Hard);
                }
            }
        }
    }

    fn veils(&mut self) {
        for veil in &self.chart.veils {
            for span in &veil.spans {
                let [from, to] = span.map(|at| FIELD[0] * self.chart.axes[0].share(at));
                let corners = [[from, 0.0], [to, 0.0], [to, FIELD[1]], [from, FIELD[1]]];
                self.figure.polygon(&corners, &Paint::fill(veil_color()));
            }
        }
    }

    /// The axes with their values and names.
    fn frame(&mut self) {
        let [width, height] = FIELD;
        let ends = [[0.0, height], [0.0, 0.0], [width, 0.0]];
        self.figure.polyline(&ends, FRAME);
        self.avoid(ends[0], ends[1], Weight::Hard);
        self.avoid(ends[1], ends[2], Weight::Hard);
        for tick in self.chart.axes[0].ticks() {
            let x = width * self.chart.axes[0].share(tick.at);
            self.figure.polyline(&[[x, 0.0], [x, -TICK]], FRAME);
            let text = Text::new(tick.label.as_str(), SMALL_SIZE);
            self.figure.text([x, -TICK], [0.0, 0.9 * SMALL_SIZE], &text);
        }
        for tick in self.chart.axes[1].ticks() {
            let y = height * self.chart.axes[1].share(tick.at);
            self.figure.polyline(&[[0.0, y], [-TICK, y]], FRAME);
            let text = Text::new(tick.label.as_str(), SMALL_SIZE).anchored(Anchor::End);
            self.figure.text([-TICK, y], [-4.0, 0.0], &text);
        }
        let [horizontal, vertical] = [0, 1]
            .map(|axis| Text::new(self.chart.axes[axis].label(), SMALL_SIZE).colored(Color::GREY));
        self.figure.text([width / 2.0, -TICK], [0.0, 2.5 * SMALL_SIZE], &horizontal);
        // Beside the axis there is only room for letters on end.
        let left = -TICK - SMALL_SIZE;
        self.figure.text(
            [left, height],
            [0.0, -1.4 * SMALL_SIZE],
            &vertical.anchored(Anchor::Start),
        );
    }

    /// Dotted lines first: no mark is crossed by that of another.
    fn marks(&mut self) {
        for mark in &self.chart.marks {
            let [x, y] = self.at(mark.point);
            self.figure.polyline(&[[x, 0.0], [x, y]], Stroke::dotted(mark.color, 1.0));
            self.avoid([x, 0.0], [x, y], Weight::Hard);
        }
        for mark in &self.chart.marks {
            let at = self.at(mark.point);
            let rim = Stroke::solid(Color::WHITE, 1.0);
            self.figure.disc(at, DOT, &Paint::both(mark.color, rim));
            self.labels.avoid_box(PageBox::centered(self.figure.to_page(at), [2.0 * DOT; 2]));
        }
        // The column is not the field's.
        let column = [[COLUMN, -FIELD[1]], [2.0 * COLUMN, 0.0]];
        self.labels.avoid_box(PageBox { min: column[0], max: column[1] });
        for ChartMark { point, label, color, .. } in &self.chart.marks {
            let spot = Spot { at: self.at(*point), toward: [0.0, -1.0], gap: DOT + 3.0 };
            let text = Text::new(label.as_str(), LABEL_SIZE).colored(*color).with_halo();
            self.labels.write(&mut self.figure, &text, spot);
        }
    }

    /// What curves, marks, bands and veils are, from a height on downwards.
    fn key(&mut self, top: f64) {
        let mut y = top;
        let chart = self.chart;
        for curve in &chart.curves {
            let line = [[COLUMN, y], [COLUMN + SAMPLE, y]];
            self.figure.polyline(&line, stroke(curve.line, curve.color));
            self.entry(&curve.label, &mut y);
        }
        for mark in chart.marks.iter().filter(|mark| !mark.meaning.is_empty()) {
            self.figure.disc([COLUMN + SAMPLE / 2.0, y], DOT, &Paint::fill(mark.color));
            self.entry(&mark.meaning, &mut y);
        }
        for band in &chart.bands {
            self.swatch(band_color(band.color), y);
            self.entry(&band.label, &mut y);
        }
        for veil in &chart.veils {
            self.swatch(veil_color(), y);
            self.entry(&veil.label, &mut y);
        }
    }

    fn swatch(&mut self, color: Color, y: f64) {
        let (low, high) = (y - 0.45 * SMALL_SIZE, y + 0.45 * SMALL_SIZE);
        let (left, right) = (COLUMN, COLUMN + SAMPLE);
        let corners = [[left, low], [right, low], [right, high], [left, high]];
        self.figure.polygon(&corners, &Paint::fill(color));
    }

    fn entry(&mut self, label: &str, y: &mut f64) {
        let text = Text::new(label, SMALL_SIZE).anchored(Anchor::Start);
        self.figure.text([COLUMN + SAMPLE, *y], [8.0, 0.0], &text);
        *y -= KEY_LINE;
    }

    fn title(&mut self) {
        let Some(title) = &self.chart.title else {
            return;
        };
        let ink = self.figure.ink();
        let text = Text::new(title.as_str(), TITLE_SIZE).anchored(Anchor::Start);
        self.figure.caption([ink.min[0], ink.min[1] - 1.4 * TITLE_SIZE], &text);
    }

    fn avoid(&mut self, from: [f64; 2], to: [f64; 2], weight: Weight) {
        let (from, to) = (self.figure.to_page(from), self.figure.to_page(to));
        self.labels.avoid_line(from, to, weight);
    }
}

fn stroke(line: LineStyle, color: Color) -> Stroke {
    match line {
        LineStyle::Plain => Stroke::solid(color, 2.0),
        LineStyle::Broad => Stroke::solid(color.lightened(0.45), 5.0),
    }
}

fn band_color(color: Color) -> Color {
    color.with_opacity(0.12)
}

fn veil_color() -> Color {
    Color::PART.with_opacity(0.75)
}
