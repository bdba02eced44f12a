//! Which parts of a line are hidden behind triangles.

use clench_screw::Vector;
use clench_screw::spatial::cross;

use crate::solid::grid::{Grid, around};
use crate::solid::scene::{EDGE_ON, Scene, flat};
use crate::world_map::UNSEEN;

/// How far behind a triangle's plane something has to be to be hidden: what lies in a face that is
/// plane only to the accuracy of a mesh is not.
const BEHIND: f64 = UNSEEN / 8.0;

/// How far a triangle hides beyond its rim, so that nothing shows between neighbors: below what is
/// seen, above the rounding of coordinates of size 1.
const RIM: f64 = UNSEEN * UNSEEN;

/// A run of a line that is shorter than this on the picture counts as part of its neighbor.
const SHORTEST: f64 = 4.0 * UNSEEN;

/// How far off the surface a contact is looked for: a mesh of a hollow may be this much nearer to
/// the viewer than the point on the true surface.
const OFF_SURFACE: f64 = 3.0 * UNSEEN;

/// A triangle that hides what is behind it.
#[derive(Debug)]
struct Screen {
    corners: [Vector<3>; 3],
    /// Of unit length, towards the viewer.
    normal: Vector<3>,
}

impl Screen {
    /// None where the triangle is seen as a line.
    fn new([a, b, c]: [Vector<3>; 3]) -> Option<Self> {
        let normal = cross(b - a, c - a).direction()?;
        let turned = normal[2] < 0.0;
        let (corners, normal) =
            if turned { ([a, c, b], normal * -1.0) } else { ([a, b, c], normal) };
        (normal[2] > EDGE_ON).then_some(Self { corners, normal })
    }

    /// Between which shares of a segment it is hidden.
    fn hidden(&self, from: Vector<3>, to: Vector<3>) -> Option<[f64; 2]> {
        let mut span = [0.0, 1.0];
        let behind = |p: Vector<3>| self.normal.dot(self.corners[0] - p) - BEHIND;
        cut(&mut span, behind(from), behind(to));
        for i in 0..3 {
            let (a, b) = (self.corners[i], self.corners[(i + 1) % 3]);
            let (x, y) = (b[0] - a[0], b[1] - a[1]);
            let rim = RIM * x.hypot(y);
            let inside = |p: Vector<3>| x * (p[1] - a[1]) - y * (p[0] - a[0]) + rim;
            cut(&mut span, inside(from), inside(to));
        }
        (span[0] < span[1]).then_some(span)
    }
}

/// Keeps of a span where a number that changes evenly from 0 to 1 is positive.
fn cut(span: &mut [f64; 2], at_0: f64, at_1: f64) {
    if at_0 <= 0.0 && at_1 <= 0.0 {
        *span = [1.0, 0.0];
    } else if at_0 < 0.0 {
        span[0] = span[0].max(at_0 / (at_0 - at_1));
    } else if at_1 < 0.0 {
        span[1] = span[1].min(at_0 / (at_0 - at_1));
    }
}

/// A piece of a line that is seen, or hidden, throughout.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Run {
    pub(crate) points: Vec<Vector<3>>,
    pub(crate) seen: bool,
}

/// Everything that hides.
#[derive(Debug)]
pub(crate) struct Screens {
    screens: Vec<Screen>,
    grid: Grid,
}

impl Screens {
    /// The faces that are turned towards the viewer: where another hides, so does one of these.
    pub(crate) fn of_part(scene: &Scene) -> Self {
        let front = scene.faces.iter().filter(|face| face.is_front());
        Self::new(front.flat_map(|face| face.triangles.iter().copied()))
    }

    pub(crate) fn new(triangles: impl Iterator<Item = [Vector<3>; 3]>) -> Self {
        let screens: Vec<_> = triangles.filter_map(Screen::new).collect();
        let rectangles: Vec<_> = screens.iter().map(|screen| around(&screen.corners)).collect();
        Self { screens, grid: Grid::new(&rectangles) }
    }

    /// Whether a point is hidden.
    pub(crate) fn hide(&self, point: Vector<3>) -> bool {
        let near = self.grid.near(&around(&[point]));
        near.into_iter().any(|i| self.screens[i].hidden(point, point).is_some())
    }

    /// A line through points, cut where it begins or ceases to be hidden; a closed one, which
    /// ends where it begins, only there.
    pub(crate) fn runs(&self, line: &[Vector<3>]) -> Vec<Run> {
        let mut runs = Vec::new();
        for ends in line.windows(2) {
            let mut at = 0.0;
            for [from, to] in self.hidden(ends[0], ends[1]) {
                add(&mut runs, ends, [at, from], true);
                add(&mut runs, ends, [from, to], false);
                at = to;
            }
            add(&mut runs, ends, [at, 1.0], true);
        }
        let mut runs = without_short(runs);
        if line.len() > 2 && line.first() == line.last() {
            join_ends(&mut runs);
        }
        runs
    }

    /// The spans of a segment that are hidden, ascending and apart.
    fn hidden(&self, from: Vector<3>, to: Vector<3>) -> Vec<[f64; 2]> {
        let near = self.grid.near(&around(&[from, to]));
        let mut spans: Vec<_> =
            near.into_iter().filter_map(|i| self.screens[i].hidden(from, to)).collect();
        spans.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        let mut apart: Vec<[f64; 2]> = Vec::new();
        for span in spans {
            match apart.last_mut() {
                Some(last) if span[0] <= last[1] => last[1] = last[1].max(span[1]),
                _ => apart.push(span),
            }
        }
        apart
    }
}

/// Whether a contact is out of sight: it is seen where a place just off the surface is.
pub(crate) fn is_behind(screens: &Screens, tip: Vector<3>, inward: Vector<3>) -> bool {
    inward[2] > EDGE_ON || screens.hide(tip - inward * OFF_SURFACE)
}

/// Adds a span of a segment to the last run if that is as visible, else as a new one.
fn add(runs: &mut Vec<Run>, ends: &[Vector<3>], [from, to]: [f64; 2], seen: bool) {
    if from >= to {
        return;
    }
    let at = |share: f64| ends[0] * (1.0 - share) + ends[1] * share;
    match runs.last_mut() {
        Some(run) if run.seen == seen => run.points.push(at(to)),
        _ => runs.push(Run { points: vec![at(from), at(to)], seen }),
    }
}

/// The runs with those too short to be seen given to the one before, or after the first.
fn without_short(runs: Vec<Run>) -> Vec<Run> {
    let mut kept: Vec<Run> = Vec::new();
    for run in runs {
        let is_second = kept.len() == 1;
        match kept.last_mut() {
            None => kept.push(run),
            Some(last) => {
                let joins = last.seen == run.seen || run.is_short();
                if joins || (is_second && last.is_short()) {
                    last.seen = if joins { last.seen } else { run.seen };
                    last.points.extend_from_slice(&run.points[1..]);
                } else {
                    kept.push(run);
                }
            }
        }
    }
    kept
}

/// Makes the last run go on with the first, if they are as visible.
fn join_ends(runs: &mut Vec<Run>) {
    if runs.len() > 1 && runs.first().map(|run| run.seen) == runs.last().map(|run| run.seen) {
        let first = runs.remove(0);
        if let Some(last) = runs.last_mut() {
            last.points.extend_from_slice(&first.points[1..]);
        }
    }
}

impl Run {
    /// Its length in the picture.
    pub(crate) fn length(&self) -> f64 {
        let length = |ends: &[Vector<3>]| {
            let ([x, y], [u, v]) = (flat(ends[0]), flat(ends[1]));
            (u - x).hypot(v - y)
        };
        self.points.windows(2).map(length).sum()
    }

    fn is_short(&self) -> bool {
        self.length() < SHORTEST
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The square from -0.25 to 0.25 at a height, as two triangles.
    fn square(height: f64) -> [[Vector<3>; 3]; 2] {
        let at = |x: f64, y: f64| Vector::new([x / 4.0, y / 4.0, height]);
        let [a, b, c, d] = [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
        // The second one is the other way round.
        [[a, b, c], [a, d, c]]
    }

    fn shares(screens: &Screens, from: [f64; 3], to: [f64; 3]) -> Vec<(f64, bool)> {
        let runs = screens.runs(&[from.into(), to.into()]);
        let length = |run: &Run| (run.length() * 1000.0).round() / 1000.0;
        runs.iter().map(|run| (length(run), run.seen)).collect()
    }

    #[test]
    fn a_line_is_hidden_where_it_passes_behind() {
        let screens = Screens::new(square(0.0).into_iter());
        // Over the seam between the two triangles, which leaves no gap.
        let below = shares(&screens, [-0.4, 0.1, -0.2], [0.4, 0.1, -0.2]);
        assert_eq!(below, [(0.15, true), (0.5, false), (0.15, true)]);
        assert_eq!(shares(&screens, [-0.4, 0.1, 0.2], [0.4, 0.1, 0.2]), [(0.8, true)]);
        // It dives through the square in the middle, up to what is not seen.
        let through = shares(&screens, [-0.4, 0.0, 0.8], [0.4, 0.0, -0.8]);
        assert_eq!(through, [(0.4, true), (0.25, false), (0.15, true)]);
    }

    #[test]
    fn the_seam_and_the_rim_of_what_hides_are_closed() {
        let screens = Screens::new(square(0.0).into_iter());
        let along =
            |a: [f64; 2], b: [f64; 2]| shares(&screens, [a[0], a[1], -0.1], [b[0], b[1], -0.1]);
        assert_eq!(along([-0.2, -0.2], [0.2, 0.2]), [(0.566, false)]);
        assert_eq!(along([-0.25, -0.25], [0.25, -0.25]), [(0.5, false)]);
    }

    #[test]
    fn what_lies_in_a_face_is_seen() {
        let screens = Screens::new(square(0.0).into_iter());
        assert_eq!(shares(&screens, [-0.2, 0.1, 0.0], [0.2, 0.1, 0.0]), [(0.4, true)]);
        assert!(!screens.hide(Vector::ZERO));
        assert!(screens.hide([0.0, 0.0, -0.1].into()));
    }

    #[test]
    fn a_run_too_short_to_see_is_none() {
        let screens = Screens::new(square(0.0).into_iter());
        let ends = [[0.2, 0.0, -0.1], [0.252, 0.0, -0.1]];
        assert_eq!(shares(&screens, ends[0], ends[1]), [(0.052, false)]);
        assert_eq!(shares(&screens, ends[1], ends[0]), [(0.052, false)]);
    }
}
