//! The first placements of a search against ten times as many ascents from other starts.

use super::{held, part, rating};
use crate::polyhedron::Fingers;
use crate::polyhedron::bound::Pieces;
use crate::polyhedron::rating::Worth;
use crate::polyhedron::scene::Scene;
use crate::polyhedron::search::SpatialSearch;

use clench_testkit::Random;
use rayon::prelude::*;

/// Seeds that no search uses.
const SEEDS: std::ops::Range<u64> = 1_000_000..1_000_160;

#[test]
fn ten_times_as_many_ascents_find_nothing_better() {
    let mut r = Random::new(76);
    // Cube, tetrahedron, wedge and L.
    for kind in 0..4 {
        let part = part(&mut r, kind);
        let fingers = Fingers::new(7);
        let scene = Scene::of_part(&part, &fingers).unwrap();
        let rating = rating(&scene, &fingers);
        let pieces = Pieces::new(&scene);
        let first = SpatialSearch::new(rating, &pieces).first::<7>(None);
        let found = first.iter().map(|candidate| candidate.quality).fold(0.0, f64::max);
        let seeds: Vec<u64> = SEEDS.collect();
        let others = seeds.par_iter().filter_map(|&seed| held::<7>(rating, seed));
        let best = others.map(|(worth, _)| match worth {
            Worth::Held(quality, _) => quality,
            Worth::Loose(_) => 0.0,
        });
        let best = best.reduce(|| 0.0, f64::max);
        assert!(found >= best * (1.0 - 1e-6), "body {kind}: {found} after {best}");
    }
}
