//! Best placements: one combination of edges, and all combinations of outlines of growing size.
#![allow(missing_docs, clippy::unwrap_used, reason = "a measurement, not an interface")]
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small numbers")]

use std::hint::black_box;
use std::time::{Duration, Instant};

use clench::optimize::polygon::{
    FourFingers, Part, ThreeFingers, four_fingers, four_fingers_on, three_fingers,
};
use clench::shape::Polygon;
use clench_benches::smooth_part;
use clench_testkit::cases::{array, list, matching, numbers};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

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
    let short_run = |(part, edges): &(Part, [usize; 4])| {
        let start = Instant::now();
        (0..400).for_each(|_| {
            black_box(four_fingers_on(black_box(part), *edges)).unwrap();
        });
        start.elapsed()
    };
    combinations.sort_by_cached_key(short_run);
    let mut group = c.benchmark_group("one four-finger combination, exactly");
    for (name, place) in [("median", combinations.len() / 2), ("slowest", combinations.len() - 1)] {
        let (part, edges) = &combinations[place];
        group.bench_function(name, |b| b.iter(|| four_fingers_on(black_box(part), *edges)));
    }
    group.finish();
}

fn all_combinations(c: &mut Criterion) {
    let mut group = c.benchmark_group("all combinations");
    group.sample_size(10).measurement_time(Duration::from_secs(10));
    for edges in [10, 30, 100] {
        let part = smooth_part(edges, 7);
        group.bench_with_input(BenchmarkId::new("four fingers", edges), &part, |b, part| {
            b.iter(|| four_fingers(part, &FourFingers::default(), |_| {}).unwrap());
        });
        group.bench_with_input(BenchmarkId::new("three fingers", edges), &part, |b, part| {
            b.iter(|| three_fingers(part, &ThreeFingers::with_preload(1.0), |_| {}).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, one_combination, all_combinations);
criterion_main!(benches);
