//! The outline of a planar part.

use clench_screw::Vector;

use crate::circle::smallest_center;
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

/// A part's outline: a closed chain of straight edges that meets itself nowhere.
///
/// Corners and edges keep the order and the numbers they were given in, from 0: edge `e` joins
/// corner `e` to corner `e + 1`, the last one closes the outline. Either winding is fine, and
/// corners within a straight side are too.
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
    winding: Winding,
    edges: Vec<Edge>,
    hull: Vec<usize>,
    partition: FarthestPartition,
    circle: Circle,
    extremes: ExtremePoints<2>,
}

impl Polygon {
    /// The outline through `corners`, in this order.
    ///
    /// Whether it is valid is decided exactly, without a tolerance. Cost: O(n log n) for `n`
    /// corners, unless many edges have overlapping boxes.
    ///
    /// # Errors
    ///
    /// The first fault found, in the order of the variants of [`PolygonError`].
    pub fn new(corners: &[[f64; 2]]) -> Result<Self, PolygonError> {
        let corners: Vec<Vector<2>> = corners.iter().map(|&c| c.into()).collect();
        let hull = checked_hull(&corners)?;
        let winding = winding_at(&corners, hull[0]);
        let edges = (0..corners.len())
            .map(|e| Edge::new(corners[e], corners[(e + 1) % corners.len()], winding))
            .collect();
        let sites: Vec<Vector<2>> = hull.iter().map(|&i| corners[i]).collect();
        let mesh = Triangulation::new(&sites);
        let center = smallest_center(&sites, &mesh);
        let partition = FarthestPartition::new(&hull, sites, &mesh);
        let circle = Circle { center, radius: partition.farthest(center).distance };
        let extremes = ExtremePoints::of_points(&corners, hull.clone());
        Ok(Self { corners, winding, edges, hull, partition, circle, extremes })
    }

    /// The corners, in the order given.
    #[must_use]
    pub fn corners(&self) -> &[Vector<2>] {
        &self.corners
    }

    /// The direction in which the corners were given.
    #[must_use]
    pub fn winding(&self) -> Winding {
        self.winding
    }

    /// The edges; edge `e` joins corner `e` to corner `e + 1`.
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

    /// Whether the outline turns the same way at all its corners, or straight on; exactly.
    #[must_use]
    pub fn is_convex(&self) -> bool {
        let (n, at) = (self.corners.len(), &self.corners);
        let mut turns = (0..n).map(|i| turn(at[i], at[(i + 1) % n], at[(i + 2) % n]));
        match self.winding {
            Winding::CounterClockwise => turns.all(|turn| turn >= 0.0),
            Winding::Clockwise => turns.all(|turn| turn <= 0.0),
        }
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
        nearest_place(&self.edges, point)
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
                let before = (corner + self.edges.len() - 1) % self.edges.len();
                inward + self.edges[before].inward_normal()
            }
            None => inward,
        }
    }

    /// The area enclosed by the outline (length squared).
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

/// The winding of a simple outline, from its turn at a corner of its hull, which is never straight.
fn winding_at(corners: &[Vector<2>], corner: usize) -> Winding {
    let n = corners.len();
    let (before, after) = (corners[(corner + n - 1) % n], corners[(corner + 1) % n]);
    if turn(before, corners[corner], after) > 0.0 {
        Winding::CounterClockwise
    } else {
        Winding::Clockwise
    }
}
