//! No bound is below what is under it.

use clench_testkit::Random;

use super::{each_set, enumerated, node, part, question, restricted};
use crate::Objective;
use crate::polygon::rating::{Spot, moments, rate};
use crate::polygon::scene::Scene;
use crate::polygon::springs::{SpringSearch, Springs};
use crate::polygon::triplets::{TripletSearch, Triplets};
use crate::polygon::{Fingers, ThreeFingers};
use crate::search::{Floor, Piece, Problem};

/// A floor from none to about the best.
fn floor(r: &mut Random, best: (f64, f64)) -> Floor {
    match r.below(4) {
        0 => Floor::NONE,
        1 => Floor { quality: best.0, second: best.1 },
        _ => {
            let quality = r.between(0.0, 1.0) * best.0;
            Floor { quality, second: quality.max(r.between(0.0, 1.0) * best.1) }
        }
    }
}

/// What a bound says of a placement on its node: it is not above, or does not exceed the floor.
fn assert_bounded(bound: Option<f64>, floor: &Floor, (quality, second): (f64, f64), what: &str) {
    match bound {
        // The last digits of a placement are not those of its bound.
        Some(bound) => {
            let limit = bound.max(floor.quality) * (1.0 + 1e-11);
            assert!(quality <= limit, "{quality} above {bound}: {what}");
        }
        None => assert!(
            !floor.is_exceeded_by(quality * (1.0 - 1e-11), second * (1.0 - 1e-11)),
            "{quality}, {second} excluded by {floor:?}: {what}"
        ),
    }
}

#[test]
fn no_bound_is_below_the_best_of_the_combinations_under_it() {
    let r = &mut Random::new(73);
    let (mut compared, mut close) = (0, 0);
    for _ in 0..150 {
        let size = 4 + r.below(8);
        let mut part = part(r, size);
        let asked = question(r);
        if r.below(2) == 0 {
            part = restricted(r, part);
        }
        let what = format!("{:?} {asked:?}", part.outline().corners());
        let scene = Scene::checked(&part).unwrap();
        let springs = Springs { scene: &scene, fingers: &asked };
        let search = SpringSearch::new(springs);
        let Some(best) = enumerated(springs, scene.supports.len()) else { continue };
        for _ in 0..30 {
            let pieces: [Piece; 4] = node(r, &search.pieces, false);
            let floor = floor(r, best);
            let bound = search.bound(&pieces, &floor, None).map(|b| b.bound);
            let ranges = pieces.map(|piece| search.pieces.stretches(piece));
            let mut under = (0.0, 0.0);
            each_set::<4>(scene.supports.len(), |set| {
                if !covers(&ranges, set) {
                    return;
                }
                let found = springs.solve(set, &Floor::NONE);
                if let Some(found) = found.filter(|found| !springs.is_crowded(found)) {
                    assert_bounded(bound, &floor, (found.quality, found.second), &what);
                    compared += 1;
                    under =
                        if found.quality > under.0 { (found.quality, found.second) } else { under };
                }
            });
            close += usize::from(bound.is_some_and(|bound| bound < 1.2 * under.0));
        }
    }
    assert!(compared > 10_000 && close > 100, "{compared} {close}");
}

/// Whether fingers on the stretches of `set` can be dealt to the ranges, one each.
fn covers<const K: usize>(ranges: &[&[usize]; K], set: [usize; K]) -> bool {
    fn deal(ranges: &[&[usize]], rest: &[usize]) -> bool {
        let Some((first, others)) = ranges.split_first() else { return true };
        (0..rest.len()).any(|i| {
            let mut left = rest.to_vec();
            first.contains(&left.remove(i)) && deal(others, &left)
        })
    }
    deal(ranges, &set)
}

/// For more fingers and the worst point, where no combination is solved: placements by chance.
#[test]
fn no_bound_is_below_a_placement_under_it() {
    fn check<const K: usize>(r: &mut Random) -> usize {
        let size = 4 + r.below(8);
        let part = part(r, size);
        let asked = Fingers {
            objective: [Objective::Quality, Objective::WorstPoint][r.below(2)],
            least_share: [0.0, r.between(0.0, 0.1)][r.below(2)],
            finger_radius: [0.0, r.between(0.0, 1.0)][r.below(2)],
            clearance: [0.0, r.between(0.0, 1.0)][r.below(2)],
            ..Fingers::new(K)
        };
        let what = format!("{:?} {asked:?}", part.outline().corners());
        let scene = Scene::checked(&part).unwrap();
        let springs = Springs { scene: &scene, fingers: &asked };
        let search = SpringSearch::new(springs);
        let mut compared = 0;
        for _ in 0..10 {
            let pieces: [Piece; K] = node(r, &search.pieces, true);
            let mut rated = Vec::new();
            for _ in 0..300 {
                let spots = pieces.map(|piece| {
                    let stretches = search.pieces.stretches(piece);
                    let (from, to) = piece.along();
                    let along = [from, to, r.between(from, to)][r.below(3)];
                    Spot { stretch: stretches[r.below(stretches.len())], along }
                });
                let stretches = spots.map(|spot: Spot| spot.stretch);
                let moments = moments(&scene, &spots);
                rated.extend(rate(&scene, &asked, &stretches, &moments, |_| true));
            }
            let qualities: Vec<_> = rated.iter().map(|rating| springs.objectives(rating)).collect();
            let best =
                qualities.iter().copied().fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a });
            for floor in [Floor::NONE, floor(r, best), floor(r, best)] {
                let bound = search.bound(&pieces, &floor, None).map(|b| b.bound);
                for &quality in &qualities {
                    assert_bounded(bound, &floor, quality, &what);
                    compared += 1;
                }
            }
        }
        compared
    }
    let r = &mut Random::new(74);
    let mut compared = [0; 3];
    for _ in 0..60 {
        compared[0] += check::<4>(r);
        compared[1] += check::<5>(r);
        compared[2] += check::<6>(r);
    }
    assert!(compared.iter().all(|&count| count > 1000), "{compared:?}");
}

#[test]
fn no_bound_on_triplets_is_below_the_best_under_it() {
    let r = &mut Random::new(75);
    let mut compared = 0;
    for _ in 0..300 {
        let size = 4 + r.below(12);
        let part = part(r, size);
        let asked = ThreeFingers {
            finger_radius: [0.0, 0.3][r.below(2)],
            least_share: [0.0, r.between(0.0, 0.3)][r.below(2)],
            ..ThreeFingers::with_preload(10.0_f64.powf(r.between(-2.0, 1.0)))
        };
        let what = format!("{:?} {asked:?}", part.outline().corners());
        let scene = Scene::checked(&part).unwrap();
        let triplets = Triplets::new(&scene, &asked);
        let search = TripletSearch::new(triplets);
        for _ in 0..20 {
            let pieces: [Piece; 3] = node(r, &search.springs, false);
            let ranges = pieces.map(|piece| search.springs.stretches(piece));
            let mut under = Vec::new();
            each_set::<3>(scene.supports.len(), |set| {
                if covers(&ranges, set) {
                    under.extend(triplets.solve(set, &Floor::NONE).map(|f| (f.quality, f.second)));
                }
            });
            let best = under.iter().copied().fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a });
            for floor in [Floor::NONE, floor(r, best)] {
                let bound = search.bound(&pieces, &floor, None).map(|b| b.bound);
                for &quality in &under {
                    assert_bounded(bound, &floor, quality, &what);
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 2000, "{compared}");
}
