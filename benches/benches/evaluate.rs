//! Stiffness and quality of one given grasp.
#![allow(missing_docs, clippy::unwrap_used, reason = "a measurement, not an interface")]

use std::hint::black_box;

use clench::contact::{Contact, Geometry, Law, Order};
use clench::metrics::{Principal, Quality, WorstPoint};
use clench::shape::Polygon;
use clench::stiffness::Grasp;
use criterion::{Criterion, criterion_group, criterion_main};

fn planar(c: &mut Criterion) {
    let outline = Polygon::new(&[[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]]).unwrap();
    let law = Law::linear(1.0).unwrap();
    let places = [(0, 1.3, 0.111), (0, 11.7, 0.111), (1, 4.47, 0.298), (3, 2.61, 0.281)];
    let contacts = places.map(|(edge, along, preload)| {
        let edge = &outline.edges()[edge];
        Contact::new(
            Geometry::on_face(edge.point_at(along), edge.inward_normal(), 0.5),
            law.clone(),
            preload,
        )
        .unwrap()
    });
    let grasp = Grasp::new(contacts.to_vec()).unwrap();
    let principal = |grasp: &Grasp<2, 1>, order| {
        Principal::near(grasp.centroid(), |origin| grasp.stiffness(origin, order)).unwrap()
    };
    let mut group = c.benchmark_group("planar grasp of 4 contacts");
    group.bench_function("K to second order", |b| {
        b.iter(|| black_box(&grasp).stiffness(grasp.centroid(), Order::Second));
    });
    group.bench_function("K and Q to first order", |b| {
        b.iter(|| Quality::of(&principal(black_box(&grasp), Order::First), &outline));
    });
    group.bench_function("K and Q to second order", |b| {
        b.iter(|| Quality::of(&principal(black_box(&grasp), Order::Second), &outline));
    });
    let known = principal(&grasp, Order::Second);
    group.bench_function("worst point", |b| {
        b.iter(|| WorstPoint::of(black_box(&known), &outline).unwrap());
    });
    group.bench_function("preloads and force closure", |b| {
        b.iter(|| black_box(&grasp).preloads().unwrap());
    });
    group.bench_function("stability class", |b| b.iter(|| black_box(&grasp).stability()));
    group.finish();
}

criterion_group!(benches, planar);
criterion_main!(benches);
