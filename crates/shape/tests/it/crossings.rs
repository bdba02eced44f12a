//! Surfaces that pass through themselves, and those that only touch.

use clench_screw::{Vector, spatial};
use clench_shape::{Polyhedron, PolyhedronError};
use clench_testkit::Random;

use crate::solids::{Mesh, cuboid, solid, turned};

/// One mesh of several, each with its own vertices.
fn joined(meshes: &[Mesh]) -> Mesh {
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for (points, own) in meshes {
        let shift = vertices.len();
        vertices.extend(points);
        faces.extend(own.iter().map(|face| face.iter().map(|c| c + shift).collect::<Vec<_>>()));
    }
    (vertices, faces)
}

fn found((vertices, faces): &Mesh) -> Option<PolyhedronError> {
    Polyhedron::new(vertices, faces).err()
}

fn at(mesh: &Mesh, origin: [f64; 3]) -> Mesh {
    turned(mesh, &spatial::Frame::at(Vector::new(origin)))
}

/// In some poses, the last of them turned so that nothing is exact any more.
fn poses(r: &mut Random) -> [spatial::Frame; 6] {
    [
        spatial::Frame::at(Vector::ZERO),
        spatial::Frame::at(Vector::new([8.0, -16.0, 0.5])),
        spatial::Frame::new(r.array(9.0), [0.0; 3]),
        spatial::Frame::new([0.0; 3], [0.0, 0.0, r.between(-3.0, 3.0)]),
        spatial::Frame::new(r.array(9.0), r.array(3.0)),
        spatial::Frame::new(r.array(9.0), r.array(3.0)),
    ]
}

/// That a mesh crosses itself in any pose, at a point on both faces that are named.
#[track_caller]
fn crosses(r: &mut Random, mesh: &Mesh) {
    for pose in poses(r) {
        let (vertices, faces) = turned(mesh, &pose);
        let fault = Polyhedron::new(&vertices, &faces).unwrap_err();
        let PolyhedronError::FacesCross { faces: named, point } = fault else {
            panic!("{fault:?}")
        };
        assert!(named[0] < named[1], "{fault}");
        for face in named {
            let corners = &faces[face];
            let [a, b, c] = [0, 1, 2].map(|i| Vector::new(vertices[corners[i]]));
            let normal = spatial::cross(b - a, c - a).direction().unwrap();
            let off = normal.dot(Vector::new(point) - a);
            assert!(off.abs() < 1e-13 * 20.0, "{fault}: {off:e}");
        }
    }
}

#[test]
fn shells_that_cross_are_refused() {
    let r = &mut Random::new(101);
    let base = cuboid([1.0; 3]);
    let others = [
        // Through faces, an edge, a corner; a post through it; and one that is as thick.
        at(&cuboid([0.5; 3]), [0.5, 0.25, 0.75]),
        at(&cuboid([0.5; 3]), [1.0, 1.0, 0.25]),
        at(&cuboid([0.75; 3]), [0.5, 0.5, 0.5]),
        cuboid([0.5, 0.25, 2.0]),
        at(&cuboid([0.5, 1.0, 2.0]), [0.25, 0.0, 0.0]),
    ];
    for other in others {
        crosses(r, &joined(&[base.clone(), other.clone()]));
        crosses(r, &joined(&[other, base.clone()]));
    }
    let fault = found(&joined(&[base, cuboid([0.5, 0.25, 2.0])])).unwrap();
    let PolyhedronError::FacesCross { faces: [0, 8], point } = fault else { panic!("{fault:?}") };
    assert_eq!((point[1], point[2]), (-0.25, -1.0));
    let message = format!("faces 0 and 8 pass through each other, at ({}, -0.25, -1)", point[0]);
    assert!(fault.to_string().starts_with(&message), "{fault}");
}

/// A plate from `z = -1` to 1 whose upper side is cut by `inner` lines, all of its faces triangles.
fn plate(inner: &[[f64; 2]], top: &[[usize; 3]]) -> Mesh {
    let (mut vertices, mut faces) = cuboid([2.0, 2.0, 1.0]);
    vertices.extend(inner.iter().map(|&[x, y]| [x, y, 1.0]));
    faces.remove(1);
    faces.extend(top.iter().map(|corners| corners.map(|corner| corner + 4).to_vec()));
    (vertices, faces)
}

#[test]
fn a_post_through_edges_of_a_mesh_crosses_it() {
    let r = &mut Random::new(102);
    let post = |z: f64| at(&cuboid([0.5, 0.5, 2.0]), [0.0, 0.0, z]);
    // All edges of the post go through edges of the plate's upper side.
    let fan = plate(&[[0.0, 0.0]], &[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]);
    assert_eq!(solid(&fan).facets(0.0).len(), 6);
    crosses(r, &joined(&[fan.clone(), post(1.5)]));
    crosses(r, &joined(&[fan.clone(), post(0.25)]));
    // The same, and edges of the plate all around the post.
    let square = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
    let ring = [[4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5]];
    let ring = [&ring[..], &[[2, 3, 7], [2, 7, 6], [3, 0, 4], [3, 4, 7]]].concat();
    let imprint = plate(&square, &ring);
    assert_eq!(solid(&imprint).facets(0.0).len(), 6);
    crosses(r, &joined(&[imprint.clone(), post(1.25)]));
    // A post that only stands there is no fault.
    for plate in [fan, imprint] {
        let standing = joined(&[plate, at(&cuboid([0.5, 0.25, 1.0]), [0.0, 0.0, 2.0])]);
        for pose in poses(r) {
            assert_eq!(found(&turned(&standing, &pose)), None);
        }
    }
}

#[test]
fn overlapping_bases_are_refused() {
    let base = cuboid([1.0; 3]);
    let lower = at(&cuboid([1.0, 0.5, 0.5]), [1.0, 0.0, -0.5]);
    let fault = found(&joined(&[base.clone(), lower]));
    let Some(PolyhedronError::FacesCross { faces: [0, 6], point }) = fault else {
        panic!("{fault:?}")
    };
    assert!(
        point[2] == -1.0 && (0.0..1.0).contains(&point[0]) && point[1].abs() < 0.5,
        "{point:?}"
    );
    // One inside the other with their bases in one plane is a matter of how they are wound.
    let inner = at(&cuboid([0.5; 3]), [0.0, 0.0, -0.5]);
    let fault = found(&joined(&[base, inner]));
    assert!(matches!(fault, Some(PolyhedronError::FacesCross { faces: [0, 6], .. })), "{fault:?}");
}

#[test]
fn one_surface_that_passes_through_itself_is_refused() {
    let r = &mut Random::new(103);
    // The middle of the upper side is pushed down, and out at the bottom.
    let dented = |z: f64| {
        let mut mesh = plate(&[[0.5, 0.25]], &[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]);
        mesh.0[8][2] = z;
        mesh
    };
    solid(&dented(-0.75));
    crosses(r, &dented(-1.5));
    crosses(r, &dented(-1.0 - 1e-9));
    // To the bottom only: that the surface touches itself there is no fault.
    assert_eq!(found(&dented(-1.0)), None);
    assert_eq!(found(&dented(-1.0_f64.next_up())), None);
    // Nor is what single precision rounds to, if that is what all coordinates have.
    let next = f64::from((-1.0_f32).next_down());
    assert_eq!(found(&dented(next)), None);
    assert!(found(&dented(next.next_down())).is_some());
}

/// Whether the corners of tetrahedra, small whole numbers, are separated by a plane, touching or
/// not; or one holds the other.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Relation {
    Apart,
    Inside,
    Crossing,
}

type Whole = [i64; 3];

fn minus(a: Whole, b: Whole) -> Whole {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn times(a: Whole, b: Whole) -> Whole {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn along(a: Whole, b: Whole) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
const EDGES: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

fn normals(t: &[Whole; 4]) -> impl Iterator<Item = (Whole, Whole)> {
    FACES.iter().map(|&[a, b, c]| (times(minus(t[b], t[a]), minus(t[c], t[a])), t[a]))
}

fn relation(t: &[Whole; 4], u: &[Whole; 4]) -> Relation {
    let directions = |t: &[Whole; 4]| EDGES.map(|[a, b]| minus(t[b], t[a]));
    let (mine, theirs) = (directions(t), directions(u));
    let across = mine.iter().flat_map(|&d| theirs.iter().map(move |&e| times(d, e)));
    let axes = normals(t).chain(normals(u)).map(|(normal, _)| normal).chain(across);
    let is_apart = |axis: Whole| {
        let range = |t: &[Whole; 4]| {
            let at = t.map(|p| along(p, axis));
            (at.into_iter().min().unwrap(), at.into_iter().max().unwrap())
        };
        let ((low, high), (from, to)) = (range(t), range(u));
        axis != [0; 3] && (high <= from || to <= low)
    };
    let holds = |t: &[Whole; 4], u: &[Whole; 4]| {
        normals(t).all(|(normal, point)| u.iter().all(|&p| along(minus(p, point), normal) <= 0))
    };
    if axes.into_iter().any(is_apart) {
        Relation::Apart
    } else if holds(t, u) || holds(u, t) {
        Relation::Inside
    } else {
        Relation::Crossing
    }
}

fn tetrahedron(r: &mut Random, size: usize) -> [Whole; 4] {
    loop {
        let mut t: [Whole; 4] =
            std::array::from_fn(|_| std::array::from_fn(|_| i64::try_from(r.below(size)).unwrap()));
        let volume =
            |t: &[Whole; 4]| along(times(minus(t[1], t[0]), minus(t[2], t[0])), minus(t[3], t[0]));
        if volume(&t) < 0 {
            t.swap(0, 1);
        }
        if volume(&t) > 0 {
            return t;
        }
    }
}

#[test]
fn tetrahedra_on_a_lattice_cross_if_whole_numbers_say_so() {
    let r = &mut Random::new(104);
    let mut counts = [0; 4];
    for round in 0..40_000 {
        let size = 3 + r.below(6);
        let [t, u] = [tetrahedron(r, size), tetrahedron(r, size)];
        // Equal vertices are one, so that neighbors that share a vertex are there too.
        #[expect(clippy::cast_precision_loss, reason = "single digits")]
        let corner = |p: Whole| p.map(|x| x as f64);
        let triangles: Vec<_> =
            [t, u].iter().flat_map(|t| FACES.map(|face| face.map(|i| corner(t[i])))).collect();
        let fault = Polyhedron::from_triangles(&triangles).err();
        let expected = relation(&t, &u);
        let crossing = matches!(fault, Some(PolyhedronError::FacesCross { .. }));
        let what = format!("round {round}: {t:?} {u:?} {expected:?} {fault:?}");
        match (&fault, expected) {
            // Two vertices in common.
            (
                Some(
                    PolyhedronError::NonManifoldEdge { .. }
                    | PolyhedronError::FlippedNeighbor { .. },
                ),
                _,
            ) => counts[0] += 1,
            (_, Relation::Apart) => {
                assert_eq!(fault, None, "{what}");
                counts[1] += 1;
            }
            (_, Relation::Crossing) => {
                assert!(crossing, "{what}");
                counts[2] += 1;
            }
            (_, Relation::Inside) => {
                assert!(fault.is_some(), "{what}");
                counts[3] += 1;
            }
        }
    }
    assert!(counts[..3].iter().all(|&count| count > 500) && counts[3] > 0, "{counts:?}");
}
