//! The names in the picture of a contact.

use crate::contact::drawing::Drawing;
use crate::contact::layout::Layout;
use crate::labels::Spot;
use crate::page_box::PageBox;
use crate::paint::Color;
use crate::text::{LABEL_SIZE, SMALL_SIZE, Text};

/// Room for the name of a flat part's radius between its middle and the end of the view.
const FLAT_LABEL: f64 = 36.0;

/// A part from this radius on has room for its name.
const NAMED_INSIDE: f64 = 100.0;

/// How far the names of the bodies stand from the axis, in parts of what is seen of the body, and
/// from the end of the view.
const ASIDE: f64 = 0.5;
const OFF_END: f64 = 16.0;

impl Drawing<'_> {
    /// What the bodies are called, inside if there is room.
    pub(crate) fn body_names(&mut self) {
        let Layout { finger, part, half, top, bottom, .. } = *self.layout;
        let [_, y] = finger.center();
        let at = if top - y > finger.radius {
            [0.0, y + ASIDE * finger.radius]
        } else {
            [ASIDE * half, top - OFF_END]
        };
        self.body_name("finger A", at);
        let reach = part.radius.min(half);
        let at = if part.bends_up || part.radius > NAMED_INSIDE {
            [ASIDE * reach, OFF_END - bottom]
        } else {
            [part.radius + 2.0 * OFF_END, part.center()[1] - OFF_END]
        };
        self.body_name("part B", at);
    }

    fn body_name(&mut self, content: &str, at: [f64; 2]) {
        let text = Text::new(content, SMALL_SIZE).colored(Color::GREY);
        self.labels.avoid_box(PageBox::centered(self.figure.to_page(at), text.page_size()));
        self.figure.text(at, [0.0, 0.0], &text);
    }

    /// Names, those with the least choice first.
    pub(crate) fn texts(&mut self) {
        let Layout { overlap, finger, part, half_width, .. } = *self.layout;
        let dimension = [self.overlap_at(), -overlap / 2.0];
        self.name("δ", Color::INK, spot(dimension, [1.0, 0.0], 6.0));
        if let Some(half_width) = half_width {
            let rise = self.half_width_rise(half_width);
            self.name("a_{H}", Color::ORANGE, spot([-half_width / 2.0, rise], [0.0, -1.0], 3.0));
        }
        self.name("b", Color::INK, spot([0.0, 0.0], [0.7, -0.7], 5.0));
        self.name("a", Color::INK, spot([0.0, -overlap], [-0.7, 0.7], 5.0));
        let tip = self.normal_tip();
        self.name("n", Color::BLUE, spot([tip[0], tip[1] + 8.0], [1.0, 0.0], 8.0));
        if self.layout.shows_finger_center() {
            self.name("c", Color::INK, spot(finger.center(), [0.8, -0.6], 6.0));
        }
        self.radius("r_{A}", self.finger_radius());
        match self.part_radius() {
            None => {
                let [x, y] = self.part_radius_end();
                let x = x.max(FLAT_LABEL - self.layout.half);
                self.name("r_{B} = ∞", Color::INK, spot([x, y], [0.0, 1.0], 6.0));
            }
            Some(arrow) if part.bends_up => self.radius("r_{B} < 0", arrow),
            Some(arrow) => self.radius("r_{B}", arrow),
        }
    }

    /// A name beside the middle of an arrow.
    fn radius(&mut self, content: &str, [tail, tip]: [[f64; 2]; 2]) {
        let middle = [0, 1].map(|i| f64::midpoint(tail[i], tip[i]));
        let run = [tip[0] - tail[0], tip[1] - tail[1]];
        let length = run[0].hypot(run[1]);
        // A normal of the arrow, y down: upwards from a center, else towards the axis.
        let aside = [run[1] / length, run[0] / length];
        let from_center = tail[0] == 0.0;
        let turned = if from_center { aside[1] > 0.0 } else { aside[0] < 0.0 };
        let aside = if turned { aside.map(|value| -value) } else { aside };
        self.name(content, Color::INK, spot(middle, aside, 4.0));
    }

    fn name(&mut self, content: &str, color: Color, spot: Spot) {
        let text = Text::new(content, LABEL_SIZE).colored(color);
        self.labels.write(&mut self.figure, &text, spot);
    }
}

fn spot(at: [f64; 2], toward: [f64; 2], gap: f64) -> Spot {
    Spot { at, toward, gap }
}
