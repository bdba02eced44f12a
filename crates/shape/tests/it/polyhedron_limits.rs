//! What is no solid, each with its exact error; and solids of extreme size.

use clench_screw::{Vector, spatial};
use clench_shape::{
    LARGEST_SOLID_COORDINATE, PolygonError, Polyhedron, PolyhedronError, SMALLEST_SOLID_COORDINATE,
};
use clench_testkit::{Random, assert_close};

use crate::solids::{Mesh, cuboid, prism, rough_ball, solid, turned};

/// The corner of a cube; edges from vertex 0 along the axes.
fn corner() -> Mesh {
    let vertices = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    (vertices, vec![vec![0, 2, 1], vec![0, 1, 3], vec![0, 3, 2], vec![1, 2, 3]])
}

#[track_caller]
fn refused(mesh: &Mesh, expected: PolyhedronError) {
    assert_eq!(Polyhedron::new(&mesh.0, &mesh.1), Err(expected), "{expected}");
}

/// The corner of a cube with one thing changed.
fn changed(change: impl FnOnce(&mut Mesh)) -> Mesh {
    let mut mesh = corner();
    change(&mut mesh);
    mesh
}

#[test]
fn too_little_encloses_nothing() {
    let few = changed(|mesh| mesh.0.truncate(3));
    refused(&few, PolyhedronError::TooFewVertices { count: 3 });
    let few = changed(|mesh| mesh.1.truncate(3));
    refused(&few, PolyhedronError::TooFewFaces { count: 3 });
    let few = changed(|mesh| mesh.1[2] = vec![0, 3]);
    refused(&few, PolyhedronError::TooFewCorners { face: 2, count: 2 });
}

#[test]
fn coordinates_out_of_range_are_named_with_their_place() {
    for value in [f64::INFINITY, f64::NEG_INFINITY] {
        let mesh = changed(|mesh| mesh.0[3][2] = value);
        refused(&mesh, PolyhedronError::NotFinite { vertex: 3, axis: 'z', value });
    }
    let mesh = changed(|mesh| mesh.0[1][1] = f64::NAN);
    let fault = Polyhedron::new(&mesh.0, &mesh.1).unwrap_err();
    assert_eq!(fault.to_string(), "y of vertex 1 is NaN, not a finite number");
    let value = LARGEST_SOLID_COORDINATE.next_up();
    let mesh = changed(|mesh| mesh.0[1][0] = value);
    refused(&mesh, PolyhedronError::TooLarge { vertex: 1, axis: 'x', value });
    let value = -SMALLEST_SOLID_COORDINATE.next_down();
    let mesh = changed(|mesh| mesh.0[2][0] = value);
    refused(&mesh, PolyhedronError::TooSmall { vertex: 2, axis: 'x', value });
}

#[test]
fn corners_that_are_no_numbers_are_not_counted_as_one_vertex() {
    // As a file may have them: all six equal to one another, bit for bit.
    let nan = [f64::NAN; 3];
    let triangles = [[nan, nan, nan], [nan, nan, nan], [[0.0; 3], [1.0, 0.0, 0.0], nan]];
    let fault = Polyhedron::from_triangles(&triangles).unwrap_err();
    assert_eq!(fault.to_string(), "x of vertex 0 is NaN, not a finite number");
}

#[test]
fn messages_name_no_functions() {
    let fault = PolyhedronError::EqualVertices { first: 2, second: 6 }.to_string();
    assert!(fault.starts_with("vertices 2 and 6 are the same point; give it once"), "{fault}");
    assert!(!fault.contains("::"), "{fault}");
}

#[test]
fn faces_name_each_of_their_vertices_once() {
    let mesh = changed(|mesh| mesh.1[3] = vec![1, 2, 4]);
    refused(&mesh, PolyhedronError::NoSuchVertex { face: 3, vertex: 4, count: 4 });
    let mesh = changed(|mesh| mesh.1[1] = vec![0, 1, 3, 1]);
    refused(&mesh, PolyhedronError::RepeatedCorner { face: 1, vertex: 1 });
}

#[test]
fn unused_vertices_do_no_harm_and_used_ones_differ() {
    let mut mesh = corner();
    mesh.0.extend([[9.0, 9.0, 9.0], [0.0, 0.0, 0.0]]);
    let part = solid(&mesh);
    assert_eq!((part.vertices().len(), part.box_center().to_array()), (6, [0.5; 3]));
    mesh.0.push([-0.0, 1.0, 0.0]);
    mesh.1[3] = vec![1, 6, 3];
    refused(&mesh, PolyhedronError::EqualVertices { first: 2, second: 6 });
}

#[test]
fn a_face_without_area_is_refused() {
    let mesh = changed(|mesh| {
        mesh.0.push([0.5, 0.0, 0.0]);
        mesh.1.push(vec![0, 4, 1]);
    });
    let allowed = 32.0 * f64::EPSILON;
    refused(&mesh, PolyhedronError::ZeroAreaFace { face: 4, width: 0.0, allowed });
}

#[test]
fn a_bent_face_is_refused_with_what_is_off() {
    let (mut vertices, faces) = cuboid([1.0; 3]);
    vertices[6][2] += 0.25;
    let fault = Polyhedron::new(&vertices, &faces).unwrap_err();
    let PolyhedronError::NotPlanar { face: 1, distance, allowed, .. } = fault else {
        panic!("{fault:?}");
    };
    assert!(distance > 0.1 && allowed < 1e-13, "{fault}");
    // Turned boxes are as flat as their rounding leaves them, thin ones too.
    let r = &mut Random::new(45);
    for _ in 0..500 {
        let sizes = [1.0, r.between(1e-3, 1.0), 10_f64.powf(r.between(-6.0, 0.0))];
        let pose = spatial::Frame::new(r.array(2.0), r.array(3.0));
        solid(&turned(&cuboid(sizes), &pose));
    }
}

#[test]
fn a_face_that_meets_itself_is_refused() {
    let outline = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, -1.0], [0.0, 2.0]];
    let (vertices, faces) = prism(&outline, 1.0);
    let fault = PolygonError::CrossingEdges { first: 1, second: 4 };
    let found = Polyhedron::new(&vertices, &faces);
    assert!(matches!(found, Err(PolyhedronError::FaultyFace { face: 0, .. })), "{found:?}");
    let upright = (vertices, [&faces[1..], &faces[..1]].concat());
    let fault_of_the_top = PolygonError::CrossingEdges { first: 0, second: 2 };
    assert_ne!(fault, fault_of_the_top);
    refused(&upright, PolyhedronError::FaultyFace { face: 0, fault: fault_of_the_top });
}

#[test]
fn holes_and_flipped_and_extra_faces_are_found_at_their_edges() {
    let open = changed(|mesh| {
        mesh.0.push([2.0, 2.0, 2.0]);
        mesh.1[3] = vec![1, 2, 4];
    });
    refused(&open, PolyhedronError::OpenEdge { vertices: [1, 3], face: 1 });
    let flipped = changed(|mesh| mesh.1[3] = vec![3, 2, 1]);
    refused(&flipped, PolyhedronError::FlippedNeighbor { vertices: [2, 1], faces: [0, 3] });
    let extra = changed(|mesh| {
        mesh.0.push([2.0, 2.0, 2.0]);
        mesh.1.push(vec![1, 2, 4]);
    });
    let faces = [0, 3, 4];
    refused(&extra, PolyhedronError::NonManifoldEdge { vertices: [1, 2], faces, count: 3 });
}

/// A ball of triangles with one thing changed, and what is wrong with it.
fn damaged(change: impl FnOnce(&mut Vec<[[f64; 3]; 3]>)) -> PolyhedronError {
    let mut mesh = rough_ball(&mut Random::new(46), 3, 1.2);
    change(&mut mesh);
    Polyhedron::from_triangles(&mesh).unwrap_err()
}

#[test]
fn damaged_meshes_are_refused_with_the_triangles_at_fault() {
    use PolyhedronError as Fault;
    let fault = damaged(Vec::clear);
    assert_eq!(fault, Fault::TooFewVertices { count: 0 });
    let fault = damaged(|mesh| mesh.truncate(3));
    assert_eq!(fault, Fault::TooFewFaces { count: 3 });
    let fault = damaged(|mesh| mesh[77][1] = mesh[77][2]);
    assert!(matches!(fault, Fault::RepeatedCorner { face: 77, .. }), "{fault:?}");
    let fault = damaged(|mesh| {
        let [a, b, _] = mesh[77].map(Vector::new);
        mesh[77][2] = ((a + b) * 0.5).to_array();
    });
    assert!(matches!(fault, Fault::ZeroAreaFace { face: 77, .. }), "{fault:?}");
    let fault = damaged(|mesh| {
        mesh.remove(77);
    });
    assert!(matches!(fault, Fault::OpenEdge { .. }), "{fault:?}");
    let fault = damaged(|mesh| mesh[77].reverse());
    let Fault::FlippedNeighbor { faces, .. } = fault else { panic!("{fault:?}") };
    assert!(faces.contains(&77), "{fault:?}");
    // A triangle that is there twice, and one turned over that lies on it.
    let fault = damaged(|mesh| mesh.push(mesh[77]));
    let Fault::NonManifoldEdge { faces, count: 3, .. } = fault else { panic!("{fault:?}") };
    assert!(faces[2] == 512 && faces.contains(&77), "{fault:?}");
    let fault = damaged(|mesh| {
        let [a, b, c] = mesh[77];
        mesh.push([a, c, b]);
    });
    assert!(matches!(fault, Fault::NonManifoldEdge { count: 3, .. }), "{fault:?}");
    // All of it twice.
    let fault = damaged(|mesh| mesh.extend(mesh.clone()));
    assert!(matches!(fault, Fault::NonManifoldEdge { count: 4, .. }), "{fault:?}");
    // The same ball a little to the side, and a smaller one inside.
    let moved = |mesh: &[[[f64; 3]; 3]], share: f64, shift: f64| -> Vec<[[f64; 3]; 3]> {
        mesh.iter().map(|t| t.map(|[x, y, z]| [x * share + shift, y * share, z * share])).collect()
    };
    let fault = damaged(|mesh| mesh.extend(moved(mesh, 1.0, 0.25)));
    let Fault::FacesCross { faces: [0..512, 512..1024], point } = fault else {
        panic!("{fault:?}")
    };
    assert!(Vector::new(point).norm() < 1.2, "{point:?}");
    let fault = damaged(|mesh| mesh.extend(moved(mesh, 0.5, 0.0)));
    assert_eq!(fault, Fault::NestedAlike { face: 512, around: 0 });
}

#[test]
fn a_triangle_that_is_missing_is_named_by_an_edge_and_its_neighbor() {
    let mesh = rough_ball(&mut Random::new(46), 3, 1.2);
    let part = Polyhedron::from_triangles(&mesh).unwrap();
    let vertices: Vec<[f64; 3]> = part.vertices().iter().map(|v| v.to_array()).collect();
    let faces: Vec<Vec<usize>> = part.faces().iter().map(|f| f.vertices().to_vec()).collect();
    for missing in [0, 77, 511] {
        let mut left = faces.clone();
        let gone = left.swap_remove(missing);
        let fault = Polyhedron::new(&vertices, &left).unwrap_err();
        let PolyhedronError::OpenEdge { vertices: ends, face } = fault else { panic!("{fault:?}") };
        for end in ends {
            assert!(gone.contains(&end) && left[face].contains(&end), "{fault:?}");
        }
    }
}

#[test]
fn many_triangles_in_each_others_way_are_refused_soon() {
    let r = &mut Random::new(47);
    let mut triangles = Vec::new();
    for _ in 0..50_000 {
        let [a, b, c, d]: [[f64; 3]; 4] = std::array::from_fn(|_| r.array(1.0));
        triangles.extend([[a, c, b], [a, b, d], [b, c, d], [c, a, d]]);
    }
    let fault = Polyhedron::from_triangles(&triangles).unwrap_err();
    assert!(matches!(fault, PolyhedronError::FacesCross { faces: [0, _], .. }), "{fault:?}");
}

#[test]
fn flat_and_inside_out_solids_are_told_apart() {
    // Both sides of a square, cut along both diagonals.
    let vertices = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let faces = vec![vec![0, 1, 2], vec![0, 2, 3], vec![1, 0, 3], vec![1, 3, 2]];
    let allowed = 4.0 * f64::EPSILON * 2.0;
    refused(&(vertices, faces), PolyhedronError::ZeroVolume { face: 0, volume: 0.0, allowed });
    let inside_out = changed(|mesh| mesh.1.iter_mut().for_each(|face| face.reverse()));
    let found = Polyhedron::new(&inside_out.0, &inside_out.1);
    let Err(PolyhedronError::InsideOut { face: 0, volume }) = found else {
        panic!("an inside-out solid was accepted");
    };
    assert_close(volume, -1.0 / 6.0, f64::EPSILON, 1.0, "volume");
}

#[test]
fn solids_of_any_allowed_size_have_their_measures() {
    for size in [2.0 * SMALLEST_SOLID_COORDINATE, 1e-9, 1e9, LARGEST_SOLID_COORDINATE] {
        let part = solid(&cuboid([size; 3]));
        let volume = (2.0 * size).powi(3);
        assert_close(part.volume(), volume, 8.0 * f64::EPSILON, volume, "volume");
        let depth = part.signed_distance([0.5 * size, 0.0, 0.25 * size].into());
        assert_close(depth, -0.5 * size, f64::EPSILON, size, "depth");
        let above = part.place([0.0, 2.0 * size, 0.0].into());
        assert_close(above.distance, size, f64::EPSILON, size, "distance");
    }
}
