//! Fingers with tips that need room, against all combinations of candidates.

use clench_screw::Vector;
use clench_testkit::Random;

use super::enumeration::all;
use super::{OBJECTIVES, part, rating, touch};
use crate::polyhedron::scene::Scene;
use crate::polyhedron::{Fingers, Spacing, Touch, fingers_among};
use crate::{Effort, Ended, OptimizeError, unwatched};

#[test]
fn the_search_finds_the_best_of_all_combinations_that_keep_a_clearance() {
    let mut r = Random::new(63);
    let (mut answered, mut changed) = (0, 0);
    for round in 0..96 {
        let part = part(&mut r, [0, 3, 4, 5][round % 4]);
        let candidates: Vec<Touch> = (0..13 + r.below(3)).map(|_| touch(&mut r, &part)).collect();
        let fixed: Vec<Touch> = (0..round % 3).map(|_| touch(&mut r, &part)).collect();
        let mut radii = |count: usize| (0..count).map(|_| r.between(0.0, 0.2)).collect::<Vec<_>>();
        let (given, each) = (radii(fixed.len()), radii(candidates.len()));
        let spacing = Spacing {
            radius: 0.1,
            clearance: r.between(0.0, 0.4),
            given: given.clone(),
            // One candidate has the radius of those that are placed.
            candidates: each[1..].to_vec(),
        };
        let each: Vec<f64> = each[1..].iter().copied().chain([0.1]).collect();
        let objective = OBJECTIVES[round / 4 % 4];
        let free = Fingers { objective, fixed, roundness: 0.0, ..Fingers::new(7) };
        let body = part.solid().extreme_points();
        let Ok(scene) = Scene::of_candidates(body, &candidates, &free) else { continue };
        let center = |touch: &Touch, radius: f64| touch.point - touch.inward_normal * radius;
        let placed: Vec<(Vector<3>, f64)> =
            candidates.iter().zip(&each).map(|(t, &radius)| (center(t, radius), radius)).collect();
        let given: Vec<(Vector<3>, f64)> =
            free.fixed.iter().zip(&given).map(|(t, &radius)| (center(t, radius), radius)).collect();
        let apart = |(x, a): (Vector<3>, f64), (y, b): (Vector<3>, f64)| {
            (x - y).norm() >= a + b + spacing.clearance
        };
        let keeps = |set: &[usize; 7]| {
            (0..7).all(|i| {
                let one = placed[set[i]];
                set[..i].iter().all(|&j| apart(one, placed[j]))
                    && given.iter().all(|&other| apart(one, other))
            })
        };
        let every = all(rating(&scene, &free));
        let largest = |sets: &mut dyn Iterator<Item = f64>| sets.fold(f64::NEG_INFINITY, f64::max);
        let most = largest(&mut every.iter().filter(|(set, _)| keeps(set)).map(|found| found.1));
        let loose = largest(&mut every.iter().map(|found| found.1));
        let asked = Fingers { spacing: spacing.clone(), ..free.clone() };
        let found = fingers_among(body, &candidates, &asked, &Effort::default(), unwatched);
        if most < 0.0 {
            let none = matches!(
                found,
                Err(OptimizeError::ConditionsNeverMet { .. } | OptimizeError::AlwaysEscapes { .. })
            );
            assert!(none, "round {round}: {found:?}");
            continue;
        }
        answered += 1;
        changed += usize::from(most < loose * (1.0 - 1e-9));
        let found = found.unwrap();
        assert_eq!(found.certificate.ended, Ended::Proved);
        let best = found.best.objective / scene.stiffness_unit;
        assert!((best - most).abs() <= 1e-9 * most, "round {round}: {best} instead of {most}");
        let mut set: Vec<usize> = found.best.placements.iter().map(|p| p.on).collect();
        set.sort_unstable();
        assert!(keeps(&set.try_into().unwrap()), "round {round}");
    }
    assert!(answered > 12 && changed > 6, "{answered} answered, {changed} changed");
}
