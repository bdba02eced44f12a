//! The optimum of the search is that of plain enumeration.

use clench_testkit::{Random, assert_close};

use super::{each_set, enumerated, part, question, restricted};
use crate::Objective;
use crate::polygon::scene::Scene;
use crate::polygon::springs::Springs;
use crate::polygon::triplets::Triplets;
use crate::polygon::{Fingers, ThreeFingers, fingers, three_fingers};
use crate::search::{Floor, Leaders};
use crate::{Effort, Ended, OptimizeError, unwatched};

/// Enough for each family of outlines to come with each condition and objective.
const OUTLINES: usize = 1000;

#[test]
fn the_search_finds_what_plain_enumeration_finds() {
    let r = &mut Random::new(71);
    let (mut held, mut conditions) = (0, 0);
    for round in 0..OUTLINES {
        let n = match round % 50 {
            0 => 15 + r.below(16),
            1..=6 => 9 + r.below(6),
            _ => 3 + r.below(6),
        };
        let mut part = part(r, n);
        // Half of them as they are, half under conditions.
        let mut asked = Fingers::new(4);
        if round % 2 == 1 {
            asked = question(r);
            if r.below(2) == 0 {
                part = restricted(r, part);
            }
        }
        let what = format!("round {round}: {:?} {asked:?}", part.outline().corners());
        let scene = Scene::checked(&part).unwrap();
        let wanted = enumerated(Springs { scene: &scene, fingers: &asked }, scene.supports.len());
        let found = fingers(&part, &asked, &Effort::default(), unwatched);
        match (wanted, found) {
            (Some((quality, second)), Ok(found)) => {
                let unit = scene.stiffness_unit;
                let best = &found.best;
                if asked.least_distance() > 0.0 && best.objective > quality * unit * (1.0 + 1e-9) {
                    // On a combination whose best are too near to each other: see `tips.rs`.
                    continue;
                }
                assert_close(best.objective, quality * unit, 1e-9, quality * unit, &what);
                let among_ties = match asked.objective {
                    Objective::Rotation { .. } => best.quality.translational,
                    _ => best.quality.equivalent(),
                };
                assert_close(among_ties, second * unit, 1e-9, second * unit, &what);
                if asked.least_distance() <= 0.0 {
                    assert_eq!(found.certificate.ended, Ended::Proved, "{what}");
                }
                held += 1;
                conditions += round % 2;
            }
            (None, Err(error)) => assert!(
                matches!(
                    error,
                    OptimizeError::NormalsNeverBalance { .. }
                        | OptimizeError::TorquesNeverBalance { .. }
                        | OptimizeError::ConditionsNeverMet { .. }
                ),
                "{error} {what}"
            ),
            (None, Ok(_)) if asked.least_distance() > 0.0 => {}
            // Thin parts hold less than rounding can tell.
            (_, Err(OptimizeError::OutOfRange { .. })) => {}
            (wanted, found) => panic!("{wanted:?} {found:?} {what}"),
        }
    }
    assert!(held > OUTLINES / 2 && conditions > OUTLINES / 4, "{held} {conditions}");
}

#[test]
fn three_fingers_are_those_of_plain_enumeration() {
    let r = &mut Random::new(72);
    let mut held = 0;
    for round in 0..OUTLINES {
        let size = 3 + r.below(if round % 10 == 0 { 28 } else { 10 });
        let part = part(r, size);
        let asked = ThreeFingers {
            finger_radius: [0.0, 0.3][r.below(2)],
            least_share: [0.0, r.between(0.0, 0.3)][r.below(2)],
            ..ThreeFingers::with_preload(10.0_f64.powf(r.between(-3.0, 1.0)))
        };
        let what = format!("round {round}: {:?} {asked:?}", part.outline().corners());
        let scene = Scene::checked(&part).unwrap();
        let triplets = Triplets::new(&scene, &asked);
        let mut wanted = Leaders::new(1);
        each_set::<3>(scene.supports.len(), |set| {
            wanted.merge(triplets.solve(set, &Floor::NONE));
        });
        let wanted = wanted.candidates().first().map(|best| best.quality * scene.stiffness_unit);
        match (wanted, three_fingers(&part, &asked, &Effort::default(), unwatched)) {
            (Some(wanted), Ok(found)) => {
                assert_close(found.best.objective, wanted, 1e-9, wanted, &what);
                held += 1;
            }
            (None, Err(_)) | (_, Err(OptimizeError::OutOfRange { .. })) => {}
            (wanted, found) => panic!("{wanted:?} {found:?} {what}"),
        }
    }
    assert!(held > OUTLINES / 3, "{held}");
}
