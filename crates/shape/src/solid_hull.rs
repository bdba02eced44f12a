//! The convex hull of points in space: which of them are extreme.

use clench_screw::Vector;
use robust::{Coord, Coord3D, orient2d, orient3d};

use crate::predicates::unit_scale;

/// A coordinate below this part of the largest counts as zero: products of three such stay normal
/// numbers.
const INVISIBLE: f64 = 1e-90;

/// The numbers of the extreme points, ascending; all numbers if the points are in one plane.
///
/// Quickhull (Barber, Dobkin and Huhdanpaa) with exact predicates: of equal points one is extreme,
/// and none within an edge or a face of the hull is. The hulls of libraries decide with tolerances:
/// the one of parry loses some millionths of the radius on a cylinder of 10,000 points, and the
/// ends of needles.
pub(crate) fn extreme_points(points: &[Vector<3>]) -> Vec<usize> {
    let largest = points.iter().fold(0.0_f64, |m, p| m.max(p.max_abs()));
    // Nothing is rounded, and no product leaves the range of numbers: of coordinates that are so
    // much smaller than the largest nothing can be told in it.
    let scale = if largest.is_normal() { unit_scale(largest) } else { 1.0 };
    let scaled = |x: f64| if (x * scale).abs() < INVISIBLE { 0.0 } else { x * scale };
    let sites = points.iter().map(|p| p.to_array().map(scaled)).collect();
    let Some(mut hull) = Hull::of_tetrahedron(sites) else {
        return (0..points.len()).collect();
    };
    hull.grow();
    hull.vertices()
}

/// A triangle of the hull, counter-clockwise seen from outside.
#[derive(Clone, Debug)]
struct Facet {
    corners: [usize; 3],
    /// The facet across the side from corner `i` to corner `i + 1`.
    across: [usize; 3],
    /// Points that see it from outside and are not yet in the hull.
    outside: Vec<usize>,
    is_alive: bool,
}

#[derive(Debug)]
struct Hull {
    sites: Vec<[f64; 3]>,
    facets: Vec<Facet>,
}

impl Hull {
    /// Four points that are not in one plane, and all others as their outside.
    fn of_tetrahedron(sites: Vec<[f64; 3]>) -> Option<Self> {
        let [a, b, c, d] = tetrahedron(&sites)?;
        let corners = [[a, b, c], [a, d, b], [b, d, c], [c, d, a]];
        let across = [[1, 2, 3], [3, 2, 0], [1, 3, 0], [2, 1, 0]];
        let facet = |i: usize| Facet {
            corners: corners[i],
            across: across[i],
            outside: Vec::new(),
            is_alive: true,
        };
        let mut hull = Self { sites, facets: (0..4).map(facet).collect() };
        let others = (0..hull.sites.len()).collect();
        hull.assign(others, 0);
        Some(hull)
    }

    /// Adds points until none is outside.
    fn grow(&mut self) {
        let mut next = 0;
        while next < self.facets.len() {
            match self.eye(next) {
                Some(eye) => self.add(eye, next),
                None => next += 1,
            }
        }
    }

    /// The point outside a facet that is farthest from it.
    fn eye(&self, facet: usize) -> Option<usize> {
        let Facet { outside, is_alive, .. } = &self.facets[facet];
        let height = |&site: &usize| -self.side(facet, site);
        let higher = |one: &usize, other: &usize| height(one).total_cmp(&height(other));
        outside.iter().copied().filter(|_| *is_alive).max_by(higher)
    }

    /// Replaces all that `eye` sees by a cone from it.
    fn add(&mut self, eye: usize, start: usize) {
        let mut seen = vec![start];
        let mut rim = Vec::new();
        let mut left = Vec::new();
        self.facets[start].is_alive = false;
        let mut at = 0;
        while at < seen.len() {
            let facet = seen[at];
            at += 1;
            left.append(&mut self.facets[facet].outside);
            for side in 0..3 {
                let beyond = self.facets[facet].across[side];
                if !self.facets[beyond].is_alive {
                    continue;
                }
                let Facet { corners, .. } = &self.facets[facet];
                let edge = [corners[side], corners[(side + 1) % 3]];
                if self.sees(eye, beyond, edge) {
                    self.facets[beyond].is_alive = false;
                    seen.push(beyond);
                } else {
                    rim.push((edge[0], edge[1], beyond));
                }
            }
        }
        let first = self.facets.len();
        self.cone(eye, &rim);
        left.retain(|&site| site != eye);
        self.assign(left, first);
    }

    /// Whether `eye` sees a facet across `edge`, which belongs to one that it sees: from outside
    /// its plane, or, in its plane, unless the edge is between them. Then the facet stays, and the
    /// new one beside it is no degenerate triangle. (Otherwise each new point of a face of many
    /// corners would replace all of its facets.)
    fn sees(&self, eye: usize, facet: usize, edge: [usize; 2]) -> bool {
        let side = self.side(facet, eye);
        if side != 0.0 {
            return side < 0.0;
        }
        let corners = self.facets[facet].corners;
        let apex = corners.into_iter().find(|corner| !edge.contains(corner)).unwrap_or(eye);
        // In a coordinate plane in which the facet has an area: exactly.
        let turn = |axis: usize, point: usize| {
            let [a, b, c] = [edge[0], edge[1], point].map(|i| self.sites[i]);
            let flat = |p: [f64; 3]| Coord { x: p[(axis + 1) % 3], y: p[(axis + 2) % 3] };
            orient2d(flat(a), flat(b), flat(c))
        };
        let sides = (0..3).map(|axis| [turn(axis, apex), turn(axis, eye)]);
        let opposite =
            |[apex, eye]: [f64; 2]| (apex < 0.0 && eye > 0.0) || (apex > 0.0 && eye < 0.0);
        !sides.into_iter().any(opposite)
    }

    /// The facets from the rim to `eye`, joined to each other and to those beyond the rim.
    fn cone(&mut self, eye: usize, rim: &[(usize, usize, usize)]) {
        let first = self.facets.len();
        let mut starts: Vec<(usize, usize)> =
            rim.iter().enumerate().map(|(i, &(start, ..))| (start, first + i)).collect();
        starts.sort_unstable();
        let starting = |corner: usize| {
            let place = starts.partition_point(|&(start, _)| start < corner);
            starts[place].1
        };
        let mut before = vec![0; rim.len()];
        for (i, &(_, end, _)) in rim.iter().enumerate() {
            before[starting(end) - first] = first + i;
        }
        for (i, &(start, end, beyond)) in rim.iter().enumerate() {
            let across = [beyond, starting(end), before[i]];
            let corners = [start, end, eye];
            self.facets.push(Facet { corners, across, outside: Vec::new(), is_alive: true });
            let Facet { corners, across, .. } = &mut self.facets[beyond];
            let side = (0..3).find(|&side| corners[side] == end).unwrap_or_default();
            across[side] = first + i;
        }
    }

    /// Gives each point to a facet, from `first` on, that it sees; the others are inside.
    fn assign(&mut self, points: Vec<usize>, first: usize) {
        for site in points {
            let sees = |&facet: &usize| self.side(facet, site) < 0.0;
            if let Some(facet) = (first..self.facets.len()).find(sees) {
                self.facets[facet].outside.push(site);
            }
        }
    }

    /// Negative for a point outside the facet's plane, positive inside, 0 in it: exactly.
    fn side(&self, facet: usize, site: usize) -> f64 {
        let [a, b, c] = self.facets[facet].corners;
        side(&self.sites, [a, b, c, site])
    }

    fn vertices(&self) -> Vec<usize> {
        let alive = self.facets.iter().filter(|facet| facet.is_alive);
        let mut vertices: Vec<usize> = alive.flat_map(|facet| facet.corners).collect();
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }
}

/// Four points that are not in one plane, the fourth inside the plane of the first three.
fn tetrahedron(sites: &[[f64; 3]]) -> Option<[usize; 4]> {
    let at = |i: usize| Vector::new(sites[i]);
    let farthest = |distance: &dyn Fn(usize) -> f64| {
        (0..sites.len()).max_by(|&i, &j| distance(i).total_cmp(&distance(j)))
    };
    let a = farthest(&|i| -sites[i][0])?;
    let b = farthest(&|i| (at(i) - at(a)).norm_squared())?;
    let along = at(b) - at(a);
    let c = farthest(&|i| clench_screw::spatial::cross(along, at(i) - at(a)).norm_squared())?;
    let d = farthest(&|i| side(sites, [a, b, c, i]).abs())?;
    let height = side(sites, [a, b, c, d]);
    if height > 0.0 {
        Some([a, b, c, d])
    } else if height < 0.0 {
        Some([a, c, b, d])
    } else {
        None
    }
}

fn side(sites: &[[f64; 3]], corners: [usize; 4]) -> f64 {
    let [a, b, c, d] = corners.map(|i| {
        let [x, y, z] = sites[i];
        Coord3D { x, y, z }
    });
    orient3d(a, b, c, d)
}
