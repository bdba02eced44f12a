//! A convex polygon of few vertices, cut by half-planes.

use std::cmp::Ordering;

use clench_screw::Vector;
use clench_screw::planar::cross;

/// A face starts as a window of 4 vertices, and each of its at most 9 half-planes adds one.
const CAPACITY: usize = 13;

/// A convex polygon, counter-clockwise; empty when nothing is left.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Convex {
    vertices: [Vector<2>; CAPACITY],
    count: usize,
}

impl Convex {
    /// The parallelogram with the given center, spanned by `+-u` and `+-v`, with `u x v > 0`.
    pub(crate) fn parallelogram(center: Vector<2>, u: Vector<2>, v: Vector<2>) -> Self {
        let mut vertices = [Vector::ZERO; CAPACITY];
        vertices[0] = center - u - v;
        vertices[1] = center + u - v;
        vertices[2] = center + u + v;
        vertices[3] = center - u + v;
        Self { vertices, count: 4 }
    }

    /// All sums of the center and parts between -1 and 1 of the generators.
    pub(crate) fn zonogon(center: Vector<2>, generators: [Vector<2>; 4]) -> Self {
        // Pointing to the upper half-plane and in order of angle, they are the sides of the right
        // half, from the lowest vertex up.
        let mut sides =
            generators.map(|g| if g[1] < 0.0 || (g[1] == 0.0 && g[0] < 0.0) { -g } else { g });
        sides.sort_by(|a, b| 0.0.partial_cmp(&cross(*a, *b)).unwrap_or(Ordering::Equal));
        let mut zonogon = Self { vertices: [Vector::ZERO; CAPACITY], count: 0 };
        let mut vertex = sides.iter().fold(center, |sum, &g| sum - g);
        for side in sides.into_iter().chain(sides.map(|g| -g)) {
            zonogon.push(vertex);
            vertex += side * 2.0;
        }
        zonogon
    }

    /// Its area.
    pub(crate) fn area(&self) -> f64 {
        let origin = self.vertices().first().copied().unwrap_or(Vector::ZERO);
        0.5 * self.edges().map(|(a, b)| cross(a - origin, b - origin)).sum::<f64>()
    }

    pub(crate) fn vertices(&self) -> &[Vector<2>] {
        &self.vertices[..self.count]
    }

    /// The edges, from each vertex to the next.
    pub(crate) fn edges(&self) -> impl Iterator<Item = (Vector<2>, Vector<2>)> + '_ {
        let next = |i: usize| if i + 1 < self.count { i + 1 } else { 0 };
        (0..self.count).map(move |i| (self.vertices[i], self.vertices[next(i)]))
    }

    /// What of it fulfills `g . d <= bound`.
    #[must_use]
    pub(crate) fn cut(&self, g: Vector<2>, bound: f64) -> Self {
        let mut kept = Self { vertices: [Vector::ZERO; CAPACITY], count: 0 };
        for (a, b) in self.edges() {
            let (excess_a, excess_b) = (g.dot(a) - bound, g.dot(b) - bound);
            if excess_a <= 0.0 {
                kept.push(a);
            }
            if (excess_a < 0.0 && excess_b > 0.0) || (excess_a > 0.0 && excess_b < 0.0) {
                kept.push(a + (b - a) * (excess_a / (excess_a - excess_b)));
            }
        }
        kept
    }

    /// What of the stretch `[from, to]` of the line `start + t direction` lies inside.
    pub(crate) fn clip(
        &self,
        (start, direction): (Vector<2>, Vector<2>),
        (mut from, mut to): (f64, f64),
    ) -> Option<(f64, f64)> {
        // A polygon without area, a segment or a point, has no inner side that could bound a line
        // along it: its extent does.
        let along = |v: &Vector<2>| (*v - start).dot(direction) / direction.norm_squared();
        from = from.max(self.vertices().iter().map(along).fold(f64::INFINITY, f64::min));
        to = to.min(self.vertices().iter().map(along).fold(f64::NEG_INFINITY, f64::max));
        for (a, b) in self.edges() {
            let (inside, slope) = (cross(b - a, start - a), cross(b - a, direction));
            if slope > 0.0 {
                from = from.max(-inside / slope);
            } else if slope < 0.0 {
                to = to.min(-inside / slope);
            } else if inside < 0.0 {
                return None;
            }
        }
        (from < to).then_some((from, to))
    }

    fn push(&mut self, vertex: Vector<2>) {
        if self.count < CAPACITY {
            self.vertices[self.count] = vertex;
            self.count += 1;
        }
    }
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "small whole numbers are exact")]
mod tests {
    use super::*;

    fn square() -> Convex {
        Convex::parallelogram(Vector::ZERO, Vector::new([1.0, 0.0]), Vector::new([0.0, 1.0]))
    }

    #[test]
    fn a_cut_keeps_what_fulfils_the_inequality() {
        let half = square().cut(Vector::new([1.0, 0.0]), 0.5);
        let expected = [[-1.0, -1.0], [0.5, -1.0], [0.5, 1.0], [-1.0, 1.0]].map(Vector::new);
        assert_eq!(half.vertices(), expected);
        assert!(square().cut(Vector::new([1.0, 0.0]), -2.0).vertices().is_empty());
        assert_eq!(square().cut(Vector::new([1.0, 1.0]), 5.0).vertices(), square().vertices());
    }

    #[test]
    fn a_line_is_clipped_to_what_lies_inside() {
        let line = |x: f64, y: f64| (Vector::new([x, y]), Vector::new([1.0, 0.0]));
        let all = (f64::NEG_INFINITY, f64::INFINITY);
        assert_eq!(square().clip(line(-3.0, 0.0), all), Some((2.0, 4.0)));
        assert_eq!(square().clip(line(-3.0, 0.0), (0.0, 2.5)), Some((2.0, 2.5)));
        assert_eq!(square().clip(line(-3.0, 0.0), (0.0, 1.5)), None);
        assert_eq!(square().clip(line(-3.0, 2.0), all), None);
    }

    #[test]
    fn a_line_along_a_polygon_without_area_is_clipped_to_its_extent() {
        let right = Vector::new([1.0, 0.0]);
        let segment = Convex::parallelogram(Vector::ZERO, right, Vector::ZERO);
        let all = (f64::NEG_INFINITY, f64::INFINITY);
        assert_eq!(segment.clip((Vector::new([-3.0, 0.0]), right), all), Some((2.0, 4.0)));
        assert_eq!(segment.clip((Vector::new([-3.0, 1e-9]), right), all), None);
        let point = Convex::parallelogram(right, Vector::ZERO, Vector::ZERO);
        assert_eq!(point.clip((Vector::ZERO, right), all), None);
    }

    #[test]
    fn a_zonogon_has_the_extent_and_area_of_its_generators() {
        let generators = [[1.0, 0.0], [0.0, -2.0], [0.5, 0.5], [-1.0, 1.0]].map(Vector::new);
        let zonogon = Convex::zonogon(Vector::new([3.0, 4.0]), generators);
        assert_eq!(zonogon.vertices().len(), 8);
        let x = zonogon.vertices().iter().map(|v| v[0]).fold(0.0, f64::max);
        assert_eq!(x, 3.0 + 1.0 + 0.5 + 1.0);
        // Four times the sum of |g_i x g_j|: 2 + 0.5 + 1 + 1 + 2 + 1.
        assert_eq!(zonogon.area(), 4.0 * 7.5);
    }

    #[test]
    fn the_area_of_a_cut_is_that_of_what_is_left() {
        assert_eq!(square().area(), 4.0);
        assert_eq!(square().cut(Vector::new([1.0, 0.0]), -0.5).area(), 1.0);
    }
}
