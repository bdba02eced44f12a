//! Where labels go so that they cover neither lines nor one another.

use crate::figure::Figure;
use crate::page_box::PageBox;
use crate::text::Text;

/// Room kept free beside a label, in page units.
const PADDING: f64 = 4.0;

/// Turns away from the wanted direction that are tried, in degrees.
const TURNS: [f64; 15] = [
    0.0, 20.0, -20.0, 40.0, -40.0, 60.0, -60.0, 85.0, -85.0, 110.0, -110.0, 140.0, -140.0, 165.0,
    180.0,
];

/// Steps away from the point that are tried, in page units.
const STEPS: [f64; 5] = [0.0, 5.0, 11.0, 18.0, 28.0];

/// What a line under a label costs, against a turn of 20 degrees costing 1.
const SOFT: f64 = 4.0;
const HARD: f64 = 12.0;

/// How bad it is to cover something.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Weight {
    /// A thin auxiliary line; a halo keeps the label legible.
    Soft,
    /// An outline.
    Hard,
}

/// Where a label is wanted.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spot {
    /// The world point that it names.
    pub(crate) at: [f64; 2],
    /// The unit direction from there, y down.
    pub(crate) toward: [f64; 2],
    /// The gap between the point and the label's edge, in page units.
    pub(crate) gap: f64,
}

/// The obstacles so far, in page units.
#[derive(Debug, Default)]
pub(crate) struct Labels {
    boxes: Vec<PageBox>,
    lines: Vec<([f64; 2], [f64; 2], Weight)>,
}

impl Labels {
    pub(crate) fn avoid_box(&mut self, area: PageBox) {
        self.boxes.push(area);
    }

    pub(crate) fn avoid_line(&mut self, from: [f64; 2], to: [f64; 2], weight: Weight) {
        self.lines.push((from, to, weight));
    }

    pub(crate) fn avoid_ring(&mut self, ring: &[[f64; 2]], weight: Weight) {
        for (i, &from) in ring.iter().enumerate() {
            self.avoid_line(from, ring[(i + 1) % ring.len()], weight);
        }
    }

    /// Whether a box touches no obstacle.
    pub(crate) fn is_free(&self, area: &PageBox) -> bool {
        self.cost(area) <= 0.0
    }

    /// Writes a label as near as can be to where it is wanted; it becomes an obstacle.
    pub(crate) fn write(&mut self, figure: &mut Figure, text: &Text, spot: Spot) {
        self.write_at_best(figure, text, &[spot]);
    }

    /// Writes a label at the first of several spots where it covers least.
    pub(crate) fn write_at_best(&mut self, figure: &mut Figure, text: &Text, spots: &[Spot]) {
        let [width, height] = text.page_size();
        let size = [width + PADDING, height];
        let mut best = (f64::INFINITY, [0.0; 2]);
        for &spot in spots {
            let (cost, center) = self.place(size, figure.to_page(spot.at), spot);
            if cost < best.0 {
                best = (cost, center);
            }
        }
        self.boxes.push(PageBox::centered(best.1, size));
        figure.caption(best.1, text);
    }

    /// What it costs to write a label of this size at a page position, and its center there.
    fn place(&self, size: [f64; 2], at: [f64; 2], spot: Spot) -> (f64, [f64; 2]) {
        let Spot { toward, gap, .. } = spot;
        let mut best = (f64::INFINITY, at);
        for turn in TURNS {
            let (sin, cos) = turn.to_radians().sin_cos();
            let way = [cos * toward[0] - sin * toward[1], sin * toward[0] + cos * toward[1]];
            for step in STEPS {
                // The label's edge, not its center, keeps the gap.
                let clear = gap + step + rim(size, way);
                let center = [at[0] + clear * way[0], at[1] + clear * way[1]];
                let cost =
                    turn.abs() / 20.0 + step / 5.0 + self.cost(&PageBox::centered(center, size));
                if cost < best.0 {
                    best = (cost, center);
                }
            }
        }
        best
    }

    fn cost(&self, label: &PageBox) -> f64 {
        let area = label.size()[0] * label.size()[1];
        let boxes: f64 = self.boxes.iter().map(|other| label.overlap(other)).sum();
        let lines: f64 = self
            .lines
            .iter()
            .filter(|(from, to, _)| label.inside_length(*from, *to) > 0.0)
            .map(|(.., weight)| if *weight == Weight::Hard { HARD } else { SOFT })
            .sum();
        let covers = if boxes > 0.0 { 2.0 * HARD * (1.0 + boxes / area) } else { 0.0 };
        covers + lines
    }
}

/// The distance from a box's center to its rim in a direction.
fn rim(size: [f64; 2], way: [f64; 2]) -> f64 {
    let across = |i: usize| {
        if way[i] == 0.0 { f64::INFINITY } else { size[i] / 2.0 / way[i].abs() }
    };
    across(0).min(across(1))
}
