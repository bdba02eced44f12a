//! Parts on which faces degenerate: symmetric ones, parallel and nearly parallel edges, widely
//! different stiffnesses. Each family is held against sampling, and against itself.

use clench_optimize::polygon::{
    Fingers, Part, ThreeFingers, fingers, four_fingers_on, three_fingers,
};
use clench_optimize::{Effort, Ended, Objective, OptimizeError, unwatched};
use clench_screw::planar::Frame;
use clench_shape::Polygon;
use clench_testkit::{Random, assert_close};

use crate::sampling::{equivalent, grasp};

fn turned(corners: &[[f64; 2]], angle: f64) -> Vec<[f64; 2]> {
    let frame = Frame::new([0.0, 0.0], angle);
    corners.iter().map(|&c| frame.point_to_parent(c.into()).to_array()).collect()
}

fn rectangle(r: &mut Random) -> Vec<[f64; 2]> {
    let (w, h) = (r.between(0.5, 3.0), r.between(0.5, 3.0));
    turned(&[[0.0, 0.0], [w, 0.0], [w, h], [0.0, h]], r.between(0.0, 6.0))
}

fn regular(r: &mut Random) -> Vec<[f64; 2]> {
    let (n, first) = (4 + r.below(5), r.between(0.0, 6.0));
    let angle = |i: usize| first + std::f64::consts::TAU * i as f64 / n as f64;
    (0..n).map(|i| [angle(i).cos(), angle(i).sin()]).collect()
}

fn bent(r: &mut Random) -> Vec<[f64; 2]> {
    let (w, h) = (r.between(2.0, 4.0), r.between(2.0, 4.0));
    let (x, y) = (r.between(0.5, 1.5), r.between(0.5, 1.5));
    let corners = [[0.0, 0.0], [w, 0.0], [w, y], [x, y], [x, h], [0.0, h]];
    turned(&corners, [0.0, r.between(0.0, 6.0)][r.below(2)])
}

/// As a drawing exports it: right angles up to the sixth decimal.
fn rounded(r: &mut Random) -> Vec<[f64; 2]> {
    let corners = if r.below(2) == 0 { rectangle(r) } else { bent(r) };
    corners.iter().map(|c| c.map(|x| (x * 1e6).round() / 1e6)).collect()
}

/// A trapezoid whose long sides are parallel up to a small slope.
fn nearly_parallel(r: &mut Random) -> Vec<[f64; 2]> {
    let slope = 10.0_f64.powf(r.between(-9.0, -3.0));
    let (w, h) = (r.between(1.0, 4.0), r.between(0.5, 2.0));
    turned(&[[0.0, 0.0], [w, slope], [w, h], [0.2 * w, h - slope]], r.between(0.0, 6.0))
}

fn check(family: &str, corners: &[[f64; 2]], stiffness: Vec<f64>, r: &mut Random) {
    let what = format!("{family} {corners:?} {stiffness:?}");
    let part = Part::new(Polygon::new(corners).unwrap(), stiffness).unwrap();
    let outcome = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap();
    let best = outcome.best.quality.value;
    assert_close(outcome.certificate.upper_bound, best, 1e-7, best, format!("bound of {what}"));
    let margin = outcome.best.placements.iter().map(|p| p.share).fold(f64::INFINITY, f64::min);
    assert!(margin >= 0.0, "{what}");

    let n = corners.len();
    let (mut seen, mut sampled) = (0.0_f64, 0);
    for a in 0..n {
        for b in a..n {
            for c in b..n {
                for d in c..n {
                    let edges = [a, b, c, d];
                    // Nearly parallel edges alone may hold less than rounding can tell.
                    let q = match four_fingers_on(&part, edges, &Fingers::new(4)) {
                        Ok(found) => found.map(|s| s.quality),
                        Err(OptimizeError::OutOfRange { .. }) => continue,
                        Err(other) => panic!("{other}"),
                    };
                    seen = seen.max(q.map_or(0.0, |q| q.value));
                    for _ in 0..60 {
                        let along = std::array::from_fn(|_| match r.below(4) {
                            0 => 0.0,
                            1 => 1.0,
                            _ => r.between(0.0, 1.0),
                        });
                        let closing = equivalent(&part, edges, along).filter(|_| {
                            // A margin above rounding, so that the placement really closes.
                            let best = grasp(&part, edges, along).preloads().unwrap().best;
                            best.is_some_and(|b| b.margin > 1e-6)
                        });
                        if let Some(value) = closing {
                            let optimum = q.map_or(0.0, |q| q.equivalent());
                            assert!(
                                value <= optimum * (1.0 + 1e-7),
                                "{edges:?} {along:?}: {value} > {optimum}, {what}"
                            );
                            sampled += 1;
                        }
                    }
                }
            }
        }
    }
    assert!(seen <= best * (1.0 + 1e-7), "{seen} > {best}: {what}");
    assert!(sampled > 0, "{what}");
}

type Family = fn(&mut Random) -> Vec<[f64; 2]>;

#[test]
fn no_sample_beats_the_optimum_of_degenerate_parts() {
    let r = &mut Random::new(61);
    let families: [(&str, Family); 5] = [
        ("rectangle", rectangle),
        ("regular", regular),
        ("bent", bent),
        ("rounded", rounded),
        ("nearly parallel", nearly_parallel),
    ];
    for (name, family) in families {
        for round in 0..12 {
            let corners = family(r);
            let stiffness = match round % 3 {
                0 => vec![1.0; corners.len()],
                1 => corners.iter().map(|_| r.between(0.5, 2.0)).collect(),
                _ => corners.iter().map(|_| 10.0_f64.powf(r.between(-3.0, 3.0))).collect(),
            };
            check(name, &corners, stiffness, r);
        }
    }
}

/// Pins at the ends of a diagonal, two in each corner, hold a rectangle best: for stiffness 1 and
/// sides w and h, `mu = (w^2 + h^2) / 2` and `rho^2 = (w^2 + h^2) / 4`, so both stiffnesses are 2.
#[test]
fn any_rectangle_is_held_with_quality_two() {
    let r = &mut Random::new(62);
    for _ in 0..300 {
        let part = Part::uniform(Polygon::new(&rectangle(r)).unwrap(), 1.0).unwrap();
        let outcome = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap();
        assert_close(outcome.best.quality.value, 2.0, 1e-12, 2.0, "rectangle");
    }
}

#[test]
fn turning_a_regular_polygon_does_not_change_its_quality() {
    let r = &mut Random::new(63);
    for n in 4..=12_u32 {
        let quality = |first: f64| {
            let angle = |i| first + std::f64::consts::TAU * f64::from(i) / f64::from(n);
            let corners: Vec<_> = (0..n).map(|i| [angle(i).cos(), angle(i).sin()]).collect();
            let part = Part::uniform(Polygon::new(&corners).unwrap(), 1.0).unwrap();
            fingers(&part, &Fingers::new(4), &Effort::default(), unwatched)
                .unwrap()
                .best
                .quality
                .value
        };
        let wanted = quality(0.0);
        for _ in 0..6 {
            let found = quality(r.between(0.0, 6.0));
            assert_close(found, wanted, 1e-11, wanted, format!("{n} corners"));
        }
    }
}

/// On these edges of an S the torques balance only where two forces vanish, and no placement near
/// by has all forces positive: the placements touch the cone of pushing forces from outside.
#[test]
fn placements_that_only_touch_the_pushing_cone_are_no_limits() {
    let s = [
        [0.0, 0.0],
        [2.0, 0.0],
        [2.0, 1.0],
        [3.0, 1.0],
        [3.0, 2.0],
        [1.0, 2.0],
        [1.0, 1.0],
        [0.0, 1.0],
    ];
    for angle in [0.0, 0.3, 1.1, 4.0] {
        let outline = Polygon::new(&turned(&s, angle)).unwrap();
        let part = Part::uniform(outline, 1.0).unwrap();
        assert_eq!(
            four_fingers_on(&part, [2, 3, 6, 7], &Fingers::new(4)).unwrap(),
            None,
            "{angle}"
        );
    }
}

/// The same S with a long tail: its edges are short beside their distance from the center.
#[test]
fn touching_is_recognized_on_short_edges_far_from_the_center() {
    for tail in [10.0, 1e3, 1e4, 1e5] {
        let s = [
            [0.0, 0.0],
            [0.5, -tail],
            [2.0, 0.0],
            [2.0, 1.0],
            [3.0, 1.0],
            [3.0, 2.0],
            [1.0, 2.0],
            [1.0, 1.0],
            [0.0, 1.0],
        ];
        let part = Part::uniform(Polygon::new(&s).unwrap(), 1.0).unwrap();
        assert_eq!(four_fingers_on(&part, [3, 4, 7, 8], &Fingers::new(4)).unwrap(), None, "{tail}");
    }
}

/// Slivers whose centers of compliance are thousands of radii away; each placement given is the
/// best known, computed with 70 digits.
#[test]
fn far_centers_of_compliance_do_not_hide_the_optimum() {
    let sliver = [
        [1.692_102_989_337_123_3, 0.860_351_516_978_834_2],
        [-1.439_332_552_848_597, -0.730_598_021_729_064_3],
        [-0.345_620_802_129_220_14, -0.176_606_877_468_631_05],
        [0.377_830_628_097_994_84, 0.190_982_723_943_169_42],
    ];
    let stiffness = vec![
        1.449_503_930_793_034,
        0.552_928_112_574_214_5,
        1.078_774_973_551_512_9,
        0.766_202_422_780_366,
    ];
    let part = Part::new(Polygon::new(&sliver).unwrap(), stiffness).unwrap();
    let found =
        fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap().best.quality.value;
    assert!(found >= 2.1306e-6, "{found:e}");

    let sliver = [
        [0.644_134_438_111_406_4, -1.158_641_479_430_325_7],
        [0.026_827_546_118_128_23, -0.047_225_063_958_550_1],
        [-1.079_731_166_424_93, 1.943_064_232_056_840_8],
        [-0.915_210_012_413_334_2, 1.645_653_765_319_319],
        [0.178_644_004_355_184_04, -0.322_391_937_859_070_3],
        [0.800_627_628_406_503_7, -1.440_670_440_616_642_6],
    ];
    let stiffness = vec![
        1.265_010_983_607_783_4,
        1.0,
        0.897_708_702_040_653_9,
        1.0,
        0.859_158_927_384_572,
        0.622_641_257_584_861_2,
    ];
    let part = Part::new(Polygon::new(&sliver).unwrap(), stiffness).unwrap();
    let found = four_fingers_on(&part, [0, 2, 4, 5], &Fingers::new(4))
        .unwrap()
        .unwrap()
        .quality
        .equivalent();
    assert!(found >= 1.8110e-6, "{found:e}");
}

/// A rectangle from `(0, 0)` to `(w, h)` whose sides are `pieces` edges each.
fn divided_rectangle(w: f64, h: f64, pieces: usize, angle: f64) -> Polygon {
    let ends = [[0.0, 0.0], [w, 0.0], [w, h], [0.0, h], [0.0, 0.0]];
    let place = |from: [f64; 2], to: [f64; 2], i: usize| {
        let part = i as f64 / pieces as f64;
        [from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part]
    };
    let corners: Vec<_> = ends
        .windows(2)
        .flat_map(|side| (0..pieces).map(move |i| place(side[0], side[1], i)))
        .collect();
    Polygon::new(&turned(&corners, angle)).unwrap()
}

fn never_held(error: &OptimizeError) -> bool {
    matches!(
        error,
        OptimizeError::NormalsNeverBalance { .. }
            | OptimizeError::TorquesNeverBalance { .. }
            | OptimizeError::ConditionsNeverMet { .. }
    )
}

/// Short edges know their direction to some digits only; what those would balance is not held.
#[test]
fn rounded_directions_hold_nothing() {
    for angle in [0.0, 0.33, 0.56, 1.02] {
        for pieces in [1, 3, 10] {
            let part = Part::uniform(divided_rectangle(4.0, 2.0, pieces, angle), 1.0).unwrap();
            let asked = ThreeFingers::with_preload(1.0);
            let fault = three_fingers(&part, &asked, &Effort::default(), unwatched).unwrap_err();
            assert!(never_held(&fault), "{pieces} {angle}: {fault}");
            let open = (2 * pieces..3 * pieces).fold(part, |p, edge| p.without_edge(edge).unwrap());
            for fingers_asked in [Fingers::new(4), Fingers::new(5)] {
                let effort = Effort { gap: 1e-2, nodes: Some(200_000), ..Effort::default() };
                let found = fingers(&open, &fingers_asked, &effort, unwatched);
                let fault = found.map(|o| o.best).unwrap_err();
                assert!(
                    never_held(&fault) || matches!(fault, OptimizeError::NothingFound { .. }),
                    "{pieces} {angle}: {fault}"
                );
            }
        }
    }
}

/// Stiff sides beside soft ones round the directions in which forces balance.
#[test]
fn three_sides_of_a_rectangle_hold_nothing_however_stiff() {
    for ratio in [1e3, 1e6, 9e9] {
        for step in 0..20 {
            let outline = divided_rectangle(2.0, 1.0, 1, 0.05 + 0.3 * f64::from(step));
            let part = Part::new(outline, vec![ratio, 1.0, ratio, 1.0]).unwrap();
            let part = part.without_edge(3).unwrap();
            let rotation = Objective::Rotation { least_translation: 0.0 };
            for objective in [Objective::Quality, rotation] {
                let asked = Fingers { objective, ..Fingers::new(4) };
                let fault = fingers(&part, &asked, &Effort::default(), unwatched).unwrap_err();
                assert!(never_held(&fault), "{ratio:e} {step}: {fault}");
            }
        }
    }
}

/// Combinations that only touch the cone of pushing forces do not keep a search from its end.
#[test]
fn searches_that_close_in_come_to_an_end() {
    let kite = [[0.0, 0.0], [4.0, 0.0], [3.5, 3.0], [0.0, 3.0]];
    let part = Part::uniform(Polygon::new(&kite).unwrap(), 1.0).unwrap();
    let effort = Effort { gap: 1e-2, nodes: Some(200_000), ..Effort::default() };
    let rotation = Objective::Rotation { least_translation: 1.0 };
    for asked in [
        Fingers::new(7),
        Fingers::new(8),
        Fingers { objective: rotation, ..Fingers::new(5) },
        Fingers { clearance: 0.5, ..Fingers::new(6) },
        Fingers { objective: Objective::WorstPoint, ..Fingers::new(4) },
    ] {
        let found = fingers(&part, &asked, &effort, unwatched).unwrap();
        assert!(matches!(found.certificate.ended, Ended::Gap | Ended::Proved), "{asked:?}");
        assert!(found.gap() <= 1e-2, "{asked:?}");
    }
}

/// Several of the best combinations, each up to the gap, where none is solved exactly.
#[test]
fn the_top_combinations_come_to_an_end_where_a_search_closes_in() {
    let quadrilateral = [[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]];
    let part = Part::uniform(Polygon::new(&quadrilateral).unwrap(), 1.0).unwrap();
    let top = std::num::NonZeroUsize::new(3).unwrap();
    let effort = Effort { top, gap: 1e-2, nodes: Some(200_000), ..Effort::default() };
    let found = fingers(&part, &Fingers::new(5), &effort, unwatched).unwrap();
    assert_eq!(found.certificate.ended, Ended::Gap);
    let values: Vec<f64> = found.solutions().map(|s| s.objective).collect();
    assert!(values.len() == 3 && values.windows(2).all(|w| w[0] >= w[1]), "{values:?}");
}

/// Thinner than rounding can tell: not called free, and not called held.
#[test]
fn needles_are_not_judged() {
    for thinness in [3e-9, 1e-9] {
        let needle = [[0.0, 0.0], [13.0, 0.0], [9.0, 8.0 * thinness], [2.0, 6.0 * thinness]];
        for step in 0..10 {
            let corners = turned(&needle, 0.3 * f64::from(step));
            let Ok(outline) = Polygon::new(&corners) else { continue };
            let part = Part::uniform(outline, 1.0).unwrap();
            let fault =
                fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap_err();
            assert!(
                matches!(fault, OptimizeError::TooThin { .. } | OptimizeError::OutOfRange { .. }),
                "{thinness:e} {step}: {fault}"
            );
        }
    }
}
