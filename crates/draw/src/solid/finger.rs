//! A finger as a cone in space, and a locator's foot.

use std::f64::consts::PI;

use clench_screw::Vector;
use clench_screw::spatial::cross;

use crate::arc::{EllipseArc, Piece};
use crate::figure::Figure;
use crate::paint::{Color, Paint, Stroke};
use crate::solid::scene::flat;
use crate::world_map::UNSEEN;

/// Length and radius of the cone, in page units.
const CONE: [f64; 2] = [44.0, 7.5];

/// Half the side and the thickness of the square foot of a locator, in page units.
const FOOT: [f64; 2] = [11.0, 5.0];

/// How far the foot is turned about the finger, in radians, so that two of its sides show.
const FOOT_TURN: f64 = 0.5;

/// The opacity of the veil over a finger behind the part.
const VEIL: f64 = 0.13;

/// Straight pieces that stand for the rim of the cone where it is hidden.
const RIM_STEPS: i32 = 24;

/// A finger's shape in coordinates of the view.
#[derive(Debug)]
pub(crate) struct Cone {
    pub(crate) tip: Vector<3>,
    /// From the base to the tip, of unit length.
    pub(crate) inward: Vector<3>,
    /// The middle of the base.
    pub(crate) base: Vector<3>,
    /// Two half-diameters of the base, at right angles; the first leads towards the viewer.
    radii: [Vector<3>; 2],
    /// The angles at which the sides of the cone are seen are this and its negative; none where
    /// the cone is seen from its tip or its base.
    side: Option<f64>,
    /// Corners of the foot at the base, and what leads from there to those farther out.
    foot: Option<([Vector<3>; 4], Vector<3>)>,
    color: Color,
    /// Whether the part hides the contact.
    pub(crate) is_behind: bool,
}

/// Two directions at right angles to a unit one and to each other, the first leading as far
/// towards the viewer as may be.
pub(crate) fn around(along: Vector<3>) -> [Vector<3>; 2] {
    let sight = Vector::new([0.0, 0.0, 1.0]);
    let first = (sight - along * along[2]).direction().filter(|_| along[2].abs() < 1.0 - UNSEEN);
    let first = first.unwrap_or_else(|| {
        let right = Vector::new([1.0, 0.0, 0.0]);
        (right - along * along[0]).direction().unwrap_or(right)
    });
    [first, cross(along, first)]
}

impl Cone {
    /// The cone with its tip here; `unit` is the length of a page unit.
    pub(crate) fn new(tip: Vector<3>, inward: Vector<3>, unit: f64, fixed: bool) -> Self {
        let [length, radius] = CONE.map(|side| side * unit);
        let [first, second] = around(inward);
        let base = tip - inward * length;
        // The surface is seen edge-on where its normal, the direction out of the axis plus
        // radius / length along it, is at right angles to the line of sight.
        let cosine = -(radius / length) * inward[2] / first[2];
        let foot = fixed.then(|| {
            let [half, thick] = FOOT.map(|side| side * unit);
            let (sin, cos) = FOOT_TURN.sin_cos();
            let (u, v) = (first * cos + second * sin, second * cos - first * sin);
            let corner = |a: f64, b: f64| base + (u * a + v * b) * half;
            let corners =
                [corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0)];
            (corners, inward * -thick)
        });
        Self {
            tip,
            inward,
            base,
            radii: [first * radius, second * radius],
            side: (cosine.abs() < 1.0).then(|| cosine.acos()),
            foot,
            color: if fixed { Color::GREEN } else { Color::BLUE },
            is_behind: false,
        }
    }

    /// The same finger, of which the part may hide the contact.
    pub(crate) fn behind(self, is_behind: bool) -> Self {
        Self { is_behind, ..self }
    }

    /// The color of its name.
    pub(crate) fn label_color(&self) -> Color {
        if self.is_behind { self.color.lightened(0.3) } else { self.color }
    }

    /// Triangles that cover the shape as it is seen.
    pub(crate) fn patches(&self) -> Vec<[Vector<3>; 3]> {
        let [u, v] = self.radii;
        let mut patches = Vec::new();
        if let Some(side) = self.side {
            patches.push([self.tip, self.rim(side), self.rim(-side)]);
        }
        let mut add = |[a, b, c, d]: [Vector<3>; 4]| patches.extend([[a, b, c], [a, c, d]]);
        add([self.base + u, self.base + v, self.base - u, self.base - v]);
        if let Some((corners, out)) = self.foot {
            add(corners);
            add(corners.map(|corner| corner + out));
        }
        patches
    }

    fn rim(&self, angle: f64) -> Vector<3> {
        self.base + self.radii[0] * angle.cos() + self.radii[1] * angle.sin()
    }

    fn base_arc(&self) -> EllipseArc {
        EllipseArc::ellipse(flat(self.base), self.radii.map(flat))
    }

    /// Paints the finger as if nothing hid it.
    pub(crate) fn paint(&self, figure: &mut Figure) {
        let pale = if self.is_behind { 0.45 } else { 0.0 };
        let line = Stroke::solid(self.color.lightened(pale), 1.1);
        let shade =
            |share: f64| Paint::both(self.color.lightened(pale + (1.0 - pale) * share), line);
        let base_first = self.inward[2] > 0.0;
        if base_first {
            self.paint_base(figure, &shade);
        }
        if let Some(side) = self.side {
            let arc = self.base_arc().between(-side, side);
            figure.closed(&[Piece::Corner(flat(self.tip)), Piece::Arc(arc)], &shade(0.25));
        }
        if !base_first {
            self.paint_base(figure, &shade);
        }
    }

    fn paint_base(&self, figure: &mut Figure, shade: &impl Fn(f64) -> Paint) {
        let Some((corners, out)) = self.foot else {
            return figure.arc(&self.base_arc(), &shade(0.6));
        };
        for i in 0..4 {
            let (a, b) = (corners[i], corners[(i + 1) % 4]);
            let outward = (a + b) * 0.5 - self.base;
            if outward[2] > 0.0 {
                figure.polygon(&[a, b, b + out, a + out].map(flat), &shade(0.45));
            }
        }
        let shown = if out[2] > 0.0 { corners.map(|corner| corner + out) } else { corners };
        figure.polygon(&shown.map(flat), &shade(0.7));
    }

    /// The lines that bound it, to be dashed where they are hidden.
    pub(crate) fn lines(&self) -> Vec<Vec<Vector<3>>> {
        let mut lines = Vec::new();
        if let Some(side) = self.side {
            lines.push(vec![self.rim(-side), self.tip, self.rim(side)]);
        }
        lines.push(match self.foot {
            Some((corners, out)) => (0..5).map(|i| corners[i % 4] + out).collect(),
            None => (0..=RIM_STEPS)
                .map(|step| self.rim(2.0 * PI * f64::from(step) / f64::from(RIM_STEPS)))
                .collect(),
        });
        lines
    }

    /// A veil over the shape, which shows where it is behind the part.
    pub(crate) fn paint_veil(&self, figure: &mut Figure) {
        let veil = Paint::fill(self.color.with_opacity(VEIL));
        if let Some(side) = self.side {
            // The rim is on the far side of the base from the tip.
            let (from, to) =
                if self.inward[2] > 0.0 { (-side, side) } else { (side, 2.0 * PI - side) };
            let arc = self.base_arc().between(from, to);
            figure.closed(&[Piece::Corner(flat(self.tip)), Piece::Arc(arc)], &veil);
        } else {
            figure.arc(&self.base_arc(), &veil);
        }
        if let Some((corners, out)) = self.foot {
            figure.polygon(&corners.map(|corner| flat(corner + out)), &veil);
        }
    }

    /// How its hidden lines are drawn.
    pub(crate) fn hidden_stroke(&self) -> Stroke {
        Stroke::dashed(self.color.lightened(0.35), 1.1)
    }
}
