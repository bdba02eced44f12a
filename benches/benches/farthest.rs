//! Farthest corners and smallest circles of outlines of growing size.
#![allow(missing_docs, clippy::unwrap_used, reason = "a measurement, not an interface")]

use std::hint::black_box;

use clench::screw::Vector;
use clench::shape::Polygon;
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

criterion_group!(benches, farthest, build);
criterion_main!(benches);
