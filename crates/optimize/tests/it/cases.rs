//! The optima of an independent program, combination by combination.

use clench_optimize::polygon::{
    Fingers, Part, ThreeFingers, fingers, four_fingers_on, three_fingers, three_fingers_on,
};
use clench_optimize::{Effort, unwatched};
use clench_shape::Polygon;
use clench_testkit::cases::{Value, array, list, matching, number, numbers};
use clench_testkit::{assert_all_close, assert_close};

/// What the cases may be trusted to.
const DIGITS: f64 = 1e-9;

fn part(case: &Value) -> Part {
    let corners: Vec<[f64; 2]> = list(&case["vertices"]).iter().map(array).collect();
    Part::new(Polygon::new(&corners).unwrap(), numbers(&case["edge_stiffness"])).unwrap()
}

fn edges<const K: usize>(value: &Value) -> [usize; K] {
    let found: Vec<usize> =
        list(value).iter().map(|e| usize::try_from(e.as_u64().unwrap()).unwrap()).collect();
    found.try_into().unwrap()
}

#[test]
fn four_fingers_reach_the_optimum_of_each_combination() {
    let (_, cases) = &matching("polygon_four_finger")[0];
    let mut combinations = 0;
    for (i, case) in list(cases).iter().enumerate() {
        let (part, wanted) = (part(case), &case["four_finger"]);
        for combination in list(&wanted["combos"]) {
            let edges: [usize; 4] = edges(&combination[0]);
            let what = format!("part {i}, edges {edges:?}");
            let found =
                four_fingers_on(&part, edges, &Fingers::new(4)).unwrap().expect(&what).quality;
            let (sigma, mu_eq) = (number(&combination[1]), number(&combination[2]));
            assert_close(found.translational, sigma, DIGITS, sigma, &what);
            assert_close(found.equivalent(), mu_eq, DIGITS, mu_eq, &what);
            combinations += 1;
        }
        let outcome = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap();
        let best = &outcome.best;
        assert_eq!(best.touched(), edges::<4>(&wanted["edges"]), "part {i}");
        let q = number(&wanted["q"]);
        assert_close(best.quality.value, q, DIGITS, q, format!("part {i}"));
        let center = numbers(&wanted["center"]);
        assert_all_close(&best.center().to_array(), &center, 1e-7, format!("center of part {i}"));
        assert!(outcome.combinations.total >= list(&wanted["combos"]).len() as f64);
    }
    assert_eq!(combinations, 40);
}

/// All combinations that the cases do not list must be refused.
#[test]
fn combinations_that_cannot_close_have_no_placement() {
    let (_, cases) = &matching("polygon_four_finger")[0];
    for case in list(cases) {
        let part = part(case);
        let listed: Vec<[usize; 4]> =
            list(&case["four_finger"]["combos"]).iter().map(|c| edges(&c[0])).collect();
        let n = part.outline().edges().len();
        for a in 0..n {
            for b in a..n {
                for c in b..n {
                    for d in c..n {
                        let found = four_fingers_on(&part, [a, b, c, d], &Fingers::new(4)).unwrap();
                        let expected = listed.contains(&[a, b, c, d]);
                        assert_eq!(found.is_some(), expected, "{:?}", [a, b, c, d]);
                    }
                }
            }
        }
    }
}

#[test]
fn three_fingers_reach_the_optimum_of_each_triplet() {
    let (_, cases) = &matching("polygon_three_finger")[0];
    for (i, case) in list(cases).iter().enumerate() {
        let part = part(case);
        let options = ThreeFingers {
            finger_radius: number(&case["finger_radius"]),
            ..ThreeFingers::with_preload(number(&case["total_preload"]))
        };
        for triplet in list(&case["triplets"]) {
            let edges: [usize; 3] = edges(&triplet["edges"]);
            let what = format!("part {i}, edges {edges:?}");
            let found = three_fingers_on(&part, edges, &options).unwrap().expect(&what);
            let (q, mu_eq) = (number(&triplet["q"]), number(&triplet["mu_eq"]));
            let sigma = number(&triplet["sigma_min"]);
            assert_close(found.quality.value, q, DIGITS, q, &what);
            assert_close(found.quality.equivalent(), mu_eq, DIGITS, mu_eq, &what);
            assert_close(found.quality.translational, sigma, DIGITS, sigma, &what);
            let meeting = numbers(&triplet["concurrency"]);
            assert_all_close(&found.center().to_array(), &meeting, DIGITS, &what);
        }
        let outcome = three_fingers(&part, &options, &Effort::default(), unwatched).unwrap();
        let q = number(&case["best_q"]);
        assert_close(outcome.best.quality.value, q, DIGITS, q, format!("part {i}"));
        assert_eq!(outcome.best.touched(), edges::<3>(&case["best_edges"]));
    }
}
