//! The drawing of a grasp picture, layer by layer.

use std::f64::consts::PI;

use crate::arc::EllipseArc;
use crate::caption;
use crate::error::DrawError;
use crate::figure::Figure;
use crate::grasp::finger::Finger;
use crate::grasp::{GraspPicture, Way};
use crate::labels::{Labels, Weight};
use crate::page_box::PageBox;
use crate::paint::{Color, Paint, Stroke};

/// The page rectangle that the part of a picture of its own is fitted into.
pub(crate) const PLOT: PageBox = PageBox { min: [0.0, 0.0], max: [440.0, 380.0] };

/// Length and half-width of a pointed finger, and the length of the arrow of its force.
pub(crate) const WEDGE: [f64; 2] = [30.0, 7.0];
const FORCE: f64 = 30.0;

/// The length of the arrow of the largest force, where forces are given.
const LARGEST_FORCE: f64 = 48.0;

/// Depth and half-width of the pad that stands for a finger too large to show, and the
/// number of straight pieces in half a disc.
pub(crate) const PAD: [f64; 2] = [24.0, 26.0];
const DISC_STEPS: i32 = 36;

/// A disc finger is drawn whole up to this share of the part's extent.
const LARGEST_DISC: f64 = 0.4;

/// A line of action meets the contact's own edge at 0, or a little further on where a smooth
/// outline is given as a polygon: in parts of the extent.
const OWN_EDGE: f64 = 0.02;

/// Half the angle of the arc through the farthest corner, in radians.
const REACH_ARC: f64 = 0.24;

/// A grasp picture in the making.
pub(crate) struct Drawing<'a> {
    pub(crate) picture: &'a GraspPicture,
    pub(crate) figure: Figure,
    pub(crate) labels: Labels,
    /// The larger side of the part's box.
    extent: f64,
}

/// Draws a grasp whose part is fitted into a page rectangle.
pub(crate) fn draw(picture: &GraspPicture, plot: PageBox) -> Result<Figure, DrawError> {
    picture.check()?;
    let bounds = picture.bounds();
    let extent = (bounds[1][0] - bounds[0][0]).max(bounds[1][1] - bounds[0][1]);
    let figure = Figure::within(bounds, plot)?;
    picture.check_on_page(figure.map())?;
    let mut drawing = Drawing { picture, figure, labels: Labels::default(), extent };
    drawing.part();
    drawing.lines_of_action();
    drawing.reach();
    drawing.ways();
    drawing.displaced();
    drawing.outline();
    for finger in &picture.fingers {
        drawing.finger(finger);
    }
    drawing.directions();
    drawing.center_mark();
    drawing.loads();
    drawing.finger_labels();
    drawing.avoid_fingers();
    drawing.corner_labels();
    drawing.mark_labels();
    drawing.direction_labels();
    caption::write(&mut drawing.figure, &picture.caption);
    caption::heading(&mut drawing.figure, picture.title.as_deref());
    Ok(drawing.figure)
}

impl Drawing<'_> {
    fn part(&mut self) {
        let paint = Paint::fill(Color::PART);
        let picture = self.picture;
        self.fill_part(&paint);
        for region in &picture.regions {
            let edge = Stroke::solid(region.color.with_opacity(0.5), 0.8);
            let paint = Paint::both(region.color.with_opacity(0.11), edge);
            self.figure.polygon(&region.corners, &paint);
        }
    }

    /// Thin lines along the normals, to where they leave the part or pass the center.
    fn lines_of_action(&mut self) {
        for finger in &self.picture.fingers {
            let foot = self.picture.center.as_ref().map_or(0.0, |center| {
                (0..2).map(|i| (center.point[i] - finger.point[i]) * finger.inward_normal[i]).sum()
            });
            let beyond = self.figure.world_length(14.0);
            let length = self.exit(finger).max(foot + beyond);
            let end = finger.offset(length.max(self.figure.world_length(FORCE)), 0.0);
            let stroke = Stroke::solid(Color::BLUE.with_opacity(0.55), 0.9);
            self.figure.polyline(&[finger.point, end], stroke);
            self.avoid(finger.point, end, Weight::Soft);
        }
    }

    /// How far along its normal a finger's line first leaves the part; 0 if it never enters.
    fn exit(&self, finger: &Finger) -> f64 {
        let [nx, ny] = finger.inward_normal;
        let mut first = f64::INFINITY;
        let edges = self
            .picture
            .loops()
            .flat_map(|corners| corners.iter().zip(corners.iter().cycle().skip(1)));
        for (a, b) in edges {
            let (ex, ey) = (b[0] - a[0], b[1] - a[1]);
            let (px, py) = (a[0] - finger.point[0], a[1] - finger.point[1]);
            let slope = nx * ey - ny * ex;
            let (along, share) = ((px * ey - py * ex) / slope, (px * ny - py * nx) / slope);
            if (0.0..=1.0).contains(&share) && along > OWN_EDGE * self.extent {
                first = first.min(along);
            }
        }
        if first.is_finite() { first } else { 0.0 }
    }

    fn reach(&mut self) {
        let (Some(center), Some(corner)) = (&self.picture.center, self.picture.farthest_corner)
        else {
            return;
        };
        let run = [corner[0] - center.point[0], corner[1] - center.point[1]];
        let middle = run[1].atan2(run[0]);
        let stroke = Stroke::dashed(Color::ORANGE, 1.3);
        let arc = EllipseArc::circle(center.point, run[0].hypot(run[1]))
            .between(middle - REACH_ARC, middle + REACH_ARC);
        self.figure.arc(&arc, &Paint::stroke(stroke));
        self.figure.polyline(&[center.point, corner], stroke);
        self.avoid(center.point, corner, Weight::Soft);
        for i in 0..8 {
            let at = |i: f64| arc.point(middle + (i / 4.0 - 1.0) * REACH_ARC);
            self.avoid(at(f64::from(i)), at(f64::from(i + 1)), Weight::Soft);
        }
    }

    /// Dashed lines with an arrow at the end.
    fn ways(&mut self) {
        for Way { points, color } in &self.picture.ways {
            let stroke = Stroke::dashed(*color, 1.6);
            if let [.., from, to] = points.as_slice() {
                self.figure.polyline(&points[..points.len() - 1], stroke);
                self.figure.arrow(*from, *to, stroke);
            }
            for ends in points.windows(2) {
                self.avoid(ends[0], ends[1], Weight::Hard);
            }
        }
    }

    fn outline(&mut self) {
        let paint = Paint::stroke(Stroke::solid(Color::INK, 1.8));
        self.fill_part(&paint);
        for corners in self.picture.loops() {
            let page = self.on_page(corners);
            self.labels.avoid_ring(&page, Weight::Hard);
        }
    }

    /// The part with its holes.
    fn fill_part(&mut self, paint: &Paint) {
        let picture = self.picture;
        if picture.holes.is_empty() {
            self.figure.polygon(&picture.outline, paint);
        } else {
            self.figure.area(picture.loops(), paint);
        }
    }

    fn finger(&mut self, finger: &Finger) {
        let rim = Stroke::solid(Color::INK, 1.2);
        let paint = Paint::both(Color::BLUE.lightened(0.72), rim);
        let shape = self.finger_shape(finger);
        self.figure.polygon(&shape, &paint);
        let page = self.on_page(&shape);
        self.labels.avoid_ring(&page, Weight::Hard);
        let tip = finger.offset(self.figure.world_length(self.arrow_length(finger)), 0.0);
        self.figure.arrow(finger.point, tip, Stroke::solid(Color::BLUE, 1.6));
        self.figure.disc(finger.point, 2.6, &Paint::fill(Color::INK));
    }

    /// The length of the arrow of a finger's force, in page units.
    fn arrow_length(&self, finger: &Finger) -> f64 {
        let fingers = self.picture.fingers.iter();
        let largest = fingers.map(|finger| finger.force).fold(0.0, f64::max);
        if largest > 0.0 { LARGEST_FORCE * (finger.force / largest).max(0.0) } else { FORCE }
    }

    /// A wedge, a disc, or for a disc that would dwarf the part a pad with its curvature.
    fn finger_shape(&self, finger: &Finger) -> Vec<[f64; 2]> {
        let page = |units: f64| self.figure.world_length(units);
        if finger.radius == 0.0 {
            let [length, half] = WEDGE.map(page);
            return vec![finger.point, finger.offset(-length, half), finger.offset(-length, -half)];
        }
        let half =
            if self.whole(finger) { PI } else { (page(PAD[1]) / finger.radius).min(1.0).asin() };
        let mut shape: Vec<_> = (-DISC_STEPS..=DISC_STEPS)
            .map(|step| {
                let (sin, cos) = (half * f64::from(step) / f64::from(DISC_STEPS)).sin_cos();
                // 1 - cos, without cancelling for the slight curvature of a pad.
                let depth = sin * sin / (1.0 + cos).max(f64::MIN_POSITIVE);
                let depth = if cos < 0.0 { 1.0 - cos } else { depth };
                finger.offset(-finger.radius * depth, finger.radius * sin)
            })
            .collect();
        if !self.whole(finger) {
            shape.push(finger.offset(-page(PAD[0]), page(PAD[1])));
            shape.push(finger.offset(-page(PAD[0]), -page(PAD[1])));
        }
        shape
    }

    pub(crate) fn whole(&self, finger: &Finger) -> bool {
        finger.radius <= LARGEST_DISC * self.extent
    }

    fn center_mark(&mut self) {
        for note in &self.picture.notes {
            self.figure.disc(note.point, 2.4, &Paint::fill(Color::GREY));
        }
        let Some(center) = &self.picture.center else {
            return;
        };
        // A ring and a dot, told from contacts and corners without color.
        let ring = Paint::both(Color::WHITE, Stroke::solid(Color::ORANGE, 1.8));
        self.figure.disc(center.point, 6.0, &ring);
        self.figure.disc(center.point, 2.2, &Paint::fill(Color::ORANGE));
        let page = self.figure.to_page(center.point);
        self.labels.avoid_box(PageBox::centered(page, [15.0, 15.0]));
    }

    /// Keeps what is placed from now on off the fingers: not only off their rims.
    fn avoid_fingers(&mut self) {
        for finger in &self.picture.fingers {
            let mut area = PageBox::EMPTY;
            for corner in self.on_page(&self.finger_shape(finger)) {
                area.include(corner, 0.0);
            }
            self.labels.avoid_box(area);
        }
    }

    pub(crate) fn on_page(&self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        points.iter().map(|&point| self.figure.to_page(point)).collect()
    }

    pub(crate) fn avoid(&mut self, from: [f64; 2], to: [f64; 2], weight: Weight) {
        let (from, to) = (self.figure.to_page(from), self.figure.to_page(to));
        self.labels.avoid_line(from, to, weight);
    }
}
