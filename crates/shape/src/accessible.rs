//! Where on an outline a round finger tip can touch.

use clench_screw::{Vector, planar};
use parry2d_f64::bounding_volume::Aabb;
use parry2d_f64::math::Vector as ParryVector;
use parry2d_f64::partitioning::{Bvh, BvhBuildStrategy};

use crate::predicates::{turn, unit_scale};
use crate::validity::surround;
use crate::{AccessError, DiscTip, Edge, Plate, Polygon};

/// A finger may overlap what it stays off by this many roundings of the lengths involved: a finger
/// in a groove of its own width touches both sides.
const TOUCHING: f64 = 64.0 * f64::EPSILON;

/// Discs of this radius, in units of the largest coordinate, stand for larger ones, from which they
/// differ by half the inverse: less than what the rounding of their own centers hides.
const STRAIGHTEST: f64 = 1e7;

/// Holes are counted from that at the offset; above this numbers are no longer exact.
const LARGEST_INDEX: f64 = 1e15;

/// The largest number of holes of a plate that are looked at beside one edge.
pub const MOST_HOLES_AT_EDGE: f64 = 1e6;

impl Polygon {
    /// For each edge the stretches that the disc of `tip` can touch from outside, which may be
    /// within a hole: where they begin and end, from the start of the edge (length), ascending.
    ///
    /// Each is what straight edges and round corners leave of the line of centers, to rounding.
    /// Cost: O(n log n) for `n` edges, unless a finger meets many of them.
    ///
    /// # Errors
    ///
    /// [`AccessError::TooManyHolesAtEdge`], [`AccessError::PlateTooFar`].
    ///
    /// ```
    /// use clench_shape::{DiscTip, Polygon};
    /// // In the corner of an L a disc stays its radius away from the other side.
    /// let corner = [[0.0, 0.0], [6.0, 0.0], [6.0, 2.0], [2.0, 2.0], [2.0, 6.0], [0.0, 6.0]];
    /// let stretches = Polygon::new(&corner)?.accessible(&DiscTip::new(1.0)?)?;
    /// assert_eq!(stretches[0], [[0.0, 6.0]]);
    /// let [[from, to]] = stretches[2][..] else { panic!() };
    /// assert!(from == 0.0 && (to - 3.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn accessible(&self, tip: &DiscTip) -> Result<Vec<Vec<[f64; 2]>>, AccessError> {
        let walls = Walls::of(self);
        let radius = self.radius_beside(tip);
        let edges = self.edges().iter().enumerate();
        edges
            .map(|(number, edge)| {
                let line = Line { edge, radius };
                let mut left = vec![[0.0, edge.length()]];
                if tip.radius() > 0.0 {
                    let taken = walls.near(&line).filter(|&wall| !walls.beside(wall, number));
                    left = without(left, taken.filter_map(|wall| line.meets(walls.ends(wall))));
                }
                for region in tip.keep_out() {
                    left = line.outside(region, left);
                }
                match tip.plate() {
                    Some(plate) => line.over(plate, number, &left),
                    None => Ok(left),
                }
            })
            .collect()
    }

    /// The radius of a tip, or of a smaller one that is as straight beside the part.
    fn radius_beside(&self, tip: &DiscTip) -> f64 {
        let corners = tip.keep_out().iter().flat_map(Self::corners).chain(self.corners());
        let size = corners.fold(0.0_f64, |size, corner| size.max(corner.max_abs()));
        // Over a plate it matters where the center is.
        if tip.plate().is_some() { tip.radius() } else { tip.radius().min(STRAIGHTEST * size) }
    }
}

/// The centers of a finger that touches an edge, from its start on.
#[derive(Clone, Copy, Debug)]
struct Line<'a> {
    edge: &'a Edge,
    radius: f64,
}

impl Line<'_> {
    /// The center of a finger at the start of the edge.
    fn start(&self) -> Vector<2> {
        self.edge.start() - self.edge.inward_normal() * self.radius
    }

    fn at(&self, along: f64) -> Vector<2> {
        self.edge.point_at(along) - self.edge.inward_normal() * self.radius
    }

    /// The parts of `left` on which the center is over a hole of `plate`.
    fn over(
        &self,
        plate: &Plate,
        number: usize,
        left: &[[f64; 2]],
    ) -> Result<Vec<[f64; 2]>, AccessError> {
        let reached = self.holes(plate, number)?.into_iter().filter_map(|hole| {
            let size = hole.max_abs() + self.start().max_abs() + plate.travel();
            self.within(hole, plate.travel() + TOUCHING * size)
        });
        let reached = joined(reached.collect());
        let meet = |[a, b]: [f64; 2]| {
            let cut = reached.iter().map(move |&[c, d]| [a.max(c), b.min(d)]);
            cut.filter(|[from, to]| from < to)
        };
        Ok(left.iter().flat_map(|&stretch| meet(stretch)).collect())
    }

    /// The holes within the travel of the line, and some more.
    fn holes(&self, plate: &Plate, number: usize) -> Result<Vec<Vector<2>>, AccessError> {
        let (a, b) = (self.start(), self.start() + self.edge.direction() * self.edge.length());
        let (pitch, offset, travel) = (plate.pitch(), plate.offset(), plate.travel());
        // Along the axis that the line runs along more, column by column.
        let run = b - a;
        let (x, y) = if run[0].abs() >= run[1].abs() { (0, 1) } else { (1, 0) };
        let range = |low: f64, high: f64, axis: usize| {
            let index = |value: f64| (value - offset[axis]) / pitch[axis];
            (index(low - travel).floor(), index(high + travel).ceil())
        };
        let index = |end: Vector<2>, i: usize| ((end[i] - offset[i]) / pitch[i]).abs();
        let farthest = [a, b].into_iter().flat_map(|end| [index(end, 0), index(end, 1)]);
        let farthest = farthest.fold(0.0, f64::max) + travel / pitch[0].min(pitch[1]);
        if farthest >= LARGEST_INDEX {
            return Err(AccessError::PlateTooFar { edge: number, pitches: farthest });
        }
        let (first, last) = range(a[x].min(b[x]), a[x].max(b[x]), x);
        let slope = run[y] / run[x];
        let rows = 2.0 * (travel * (1.0 + slope.abs()) / pitch[y]) + 3.0;
        let found = (last - first + 1.0) * rows;
        if found.is_nan() || found > MOST_HOLES_AT_EDGE {
            let most = MOST_HOLES_AT_EDGE;
            return Err(AccessError::TooManyHolesAtEdge { edge: number, found, most });
        }
        let mut holes = Vec::new();
        let mut column = first;
        while column <= last {
            let at = offset[x] + column * pitch[x];
            let [near, far] = [at - travel, at + travel].map(|at| a[y] + (at - a[x]) * slope);
            let (mut row, end) = range(near.min(far), near.max(far), y);
            while row <= end {
                let other = offset[y] + row * pitch[y];
                holes.push(Vector::new(if x == 0 { [at, other] } else { [other, at] }));
                row += 1.0;
            }
            column += 1.0;
        }
        Ok(holes)
    }

    /// Where the center is within `distance` of `point`.
    fn within(&self, point: Vector<2>, distance: f64) -> Option<[f64; 2]> {
        let chord = planar::chord(point - self.start(), self.edge.direction(), distance);
        chord.filter(|[from, to]| from < to)
    }

    /// Where the finger overlaps a straight wall by more than rounding: one interval, since the
    /// distance from it is convex.
    fn meets(&self, wall: [Vector<2>; 2]) -> Option<[f64; 2]> {
        let distance = self.radius - TOUCHING * (self.radius + size(wall));
        if distance <= 0.0 {
            return None;
        }
        let ends = wall.into_iter().filter_map(|end| self.within(end, distance));
        ends.chain(self.meets_side(wall, distance)).reduce(|[a, b], [c, d]| [a.min(c), b.max(d)])
    }

    /// Where the center is within `distance` of the wall's line, between its ends.
    fn meets_side(&self, [start, end]: [Vector<2>; 2], distance: f64) -> Option<[f64; 2]> {
        let (from, run) = (self.start() - start, end - start);
        let (length, direction) = (run.norm(), self.edge.direction());
        // Both grow linearly along the edge.
        let across = (planar::cross(run, from), planar::cross(run, direction));
        let along = (run.dot(from), run.dot(direction));
        let strip = between(across, -distance * length, distance * length)?;
        let slab = between(along, 0.0, length * length)?;
        let both = [strip[0].max(slab[0]), strip[1].min(slab[1])];
        (both[0] < both[1]).then_some(both)
    }

    /// The parts of `left` where the finger does not overlap `region` by more than rounding.
    fn outside(&self, region: &Polygon, left: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
        let walls = || region.edges().iter().map(|edge| [edge.start(), edge.end()]);
        let left = without(left, walls().filter_map(|wall| self.meets(wall)));
        // The center of a finger that is a point, or hardly more, gets in and out at the edges.
        let left = without(left, walls().filter_map(|wall| self.crosses(wall)).map(|at| [at; 2]));
        // It comes from outside of the part, whatever its size: a little there is clear of edges
        // that the region shares with the part.
        let size = walls().map(size).fold(self.start().max_abs(), f64::max);
        let outward = self.edge.inward_normal() * (-2.0 * TOUCHING * size);
        let enclosed =
            |&[from, to]: &[f64; 2]| surround(walls(), self.at(0.5 * (from + to)) + outward);
        joined(left.into_iter().filter(|stretch| !enclosed(stretch)).collect())
    }

    /// Where the line of centers crosses a wall, or nearly so.
    fn crosses(&self, [start, end]: [Vector<2>; 2]) -> Option<f64> {
        let (run, from) = (end - start, self.start() - start);
        let slope = planar::cross(run, self.edge.direction());
        let at = -planar::cross(run, from) / slope;
        let along = run.dot(from + self.edge.direction() * at) / run.norm();
        let slack = TOUCHING * (size([start, end]) + self.start().max_abs());
        (-slack <= along && along <= run.norm() + slack).then_some(at)
    }
}

/// The largest coordinate of a wall.
fn size(wall: [Vector<2>; 2]) -> f64 {
    wall.iter().map(|end| end.max_abs()).fold(0.0, f64::max)
}

/// Where `value + slope t` is between `low` and `high`; all `t` count where it is constant.
fn between((value, slope): (f64, f64), low: f64, high: f64) -> Option<[f64; 2]> {
    if slope == 0.0 {
        return (low < value && value < high).then_some([f64::NEG_INFINITY, f64::INFINITY]);
    }
    let [a, b] = [(low - value) / slope, (high - value) / slope];
    Some([a.min(b), a.max(b)])
}

/// What `taken` leaves of `left`, which ascends.
fn without(left: Vec<[f64; 2]>, taken: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    taken.fold(left, |left, [from, to]| {
        let pieces = left.into_iter().flat_map(|[a, b]| [[a, b.min(from)], [a.max(to), b]]);
        pieces.filter(|[a, b]| a < b).collect()
    })
}

/// The union of intervals, ascending.
fn joined(mut intervals: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    intervals.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut union: Vec<[f64; 2]> = Vec::new();
    for [from, to] in intervals {
        match union.last_mut() {
            Some(last) if from <= last[1] => last[1] = last[1].max(to),
            _ => union.push([from, to]),
        }
    }
    union
}

/// The edges of a part as what fingers stay off.
struct Walls<'a> {
    outline: &'a Polygon,
    tree: Bvh,
    /// What brings lengths to about 1 in the tree.
    scale: f64,
}

impl<'a> Walls<'a> {
    fn of(outline: &'a Polygon) -> Self {
        let corners = outline.corners().iter();
        let scale = unit_scale(corners.fold(0.0_f64, |m, corner| m.max(corner.max_abs())));
        let boxes: Vec<Aabb> = outline
            .edges()
            .iter()
            .map(|edge| around([edge.start(), edge.end()], 0.0, scale))
            .collect();
        Self { outline, tree: Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes), scale }
    }

    fn ends(&self, wall: usize) -> [Vector<2>; 2] {
        let edge = &self.outline.edges()[wall];
        [edge.start(), edge.end()]
    }

    /// The walls whose boxes a finger on `line` may meet.
    fn near(&self, line: &Line<'_>) -> impl Iterator<Item = usize> {
        let ends = [0.0, line.edge.length()].map(|along| line.at(along));
        let around = around(ends, line.radius, self.scale);
        let mut near: Vec<usize> =
            self.tree.intersect_aabb(&around).map(|leaf| leaf as usize).collect();
        near.sort_unstable();
        near.into_iter()
    }

    /// Whether a wall is the edge `number` itself, or next to it and not in the way of a finger on
    /// it: at a corner where the part does not turn towards the finger.
    fn beside(&self, wall: usize, number: usize) -> bool {
        let edges = self.outline.edges();
        if wall == number {
            return true;
        }
        let (edge, other) = (&edges[number], &edges[wall]);
        let far = if other.start() == edge.end() {
            other.end()
        } else if other.end() == edge.start() {
            other.start()
        } else {
            return false;
        };
        let left = planar::cross(edge.direction(), edge.inward_normal()) > 0.0;
        let side = turn(edge.start(), edge.end(), far);
        if left { side >= 0.0 } else { side <= 0.0 }
    }
}

/// The box around two points and all that is as near to them as `distance`.
fn around([a, b]: [Vector<2>; 2], distance: f64, scale: f64) -> Aabb {
    let point = |v: Vector<2>| ParryVector::from_array((v * scale).to_array());
    let far = ParryVector::splat(distance * scale);
    Aabb::new(point(a).min(point(b)) - far, point(a).max(point(b)) + far)
}
