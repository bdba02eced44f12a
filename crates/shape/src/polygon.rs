//! The outline of a planar part, and its holes.

use std::ops::Range;

use clench_screw::Vector;

use crate::circle::smallest_center;
use crate::hull::compare;
use crate::loops::Loops;
use crate::place::nearest_place;
use crate::predicates::turn;
use crate::triangulation::Triangulation;
use crate::validity::checked_hull;
use crate::{Circle, Edge, ExtremePoints, FarthestPartition, Place, PolygonError, Reach, Stretch};

/// The direction in which an outline lists its corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Winding {
    /// The part is on the left of each edge.
    CounterClockwise,
    /// The part is on the right of each edge.
    Clockwise,
}

/// A part's outline: a closed chain of straight edges that meets itself nowhere, and such chains
/// within it, the outlines of holes.
///
/// Corners and edges keep the order and the numbers they were given in, from 0, those of the holes
/// after those of the outer loop: edge `e` joins corner `e` to corner `e + 1`, the last one of a
/// loop closes it. Either winding is fine, and corners within a straight side are too.
///
/// ```
/// use clench_shape::{Polygon, Winding};
/// let part = Polygon::new(&[[0.0, 0.0], [0.0, 3.0], [4.0, 0.0]])?;
/// assert_eq!(part.winding(), Winding::Clockwise);
/// assert_eq!(part.edges()[1].length(), 5.0);
/// assert_eq!(part.enclosing_circle().center.to_array(), [2.0, 1.5]);
/// # Ok::<(), clench_shape::PolygonError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    corners: Vec<Vector<2>>,
    loops: Loops,
    winding: Winding,
    edges: Vec<Edge>,
    hull: Vec<usize>,
    partition: FarthestPartition,
    circle: Circle,
    extremes: ExtremePoints<2>,
}

impl Polygon {
    /// The outline through `corners`, in this order, without holes.
    ///
    /// Whether it is valid is decided exactly, without a tolerance. Cost: O(n log n) for `n`
    /// corners, unless many edges have overlapping boxes.
    ///
    /// # Errors
    ///
    /// The first fault found, in the order of the variants of [`PolygonError`].
    pub fn new(corners: &[[f64; 2]]) -> Result<Self, PolygonError> {
        Self::with_holes(corners, &[])
    }

    /// The outline through `corners` with `holes` in it, each a list of corners in order.
    ///
    /// Validity as for [`Polygon::new`]; O(n) more per hole.
    ///
    /// # Errors
    ///
    /// The first fault found, in the order of the variants of [`PolygonError`].
    ///
    /// ```
    /// use clench_shape::Polygon;
    /// let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
    /// let frame = Polygon::with_holes(&square(0.0, 4.0), &[square(1.0, 3.0).to_vec()])?;
    /// assert_eq!(frame.area(), 12.0);
    /// // Edge 4 is the lower one of the hole: the material is below it.
    /// assert_eq!(frame.edges()[4].inward_normal().to_array(), [0.0, -1.0]);
    /// assert_eq!(frame.signed_distance([2.0, 2.0].into()), 1.0);
    /// # Ok::<(), clench_shape::PolygonError>(())
    /// ```
    pub fn with_holes(corners: &[[f64; 2]], holes: &[Vec<[f64; 2]>]) -> Result<Self, PolygonError> {
        let lengths = [corners.len()].into_iter().chain(holes.iter().map(Vec::len));
        let loops = Loops::of_lengths(lengths);
        let all = corners.iter().chain(holes.iter().flatten());
        let corners: Vec<Vector<2>> = all.map(|&c| c.into()).collect();
        let hull = checked_hull(&corners, &loops)?;
        let edges = edges(&corners, &loops);
        let winding = winding_of(&corners, &loops.runs()[0]);
        let sites: Vec<Vector<2>> = hull.iter().map(|&i| corners[i]).collect();
        let mesh = Triangulation::new(&sites);
        let center = smallest_center(&sites, &mesh);
        let partition = FarthestPartition::new(&hull, sites, &mesh);
        let circle = Circle { center, radius: partition.farthest(center).distance };
        let extremes = ExtremePoints::of_points(&corners, hull.clone());
        Ok(Self { corners, loops, winding, edges, hull, partition, circle, extremes })
    }

    /// The corners, in the order given: those of the outer loop, then those of each hole.
    #[must_use]
    pub fn corners(&self) -> &[Vector<2>] {
        &self.corners
    }

    /// The runs of corners, and of edges, that make up a loop each: the outer one first, then the
    /// holes.
    ///
    /// ```
    /// let holes = [vec![[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]]];
    /// let outer = [[0.0, 0.0], [5.0, 0.0], [5.0, 5.0], [0.0, 5.0]];
    /// let part = clench_shape::Polygon::with_holes(&outer, &holes)?;
    /// assert_eq!(part.loops(), [0..4, 4..7]);
    /// # Ok::<(), clench_shape::PolygonError>(())
    /// ```
    #[must_use]
    pub fn loops(&self) -> &[Range<usize>] {
        self.loops.runs()
    }

    /// The direction in which the corners of the outer loop were given.
    #[must_use]
    pub fn winding(&self) -> Winding {
        self.winding
    }

    /// The edges; edge `e` joins corner `e` to the next one of its loop.
    #[must_use]
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The numbers of the corners of the convex hull, counter-clockwise from the leftmost.
    ///
    /// Corners within a straight side of the hull are left out.
    #[must_use]
    pub fn hull(&self) -> &[usize] {
        &self.hull
    }

    /// The corners of the convex hull, for how far the part reaches.
    #[must_use]
    pub fn extreme_points(&self) -> &ExtremePoints<2> {
        &self.extremes
    }

    /// Whether there are no holes, and the outline turns the same way at all its corners, or
    /// straight on; exactly.
    #[must_use]
    pub fn is_convex(&self) -> bool {
        let at = |i: usize| self.corners[i];
        let (before, after) = (|i| self.loops.before(i), |i| self.loops.after(i));
        let mut turns = (0..self.corners.len()).map(|i| turn(at(before(i)), at(i), at(after(i))));
        let convex = match self.winding {
            Winding::CounterClockwise => turns.all(|turn| turn >= 0.0),
            Winding::Clockwise => turns.all(|turn| turn <= 0.0),
        };
        convex && self.loops().len() == 1
    }

    /// The smallest circle around the part: the geometric center `p_0` and the radius `r_0` of
    /// [LBR, section 5.2], which is the least value of `rho_max`.
    ///
    /// No corner is outside it: the radius is the distance of the farthest corner from the
    /// rounded center.
    #[must_use]
    pub fn enclosing_circle(&self) -> Circle {
        self.circle
    }

    /// The corner farthest from `point`, and its distance: `rho_max` of [LBR, section 5].
    ///
    /// The distance is that of the corner named, and within a few roundings of the largest one.
    /// Of corners equally far any may be named, always the same for the same bits. Cost: O(log h)
    /// for `h` corners of the hull.
    ///
    /// ```
    /// let square = clench_shape::Polygon::new(&[[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0]])?;
    /// let reach = square.farthest([-1.0, 0.0].into());
    /// assert_eq!((reach.corner, reach.distance), (2, 5.0));
    /// # Ok::<(), clench_shape::PolygonError>(())
    /// ```
    #[must_use]
    pub fn farthest(&self, point: Vector<2>) -> Reach {
        self.partition.farthest(point)
    }

    /// The segment from `start` to `end`, in pieces that have one farthest corner each.
    ///
    /// The pieces come in order and cover all of it, without gaps. A corner that is farthest at a
    /// single point only may be left out. Cost: O(h) per piece, no allocation.
    ///
    /// ```
    /// use clench_shape::{Polygon, Stretch};
    /// let square = Polygon::new(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?;
    /// // From left to right below the middle: first the right upper corner, then the left one.
    /// let (start, end) = ([0.0, 1.0].into(), [8.0, 1.0].into());
    /// let stretches: Vec<_> = square.farthest_along(start, end).collect();
    /// let expected = [
    ///     Stretch { corner: 2, from: 0.0, to: 0.25 },
    ///     Stretch { corner: 3, from: 0.25, to: 1.0 },
    /// ];
    /// assert_eq!(stretches, expected);
    /// # Ok::<(), clench_shape::PolygonError>(())
    /// ```
    pub fn farthest_along(
        &self,
        start: Vector<2>,
        end: Vector<2>,
    ) -> impl Iterator<Item = Stretch> {
        self.partition.farthest_along(start, end)
    }

    /// The regions of the plane with one farthest corner each: `R_i` of [LBR, section 5].
    #[must_use]
    pub fn partition(&self) -> &FarthestPartition {
        &self.partition
    }

    /// The place of the outline nearest to `point`.
    ///
    /// Of places equally near, the one on the edge with the lowest number. Cost: O(n).
    ///
    /// ```
    /// let part = clench_shape::Polygon::new(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]])?;
    /// let place = part.place([1.0, -0.5].into());
    /// assert_eq!((place.edge, place.along, place.distance), (0, 1.0, 0.5));
    /// assert_eq!(part.place([5.0, -1.0].into()).corner, Some(1));
    /// # Ok::<(), clench_shape::PolygonError>(())
    /// ```
    #[must_use]
    pub fn place(&self, point: Vector<2>) -> Place {
        nearest_place(&self.edges, &self.loops, point)
    }

    /// The distance of `point` from the outline (length), negative inside.
    ///
    /// ```
    /// let part = clench_shape::Polygon::new(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]])?;
    /// assert_eq!(part.signed_distance([1.0, 0.5].into()), -0.5);
    /// assert_eq!(part.signed_distance([7.0, -4.0].into()), 5.0);
    /// # Ok::<(), clench_shape::PolygonError>(())
    /// ```
    #[must_use]
    pub fn signed_distance(&self, point: Vector<2>) -> f64 {
        let place = self.place(point);
        let foot = self.edges[place.edge].point_at(place.along);
        let inside = self.inward_at(&place).dot(point - foot) > 0.0;
        if inside { -place.distance } else { place.distance }
    }

    /// A direction into the part from a place of the outline: at a corner a point that is nearest
    /// to it is inside exactly if it is on this side.
    pub(crate) fn inward_at(&self, place: &Place) -> Vector<2> {
        let inward = self.edges[place.edge].inward_normal();
        match place.corner {
            Some(corner) => {
                let before = self.loops.before(corner);
                inward + self.edges[before].inward_normal()
            }
            None => inward,
        }
    }

    /// The area of the part, without its holes (length squared).
    ///
    /// Summed about the geometric center, so that it does not suffer far away from the origin.
    #[must_use]
    pub fn area(&self) -> f64 {
        let doubled: f64 = self
            .edges
            .iter()
            .map(|e| -e.inward_normal().dot(e.start() - self.circle.center) * e.length())
            .sum();
        doubled * 0.5
    }
}

/// The edges of valid loops: the part is on the inner side of the first loop, and on the outer side
/// of the others.
fn edges(corners: &[Vector<2>], loops: &Loops) -> Vec<Edge> {
    let mut edges = Vec::with_capacity(corners.len());
    for (number, run) in loops.runs().iter().enumerate() {
        let winding = match (winding_of(corners, run), number) {
            (winding, 0) => winding,
            (Winding::CounterClockwise, _) => Winding::Clockwise,
            (Winding::Clockwise, _) => Winding::CounterClockwise,
        };
        edges.extend(run.clone().map(|e| Edge::new(corners[e], corners[loops.after(e)], winding)));
    }
    edges
}

/// The winding of a simple loop, from its turn at its leftmost corner, the lowest of those: it is a
/// corner of its hull, which is never straight.
fn winding_of(corners: &[Vector<2>], run: &Range<usize>) -> Winding {
    let least = run.clone().min_by(|&i, &j| compare(corners[i], corners[j]));
    let corner = least.unwrap_or(run.start);
    let before = if corner == run.start { run.end - 1 } else { corner - 1 };
    let after = if corner + 1 == run.end { run.start } else { corner + 1 };
    if turn(corners[before], corners[corner], corners[after]) > 0.0 {
        Winding::CounterClockwise
    } else {
        Winding::Clockwise
    }
}
