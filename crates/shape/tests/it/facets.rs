//! Laws of faces taken together where they are in one plane.

use clench_screw::{Vector, spatial};
use clench_shape::{Facet, Polyhedron};
use clench_testkit::{Random, assert_all_close, assert_close};

use crate::solids::{Mesh, bracket, cuboid, prism, ring, rough_ball, solid, turned};

/// Areas and normals are sums of products of a few coordinates, each rounded once or twice.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

fn area_vector([a, b, c]: [Vector<3>; 3]) -> Vector<3> {
    spatial::cross(b - a, c - a) * 0.5
}

/// What each facet of any solid is held to.
fn check(part: &Polyhedron, facets: &[Facet], what: &str) {
    let mut faces: Vec<usize> = facets.iter().flat_map(|f| f.faces().to_vec()).collect();
    assert!(facets.iter().all(|facet| facet.faces().is_sorted()), "{what}");
    assert!(facets.is_sorted_by_key(|facet| facet.faces()[0]), "{what}");
    faces.sort_unstable();
    assert!(faces.into_iter().eq(0..part.faces().len()), "{what}");
    for facet in facets {
        let normal = facet.inward_normal();
        assert_close(normal.norm(), 1.0, ROUNDING, 1.0, what);
        let of_faces: f64 = facet.faces().iter().map(|&face| part.faces()[face].area()).sum();
        assert_eq!(facet.area(), of_faces, "{what}");
        let areas = facet.triangles().iter().map(|&corners| area_vector(corners));
        let (mut total, mut along) = (0.0, Vector::ZERO);
        for area in areas {
            assert!(area.norm() > 0.0, "{what}");
            if area.norm() > 1e-5 {
                assert!(area.dot(normal) < -0.999 * area.norm(), "{what}");
            }
            total += area.norm();
            along += area;
        }
        // Slivers without any width are left out: the rounding of a coordinate along an edge.
        let scale = facet.area() + 9.0 * facet.area().sqrt();
        assert_close(total, facet.area(), ROUNDING, scale, what);
        // The area inside of the loops, as a vector, is that of the triangles.
        let points = part.vertices();
        let around = facet.loops().iter().flat_map(|chain| {
            let next = chain.iter().cycle().skip(1);
            chain
                .iter()
                .zip(next)
                .map(|(&u, &v)| area_vector([points[chain[0]], points[u], points[v]]))
        });
        let around = around.fold(Vector::ZERO, |sum, part| sum + part);
        assert_close((around - along).norm(), 0.0, ROUNDING, 4.0 * scale, what);
    }
}

#[test]
fn facets_cover_the_surface_and_triangles_the_facets() {
    let r = &mut Random::new(91);
    let ball = Polyhedron::from_triangles(&rough_ball(r, 3, 1.5)).unwrap();
    check(&ball, &ball.facets(0.0), "ball");
    assert_eq!(ball.facets(0.0).len(), 512);
    for round in 0..200 {
        let corners = 3 + r.below(40);
        let outline = if round % 3 == 0 { r.convex(corners) } else { r.star(corners) };
        for (mesh, count) in
            [(prism(&outline, 0.7), corners + 2), (ring(7), 28 - 12), (bracket(), 12)]
        {
            let pose = spatial::Frame::new(r.array(2.0), r.array(2.0));
            let place = if round % 2 == 0 { mesh } else { turned(&mesh, &pose) };
            let part = solid(&place);
            let facets = part.facets(0.0);
            check(&part, &facets, &format!("round {round}"));
            assert_eq!(facets.len(), count, "round {round}");
        }
    }
}

#[test]
fn each_point_of_a_hollow_face_is_in_one_triangle() {
    let r = &mut Random::new(92);
    for round in 0..60 {
        let outline = r.star(4 + round);
        let part = solid(&prism(&outline, 1.0));
        let polygon = clench_shape::Polygon::new(&outline).unwrap();
        let facets = part.facets(0.0);
        let top = facets.iter().find(|facet| facet.inward_normal()[2] == -1.0).unwrap();
        assert_eq!(top.triangles().len(), outline.len() - 2);
        for _ in 0..200 {
            let [x, y] = r.array(3.0);
            let point = Vector::new([x, y, 1.0]);
            let within = |&&[a, b, c]: &&[Vector<3>; 3]| {
                [[a, b], [b, c], [c, a]]
                    .iter()
                    .all(|&[p, q]| spatial::cross(q - p, point - p)[2] > 0.0)
            };
            let mut inside = false;
            for edge in polygon.edges() {
                let (p, q) = (edge.start(), edge.end());
                let crossed = p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]);
                inside ^= (p[1] > y) != (q[1] > y) && crossed > x;
            }
            let count = top.triangles().iter().filter(within).count();
            assert_eq!(count, usize::from(inside), "round {round}: {point:?}");
        }
    }
}

#[test]
fn corners_in_the_middle_of_straight_sides_get_no_triangle() {
    let outline =
        [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 2.0], [4.0, 4.0], [0.0, 4.0]];
    let facets = solid(&prism(&outline, 1.0)).facets(0.0);
    assert_eq!(facets.len(), 6);
    assert_eq!((facets[0].triangles().len(), facets[0].area()), (2, 16.0));
    assert_eq!(facets[0].loops(), [[0, 6, 5, 4, 3, 2, 1]]);
    // The lower side is three faces.
    assert_eq!((facets[2].faces(), facets[2].area()), ([2, 3, 4].as_slice(), 8.0));
    // A comb: hollow corners in line with each other, all in the way of one long ear.
    let teeth = 50;
    let mut comb = vec![[0.0, -1.0], [f64::from(2 * teeth), -1.0]];
    for i in (0..teeth).rev().map(f64::from) {
        comb.extend([
            [2.0 * i + 2.0, 3.0],
            [2.0 * i + 1.0, 3.0],
            [2.0 * i + 1.0, 0.0],
            [2.0 * i, 0.0],
        ]);
    }
    let part = solid(&prism(&comb, 1.0));
    check(&part, &part.facets(0.0), "comb");
}

/// The faces cut into triangles, and these again at random: within, and at their edges.
fn subdivided(r: &mut Random, mesh: &Mesh, rounds: usize) -> Mesh {
    let part = solid(mesh);
    let number = |v: &Vector<3>| part.vertices().iter().position(|u| u == v).unwrap();
    let facets = part.facets(0.0);
    let triangles = facets.iter().flat_map(Facet::triangles);
    let mut faces: Vec<[usize; 3]> =
        triangles.map(|corners| corners.each_ref().map(number)).collect();
    let mut vertices = part.vertices().to_vec();
    for _ in 0..rounds {
        let face = r.below(faces.len());
        let [from, to, tip] = faces[face];
        let [a, b, c] = [from, to, tip].map(|corner| vertices[corner]);
        let new = vertices.len();
        if r.below(2) == 0 {
            vertices.push(a * 0.25 + b * 0.25 + c * 0.5);
            faces[face] = [from, to, new];
            faces.extend([[to, tip, new], [tip, from, new]]);
        } else {
            vertices.push((a + b) * 0.5);
            let ends = |f: &[usize; 3]| (0..3).find(|&i| (f[i], f[(i + 1) % 3]) == (to, from));
            let (across, i) =
                faces.iter().enumerate().find_map(|(f, face)| Some((f, ends(face)?))).unwrap();
            let beyond = faces[across][(i + 2) % 3];
            faces[face] = [from, new, tip];
            faces[across] = [to, new, beyond];
            faces.extend([[new, to, tip], [new, from, beyond]]);
        }
    }
    (vertices.iter().map(|v| v.to_array()).collect(), faces.iter().map(|f| f.to_vec()).collect())
}

/// Normal, area, moment of the area, and number of loops of each facet, in an order of their own.
fn described(facets: &[Facet]) -> Vec<([f64; 7], usize)> {
    let mut all: Vec<_> = facets
        .iter()
        .map(|facet| {
            let moment = facet.triangles().iter().fold(Vector::ZERO, |sum, &[a, b, c]| {
                sum + (a + b + c) * (area_vector([a, b, c]).norm() / 3.0)
            });
            let ([x, y, z], [p, q, s]) = (facet.inward_normal().to_array(), moment.to_array());
            ([x, y, z, facet.area(), p, q, s], facet.loops().len())
        })
        .collect();
    // Apart by more than rounding.
    let key = |(row, _): &([f64; 7], usize)| row.map(|x| (x * 1e6).round());
    all.sort_by(|one, other| key(one).partial_cmp(&key(other)).unwrap());
    all
}

#[test]
fn facets_do_not_depend_on_how_faces_are_cut_and_numbered() {
    let r = &mut Random::new(93);
    let outline = [[-1.5, -1.0], [2.0, -1.25], [2.5, 1.0], [0.5, 0.25], [-1.0, 2.0]];
    for round in 0..60 {
        let mesh = [cuboid([1.0, 2.0, 0.5]), prism(&outline, 1.0), bracket()][round % 3].clone();
        let whole = solid(&mesh);
        let expected = described(&whole.facets(0.0));
        assert_eq!(expected.len(), [6, 7, 12][round % 3]);
        let rounds = 4 * r.below(30);
        let cut = subdivided(r, &mesh, rounds);
        let pose = spatial::Frame::new(r.array(2.0), r.array(2.0));
        let same = |found: &[Facet], expected: &[([f64; 7], usize)], what: &str| {
            let found = described(found);
            assert_eq!(found.len(), expected.len(), "{what}");
            for (one, other) in found.iter().zip(expected) {
                assert_eq!(one.1, other.1, "{what}");
                assert_all_close(&one.0, &other.0, 1e-11, what);
            }
        };
        let part = solid(&cut);
        let facets = part.facets(1e-12);
        check(&part, &facets, "cut");
        same(&facets, &expected, "cut");
        let moved = solid(&turned(&cut, &pose));
        let pieces = moved.facets(1e-11);
        check(&moved, &pieces, "turned");
        same(&pieces, &described(&solid(&turned(&mesh, &pose)).facets(1e-11)), "turned");
        // Other numbers: the same facets.
        let renumbered = renumbered(r, &cut);
        let other = solid(&renumbered);
        let others = other.facets(1e-12);
        check(&other, &others, "renumbered");
        let triangles = |facet: &Facet| {
            let mut all: Vec<[[u64; 3]; 3]> = facet.triangles().iter().map(bits).collect();
            all.sort_unstable();
            all
        };
        let sorted = |facets: &[Facet]| {
            let mut all: Vec<_> = facets.iter().map(triangles).collect();
            all.sort_unstable();
            all
        };
        assert_eq!(sorted(&facets), sorted(&others), "round {round}");
    }
}

fn bits(corners: &[Vector<3>; 3]) -> [[u64; 3]; 3] {
    let mut corners = corners.map(|corner| corner.to_array().map(|x| (x + 0.0).to_bits()));
    corners.sort_unstable();
    corners
}

fn shuffled(r: &mut Random, count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    (1..count).for_each(|i| order.swap(i, r.below(i + 1)));
    order
}

/// The same solid with vertices and faces in another order.
fn renumbered(r: &mut Random, (vertices, faces): &Mesh) -> Mesh {
    let (order, places) = (shuffled(r, faces.len()), shuffled(r, vertices.len()));
    let mut moved = vertices.clone();
    places.iter().zip(vertices).for_each(|(&place, &vertex)| moved[place] = vertex);
    let face = |&face: &usize| faces[face].iter().map(|&corner| places[corner]).collect();
    (moved, order.iter().map(face).collect())
}

#[test]
fn a_facet_with_a_hole_has_two_loops_that_turn_against_each_other() {
    let part = solid(&bracket());
    assert_close(part.volume(), 13.0, ROUNDING, 14.0, "volume");
    let facets = part.facets(0.0);
    assert_eq!(facets.len(), 12);
    let side = facets.iter().find(|facet| facet.faces().contains(&2)).unwrap();
    assert_eq!((side.faces(), side.area()), ([2, 8].as_slice(), 7.0));
    assert_eq!(side.loops(), [[0, 1, 7, 6], [12, 15, 14, 13]]);
    assert_eq!(side.inward_normal().to_array(), [0.0, 1.0, 0.0]);
}

#[test]
fn loops_part_where_a_facet_meets_itself_at_a_vertex() {
    // A plate whose upper side, cut along a lattice, has two pits that touch each other there.
    let mut vertices: Vec<[f64; 3]> =
        (0..25).map(|i| [f64::from(i % 5), f64::from(i / 5), 1.0]).collect();
    vertices.extend([[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0]]);
    vertices.extend([[1.5, 1.5, 0.5], [2.5, 2.5, 0.5]]);
    let mut faces = vec![
        vec![28, 27, 26, 25],
        vec![25, 26, 4, 3, 2, 1, 0],
        vec![26, 27, 24, 19, 14, 9, 4],
        vec![27, 28, 20, 21, 22, 23, 24],
        vec![28, 25, 0, 5, 10, 15, 20],
    ];
    for (x, y) in (0..16).map(|i| (i % 4, i / 4)) {
        let ring = [5 * y + x, 5 * y + x + 1, 5 * y + x + 6, 5 * y + x + 5];
        match (x, y) {
            (1, 1) | (2, 2) => {
                faces.extend((0..4).map(|i| vec![ring[i], ring[(i + 1) % 4], 28 + x]));
            }
            _ => faces.push(ring.to_vec()),
        }
    }
    let part = solid(&(vertices, faces));
    let facets = part.facets(0.0);
    check(&part, &facets, "pits");
    assert_eq!(facets.len(), 6 + 8);
    let top = facets.iter().find(|facet| facet.inward_normal()[2] == -1.0).unwrap();
    assert_eq!((top.area(), top.faces().len()), (14.0, 14));
    let rim = vec![0, 1, 2, 3, 4, 9, 14, 19, 24, 23, 22, 21, 20, 15, 10, 5];
    assert_eq!(top.loops(), [rim, vec![6, 11, 12, 7], vec![12, 17, 18, 13]]);
}

/// As a file in single precision has it.
fn in_single_precision((vertices, faces): &Mesh) -> Mesh {
    #[expect(clippy::cast_possible_truncation, reason = "what such a file does")]
    let rounded = |v: &[f64; 3]| v.map(|x| f64::from(x as f32));
    (vertices.iter().map(rounded).collect(), faces.clone())
}

#[test]
fn single_precision_does_not_split_facets_within_its_flatness() {
    let r = &mut Random::new(94);
    let mut most = 0;
    for round in 0..100 {
        let (mesh, count) = [(cuboid([1.0, 2.0, 0.5]), 6), (bracket(), 12)][round % 2].clone();
        let cut = subdivided(r, &mesh, 60);
        let pose = spatial::Frame::new(r.array(2.0), r.array(2.0));
        // Slivers that this turns over pass through others, but by its rounding only.
        let part = solid(&in_single_precision(&turned(&cut, &pose)));
        let largest = part.vertices().iter().fold(0.0_f64, |m, v| m.max(v.max_abs()));
        let facets = part.facets(1e-6 * largest);
        check(&part, &facets, "single precision");
        assert_eq!(facets.len(), count, "round {round}");
        most = most.max(part.facets(0.0).len());
    }
    assert!(most > 50, "{most}");
}

#[test]
fn round_surfaces_keep_their_faces() {
    let ball = rough_ball(&mut Random::new(95), 4, 1.0);
    let part = Polyhedron::from_triangles(&ball).unwrap();
    assert_eq!(part.facets(0.0).len(), 2048);
    assert_eq!(part.facets(1e-6).len(), 2048);
    // A flatness that is no length is none.
    assert_eq!(part.facets(-1.0).len(), 2048);
    assert_eq!(part.facets(f64::NAN).len(), 2048);
    // One larger than the solid takes all of it together, without borders.
    let all = part.facets(10.0);
    assert_eq!((all.len(), all[0].faces().len(), all[0].loops().len()), (1, 2048, 0));
    assert!(all[0].inward_normal().is_finite());
}

#[test]
fn both_sides_of_a_thin_sheet_stay_apart() {
    let r = &mut Random::new(96);
    let sheet = cuboid([1.0, 2.0, 1e-4]);
    let part = solid(&subdivided(r, &sheet, 0));
    assert_eq!(part.facets(0.0).len(), 6);
    // With the rim within the flatness, each side keeps its way, and takes some of the rim.
    let facets = part.facets(1e-3);
    assert_eq!(facets.len(), 2);
    let [one, other] = [0, 1].map(|i| facets[i].inward_normal());
    assert!(one.dot(other) < -0.999, "{one:?} {other:?}");
}
