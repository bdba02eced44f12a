//! The outlines that library and peers are asked about, and how they are handed over.

use std::f64::consts::TAU;

use clench::optimize::polygon::Part;
use clench::shape::Polygon;
use serde::Serialize;

use super::PeersError;

/// A part as the scripts read it: edge `e` joins corner `e` to corner `e + 1`.
#[derive(Debug, Serialize)]
pub(super) struct Outline {
    corners: Vec<[f64; 2]>,
    /// The inward normals, by edge.
    normals: Vec<[f64; 2]>,
    /// By edge.
    stiffness: Vec<f64>,
}

impl Outline {
    pub(super) fn of(part: &Part) -> Self {
        let edges = part.outline().edges();
        Self {
            corners: edges.iter().map(|edge| edge.start().to_array()).collect(),
            normals: edges.iter().map(|edge| edge.inward_normal().to_array()).collect(),
            stiffness: part.edge_stiffness().to_vec(),
        }
    }
}

/// The smooth part of the benches with so many corners, stiffness 1 on each edge.
///
/// `r(t) = 1 + sum of a_m cos(m t + p_m)` over `m` = 2 to 6, with `a_m` uniform in
/// `[0, 0.25 / (m - 1)]` and random `p_m`, stretched 10 : 7.
pub(super) fn smooth_part(corners: usize, seed: u64) -> Result<Part, PeersError> {
    let mut random = fastrand::Rng::with_seed(seed);
    let waves = [2.0, 3.0, 4.0, 5.0, 6.0].map(|m| {
        let size = 0.25 / (m - 1.0) * random.f64();
        (m, size, TAU * random.f64())
    });
    let corner = |i: usize| {
        let t = TAU * i as f64 / corners as f64;
        let swell: f64 = waves.iter().map(|(m, size, phase)| size * (m * t + phase).cos()).sum();
        [10.0 * (1.0 + swell) * t.cos(), 7.0 * (1.0 + swell) * t.sin()]
    };
    let corners: Vec<[f64; 2]> = (0..corners).map(corner).collect();
    Ok(Part::uniform(Polygon::new(&corners)?, 1.0)?)
}

/// All sets of four edges, ascending, several fingers on one edge included.
pub(super) fn combinations(edges: usize) -> impl Iterator<Item = [usize; 4]> {
    (0..edges).flat_map(move |a| {
        (a..edges)
            .flat_map(move |b| (b..edges).flat_map(move |c| (c..edges).map(move |d| [a, b, c, d])))
    })
}

#[cfg(test)]
mod tests {
    use super::{Outline, combinations, smooth_part};

    #[test]
    fn there_are_as_many_combinations_as_multisets() {
        let all: Vec<_> = combinations(10).collect();
        assert_eq!(all.len(), 715);
        assert!(all.is_sorted() && all.iter().all(|edges| edges.is_sorted()));
    }

    #[test]
    fn an_outline_has_a_normal_and_a_stiffness_for_each_corner() {
        let outline = Outline::of(&smooth_part(15, 7).unwrap());
        let Outline { corners, normals, stiffness } = &outline;
        assert_eq!([corners.len(), normals.len(), stiffness.len()], [15; 3]);
    }
}
