//! A million random grasps of a cube in one parallel batch, one more step at a time.
#![allow(missing_docs, clippy::unwrap_used, reason = "a measurement, not an interface")]

use std::hint::black_box;
use std::time::Duration;

use clench::metrics::{EquivalentStiffness, Principal, Quality, WorstPoint};
use clench::screw::{Stiffness, Vector, Wrench};
use clench::shape::ExtremePoints;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use rayon::prelude::*;

const GRASPS: u64 = 1_000_000;

/// A finger: where it touches, the inward normal, and its stiffness.
type Finger = (Vector<3>, Vector<3>, f64);

/// Seven fingers on the faces of a cube of side 2, all different for each number.
fn fingers(grasp: u64) -> [Finger; 7] {
    let mut state = grasp.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut unit = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    [0, 1, 2, 3, 4, 5, 0].map(|face| {
        let (axis, side) = (face / 2, if face % 2 == 0 { 1.0 } else { -1.0 });
        let (a, b) = (unit(), unit());
        let point = Vector::from_fn(|i| match (i + 3 - axis) % 3 {
            0 => side,
            1 => a,
            _ => b,
        });
        let normal = Vector::from_fn(|i| if i == axis { -side } else { 0.0 });
        (point, normal, 1.5 + unit())
    })
}

fn stiffness(fingers: &[Finger; 7], origin: Vector<3>) -> Stiffness<3, 3> {
    fingers.iter().fold(Stiffness::ZERO, |sum, &(point, normal, k)| {
        sum + Stiffness::outer(&Wrench::of_force_at(normal, point - origin)) * k
    })
}

fn principal(fingers: &[Finger; 7]) -> Option<Principal<3, 3>> {
    let share = 1.0 / 7.0;
    let middle = fingers.iter().fold(Vector::ZERO, |sum, finger| sum + finger.0 * share);
    Principal::near(middle, |origin| stiffness(fingers, origin)).ok()
}

fn batch(c: &mut Criterion) {
    let corner = |i: usize| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { 1.0 } else { -1.0 });
    let cube = ExtremePoints::new(&(0..8).map(corner).collect::<Vec<_>>()).unwrap();
    let mut group = c.benchmark_group("a million grasps of 7 contacts on 8 vertices");
    group.sample_size(10).warm_up_time(Duration::from_secs(1));
    group.throughput(Throughput::Elements(GRASPS));
    let largest = |evaluate: &(dyn Fn(&[Finger; 7]) -> Option<f64> + Sync)| {
        (0..GRASPS)
            .into_par_iter()
            .filter_map(|grasp| evaluate(black_box(&fingers(grasp))))
            .reduce(|| 0.0, f64::max)
    };
    group.bench_function("1 fingers", |b| {
        b.iter(|| largest(&|fingers| Some(fingers[6].2)));
    });
    group.bench_function("2 and K, twice", |b| {
        b.iter(|| {
            largest(&|fingers| {
                let once = stiffness(fingers, fingers[0].0);
                Some(once.entry(0, 0) + stiffness(fingers, fingers[1].0).entry(5, 5))
            })
        });
    });
    group.bench_function("3 and principal parameters", |b| {
        b.iter(|| largest(&|fingers| Some(principal(fingers)?.rotational().values[0])));
    });
    group.bench_function("4 and Q", |b| {
        b.iter(|| largest(&|fingers| Some(Quality::of(&principal(fingers)?, &cube).ok()?.value)));
    });
    group.bench_function("5 and Q_V", |b| {
        b.iter(|| {
            largest(&|fingers| {
                let principal = principal(fingers)?;
                let quality = Quality::of(&principal, &cube).ok()?.value;
                Some(quality.min(EquivalentStiffness::least(&principal, &cube).ok()?.value))
            })
        });
    });
    group.bench_function("6 and Q_pt", |b| {
        b.iter(|| {
            largest(&|fingers| {
                let principal = principal(fingers)?;
                let quality = Quality::of(&principal, &cube).ok()?.value;
                let least = EquivalentStiffness::least(&principal, &cube).ok()?.value;
                Some(quality.min(least).min(WorstPoint::of(&principal, &cube).ok()?.stiffness))
            })
        });
    });
    group.finish();
}

criterion_group!(benches, batch);
criterion_main!(benches);
