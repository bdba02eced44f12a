//! Where round fingers have room, against distances by parry at many places.

use clench_screw::Vector;
use clench_shape::{AccessError, DiscTip, Edge, Plate, Polygon};
use clench_testkit::{Random, assert_close};
use parry2d_f64::math::Vector as ParryVector;
use parry2d_f64::query::PointQuery;
use parry2d_f64::shape::Segment;

/// Places so near to the end of a stretch, or fingers so near to touching, may count either way.
const NEAR: f64 = 1e-7;

/// How many places are looked at along an edge.
const SAMPLES: usize = 64;

fn square(low: f64, high: f64) -> Vec<[f64; 2]> {
    vec![[low, low], [high, low], [high, high], [low, high]]
}

fn parry(v: Vector<2>) -> ParryVector {
    ParryVector::new(v[0], v[1])
}

/// How far `point` is from the edges of an outline, by parry.
fn distance(outline: &Polygon, point: Vector<2>) -> f64 {
    let segment = |e: &Edge| Segment::new(parry(e.start()), parry(e.end()));
    let to = |e: &Edge| segment(e).distance_to_local_point(parry(point), true);
    outline.edges().iter().map(to).fold(f64::INFINITY, f64::min)
}

/// Holds all stretches against the definition of room, place by place; how many had room, and how
/// many not.
fn check(outline: &Polygon, tip: &DiscTip, r: &mut Random) -> [usize; 2] {
    let stretches = outline.accessible(tip).unwrap();
    let mut counts = [0; 2];
    for (edge, stretches) in outline.edges().iter().zip(&stretches) {
        assert!(stretches.iter().all(|[from, to]| from < to), "{stretches:?}");
        assert!(stretches.windows(2).all(|pair| pair[0][1] <= pair[1][0]), "{stretches:?}");
        for _ in 0..SAMPLES {
            let along = r.between(0.0, edge.length());
            let center = edge.point_at(along) - edge.inward_normal() * tip.radius();
            let slack = distance(outline, center) - tip.radius();
            let kept = tip.keep_out().iter().map(|k| k.signed_distance(center) - tip.radius());
            let kept = kept.fold(f64::INFINITY, f64::min);
            let off = tip.plate().map_or(-1.0, |plate| {
                let to = |i: usize| {
                    let steps = (center[i] - plate.offset()[i]) / plate.pitch()[i];
                    (steps - steps.round()) * plate.pitch()[i]
                };
                Vector::new([to(0), to(1)]).norm() - plate.travel()
            });
            // On its own edge the slack is 0, up to rounding.
            if kept.abs() < NEAR || off.abs() < NEAR || (-NEAR..-1e-12).contains(&slack) {
                continue;
            }
            let has_room = slack >= -1e-12 && kept > 0.0 && off < 0.0;
            let found = stretches.iter().any(|s| (s[0]..=s[1]).contains(&along));
            assert_eq!(found, has_room, "{along} of {edge:?}: {slack} {kept} {off} {stretches:?}");
            counts[usize::from(!has_room)] += 1;
        }
    }
    counts
}

/// Stars with a hole, discs of all sizes, regions around them and plates.
#[test]
fn a_finger_has_room_where_its_disc_meets_nothing() {
    let r = &mut Random::new(7);
    let mut counts = [0; 2];
    for _ in 0..300 {
        let corners = r.below(20) + 4;
        let star = r.star(corners);
        let hole: Vec<[f64; 2]> =
            r.convex(3 + corners / 3).iter().map(|c| c.map(|x| 0.1 * x)).collect();
        let holes = [vec![], vec![hole]][r.below(2)].clone();
        let Ok(outline) = Polygon::with_holes(&star, &holes) else { continue };
        let size = outline.enclosing_circle().radius;
        let radius = [0.0, r.between(0.001, 0.05), r.between(0.05, 0.5)][r.below(3)] * size;
        let mut tip = DiscTip::new(radius).unwrap();
        if r.below(2) == 0 {
            let [x, y] = r.array(size);
            let side = r.between(0.1, 1.0) * size;
            let region = Polygon::new(&[[x, y], [x + side, y], [x, y + side]]);
            tip = tip.keeping_out(vec![region.unwrap()]);
        }
        if r.below(3) == 0 {
            let pitch = [r.between(0.2, 1.0) * size, r.between(0.2, 1.0) * size];
            let travel = r.between(0.05, 0.3) * size;
            tip = tip.over(Plate::new(pitch, r.array(size), travel).unwrap());
        }
        let [with, without] = check(&outline, &tip, r);
        counts = [counts[0] + with, counts[1] + without];
    }
    assert!(counts.iter().all(|count| *count > 20_000), "{counts:?}");
}

/// Asserts that stretches end where they should, to the rounding that touching is given.
#[track_caller]
fn assert_stretches(found: &[[f64; 2]], expected: &[[f64; 2]]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.as_flattened().iter().zip(expected.as_flattened()) {
        assert_close(*found, *expected, 1e-12, 1.0, "an end");
    }
}

#[test]
fn a_slot_takes_fingers_up_to_its_width() {
    // A slot of width 2 and depth 4 from above.
    let slotted = [
        [0.0, 0.0],
        [8.0, 0.0],
        [8.0, 6.0],
        [5.0, 6.0],
        [5.0, 2.0],
        [3.0, 2.0],
        [3.0, 6.0],
        [0.0, 6.0],
    ];
    let part = Polygon::new(&slotted).unwrap();
    let stretches = |radius| part.accessible(&DiscTip::new(radius).unwrap()).unwrap();
    let narrow = stretches(0.5);
    assert_stretches(&narrow[3], &[[0.0, 3.5]]);
    assert_stretches(&narrow[4], &[[0.5, 1.5]]);
    assert_stretches(&narrow[5], &[[0.5, 4.0]]);
    // As wide as the slot it touches both sides, and the bottom in one point.
    let just = stretches(1.0);
    assert_eq!((just[3].len(), just[5].len()), (1, 1));
    assert_close(just[3][0][1], 3.0, 1e-6, 1.0, "as deep as the bottom allows");
    let [from, to] = just[4].first().copied().unwrap_or([1.0, 1.0]);
    assert!(to - from < 1e-6);
    // Wider, it stays on the rim.
    let wide = stretches(1.25);
    assert!(wide[3].is_empty() && wide[4].is_empty() && wide[5].is_empty());
    assert_stretches(&wide[2], &[[0.0, 3.0]]);
    assert_stretches(&wide[6], &[[0.0, 3.0]]);
}

#[test]
fn a_bore_takes_fingers_smaller_than_itself() {
    let part = Polygon::with_holes(&square(0.0, 10.0), &[square(4.0, 6.0)]).unwrap();
    let stretches = |radius| part.accessible(&DiscTip::new(radius).unwrap()).unwrap();
    assert_stretches(&stretches(0.75)[4], &[[0.75, 1.25]]);
    assert!((4..8).all(|edge| stretches(1.5)[edge].is_empty()));
    assert!((0..4).all(|edge| stretches(1e6)[edge] == [[0.0, 10.0]]));
}

#[test]
fn convex_outlines_leave_all_room_whatever_their_size_and_place() {
    let r = &mut Random::new(3);
    for size in [1e-100, 1e-9, 1.0, 1e9, 1e100] {
        let angle = r.between(0.0, 1.0);
        let corner = |i: u32| {
            let turn = angle + f64::from(i) * std::f64::consts::TAU / 300.0;
            [size * (2.0 + turn.cos()), size * turn.sin()]
        };
        let part = Polygon::new(&(0..300).map(corner).collect::<Vec<_>>()).unwrap();
        for radius in [1e-3, 1.0, 1e3] {
            let stretches = part.accessible(&DiscTip::new(radius * size).unwrap()).unwrap();
            for (edge, stretches) in part.edges().iter().zip(stretches) {
                assert_eq!(stretches, [[0.0, edge.length()]], "{size} {radius}");
            }
        }
    }
}

#[test]
fn discs_may_be_of_any_size() {
    let corner = [[0.0, 0.0], [6.0, 0.0], [6.0, 2.0], [2.0, 2.0], [2.0, 6.0], [0.0, 6.0]];
    let part = Polygon::new(&corner).unwrap();
    let thin = part.accessible(&DiscTip::new(1e-9).unwrap()).unwrap();
    assert!(thin.iter().all(|stretches| stretches.len() == 1));
    for radius in [1e9, 1e100, 1e155, 1e300, f64::MAX] {
        let stretches = part.accessible(&DiscTip::new(radius).unwrap()).unwrap();
        let left: Vec<_> = stretches.iter().map(Vec::len).collect();
        assert_eq!(left[2..4], [0, 0], "{radius}: {stretches:?}");
    }
}

#[test]
fn regions_are_kept_out_of_from_inside_and_outside() {
    let part = Polygon::new(&square(0.0, 10.0)).unwrap();
    let region = |low, high| Polygon::new(&square(low, high)).unwrap();
    let around = DiscTip::new(1.0).unwrap().keeping_out(vec![region(-20.0, 20.0)]);
    assert!(part.accessible(&around).unwrap().iter().all(Vec::is_empty));
    let none = DiscTip::new(1.0).unwrap().keeping_out(vec![region(20.0, 30.0)]);
    assert_eq!(part.accessible(&none).unwrap()[0], [[0.0, 10.0]]);
    // A point on the outline is in a region that it enters.
    let corner = DiscTip::new(0.0).unwrap().keeping_out(vec![region(-3.0, 4.0)]);
    assert_eq!(part.accessible(&corner).unwrap()[0], [[4.0, 10.0]]);
    // A disc keeps its radius away.
    let corner = DiscTip::new(1.0).unwrap().keeping_out(vec![region(-3.0, 4.0)]);
    assert_stretches(&part.accessible(&corner).unwrap()[0], &[[5.0, 10.0]]);
}

/// A pointed finger is the limit of thin ones: what rests on an edge from outside is in its way,
/// what rests on it from inside is not, on whichever side. Walls that it would only cross if they
/// were longer leave its stretches whole.
#[test]
fn points_come_from_outside_of_the_part() {
    for (offset, radius) in [(0.0, 0.0), (1e6, 0.0), (0.0, 1e-16), (1e6, 1e-9), (0.0, 1e-13)] {
        let moved = |corners: &[[f64; 2]]| -> Vec<[f64; 2]> {
            corners.iter().map(|c| [c[0] + offset, c[1] - offset]).collect()
        };
        let part = Polygon::new(&moved(&square(0.0, 10.0))).unwrap();
        let beside = |y: [f64; 2]| {
            let region = [[3.0, y[0]], [7.0, y[0]], [7.0, y[1]], [3.0, y[1]]];
            let turned = |times: usize| {
                (0..times).fold(region, |r, _| r.map(|[x, y]: [f64; 2]| [10.0 - y, x]))
            };
            [0, 1, 2, 3].map(turned)
        };
        let stretches = |corners: &[[f64; 2]; 4]| {
            let region = Polygon::new(&moved(corners)).unwrap();
            part.accessible(&DiscTip::new(radius).unwrap().keeping_out(vec![region])).unwrap()
        };
        for side in 0..4 {
            for blocking in [[-5.0, 0.0], [-5.0, 2.0]] {
                let found = stretches(&beside(blocking)[side]);
                assert_stretches(&found[side], &[[0.0, 3.0], [7.0, 10.0]]);
                assert!((0..4).filter(|&e| e != side).all(|e| found[e] == [[0.0, 10.0]]));
            }
            for free in [[0.0, 2.0], [2.0, 5.0], [-5.0, -1.0]] {
                let found = stretches(&beside(free)[side]);
                assert!(found.iter().all(|edge| *edge == [[0.0, 10.0]]), "{offset} {found:?}");
            }
        }
    }
}

#[test]
fn a_plate_holds_centers_near_its_holes() {
    let part = Polygon::new(&square(0.0, 10.0)).unwrap();
    let plate = Plate::new([4.0, 4.0], [1.0, -1.0], 0.5).unwrap();
    let room = DiscTip::new(1.0).unwrap().over(plate);
    let stretches = part.accessible(&room).unwrap();
    // The centers below edge 0 are on the row of holes at y = -1.
    assert_stretches(&stretches[0], &[[0.5, 1.5], [4.5, 5.5], [8.5, 9.5]]);
    // To the right of edge 1 they are on the column at x = 11, which is no multiple of the pitch.
    assert!(stretches[1].is_empty());
}

#[test]
fn tips_and_plates_that_are_none_are_refused_by_value() {
    for value in [-1.0, f64::INFINITY] {
        assert_eq!(DiscTip::new(value), Err(AccessError::Radius { value }));
    }
    assert!(matches!(DiscTip::new(f64::NAN), Err(AccessError::Radius { .. })));
    let fine = Plate::new([1e-9, 1e-9], [0.0, 0.0], 0.1).unwrap();
    let tip = DiscTip::new(1.0).unwrap().over(fine);
    let part = Polygon::new(&square(0.0, 10.0)).unwrap();
    let found = part.accessible(&tip);
    assert!(matches!(found, Err(AccessError::TooManyHolesAtEdge { edge: 0, .. })));
    // So far away that one hole more is no other number.
    let far = DiscTip::new(1.0).unwrap().over(Plate::new([1.0, 1.0], [1e17, 0.0], 0.1).unwrap());
    let found = part.accessible(&far);
    assert_eq!(found, Err(AccessError::PlateTooFar { edge: 0, pitches: 1e17 }));
}
