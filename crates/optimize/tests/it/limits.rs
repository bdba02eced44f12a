//! Questions without an answer, and parts at the edge of what has one.

use std::ops::ControlFlow;
use std::time::Duration;

use clench_optimize::polygon::{
    FEWEST_FINGERS, Fingers, LARGEST_SPREAD, MOST_FINGERS, Part, Stretch, ThreeFingers, fingers,
    four_fingers_on, three_fingers, three_fingers_on,
};
use clench_optimize::{
    Effort, Ended, Objective, OptimizeError, Outcome, Placement, Progress, unwatched,
};
use clench_screw::Vector;
use clench_shape::Polygon;
use clench_testkit::{Random, assert_close};

const RECTANGLE: [[f64; 2]; 4] = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]];

fn rectangle() -> Part {
    Part::uniform(Polygon::new(&RECTANGLE).unwrap(), 1.0).unwrap()
}

#[test]
fn each_edge_needs_one_positive_stiffness() {
    let outline = || Polygon::new(&RECTANGLE).unwrap();
    let fault = Part::new(outline(), vec![1.0; 3]).unwrap_err();
    assert_eq!(fault, OptimizeError::StiffnessCount { found: 3, sides: 4 });
    for value in [0.0, -1.0, f64::INFINITY] {
        let fault = Part::new(outline(), vec![1.0, 1.0, value, 1.0]).unwrap_err();
        assert_eq!(fault, OptimizeError::Stiffness { side: 2, value });
    }
    let fault = Part::uniform(outline(), f64::NAN).unwrap_err();
    assert!(matches!(fault, OptimizeError::Stiffness { side: 0, value } if value.is_nan()));
}

#[test]
fn three_fingers_need_a_preload_and_a_radius() {
    for value in [0.0, -1.0, f64::INFINITY] {
        let fault = three_fingers(
            &rectangle(),
            &ThreeFingers::with_preload(value),
            &Effort::default(),
            unwatched,
        )
        .unwrap_err();
        assert_eq!(fault, OptimizeError::TotalPreload { value });
    }
    let options = ThreeFingers { finger_radius: -0.5, ..ThreeFingers::with_preload(1.0) };
    let fault = three_fingers(&rectangle(), &options, &Effort::default(), unwatched).unwrap_err();
    assert_eq!(fault, OptimizeError::FingerRadius { value: -0.5 });
}

#[test]
fn edges_that_do_not_exist_are_refused() {
    let fault = four_fingers_on(&rectangle(), [0, 1, 2, 4], &Fingers::new(4)).unwrap_err();
    assert_eq!(fault, OptimizeError::NoSuchEdge { edge: 4, last: 3 });
    let options = ThreeFingers::with_preload(1.0);
    let fault = three_fingers_on(&rectangle(), [9, 1, 2], &options).unwrap_err();
    assert_eq!(fault, OptimizeError::NoSuchEdge { edge: 9, last: 3 });
}

#[test]
fn three_fingers_cannot_hold_a_rectangle() {
    let fault = three_fingers(
        &rectangle(),
        &ThreeFingers::with_preload(1.0),
        &Effort::default(),
        unwatched,
    )
    .unwrap_err();
    assert_eq!(fault, OptimizeError::NormalsNeverBalance { fingers: 3, combinations: 4.0 });
    assert!(fault.to_string().contains("no placement of 3 frictionless fingers"));
}

/// A bent strip: the normals of two triplets balance, but none has a point that all three face.
#[test]
fn three_fingers_need_a_point_where_their_normals_meet() {
    let strip = [[2.0, 5.0], [5.0, 2.0], [6.0, 0.0], [5.0, 1.0], [1.0, 5.0], [1.0, 6.0]];
    let part = Part::uniform(Polygon::new(&strip).unwrap(), 1.0).unwrap();
    let fault =
        three_fingers(&part, &ThreeFingers::with_preload(1.0), &Effort::default(), unwatched)
            .unwrap_err();
    assert_eq!(fault, OptimizeError::TorquesNeverBalance { fingers: 3, combinations: 20.0 });
}

#[test]
fn stiffnesses_of_any_size_but_not_of_any_ratio_are_taken() {
    let outline = || Polygon::new(&RECTANGLE).unwrap();
    let quality = |k: f64| {
        let part = Part::uniform(outline(), k).unwrap();
        fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap().best.quality.value
    };
    for k in [1e-200, 1e200, 1e300] {
        assert!((quality(k) / k - quality(1.0)).abs() <= 1e-12 * quality(1.0), "{k:e}");
    }
    let fault = Part::new(outline(), vec![1e10, 1.0, 1.0, 2.0]).unwrap_err();
    let (smallest, largest, limit) = (1.0, 1e10, LARGEST_SPREAD);
    assert_eq!(fault, OptimizeError::StiffnessSpread { smallest, largest, limit });
}

/// So flat that its stiffness across is lost beside the one along: refused, not called free.
#[test]
fn a_needle_beyond_rounding_is_too_thin() {
    for height in [3e-8, 1e-7] {
        let needle = Polygon::new(&[[0.0, 0.0], [1.0, 0.0], [0.4, height]]).unwrap();
        let part = Part::uniform(needle, 1.0).unwrap();
        for count in [4, 5] {
            let asked = Fingers::new(count);
            let fault = fingers(&part, &asked, &Effort::default(), unwatched).unwrap_err();
            assert!(matches!(fault, OptimizeError::TooThin { .. }), "{height:e}: {fault:?}");
        }
    }
}

/// A rotational stiffness above the largest number.
#[test]
fn numbers_that_overflow_are_out_of_range() {
    let corners = RECTANGLE.map(|c| c.map(|x| x * 1e10));
    let part = Part::uniform(Polygon::new(&corners).unwrap(), 1e300).unwrap();
    let fault = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap_err();
    assert!(matches!(fault, OptimizeError::OutOfRange { .. }), "{fault:?}");
}

/// On a square of side 2 with `k = 1`, fingers at one end of each side, all turning the same way
/// round, are 1 from the center: `mu = 4`, `rho^2 = 2`, both stiffnesses 2.
#[test]
fn a_square_is_held_at_its_corners() {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let part = Part::uniform(Polygon::new(&square).unwrap(), 1.0).unwrap();
    let outcome = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap();
    let best = &outcome.best;
    assert!((best.quality.value - 2.0).abs() < 1e-14);
    assert!((best.quality.equivalent() - 2.0).abs() < 1e-14);
    assert_eq!(best.touched(), [0, 1, 2, 3]);
    assert_eq!(outcome.combinations.total, 35.0);
}

/// Two fingers on each of two edges, or three on one, never close.
#[test]
fn crowded_edges_never_close() {
    for edges in [[0, 0, 2, 2], [0, 0, 0, 2], [1, 1, 1, 1], [0, 0, 1, 2]] {
        assert_eq!(
            four_fingers_on(&rectangle(), edges, &Fingers::new(4)).unwrap(),
            None,
            "{edges:?}"
        );
    }
}

#[test]
fn slivers_and_extreme_sizes_have_an_optimum() {
    for size in [1e-9, 1.0, 1e9] {
        for sliver in [1.0, 1e-3, 1e-6] {
            let corners = [[0.0, 0.0], [size, 0.0], [0.4 * size, sliver * size]];
            let part = Part::uniform(Polygon::new(&corners).unwrap(), 2.0).unwrap();
            let four = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap();
            assert!(four.best.quality.value > 0.0);
            let three = three_fingers(
                &part,
                &ThreeFingers::with_preload(1e-3 * size),
                &Effort::default(),
                unwatched,
            )
            .unwrap();
            assert!(three.best.quality.value > 0.0);
        }
    }
}

/// The rounder the outline, the less it can be held against rotation.
#[test]
fn regular_polygons_get_harder_to_hold_with_more_corners() {
    let quality = |n: u32| {
        let angle = |i| std::f64::consts::TAU * f64::from(i) / f64::from(n);
        let corners: Vec<_> = (0..n).map(|i| [angle(i).cos(), angle(i).sin()]).collect();
        let part = Part::uniform(Polygon::new(&corners).unwrap(), 1.0).unwrap();
        fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap().best.quality
    };
    let (six, twenty_four, forty_eight) = (quality(6), quality(24), quality(48));
    assert!(six.value > twenty_four.value && twenty_four.value > forty_eight.value);
    // mu is of the order of the squared half side, (pi / n)^2.
    let ratio = twenty_four.value / forty_eight.value;
    assert!((3.9..4.1).contains(&ratio), "{ratio}");
}

#[test]
fn questions_that_make_no_sense_are_refused() {
    let ask = |asked: Fingers, effort: Effort| {
        fingers(&rectangle(), &asked, &effort, unwatched).unwrap_err()
    };
    let four = Fingers::new(4);
    for found in [0, 3, 9] {
        let (fewest, most) = (FEWEST_FINGERS, MOST_FINGERS);
        let fault = ask(Fingers { count: found, ..four }, Effort::default());
        assert_eq!(fault, OptimizeError::FingerCount { found, fewest, most });
    }
    for value in [-1.0, 1e131, f64::INFINITY] {
        let fault = ask(Fingers { finger_radius: value, ..four }, Effort::default());
        assert_eq!(fault, OptimizeError::FingerRadius { value });
        let asked = ThreeFingers { finger_radius: value, ..ThreeFingers::with_preload(1.0) };
        let fault = three_fingers(&rectangle(), &asked, &Effort::default(), unwatched);
        assert_eq!(fault.unwrap_err(), OptimizeError::FingerRadius { value });
    }
    // As large as can be they overlap each other on any part.
    let asked = Fingers { finger_radius: 1e130, ..four };
    let fault = ask(asked, Effort::default());
    assert_eq!(fault, OptimizeError::ConditionsNeverMet { fingers: 4, combinations: 35.0 });
    for value in [-1.0, f64::INFINITY] {
        let fault = ask(Fingers { clearance: value, ..four }, Effort::default());
        assert_eq!(fault, OptimizeError::Clearance { value });
        let objective = Objective::Rotation { least_translation: value };
        let fault = ask(Fingers { objective, ..four }, Effort::default());
        assert_eq!(fault, OptimizeError::LeastTranslation { value });
        let fault = ask(four, Effort { gap: value, ..Effort::default() });
        assert_eq!(fault, OptimizeError::Gap { value });
        assert_eq!(rectangle().with_margin(value).unwrap_err(), OptimizeError::Margin { value });
    }
    for value in [-0.1, 0.25, 1.0] {
        let fault = ask(Fingers { least_share: value, ..four }, Effort::default());
        assert_eq!(fault, OptimizeError::LeastShare { value, limit: 0.25 });
    }
    let asked = ThreeFingers { least_share: 0.5, ..ThreeFingers::with_preload(1.0) };
    let fault = three_fingers(&rectangle(), &asked, &Effort::default(), unwatched).unwrap_err();
    assert_eq!(fault, OptimizeError::LeastShare { value: 0.5, limit: 1.0 / 3.0 });
    let fault = rectangle().without_edge(4).unwrap_err();
    assert_eq!(fault, OptimizeError::NoSuchEdge { edge: 4, last: 3 });
    let (edge, from, to) = (1, 0.5, 0.5);
    let fault = rectangle().without(Stretch { edge, from, to }).unwrap_err();
    assert_eq!(fault, OptimizeError::Stretch { edge, from, to });
    let fault = ask(Fingers { least_share: f64::NAN, ..four }, Effort::default());
    assert!(matches!(fault, OptimizeError::LeastShare { value, .. } if value.is_nan()));
}

#[test]
fn given_edges_are_for_four_fingers_and_closed_forms() {
    let on = |asked: Fingers| four_fingers_on(&rectangle(), [0, 1, 2, 3], &asked);
    let fault = on(Fingers::new(5)).unwrap_err();
    assert_eq!(fault, OptimizeError::FingerCount { found: 5, fewest: 4, most: 4 });
    let worst_point = Fingers { objective: Objective::WorstPoint, ..Fingers::new(4) };
    assert_eq!(on(worst_point).unwrap_err(), OptimizeError::NoClosedForm);
    let rotation = Objective::Rotation { least_translation: 1.0 };
    let found = on(Fingers { objective: rotation, ..Fingers::new(4) }).unwrap().unwrap();
    assert_eq!(found.objective, found.quality.equivalent());
}

/// A half disc with a bore, both flattened to edges that are shorter than the margin: it counts
/// along the boundary from the two real corners, wherever the numbers of edges begin.
#[test]
fn margins_count_from_real_corners_along_flattened_curves() {
    let arc = |radius: f64, turn: f64, steps: i32| {
        let at = move |i: i32| turn * f64::from(i) / f64::from(steps);
        (0..=steps).map(move |i| [radius * at(i).cos(), radius * at(i).sin()])
    };
    let half: Vec<[f64; 2]> = arc(10.0, std::f64::consts::PI, 90).collect();
    let bore: Vec<[f64; 2]> =
        arc(1.0, std::f64::consts::TAU, 24).skip(1).map(|[x, y]| [x, y + 5.0]).collect();
    let margin = 2.0;
    for first in [0, 1, 45, 90] {
        let mut corners = half.clone();
        corners.rotate_left(first);
        if first == 45 {
            corners.reverse();
        }
        let outline = Polygon::with_holes(&corners, std::slice::from_ref(&bore)).unwrap();
        let whole: f64 = outline.edges().iter().map(clench_shape::Edge::length).sum();
        let part = Part::uniform(outline, 1.0).unwrap().with_margin(margin).unwrap();
        let left: f64 = part.stretches().iter().map(|s| s.to - s.from).sum();
        assert_close(left, whole - 4.0 * margin, 1e-12, whole, "what is left");
        for Stretch { edge, from, to } in part.stretches() {
            for along in [from, to] {
                let point = part.outline().edges()[*edge].point_at(*along);
                let corner = |x: f64| (point - Vector::new([x, 0.0])).norm();
                // On the arc the way is longer than straight, by its cube over 24 r^2.
                assert!(corner(10.0).min(corner(-10.0)) >= margin - 0.01, "{edge} {along}");
            }
        }
    }
}

#[test]
fn a_part_that_may_be_touched_nowhere_has_no_answer() {
    // Half of the shorter side is the longer margin that leaves something.
    let part = rectangle().with_margin(1.5).unwrap();
    assert!(part.stretches().is_empty());
    let fault = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap_err();
    assert_eq!(fault, OptimizeError::NowhereToTouch);
    let asked = ThreeFingers::with_preload(1.0);
    let fault = three_fingers(&part, &asked, &Effort::default(), unwatched).unwrap_err();
    assert_eq!(fault, OptimizeError::NowhereToTouch);
}

/// On a rectangle `sigma_min` is at most 2 with four fingers of stiffness 1.
#[test]
fn conditions_that_cannot_be_met_are_told_from_parts_that_cannot_be_held() {
    let objective = Objective::Rotation { least_translation: 2.1 };
    let asked = Fingers { objective, ..Fingers::new(4) };
    let fault = fingers(&rectangle(), &asked, &Effort::default(), unwatched).unwrap_err();
    assert_eq!(fault, OptimizeError::ConditionsNeverMet { fingers: 4, combinations: 35.0 });
}

#[test]
fn conditions_cost_quality_until_nothing_fits() {
    let quality = |asked: Fingers| {
        let corners = [[0.0, 0.0], [3.0, 0.0], [2.5, 1.0], [0.0, 1.0]];
        let slanted = Part::uniform(Polygon::new(&corners).unwrap(), 1.0).unwrap();
        let found = fingers(&slanted, &asked, &Effort::default(), unwatched)?;
        assert!(matches!(found.certificate.ended, Ended::Proved | Ended::Gap));
        let distance = |p: &Placement<2>, q: &Placement<2>| (p.point - q.point).norm();
        for (i, p) in found.best.placements.iter().enumerate() {
            assert!(p.share >= asked.least_share - 1e-12);
            for q in &found.best.placements[..i] {
                let near = distance(p, q) < asked.clearance - 1e-12;
                assert!(!near, "{:?}", found.best.placements);
            }
        }
        Ok::<f64, OptimizeError>(found.best.objective)
    };
    let free = quality(Fingers::new(4)).unwrap();
    let shared = quality(Fingers { least_share: 0.2, ..Fingers::new(4) }).unwrap();
    let apart = quality(Fingers { clearance: 0.5, ..Fingers::new(4) }).unwrap();
    assert!(shared < free && apart <= free, "{free} {shared} {apart}");
    // No two places of the outline are so far apart.
    let never = quality(Fingers { clearance: 3.5, ..Fingers::new(4) });
    assert_eq!(never, Err(OptimizeError::ConditionsNeverMet { fingers: 4, combinations: 35.0 }));
}

/// On a square of side 4 tips 2.5 apart are best where two fingers press no more: at (2, 0),
/// (4, 1.5), (0, 4) and (0, 1.5), with a quality of 8/61. Those who press come as near as one
/// likes, in ever smaller parts of what is divided.
#[test]
fn the_bound_holds_where_tips_touch_at_the_limit_of_closure() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let part = Part::uniform(Polygon::new(&square).unwrap(), 1.0).unwrap();
    let asked = Fingers { clearance: 2.5, ..Fingers::new(4) };
    let found = fingers(&part, &asked, &Effort::default(), unwatched).unwrap();
    let (best, limit) = (found.best.objective, 8.0 / 61.0);
    assert!(found.certificate.upper_bound >= limit * (1.0 - 1e-12));
    assert!(best <= limit * (1.0 + 1e-12) && best > 0.999 * limit);
}

/// However a search ends, no placement is above its bound, and its best is one.
#[test]
fn a_stopped_search_has_a_bound_that_holds() {
    let r = &mut Random::new(81);
    let part = Part::uniform(Polygon::new(&r.star(40)).unwrap(), 1.0).unwrap();
    let four = Fingers::new(4);
    let proved = fingers(&part, &four, &Effort::default(), unwatched).unwrap();
    let optimum = proved.best.objective;
    assert_eq!(proved.certificate.ended, Ended::Proved);
    assert!(proved.gap() <= 1e-12);
    let check = |outcome: Outcome<2, 1>, ended: Ended| {
        assert_eq!(outcome.certificate.ended, ended);
        let (best, bound) = (outcome.best.objective, outcome.certificate.upper_bound);
        assert!(best <= optimum * (1.0 + 1e-12) && bound >= optimum * (1.0 - 1e-12));
        outcome.gap()
    };
    let effort = |gap, nodes| Effort { gap, nodes, ..Effort::default() };
    let ask = |effort: Effort| fingers(&part, &four, &effort, unwatched).unwrap();
    assert!(check(ask(effort(0.1, None)), Ended::Gap) <= 0.1);
    let few = check(ask(effort(0.0, Some(50))), Ended::Nodes);
    let more = check(ask(effort(0.0, Some(1000))), Ended::Nodes);
    assert!(few >= more && more > 0.0, "{few} {more}");
    let at_once = Effort { time: Some(Duration::ZERO), ..Effort::default() };
    check(ask(at_once), Ended::Time);
    let stop = |p: &Progress| {
        if p.nodes > 100 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let cancelled = fingers(&part, &four, &Effort::default(), stop).unwrap();
    check(cancelled, Ended::Cancelled);
}

/// A condition so narrow that no trial meets it: stopped at once, nothing is known but a bound.
#[test]
fn a_search_stopped_before_it_found_anything_says_so() {
    let r = &mut Random::new(82);
    let part = Part::uniform(Polygon::new(&r.convex(40)).unwrap(), 1.0).unwrap();
    let asked = Fingers { least_share: 0.249, ..Fingers::new(4) };
    let effort = Effort { nodes: Some(1), ..Effort::default() };
    let fault = fingers(&part, &asked, &effort, unwatched).unwrap_err();
    let OptimizeError::NothingFound { fingers: 4, ended: Ended::Nodes, upper_bound } = fault else {
        panic!("{fault}");
    };
    assert!(upper_bound > 0.0);
}
