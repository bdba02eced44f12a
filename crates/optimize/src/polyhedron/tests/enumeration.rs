//! The search among candidates against all combinations of them.

use std::sync::atomic::{AtomicUsize, Ordering};

use clench_testkit::Random;

use super::{OBJECTIVES, part, rating, touch};
use crate::polyhedron::bound::{Hint, Pieces};
use crate::polyhedron::rating::{Rating, Spot, Worth};
use crate::polyhedron::scene::Scene;
use crate::polyhedron::search::SpatialSearch;
use crate::polyhedron::{Fingers, Touch, fingers_among};
use crate::search::{Bounded, Candidate, Floor, Leaders, Piece, Problem, Settled, above, search};
use crate::{Effort, Ended, OptimizeError, unwatched};

/// What all combinations of seven candidates are worth, if they hold.
pub(super) fn all(rating: Rating<'_>) -> Vec<([usize; 7], f64)> {
    let count = rating.scene.patches.len();
    let mut found = Vec::new();
    let mut set: [usize; 7] = std::array::from_fn(|i| i);
    loop {
        let spots: Vec<Spot> = set
            .iter()
            .map(|&patch| Spot { patch, point: rating.scene.patches[patch].corners[0] })
            .collect();
        if let Some(Worth::Held(quality, _)) = rating.above(&spots, Worth::Loose(f64::NEG_INFINITY))
        {
            found.push((set, quality));
        }
        let Some(i) = (0..7).rev().find(|&i| set[i] + 7 < count + i) else { return found };
        set[i] += 1;
        for j in i + 1..7 {
            set[j] = set[j - 1] + 1;
        }
    }
}

/// A search each bound of which is held against the best combination under its node.
struct Watched<'a> {
    inner: SpatialSearch<'a>,
    pieces: &'a Pieces<'a>,
    /// Best first.
    all: &'a [([usize; 7], f64)],
    /// How many bounds were near what is under them.
    near: AtomicUsize,
}

impl Problem<7> for Watched<'_> {
    type Place = [Spot; 7];
    type Hint = Hint;

    const MOST_OPEN: usize = 1 << 19;
    const NODES_PER_PROBE: u64 = u64::MAX;

    fn halves(&self, piece: Piece) -> Option<[Piece; 2]> {
        self.pieces.halves(piece)
    }

    fn unit(&self) -> f64 {
        1.0
    }

    fn combination(&self, node: &[Piece; 7]) -> Option<[usize; 7]> {
        self.inner.combination(node)
    }

    fn bound(
        &self,
        node: &[Piece; 7],
        floor: &Floor,
        hint: Option<&Hint>,
    ) -> Option<Bounded<Hint>> {
        let bounded = self.inner.bound(node, floor, hint);
        let under = self.all.iter().find(|(set, _)| is_under(self.pieces, node, set, 0, 0));
        if let Some((set, quality)) = under.filter(|(_, quality)| *quality > above(floor.quality)) {
            let bound = bounded.as_ref().map_or(0.0, |bounded| bounded.bound);
            assert!(bound >= quality * (1.0 - 1e-11), "{bound} < {quality} of {set:?}");
            self.near.fetch_add(usize::from(bound < 2.0 * quality), Ordering::Relaxed);
        }
        bounded
    }

    fn probe(&self, _: &[Piece; 7], _: u64) -> Option<Candidate<7, [Spot; 7]>> {
        None
    }

    fn settle(&self, node: &[Piece; 7], floor: &Floor) -> Settled<7, [Spot; 7]> {
        self.inner.settle(node, floor)
    }
}

/// Whether seven candidates can be put on the pieces, one each.
fn is_under(pieces: &Pieces<'_>, node: &[Piece; 7], set: &[usize; 7], used: u8, at: usize) -> bool {
    at == 7
        || (0..7).any(|i| {
            used >> i & 1 == 0
                && pieces.patches(node[at]).contains(&set[i])
                && is_under(pieces, node, set, used | 1 << i, at + 1)
        })
}

#[test]
fn the_search_among_candidates_finds_the_best_of_all_combinations() {
    let mut r = Random::new(62);
    let (mut answered, mut near) = (0, 0);
    for round in 0..48 {
        let part = part(&mut r, round % 6);
        let candidates: Vec<Touch> = (0..13 + r.below(3)).map(|_| touch(&mut r, &part)).collect();
        let objective = OBJECTIVES[round / 6 % 4];
        let fingers = Fingers { objective, roundness: 0.0, ..Fingers::new(7) };
        let body = part.solid().extreme_points();
        // All candidates may be on faces along one direction.
        let Ok(scene) = Scene::of_candidates(body, &candidates, &fingers) else { continue };
        let rating = rating(&scene, &fingers);
        let mut all = all(rating);
        all.sort_by(|a, b| b.1.total_cmp(&a.1));
        let found = fingers_among(body, &candidates, &fingers, &Effort::default(), unwatched);
        let Some(&(_, most)) = all.first() else {
            let none = matches!(
                found,
                Err(OptimizeError::NeverHeld { .. }
                    | OptimizeError::AlwaysEscapes { .. }
                    | OptimizeError::ConditionsNeverMet { .. })
            );
            assert!(none, "{found:?}");
            continue;
        };
        answered += 1;
        let found = found.unwrap();
        assert_eq!(found.certificate.ended, Ended::Proved);
        let best = found.best.objective / scene.stiffness_unit;
        assert!((best - most).abs() <= 1e-9 * most, "{best} instead of {most}, {objective:?}");

        let pieces = Pieces::new(&scene);
        let inner = SpatialSearch::new(rating, &pieces);
        let watched = Watched { inner, pieces: &pieces, all: &all, near: AtomicUsize::new(0) };
        let searched = search(&watched, Leaders::new(1), &Effort::default(), unwatched);
        assert!(searched.nodes > 0);
        near += watched.near.into_inner();
    }
    assert!(answered > 12, "{answered} of 48 can be held");
    assert!(near > 20, "the bounds are of no use: {near} are near");
}
