//! Solids whose surface is in several pieces: beside each other, in each other, touching.

use clench_screw::{Vector, spatial};
use clench_shape::{Polyhedron, PolyhedronError};
use clench_testkit::{Random, assert_close};

use crate::solids::{Mesh, cuboid, prism, rough_ball, solid, turned};

/// How a shell is wound.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Wound {
    Outward,
    Inward,
}

/// The cube with this half-width about a center.
fn cube(half: f64, center: [f64; 3]) -> Mesh {
    turned(&cuboid([half; 3]), &spatial::Frame::at(center.into()))
}

/// One mesh of several, each with its own vertices.
fn joined(shells: &[(Mesh, Wound)]) -> Mesh {
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for ((points, outward), wound) in shells {
        let shift = vertices.len();
        vertices.extend(points);
        faces.extend(outward.iter().map(|face| {
            let moved = face.iter().map(|corner| corner + shift);
            if *wound == Wound::Outward { moved.collect() } else { moved.rev().collect() }
        }));
    }
    (vertices, faces)
}

fn found((vertices, faces): &Mesh) -> Option<PolyhedronError> {
    Polyhedron::new(vertices, faces).err()
}

#[test]
fn a_piece_that_is_inside_out_beside_another_is_refused() {
    let (large, small) = (cube(2.0, [0.0; 3]), cube(1.0, [8.0, 0.0, 0.0]));
    let pieces = joined(&[(large.clone(), Wound::Outward), (small.clone(), Wound::Outward)]);
    assert_eq!((solid(&pieces).volume(), solid(&pieces).pieces()), (64.0 + 8.0, 2));
    let inside_out = |shells: &[(Mesh, Wound)], first: usize| {
        let fault = found(&joined(shells)).unwrap();
        let PolyhedronError::InsideOut { face, volume } = fault else { panic!("{fault:?}") };
        assert_eq!(face, first);
        assert_close(volume, -8.0, 8.0 * f64::EPSILON, 64.0, "volume");
        let message = format!("the solid is inside out at face {first}: with all faces joined");
        assert!(fault.to_string().starts_with(&message), "{fault}");
    };
    inside_out(&[(large.clone(), Wound::Outward), (small.clone(), Wound::Inward)], 6);
    // The same where the other piece is passed first.
    let far = cube(1.0, [-8.0, 0.0, 0.0]);
    inside_out(&[(far, Wound::Inward), (large, Wound::Outward)], 0);
}

#[test]
fn a_shell_inside_another_is_wound_against_it() {
    use Wound::{Inward, Outward};
    let [outer, middle, inner] = [3.0, 2.0, 1.0].map(|half| cube(half, [0.25, 0.0, 0.5]));
    let nested = |wound: [Wound; 3]| {
        let meshes = [outer.clone(), middle.clone(), inner.clone()];
        joined(&meshes.into_iter().zip(wound).collect::<Vec<_>>())
    };
    let hollow = joined(&[(outer.clone(), Outward), (middle.clone(), Inward)]);
    assert_eq!((solid(&outer).pieces(), solid(&hollow).pieces()), (1, 1));
    let part = solid(&nested([Outward, Inward, Outward]));
    assert_eq!(part.pieces(), 2);
    assert_close(part.volume(), 216.0 - 64.0 + 8.0, f64::EPSILON, 216.0, "volume");
    assert_eq!(part.signed_distance([0.25, 1.75, 0.5].into()), 0.25);
    assert_eq!(part.signed_distance([0.25, 0.75, 0.5].into()), -0.25);
    let alike = |face, around| Some(PolyhedronError::NestedAlike { face, around });
    assert_eq!(found(&nested([Outward, Inward, Inward])), alike(12, 6));
    assert_eq!(found(&nested([Outward, Outward, Outward])), alike(6, 0));
    // With the outermost wrong, all others look wrong: it is the one that is named.
    let fault = Some(PolyhedronError::InsideOut { face: 0, volume: -216.0 });
    assert_eq!(found(&nested([Inward, Outward, Inward])), fault);
    let two = |wound| joined(&[(middle.clone(), Outward), (outer.clone(), wound)]);
    assert_eq!(found(&two(Outward)), alike(0, 6));
    let fault = Some(PolyhedronError::InsideOut { face: 6, volume: -216.0 });
    assert_eq!(found(&two(Inward)), fault);
    let message = found(&two(Outward)).unwrap().to_string();
    assert!(message.starts_with("face 0 and all faces joined to it are inside"), "{message}");
}

#[test]
fn a_flat_shell_beside_a_solid_is_refused() {
    let (mut vertices, mut faces) = cube(1.0, [0.0; 3]);
    vertices.extend([[4.0, 0.0, 0.0], [5.0, 0.0, 0.0], [5.0, 1.0, 0.0], [4.0, 1.0, 0.0]]);
    faces.extend([vec![8, 9, 10], vec![8, 10, 11], vec![9, 8, 11], vec![9, 11, 10]]);
    let fault = found(&(vertices, faces));
    let flat = matches!(fault, Some(PolyhedronError::ZeroVolume { face: 6, .. }));
    assert!(flat, "{fault:?}");
}

/// A shell that fills most of a cube, and how far out from the middle it leaves room, as a share.
fn shell(r: &mut Random, center: [f64; 3], half: f64, is_rough: bool) -> (Mesh, f64) {
    if !is_rough {
        return (cube(half, center), 0.5);
    }
    let ball = Polyhedron::from_triangles(&rough_ball(r, 2, 1.7)).unwrap();
    let moved = |v: &Vector<3>| (Vector::new(center) + *v * (0.5 * half)).to_array();
    let vertices = ball.vertices().iter().map(moved).collect();
    let faces = ball.faces().iter().map(|face| face.vertices().to_vec()).collect();
    ((vertices, faces), 0.125)
}

/// Shells at random beside and in each other, each with the number of shells around it.
///
/// On a lattice, so that lines along the axes from vertices meet vertices and edges of others.
fn nest(r: &mut Random, is_rough: bool) -> Vec<(Mesh, usize)> {
    let mut shells = Vec::new();
    let mut free = vec![([0.0; 3], 32.0, 0), ([80.0, 0.0, 0.0], 32.0, 0)];
    while shells.len() < 9 && !free.is_empty() {
        let (center, half, depth) = free.swap_remove(r.below(free.len()));
        let (mesh, room) = shell(r, center, half, is_rough);
        shells.push((mesh, depth));
        let mut places: Vec<[usize; 3]> = (0..3).map(|_| [0; 3].map(|_| r.below(3))).collect();
        places.sort_unstable();
        places.dedup();
        free.extend(places.into_iter().map(|place| {
            let at = std::array::from_fn(|k| center[k] + (place[k] as f64 - 1.0) * room * half);
            (at, 0.375 * room * half, depth + 1)
        }));
    }
    shells
}

#[test]
fn shells_in_shells_are_accepted_in_one_winding_only() {
    let r = &mut Random::new(61);
    let mut deepest = 0;
    for round in 0..120 {
        let shells = nest(r, round % 2 == 1);
        let pose = spatial::Frame::new(r.array(20.0), r.array(3.0));
        let place = |mesh: &Mesh| if round % 4 < 2 { mesh.clone() } else { turned(mesh, &pose) };
        let wound = |flipped: Option<usize>| {
            let each = shells.iter().enumerate().map(|(i, (mesh, depth))| {
                let is_outward = depth.is_multiple_of(2) != (flipped == Some(i));
                (place(mesh), if is_outward { Wound::Outward } else { Wound::Inward })
            });
            joined(&each.collect::<Vec<_>>())
        };
        assert_eq!(found(&wound(None)), None, "round {round}");
        deepest = shells.iter().fold(deepest, |deepest, (_, depth)| deepest.max(*depth));
        let mut first = 0;
        for (i, (mesh, depth)) in shells.iter().enumerate() {
            let fault = found(&wound(Some(i)));
            let named = match fault {
                Some(PolyhedronError::InsideOut { face, .. }) => *depth == 0 && face == first,
                Some(PolyhedronError::NestedAlike { face, .. }) => *depth > 0 && face == first,
                _ => false,
            };
            assert!(named, "round {round}, shell {i} from face {first} at {depth}: {fault:?}");
            first += mesh.1.len();
        }
    }
    assert!(deepest > 3, "{deepest}");
}

#[test]
fn shells_that_touch_are_left_alone() {
    let base = cube(1.0, [0.0; 3]);
    // A slot along y, filled by a block; a pocket, filled too.
    let slot = [[-3.0, -3.0], [3.0, -3.0], [3.0, 3.0], [1.0, 3.0], [1.0, -1.0], [-1.0, -1.0]];
    let slot = [&slot[..], &[[-1.0, 3.0], [-3.0, 3.0]]].concat();
    let pairs = [
        // Face on face, the smaller one within the larger one's.
        (base.clone(), cube(0.5, [0.25, 0.25, 1.5])),
        (base.clone(), cube(0.5, [0.25, 1.5, 0.25])),
        (base.clone(), cube(0.5, [1.5, 0.25, 0.25])),
        // Edge on edge, the ends of one within the other; and a vertex on a vertex.
        (base.clone(), cube(0.5, [1.5, 1.5, 0.25])),
        (base.clone(), cube(0.5, [1.5, 1.5, 1.5])),
        (prism(&slot, 2.0), turned(&cuboid([1.0, 1.5, 1.0]), &at([0.0, 0.5, 0.0]))),
        (prism(&slot, 2.0), turned(&cuboid([1.0, 2.0, 2.0]), &at([0.0, 1.0, 0.0]))),
    ];
    let r = &mut Random::new(62);
    for (i, (one, other)) in pairs.iter().enumerate() {
        for round in 0..200 {
            let pose = match round % 3 {
                0 => at(r.array(9.0)),
                1 => spatial::Frame::new([0.0; 3], [0.0, 0.0, r.between(-3.0, 3.0)]),
                _ => spatial::Frame::new(r.array(9.0), r.array(3.0)),
            };
            let place = |mesh: &Mesh| turned(mesh, &pose);
            let both = [(place(one), Wound::Outward), (place(other), Wound::Outward)];
            let fault = found(&joined(&both)).filter(|fault| {
                // Touching vertices are not always equal once they are rounded.
                !matches!(fault, PolyhedronError::EqualVertices { .. })
            });
            assert_eq!(fault, None, "pair {i}, round {round}");
        }
    }
}

#[test]
fn pieces_may_share_a_vertex() {
    // Two corners of cubes, opposite each other at the origin.
    let vertices = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mirrored = vertices[1..].iter().map(|v| v.map(|x| -x));
    let vertices: Vec<[f64; 3]> = vertices.iter().copied().chain(mirrored).collect();
    let faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    let other = [[0, 4, 5], [0, 6, 4], [0, 5, 6], [4, 6, 5]];
    let faces: Vec<Vec<usize>> = faces.iter().chain(&other).map(|f| f.to_vec()).collect();
    let part = solid(&(vertices, faces));
    assert_close(part.volume(), 1.0 / 3.0, f64::EPSILON, 1.0, "volume");
}

fn at(origin: [f64; 3]) -> spatial::Frame {
    spatial::Frame::at(Vector::new(origin))
}
