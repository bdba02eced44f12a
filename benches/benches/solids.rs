//! Placements on solids: with given contacts to a gap, a fixed number of nodes for seven free
//! fingers, and the best of many candidates.
#![allow(missing_docs, clippy::unwrap_used, reason = "a measurement, not an interface")]

use std::time::Duration;

use clench::optimize::polyhedron::{Fingers, Part, Touch, fingers, fingers_among};
use clench::optimize::{Effort, unwatched};
use clench::shape::Polyhedron;
use clench_testkit::solids::{self, Mesh};
use criterion::{BatchSize, Criterion, criterion_group, criterion_main};

fn part((vertices, faces): &Mesh) -> Part {
    Part::uniform(Polyhedron::new(vertices, faces).unwrap(), 1.0, 0.0).unwrap()
}

/// Three locators under an L, two behind it, one beside it.
fn locators() -> Vec<Touch> {
    let touch = |point: [f64; 3], normal: [f64; 3]| Touch {
        point: point.into(),
        inward_normal: normal.into(),
        stiffness: 1.0,
    };
    vec![
        touch([0.3, 0.3, -1.0], [0.0, 0.0, 1.0]),
        touch([3.7, 0.5, -1.0], [0.0, 0.0, 1.0]),
        touch([0.5, 2.7, -1.0], [0.0, 0.0, 1.0]),
        touch([0.5, 0.0, 0.0], [0.0, 1.0, 0.0]),
        touch([3.5, 0.0, 0.2], [0.0, 1.0, 0.0]),
        touch([0.0, 2.5, 0.1], [1.0, 0.0, 0.0]),
    ]
}

/// The middles of triangles that all faces are cut into again and again.
fn candidates(part: &Part, splits: u32) -> Vec<Touch> {
    let mut found = Vec::new();
    for facet in part.facets() {
        let mut triangles = facet.triangles().to_vec();
        for _ in 0..splits {
            triangles = triangles
                .into_iter()
                .flat_map(|[a, b, c]| {
                    let [p, q, s] = [(a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5];
                    [[a, p, s], [p, b, q], [s, q, c], [p, q, s]]
                })
                .collect();
        }
        found.extend(triangles.into_iter().map(|[a, b, c]| Touch {
            point: (a + b + c) * (1.0 / 3.0),
            inward_normal: facet.inward_normal(),
            stiffness: 1.0,
        }));
    }
    found
}

fn placements(c: &mut Criterion) {
    let mut group = c.benchmark_group("solids");
    group.sample_size(10);
    group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(3));
    let angle = part(&solids::angle());
    let clamps = |count| Fingers { fixed: locators(), ..Fingers::new(count) };
    for (name, count, gap) in [("three clamps to 5 %", 3, 0.05), ("three clamps to 1 %", 3, 0.01)] {
        let effort = Effort { gap, ..Effort::default() };
        group.bench_function(name, |b| {
            b.iter(|| fingers(&angle, &clamps(count), &effort, unwatched).unwrap());
        });
    }
    // What a node costs: the difference of these by that of their nodes.
    for nodes in [1, 20_000] {
        let effort = Effort { nodes: Some(nodes), ..Effort::default() };
        let cube = part(&solids::cuboid([1.0, 1.0, 1.0]));
        group.bench_function(format!("seven fingers on a cube, {nodes} nodes"), |b| {
            b.iter(|| fingers(&cube, &Fingers::new(7), &effort, unwatched).unwrap());
        });
    }
    let all = candidates(&angle, 4);
    let body = angle.solid().extreme_points();
    let effort = Effort { gap: 0.05, ..Effort::default() };
    group.bench_function(format!("three clamps of {} candidates to 5 %", all.len()), |b| {
        b.iter(|| fingers_among(body, &all, &clamps(3), &effort, unwatched).unwrap());
    });
    group.finish();
}

/// What it takes to see the facets of a mesh.
fn facets(c: &mut Criterion) {
    let mut group = c.benchmark_group("facets");
    group.sample_size(10);
    let globe = solids::globe(100, [1.0, 2.0, 3.0]);
    group.bench_function("the solid of 19,800 triangles", |b| {
        b.iter_batched_ref(
            || globe.clone(),
            |globe| Polyhedron::from_triangles(globe).unwrap(),
            BatchSize::LargeInput,
        );
    });
    let solid = Polyhedron::from_triangles(&globe).unwrap();
    group.bench_function("its facets", |b| b.iter(|| solid.facets(0.0)));
    group.finish();
}

criterion_group!(benches, placements, facets);
criterion_main!(benches);
