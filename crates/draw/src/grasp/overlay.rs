//! What is drawn over a grasp where it is of use: principal directions, loads, and the part as a
//! load has moved it.

use crate::error::{DrawError, Input};
use crate::grasp::drawing::Drawing;
use crate::grasp::point;
use crate::labels::{Spot, Weight};
use crate::paint::{Color, Paint, Stroke};
use crate::text::{LABEL_SIZE, Text};
use crate::world_map::WorldMap;

/// Half the length of a principal direction, from the center, and the length of a load's arrow, in
/// page units.
const DIRECTION: f64 = 46.0;
const LOAD: f64 = 44.0;

/// A line through the center with an arrow at both ends, such as a principal direction.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Direction {
    /// Along the line, of length 1.
    pub along: [f64; 2],
    /// What it is called; `_{…}` lowers and `^{…}` raises. Empty for none.
    pub label: String,
}

/// A force from outside, drawn as an arrow that ends where it acts; its length says nothing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Load {
    /// Where it acts.
    pub point: [f64; 2],
    /// The direction in which it acts, of length 1.
    pub along: [f64; 2],
    /// What it is called, such as its value. Empty for none.
    pub label: String,
}

/// The part as a load has moved it, drawn over the part at rest.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Displaced {
    /// How far each corner moves: those of the outline, then those of the holes.
    pub shifts: Vec<[f64; 2]>,
    /// How many times as far it is drawn; see [`exaggeration`](crate::exaggeration).
    pub exaggeration: f64,
}

impl Displaced {
    fn moved(&self, corner: [f64; 2], number: usize) -> [f64; 2] {
        let by = self.shifts.get(number).copied().unwrap_or_default();
        [corner[0] + self.exaggeration * by[0], corner[1] + self.exaggeration * by[1]]
    }

    /// Refuses what is no number, or leads absurdly far.
    pub(crate) fn check(&self, corners: &[[f64; 2]], map: &WorldMap) -> Result<(), DrawError> {
        for (number, &corner) in corners.iter().enumerate() {
            let moved = self.moved(corner, number);
            point(moved, Input::Displaced, number)?;
            map.check(moved, Input::Displaced, number)?;
        }
        Ok(())
    }
}

impl Drawing<'_> {
    /// The part where the load has moved it, exaggerated.
    pub(crate) fn displaced(&mut self) {
        let Some(displaced) = &self.picture.displaced else { return };
        let mut number = 0;
        let mut moved = |ring: &[[f64; 2]]| {
            let start = number;
            number += ring.len();
            (start..).zip(ring).map(|(i, &corner)| displaced.moved(corner, i)).collect()
        };
        let rings: Vec<Vec<[f64; 2]>> = self.picture.loops().map(&mut moved).collect();
        let edge = Stroke::solid(Color::ORANGE, 1.4);
        let paint = Paint::both(Color::ORANGE.with_opacity(0.08), edge);
        self.figure.area(rings.iter().map(Vec::as_slice), &paint);
        for ring in &rings {
            let page = self.on_page(ring);
            self.labels.avoid_ring(&page, Weight::Soft);
        }
    }

    /// Double arrows through the center.
    pub(crate) fn directions(&mut self) {
        let Some(center) = &self.picture.center else { return };
        let half = self.figure.world_length(DIRECTION);
        for Direction { along, .. } in &self.picture.directions {
            for side in [-half, half] {
                let tip = [center.point[0] + side * along[0], center.point[1] + side * along[1]];
                self.figure.arrow(center.point, tip, Stroke::solid(Color::GREEN, 1.2));
                self.avoid(center.point, tip, Weight::Hard);
            }
        }
    }

    pub(crate) fn direction_labels(&mut self) {
        let Some(center) = &self.picture.center else { return };
        let half = self.figure.world_length(DIRECTION);
        for Direction { along, label } in &self.picture.directions {
            // The upper end, or the right one of a level line.
            let side = if along[1].abs() > 0.1 { along[1].signum() } else { along[0].signum() };
            let end = [0, 1].map(|i| center.point[i] + side * half * along[i]);
            let toward = [side * along[0], -side * along[1]];
            self.name(end, label, Color::GREEN, toward);
        }
    }

    pub(crate) fn loads(&mut self) {
        let length = self.figure.world_length(LOAD);
        for Load { point, along, label } in &self.picture.loads {
            let tail = [0, 1].map(|i| point[i] - length * along[i]);
            self.figure.arrow(tail, *point, Stroke::solid(Color::PURPLE, 2.0));
            self.avoid(tail, *point, Weight::Hard);
            self.name(tail, label, Color::PURPLE, [-along[0], along[1]]);
        }
    }

    fn name(&mut self, at: [f64; 2], label: &str, color: Color, toward: [f64; 2]) {
        if label.is_empty() {
            return;
        }
        let text = Text::new(label, LABEL_SIZE).colored(color).with_halo();
        self.labels.write(&mut self.figure, &text, Spot { at, toward, gap: 4.0 });
    }
}
