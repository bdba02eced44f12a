//! Properties that hold for every outline, point and segment.

use std::f64::consts::TAU;

use clench_screw::{Vector, planar};
use clench_shape::{Circle, Polygon, Winding};
use clench_testkit::{Random, assert_all_close, assert_close};

/// A distance is the root of two squared differences: three roundings, on both sides, and the
/// search may be wrong by as much again where corners are equally far.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

type Corners = Vec<[f64; 2]>;

/// The outline, or none where rounding made its corners coincide or edges meet.
fn outline(corners: &[[f64; 2]]) -> Option<Polygon> {
    Polygon::new(corners).ok()
}

fn regular(n: usize) -> Corners {
    (0..n).map(|i| TAU * i as f64 / n as f64).map(|a| [a.cos(), a.sin()]).collect()
}

/// A rectangle whose long sides bulge by `sagitta`, with `n` corners on each.
fn bowed(n: usize, sagitta: f64) -> Corners {
    let side = |y: f64, sign: f64| {
        (0..=n).map(move |i| {
            let x = 2.0 * i as f64 / n as f64 - 1.0;
            [x * sign, (y + sagitta * (1.0 - x * x)) * sign]
        })
    };
    side(-0.3, 1.0)
        .map(|[x, y]| [x, y - 2.0 * sagitta * (1.0 - x * x)])
        .chain(side(0.3, -1.0).map(|[x, y]| [x, -y]))
        .collect()
}

/// Corners in groups whose members are a few roundings to 1e-3 apart, about a center.
fn clustered(r: &mut Random, groups: usize) -> Corners {
    let mut corners: Corners = Vec::new();
    for i in 0..groups {
        let angle = TAU * (i as f64 + r.between(0.1, 0.9)) / groups as f64;
        let size = 10_f64.powf(r.between(-16.3, -3.0));
        for _ in 0..=r.below(4) {
            let [dx, dy] = r.array(size);
            corners.push([angle.cos() + dx, angle.sin() + dy]);
        }
    }
    corners.sort_by(|a, b| a[1].atan2(a[0]).total_cmp(&b[1].atan2(b[0])));
    corners
}

/// All whole-number points at one distance from the origin: exactly on one circle.
fn cocircular(squared: i32) -> Corners {
    let reach = squared.isqrt();
    let whole = (-reach..=reach).flat_map(|x| (-reach..=reach).map(move |y| (x, y)));
    let mut corners: Corners = whole
        .filter(|(x, y)| x * x + y * y == squared)
        .map(|(x, y)| [f64::from(x), f64::from(y)])
        .collect();
    corners.sort_by(|a, b| a[1].atan2(a[0]).total_cmp(&b[1].atan2(b[0])));
    corners
}

/// Outlines of all kinds: random, regular, cocircular, nearly straight, with tiny edges.
fn outlines(r: &mut Random) -> Vec<Polygon> {
    let mut all: Vec<Corners> = vec![
        cocircular(5 * 5 * 13 * 13 * 17),
        cocircular(65),
        vec![[0.0, 0.0], [7.0, 0.0], [7.0, 2.0], [0.0, 2.0]],
    ];
    all.extend([3, 4, 5, 8, 32, 33, 34, 64, 360, 2000].map(regular));
    all.extend([3, 4, 5, 9, 32, 33, 55, 200, 2000].map(|n| r.convex(n)));
    all.extend([3, 5, 20, 300].map(|n| r.star(n)));
    for sagitta in [0.0, 1e-15, 1e-13, 1e-10, 1e-6, 1e-2, 0.5] {
        all.extend([1, 3, 20, 200].map(|n| bowed(n, sagitta)));
    }
    all.extend((0..200).map(|i| clustered(r, 3 + i % 80)));
    let valid: Vec<Polygon> = all.iter().filter_map(|corners| outline(corners)).collect();
    assert!(valid.len() > 100, "only {} valid outlines", valid.len());
    valid
}

fn brute_force(part: &Polygon, point: Vector<2>) -> f64 {
    part.corners().iter().fold(0.0, |m: f64, &corner| m.max((point - corner).norm()))
}

/// Points where a search could go wrong, out to a thousand radii.
fn queries(r: &mut Random, part: &Polygon) -> Vec<Vector<2>> {
    let circle = part.enclosing_circle();
    let mut points = vec![circle.center];
    for share in [1e-9, 0.3, 1.0, 5.0, 1e3] {
        points.extend((0..20).map(|_| circle.center + Vector::new(r.array(share)) * circle.radius));
    }
    for boundary in part.partition().borders().iter().take(60) {
        points.push(boundary.middle);
        for reach in [1.0, 30.0, 1e3] {
            let around = Circle { radius: reach * circle.radius, ..circle };
            points.extend(boundary.within(around).into_iter().flatten());
        }
    }
    // On the rays from the circumcentres away from the corners, and behind them.
    for (region, i) in part.partition().regions().iter().zip(0..60) {
        let corner = part.corners()[region.corner];
        points.push(corner);
        let number = region.borders[i % region.borders.len()];
        let border = &part.partition().borders()[number];
        let away = border.point_at(border.from) - corner;
        points.extend([-0.5, 0.2, 1.0, 1.5].map(|share| corner + away * share));
    }
    points.retain(|point| (*point - circle.center).norm() <= 2e3 * circle.radius);
    points
}

#[test]
fn the_farthest_corner_is_as_far_as_brute_force_says() {
    let r = &mut Random::new(11);
    for part in outlines(r) {
        for point in queries(r, &part) {
            let reach = part.farthest(point);
            let named = (point - part.corners()[reach.corner]).norm();
            let h = part.hull().len();
            assert_close(reach.distance, named, f64::EPSILON, named, "distance of the corner");
            let largest = brute_force(&part, point);
            assert_close(reach.distance, largest, ROUNDING, largest, format!("{h}: {point:?}"));
        }
    }
}

#[test]
fn points_of_a_boundary_have_two_farthest_corners() {
    let r = &mut Random::new(12);
    for part in outlines(r) {
        let circle = part.enclosing_circle();
        for boundary in part.partition().borders() {
            let around = Circle { radius: 2e3 * circle.radius, ..circle };
            let Some([low, high]) = boundary.within(around) else {
                continue;
            };
            for share in [0.0, 1e-3, 0.3, 0.9, 1.0] {
                let point = low * (1.0 - share) + high * share;
                let largest = brute_force(&part, point);
                for corner in [boundary.corners.0, boundary.corners.1] {
                    let distance = (point - part.corners()[corner]).norm();
                    // The point itself is rounded to its own size, which is that of the distance
                    // unless the part is far from the origin: four times the error of a search.
                    let what = format!("{boundary:?}");
                    assert_close(distance, largest, 4.0 * ROUNDING, largest, what);
                }
            }
        }
    }
}

#[test]
fn neighboring_cells_have_one_boundary_each() {
    let r = &mut Random::new(13);
    for n in (3..60).chain([500]) {
        let part = outline(&r.convex(n)).unwrap();
        let borders = part.partition().borders();
        assert_eq!(borders.len(), 2 * n - 3, "borders of {n} corners");
        assert_eq!(borders.iter().filter(|b| b.to.is_infinite()).count(), n, "rays");
        let mut pairs: Vec<_> = borders
            .iter()
            .map(|b| (b.corners.0.min(b.corners.1), b.corners.0.max(b.corners.1)))
            .collect();
        pairs.sort_unstable();
        pairs.dedup();
        assert_eq!(pairs.len(), 2 * n - 3, "pairs of {n} corners");
    }
}

#[test]
fn cells_are_convex_cover_the_plane_and_do_not_overlap() {
    let r = &mut Random::new(14);
    for part in outlines(r) {
        let partition = part.partition();
        assert_eq!(partition.regions().len(), part.hull().len());
        let circle = part.enclosing_circle();
        // How far a point is within a region: least over its borders, positive on the inside.
        let depth = |region: &clench_shape::Region, point: Vector<2>| {
            region.borders.iter().fold(f64::INFINITY, |least, &b| {
                let boundary = partition.borders()[b];
                let left = planar::cross(boundary.direction, point - boundary.middle);
                least.min(if boundary.corners.1 == region.corner { -left } else { left })
            })
        };
        for _ in 0..20 {
            let point = circle.center + Vector::new(r.array(3.0)) * circle.radius;
            let farthest = part.farthest(point).corner;
            let others = partition.regions().iter().filter(|region| region.corner != farthest);
            let own = partition.regions().iter().find(|region| region.corner == farthest).unwrap();
            let largest = brute_force(&part, point);
            let clear = others.clone().all(|region| {
                (point - part.corners()[region.corner]).norm() < largest * (1.0 - 1e-9)
            });
            if clear {
                assert!(depth(own, point) > 0.0, "point {point:?} is outside its region");
                for region in others {
                    assert!(depth(region, point) <= 0.0, "{point:?} is also in {}", region.corner);
                }
            }
        }
    }
}

#[test]
fn the_borders_of_a_cell_follow_each_other_counter_clockwise() {
    let r = &mut Random::new(15);
    for n in [3, 4, 5, 12, 40] {
        let part = outline(&r.convex(n)).unwrap();
        let radius = part.enclosing_circle().radius;
        for region in part.partition().regions() {
            // Each border, run with the region on its left: its two ends.
            let ends = |&b: &usize| {
                let boundary = part.partition().borders()[b];
                let ends = [boundary.from, boundary.to].map(|offset| boundary.point_at(offset));
                if boundary.corners.0 == region.corner { ends } else { [ends[1], ends[0]] }
            };
            for pair in region.borders.windows(2) {
                let ([_, end], [start, _]) = (ends(&pair[0]), ends(&pair[1]));
                // Both are the circumcentre of one triangle; a flat one of 40 corners has a
                // radius of about 40^2 times the part's, and so has the error.
                let scale = radius.max(end.norm());
                assert!((end - start).norm() <= 1e-9 * scale, "{end:?} is not {start:?}");
            }
        }
    }
}

#[test]
fn stretches_cover_a_segment_and_name_its_farthest_corners() {
    let r = &mut Random::new(16);
    for part in outlines(r) {
        let circle = part.enclosing_circle();
        for size in [0.5, 2.0, 100.0] {
            let mut end = || circle.center + Vector::new(r.array(size)) * circle.radius;
            let (start, end) = (end(), end());
            let stretches: Vec<_> = part.farthest_along(start, end).collect();
            let mut at = 0.0_f64;
            for stretch in &stretches {
                assert_eq!(stretch.from.to_bits(), at.to_bits(), "{stretches:?}");
                assert!(stretch.to > stretch.from, "{stretches:?}");
                at = stretch.to;
                for i in 0..=20 {
                    let share = f64::from(i) / 20.0;
                    let t = stretch.from + (stretch.to - stretch.from) * share;
                    let point = start + (end - start) * t;
                    let distance = (point - part.corners()[stretch.corner]).norm();
                    // Where corners change is rounded to the size of the segment.
                    let scale = (end - start).norm().max(brute_force(&part, point));
                    let largest = brute_force(&part, point);
                    assert_close(distance, largest, ROUNDING, scale, format!("{stretch:?}"));
                }
            }
            assert_eq!(at.to_bits(), 1.0_f64.to_bits(), "{stretches:?}");
        }
    }
}

#[test]
fn a_segment_along_a_boundary_is_covered_too() {
    let r = &mut Random::new(17);
    for part in outlines(r) {
        let circle = part.enclosing_circle();
        let wide = Circle { radius: 3.0 * circle.radius, ..circle };
        for boundary in part.partition().borders().iter().take(40) {
            let Some([start, end]) = boundary.within(wide) else {
                continue;
            };
            let stretches: Vec<_> = part.farthest_along(start, end).collect();
            assert_eq!(stretches.last().map(|s| s.to.to_bits()), Some(1.0_f64.to_bits()));
            for stretch in stretches {
                let point = start + (end - start) * (0.5 * (stretch.from + stretch.to));
                let (largest, corner) = (brute_force(&part, point), stretch.corner);
                let distance = (point - part.corners()[corner]).norm();
                assert_close(distance, largest, ROUNDING, largest, format!("{stretch:?}"));
            }
        }
    }
}

/// The smallest circle by trying all pairs and triples of corners.
fn smallest_circle(corners: &[Vector<2>]) -> Circle {
    let mut candidates = Vec::new();
    for (i, &a) in corners.iter().enumerate() {
        for (j, &b) in corners.iter().enumerate().take(i) {
            candidates.push((a + b) * 0.5);
            for &c in &corners[..j] {
                let (e, f) = (b - a, c - a);
                let (ee, ff) = (e.norm_squared(), f.norm_squared());
                let along = planar::quarter_turn(e) * ff - planar::quarter_turn(f) * ee;
                candidates.push(a + along * (0.5 / planar::cross(e, f)));
            }
        }
    }
    let radius =
        |center: Vector<2>| corners.iter().map(|&c| (c - center).norm()).fold(0.0, f64::max);
    candidates
        .into_iter()
        .filter(|center| center.is_finite())
        .map(|center| Circle { center, radius: radius(center) })
        .fold(Circle { center: Vector::ZERO, radius: f64::INFINITY }, |best, circle| {
            if circle.radius < best.radius { circle } else { best }
        })
}

#[test]
fn the_enclosing_circle_is_the_smallest() {
    let r = &mut Random::new(18);
    for round in 0..300 {
        let n = 3 + r.below(9);
        let corners = if round % 2 == 0 { r.star(n) } else { r.convex(n) };
        let part = outline(&corners).unwrap();
        let (found, expected) = (part.enclosing_circle(), smallest_circle(part.corners()));
        assert_close(found.radius, expected.radius, ROUNDING, expected.radius, "radius");
        // Two almost equal candidates differ more in the center than in the radius.
        let apart = (found.center - expected.center).norm();
        assert!(apart <= 1e-7 * found.radius, "centres are {apart:e} apart");
    }
}

#[test]
fn the_enclosing_circle_encloses_all_corners_and_rests_on_two_or_three() {
    let r = &mut Random::new(19);
    for part in outlines(r) {
        let Circle { center, radius } = part.enclosing_circle();
        let offsets: Vec<_> = part.corners().iter().map(|&corner| corner - center).collect();
        assert!(offsets.iter().all(|v| v.norm() <= radius), "a corner is outside");
        // A circle is smallest when no half turn is free of corners on it; to rounding, since
        // each direction must have a corner on the circle that is not behind the center.
        let on: Vec<_> =
            offsets.iter().filter(|v| v.norm() >= radius * (1.0 - 4.0 * ROUNDING)).collect();
        for i in 0..360 {
            let angle = TAU * f64::from(i) / 360.0;
            let direction = Vector::new([angle.cos(), angle.sin()]);
            let ahead = on.iter().map(|v| v.dot(direction)).fold(f64::MIN, f64::max);
            assert!(ahead >= -16.0 * ROUNDING * radius, "the circle could shrink: {ahead:e}");
        }
    }
}

#[test]
fn a_rigid_motion_moves_all_answers_with_the_part() {
    let r = &mut Random::new(20);
    for n in 3..60 {
        let corners = r.star(n);
        let frame = planar::Frame::new(r.array(4.0), r.between(0.0, TAU));
        let moved = |v: Vector<2>| *frame.axes() * v + frame.origin();
        let there: Corners = corners.iter().map(|&c| moved(c.into()).to_array()).collect();
        let (part, image) = (outline(&corners).unwrap(), outline(&there).unwrap());
        // Coordinates of up to 10 are rounded before the questions are asked.
        let rounding = 10.0 * ROUNDING;
        let (circle, other) = (part.enclosing_circle(), image.enclosing_circle());
        assert_close(other.radius, circle.radius, rounding, 1.0, "radius");
        assert_close(image.area(), part.area(), 30.0 * rounding, 1.0, "area");
        for (edge, turned) in part.edges().iter().zip(image.edges()) {
            let normal = (*frame.axes() * edge.inward_normal()).to_array();
            // The direction of an edge is as good as its coordinates over its length.
            let rounding = rounding / edge.length();
            assert_all_close(&turned.inward_normal().to_array(), &normal, rounding, "normal");
        }
        let point: Vector<2> = r.array(5.0).into();
        let (near, far) = (part.place(point), image.place(moved(point)));
        assert_close(far.distance, near.distance, rounding, 1.0, "distance to the outline");
        let (reach, image_reach) = (part.farthest(point), image.farthest(moved(point)));
        assert_close(image_reach.distance, reach.distance, rounding, 1.0, "reach");
        assert_eq!(part.winding(), image.winding());
    }
}

#[test]
fn reversing_the_corners_changes_numbers_only() {
    let r = &mut Random::new(21);
    for n in 3..60 {
        let corners = r.star(n);
        let reversed: Corners = corners.iter().rev().copied().collect();
        let (part, back) = (outline(&corners).unwrap(), outline(&reversed).unwrap());
        assert_eq!(part.winding(), Winding::CounterClockwise);
        assert_eq!(back.winding(), Winding::Clockwise);
        for e in 0..n {
            let mirrored = back.edges()[(2 * n - 2 - e) % n];
            assert_eq!(mirrored.inward_normal(), part.edges()[e].inward_normal());
        }
        let (circle, other) = (part.enclosing_circle(), back.enclosing_circle());
        assert_close(circle.radius, other.radius, ROUNDING, 3.0, "radius");
        assert_close(part.area(), back.area(), 10.0 * ROUNDING, 30.0, "area");
        let hull: Vec<usize> = back.hull().iter().map(|i| n - 1 - i).collect();
        assert_eq!(hull, part.hull());
    }
}

/// All numbers that a part answers with, each divided by `size` to the power of its unit.
fn answers(part: &Polygon, point: Vector<2>, size: f64) -> Vec<u64> {
    let scaled = |v: Vector<2>| v * (1.0 / size);
    let circle = part.enclosing_circle();
    let place = part.place(point * size);
    let mut all = scaled(circle.center).to_array().to_vec();
    all.extend([circle.radius / size, part.area() / size / size, place.along / size]);
    all.extend([place.distance / size, place.edge as f64]);
    let reach = part.farthest(point * size);
    all.extend([reach.distance / size, reach.corner as f64]);
    for stretch in part.farthest_along(point * size, circle.center) {
        all.extend([stretch.corner as f64, stretch.from, stretch.to]);
    }
    for boundary in part.partition().borders() {
        all.extend(scaled(boundary.middle).to_array());
        all.extend(boundary.direction.to_array());
        all.extend([boundary.from / size, boundary.to / size]);
    }
    all.into_iter().map(f64::to_bits).collect()
}

#[test]
fn the_unit_of_length_changes_no_bit() {
    let r = &mut Random::new(22);
    for n in (3..40).chain([300]) {
        for corners in [r.star(n), r.convex(n), regular(n)] {
            let point: Vector<2> = r.array(4.0).into();
            let expected = answers(&outline(&corners).unwrap(), point, 1.0);
            for power in [-180, -15, 1, 16, 180] {
                let size = 4.0_f64.powi(power);
                let scaled: Corners = corners.iter().map(|c| c.map(|x| x * size)).collect();
                let found = outline(&scaled).map(|part| answers(&part, point, size));
                assert_eq!(found.as_ref(), Some(&expected), "{n} corners times 4^{power}");
            }
        }
    }
}

#[test]
fn no_place_of_the_outline_is_nearer_than_the_one_named() {
    let r = &mut Random::new(23);
    for n in 3..40 {
        let part = outline(&r.star(n)).unwrap();
        for _ in 0..20 {
            let point: Vector<2> = r.array(4.0).into();
            let place = part.place(point);
            let nearest = part.edges()[place.edge].point_at(place.along);
            assert_close((point - nearest).norm(), place.distance, ROUNDING, 10.0, "its distance");
            for edge in part.edges() {
                for i in 0..=50 {
                    let other = edge.point_at(edge.length() * f64::from(i) / 50.0);
                    let distance = (point - other).norm();
                    assert!(distance >= place.distance - 10.0 * ROUNDING, "{place:?}");
                }
            }
            // A point of the outline is found again.
            let edge = r.below(n);
            let along = part.edges()[edge].length() * r.between(0.01, 0.99);
            let found = part.place(part.edges()[edge].point_at(along));
            assert_eq!((found.edge, found.corner), (edge, None));
            assert_close(found.along, along, ROUNDING, 10.0, "along");
            assert!(found.distance <= 10.0 * ROUNDING, "{found:?}");
        }
    }
}

/// Whether whole-number corners form a simple outline, by integers, all pairs of edges.
fn simple(corners: &[[i64; 2]]) -> bool {
    let n = corners.len();
    let turn = |a: [i64; 2], b: [i64; 2], c: [i64; 2]| {
        ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).signum()
    };
    let between = |a: [i64; 2], b: [i64; 2], p: [i64; 2]| {
        turn(a, b, p) == 0 && (0..2).all(|k| a[k].min(b[k]) <= p[k] && p[k] <= a[k].max(b[k]))
    };
    let edge = |e: usize| (corners[e % n], corners[(e + 1) % n]);
    (0..n).all(|i| {
        let (a, b) = edge(i);
        let (_, c) = edge(i + 1);
        let shares_more = a == b || between(a, b, c) || between(b, c, a);
        !shares_more
            && (i + 2..n).filter(|j| (j + 1) % n != i).all(|j| {
                let (p, q) = edge(j);
                let crosses =
                    turn(a, b, p) * turn(a, b, q) < 0 && turn(p, q, a) * turn(p, q, b) < 0;
                let touches =
                    between(a, b, p) || between(a, b, q) || between(p, q, a) || between(p, q, b);
                !crosses && !touches
            })
    })
}

#[test]
fn outlines_are_valid_exactly_when_no_pair_of_edges_meets() {
    let r = &mut Random::new(24);
    let mut valid = 0;
    for round in 0..20_000 {
        let (n, grid) = (3 + r.below(6), 3 + r.below(9));
        let whole: Vec<[i64; 2]> = (0..n)
            .map(|_| [r.below(grid), r.below(grid)].map(|x| i64::try_from(x).unwrap()))
            .collect();
        // Shifts and scales that the doubles represent without rounding.
        let (shift, scale) = ([0.0, 1e6, -12_345.0][round % 3], [1.0, 0.25, 4096.0][round / 3 % 3]);
        let corners: Corners =
            whole.iter().map(|c| c.map(|x| (x as f64 + shift) * scale)).collect();
        let expected = simple(&whole);
        valid += usize::from(expected);
        assert_eq!(Polygon::new(&corners).is_ok(), expected, "{whole:?}");
    }
    assert!(valid > 1000, "only {valid} valid outlines");
}

#[test]
fn the_area_of_whole_numbers_is_exact_to_rounding() {
    let part = outline(&[[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [3.0, 1.0], [0.0, 4.0]]).unwrap();
    // The rectangle of 24 less the notch of base 6 and height 3.
    assert_close(part.area(), 15.0, ROUNDING, 15.0, "area");
}
