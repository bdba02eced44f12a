//! Solids for the tests of this crate.

use std::f64::consts::TAU;

use clench_screw::{Vector, spatial};
use clench_shape::Polyhedron;
use clench_testkit::Random;

pub(crate) type Mesh = (Vec<[f64; 3]>, Vec<Vec<usize>>);

/// The box with these half-widths about the origin.
pub(crate) fn cuboid([a, b, c]: [f64; 3]) -> Mesh {
    let (vertices, faces) = prism(&[[-a, -b], [a, -b], [a, b], [-a, b]], c);
    (vertices, faces)
}

/// A prism over a counter-clockwise outline, from `z = -h` to `h`.
pub(crate) fn prism(outline: &[[f64; 2]], h: f64) -> Mesh {
    let n = outline.len();
    let level = |z: f64| outline.iter().map(move |&[x, y]| [x, y, z]);
    let mut faces = vec![(0..n).rev().collect::<Vec<_>>(), (n..2 * n).collect()];
    faces.extend((0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]));
    (level(-h).chain(level(h)).collect(), faces)
}

/// An L from `z = -1` to 1, its foot along x with a square hole along y: 12 sides, of which those
/// with the hole are two faces each.
pub(crate) fn bracket() -> Mesh {
    let outline = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]];
    let (mut vertices, mut faces) = prism(&outline, 1.0);
    let hole = [[2.0, -0.5], [3.0, -0.5], [3.0, 0.5], [2.0, 0.5]];
    vertices.extend(hole.map(|[x, z]| [x, 0.0, z]));
    vertices.extend(hole.map(|[x, z]| [x, 1.0, z]));
    faces[2] = vec![0, 1, 7, 14, 13, 12];
    faces.push(vec![0, 12, 15, 14, 7, 6]);
    faces[4] = vec![2, 3, 9, 19, 16, 17];
    faces.push(vec![2, 17, 18, 19, 9, 8]);
    for i in 0..4 {
        let j = (i + 1) % 4;
        faces.push(vec![12 + i, 12 + j, 16 + j, 16 + i]);
    }
    (vertices, faces)
}

/// A ring of square cross-section, not triangles: 4 `n` faces, Euler characteristic 0.
pub(crate) fn ring(n: usize) -> Mesh {
    let profile = [[2.0, -0.5], [3.0, -0.5], [3.0, 0.5], [2.0, 0.5]];
    let vertices = (0..4 * n)
        .map(|k| {
            let (s, c) = (TAU * (k / 4) as f64 / n as f64).sin_cos();
            let [r, z] = profile[k % 4];
            [r * c, r * s, z]
        })
        .collect();
    let at = |i: usize, k: usize| 4 * (i % n) + k % 4;
    let faces = (0..4 * n)
        .map(|f| (f / 4, f % 4))
        .map(|(i, k)| vec![at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)])
        .collect();
    (vertices, faces)
}

/// A rough ball of triangles: an octahedron split `splits` times, radii between 1 and `peak`.
pub(crate) fn rough_ball(r: &mut Random, splits: usize, peak: f64) -> Vec<[[f64; 3]; 3]> {
    let mut triangles = Vec::new();
    for signs in 0..8 {
        let sign = |bit: usize| if signs >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let corners = [[sign(0), 0.0, 0.0], [0.0, sign(1), 0.0], [0.0, 0.0, sign(2)]];
        let turned = sign(0) * sign(1) * sign(2) < 0.0;
        let [x, y, z] = corners.map(Vector::new);
        triangles.push(if turned { [x, z, y] } else { [x, y, z] });
    }
    for _ in 0..splits {
        triangles = triangles
            .into_iter()
            .flat_map(|[a, b, c]| {
                let [p, q, s] = [(a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5];
                [[a, p, s], [p, b, q], [s, q, c], [p, q, s]]
            })
            .collect();
    }
    // One radius per point: the same for all triangles that share it.
    let mut radii = std::collections::HashMap::new();
    let mut moved = |v: Vector<3>| {
        let key = v.to_array().map(|x| (x + 0.0).to_bits());
        let radius = *radii.entry(key).or_insert_with(|| r.between(1.0, peak));
        (v * (radius / v.norm())).to_array()
    };
    triangles.into_iter().map(|corners| corners.map(&mut moved)).collect()
}

/// The triangles between `n` meridians and as many steps from pole to pole of an ellipsoid: a
/// convex mesh of `2 n (n - 1)` triangles, with its vertices on the ellipsoid.
pub(crate) fn globe(n: usize, [a, b, c]: [f64; 3]) -> Vec<[[f64; 3]; 3]> {
    let at = |step: usize, meridian: usize| {
        let (sin, cos) = (TAU * (meridian % n) as f64 / n as f64).sin_cos();
        match step {
            0 => [0.0, 0.0, c],
            _ if step == n => [0.0, 0.0, -c],
            _ => {
                let (away, up) = (0.5 * TAU * step as f64 / n as f64).sin_cos();
                [a * away * cos, b * away * sin, c * up]
            }
        }
    };
    let between = |i: usize, j: usize| {
        let [p, q, r, s] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        let lower = (i + 1 < n).then_some([p, q, r]);
        lower.into_iter().chain((i > 0).then_some([p, r, s]))
    };
    (0..n * n).flat_map(|k| between(k / n, k % n)).collect()
}

/// The same faces over turned and shifted vertices.
pub(crate) fn turned((vertices, faces): &Mesh, pose: &spatial::Frame) -> Mesh {
    let moved = vertices.iter().map(|&v| pose.point_to_parent(v.into()).to_array());
    (moved.collect(), faces.clone())
}

pub(crate) fn solid((vertices, faces): &Mesh) -> Polyhedron {
    Polyhedron::new(vertices, faces).unwrap()
}
