//! A solid as a load has moved it, and the loads.

use clench_screw::Vector;

use crate::error::{DrawError, Input};
use crate::labels::{Spot, Weight};
use crate::paint::{Color, Stroke};
use crate::solid::drawing::Drawing;
use crate::solid::edges::{EdgeKind, lines};
use crate::solid::hiding::Screens;
use crate::solid::scene::{Scene, flat};
use crate::solid::{SolidFace, SolidPicture, all_finite, direction};
use crate::text::{LABEL_SIZE, Text};

/// The length of a load's arrow, in page units, and the least share of it that is taken to be seen.
const LOAD: f64 = 46.0;
const LEAST_SEEN: f64 = 0.3;

/// A small motion of a solid, drawn by its edges over the solid at rest.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolidDisplaced {
    /// The point that the motion is written about, near the solid.
    pub about: [f64; 3],
    /// The displacement of that point.
    pub translation: [f64; 3],
    /// The small rotation (rad), axis times angle.
    pub rotation: [f64; 3],
    /// How many times as far it is drawn; see [`exaggeration`](crate::exaggeration).
    pub exaggeration: f64,
}

/// A force from outside, drawn as an arrow that ends where it acts; its length says nothing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolidLoad {
    /// Where it acts.
    pub point: [f64; 3],
    /// The direction in which it acts, of any length but zero.
    pub along: [f64; 3],
    /// What it is called, such as its value. Empty for none.
    pub label: String,
}

impl SolidDisplaced {
    /// How far a point moves, not exaggerated.
    #[must_use]
    pub fn displacement_at(&self, point: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = [0, 1, 2].map(|i| point[i] - self.about[i]);
        let [a, b, c] = self.rotation;
        let turned = [b * z - c * y, c * x - a * z, a * y - b * x];
        [0, 1, 2].map(|i| self.translation[i] + turned[i])
    }

    pub(crate) fn check(&self) -> Result<(), DrawError> {
        for vector in [self.about, self.translation, self.rotation, [self.exaggeration; 3]] {
            all_finite(vector, Input::Displaced, 0)?;
        }
        Ok(())
    }

    /// Where a point is drawn, to first order in the rotation.
    fn moved(&self, point: [f64; 3]) -> [f64; 3] {
        let moved = self.displacement_at(point);
        [0, 1, 2].map(|i| point[i] + self.exaggeration * moved[i])
    }

    fn face(&self, face: &SolidFace) -> SolidFace {
        let ring = |ring: &Vec<[f64; 3]>| ring.iter().map(|&corner| self.moved(corner)).collect();
        SolidFace {
            outward_normal: face.outward_normal,
            loops: face.loops.iter().map(ring).collect(),
            triangles: face.triangles.iter().map(|t| t.map(|corner| self.moved(corner))).collect(),
        }
    }
}

impl SolidLoad {
    pub(crate) fn check(&self, index: usize) -> Result<(), DrawError> {
        all_finite(self.point, Input::LoadPoint, index)?;
        direction(self.along, Input::LoadDirection, index)
    }
}

impl Drawing<'_> {
    /// The edges in sight of the solid where the load has moved it.
    pub(crate) fn displaced(&mut self) {
        let Some(displaced) = &self.picture.displaced else { return };
        let faces = self.picture.faces.iter().map(|face| displaced.face(face)).collect();
        let moved = SolidPicture { faces, ..SolidPicture::default() };
        let scene = Scene::seen_as(&moved, &self.scene);
        let screens = Screens::of_part(&scene);
        let shown = lines(&moved, &scene).into_iter().filter(|line| line.kind != EdgeKind::Hollow);
        for line in shown {
            for run in screens.runs(&line.points).into_iter().filter(|run| run.seen) {
                self.line(&run.points, Stroke::solid(Color::ORANGE, 1.3), Some(Weight::Soft));
            }
        }
    }

    pub(crate) fn loads(&mut self) {
        for SolidLoad { point, along, label } in &self.picture.loads {
            let (tip, along) = (self.scene.point(*point), self.scene.direction(*along));
            let tail: Vector<3> = tip - along * self.length(LOAD);
            let seen = along[0].hypot(along[1]);
            self.figure.arrow(flat(tail), flat(tip), Stroke::solid(Color::PURPLE, 2.2));
            let [from, to] = [tail, tip].map(|at| self.figure.to_page(flat(at)));
            self.labels.avoid_line(from, to, Weight::Hard);
            if label.is_empty() {
                continue;
            }
            let toward = [-along[0], along[1]].map(|side| side / seen.max(LEAST_SEEN));
            let text = Text::new(label, LABEL_SIZE).colored(Color::PURPLE).with_halo();
            let spot = Spot { at: flat(tail), toward, gap: 4.0 };
            self.labels.write(&mut self.figure, &text, spot);
        }
    }
}
