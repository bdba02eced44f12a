//! Properties of solids, and of the nearest places on them.

use std::f64::consts::TAU;

use clench_screw::{Vector, spatial};
use clench_shape::{FaceFeature, Polygon, Polyhedron};
use clench_testkit::{Random, assert_all_close, assert_close};

use crate::solids::{cuboid, prism, ring, rough_ball, solid, turned};

/// Coordinates are rounded when a solid is turned, and feet and distances are a few products of
/// them.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

#[test]
fn a_box_has_the_faces_and_the_volume_of_a_box() {
    let part = solid(&cuboid([1.0, 2.0, 3.0]));
    assert_eq!((part.volume(), part.faces().len()), (48.0, 6));
    assert_eq!(part.box_center().to_array(), [0.0; 3]);
    assert_close(part.enclosing_radius(), 14.0_f64.sqrt(), f64::EPSILON, 4.0, "radius");
    let top = &part.faces()[1];
    assert_eq!((top.area(), top.vertices()), (8.0, [4, 5, 6, 7].as_slice()));
    assert_eq!(top.inward_normal().to_array(), [0.0, 0.0, -1.0]);
    assert_eq!(top.point().to_array(), [0.0, 0.0, 3.0]);
}

#[test]
fn turning_and_scaling_a_solid_changes_its_measures_alone() {
    let r = &mut Random::new(41);
    for size in [1e-9, 1.0, 1e9] {
        for corners in [4, 5, 9, 40] {
            let outline: Vec<[f64; 2]> =
                r.star(corners).iter().map(|c| c.map(|x| x * size)).collect();
            let mesh = prism(&outline, 0.7 * size);
            let pose = spatial::Frame::new(r.array(2.0 * size), r.array(2.0));
            let (part, other) = (solid(&mesh), solid(&turned(&mesh, &pose)));
            let area = Polygon::new(&outline).unwrap().area();
            assert_close(part.volume(), area * 1.4 * size, ROUNDING, size.powi(3) * 30.0, "volume");
            assert_close(other.volume(), part.volume(), ROUNDING, size.powi(3) * 90.0, "turned");
            for (face, there) in part.faces().iter().zip(other.faces()) {
                let normal = pose.direction_to_parent(face.inward_normal()).to_array();
                let found = there.inward_normal().to_array();
                // Coordinates up to five sizes, and edges as short as a tenth of one.
                assert_all_close(&found, &normal, 50.0 * ROUNDING, "normal");
                assert_close(there.area(), face.area(), 50.0 * ROUNDING, size * size, "area");
            }
        }
    }
}

/// The signed distance of a point from a prism over `outline` from `-h` to `h`.
fn prism_distance(outline: &Polygon, h: f64, point: Vector<3>) -> f64 {
    let level = Vector::new([point[0], point[1]]);
    let mut turns = 0.0;
    for edge in outline.edges() {
        let (a, b) = (edge.start() - level, edge.end() - level);
        turns += clench_screw::planar::cross(a, b).atan2(a.dot(b)) / TAU;
    }
    let beside = outline.place(level).distance * if turns > 0.5 { -1.0 } else { 1.0 };
    let above = point[2].abs() - h;
    if beside > 0.0 && above > 0.0 { beside.hypot(above) } else { beside.max(above) }
}

#[test]
fn hollow_prisms_have_the_distances_that_follow_from_their_outlines() {
    let r = &mut Random::new(42);
    for corners in [3, 5, 9, 60] {
        for size in [1e-9, 1.0, 1e9] {
            let outline: Vec<[f64; 2]> =
                r.star(corners).iter().map(|c| c.map(|x| x * size)).collect();
            let (polygon, h) = (Polygon::new(&outline).unwrap(), 0.8 * size);
            let mesh = prism(&outline, h);
            let pose = spatial::Frame::new(r.array(2.0 * size), r.array(2.0));
            let (part, other) = (solid(&mesh), solid(&turned(&mesh, &pose)));
            for i in 0..400 {
                // Around, and near vertices and the middles of edges.
                let from = match i % 3 {
                    0 => Vector::ZERO,
                    1 => part.vertices()[i % part.vertices().len()],
                    _ => (part.vertices()[0] + part.vertices()[1]) * 0.5,
                };
                let reach = if i % 3 == 0 { 4.0 } else { 0.1_f64.powf((i % 11) as f64) };
                let point = from + Vector::new(r.array(reach * size));
                let expected = prism_distance(&polygon, h, point);
                let what = format!("{corners} {size} {point:?}");
                assert_close(part.signed_distance(point), expected, ROUNDING, 7.0 * size, &what);
                let there = other.signed_distance(pose.point_to_parent(point));
                assert_close(there, expected, ROUNDING, 7.0 * size, &what);
            }
        }
    }
}

/// The point of a triangle nearest to `p` (C. Ericson, *Real-Time Collision Detection*, 5.1.5).
fn on_triangle([a, b, c]: [Vector<3>; 3], p: Vector<3>) -> Vector<3> {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    let (d3, d4) = (ab.dot(p - b), ac.dot(p - b));
    let (d5, d6) = (ab.dot(p - c), ac.dot(p - c));
    let (va, vb, vc) = (d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2);
    if d1 <= 0.0 && d2 <= 0.0 {
        a
    } else if d3 >= 0.0 && d4 <= d3 {
        b
    } else if d6 >= 0.0 && d5 <= d6 {
        c
    } else if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        a + ab * (d1 / (d1 - d3))
    } else if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        a + ac * (d2 / (d2 - d6))
    } else if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)))
    } else {
        a + ab * (vb / (va + vb + vc)) + ac * (vc / (va + vb + vc))
    }
}

/// The part of the full solid angle under which a triangle is seen (A. Van Oosterom, J. Strackee,
/// *The Solid Angle of a Plane Triangle*, 1983).
fn solid_angle(corners: [Vector<3>; 3], p: Vector<3>) -> f64 {
    let [a, b, c] = corners.map(|corner| corner - p);
    let triple = a.dot(spatial::cross(b, c));
    let (la, lb, lc) = (a.norm(), b.norm(), c.norm());
    let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    triple.atan2(below) / TAU
}

fn brute_force(triangles: &[[Vector<3>; 3]], point: Vector<3>) -> f64 {
    let mut distance = f64::INFINITY;
    let mut around = 0.0;
    for &triangle in triangles {
        distance = distance.min((on_triangle(triangle, point) - point).norm());
        around += solid_angle(triangle, point);
    }
    if around > 0.5 { -distance } else { distance }
}

#[test]
fn rough_meshes_have_the_signed_distances_that_brute_force_finds() {
    let r = &mut Random::new(43);
    for (splits, peak) in [(0, 1.0), (1, 3.0), (2, 1.5), (3, 1.2), (2, 6.0)] {
        let mesh = rough_ball(r, splits, peak);
        let part = Polyhedron::from_triangles(&mesh).unwrap();
        let triangles: Vec<_> = mesh.iter().map(|t| t.map(Vector::new)).collect();
        let count = 8 * 4_usize.pow(u32::try_from(splits).unwrap());
        assert_eq!((part.faces().len(), part.vertices().len()), (count, count / 2 + 2));
        for i in 0..1500 {
            let reach = if i % 3 == 0 { 2.0 } else { 0.1_f64.powf((i % 9) as f64) };
            let from = match i % 3 {
                0 => Vector::ZERO,
                1 => part.vertices()[i % part.vertices().len()],
                _ => (triangles[i % count][0] + triangles[i % count][1]) * 0.5,
            };
            let point = from + Vector::new(r.array(reach));
            let expected = brute_force(&triangles, point);
            let found = part.signed_distance(point);
            assert_close(found, expected, ROUNDING, 10.0, format!("{splits} {peak} {point:?}"));
        }
    }
}

#[test]
fn a_ring_is_hollow_in_the_middle() {
    let part = solid(&ring(8));
    let apothem = 2.0 * (TAU / 16.0).cos();
    assert_close(part.signed_distance(Vector::ZERO), apothem, ROUNDING, 3.0, "middle");
    let (s, c) = (TAU / 16.0).sin_cos();
    let inside = Vector::new([2.3 * c, 2.3 * s, 0.1]);
    assert_close(part.signed_distance(inside), -0.4, ROUNDING, 3.0, "upper side");
    // A regular octagon of circumradius R has the area 2 sqrt(2) R^2.
    let volume = 8.0_f64.sqrt() * (9.0 - 4.0);
    assert_close(part.volume(), volume, ROUNDING, volume, "volume");
}

#[test]
fn a_cavity_is_outside() {
    let ((mut vertices, mut faces), (inner, cavity)) = (cuboid([2.0; 3]), cuboid([1.0; 3]));
    vertices.extend(inner);
    faces.extend(cavity.iter().map(|face| face.iter().rev().map(|&c| c + 8).collect::<Vec<_>>()));
    let part = solid(&(vertices, faces));
    assert_close(part.volume(), 64.0 - 8.0, ROUNDING, 64.0, "volume");
    assert_eq!(part.signed_distance([0.0, 0.5, 0.0].into()), 0.5);
    assert_eq!(part.signed_distance([0.0, 1.25, 0.0].into()), -0.25);
}

#[test]
fn places_name_all_faces_that_share_them() {
    let part = solid(&cuboid([1.0, 1.0, 1.0]));
    let inside = part.place([0.25, 0.5, 3.0].into());
    assert_eq!((inside.face, inside.distance, &inside.on), (1, 2.0, &FaceFeature::Interior));
    assert_eq!(inside.foot.to_array(), [0.25, 0.5, 1.0]);
    // On the edge, off it by a rounding, and clearly beside it.
    let edge = FaceFeature::Edge { faces: [1, 3], vertices: [5, 6] };
    let place = part.place([1.0, 0.5, 1.0].into());
    assert_eq!((place.face, &place.on), (1, &edge));
    assert_eq!(part.place([1.0 - f64::EPSILON, 0.5, 1.0].into()).on, edge);
    assert_eq!(part.place([1.0, 0.5, 1.0 - f64::EPSILON].into()).on, edge);
    assert_eq!(part.place([1.0 - 1e-14, 0.5, 1.0].into()).on, FaceFeature::Interior);
    assert_eq!(part.place([5.0, 0.5, 4.0].into()).distance, 5.0);
    let vertex = FaceFeature::Vertex { vertex: 6, faces: vec![1, 3, 4] };
    let place = part.place([1.0, 1.0 + f64::EPSILON, 1.0].into());
    assert_eq!((place.face, &place.on), (1, &vertex));
}

#[test]
fn edges_between_triangles_of_one_side_are_edges_too() {
    let (vertices, mut faces) = cuboid([1.0, 1.0, 1.0]);
    faces[1] = vec![4, 5, 6];
    faces.push(vec![4, 6, 7]);
    let part = solid(&(vertices, faces));
    let place = part.place([0.25, 0.25, 1.5].into());
    assert_eq!(place.on, FaceFeature::Edge { faces: [1, 6], vertices: [4, 6] });
    let normals = [1, 6].map(|face: usize| part.faces()[face].inward_normal());
    assert_eq!(normals[0], normals[1]);
}

#[test]
fn a_mesh_of_half_a_million_triangles_is_validated_and_asked_quickly() {
    let r = &mut Random::new(44);
    let mesh = rough_ball(r, 8, 1.0001);
    assert_eq!(mesh.len(), 8 << 16);
    let part = Polyhedron::from_triangles(&mesh).unwrap();
    for _ in 0..1000 {
        let point = Vector::new(r.array(2.0));
        let found = part.signed_distance(point);
        // Between the unit ball, less the sagitta of a triangle, and the ball of the peaks.
        let radius = point.norm() - found;
        assert!((0.9999..=1.0001).contains(&radius), "{point:?}: {found}");
    }
}
