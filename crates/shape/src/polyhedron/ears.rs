//! Simple polygons cut into triangles.

use std::collections::VecDeque;

use clench_screw::Vector;

use crate::hull::compare;
use crate::predicates::turn;

/// The corners of triangles that cover a simple polygon exactly once, in the order in which it
/// runs; none is on one line.
///
/// An ear, the triangle at a corner in which there is no other, is cut off until nothing is left;
/// a corner in the middle of a straight stretch is passed over. All turns are exact, so that there
/// always is an ear (G. H. Meisters, *Polygons Have Ears*, 1975), and cutting it off makes ears of
/// its two neighbors at most. Cost: O(n + n r) for `r` of `n` corners that are hollow.
pub(super) fn ears(outline: &[Vector<2>]) -> Vec<[usize; 3]> {
    let mut chain = Chain::new(outline);
    let mut triangles = Vec::with_capacity(outline.len().saturating_sub(2));
    // Straight corners first, so that few triangles are needed.
    let mut candidates: VecDeque<usize> =
        chain.hollow.iter().copied().chain(0..outline.len()).collect();
    while chain.count > 2 {
        let Some(at) = candidates.pop_front() else { break };
        if chain.is_cut[at] {
            continue;
        }
        let corners = [chain.before[at], at, chain.after[at]];
        let [a, b, c] = corners.map(|corner| chain.points[corner]);
        let bend = turn(a, b, c);
        if bend < 0.0 || (bend > 0.0 && !chain.is_ear(corners)) {
            continue;
        }
        if bend > 0.0 {
            triangles.push(corners);
        }
        chain.cut(corners);
        candidates.extend([corners[0], corners[2]]);
    }
    triangles
}

/// What is left of a polygon.
struct Chain {
    /// Counter-clockwise.
    points: Vec<Vector<2>>,
    before: Vec<usize>,
    after: Vec<usize>,
    is_cut: Vec<bool>,
    count: usize,
    /// All corners that may be hollow or straight: if any corner is in an ear, one of these is.
    hollow: Vec<usize>,
}

impl Chain {
    fn new(outline: &[Vector<2>]) -> Self {
        let n = outline.len();
        let (before, after): (Vec<_>, Vec<_>) =
            (0..n).map(|i| ((i + n - 1) % n, (i + 1) % n)).unzip();
        let bend =
            |points: &[Vector<2>], i: usize| turn(points[before[i]], points[i], points[after[i]]);
        // The first corner from the left is one of the hull, where the outline turns as a whole.
        let first = (0..n).min_by(|&i, &j| compare(outline[i], outline[j])).unwrap_or(0);
        let is_left = bend(outline, first) > 0.0;
        let mirrored = |v: &Vector<2>| if is_left { *v } else { Vector::new([v[1], v[0]]) };
        let points: Vec<Vector<2>> = outline.iter().map(mirrored).collect();
        let hollow = (0..n).filter(|&i| bend(&points, i) <= 0.0).collect();
        Self { points, before, after, is_cut: vec![false; n], count: n, hollow }
    }

    /// Whether no other corner is in the triangle at a corner, its border included.
    fn is_ear(&self, corners: [usize; 3]) -> bool {
        let [a, b, c] = corners.map(|corner| self.points[corner]);
        let is_in =
            |p: Vector<2>| turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
        let is_other = |&&corner: &&usize| !self.is_cut[corner] && !corners.contains(&corner);
        !self.hollow.iter().filter(is_other).any(|&corner| is_in(self.points[corner]))
    }

    fn cut(&mut self, [before, at, after]: [usize; 3]) {
        self.after[before] = after;
        self.before[after] = before;
        self.is_cut[at] = true;
        self.count -= 1;
    }
}
