//! Convex polygons around convex sets.

use clench_screw::Vector;

use super::obstacle::Obstacle;

/// Directions in which any set is looked at first, over half a turn.
const FIRST: usize = 4;

/// Corners of a polygon at most: a set of any shape is covered by far fewer.
const MOST_CORNERS: usize = 4096;

/// How often the angle beside a side of the window is halved: to a hundredth of a degree.
const BISECTIONS: usize = 12;

/// A convex polygon, counter-clockwise.
#[derive(Clone, Debug)]
pub(super) struct Cover {
    sides: Vec<Side>,
}

/// A side of a polygon.
#[derive(Clone, Copy, Debug)]
struct Side {
    /// The corner that it begins at.
    from: Vector<2>,
    /// Outward, a unit vector.
    normal: Vector<2>,
    /// Whether it is one of the window.
    is_window: bool,
}

impl Cover {
    /// The window from minus `half` to `half`.
    pub(super) fn window(half: Vector<2>) -> Self {
        let (right, up) = (Vector::new([1.0, 0.0]), Vector::new([0.0, 1.0]));
        let side = |x: f64, y: f64, normal| {
            let from = Vector::new([x * half[0], y * half[1]]);
            Side { from, normal, is_window: true }
        };
        let (bottom, top) = (side(-1.0, -1.0, -up), side(1.0, 1.0, up));
        Self { sides: vec![bottom, side(1.0, -1.0, right), top, side(-1.0, 1.0, -right)] }
    }

    /// The part of the window in a polygon that holds an obstacle, with `padding`, and no point of
    /// the window farther from it than `tolerance`; `None` if that is empty.
    ///
    /// Where two sides meet at a point that is as far from the set as a third of the tolerance or
    /// more in the direction between, another side is put in between. (As a function of the angle
    /// that distance is a sine wave or more curved, zero at both sides: at most about twice what it
    /// is in the middle. At a side of the window it is negative, as far as the set is beyond; there
    /// other directions are tried, too.)
    pub(super) fn of(
        obstacle: &Obstacle,
        half: Vector<2>,
        tolerance: f64,
        padding: f64,
    ) -> Option<Self> {
        let mut cover = Self::window(half);
        let even = (0..FIRST).flat_map(|i| {
            let (y, x) = (std::f64::consts::PI * i as f64 / FIRST as f64).sin_cos();
            [Vector::new([x, y]), Vector::new([-x, -y])]
        });
        for u in even.chain(obstacle.straight.iter().copied()) {
            cover.clip(u, obstacle.support(u) + padding)?;
        }
        let mut at = 0;
        while at < cover.sides.len() && cover.sides.len() < MOST_CORNERS {
            let before = cover.sides[(at + cover.sides.len() - 1) % cover.sides.len()];
            let corner = cover.sides[at].from;
            let mut tried = between(before, cover.sides[at])
                .map(|u| (u, obstacle.support(u) + padding))
                .filter(|(u, support)| u.dot(corner) - support > tolerance / 3.0);
            match tried.next() {
                // Again from the first of the two new corners.
                Some((u, support)) => {
                    cover.clip(u, support)?;
                    at = at.saturating_sub(1);
                }
                None => at += 1,
            }
        }
        Some(cover)
    }

    /// Keeps where `row . p` is no more than `limit`, for a row of any length; `None` if that is
    /// nowhere.
    pub(super) fn limit(&mut self, row: Vector<2>, limit: f64) -> Option<()> {
        match row.direction() {
            Some(u) => self.clip(u, limit / row.norm()),
            None => (limit >= 0.0).then_some(()),
        }
    }

    /// Keeps what is not beyond the line `u . p = limit`; `None` if nothing is left.
    fn clip(&mut self, u: Vector<2>, limit: f64) -> Option<()> {
        let beyond: Vec<f64> = self.sides.iter().map(|side| u.dot(side.from) - limit).collect();
        if beyond.iter().all(|&height| height <= 0.0) {
            return Some(());
        }
        let count = self.sides.len();
        let mut kept = Vec::with_capacity(count + 1);
        for i in 0..count {
            let (side, next) = (self.sides[i], (i + 1) % count);
            if beyond[i] <= 0.0 {
                kept.push(side);
            }
            if (beyond[i] <= 0.0) != (beyond[next] <= 0.0) {
                let part = beyond[i] / (beyond[i] - beyond[next]);
                let from = side.from + (self.sides[next].from - side.from) * part;
                let leaves = beyond[i] <= 0.0;
                let new = Side { from, normal: u, is_window: false };
                kept.push(if leaves { new } else { Side { from, ..side } });
            }
        }
        self.sides = kept;
        (self.sides.len() > 2).then_some(())
    }

    /// Whether it is the whole window.
    pub(super) fn is_window(&self) -> bool {
        self.sides.iter().all(|side| side.is_window)
    }

    /// The corners, counter-clockwise.
    pub(super) fn corners(&self) -> impl Iterator<Item = Vector<2>> + Clone + '_ {
        self.sides.iter().map(|side| side.from)
    }

    /// Whether a triangle overlaps it by more than `slack`.
    ///
    /// Convex sets that do not have a line along a side of one of them between.
    pub(super) fn overlaps(&self, triangle: &[Vector<2>; 3], slack: f64) -> bool {
        let corners: Vec<Vector<2>> = self.corners().collect();
        let apart = |one: &[Vector<2>], others: &[Vector<2>]| {
            half_planes(one).any(|(u, limit)| others.iter().all(|&x| u.dot(x) >= limit - slack))
        };
        !apart(&corners, triangle) && !apart(triangle, &corners)
    }

    /// Triangles that cover what of a triangle is not in it.
    pub(super) fn outside(&self, triangle: &[Vector<2>; 3]) -> Vec<[Vector<2>; 3]> {
        let corners: Vec<Vector<2>> = self.corners().collect();
        let (mut within, mut found) = (triangle.to_vec(), Vec::new());
        for (u, limit) in half_planes(&corners) {
            let beyond = clipped(&within, -u, -limit);
            let fan = (2..beyond.len()).map(|i| [beyond[0], beyond[i - 1], beyond[i]]);
            found.extend(fan);
            within = clipped(&within, u, limit);
        }
        found
    }
}

/// Directions between the normals of two sides: the middle, and beside a side of the window ever
/// nearer to either.
fn between(before: Side, after: Side) -> impl Iterator<Item = Vector<2>> {
    let middle = (before.normal + after.normal).direction();
    let nearer = move |end: Vector<2>| {
        let first = middle.filter(|_| before.is_window || after.is_window);
        std::iter::successors(first, move |u| (*u + end).direction()).skip(1).take(BISECTIONS)
    };
    middle.into_iter().chain(nearer(before.normal)).chain(nearer(after.normal))
}

/// The outward unit normals of a convex polygon, and how far it reaches along each.
///
/// Sides as short as rounding may have any direction, so all corners count.
fn half_planes(corners: &[Vector<2>]) -> impl Iterator<Item = (Vector<2>, f64)> + '_ {
    (0..corners.len()).filter_map(|i| {
        let side = corners[(i + 1) % corners.len()] - corners[i];
        let u = Vector::new([side[1], -side[0]]).direction()?;
        Some((u, corners.iter().map(|x| u.dot(*x)).fold(f64::NEG_INFINITY, f64::max)))
    })
}

/// The part of a convex polygon where `u . p` is no more than `limit`.
fn clipped(corners: &[Vector<2>], u: Vector<2>, limit: f64) -> Vec<Vector<2>> {
    let beyond: Vec<f64> = corners.iter().map(|x| u.dot(*x) - limit).collect();
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (i, &corner) in corners.iter().enumerate() {
        let next = (i + 1) % corners.len();
        if beyond[i] <= 0.0 {
            kept.push(corner);
        }
        if (beyond[i] <= 0.0) != (beyond[next] <= 0.0) {
            let part = beyond[i] / (beyond[i] - beyond[next]);
            kept.push(corner + (corners[next] - corner) * part);
        }
    }
    kept
}
