//! Each cut is fulfilled by all placements that meet its demand.

use clench_screw::Vector;
use clench_screw::spatial::cross;
use clench_shape::Polygon;
use clench_testkit::Random;

use super::node;
use crate::Objective;
use crate::polygon::bound::{Cut, Demand, Middle, closure_cuts, slack};
use crate::polygon::rating::{Spot, moments, rate};
use crate::polygon::scene::Scene;
use crate::polygon::{Fingers, Part};
use crate::search::Piece;
use crate::search::boxes::value;

/// How much `cut` leaves to a placement, less than 0 if it excludes it, without its slack.
fn left<const K: usize>(cut: &Cut<K>, wrenches: &[Vector<3>; K]) -> f64 {
    let values = wrenches.iter().zip(cut.linear).map(|(&p, linear)| value(&cut.form, linear, p));
    values.sum::<f64>() - cut.constant
}

/// Each placement, whatever its quality, against the cuts that demand just that, with test
/// points from the middle of a large node: so the slack counts.
#[test]
fn placements_fulfill_the_cuts_of_their_own_quality_and_need_the_slack() {
    let r = &mut Random::new(76);
    let (mut needed, mut most, mut forces) = (0, 0.0_f64, 0);
    for _ in 0..4000 {
        let corners = r.star(7);
        let stiffness = corners.iter().map(|_| r.between(0.5, 2.0)).collect();
        let outline = Polygon::new(&corners).unwrap();
        let part = Part::new(outline, stiffness).unwrap();
        let scene = Scene::checked(&part).unwrap();
        let tree = scene.wrenches();
        let least_share = [0.0, 0.05][r.below(2)];
        let node: [Piece; 4] = std::array::from_fn(|_| {
            let mut piece = Piece::BOUNDARY;
            for _ in 0..=r.below(3) {
                piece = tree.halves(piece).unwrap()[r.below(2)];
            }
            piece
        });
        let fingers = Fingers { objective: Objective::WorstPoint, least_share, ..Fingers::new(4) };
        for _ in 0..50 {
            let spots = node.map(|piece| {
                let (stretches, (from, to)) = (tree.stretches(piece), piece.along());
                let stretch = stretches[r.below(stretches.len())];
                Spot { stretch, along: r.between(from, to) }
            });
            let (stretches, place) = (spots.map(|spot| spot.stretch), moments(&scene, &spots));
            let Some(rating) = rate(&scene, &fingers, &stretches, &place, |_| true) else {
                continue;
            };
            let demand = Demand {
                translation: rating.sigma_min,
                rotation: rating.equivalent,
                fixed_translation: false,
                worst_point: rating.worst_point,
            };
            let wrenches = std::array::from_fn(|i| scene.supports[stretches[i]].wrench(place[i]));
            let middle = Middle::new(node.map(|piece| tree.range(piece)), demand.translation);
            let center = scene.center_of_compliance(&stretches, &place);
            let corners = part.outline().corners();
            let any = corners[r.below(corners.len())] - scene.center;
            let one = Cut::by_rotation(&scene, &middle, &demand, scene.farthest(center));
            let other = Cut::by_rotation(&scene, &middle, &demand, any);
            let mixed = one.mixed(r.between(0.0, 1.0), &other);
            let scaled = Cut::NONE.plus(r.between(0.1, 3.0), &mixed);
            let translation = Cut::by_translation(&middle, &demand);
            let point =
                Cut::by_worst_point(&scene, &demand, &middle.ranges.map(|range| range.center));
            for cut in [one, mixed, scaled, translation].into_iter().chain(point) {
                let rounding = 1e-12 * cut.size;
                let (slack, left) = (slack(&middle, &demand, &cut), left(&cut, &wrenches));
                assert!(left + slack >= -rounding, "{left} {slack} {demand:?}");
                if cut.turning > 0.0 && left < -rounding {
                    needed += 1;
                    most = most.max(-left / slack);
                }
            }
            for cut in closure_cuts(&middle, scene.radius, least_share) {
                let left = left(&cut, &wrenches) + cut.slack;
                assert!(left >= -1e-12 * cut.size, "{left}");
                forces += 1;
            }
        }
    }
    // Half of the slack would exclude some.
    assert!(needed > 100 && most > 0.5 && forces > 10, "{needed} {most} {forces}");
}

/// A linearized balancing force and its slack are at least the force itself, wherever the fingers
/// are on a node.
#[test]
fn cuts_by_closure_are_above_the_forces() {
    let r = &mut Random::new(77);
    let mut compared = 0;
    for _ in 0..2000 {
        let outline = Polygon::new(&r.star(7)).unwrap();
        let part = Part::uniform(outline, 1.0).unwrap();
        let scene = Scene::checked(&part).unwrap();
        let tree = scene.wrenches();
        let node: [Piece; 4] = node(r, &tree, true);
        let middle = Middle::new(node.map(|piece| tree.range(piece)), 0.0);
        let force = |wrenches: &[Vector<3>; 4], l: usize| {
            let others: Vec<Vector<3>> = (0..4).filter(|&m| m != l).map(|m| wrenches[m]).collect();
            let sign = [1.0, -1.0][l % 2];
            sign * others[0].dot(cross(others[1], others[2])) / scene.radius
        };
        let cuts: Vec<Cut<4>> = closure_cuts(&middle, scene.radius, 0.0).collect();
        if cuts.is_empty() {
            continue;
        }
        // All forces are taken with one sign; a node may be sure of either.
        let mut least = [f64::INFINITY; 2];
        for (l, cut) in cuts.iter().enumerate() {
            for _ in 0..20 {
                let wrenches = middle.ranges.map(|range| {
                    let corner = range.axes.map(|axis| axis * [1.0, -1.0][r.below(2)]);
                    corner.iter().fold(range.center, |sum, &axis| sum + axis)
                });
                for (least, sign) in least.iter_mut().zip([1.0, -1.0]) {
                    let above = |w: &_| left(cut, w) + cut.slack - sign * force(w, l);
                    *least = least.min(above(&wrenches) + 1e-12 * cut.size);
                }
                compared += 1;
            }
        }
        assert!(least[0] >= 0.0 || least[1] >= 0.0, "{least:?}");
    }
    assert!(compared > 5000, "{compared}");
}
