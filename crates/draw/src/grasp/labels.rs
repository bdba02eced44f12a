//! The texts of a grasp picture.

use crate::grasp::Mark;
use crate::grasp::drawing::{Drawing, PAD, WEDGE};
use crate::labels::Spot;
use crate::paint::Color;
use crate::text::{LABEL_SIZE, Text};

impl Drawing<'_> {
    pub(crate) fn finger_labels(&mut self) {
        for finger in &self.picture.fingers {
            let shown = if finger.preload.is_empty() {
                finger.label.clone()
            } else if finger.label.is_empty() {
                finger.preload.clone()
            } else {
                format!("{}: {}", finger.label, finger.preload)
            };
            let out = [-finger.inward_normal[0], finger.inward_normal[1]];
            let scale = 1.0 / self.figure.world_length(1.0);
            let whole = self.whole(finger);
            if finger.radius > 0.0 && whole && finger.radius * scale > LABEL_SIZE {
                // Room inside the disc.
                let center = finger.offset(-finger.radius, 0.0);
                let text = Text::new(shown.as_str(), LABEL_SIZE).colored(Color::BLUE);
                if text.page_size()[0] < 1.7 * finger.radius * scale {
                    self.figure.text(center, [0.0, 0.0], &text);
                    continue;
                }
            }
            let depth = match (finger.radius > 0.0, whole) {
                (false, _) => WEDGE[0],
                (true, true) => 2.0 * finger.radius * scale,
                (true, false) => PAD[0],
            };
            self.label(finger.point, &shown, Color::BLUE, out, depth + 5.0);
        }
    }

    pub(crate) fn corner_labels(&mut self) {
        let picture = self.picture;
        let holes = picture.loops().enumerate().map(|(i, corners)| (corners, i > 0));
        let corners = holes.flat_map(|(ring, hole)| (0..ring.len()).map(move |i| (ring, i, hole)));
        for ((ring, corner, hole), label) in corners.zip(&picture.corner_labels) {
            let [x, y] = outward(ring, corner);
            let out = if hole { [-x, y] } else { [x, -y] };
            self.label(ring[corner], label, Color::INK, out, 5.0);
        }
    }

    pub(crate) fn mark_labels(&mut self) {
        let down_right = [0.8, 0.6];
        if let Some(Mark { point, label }) = &self.picture.center {
            self.label(*point, label, Color::ORANGE, down_right, 9.0);
        }
        for Mark { point, label } in &self.picture.notes {
            self.label(*point, label, Color::GREY, down_right, 5.0);
        }
    }

    fn label(&mut self, at: [f64; 2], label: &str, color: Color, toward: [f64; 2], gap: f64) {
        if label.is_empty() {
            return;
        }
        let text = Text::new(label, LABEL_SIZE).colored(color).with_halo();
        self.labels.write(&mut self.figure, &text, Spot { at, toward, gap });
    }
}

/// The unit direction that leads out of a ring at a corner: along the bisector, to the side
/// that the ring's orientation says.
fn outward(ring: &[[f64; 2]], corner: usize) -> [f64; 2] {
    let at = |i: usize| ring[i % ring.len()];
    let unit = |from: [f64; 2], to: [f64; 2]| {
        let run = [to[0] - from[0], to[1] - from[1]];
        let length = run[0].hypot(run[1]);
        if length > 0.0 { run.map(|value| value / length) } else { [0.0, 0.0] }
    };
    let here = at(corner);
    let into = unit(at(corner + ring.len() - 1), here);
    let away = unit(here, at(corner + 1));
    // Areas are taken about the corner, so that a far origin does not drown them.
    let doubled_area: f64 = (0..ring.len())
        .map(|i| {
            let (a, b) = (at(i), at(i + 1));
            (a[0] - here[0]) * (b[1] - here[1]) - (a[1] - here[1]) * (b[0] - here[0])
        })
        .sum();
    // The right-hand side of a counter-clockwise ring is outside.
    let side = if doubled_area < 0.0 { -1.0 } else { 1.0 };
    let normal = [side * (into[1] + away[1]), -side * (into[0] + away[0])];
    let length = normal[0].hypot(normal[1]);
    if length > 0.0 {
        normal.map(|value| value / length)
    } else if into[0].hypot(into[1]) > 0.0 {
        into
    } else {
        // Neighboring corners coincide: every direction is as good.
        [0.0, 1.0]
    }
}
