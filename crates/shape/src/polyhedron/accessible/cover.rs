//! Convex polygons around convex sets.

use clench_screw::Vector;

use super::obstacle::Obstacle;

/// Directions in which any set is looked at first, over half a turn.
const FIRST: usize = 4;

/// Corners of a polygon at most: a set of any shape is covered by far fewer.
const MOST_CORNERS: usize = 4096;

/// A convex polygon, counter-clockwise.
#[derive(Clone, Debug)]
pub(super) struct Cover {
    /// Corners, and the outward unit normal of the side that begins there; none for a side of the
    /// window.
    sides: Vec<(Vector<2>, Option<Vector<2>>)>,
}

impl Cover {
    /// The window from minus `half` to `half`.
    pub(super) fn window(half: Vector<2>) -> Self {
        let signs = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let corner = |[x, y]: [f64; 2]| (Vector::new([x * half[0], y * half[1]]), None);
        Self { sides: signs.map(corner).to_vec() }
    }

    /// The part of the window in a polygon that holds an obstacle, with `padding`, and no point of
    /// the window farther from it than `tolerance`; `None` if that is empty.
    ///
    /// Where two sides meet at a point that is as far from the set as a third of the tolerance or
    /// more in the direction between, another side is put in between. (As a function of the angle
    /// that distance is a sine wave or more curved, zero at both sides: at most about twice what it
    /// is in the middle.)
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
            let before = cover.sides[(at + cover.sides.len() - 1) % cover.sides.len()].1;
            let (corner, after) = cover.sides[at];
            let between = before.zip(after).and_then(|(one, other)| (one + other).direction());
            let support = between.map(|u| (u, obstacle.support(u) + padding));
            match support.filter(|(u, support)| u.dot(corner) - support > tolerance / 3.0) {
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
        let beyond: Vec<f64> = self.sides.iter().map(|(x, _)| u.dot(*x) - limit).collect();
        if beyond.iter().all(|&height| height <= 0.0) {
            return Some(());
        }
        let count = self.sides.len();
        let mut kept = Vec::with_capacity(count + 1);
        for i in 0..count {
            let ((corner, normal), next) = (self.sides[i], (i + 1) % count);
            if beyond[i] <= 0.0 {
                kept.push((corner, normal));
            }
            if (beyond[i] <= 0.0) != (beyond[next] <= 0.0) {
                let part = beyond[i] / (beyond[i] - beyond[next]);
                let crossing = corner + (self.sides[next].0 - corner) * part;
                let leaves = beyond[i] <= 0.0;
                kept.push((crossing, if leaves { Some(u) } else { normal }));
            }
        }
        self.sides = kept;
        (self.sides.len() > 2).then_some(())
    }

    /// Whether it is the whole window.
    pub(super) fn is_window(&self) -> bool {
        self.sides.iter().all(|(_, normal)| normal.is_none())
    }

    /// The corners, counter-clockwise.
    pub(super) fn corners(&self) -> impl Iterator<Item = Vector<2>> + Clone + '_ {
        self.sides.iter().map(|&(corner, _)| corner)
    }

    /// Whether a triangle overlaps it by more than `slack`.
    ///
    /// Convex sets that do not have a line along a side of one of them between.
    pub(super) fn overlaps(&self, triangle: &[Vector<2>; 3], slack: f64) -> bool {
        let corners: Vec<Vector<2>> = self.corners().collect();
        let apart = |sides: &[Vector<2>], others: &[Vector<2>]| {
            (0..sides.len()).any(|i| {
                let (from, to) = (sides[i], sides[(i + 1) % sides.len()]);
                let side = to - from;
                let Some(out) = Vector::new([side[1], -side[0]]).direction() else { return false };
                others.iter().all(|&x| out.dot(x - from) >= -slack)
            })
        };
        !apart(&corners, triangle) && !apart(triangle, &corners)
    }
}
