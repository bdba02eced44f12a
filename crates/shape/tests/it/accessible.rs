//! Where balls touch solids, judged by distances that another library finds.

use clench_screw::{Vector, spatial};
use clench_shape::{
    ACCESS_TOLERANCE, AccessError, AccessibleFacet, BallTip, Facet, KeepOut, Obstruction, Plate,
    Polyhedron,
};
use clench_testkit::{Random, assert_close};
use parry3d_f64::math::Vector as ParryVector;
use parry3d_f64::query::PointQuery;
use parry3d_f64::shape::TriMesh;

use crate::solids::{Mesh, bracket, cuboid, globe, prism, ring, rough_ball, solid, turned};

/// Distances of 4 or less are found in tens of operations with numbers of up to 16.
const ROUNDING: f64 = 1e-13;

/// A block with a slot, which is wider below if `undercut` is more than its width.
fn slotted(width: f64, undercut: f64) -> Mesh {
    let (a, b) = (0.5 * width, 0.5 * undercut);
    let right = [[2.0, 0.0], [2.0, 3.0], [a, 3.0], [a, 2.0], [b, 2.0], [b, 1.0]];
    let mut outline = right.to_vec();
    outline.extend(right.iter().rev().map(|&[x, y]| [-x, y]));
    outline.dedup();
    prism(&outline, 1.5)
}

/// A box from -2 to 2, its top at 1, with a square pocket of half-width 1 down to 0.
fn pocketed() -> Mesh {
    let square = |s: f64, z: f64| [[-s, -s, z], [s, -s, z], [s, s, z], [-s, s, z]];
    let levels = [square(2.0, -1.0), square(2.0, 1.0), square(1.0, 1.0), square(1.0, 0.0)];
    let mut faces = vec![vec![3, 2, 1, 0], vec![12, 13, 14, 15]];
    for level in 0..3 {
        faces.extend((0..4).map(|i| {
            let (j, at) = ((i + 1) % 4, 4 * level);
            vec![at + i, at + j, at + 4 + j, at + 4 + i]
        }));
    }
    (levels.concat(), faces)
}

/// What is asked of another library.
struct Judge {
    mesh: TriMesh,
}

impl Judge {
    fn new(solid: &Polyhedron) -> Self {
        let corners: Vec<[Vector<3>; 3]> =
            solid.facets(0.0).iter().flat_map(|f| f.triangles().to_vec()).collect();
        let points = corners.as_flattened().iter();
        let points = points.map(|x| ParryVector::from_array(x.to_array())).collect();
        let count = u32::try_from(corners.len()).unwrap();
        let triangles = (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        Self { mesh: TriMesh::new(points, triangles).unwrap() }
    }

    /// How far the surface is from the center of a ball that touches at a point.
    fn distance(&self, facet: &Facet, point: Vector<3>, tip: &BallTip) -> f64 {
        let center = point - facet.inward_normal() * tip.radius();
        let center = ParryVector::from_array(center.to_array());
        self.mesh.distance_to_local_point(center, false)
    }

    /// Whether the ball has room but for `slack`.
    fn has_room(&self, facet: &Facet, point: Vector<3>, tip: &BallTip, slack: f64) -> bool {
        let center = point - facet.inward_normal() * tip.radius();
        let beside = |keep_out: &KeepOut| {
            let (from, to) = (keep_out.from(), keep_out.to());
            let off =
                Vector::<3>::from_fn(|i| (from[i] - center[i]).max(center[i] - to[i]).max(0.0));
            off.norm() >= tip.radius() - slack
        };
        let over = |plate: &Plate| {
            let off = |i: usize| {
                let (pitch, offset) = (plate.pitch()[i], plate.offset()[i]);
                let along = (center[i] - offset).rem_euclid(pitch);
                along.min(pitch - along)
            };
            off(0).hypot(off(1)) <= plate.travel() + slack
        };
        self.distance(facet, point, tip) >= tip.radius() - slack
            && tip.keep_out().iter().all(beside)
            && tip.plate().is_none_or(over)
    }
}

fn within([a, b, c]: [Vector<3>; 3], weights: [f64; 3]) -> Vector<3> {
    let sum: f64 = weights.iter().sum();
    a + (b - a) * (weights[1] / sum) + (c - a) * (weights[2] / sum)
}

fn area([a, b, c]: [Vector<3>; 3]) -> f64 {
    0.5 * spatial::cross(b - a, c - a).norm()
}

/// Whether a point of the plane is in one of the triangles, or nearer to one than `slack`.
fn is_in(triangles: &[[Vector<3>; 3]], normal: Vector<3>, point: Vector<3>, slack: f64) -> bool {
    triangles.iter().any(|corners| {
        (0..3).all(|i| {
            let (from, to) = (corners[i], corners[(i + 1) % 3]);
            let out = spatial::cross(normal, to - from);
            out.dot(point - from) <= slack * out.norm()
        })
    })
}

/// Holds regions against the judge; how many points of the facets were in a region, and how many
/// were not.
fn check(part: &Polyhedron, tip: &BallTip, r: &mut Random, what: &str) -> [usize; 2] {
    let judge = Judge::new(part);
    let facets = part.facets(0.0);
    let found = part.accessible(&facets, 0.0, tip).unwrap();
    let tolerance = ACCESS_TOLERANCE * part.enclosing_radius();
    let slack = ROUNDING * part.enclosing_radius().max(1.0);
    let mut counts = [0, 0];
    for (number, (facet, region)) in facets.iter().zip(&found).enumerate() {
        let normal = facet.inward_normal();
        let total: f64 = region.triangles().iter().map(|&t| area(t)).sum();
        assert_close(total, region.area(), 1e-12, facet.area(), what);
        for &triangle in region.triangles() {
            let middle = within(triangle, [1.0; 3]);
            let chance = within(triangle, r.array::<3>(0.5).map(|x| x + 0.5));
            for point in triangle.into_iter().chain([middle, chance]) {
                let distance = judge.distance(facet, point, tip);
                assert!(
                    judge.has_room(facet, point, tip, slack),
                    "{what}, facet {number}, {point:?}: {distance}"
                );
            }
        }
        for &triangle in facet.triangles() {
            for _ in 0..40 {
                let point = within(triangle, r.array::<3>(0.5).map(|x| x + 0.5));
                let inside = is_in(region.triangles(), normal, point, 0.0);
                counts[usize::from(!inside)] += 1;
                if inside || is_in(region.triangles(), normal, point, slack) {
                    continue;
                }
                // No room, or nearly so: there is none somewhere within the tolerance.
                let axis = triangle[1] - triangle[0];
                let (u, v) = (axis * axis.norm().recip(), spatial::cross(normal, axis));
                let v = v * v.norm().recip();
                let beside = (0..64).map(|i| {
                    let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / 64.0).sin_cos();
                    point + (u * cos + v * sin) * (1.01 * tolerance)
                });
                let is_lost = std::iter::once(point).chain(beside).all(|x| {
                    judge.has_room(facet, x, tip, 0.0)
                        && is_in(facet.triangles(), normal, x, -tip.margin())
                });
                assert!(!is_lost, "{what}, facet {number}: room at {point:?} is lost");
            }
        }
    }
    counts
}

#[test]
fn a_ball_touches_where_another_library_says_that_it_has_room() {
    let r = &mut Random::new(301);
    let solids = [
        ("bracket", bracket()),
        ("wide slot", slotted(1.5, 1.5)),
        ("undercut", slotted(1.0, 2.5)),
        ("pocket", pocketed()),
        ("ring", ring(12)),
    ];
    for (name, mesh) in solids {
        for radius in [0.01, 0.2, 0.45, 0.9, 3.0, 50.0] {
            let pose = spatial::Frame::new(r.array(2.0), r.array(2.0));
            let tip = BallTip::new(radius).unwrap();
            let what = format!("{name}, radius {radius}");
            let [inside, outside] = check(&solid(&mesh), &tip, r, &what);
            assert!(inside > 0 && outside > 0, "{what}: {inside} and {outside}");
            check(&solid(&turned(&mesh, &pose)), &tip, r, &format!("turned {what}"));
        }
    }
}

#[test]
fn the_same_holds_on_random_prisms_and_rough_balls() {
    let r = &mut Random::new(3021);
    for round in 0..120 {
        let corners = 5 + r.below(20);
        let star = prism(&r.star(corners), 0.7);
        let part = if round % 5 == 0 {
            Polyhedron::from_triangles(&rough_ball(r, 2, 1.6)).unwrap()
        } else {
            solid(&turned(&star, &spatial::Frame::new(r.array(2.0), r.array(2.0))))
        };
        let tip = BallTip::new(r.between(0.02, 0.6)).unwrap();
        check(&part, &tip, r, &format!("round {round}"));
    }
}

#[test]
fn boxes_plates_and_margins_are_kept_to() {
    let r = &mut Random::new(303);
    for round in 0..40 {
        let mesh = [cuboid([2.0, 1.5, 1.0]), bracket(), pocketed()][round % 3].clone();
        let pose = spatial::Frame::new(r.array(1.0), r.array(1.0));
        let part = solid(&if round % 2 == 0 { mesh } else { turned(&mesh, &pose) });
        let corner = Vector::new(r.array(2.0));
        let keep_out = KeepOut::new(
            (corner - Vector::from_fn(|_| 0.7)).to_array(),
            (corner + Vector::from_fn(|_| r.between(0.1, 1.0))).to_array(),
        );
        let radius = if round % 4 == 0 { 0.0 } else { r.between(0.02, 0.6) };
        let tip = BallTip::new(radius).unwrap().keeping_out(vec![keep_out.unwrap()]);
        let tip = if round % 3 == 0 { tip.with_margin(0.11).unwrap() } else { tip };
        let plate = Plate::new([0.8, 0.6], [0.1, -0.2], 0.25).unwrap();
        let tip = if round % 5 < 2 { tip.over(plate) } else { tip };
        if radius > 0.0 {
            check(&part, &tip, r, &format!("round {round}"));
        }
    }
}

fn areas(part: &Polyhedron, tip: &BallTip) -> Vec<f64> {
    let found = part.accessible(&part.facets(0.0), 0.0, tip).unwrap();
    found.iter().map(AccessibleFacet::area).collect()
}

#[test]
fn areas_with_straight_borders_are_exact() {
    // A slot 1.5 wide and 3 long, closed below: its floor and walls.
    let part = solid(&slotted(1.5, 1.5));
    let ball = |radius: f64| BallTip::new(radius).unwrap();
    let of = |radius: f64, height: f64, x: f64| {
        let facets = part.facets(0.0);
        let at = |f: &Facet| {
            let [a, b, c] = f.triangles()[0];
            let middle = (a + b + c) * (1.0 / 3.0);
            (f.inward_normal()[0] - x).abs() < 1e-9 && (middle[1] - height).abs() < 1.1
        };
        let number = facets.iter().position(at).unwrap();
        areas(&part, &ball(radius))[number]
    };
    // Walls face each other: their inward normals are along x, away from the slot.
    assert_close(of(0.25, 2.0, 1.0), 3.0 * (2.0 - 0.25), 1e-12, 6.0, "wall");
    assert_close(of(0.25, 1.0, 0.0), 3.0 * 1.5, 1.0, 6.0, "bottom or floor");
    // The ball does not enter, nor does it touch walls from above.
    assert!(of(0.76, 2.0, 1.0) < 1e-12);
    // Margins take a frame off.
    let cube = solid(&cuboid([1.0, 1.0, 1.0]));
    let margin = BallTip::new(0.0).unwrap().with_margin(0.25).unwrap();
    for area in areas(&cube, &margin) {
        assert_close(area, 1.5 * 1.5, 1e-12, 4.0, "margin");
    }
    assert!(areas(&cube, &margin.with_margin(1.0).unwrap()).iter().all(|&area| area < 1e-12));
}

#[test]
fn a_ball_touches_a_bore_only_if_it_is_narrower() {
    // A regular hole of 12 sides, 2 sin(pi/12) * 2 long, their middles 2 cos(pi/12) away.
    let part = solid(&ring(12));
    let bore = 2.0 * (std::f64::consts::PI / 12.0).cos();
    let of_bore = |radius: f64| {
        let facets = part.facets(0.0);
        let tip = BallTip::new(radius).unwrap();
        let inside = |f: &Facet| f.triangles()[0].iter().all(|x| x[0].hypot(x[1]) < 2.1);
        let found = part.accessible(&facets, 0.0, &tip).unwrap();
        let of_bore = facets.iter().zip(found).filter(|(facet, _)| inside(facet));
        of_bore.map(|(_, region)| region.area()).sum::<f64>()
    };
    // Each side loses r tan(half of the angle between neighbors) at both ends.
    for radius in [0.1, 1.0, 1.9] {
        let part_left = 1.0 - radius / bore;
        let side = 4.0 * (std::f64::consts::PI / 12.0).sin();
        assert_close(of_bore(radius), 12.0 * side * part_left, 1e-11, 12.0, radius);
    }
    assert!(of_bore(bore * 1.001) < 1e-12);
}

#[test]
fn convex_solids_and_points_touch_everywhere_bit_for_bit() {
    let r = &mut Random::new(304);
    let ball = globe(40, [1.0, 2.0, 1.5]);
    for (part, radius) in [
        (Polyhedron::from_triangles(&ball).unwrap(), 5.0),
        (
            solid(&turned(
                &cuboid([1.0, 2.0, 3.0]),
                &spatial::Frame::new(r.array(2.0), r.array(2.0)),
            )),
            1e9,
        ),
        (solid(&bracket()), 0.0),
    ] {
        let facets = part.facets(0.0);
        let found = part.accessible(&facets, 0.0, &BallTip::new(radius).unwrap()).unwrap();
        for (facet, region) in facets.iter().zip(found) {
            assert_eq!(facet.triangles(), region.triangles());
            assert_eq!(facet.area(), region.area());
        }
    }
}

#[test]
fn units_do_not_matter_and_balls_may_be_of_any_size() {
    let (vertices, faces) = pocketed();
    let tip = |radius: f64| BallTip::new(radius).unwrap();
    let one = areas(&solid(&pocketed()), &tip(0.3));
    for scale in [1e-9, 1e-3, 1e9, 1e30] {
        let scaled: Vec<[f64; 3]> = vertices.iter().map(|v| v.map(|x| x * scale)).collect();
        let part = Polyhedron::new(&scaled, &faces).unwrap();
        for (found, &expected) in areas(&part, &tip(0.3 * scale)).iter().zip(&one) {
            assert_close(*found, expected * scale * scale, 1e-12, 16.0 * scale * scale, scale);
        }
        // A half space touches the convex hull: all but the pocket.
        for radius in [1e15 * scale, 1e300] {
            let found = areas(&part, &tip(radius));
            let facets = part.facets(0.0);
            for (area, facet) in found.iter().zip(&facets) {
                let depth = facet.inward_normal().dot(facet.triangles()[0][0]) / scale;
                let is_out = depth < -0.9 && facet.triangles()[0][1].max_abs() > 0.0;
                let is_wall = facet.area() < 3.0 * scale * scale;
                let expected = if is_out && !is_wall { facet.area() } else { 0.0 };
                let is_floor = (facet.area() / (4.0 * scale * scale) - 1.0).abs() < 1e-9;
                let expected = if is_floor { 0.0 } else { expected };
                assert_close(*area, expected, 1e-9, facet.area(), format!("{scale} {radius}"));
            }
        }
    }
}

#[test]
fn a_box_around_all_leaves_nothing() {
    let tip = BallTip::new(0.1).unwrap();
    let around = KeepOut::new([-9.0; 3], [9.0; 3]).unwrap();
    for tip in [tip.clone(), tip.with_radius(0.0).unwrap(), tip.with_radius(1e12).unwrap()] {
        let found = areas(&solid(&bracket()), &tip.keeping_out(vec![around]));
        assert_eq!(found, vec![0.0; found.len()]);
    }
}

#[test]
fn single_points_are_told_what_is_in_their_way() {
    let part = solid(&slotted(1.0, 1.0));
    let tip = BallTip::new(0.4).unwrap();
    let up = Vector::new([0.0, -1.0, 0.0]);
    let at = |x: f64, y: f64| part.obstruction([x, y, 0.0].into(), up, 1e-9, &tip);
    assert_eq!(at(1.0, 3.0), None);
    assert_eq!(at(0.0, 1.0), None);
    assert_eq!(at(0.2, 1.0), Some(Obstruction::Part));
    let box_ = KeepOut::new([1.2, 3.0, -1.0], [1.5, 4.0, 1.0]).unwrap();
    let tip = tip.keeping_out(vec![box_]);
    let at = |x: f64| part.obstruction([x, 3.0, 0.0].into(), up, 1e-9, &tip);
    assert_eq!((at(1.0), at(0.75)), (Some(Obstruction::KeepOut(0)), None));
    let point = tip.with_radius(0.0).unwrap();
    let at = |x: f64| part.obstruction([x, 3.0, 0.0].into(), up, 1e-9, &point);
    assert_eq!((at(1.3), at(1.1)), (Some(Obstruction::KeepOut(0)), None));
    let tip = BallTip::new(0.1).unwrap().over(Plate::new([0.5, 1.0], [0.0; 2], 0.12).unwrap());
    let at = |x: f64| part.obstruction([x, 3.0, 0.0].into(), up, 1e-9, &tip);
    assert_eq!((at(1.05), at(1.1)), (None, Some(Obstruction::Plate)));
}

#[test]
fn what_is_no_tip_is_told() {
    let tip = BallTip::new(1.0).unwrap();
    assert!(matches!(BallTip::new(f64::NAN), Err(AccessError::Radius { .. })));
    assert!(matches!(tip.with_radius(f64::INFINITY), Err(AccessError::Radius { .. })));
    assert_eq!(BallTip::new(-1.0), Err(AccessError::Radius { value: -1.0 }));
    assert_eq!(tip.with_margin(-1.0), Err(AccessError::Margin { value: -1.0 }));
    let flat = KeepOut::new([0.0, 1.0, 0.0], [1.0, 1.0, 1.0]);
    assert_eq!(flat, Err(AccessError::KeepOut { axis: 1, from: 1.0, to: 1.0 }));
    let plate = |pitch, offset, travel| Plate::new([1.0, pitch], [offset, 0.0], travel);
    assert_eq!(plate(0.0, 0.0, 1.0), Err(AccessError::PlatePitch { value: 0.0 }));
    assert!(matches!(plate(1.0, f64::NAN, 1.0), Err(AccessError::PlateOffset { .. })));
    assert_eq!(plate(1.0, 0.0, 0.0), Err(AccessError::PlateTravel { value: 0.0 }));
    let fine = BallTip::new(0.0).unwrap().over(Plate::new([1e-6; 2], [0.0; 2], 1e-7).unwrap());
    let part = solid(&cuboid([1.0; 3]));
    let error = part.accessible(&part.facets(0.0), 0.0, &fine).unwrap_err();
    assert!(matches!(error, AccessError::TooManyHoles { facet: 0, .. }), "{error}");
}
