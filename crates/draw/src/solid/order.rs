//! In which order things are painted, so that the nearer cover the farther.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use clench_screw::Vector;
use clench_screw::spatial::cross;

use crate::solid::grid::{Grid, Rectangle, around};
use crate::solid::scene::flat;
use crate::world_map::UNSEEN;

/// Two triangles cover one another where they share more than this area: a square too small to
/// see.
const SHARED: f64 = UNSEEN * UNSEEN;

/// Depths that differ by less do not say which is nearer: far above their rounding, far below
/// what is seen.
const SAME_DEPTH: f64 = UNSEEN * UNSEEN;

/// A triangle of something that is painted at once, with the number of that thing.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Patch {
    pub(crate) thing: usize,
    pub(crate) corners: [Vector<3>; 3],
}

/// What covers what, and an order that heeds it.
#[derive(Debug)]
pub(crate) struct Order {
    /// The numbers of the things, those farthest back first.
    pub(crate) sequence: Vec<usize>,
    /// Of each thing, what covers some of it.
    pub(crate) covered_by: Vec<Vec<usize>>,
}

impl Order {
    /// The order of as many things, each of at least one patch.
    ///
    /// Things that cover one another in a ring, or interpenetrate, come by their depth.
    pub(crate) fn new(things: usize, patches: &[Patch]) -> Self {
        let mut depths = vec![f64::NEG_INFINITY; things];
        for patch in patches {
            let depth = patch.corners.iter().map(|corner| corner[2]).sum::<f64>() / 3.0;
            depths[patch.thing] = depths[patch.thing].max(depth);
        }
        let covered_by = covers(things, patches);
        Self { sequence: sequence(&covered_by, &depths), covered_by }
    }
}

fn covers(things: usize, patches: &[Patch]) -> Vec<Vec<usize>> {
    let rectangles: Vec<_> = patches.iter().map(|patch| around(&patch.corners)).collect();
    let grid = Grid::new(&rectangles);
    let mut covered_by = vec![Vec::new(); things];
    for (i, a) in patches.iter().enumerate() {
        for j in grid.near(&rectangles[i]) {
            let b = &patches[j];
            if j <= i || a.thing == b.thing || apart(&rectangles[i], &rectangles[j]) {
                continue;
            }
            let Some(at) = shared_middle(&a.corners, &b.corners) else {
                continue;
            };
            let nearer = depth(&b.corners, at) - depth(&a.corners, at);
            if nearer > SAME_DEPTH {
                covered_by[a.thing].push(b.thing);
            } else if nearer < -SAME_DEPTH {
                covered_by[b.thing].push(a.thing);
            }
        }
    }
    for list in &mut covered_by {
        list.sort_unstable();
        list.dedup();
    }
    covered_by
}

fn apart(a: &Rectangle, b: &Rectangle) -> bool {
    (0..2).any(|i| a[0][i] >= b[1][i] || b[0][i] >= a[1][i])
}

/// The middle of what two triangles share in the picture; none where that is not seen.
fn shared_middle(a: &[Vector<3>; 3], b: &[Vector<3>; 3]) -> Option<[f64; 2]> {
    let polygon = shared(&a.map(flat), &b.map(flat));
    let first = polygon.first()?;
    let (mut area, mut middle) = (0.0, [0.0; 2]);
    for ends in polygon.windows(2) {
        let [u, v] = [0, 1].map(|k| [0, 1].map(|i| ends[k][i] - first[i]));
        let part = (u[0] * v[1] - u[1] * v[0]) / 2.0;
        area += part;
        for i in 0..2 {
            middle[i] += part * (u[i] + v[i]) / 3.0;
        }
    }
    (area.abs() > SHARED).then(|| [0, 1].map(|i| first[i] + middle[i] / area))
}

/// The polygon that a convex one and a triangle, either way round, have in common.
pub(crate) fn shared(polygon: &[[f64; 2]], triangle: &[[f64; 2]; 3]) -> Vec<[f64; 2]> {
    let side = |k: usize, p: [f64; 2]| {
        let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
        (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    };
    let turn = side(0, triangle[2]).signum();
    let mut ring = polygon.to_vec();
    for k in 0..3 {
        let mut kept = Vec::new();
        for (i, &p) in ring.iter().enumerate() {
            let q = ring[(i + 1) % ring.len()];
            let (at_p, at_q) = (turn * side(k, p), turn * side(k, q));
            if at_p >= 0.0 {
                kept.push(p);
            }
            if at_p * at_q < 0.0 {
                let share = at_p / (at_p - at_q);
                kept.push([0, 1].map(|i| p[i] + share * (q[i] - p[i])));
            }
        }
        ring = kept;
    }
    ring
}

/// How near to the viewer the plane of a triangle is at a place of the picture.
fn depth([a, b, c]: &[Vector<3>; 3], at: [f64; 2]) -> f64 {
    let normal = cross(*b - *a, *c - *a);
    a[2] - (normal[0] * (at[0] - a[0]) + normal[1] * (at[1] - a[1])) / normal[2]
}

/// Each thing after all that it covers, else the farthest first.
fn sequence(covered_by: &[Vec<usize>], depths: &[f64]) -> Vec<usize> {
    let mut waits_for = vec![0_usize; depths.len()];
    for &nearer in covered_by.iter().flatten() {
        waits_for[nearer] += 1;
    }
    // Heaps give the greatest first.
    let key = |thing: usize| Reverse((Depth(depths[thing]), thing));
    let mut ready: BinaryHeap<_> =
        (0..depths.len()).filter(|&thing| waits_for[thing] == 0).map(key).collect();
    let mut by_depth: Vec<_> = (0..depths.len()).collect();
    by_depth.sort_by(|&a, &b| depths[a].total_cmp(&depths[b]));
    let mut left = by_depth.into_iter();
    let mut placed = vec![false; depths.len()];
    let mut sequence = Vec::new();
    loop {
        let next = ready.pop().map(|Reverse((_, thing))| thing);
        // Where nothing is free, a ring is broken at its farthest thing.
        let Some(thing) = next.or_else(|| left.find(|&thing| !placed[thing])) else {
            return sequence;
        };
        if std::mem::replace(&mut placed[thing], true) {
            continue;
        }
        sequence.push(thing);
        for &nearer in &covered_by[thing] {
            waits_for[nearer] -= 1;
            if waits_for[nearer] == 0 {
                ready.push(key(nearer));
            }
        }
    }
}

/// A finite depth in the total order of numbers.
#[derive(Debug, Clone, Copy)]
struct Depth(f64);

impl Ord for Depth {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

impl PartialOrd for Depth {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Depth {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Depth {}

#[cfg(test)]
mod tests {
    use super::*;

    fn patch(thing: usize, corners: [[f64; 3]; 3]) -> Patch {
        Patch { thing, corners: corners.map(Vector::from) }
    }

    #[test]
    fn what_covers_comes_later_though_its_middle_is_farther() {
        // A small triangle under the near end of a long one that falls away steeply.
        let long = patch(0, [[-0.4, -0.1, 0.1], [0.4, 0.0, -0.8], [-0.4, 0.1, 0.1]]);
        let small = patch(1, [[-0.4, -0.05, 0.0], [-0.35, 0.0, 0.0], [-0.4, 0.05, 0.0]]);
        let order = Order::new(2, &[long, small]);
        assert_eq!(order.covered_by, [vec![], vec![0]]);
        assert_eq!(order.sequence, [1, 0]);
    }

    #[test]
    fn neighbors_do_not_cover_one_another() {
        let [a, b, c] = [[0.0, 0.0, 0.0], [0.5, 0.0, 0.1], [0.0, 0.5, 0.2]];
        let order = Order::new(2, &[patch(0, [a, b, c]), patch(1, [b, [0.5, 0.5, -0.5], c])]);
        assert_eq!(order.covered_by, [vec![], vec![]]);
        assert_eq!(order.sequence, [1, 0]);
    }

    #[test]
    fn three_that_cover_one_another_in_a_ring_are_all_painted() {
        // Three slats of a star, each rising from under one neighbor to over the other.
        let slat = |thing: usize| {
            let turn =
                2.0 * std::f64::consts::PI * f64::from(u8::try_from(thing).expect("small")) / 3.0;
            let (sin, cos) = turn.sin_cos();
            let at = |x: f64, y: f64, z: f64| [cos * x - sin * y, sin * x + cos * y, z];
            patch(thing, [at(-0.4, -0.12, -0.3), at(0.4, -0.17, 0.3), at(0.4, -0.07, 0.3)])
        };
        let order = Order::new(3, &[slat(0), slat(1), slat(2)]);
        assert!(order.covered_by.iter().all(|nearer| nearer.len() == 1), "{order:?}");
        let mut sequence = order.sequence;
        sequence.sort_unstable();
        assert_eq!(sequence, [0, 1, 2]);
    }
}
