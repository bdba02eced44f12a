//! The inputs that the measurements share.
//!
//! Run one with `cargo bench --package clench-benches --bench placement`.

#![allow(clippy::expect_used, reason = "fixed inputs of measurements")]

use clench::optimize::polygon::Part;
use clench::shape::{Polygon, PolygonError};
use clench_testkit::Random;

/// A smooth closed outline of `corners` corners: `r(t) = 1 + sum of a_m cos(m t + p_m)` over
/// `m` = 2 to 6, with `a_m` uniform in `[0, 0.25 / (m - 1)]` and random `p_m`, stretched 10 : 7.
///
/// # Errors
///
/// [`PolygonError`] when two corners of a fine outline coincide, which none of the seeds in use
/// comes near.
pub fn smooth_outline(corners: usize, seed: u64) -> Result<Polygon, PolygonError> {
    let r = &mut Random::new(seed);
    let waves: Vec<[f64; 3]> = (2..=6)
        .map(|m| {
            let m = f64::from(m);
            [m, r.between(0.0, 0.25 / (m - 1.0)), r.between(0.0, std::f64::consts::TAU)]
        })
        .collect();
    let corner = |i: usize| {
        let t = std::f64::consts::TAU * i as f64 / corners as f64;
        let radius: f64 = 1.0 + waves.iter().map(|[m, a, p]| a * (m * t + p).cos()).sum::<f64>();
        [10.0 * radius * t.cos(), 7.0 * radius * t.sin()]
    };
    let corners: Vec<[f64; 2]> = (0..corners).map(corner).collect();
    Polygon::new(&corners)
}

/// The smooth outline of [`smooth_outline`] with stiffness 1 on each edge.
///
/// # Panics
///
/// When the outline is not valid.
#[must_use]
pub fn smooth_part(corners: usize, seed: u64) -> Part {
    let outline = smooth_outline(corners, seed).expect("a smooth outline is simple");
    Part::uniform(outline, 1.0).expect("1 is a stiffness")
}
