//! Stiffness, principal parameters and measures of one given grasp, in the plane and in space.
#![allow(missing_docs, clippy::unwrap_used, reason = "a measurement, not an interface")]

use std::hint::black_box;

use clench::contact::{Change, Contact, Geometry, Law, Order};
use clench::metrics::{EquivalentStiffness, Principal, Quality, Sensitivity, WorstPoint};
use clench::screw::Vector;
use clench::shape::{Ellipsoid, Extent, ExtremePoints, Polygon};
use clench::stiffness::Grasp;
use criterion::{Criterion, criterion_group, criterion_main};

fn principal<const N: usize, const M: usize>(grasp: &Grasp<N, M>, order: Order) -> Principal<N, M> {
    Principal::near(grasp.centroid(), |origin| grasp.stiffness(origin, order)).unwrap()
}

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
    let grasp = Grasp::<2, 1>::new(contacts.to_vec()).unwrap();
    let mut group = c.benchmark_group("planar grasp of 4 contacts");
    group.bench_function("K to second order", |b| {
        b.iter(|| black_box(&grasp).stiffness(grasp.centroid(), Order::Second));
    });
    group.bench_function("K and Q to first order", |b| {
        b.iter(|| Quality::of(&principal(black_box(&grasp), Order::First), &outline).unwrap());
    });
    group.bench_function("K and Q to second order", |b| {
        b.iter(|| Quality::of(&principal(black_box(&grasp), Order::Second), &outline).unwrap());
    });
    group.bench_function("K and principal parameters", |b| {
        b.iter(|| principal(black_box(&grasp), Order::First));
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

/// Seven pointed fingers on a cube of side 2: three below, two behind, one aside, one on top.
fn seven_on_a_cube() -> Grasp<3, 3> {
    let fingers = [
        ([-0.7, -0.6, -1.0], [0.0, 0.0, 1.0]),
        ([0.8, -0.5, -1.0], [0.0, 0.0, 1.0]),
        ([0.1, 0.7, -1.0], [0.0, 0.0, 1.0]),
        ([-0.6, -1.0, 0.1], [0.0, 1.0, 0.0]),
        ([0.7, -1.0, -0.2], [0.0, 1.0, 0.0]),
        ([-1.0, 0.2, 0.3], [1.0, 0.0, 0.0]),
        ([0.2, 0.3, 1.0], [-0.3, -0.2, -1.0]),
    ];
    let contact = |(i, (point, normal)): (usize, ([f64; 3], [f64; 3]))| {
        let normal = Vector::from(normal).direction().unwrap();
        let law = Law::linear(1000.0 + 100.0 * i as f64).unwrap();
        Contact::new(Geometry::on_face(point.into(), normal, 0.2), law, 10.0).unwrap()
    };
    Grasp::new(fingers.into_iter().enumerate().map(contact).collect()).unwrap()
}

/// The sum of the derivatives by two directions of the place, the stiffness and the preload of each
/// contact.
fn derivatives(grasp: &Grasp<3, 3>, known: &Principal<3, 3>, body: Extent<'_, 3>) -> f64 {
    let least = EquivalentStiffness::least(known, body).unwrap();
    let worst = WorstPoint::of(known, body).unwrap();
    let of_least = Sensitivity::of_least(known, &least, body).unwrap();
    let of_worst = Sensitivity::of_worst_point(known, &worst, body).unwrap();
    let by_contact = |contact: &Contact<3, 3>| {
        let places = contact.overlap().tangents().into_iter().map(Change::along);
        let changes = places.chain([Change::Stiffness, Change::Preload]);
        let by_change = |change: Change<3>| {
            let rate = contact.stiffness_rate(&change, of_worst.origin(), Order::Second).unwrap();
            of_least.along(&rate) + of_worst.along(&rate)
        };
        changes.map(by_change).sum::<f64>()
    };
    grasp.contacts().iter().map(by_contact).sum()
}

fn spatial(c: &mut Criterion) {
    let grasp = seven_on_a_cube();
    let corner = |i: usize| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { 1.0 } else { -1.0 });
    let cube = ExtremePoints::new(&(0..8).map(corner).collect::<Vec<_>>()).unwrap();
    let known = principal(&grasp, Order::First);
    let mut group = c.benchmark_group("spatial grasp of 7 contacts on 8 vertices");
    group.bench_function("K to first order, twice", |b| {
        b.iter(|| {
            let rough = black_box(&grasp).stiffness(grasp.centroid(), Order::First);
            (rough, grasp.stiffness(black_box(Vector::ZERO), Order::First))
        });
    });
    group.bench_function("K and principal parameters", |b| {
        b.iter(|| principal(black_box(&grasp), Order::First));
    });
    group.bench_function("K and Q", |b| {
        b.iter(|| Quality::of(&principal(black_box(&grasp), Order::First), &cube).unwrap());
    });
    group.bench_function("everything", |b| {
        b.iter(|| {
            let principal = principal(black_box(&grasp), Order::First);
            let axes = (principal.twist_axes(), principal.wrench_axes());
            let quality = Quality::of(&principal, &cube).unwrap();
            let least = EquivalentStiffness::least(&principal, &cube).unwrap();
            (axes, quality, least, WorstPoint::of(&principal, &cube).unwrap())
        });
    });
    group.bench_function("of it Q", |b| b.iter(|| Quality::of(black_box(&known), &cube).unwrap()));
    group.bench_function("of it Q_V", |b| {
        b.iter(|| EquivalentStiffness::least(black_box(&known), &cube).unwrap());
    });
    group.bench_function("of it Q_pt", |b| {
        b.iter(|| WorstPoint::of(black_box(&known), &cube).unwrap());
    });
    group.bench_function("all derivatives of Q_V and Q_pt by its contacts", |b| {
        b.iter(|| derivatives(black_box(&grasp), &known, (&cube).into()));
    });
    let ball = Ellipsoid::new(Vector::ZERO, [1.0, 1.3, 0.8]).unwrap();
    group.bench_function("Q_pt of an ellipsoid instead", |b| {
        b.iter(|| WorstPoint::of(black_box(&known), Extent::from(&ball)).unwrap());
    });
    group.finish();
}

criterion_group!(benches, planar, spatial);
criterion_main!(benches);
