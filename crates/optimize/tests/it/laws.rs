//! What must not change the optimum, and what must order it.

use std::num::NonZeroUsize;

use clench_optimize::Outcome;
use clench_optimize::polygon::{
    FourFingers, Part, ThreeFingers, four_fingers, four_fingers_on, three_fingers,
};
use clench_screw::planar::Frame;
use clench_shape::Polygon;
use clench_testkit::{Random, assert_close};

fn part(corners: &[[f64; 2]], stiffness: &[f64]) -> Part {
    Part::new(Polygon::new(corners).unwrap(), stiffness.to_vec()).unwrap()
}

fn best(part: &Part) -> Outcome {
    four_fingers(part, &FourFingers::default(), |_| {}).unwrap()
}

fn top(count: usize) -> FourFingers {
    FourFingers { top: NonZeroUsize::new(count).unwrap() }
}

#[test]
fn the_outcome_is_the_same_for_any_number_of_threads() {
    let r = &mut Random::new(51);
    let part = part(&r.convex(14), &[1.0; 14]);
    let outcomes: Vec<_> = [1, 2, 3, 7]
        .iter()
        .map(|&threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| four_fingers(&part, &top(5), |_| {}).unwrap())
        })
        .collect();
    for outcome in &outcomes {
        assert_eq!(outcome, &outcomes[0]);
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
            assert_eq!((q.edge, q.point, q.share), (p.edge, p.point * length, p.share));
        }
        assert_eq!(one.combinations, other.combinations);
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
                        all.extend(four_fingers_on(&part, [a, b, c, d]).unwrap());
                    }
                }
            }
        }
        all.sort_by(|x, y| y.quality.value.total_cmp(&x.quality.value));
        let found = four_fingers(&part, &top(7), |_| {}).unwrap();
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

#[test]
fn symmetric_parts_count_their_ties() {
    let angles = (0..6).map(|i| f64::from(i) * std::f64::consts::FRAC_PI_3);
    let hexagon: Vec<_> = angles.map(|a| [a.cos(), a.sin()]).collect();
    let outcome = four_fingers(&part(&hexagon, &[1.0; 6]), &top(12), |_| {}).unwrap();
    let qualities: Vec<f64> = outcome.solutions().map(|s| s.quality.value).collect();
    let quality = |i: usize| qualities[i];
    let equal = (1..12).take_while(|&i| (quality(i) - quality(0)).abs() <= 1e-12).count();
    // The hexagon's rotations and reflections carry one optimum to others.
    assert!(outcome.ties >= 2 && outcome.ties == equal, "{} {equal}", outcome.ties);

    let triangle = [[0.0, 0.0], [2.0, 0.0], [1.0, 3.0_f64.sqrt()]];
    let three =
        three_fingers(&part(&triangle, &[1.0; 3]), &ThreeFingers::with_preload(0.1), |_| {});
    assert_eq!(three.unwrap().ties, 0);
}

#[test]
fn progress_ends_with_everything_settled() {
    let r = &mut Random::new(56);
    let part = part(&r.star(12), &[1.0; 12]);
    let mut seen = Vec::new();
    let outcome = four_fingers(&part, &FourFingers::default(), |p| seen.push(*p)).unwrap();
    let last = seen.last().unwrap();
    assert_eq!((last.settled, last.total), (last.total, outcome.combinations.total));
    assert!(seen.windows(2).all(|w| w[0].settled < w[1].settled && w[0].best <= w[1].best));
    assert!(outcome.combinations.examined < outcome.combinations.total);
}
