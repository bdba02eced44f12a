//! What must not change the optimum, and what must order it.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;

use clench_optimize::polygon::{Fingers, Part, fingers, four_fingers_on};
use clench_optimize::{Effort, Ended, Objective, Outcome, Progress, unwatched};
use clench_screw::planar::Frame;
use clench_shape::Polygon;
use clench_testkit::{Random, assert_close};

fn part(corners: &[[f64; 2]], stiffness: &[f64]) -> Part {
    Part::new(Polygon::new(corners).unwrap(), stiffness.to_vec()).unwrap()
}

fn best(part: &Part) -> Outcome<2, 1> {
    fingers(part, &Fingers::new(4), &Effort::default(), unwatched).unwrap()
}

fn top(count: usize) -> Effort {
    Effort { top: NonZeroUsize::new(count).unwrap(), ..Effort::default() }
}

#[test]
fn the_outcome_is_the_same_for_any_number_of_threads() {
    let r = &mut Random::new(51);
    let part = part(&r.convex(14), &[1.0; 14]);
    let gap = Effort { gap: 1e-3, ..Effort::default() };
    let stopped = Effort { nodes: Some(200), ..Effort::default() };
    for (asked, effort) in [
        (Fingers::new(4), top(5)),
        (Fingers { least_share: 0.2, clearance: 0.1, ..Fingers::new(4) }, top(2)),
        (Fingers { objective: Objective::WorstPoint, ..Fingers::new(4) }, gap),
        (Fingers::new(5), gap),
        (Fingers::new(5), stopped),
    ] {
        let outcomes: Vec<_> = [1, 2, 3, 7]
            .iter()
            .map(|&threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                pool.install(|| fingers(&part, &asked, &effort, unwatched).unwrap())
            })
            .collect();
        for outcome in &outcomes {
            assert_eq!(outcome, &outcomes[0], "{asked:?}");
        }
    }
}

#[test]
fn units_by_powers_of_four_change_the_optimum_exactly() {
    let r = &mut Random::new(52);
    for (length, force) in [(4.0, 1.0), (4.0_f64.powi(-15), 4.0), (4.0_f64.powi(15), 0.25)] {
        let (corners, stiffness) = (r.star(6), r.array::<6>(0.5).map(|k| 1.0 + k));
        let scaled: Vec<_> = corners.iter().map(|[x, y]| [x * length, y * length]).collect();
        let one = best(&part(&corners, &stiffness));
        let other = best(&part(&scaled, &stiffness.map(|k| k * force / length)));
        let (a, b) = (&one.best, &other.best);
        assert_eq!(b.quality.value, a.quality.value * force / length);
        assert_eq!(b.center(), a.center() * length);
        for (p, q) in a.placements.iter().zip(&b.placements) {
            assert_eq!((q.on, q.point, q.share), (p.on, p.point * length, p.share));
        }
        assert_eq!(one.combinations, other.combinations);
    }
}

#[test]
fn units_by_powers_of_four_change_searches_that_close_in_exactly() {
    let r = &mut Random::new(57);
    let corners = r.convex(6);
    let effort = Effort { gap: 1e-3, ..Effort::default() };
    for asked in [Fingers { objective: Objective::WorstPoint, ..Fingers::new(4) }, Fingers::new(5)]
    {
        let found = |length: f64, force: f64| {
            let scaled: Vec<_> = corners.iter().map(|c| c.map(|x| x * length)).collect();
            let part = part(&scaled, &[force / length; 6]);
            fingers(&part, &asked, &effort, unwatched).unwrap()
        };
        let one = found(1.0, 1.0);
        for (length, force) in [(4.0_f64.powi(10), 1.0), (4.0_f64.powi(-12), 16.0)] {
            let other = found(length, force);
            let unit = force / length;
            assert_eq!(other.best.objective, one.best.objective * unit);
            assert_eq!(other.certificate.upper_bound, one.certificate.upper_bound * unit);
            assert_eq!(other.combinations, one.combinations);
        }
    }
}

#[test]
fn position_winding_and_first_corner_do_not_matter() {
    let r = &mut Random::new(53);
    for _ in 0..10 {
        let (corners, stiffness) = (r.star(6), r.array::<6>(0.5).map(|k| 1.0 + k));
        let wanted = best(&part(&corners, &stiffness)).best.quality.value;
        let frame = Frame::new(r.array(20.0), r.between(-3.0, 3.0));
        let moved: Vec<_> =
            corners.iter().map(|&c| frame.point_to_parent(c.into()).to_array()).collect();
        let mut turned = corners.clone();
        turned.rotate_left(2);
        let mut turned_stiffness = stiffness;
        turned_stiffness.rotate_left(2);
        let backwards: Vec<_> = corners.iter().rev().copied().collect();
        // Edge e of the reversed outline joins corners 5 - e and 4 - e: edge 4 - e of the other.
        let backward_stiffness: [f64; 6] = std::array::from_fn(|e| stiffness[(10 - e) % 6]);
        for (other, k) in
            [(moved, stiffness), (turned, turned_stiffness), (backwards, backward_stiffness)]
        {
            let found = best(&part(&other, &k)).best.quality.value;
            assert_close(found, wanted, 1e-12, wanted, "quality");
        }
    }
}

#[test]
fn a_corner_in_the_middle_of_an_edge_changes_nothing() {
    let r = &mut Random::new(54);
    for _ in 0..5 {
        let corners = r.convex(5);
        let [a, b] = [corners[0], corners[1]];
        let mut split = corners.clone();
        split.insert(1, [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]);
        let whole = best(&part(&corners, &[1.0; 5])).best.quality.value;
        let halves = best(&part(&split, &[1.0; 6])).best.quality.value;
        // Two fingers on one edge, and a third on it as well, become possible only as limits.
        assert_close(halves, whole, 1e-9, whole, "quality");
    }
}

#[test]
fn the_top_combinations_are_the_best_of_all_combinations() {
    let r = &mut Random::new(55);
    for corners in [4, 5, 6] {
        let part = part(&r.star(corners), &vec![1.0; corners]);
        let mut all = Vec::new();
        for a in 0..corners {
            for b in a..corners {
                for c in b..corners {
                    for d in c..corners {
                        all.extend(four_fingers_on(&part, [a, b, c, d], &Fingers::new(4)).unwrap());
                    }
                }
            }
        }
        all.sort_by(|x, y| y.quality.value.total_cmp(&x.quality.value));
        let found = fingers(&part, &Fingers::new(4), &top(7), unwatched).unwrap();
        assert_eq!(found.solutions().count(), all.len().min(7));
        for (solution, wanted) in found.solutions().zip(&all) {
            let (q, w) = (solution.quality.value, wanted.quality.value);
            assert_close(q, w, 1e-12, w, "rank");
        }
        let (bound, q) = (found.certificate.upper_bound, found.best.quality.value);
        assert!(bound >= q);
        assert_close(bound, q, 1e-13, q, "bound");
    }
}

/// The hexagon's rotations and reflections carry one optimum to others, and the first is reported.
#[test]
fn ties_are_broken_by_the_numbers_of_the_edges() {
    let angles = (0..6).map(|i| f64::from(i) * std::f64::consts::FRAC_PI_3);
    let hexagon: Vec<_> = angles.map(|a| [a.cos(), a.sin()]).collect();
    let part = part(&hexagon, &[1.0; 6]);
    let outcome = fingers(&part, &Fingers::new(4), &top(12), unwatched).unwrap();
    let best = &outcome.best;
    let tied: Vec<_> = outcome
        .solutions()
        .filter(|s| (s.quality.value / best.quality.value - 1.0).abs() < 1e-12)
        .filter(|s| (s.quality.equivalent() / best.quality.equivalent() - 1.0).abs() < 1e-12)
        .map(clench_optimize::Solution::touched)
        .collect();
    assert!(tied.len() >= 3 && tied.is_sorted(), "{tied:?}");
}

#[test]
fn progress_closes_in_on_the_optimum() {
    let r = &mut Random::new(56);
    let part = part(&r.star(12), &[1.0; 12]);
    let mut seen = Vec::new();
    let watch = |p: &Progress| {
        seen.push(*p);
        ControlFlow::Continue(())
    };
    let outcome = fingers(&part, &Fingers::new(4), &Effort::default(), watch).unwrap();
    let best = outcome.best.objective;
    assert!(seen.len() > 2, "{}", seen.len());
    for pair in seen.windows(2) {
        assert!(pair[0].nodes < pair[1].nodes && pair[0].best <= pair[1].best);
        assert!(pair[0].upper_bound >= pair[1].upper_bound && pair[0].elapsed <= pair[1].elapsed);
    }
    assert!(seen.iter().all(|p| p.open > 0 && p.upper_bound >= best * (1.0 - 1e-12)));
    assert_eq!(outcome.certificate.ended, Ended::Proved);
    assert!((outcome.combinations.examined as f64) < outcome.combinations.total);
}
