//! Screw axes, the center and the point that gives way most.

use std::f64::consts::PI;

use clench_screw::Vector;

use crate::arc::EllipseArc;
use crate::labels::Weight;
use crate::page_box::PageBox;
use crate::paint::{Color, Paint, Stroke};
use crate::solid::drawing::{Drawing, spot};
use crate::solid::finger::around;
use crate::solid::scene::flat;
use crate::solid::{SolidAxis, SolidMark, SolidWorst};

/// How far an axis passes the part, in page units, and the least share of a length along it that
/// is taken to be seen.
const BEYOND: [f64; 2] = [26.0, 50.0];
const LEAST_SEEN: f64 = 0.35;

/// The turning arrow: its radius and place before the end of the axis in page units, and the
/// angle from its middle to its points.
const TURN_RADIUS: f64 = 16.0;
const TURN_BACK: f64 = 18.0;
const TURN_HALF: f64 = 0.8 * PI;

/// The angle that an arrow head takes of the turning arrow, in radians.
const TURN_HEAD: f64 = 0.75;

/// Straight pieces of the turning arrow where labels are placed.
const TURN_STEPS: i32 = 16;

/// Half the length of the double arrow at the worst point, in page units.
const SWAY: f64 = 36.0;

/// How far names stand from the end of an axis and from a point, in page units.
const AXIS_GAP: f64 = 4.0;
const MARK_GAP: f64 = 9.0;

/// An axis as level as this is labeled at its upper end, else at the one nearer to the viewer.
const LEVEL: f64 = 0.1;

impl Drawing<'_> {
    /// The point of an axis that is nearest to the part's middle.
    pub(crate) fn foot(&self, axis: &SolidAxis) -> Vector<3> {
        let (point, along) = (self.scene.point(axis.point), self.scene.direction(axis.direction));
        point - along * point.dot(along)
    }

    /// The ends of an axis, the one with the name first.
    fn axis_ends(&self, axis: &SolidAxis) -> [Vector<3>; 2] {
        let (foot, along) = (self.foot(axis), self.scene.direction(axis.direction));
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for corner in self.scene.corners() {
            let at = corner.dot(along);
            (low, high) = (low.min(at), high.max(at));
        }
        let level = along[0].hypot(along[1]);
        let beyond = self.length(BEYOND[usize::from(axis.emphasized)]) / level.max(LEAST_SEEN);
        let (start, end) = (foot + along * (low - beyond), foot + along * (high + beyond));
        let end_first = if along[2].abs() > LEVEL { along[2] > 0.0 } else { along[1] > 0.0 };
        if end_first { [end, start] } else { [start, end] }
    }

    pub(crate) fn axes(&mut self) {
        let picture = self.picture;
        let (strong, thin): (Vec<_>, Vec<_>) =
            picture.axes.iter().partition(|axis| axis.emphasized);
        for axis in thin.into_iter().chain(strong) {
            let ends = self.axis_ends(axis);
            let (color, width) = axis_color(axis);
            for run in self.screens.runs(&ends) {
                let color = if run.seen { color } else { color.with_opacity(0.6) };
                self.line(&run.points, Stroke::chain(color, width), Some(Weight::Soft));
            }
            if axis.emphasized {
                self.turning_arrow(ends, color);
            }
        }
    }

    /// An arrow with two heads around the first end of an axis, open behind it.
    fn turning_arrow(&mut self, [end, other]: [Vector<3>; 2], color: Color) {
        let Some(along) = (end - other).direction() else {
            return;
        };
        let level = along[0].hypot(along[1]).max(LEAST_SEEN);
        let middle = end - along * (self.length(TURN_BACK) / level);
        let radius = self.length(TURN_RADIUS);
        let [first, second] = around(along).map(|way| [way[0], way[1]]);
        // Nearer to the viewer is lower on the page where the axis rises towards the viewer.
        let open = first[0].hypot(first[1]);
        let down = if open > 0.0 { first.map(|side| side / open) } else { [0.0, -1.0] };
        let first = down.map(|side| side * radius * open.max(LEAST_SEEN));
        let ring = EllipseArc::ellipse(flat(middle), [first, second.map(|side| side * radius)]);
        let arc = |half: f64| ring.between(-half, half);
        let halo = Stroke::solid(Color::WHITE.with_opacity(0.8), 4.5);
        self.figure.arc(&arc(TURN_HALF), &Paint::stroke(halo));
        let stroke = Stroke::solid(color, 1.8);
        self.figure.arc(&arc(TURN_HALF - TURN_HEAD), &Paint::stroke(stroke));
        for side in [-1.0, 1.0] {
            let [from, to] = [TURN_HALF - TURN_HEAD, TURN_HALF].map(|at| ring.point(side * at));
            self.figure.arrow(from, to, stroke);
        }
        for step in -TURN_STEPS..TURN_STEPS {
            let [from, to] = [step, step + 1].map(|step| {
                let at = TURN_HALF * f64::from(step) / f64::from(TURN_STEPS);
                self.figure.to_page(ring.point(at))
            });
            self.labels.avoid_line(from, to, Weight::Hard);
        }
    }

    /// A ring and a dot, told from contacts without color.
    pub(crate) fn center(&mut self) {
        let Some(SolidMark { point, .. }) = &self.picture.center else {
            return;
        };
        let at = flat(self.scene.point(*point));
        let ring = Paint::both(Color::WHITE, Stroke::solid(Color::ORANGE, 1.8));
        self.figure.disc(at, 6.0, &ring);
        self.figure.disc(at, 2.2, &Paint::fill(Color::ORANGE));
        self.labels.avoid_box(PageBox::centered(self.figure.to_page(at), [15.0; 2]));
    }

    /// A disc, hollow where the part hides it, between two arrows.
    pub(crate) fn worst_point(&mut self) {
        let Some(SolidWorst { point, direction, .. }) = &self.picture.worst_point else {
            return;
        };
        let at = self.scene.point(*point);
        let sway = self.scene.direction(*direction) * self.length(SWAY);
        let stroke = Stroke::solid(Color::PURPLE, 2.0);
        let halo = Stroke::solid(Color::WHITE.with_opacity(0.8), 5.0);
        self.figure.polyline(&[flat(at - sway), flat(at + sway)], halo);
        for tip in [at - sway, at + sway] {
            self.figure.arrow(flat(at), flat(tip), stroke);
            let [from, to] = [at, tip].map(|point| self.figure.to_page(flat(point)));
            self.labels.avoid_line(from, to, Weight::Hard);
        }
        let fill = if self.screens.hide(at) { Color::WHITE } else { Color::PURPLE };
        self.figure.disc(flat(at), 4.2, &Paint::both(fill, Stroke::solid(Color::PURPLE, 1.6)));
        self.labels.avoid_box(PageBox::centered(self.figure.to_page(flat(at)), [12.0; 2]));
    }

    pub(crate) fn mark_labels(&mut self) {
        let picture = self.picture;
        for axis in &picture.axes {
            let [end, other] = self.axis_ends(axis);
            let spots = [spot(end, end - other, AXIS_GAP), spot(other, other - end, AXIS_GAP)];
            // The turning arrow has the name beside it.
            let spots = if axis.emphasized { &spots[..1] } else { &spots };
            self.label(&axis.label, axis_color(axis).0, spots);
        }
        let down_right = Vector::new([0.8, -0.6, 0.0]);
        if let Some(SolidWorst { point, label, .. }) = &picture.worst_point {
            let spot = spot(self.scene.point(*point), down_right, MARK_GAP);
            self.label(label, Color::PURPLE, &[spot]);
        }
        if let Some(SolidMark { point, label }) = &picture.center {
            let spot = spot(self.scene.point(*point), down_right, MARK_GAP);
            self.label(label, Color::ORANGE, &[spot]);
        }
    }
}

/// The color and width of an axis.
fn axis_color(axis: &SolidAxis) -> (Color, f64) {
    if axis.emphasized { (Color::ORANGE, 2.0) } else { (Color::GREY, 1.0) }
}
