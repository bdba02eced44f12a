//! Fingers that keep a distance from each other, against placements by trial.

use clench_screw::Vector;
use clench_shape::{DiscTip, Polygon};
use clench_testkit::Random;

use super::{each_set, outline, part};
use crate::polygon::rating::{Spot, moments, rate};
use crate::polygon::scene::{Scene, Support};
use crate::polygon::triplets::Triplets;
use crate::polygon::{CROWDING_GAP, Fingers, Part, ThreeFingers, fingers, three_fingers};
use crate::search::Floor;
use crate::{Effort, Ended, Solution, unwatched};

/// What distances may fall short by, as a part of the size.
const ROUNDING: f64 = 1e-12;

/// Where the centers of the tips are.
fn tips(solution: &Solution<2, 1>, radius: f64) -> Vec<Vector<2>> {
    solution.placements.iter().map(|p| p.point - p.inward_normal * radius).collect()
}

fn least_distance(tips: &[Vector<2>]) -> f64 {
    let pairs = (0..tips.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    pairs.map(|(i, j)| (tips[i] - tips[j]).norm()).fold(f64::INFINITY, f64::min)
}

/// The best quality of four fingers at some 40 places of the boundary.
fn sampled(part: &Part, asked: &Fingers) -> f64 {
    let scene = Scene::checked(part).unwrap();
    let total: f64 = scene.supports.iter().map(Support::length).sum();
    let mut spots = Vec::new();
    for (stretch, support) in scene.supports.iter().enumerate() {
        let steps = (24.0 * support.length() / total).ceil();
        let mut step = 0.0;
        while step <= steps {
            spots.push(Spot { stretch, along: step / steps });
            step += 1.0;
        }
    }
    let mut best = 0.0_f64;
    each_set::<4>(spots.len(), |set| {
        let spots = set.map(|i| spots[i]);
        let stretches = spots.map(|spot| spot.stretch);
        let moments = moments(&scene, &spots);
        if let Some(rating) = rate(&scene, asked, &stretches, &moments, |_| true) {
            best = best.max(rating.sigma_min.min(rating.equivalent));
        }
    });
    best * scene.stiffness_unit
}

#[test]
fn four_round_fingers_have_room_and_are_as_good_as_any_by_trial() {
    let r = &mut Random::new(81);
    let (mut crowded, mut held) = (0, 0);
    for _ in 0..40 {
        let size = 3 + r.below(4);
        let whole = part(r, size);
        let extent = whole.outline().enclosing_circle().radius;
        let radius = r.between(0.05, 0.4) * extent;
        let part = whole.accessible_to(&DiscTip::new(radius).unwrap()).unwrap();
        let asked = Fingers {
            finger_radius: radius,
            clearance: r.between(0.0, 1.0) * radius,
            ..Fingers::new(4)
        };
        let what = format!("{:?} {asked:?}", part.outline().corners());
        let found = fingers(&part, &asked, &Effort::default(), unwatched);
        let Ok(found) = found else { continue };
        let tips = tips(&found.best, radius);
        let slack = asked.least_distance() - least_distance(&tips);
        assert!(slack <= ROUNDING * extent, "{slack} {what}");
        let certificate = found.certificate;
        let gap = certificate.upper_bound / found.best.objective - 1.0;
        assert!(gap <= 2.0 * CROWDING_GAP, "{gap} {what}");
        assert!(matches!(certificate.ended, Ended::Proved | Ended::Gap), "{what}");
        let trial = sampled(&part, &asked);
        assert!(trial <= certificate.upper_bound * (1.0 + 1e-9), "{trial} {found:?} {what}");
        // Without keeping distances they would be better.
        let free = Fingers { finger_radius: 0.0, clearance: 0.0, ..asked };
        let free = fingers(&part, &free, &Effort::default(), unwatched).unwrap();
        assert!(free.best.objective >= found.best.objective * (1.0 - 2.0 * CROWDING_GAP));
        crowded += usize::from(slack.abs() < 1e-3 * extent);
        held += 1;
    }
    assert!(held > 20 && crowded > 5, "{held} {crowded}");
}

/// On two sides of a sharp tip, fingers stop where they touch each other.
#[test]
fn fingers_at_a_sharp_corner_touch_each_other() {
    // Far from the origin, too.
    for away in [0.0, 1e3, 1e5] {
        sharp_corner(away);
    }
}

fn sharp_corner(away: f64) {
    let corners = [[away, 0.0], [away + 12.0, -1.5], [away + 12.0, 1.5]];
    let part = Part::uniform(Polygon::new(&corners).unwrap(), 1.0).unwrap();
    let (radius, preload) = (1.5, 0.001);
    let asked = ThreeFingers { finger_radius: radius, ..ThreeFingers::with_preload(preload) };
    let near = three_fingers(&part, &asked, &Effort::default(), unwatched).unwrap();
    let kept = ThreeFingers { clearance: 2.0, ..asked };
    let kept = three_fingers(&part, &kept, &Effort::default(), unwatched).unwrap();
    assert!(least_distance(&tips(&near.best, radius)) < 4.9);
    let apart = least_distance(&tips(&kept.best, radius));
    assert!((apart - 5.0).abs() < 1e-10 + 1e-15 * away, "{apart}");
    assert_eq!(kept.certificate.ended, Ended::Proved);
}

/// The feet of the normals through points all over the part.
#[test]
fn three_fingers_that_keep_a_distance_meet_as_near_as_any() {
    let r = &mut Random::new(82);
    let (mut held, mut crowded) = (0, 0);
    for _ in 0..200 {
        let corners = {
            let n = 3 + r.below(5);
            outline(r, n)
        };
        let part = Part::uniform(Polygon::new(&corners).unwrap(), 1.0).unwrap();
        let extent = part.outline().enclosing_circle().radius;
        let radius = [0.0, r.between(0.0, 0.5) * extent][r.below(2)];
        let asked = ThreeFingers {
            finger_radius: radius,
            clearance: (r.between(0.5, 1.8) * extent - 2.0 * radius).max(0.0),
            ..ThreeFingers::with_preload(1e-3)
        };
        let scene = Scene::checked(&part).unwrap();
        let triplets = Triplets::new(&scene, &asked);
        each_set::<3>(scene.supports.len(), |set| {
            let free = ThreeFingers { finger_radius: 0.0, clearance: 0.0, ..asked };
            let free = Triplets::new(&scene, &free).solve(set, &Floor::NONE);
            let Some(free) = free else { return };
            let found = triplets.solve(set, &Floor::NONE);
            let reach = |point: Vector<2>| part.outline().farthest(point).distance;
            let apart = |point: Vector<2>| {
                let tips = set.map(|s| {
                    let support = &scene.supports[s];
                    support.foot(point) - support.normal * radius
                });
                least_distance(&tips)
            };
            if let Some(found) = &found {
                let center = found.place.center();
                let short = asked.least_distance() - apart(center);
                assert!(short <= ROUNDING * extent, "{short}");
                crowded += usize::from(free.place.center() != center);
                held += 1;
            }
            let least = found.map_or(f64::INFINITY, |found| reach(found.place.center()));
            for _ in 0..500 {
                let point = scene.center + Vector::new(r.array(extent));
                let faced = set.iter().all(|&s| scene.supports[s].faces(point));
                if faced && apart(point) >= asked.least_distance() {
                    assert!(reach(point) >= least * (1.0 - 1e-9), "{point:?} {corners:?} {set:?}");
                }
            }
        });
    }
    assert!(held > 200 && crowded > 50, "{held} {crowded}");
}
