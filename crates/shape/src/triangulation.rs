//! The farthest-point Delaunay triangulation of a convex polygon.
//!
//! The circle through the corners of each triangle holds all other sites. The triangles' dual is
//! the farthest-point Voronoi diagram, the regions `R_i` of LBR.

use clench_screw::{Vector, planar};

use crate::predicates::{in_circle, turn, unit_scale};

/// Three sites and the triangles beside them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Triangle {
    /// Sites, counter-clockwise.
    pub(crate) corners: [usize; 3],
    /// The triangle across the side opposite each corner; none across a side of the hull.
    pub(crate) across: [Option<usize>; 3],
}

impl Triangle {
    /// The side opposite corner `i`, with the triangle on its left.
    pub(crate) fn side(&self, i: usize) -> [usize; 2] {
        [self.corners[(i + 1) % 3], self.corners[(i + 2) % 3]]
    }

    /// The place of a site among the corners.
    pub(crate) fn index_of(&self, site: usize) -> usize {
        (0..3).find(|&i| self.corners[i] == site).unwrap_or_default()
    }

    fn replace_neighbor(&mut self, old: usize, new: usize) {
        for side in &mut self.across {
            if *side == Some(old) {
                *side = Some(new);
            }
        }
    }
}

/// The triangles, `h - 2` of them for `h` sites.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Triangulation {
    triangles: Vec<Triangle>,
    /// For each site the triangle at the hull's side from it to the next site.
    outer: Vec<usize>,
}

impl Triangulation {
    /// The triangulation of at least three sites, strictly convex, counter-clockwise.
    ///
    /// Chew's method: leave the sites out one by one in a shuffled order, then put them back, the
    /// last first, and turn edges until each is right again. All decisions are exact. Cost: O(h)
    /// expected.
    pub(crate) fn new(sites: &[Vector<2>]) -> Self {
        let h = sites.len();
        let sites = to_unit_size(sites);
        let order = shuffled(h);
        let mut before: Vec<usize> = (0..h).map(|i| (i + h - 1) % h).collect();
        let mut after: Vec<usize> = (0..h).map(|i| (i + 1) % h).collect();
        for &site in order[3..].iter().rev() {
            (after[before[site]], before[after[site]]) = (after[site], before[site]);
        }
        let first = order[0];
        let corners = [first, after[first], before[first]];
        let triangles = vec![Triangle { corners, across: [None; 3] }];
        let mut mesh = Self { triangles, outer: vec![0; h] };
        for &site in &order[3..] {
            mesh.insert(&sites, site, before[site], after[site]);
        }
        mesh
    }

    pub(crate) fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// The triangle at the hull's side from `site` to the next one.
    pub(crate) fn outer(&self, site: usize) -> usize {
        self.outer[site]
    }

    /// Puts `site` back between its neighbors at this stage.
    fn insert(&mut self, sites: &[Vector<2>], site: usize, before: usize, after: usize) {
        let (inner, new) = (self.outer[before], self.triangles.len());
        let corners = [site, after, before];
        self.triangles.push(Triangle { corners, across: [Some(inner), None, None] });
        let side = (0..3).find(|&i| self.triangles[inner].side(i) == [before, after]);
        self.triangles[inner].across[side.unwrap_or_default()] = Some(new);
        self.outer[before] = new;
        self.outer[site] = new;
        let mut suspects = vec![new];
        while let Some(t) = suspects.pop() {
            if let Some(beside) = self.triangles[t].across[0] {
                let circle = self.triangles[beside].corners.map(|c| sites[c]);
                if in_circle(circle, sites[site]) < 0.0 {
                    self.turn_edge(t, beside);
                    suspects.extend([t, beside]);
                }
            }
        }
    }

    /// Replaces the edge between `t = (v, p, q)` and `beside`, which has `q, p` and the corner
    /// `x` opposite, by the edge from `v` to `x`: `t` becomes `(v, p, x)`, `beside` `(v, x, q)`.
    fn turn_edge(&mut self, t: usize, beside: usize) {
        let [v, p, q] = self.triangles[t].corners;
        let old = &self.triangles[beside];
        let i = (0..3).find(|&i| old.side(i) == [q, p]).unwrap_or_default();
        let x = old.corners[i];
        let (beyond_px, beyond_xq) = (old.across[(i + 1) % 3], old.across[(i + 2) % 3]);
        let [_, beyond_qv, beyond_vp] = self.triangles[t].across;

        let across = [beyond_px, Some(beside), beyond_vp];
        self.triangles[t] = Triangle { corners: [v, p, x], across };
        let across = [beyond_xq, beyond_qv, Some(t)];
        self.triangles[beside] = Triangle { corners: [v, x, q], across };
        match beyond_px {
            Some(other) => self.triangles[other].replace_neighbor(beside, t),
            None => self.outer[p] = t,
        }
        match beyond_qv {
            Some(other) => self.triangles[other].replace_neighbor(t, beside),
            None => self.outer[q] = beside,
        }
    }
}

/// A fixed order of `0..count` without a pattern: the insertion takes expected linear time.
fn shuffled(count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    // The finalizer of SplitMix64, a bijection that scatters consecutive numbers.
    order.sort_by_cached_key(|&i| {
        let mut key = (i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        key = (key ^ (key >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        key = (key ^ (key >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        key ^ (key >> 31)
    });
    order
}

/// The sites times a power of two, so that the largest coordinate is of the order of 1.
fn to_unit_size(sites: &[Vector<2>]) -> Vec<Vector<2>> {
    let largest = sites.iter().fold(0.0_f64, |m, site| m.max(site.max_abs()));
    let scale = unit_scale(largest);
    sites.iter().map(|&site| site * scale).collect()
}

/// Twice the area of a strictly convex triangle, counter-clockwise, so positive.
///
/// Taken at the corner between the two shorter sides, where the rounding error is least: it then
/// moves the circumcenter by a few roundings of the circumradius only.
pub(crate) fn doubled_area(corners: [Vector<2>; 3]) -> f64 {
    let apex = widest(corners);
    turn(corners[(apex + 1) % 3], corners[(apex + 2) % 3], corners[apex])
}

/// The corner with the widest angle, opposite the longest side.
///
/// The product of the two sides at a corner falls as the side opposite grows. Unlike the lengths it
/// tells them apart even when two corners nearly coincide.
pub(crate) fn widest(corners: [Vector<2>; 3]) -> usize {
    let product = |i: usize| {
        let at = corners[i];
        (corners[(i + 1) % 3] - at).dot(corners[(i + 2) % 3] - at)
    };
    (1..3).fold(0, |best, i| if product(i) < product(best) { i } else { best })
}

/// The vector from corner `i` to the circumcenter, times a positive number.
///
/// With the sides `e`, `f` at the corner and `g = f - e`, the circumcenter lies at
/// `(|f|^2 q(e) - |e|^2 q(f)) / (2 e x f)`, `q` a quarter turn. Written with the shorter side `s`
/// this is `((g . (e + f)) q(s) - |s|^2 q(g)) / (2 e x f)`, which loses nothing when the other
/// corners are close together; nor does the denominator matter, which does for corners that are
/// nearly on one line. So the direction is good to a few roundings always.
pub(crate) fn to_circumcenter(corners: [Vector<2>; 3], i: usize) -> Vector<2> {
    let (a, b, c) = (corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]);
    let (e, f, g) = (b - a, c - a, c - b);
    let scale = unit_scale(e.max_abs().max(f.max_abs()));
    let (e, f, g) = (e * scale, f * scale, g * scale);
    let shorter = if e.norm_squared() < f.norm_squared() { e } else { f };
    planar::quarter_turn(shorter) * g.dot(e + f) - planar::quarter_turn(g) * shorter.norm_squared()
}

/// The point equally far from the three corners of a triangle without an obtuse angle.
pub(crate) fn circumcenter(corners: [Vector<2>; 3]) -> Vector<2> {
    let i = widest(corners);
    let (e, f) = (corners[(i + 1) % 3] - corners[i], corners[(i + 2) % 3] - corners[i]);
    let scale = unit_scale(e.max_abs().max(f.max_abs()));
    let doubled = doubled_area(corners) * scale * scale;
    corners[i] + to_circumcenter(corners, i) * (0.5 / doubled / scale)
}
