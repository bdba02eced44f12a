//! The border between two regions of one farthest corner.

use clench_screw::{Vector, planar};

use crate::Circle;
use crate::triangulation::{Triangle, doubled_area};

/// A border of the farthest-corner partition: its points are equally far from two corners, and
/// no corner is farther.
///
/// It is a part of the two corners' bisector, a segment or a ray. Where three corners are nearly
/// on one line its ends can be very far away; measured from `middle`, it is still known precisely
/// where it passes the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Border {
    /// The two corners that are farthest from each point. The region of the first is on the left
    /// of `direction`, that of the second on the right.
    pub corners: (usize, usize),
    /// The middle between the two corners, on the same line but perhaps not on the border.
    pub middle: Vector<2>,
    /// The unit vector along it; it goes from the start to infinity in the case of a ray.
    pub direction: Vector<2>,
    /// The start, as a distance from `middle` in the sense of `direction` (length).
    pub from: f64,
    /// The end, in the same way; infinite for a ray.
    pub to: f64,
}

/// A border stands for a single point when its ends differ by less than this many roundings of
/// their distance from the corners: each end is a quotient of two products of differences, the
/// divisor with three more, and the distance itself.
const POINT_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Stands for an end that no double can name; coordinates of parts stop at 1e130.
const BEYOND_REACH: f64 = 1e300;

impl Border {
    /// The point at the signed distance `offset` from `middle`.
    #[must_use]
    pub fn point_at(&self, offset: f64) -> Vector<2> {
        self.middle + self.direction * offset
    }

    /// The two ends of the part within `circle`; none where the border passes it by.
    ///
    /// Both are precise to a few roundings of the circle's and the part's size, wherever the
    /// border itself begins.
    ///
    /// ```
    /// use clench_shape::Polygon;
    /// let part = Polygon::new(&[[-3.0, 0.0], [3.0, 0.0], [0.0, 1.0]])?;
    /// let circle = part.enclosing_circle();
    /// let base = part.partition().borders().iter().find(|b| b.corners == (1, 0)).unwrap();
    /// // The bisector of the two far corners, inside the circle of radius 3: all of it.
    /// let [low, high] = base.within(circle).unwrap();
    /// assert_eq!((low.to_array(), high.to_array()), ([0.0, -3.0], [0.0, 3.0]));
    /// # Ok::<(), clench_shape::PolygonError>(())
    /// ```
    #[must_use]
    pub fn within(&self, circle: Circle) -> Option<[Vector<2>; 2]> {
        let to_center = circle.center - self.middle;
        let beside = planar::cross(self.direction, to_center);
        let half = ((circle.radius - beside) * (circle.radius + beside)).sqrt();
        let along = to_center.dot(self.direction);
        let (from, to) = (self.from.max(along - half), self.to.min(along + half));
        // The half chord of a line outside is not a number, which no offset exceeds.
        (half >= 0.0 && from < to).then(|| [self.point_at(from), self.point_at(to)])
    }
}

/// The border that starts at the circumcenter of `triangle`, across its side `i`, and ends at that
/// of the triangle `beyond`; none when these are the same point.
pub(crate) fn border(
    (sites, corners): (&[Vector<2>], &[usize]),
    triangle: &Triangle,
    i: usize,
    beyond: Option<&Triangle>,
) -> Option<Border> {
    let [a, b] = triangle.side(i);
    let side = sites[b] - sites[a];
    let distance = side.norm();
    let left = planar::quarter_turn(side);
    let direction = Vector::new([left[0] / distance, left[1] / distance]);
    let third = |t: &Triangle| t.corners.into_iter().find(|&c| c != a && c != b).unwrap_or(a);
    let from = center_offset([sites[a], sites[b], sites[third(triangle)]]);
    let to =
        beyond.map_or(f64::INFINITY, |t| -center_offset([sites[b], sites[a], sites[third(t)]]));

    let radius = (0.5 * distance).hypot(from);
    if to - from <= POINT_ROUNDING * radius {
        return None;
    }
    let middle = sites[a] + side * 0.5;
    Some(Border { corners: (corners[b], corners[a]), middle, direction, from, to })
}

/// How far the circumcenter of `a b c` is to the left of the side from `a` to `b`: half the side
/// times the cotangent of the angle at `c`.
fn center_offset([a, b, c]: [Vector<2>; 3]) -> f64 {
    let cotangent = (a - c).dot(b - c) / doubled_area([a, b, c]);
    (0.5 * (b - a).norm() * cotangent).clamp(-BEYOND_REACH, BEYOND_REACH)
}
