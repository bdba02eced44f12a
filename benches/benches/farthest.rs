//! How far bodies of growing size reach: from points, under motions, and where they are softest.
#![allow(missing_docs, clippy::unwrap_used, reason = "a measurement, not an interface")]

use std::hint::black_box;

use clench::metrics::{Principal, WorstPoint};
use clench::screw::{Stiffness, Twist, Vector, Wrench};
use clench::shape::{Extent, ExtremePoints, Polygon};
use clench_testkit::Random;
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

/// Corners on an ellipse: all of them are corners of the hull, the hard case.
fn ellipse(corners: u32) -> Vec<[f64; 2]> {
    let angle = |i| std::f64::consts::TAU * f64::from(i) / f64::from(corners);
    (0..corners).map(|i| [10.0 * angle(i).cos(), 7.0 * angle(i).sin()]).collect()
}

fn farthest(c: &mut Criterion) {
    let r = &mut Random::new(1);
    let points: Vec<Vector<2>> = (0..256).map(|_| r.array(4.0).into()).collect();
    let mut group = c.benchmark_group("256 farthest corners");
    for corners in [8, 32, 128, 1_024, 8_192] {
        let outline = Polygon::new(&ellipse(corners)).unwrap();
        group.bench_with_input(BenchmarkId::new("partition", corners), &outline, |b, outline| {
            b.iter(|| points.iter().map(|&p| outline.farthest(p).distance).sum::<f64>());
        });
        group.bench_with_input(BenchmarkId::new("all corners", corners), &outline, |b, outline| {
            let distance = |p: Vector<2>| {
                outline.corners().iter().map(|&c| (c - p).norm_squared()).fold(0.0, f64::max).sqrt()
            };
            b.iter(|| points.iter().map(|&p| distance(p)).sum::<f64>());
        });
    }
    group.finish();
}

fn build(c: &mut Criterion) {
    let mut group = c.benchmark_group("validated outline with its partition");
    for corners in [8, 128, 1_024, 8_192] {
        let corners_given = ellipse(corners);
        group.bench_with_input(BenchmarkId::from_parameter(corners), &corners_given, |b, given| {
            b.iter(|| Polygon::new(black_box(given)).unwrap());
        });
    }
    group.finish();
}

/// Vertices on an ellipsoid: all of them are vertices of the hull, the hard case.
fn ellipsoid(vertices: usize, r: &mut Random) -> Vec<[f64; 3]> {
    let vertex = |r: &mut Random| {
        let [x, y, z] = loop {
            if let Some(unit) = Vector::<3>::from(r.array(1.0)).direction() {
                break unit.to_array();
            }
        };
        [3.0 * x, 2.0 * y, z]
    };
    (0..vertices).map(|_| vertex(r)).collect()
}

/// The stiffness of seven springs at random places.
fn random_principal(r: &mut Random) -> Principal<3, 3> {
    let spring = |r: &mut Random| (Vector::from(r.array(2.0)), Vector::from(r.array(1.0)));
    let springs: Vec<_> = (0..7).map(|_| spring(r)).collect();
    Principal::near(Vector::ZERO, |origin| {
        springs.iter().fold(Stiffness::ZERO, |sum, &(point, normal)| {
            sum + Stiffness::outer(&Wrench::of_force_at(normal, point - origin))
        })
    })
    .unwrap()
}

fn reach(c: &mut Criterion) {
    let r = &mut Random::new(2);
    let twists: Vec<Twist<3, 3>> = (0..64)
        .map(|_| Twist { linear: r.array(1.0).into(), angular: r.array(1.0).into() })
        .collect();
    let grasps: Vec<Principal<3, 3>> = (0..64).map(|_| random_principal(r)).collect();
    let mut group = c.benchmark_group("64 times on a hull in space");
    for vertices in [8, 100, 10_000] {
        let points = ellipsoid(vertices, r);
        let hull = ExtremePoints::new(&points).unwrap();
        group.bench_with_input(BenchmarkId::new("fastest point", vertices), &hull, |b, hull| {
            let fastest = |twist| Extent::from(hull).fastest(Vector::ZERO, twist).value;
            b.iter(|| twists.iter().map(fastest).sum::<f64>());
        });
        group.bench_with_input(BenchmarkId::new("all vertices", vertices), &hull, |b, hull| {
            let fastest = |twist: &Twist<3, 3>| {
                let speed = |&p: &Vector<3>| twist.velocity_at(p).norm_squared();
                hull.points().iter().map(speed).fold(0.0, f64::max).sqrt()
            };
            b.iter(|| twists.iter().map(fastest).sum::<f64>());
        });
        group.bench_with_input(BenchmarkId::new("worst point", vertices), &hull, |b, hull| {
            let worst = |principal| WorstPoint::of(principal, hull).unwrap().stiffness;
            b.iter(|| grasps.iter().map(worst).sum::<f64>());
        });
        if vertices > 8 {
            group.bench_with_input(BenchmarkId::new("hull", vertices), &points, |b, points| {
                b.iter(|| ExtremePoints::new(black_box(points)).unwrap());
            });
        }
    }
    group.finish();
}

criterion_group!(benches, farthest, build, reach);
criterion_main!(benches);
