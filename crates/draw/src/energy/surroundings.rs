//! What stands around the ellipsoids of a scene: floor, scales, planes and cylinder.

use std::f64::consts::PI;

use clench_screw::Vector;

use crate::energy::scene::Scene;
use crate::energy::surface::{EnergySpace, SpaceEllipse};
use crate::number::readable;
use crate::paint::{Color, Paint, Stroke};
use crate::text::{Anchor, SMALL_SIZE, Text};
use crate::ticks::ticks;

/// Values nearer to one another than this, in page units, give way to the outermost two.
const TICKS_APART: f64 = 30.0;

impl Scene<'_> {
    /// The signs of the horizontal axes that point towards the eye.
    fn near(&self) -> [f64; 2] {
        [0, 1].map(|i| self.view.eye[i].signum())
    }

    fn plane(&self, height: f64) -> [[f64; 2]; 4] {
        let [x, y] = self.floor;
        [[x, y], [-x, y], [-x, -y], [x, -y]].map(|[x, y]| self.at([x, y, height]))
    }

    pub(crate) fn floor_plane(&mut self) {
        let corners = self.plane(-self.height);
        let edge = Stroke::solid(Color::GREY, 1.0);
        let paint = Paint::both(Color::GREEN.with_opacity(0.10), edge);
        let plain = Paint::both(Color::PART.with_opacity(0.5), edge);
        let paint = if self.space == EnergySpace::Twist { paint } else { plain };
        self.figure.polygon(&corners, &paint);
    }

    /// The upper bounding plane, over everything: it is translucent, and nearest from above.
    pub(crate) fn ceiling(&mut self) {
        let corners = self.plane(self.height);
        let edge = Stroke::solid(Color::GREY, 1.0);
        self.figure.polygon(&corners, &Paint::both(Color::GREEN.with_opacity(0.13), edge));
        for i in 0..self.solids.len() {
            for side in [-1.0, 1.0] {
                self.mark(self.solids[i].point(Vector::new([0.0, 0.0, side])), self.colors[i]);
            }
        }
        let value = readable(self.height / self.factors[2]);
        for (side, sign) in [(1.0, ""), (-1.0, "\u{2212}")] {
            let corner = self.side_corner(1.0);
            let at = self.at([corner[0], corner[1], side * self.height]);
            let content = format!("ω = {sign}√(2/μ) = {sign}{value}");
            let text = Text::new(content, SMALL_SIZE).anchored(Anchor::Start);
            // Above the corner: the floor's values are below it.
            self.figure.text(at, [10.0, -8.0], &text);
        }
    }

    /// The floor's corner farthest to the right (1) or left (-1).
    fn side_corner(&self, side: f64) -> [f64; 2] {
        [0, 1].map(|i| side * self.view.right[i].signum() * self.floor[i])
    }

    /// Values along the two near edges of the floor and up a post at its left corner.
    pub(crate) fn scales(&mut self) {
        for axis in [0, 1] {
            let mut out = [0.0; 3];
            out[1 - axis] = self.near()[1 - axis];
            for value in self.edge_values(axis) {
                self.tick(value, self.edge_point(axis, value), self.at(out));
            }
        }
        let [x, y] = self.side_corner(-1.0);
        let post = [[x, y, -self.height], [x, y, self.height]].map(|end| self.at(end));
        self.figure.polyline(&post, Stroke::solid(Color::GREY, 1.0));
        for value in ticks(0.97 * self.height / self.factors[2]) {
            self.tick(value, [x, y, value * self.factors[2]], [-1.0, 0.0]);
        }
    }

    /// The point with this coordinate on the floor's near edge along an axis.
    fn edge_point(&self, axis: usize, value: f64) -> [f64; 3] {
        let mut point = [0.0, 0.0, -self.height];
        point[axis] = value * self.factors[axis];
        point[1 - axis] = self.near()[1 - axis] * self.floor[1 - axis];
        point
    }

    fn edge_values(&self, axis: usize) -> Vec<f64> {
        let mut values = ticks(0.93 * self.floor[axis] / self.factors[axis]);
        if let [first, second, ..] = values[..] {
            let ends = [first, second].map(|value| self.at(self.edge_point(axis, value)));
            let gap = (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]);
            if gap < self.figure.world_length(TICKS_APART) {
                values = vec![first, -first];
            }
        }
        values
    }

    /// A short line outwards, given by its direction in the projection, and the value.
    fn tick(&mut self, value: f64, from: [f64; 3], out: [f64; 2]) {
        let from = self.at(from);
        let length = out[0].hypot(out[1]);
        let way = [out[0] / length, -out[1] / length];
        let end = self.figure.world_length(5.0);
        let to = [from[0] + end * way[0], from[1] - end * way[1]];
        self.figure.polyline(&[from, to], Stroke::solid(Color::GREY, 1.0));
        let text = Text::new(readable(value), SMALL_SIZE).colored(Color::GREY);
        let [width, _] = text.page_size();
        let offset = [way[0] * (4.0 + width / 2.0), way[1] * (5.0 + SMALL_SIZE / 2.0)];
        self.figure.text(to, offset, &text);
    }

    /// The footprint both wrench ellipsoids share, on the floor, and the wall above it.
    pub(crate) fn shadow(&mut self) {
        let paint = Paint::both(Color::GREY.with_opacity(0.16), Stroke::solid(Color::GREY, 1.0));
        let arc = self.arc(&self.footprint(-self.height));
        self.figure.arc(&arc, &paint);
        let right = self.rightmost();
        let turn = |i: u32| right + PI * f64::from(i) / 60.0;
        // Counter-clockwise seen from above, the right-hand point is followed by the far half.
        let far = (0..=60).map(|i| self.footprint(self.height).point(turn(i)));
        let near = (60..=120).map(|i| self.footprint(-self.height).point(turn(i)));
        let wall: Vec<_> = far.chain(near).map(|point| self.at(point)).collect();
        self.figure.polygon(&wall, &Paint::fill(Color::GREEN.with_opacity(0.07)));
    }

    fn footprint(&self, height: f64) -> SpaceEllipse {
        let [a, b, _] = self.solids[0].columns();
        let axes = [a, b].map(|axis| Vector::new([axis[0], axis[1], 0.0]));
        SpaceEllipse { center: Vector::new([0.0, 0.0, height]), axes }
    }

    /// The angle at which the footprint reaches farthest to the right.
    fn rightmost(&self) -> f64 {
        let [a, b] = self.footprint(0.0).axes.map(|axis| self.view.right.dot(axis));
        b.atan2(a)
    }

    /// The cylinder's outlines and upper rim: nothing inside reaches in front of them.
    pub(crate) fn cylinder_lines(&mut self) {
        let stroke = Stroke::solid(Color::GREEN, 1.1);
        let (low, high) = (self.footprint(-self.height), self.footprint(self.height));
        let right = self.rightmost();
        for angle in [right, right + PI] {
            let side = [low, high].map(|rim| self.at(rim.point(angle)));
            self.figure.polyline(&side, stroke);
        }
        let rim = self.arc(&high);
        self.figure.arc(&rim, &Paint::stroke(stroke));
    }

    /// Where both wrench ellipsoids meet the vertical axis, named outside the cylinder.
    pub(crate) fn axis_points(&mut self) {
        let pole = self.solids[0].columns()[2][2];
        let value = readable(pole / self.factors[2]);
        // Right of the values along the floor's edge.
        let corner = self.side_corner(1.0);
        let beyond = self.at([corner[0], corner[1], 0.0])[0] + self.figure.world_length(48.0);
        // The names keep clear of the horizontal axis that ends on this side.
        let taken = [0, 1].map(|axis| self.at(self.axis_tip(axis))).into_iter();
        let taken = taken.fold([f64::NEG_INFINITY, 0.0], |a, b| if b[0] > a[0] { b } else { a });
        let room = self.figure.world_length(30.0);
        for (side, sign) in [(1.0, ""), (-1.0, "\u{2212}")] {
            let point = Vector::new([0.0, 0.0, side * pole]);
            let at = self.at(point);
            let low = (taken[1] - room).min(at[1]);
            let high = (taken[1] + room).max(at[1]);
            let end = [beyond, if side < 0.0 { low } else { high }];
            self.figure.polyline(&[at, end], Stroke::solid(Color::INK, 0.7));
            let content = format!("τ = {sign}√(2μ) = {sign}{value}");
            let text = Text::new(content, SMALL_SIZE).anchored(Anchor::Start).with_halo();
            self.figure.text(end, [5.0, 0.0], &text);
            self.mark(point, Color::INK);
        }
    }
}
