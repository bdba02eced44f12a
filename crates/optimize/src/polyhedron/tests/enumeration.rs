//! The search among candidates against all combinations of them.

use clench_testkit::Random;

use super::{OBJECTIVES, part, rating, touch};
use crate::polyhedron::bound::{Pieces, Relaxation};
use crate::polyhedron::rating::{Rating, Spot, Worth};
use crate::polyhedron::scene::Scene;
use crate::polyhedron::{Fingers, Touch, fingers_among};
use crate::search::{Floor, Piece};
use crate::{Effort, Ended, OptimizeError, unwatched};

/// What all combinations of seven candidates are worth, if they hold.
fn all(rating: Rating<'_>) -> Vec<([usize; 7], f64)> {
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

/// A node by chance: pieces that each come from halving the whole.
fn node(r: &mut Random, pieces: &Pieces<'_>) -> [Piece; 7] {
    let mut node = std::array::from_fn(|_| {
        let mut piece = Piece::BOUNDARY;
        for _ in 0..r.below(4) {
            let Some(halves) = pieces.halves(piece) else { break };
            piece = halves[r.below(2)];
        }
        piece
    });
    node.sort_unstable();
    node
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
        let relaxation = Relaxation::new(rating, &pieces);
        for _ in 0..60 {
            let node = node(&mut r, &pieces);
            let under = all.iter().find(|(set, _)| is_under(&pieces, &node, set, 0, 0));
            let floor = Floor { quality: most * r.between(0.0, 1.0), second: 0.0 };
            let bound = relaxation.bound(&node, &floor, None).map(|bounded| bounded.bound);
            let Some(&(set, quality)) = under.filter(|(_, quality)| *quality > floor.quality)
            else {
                continue;
            };
            let bound = bound.unwrap_or_else(|| panic!("{set:?} with {quality} was excluded"));
            assert!(bound >= quality * (1.0 - 1e-11), "{bound} < {quality} of {set:?}");
            near += usize::from(bound < 2.0 * quality);
        }
    }
    assert!(answered > 12, "{answered} of 48 can be held");
    assert!(near > 20, "the bounds are of no use: {near} are near");
}
