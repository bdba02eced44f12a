//! Best placements: one combination of edges, and all combinations of outlines of growing size.
#![allow(missing_docs, clippy::unwrap_used, reason = "a measurement, not an interface")]
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small numbers")]

use std::hint::black_box;
use std::time::{Duration, Instant};

use clench::optimize::polygon::{
    Fingers, Part, ThreeFingers, fingers, four_fingers_on, three_fingers,
};
use clench::optimize::{Effort, Objective, Outcome, unwatched};
use clench::shape::Polygon;
use clench_benches::smooth_part;
use clench_testkit::cases::{array, list, matching, numbers};
use criterion::{BatchSize, BenchmarkId, Criterion, criterion_group, criterion_main};

/// Each closing combination of the reference polygons: the mean over all of them in turn, and the
/// median combination, found by a short run of each.
fn one_combination(c: &mut Criterion) {
    let (_, cases) = &matching("polygon_four_finger")[0];
    let mut combinations = Vec::new();
    for case in list(cases) {
        let corners: Vec<[f64; 2]> = list(&case["vertices"]).iter().map(array).collect();
        let stiffness = numbers(&case["edge_stiffness"]);
        let part = Part::new(Polygon::new(&corners).unwrap(), stiffness).unwrap();
        for combination in list(&case["four_finger"]["combos"]) {
            let edges = numbers(&combination[0]).into_iter().map(|e| e as usize);
            let edges: [usize; 4] = edges.collect::<Vec<_>>().try_into().unwrap();
            combinations.push((part.clone(), edges));
        }
    }
    let asked = Fingers::new(4);
    let short_run = |(part, edges): &(Part, [usize; 4])| {
        let start = Instant::now();
        (0..400).for_each(|_| {
            black_box(four_fingers_on(black_box(part), *edges, &asked)).unwrap();
        });
        start.elapsed()
    };
    combinations.sort_by_cached_key(short_run);
    let mut group = c.benchmark_group("one four-finger combination, exactly");
    for (name, place) in [("median", combinations.len() / 2), ("slowest", combinations.len() - 1)] {
        let (part, edges) = &combinations[place];
        group.bench_function(name, |b| b.iter(|| four_fingers_on(black_box(part), *edges, &asked)));
    }
    group.finish();
}

/// Outlines of each size; the fastest and the slowest of them differ by a factor of ten.
const SEEDS: std::ops::RangeInclusive<u64> = 1..=12;

/// Whole outlines, with all that an outline has to be asked for the first time, proved to the last
/// digit or to a gap.
fn whole_outlines(c: &mut Criterion) {
    let four = |part: &Part, gap: f64| {
        let effort = Effort { gap, ..Effort::default() };
        fingers(part, &Fingers::new(4), &effort, unwatched).unwrap()
    };
    let three = |part: &Part, _: f64| {
        let asked = ThreeFingers::with_preload(1.0);
        three_fingers(part, &asked, &Effort::default(), unwatched).unwrap()
    };
    let mut group = c.benchmark_group("whole outlines");
    group.sample_size(10);
    group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    let mut measure =
        |name: &str, edges, gap: f64, search: &dyn Fn(&Part, f64) -> Outcome<2, 1>| {
            for seed in SEEDS {
                let id = BenchmarkId::new(format!("{name}, {edges} edges"), seed);
                let outline = || smooth_part(edges, seed);
                group.bench_function(id, |b| {
                    b.iter_batched_ref(outline, |part| search(part, gap), BatchSize::LargeInput);
                });
            }
        };
    for edges in [20, 100, 1000, 10_000] {
        measure("four fingers", edges, 0.0, &four);
    }
    measure("four fingers to 0.1 %", 10_000, 1e-3, &four);
    for edges in [100, 1000] {
        measure("three fingers", edges, 0.0, &three);
    }
    group.finish();
}

/// What has no closed form: more fingers, and the worst point, to a gap.
fn closing_in(c: &mut Criterion) {
    let part = smooth_part(50, 7);
    let mut group = c.benchmark_group("to 0.01 %");
    group.sample_size(10).measurement_time(Duration::from_secs(3));
    let effort = Effort { gap: 1e-4, ..Effort::default() };
    let worst_point = Fingers { objective: Objective::WorstPoint, ..Fingers::new(4) };
    for (name, asked) in [
        ("worst point by four fingers", worst_point),
        ("five fingers", Fingers::new(5)),
        ("six fingers", Fingers::new(6)),
    ] {
        group.bench_function(name, |b| {
            b.iter(|| fingers(&part, &asked, &effort, unwatched).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, one_combination, whole_outlines, closing_in);
criterion_main!(benches);
