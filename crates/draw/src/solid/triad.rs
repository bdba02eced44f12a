//! The small axes of the caller's coordinates in a corner of the picture.

use crate::page_box::PageBox;
use crate::paint::{Color, Stroke};
use crate::solid::drawing::Drawing;
use crate::solid::order::shared;
use crate::solid::scene::flat;
use crate::text::{SMALL_SIZE, Text};

/// The length of an axis, the distance of its name from the origin, and the half-width of the
/// square that holds all, in page units.
const LENGTH: f64 = 26.0;
const NAME: f64 = 35.0;
const HALF: f64 = 42.0;

/// How far outside the corner of what is drawn the axes may be, in page units, if need be.
const OUTSIDE: [f64; 3] = [0.0, 20.0, 40.0];

/// An axis that shows less than this share of its length has no name beside it.
const NAMED: f64 = 0.12;

/// Draws the axes in a free corner.
pub(crate) fn draw(drawing: &mut Drawing) {
    let origin = place(drawing);
    let at =
        |way: [f64; 2], length: f64| [origin[0] + way[0] * length, origin[1] - way[1] * length];
    let names = [("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0]), ("z", [0.0, 0.0, 1.0])];
    let mut axes = names.map(|(name, along)| (name, drawing.scene.direction(along)));
    // Those that lead away from the viewer first.
    axes.sort_by(|a, b| a.1[2].total_cmp(&b.1[2]));
    for (name, along) in axes {
        let way = flat(along);
        let ends = [0.0, LENGTH].map(|length| drawing.figure.to_world(at(way, length)));
        drawing.figure.arrow(ends[0], ends[1], Stroke::solid(Color::GREY, 1.3));
        let shown = way[0].hypot(way[1]);
        let beside = if shown > NAMED {
            let gap = LENGTH + (NAME - LENGTH) / shown;
            at(way, gap)
        } else {
            at([-0.7, -0.7], NAME - LENGTH)
        };
        let text = Text::new(name, SMALL_SIZE).colored(Color::GREY).with_halo();
        drawing.figure.caption(beside, &text);
    }
}

/// Where the origin stands on the page: in the first corner that is free.
fn place(drawing: &Drawing) -> [f64; 2] {
    let ink = drawing.figure.ink();
    for out in OUTSIDE {
        let (left, right) = (ink.min[0] + HALF - out, ink.max[0] - HALF + out);
        let (top, bottom) = (ink.min[1] + HALF - out, ink.max[1] - HALF + out);
        for corner in [[left, bottom], [right, bottom], [left, top], [right, top]] {
            if is_free(drawing, corner) {
                return corner;
            }
        }
    }
    [ink.min[0] - HALF, ink.max[1] + HALF]
}

/// Whether neither a line, a label nor the part is in the square about a place.
fn is_free(drawing: &Drawing, at: [f64; 2]) -> bool {
    let area = PageBox::centered(at, [2.0 * HALF; 2]);
    let ([left, top], [right, bottom]) = (area.min, area.max);
    let ring = [[left, bottom], [right, bottom], [right, top], [left, top]]
        .map(|corner| drawing.figure.to_world(corner));
    let on_part = || {
        let mut triangles = drawing.scene.faces.iter().flat_map(|face| &face.triangles);
        triangles.any(|triangle| !shared(&ring, &triangle.map(flat)).is_empty())
    };
    drawing.labels.is_free(&area) && !on_part()
}
