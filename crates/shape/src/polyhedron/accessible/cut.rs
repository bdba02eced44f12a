//! Regions of a plane: cut, and covered with triangles.

use clench_screw::Vector;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use i_overlay::i_shape::base::data::{Contour, Shapes};
use i_triangle::float::triangulatable::Triangulatable;

use super::PLANE_ROUNDING;
use super::cover::Cover;
use super::obstacle::Obstacle;

/// So many covers are taken off at a time: few, since those that come later are more often beside
/// what is left, and not one by one, since each time costs.
const BATCH: usize = 8;

/// What is left of a facet.
#[derive(Debug)]
pub(super) struct Rest {
    area: Area,
    /// What covers it; before anything is taken off, the facet's own triangles.
    triangles: Vec<[Vector<2>; 3]>,
    /// To be taken off.
    pending: Vec<Cover>,
    /// Taken off.
    removed: Vec<Cover>,
    is_whole: bool,
}

impl Rest {
    /// All of a facet.
    pub(super) fn new(area: Area, triangles: Vec<[Vector<2>; 3]>) -> Self {
        Self { area, triangles, pending: Vec::new(), removed: Vec::new(), is_whole: true }
    }

    /// Keeps what is in one of `covers`.
    pub(super) fn keep_within(&mut self, covers: &[Cover]) {
        self.set(|area| area.overlaid(covers, OverlayRule::Intersect));
    }

    /// Takes an obstacle off, seen in a window; whether anything may be left.
    pub(super) fn remove(
        &mut self,
        obstacle: &Obstacle,
        window: Vector<2>,
        tolerance: f64,
    ) -> bool {
        if obstacle.is_beside(self.triangles.as_flattened()) {
            return true;
        }
        let Some(cover) = Cover::of(obstacle, window, tolerance, PLANE_ROUNDING) else {
            return true;
        };
        if cover.is_window() {
            return false;
        }
        if self.triangles.iter().any(|triangle| cover.overlaps(triangle, PLANE_ROUNDING)) {
            self.pending.push(cover);
        }
        self.pending.len() < BATCH || self.settled()
    }

    /// Whether anything is left.
    pub(super) fn settled(&mut self) -> bool {
        if !self.pending.is_empty() {
            let pending = std::mem::take(&mut self.pending);
            self.set(|area| area.overlaid(&pending, OverlayRule::Difference));
            self.removed.extend(pending);
        }
        !self.triangles.is_empty()
    }

    /// Triangles that cover what is left exactly once; `None` if nothing was taken off.
    ///
    /// Whatever the library did: nothing that was taken off is in them.
    pub(super) fn triangles(self) -> Option<Vec<[Vector<2>; 3]>> {
        let Self { mut triangles, removed, is_whole, .. } = self;
        for cover in removed {
            let off = |triangle: [Vector<2>; 3]| {
                if cover.overlaps(&triangle, PLANE_ROUNDING) {
                    cover.outside(&triangle)
                } else {
                    vec![triangle]
                }
            };
            triangles = triangles.into_iter().flat_map(off).collect();
        }
        triangles.retain(|triangle| width(triangle) > PLANE_ROUNDING);
        (!is_whole).then_some(triangles)
    }

    fn set(&mut self, change: impl FnOnce(&Area) -> Area) {
        self.area = change(&self.area);
        self.triangles = self.area.triangles();
        self.is_whole = false;
    }
}

/// A region of a plane: the points around which its contours run, more often one way than the
/// other.
#[derive(Clone, Debug)]
pub(super) struct Area {
    shapes: Shapes<[f64; 2]>,
}

impl Area {
    /// Inside of an outer contour, counter-clockwise, and outside of holes, clockwise.
    pub(super) fn new(contours: impl Iterator<Item = Vec<Vector<2>>>) -> Self {
        let plain = |contour: Vec<Vector<2>>| contour.into_iter().map(Vector::to_array).collect();
        Self { shapes: vec![contours.map(plain).collect()] }
    }

    /// The grid that the library rounds to has 60 bits: finer than doubles are.
    fn overlaid(&self, covers: &[Cover], rule: OverlayRule) -> Self {
        if self.shapes.is_empty() || covers.is_empty() {
            return Self { shapes: Shapes::new() };
        }
        let plain = |cover: &Cover| cover.corners().map(Vector::to_array).collect();
        let clip: Vec<Contour<[f64; 2]>> = covers.iter().map(plain).collect();
        let shapes = self.shapes.overlay_as::<i64>(&clip, rule, FillRule::NonZero);
        Self { shapes }
    }

    /// Triangles that cover it exactly once, counter-clockwise, but for what is no wider than
    /// rounding.
    fn triangles(&self) -> Vec<[Vector<2>; 3]> {
        if self.shapes.is_empty() {
            return Vec::new();
        }
        let raw = self.shapes.triangulate_as::<i64>().into_delaunay();
        let (points, corners) = (raw.points(), raw.triangle_indices::<u32>());
        let point = |&corner: &u32| Vector::new(points[corner as usize]);
        let triangles = corners.chunks_exact(3).map(|three| [0, 1, 2].map(|i| point(&three[i])));
        triangles.filter(|triangle| width(triangle) > PLANE_ROUNDING).collect()
    }
}

/// Twice the area, positive if the corners run counter-clockwise.
pub(super) fn doubled_area([a, b, c]: &[Vector<2>; 3]) -> f64 {
    let (p, q) = (*b - *a, *c - *a);
    p[0] * q[1] - p[1] * q[0]
}

/// The height of a triangle over its longest side.
fn width(triangle: &[Vector<2>; 3]) -> f64 {
    let [a, b, c] = *triangle;
    let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
    doubled_area(triangle) / longest
}
