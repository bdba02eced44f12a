//! The scene of the two ellipsoids: faces, curves, axes and marks.

use std::f64::consts::{PI, TAU};

use clench_screw::Vector;

use crate::arc::EllipseArc;
use crate::energy::hiding::{hides, runs};
use crate::energy::pieces::{meeting_planes, pieces, section};
use crate::energy::surface::{EnergySpace, EnergySurface, SpaceEllipse};
use crate::figure::Figure;
use crate::paint::{Color, Paint, Stroke};
use crate::text::{LABEL_SIZE, Text};
use crate::view::View;

/// The length of the horizontal axes against the floor's half-width, and how far the vertical
/// one rises above the ceiling.
const AXIS: f64 = 1.5;
const RISE: f64 = 0.42;

/// Curves thinner than this are left out where they are hidden.
const HIDDEN_WIDTH: f64 = 1.3;

/// What a scene shows: its solids and where they stand on the page.
pub(crate) struct Scene<'a> {
    pub(crate) space: EnergySpace,
    pub(crate) view: View,
    /// Scene units per unit of each coordinate.
    pub(crate) factors: [f64; 3],
    /// Half-widths of the floor, height of the floor below the origin, of the ceiling above.
    pub(crate) floor: [f64; 2],
    pub(crate) height: f64,
    pub(crate) solids: &'a [EnergySurface; 2],
    pub(crate) colors: [Color; 2],
    pub(crate) figure: &'a mut Figure,
}

impl Scene<'_> {
    pub(crate) fn draw(&mut self) {
        self.floor_plane();
        self.scales();
        if self.space == EnergySpace::Wrench {
            self.shadow();
        }
        self.faces();
        self.axes();
        for i in 0..self.solids.len() {
            self.curves(i);
        }
        match self.space {
            EnergySpace::Twist => self.ceiling(),
            EnergySpace::Wrench => {
                self.cylinder_lines();
                self.axis_points();
            }
        }
        self.axis_names();
    }

    /// The shaded surfaces: where they interpenetrate, piece by piece from the back.
    fn faces(&mut self) {
        let Some(planes) = meeting_planes(self.solids, self.space) else {
            // They coincide.
            let outline = self.arc(&self.solids[1].silhouette(self.view.eye));
            let corners: Vec<_> =
                (0..240).map(|i| outline.point(f64::from(i) * TAU / 240.0)).collect();
            return self.face(1, &corners);
        };
        for (index, hull) in pieces(self.solids, planes, &self.view) {
            self.face(index, &hull);
        }
        for plane in planes {
            self.curve(&section(&self.solids[0], plane), Color::INK, 0.9);
        }
    }

    fn face(&mut self, index: usize, corners: &[[f64; 2]]) {
        let ball = self.arc(&self.solids[index].silhouette(self.view.eye));
        self.figure.shaded_polygon(corners, &ball, self.colors[index]);
    }

    pub(crate) fn at(&self, point: impl Into<Vector<3>>) -> [f64; 2] {
        self.view.project(point.into())
    }

    pub(crate) fn arc(&self, ellipse: &SpaceEllipse) -> EllipseArc {
        let axes = ellipse.axes.map(|axis| self.view.project(axis));
        EllipseArc::ellipse(self.view.project(ellipse.center), axes)
    }

    /// A point of a surface: full where it is seen, hollow where a solid hides it.
    pub(crate) fn mark(&mut self, point: Vector<3>, color: Color) {
        let hidden = self.solids.iter().any(|solid| hides(solid, point, self.view.eye));
        let paint = if hidden {
            Paint::both(Color::WHITE.with_opacity(0.75), Stroke::solid(color, 1.5))
        } else {
            Paint::both(color, Stroke::solid(Color::WHITE, 1.0))
        };
        let at = self.at(point);
        self.figure.disc(at, if hidden { 3.6 } else { 4.4 }, &paint);
    }

    /// Outline, emphasized curve, and the thin net of each ellipsoid.
    fn curves(&mut self, index: usize) {
        let (solid, color) = (self.solids[index], self.colors[index]);
        for step in 0..6 {
            let ellipse = solid.meridian(f64::from(step) * PI / 6.0);
            self.curve(&ellipse, color, 0.6);
        }
        for height in [-0.8, -0.45, 0.45, 0.8] {
            self.curve(&solid.latitude(height), color, 1.1);
        }
        // Two twist ellipsoids share their equator.
        let shared = self.space == EnergySpace::Twist;
        let equator = if shared { Color::INK } else { color };
        self.curve(&solid.latitude(0.0), equator, 2.0);
        self.curve(&solid.silhouette(self.view.eye), color, 1.5);
    }

    fn curve(&mut self, ellipse: &SpaceEllipse, color: Color, width: f64) {
        let arc = self.arc(ellipse);
        for run in runs(|t| ellipse.point(t), [0.0, TAU], self.solids, self.view.eye) {
            let stroke = if run.seen {
                Stroke::solid(color, width)
            } else if width < HIDDEN_WIDTH {
                continue;
            } else {
                Stroke::dotted(color.with_opacity(0.4), (0.7 * width).min(0.9))
            };
            self.figure.arc(&arc.between(run.from, run.to), &Paint::stroke(stroke));
        }
    }

    pub(crate) fn axis_tip(&self, axis: usize) -> Vector<3> {
        let mut tip = Vector::ZERO;
        tip[axis] =
            if axis == 2 { self.height + RISE } else { AXIS * self.floor[0].max(self.floor[1]) };
        tip
    }

    /// The coordinate axes: dotted where a solid hides them.
    fn axes(&mut self) {
        for axis in 0..3 {
            let tip = self.axis_tip(axis);
            let line = |t: f64| tip * t;
            let start = if axis == 2 { -self.height / tip[2] } else { 0.0 };
            let pieces = runs(line, [start, 1.0], self.solids, self.view.eye);
            for (i, run) in pieces.iter().enumerate() {
                let (from, to) = (self.at(line(run.from)), self.at(line(run.to)));
                if !run.seen {
                    let hidden = Stroke::dotted(Color::INK.with_opacity(0.5), 0.9);
                    self.figure.polyline(&[from, to], hidden);
                } else if i + 1 == pieces.len() {
                    self.figure.arrow(from, to, Stroke::solid(Color::INK, 1.3));
                } else {
                    self.figure.polyline(&[from, to], Stroke::solid(Color::INK, 1.3));
                }
            }
        }
    }

    fn axis_names(&mut self) {
        let names = match self.space {
            EnergySpace::Twist => ["v_{x}", "v_{y}", "ω"],
            EnergySpace::Wrench => ["f_{x}", "f_{y}", "τ"],
        };
        for (axis, name) in names.into_iter().enumerate() {
            let (tip, origin) = (self.at(self.axis_tip(axis)), self.at([0.0; 3]));
            let run = [tip[0] - origin[0], tip[1] - origin[1]];
            let length = run[0].hypot(run[1]);
            let offset = [14.0 * run[0] / length, -14.0 * run[1] / length];
            self.figure.text(tip, offset, &Text::new(name, LABEL_SIZE).with_halo());
        }
    }
}
