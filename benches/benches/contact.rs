//! One contact from its curvatures, and the stiffness of a grasp in space.
#![allow(missing_docs, clippy::unwrap_used, reason = "a measurement, not an interface")]

use std::hint::black_box;

use clench::contact::{Contact, Curvature, Geometry, Hertz, Law, Order};
use clench::screw::Vector;
use clench::shape::Ellipsoid;
use clench::stiffness::Grasp;
use clench_testkit::Random;
use criterion::{Criterion, criterion_group, criterion_main};

fn one_contact(c: &mut Criterion) {
    let skewed = Geometry {
        point: Vector::new([3.0, -1.0, 2.0]),
        inward_normal: Vector::new([0.48, 0.6, 0.64]),
        finger: Curvature::principal_radii([5.0, 12.0], Vector::new([1.0, 0.0, 0.0])),
        part: Curvature::principal_radii([40.0, 9.0], Vector::new([0.0, 1.0, 0.3])),
    };
    let mut group = c.benchmark_group("elliptic Hertz contact");
    group.bench_function("from curvatures to stiffness", |b| {
        b.iter(|| {
            let law = Law::hertz(58.6e3, black_box(&skewed)).unwrap();
            let contact = Contact::<3, 3>::new(skewed, law, 200.0).unwrap();
            contact.stiffness(Vector::ZERO, Order::Second)
        });
    });
    group.bench_function("relative curvature", |b| {
        b.iter(|| black_box(&skewed).relative_curvature().unwrap());
    });
    for ratio in [1.5, 10.0, 1e3] {
        group.bench_function(format!("ellipse of curvatures 1 : {ratio}"), |b| {
            b.iter(|| Hertz::elliptic(58.6e3, black_box([0.05, 0.05 * ratio])).unwrap());
        });
    }
    group.finish();
}

/// Seven fingers on a cube, or on an ellipsoid, at random places.
fn spatial(c: &mut Criterion) {
    let r = &mut Random::new(7);
    let law = || Law::linear(1000.0).unwrap();
    let flat = (0..7).map(|i| {
        let (axis, side) = (i % 3, if i % 2 == 0 { 1.0 } else { -1.0 });
        let mut point = r.array::<3>(1.0);
        point[axis] = side;
        let normal = Vector::from_fn(|k| if k == axis { -side } else { 0.0 });
        Contact::<3, 3>::new(Geometry::on_face(point.into(), normal, 0.5), law(), 10.0).unwrap()
    });
    let flat = Grasp::new(flat.collect()).unwrap();
    let body = Ellipsoid::new(Vector::ZERO, [1.0, 1.5, 0.9]).unwrap();
    let curved = (0..7).map(|_| {
        let touched = body.at_normal(r.array::<3>(1.0).into()).unwrap();
        let place = Geometry {
            point: touched.point,
            inward_normal: touched.inward_normal,
            finger: Curvature::round(2.0),
            part: Curvature::of_shape_operator(touched.shape_operator),
        };
        Contact::<3, 3>::new(place, law(), 10.0).unwrap()
    });
    let curved = Grasp::new(curved.collect()).unwrap();
    let mut group = c.benchmark_group("K of 7 contacts in space");
    for (name, grasp) in [("flat faces", &flat), ("curved faces", &curved)] {
        for (order_name, order) in [("first", Order::First), ("second", Order::Second)] {
            group.bench_function(format!("{name}, {order_name} order"), |b| {
                b.iter(|| black_box(grasp).stiffness(grasp.centroid(), order));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, one_contact, spatial);
criterion_main!(benches);
