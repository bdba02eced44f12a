//! The drawing of a solid, layer by layer.

use clench_screw::Vector;

use crate::caption;
use crate::error::{DrawError, Input};
use crate::figure::Figure;
use crate::labels::{Labels, Spot, Weight};
use crate::page_box::PageBox;
use crate::paint::{Color, Paint, Stroke};
use crate::solid::choose;
use crate::solid::edges::{EdgeKind, Line, lines};
use crate::solid::finger::Cone;
use crate::solid::hiding::{Screens, is_behind};
use crate::solid::order::{Order, Patch};
use crate::solid::scene::{PartFrame, Scene, flat};
use crate::solid::{SolidPicture, grid, triad};
use crate::text::{LABEL_SIZE, Text};

/// The page rectangle that the part is fitted into.
const PLOT: [f64; 2] = [420.0, 360.0];

/// A part of more triangles shows no hidden edges.
const HIDDEN_LIMIT: usize = 5000;

/// Edges in sight and behind, and the line that closes the seams between faces of one color.
const EDGE: Stroke = Stroke::solid(Color::INK, 1.5);
const HIDDEN: Stroke = Stroke::dashed(Color::PALE, 0.8);
const SEAM: f64 = 0.7;

/// A hidden run is left out if it is no longer than this, in page units: of a sharp edge, than a
/// dash and a gap; of an outline, than what the zigzag of a mesh may take.
const HIDDEN_LENGTH: [f64; 2] = [8.5, 24.0];

/// Where the light comes from: from the upper left, somewhat from behind the viewer.
const LIGHT: [f64; 3] = [-0.35, 0.75, 0.56];

/// The color of a face in the shade, and how far towards white it is there and in the light.
const SHADE: Color = Color::new([0x8f, 0x9d, 0xae]);
const LIGHTENED: [f64; 2] = [0.2, 0.92];

/// The room that a finger's base takes from labels, in page units.
const BASE_ROOM: f64 = 14.0;

/// How far a name stands from a finger's base, in page units.
const NAME_GAP: f64 = 10.0;

/// A unit direction of which less is seen says nothing about where a name goes: then up and to
/// the right.
const SHOWN: f64 = 0.1;
const UP_RIGHT: [f64; 2] = [0.6, -0.8];

/// A picture of a solid in the making.
pub(crate) struct Drawing<'a> {
    pub(crate) picture: &'a SolidPicture,
    pub(crate) scene: Scene,
    pub(crate) figure: Figure,
    pub(crate) labels: Labels,
    /// What the part hides is behind these.
    pub(crate) screens: Screens,
    pub(crate) cones: Vec<Cone>,
}

pub(crate) fn draw(picture: &SolidPicture) -> Result<Figure, DrawError> {
    let frame = PartFrame::new(&picture.faces)?;
    let scene = Scene::new(picture, frame, choose::eye(picture, frame));
    let figure = figure(picture, &scene)?;
    let screens = Screens::of_part(&scene);
    let labels = Labels::default();
    let mut drawing = Drawing { picture, scene, figure, labels, screens, cones: Vec::new() };
    drawing.check_on_page()?;
    drawing.set_up_cones();
    let covered = drawing.faces();
    drawing.edges(&covered);
    drawing.displaced();
    drawing.axes();
    drawing.fingers_in_front(&covered);
    drawing.hidden_finger_lines();
    drawing.center();
    drawing.worst_point();
    drawing.loads();
    drawing.finger_labels();
    drawing.mark_labels();
    triad::draw(&mut drawing);
    caption::write(&mut drawing.figure, &picture.caption);
    caption::heading(&mut drawing.figure, picture.title.as_deref());
    Ok(drawing.figure)
}

/// The empty figure with room for the part and the points that are marked.
fn figure(picture: &SolidPicture, scene: &Scene) -> Result<Figure, DrawError> {
    let fingers = picture.fingers.iter().map(|finger| finger.point);
    let marks = picture.center.iter().map(|mark| mark.point);
    let worst = picture.worst_point.iter().map(|worst| worst.point);
    let points = fingers.chain(marks).chain(worst).map(|point| scene.point(point));
    let points: Vec<_> = scene.corners().chain(points).collect();
    Figure::new(grid::around(&points), PLOT)
}

impl Drawing<'_> {
    /// The length in the scene of so many page units.
    pub(crate) fn length(&self, page_units: f64) -> f64 {
        self.figure.world_length(page_units)
    }

    fn check_on_page(&self) -> Result<(), DrawError> {
        let map = self.figure.map();
        for (index, axis) in self.picture.axes.iter().enumerate() {
            map.check(flat(self.foot(axis)), Input::AxisPoint, index)?;
        }
        Ok(())
    }

    fn set_up_cones(&mut self) {
        let unit = self.length(1.0);
        for finger in &self.picture.fingers {
            let tip = self.scene.point(finger.point);
            let inward = self.scene.direction(finger.inward_normal);
            let is_behind = is_behind(&self.screens, tip, inward);
            let cone = Cone::new(tip, inward, unit, finger.fixed);
            self.cones.push(cone.behind(is_behind));
        }
    }

    /// Paints the faces, with the fingers that they cover some of; says which these are.
    fn faces(&mut self) -> Vec<bool> {
        let front = self.scene.faces.iter().enumerate().filter(|(_, face)| face.is_front());
        let faces: Vec<_> =
            front.flat_map(|(i, face)| face.triangles.iter().map(move |&t| (i, t))).collect();
        let mut patches: Vec<_> =
            (0..).zip(&faces).map(|(thing, &(_, corners))| Patch { thing, corners }).collect();
        for (thing, cone) in (faces.len()..).zip(&self.cones) {
            patches.extend(cone.patches().into_iter().map(|corners| Patch { thing, corners }));
        }
        let order = Order::new(faces.len() + self.cones.len(), &patches);
        let covered: Vec<bool> = order.covered_by[faces.len()..]
            .iter()
            .map(|nearer| nearer.iter().any(|&thing| thing < faces.len()))
            .collect();
        for thing in order.sequence {
            if let Some(&(face, corners)) = faces.get(thing) {
                let color = shaded(self.scene.faces[face].normal);
                let paint = Paint::both(color, Stroke::solid(color, SEAM));
                self.figure.polygon(&corners.map(flat), &paint);
            } else if covered[thing - faces.len()] {
                self.cones[thing - faces.len()].paint(&mut self.figure);
            }
        }
        covered
    }

    /// Hidden edges, then those in sight, except behind the fingers that are painted already.
    fn edges(&mut self, covered: &[bool]) {
        let pairs = self.cones.iter().zip(covered).filter(|(_, covered)| **covered);
        let cones = Screens::new(pairs.flat_map(|(cone, _)| cone.patches()));
        let triangles: usize = self.scene.faces.iter().map(|face| face.triangles.len()).sum();
        let mut seen = Vec::new();
        for Line { points, kind } in lines(self.picture, &self.scene) {
            let shortest = self.length(HIDDEN_LENGTH[usize::from(kind != EdgeKind::Sharp)]);
            for run in self.screens.runs(&points) {
                if run.seen && kind != EdgeKind::Hollow {
                    seen.extend(cones.runs(&run.points).into_iter().filter(|run| run.seen));
                } else if !run.seen && triangles <= HIDDEN_LIMIT && run.length() > shortest {
                    self.line(&run.points, HIDDEN, None);
                }
            }
        }
        for run in seen {
            self.line(&run.points, EDGE, Some(Weight::Hard));
        }
    }

    /// Draws a line, which labels may have to avoid; a closed one has no ends.
    pub(crate) fn line(&mut self, points: &[Vector<3>], stroke: Stroke, weight: Option<Weight>) {
        let line: Vec<_> = points.iter().map(|&point| flat(point)).collect();
        if points.len() > 2 && points.first() == points.last() {
            self.figure.polygon(&line[1..], &Paint::stroke(stroke));
        } else {
            self.figure.polyline(&line, stroke);
        }
        if let Some(weight) = weight {
            for ends in line.windows(2) {
                let [from, to] = [ends[0], ends[1]].map(|at| self.figure.to_page(at));
                self.labels.avoid_line(from, to, weight);
            }
        }
    }

    /// The fingers that no face covers, those farther back first.
    fn fingers_in_front(&mut self, covered: &[bool]) {
        let free: Vec<usize> = (0..self.cones.len()).filter(|&i| !covered[i]).collect();
        let patches: Vec<_> = (0..)
            .zip(&free)
            .flat_map(|(thing, &i)| {
                self.cones[i].patches().into_iter().map(move |corners| Patch { thing, corners })
            })
            .collect();
        for thing in Order::new(free.len(), &patches).sequence {
            self.cones[free[thing]].paint(&mut self.figure);
        }
    }

    fn hidden_finger_lines(&mut self) {
        for i in 0..self.cones.len() {
            if self.cones[i].is_behind {
                self.cones[i].paint_veil(&mut self.figure);
            }
            let stroke = self.cones[i].hidden_stroke();
            for line in self.cones[i].lines() {
                for run in self.screens.runs(&line) {
                    if !run.seen {
                        self.line(&run.points, stroke, None);
                    }
                }
                for ends in line.windows(2) {
                    let [from, to] = [ends[0], ends[1]].map(|at| self.figure.to_page(flat(at)));
                    self.labels.avoid_line(from, to, Weight::Hard);
                }
            }
            let base = self.figure.to_page(flat(self.cones[i].base));
            self.labels.avoid_box(PageBox::centered(base, [BASE_ROOM; 2]));
        }
    }

    fn finger_labels(&mut self) {
        for i in 0..self.cones.len() {
            let cone = &self.cones[i];
            let (spot, color) = (spot(cone.base, cone.inward * -1.0, NAME_GAP), cone.label_color());
            self.label(&self.picture.fingers[i].label, color, &[spot]);
        }
    }

    /// Writes a name at the best of some spots.
    pub(crate) fn label(&mut self, label: &str, color: Color, spots: &[Spot]) {
        if label.is_empty() {
            return;
        }
        let text = Text::new(label, LABEL_SIZE).colored(color).with_halo();
        self.labels.write_at_best(&mut self.figure, &text, spots);
    }
}

/// The spot for a name near a point, in the direction of the picture that one in the scene has.
pub(crate) fn spot(at: Vector<3>, toward: Vector<3>, gap: f64) -> Spot {
    let length = toward[0].hypot(toward[1]);
    let toward = if length > SHOWN { [toward[0] / length, -toward[1] / length] } else { UP_RIGHT };
    Spot { at: flat(at), toward, gap }
}

/// The color of a face with this unit normal.
fn shaded(normal: Vector<3>) -> Color {
    let lit = f64::midpoint(1.0, normal.dot(LIGHT.into()));
    SHADE.lightened(LIGHTENED[0] + (LIGHTENED[1] - LIGHTENED[0]) * lit)
}
