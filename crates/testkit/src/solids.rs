//! Solids as plain numbers.

use std::f64::consts::TAU;

use crate::Random;

/// Vertices, and faces as lists of them, counter-clockwise seen from outside.
pub type Mesh = (Vec<[f64; 3]>, Vec<Vec<usize>>);

/// The box with these half-widths about the origin.
#[must_use]
pub fn cuboid([a, b, c]: [f64; 3]) -> Mesh {
    prism(&[[-a, -b], [a, -b], [a, b], [-a, b]], c)
}

/// A prism over a counter-clockwise outline, from `z = -h` to `h`.
#[must_use]
pub fn prism(outline: &[[f64; 2]], h: f64) -> Mesh {
    let n = outline.len();
    let level = |z: f64| outline.iter().map(move |&[x, y]| [x, y, z]);
    let mut faces = vec![(0..n).rev().collect::<Vec<_>>(), (n..2 * n).collect()];
    faces.extend((0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]));
    (level(-h).chain(level(h)).collect(), faces)
}

/// An L from `z = -1` to 1, its foot along x with a square hole along y: 12 sides, of which those
/// with the hole are two faces each.
#[must_use]
pub fn bracket() -> Mesh {
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
#[must_use]
pub fn ring(n: usize) -> Mesh {
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
#[must_use]
pub fn rough_ball(r: &mut Random, splits: usize, peak: f64) -> Vec<[[f64; 3]; 3]> {
    let mut triangles = Vec::new();
    for signs in 0..8 {
        let sign = |bit: usize| if signs >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let corners = [[sign(0), 0.0, 0.0], [0.0, sign(1), 0.0], [0.0, 0.0, sign(2)]];
        let turned = sign(0) * sign(1) * sign(2) < 0.0;
        let [x, y, z] = corners;
        triangles.push(if turned { [x, z, y] } else { [x, y, z] });
    }
    for _ in 0..splits {
        triangles = triangles
            .into_iter()
            .flat_map(|[a, b, c]| {
                let [p, q, s] = [middle(a, b), middle(b, c), middle(c, a)];
                [[a, p, s], [p, b, q], [s, q, c], [p, q, s]]
            })
            .collect();
    }
    // One radius per point: the same for all triangles that share it.
    let mut radii = std::collections::HashMap::new();
    let mut moved = |v: [f64; 3]| {
        let key = v.map(|x| (x + 0.0).to_bits());
        let radius = *radii.entry(key).or_insert_with(|| r.between(1.0, peak));
        v.map(|x| x * (radius / dot(v, v).sqrt()))
    };
    triangles.into_iter().map(|corners| corners.map(&mut moved)).collect()
}

/// The triangles between `n` meridians and as many steps from pole to pole of an ellipsoid: a
/// convex mesh of `2 n (n - 1)` triangles, with its vertices on the ellipsoid.
#[must_use]
pub fn globe(n: usize, [a, b, c]: [f64; 3]) -> Vec<[[f64; 3]; 3]> {
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

/// The tetrahedron in a cube of half-width 1.
#[must_use]
pub fn tetrahedron() -> Mesh {
    let vertices = vec![[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    (vertices, vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]])
}

/// Half of a 4 x 3 x 2 box, cut along its slope.
#[must_use]
pub fn wedge() -> Mesh {
    let (x, y, z) = (4.0, 3.0, 2.0);
    let base = [[0.0, 0.0, 0.0], [x, 0.0, 0.0], [x, y, 0.0], [0.0, y, 0.0]];
    let vertices = base.into_iter().chain([[0.0, 0.0, z], [0.0, y, z]]).collect();
    let faces = [&[0, 3, 2, 1][..], &[0, 4, 5, 3], &[1, 2, 5, 4], &[0, 1, 4], &[3, 5, 2]];
    (vertices, faces.map(<[usize]>::to_vec).into())
}

/// An L of thickness 2: arms of 4 and 3, of width 1.
#[must_use]
pub fn angle() -> Mesh {
    prism(&[[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]], 1.0)
}

/// A regular prism of height 2 and radius 1.
#[must_use]
pub fn regular_prism(sides: usize) -> Mesh {
    let corner = |i: usize| {
        let (sine, cosine) = (TAU * i as f64 / sides as f64).sin_cos();
        [cosine, sine]
    };
    prism(&(0..sides).map(corner).collect::<Vec<_>>(), 1.0)
}

/// A convex solid between `planes` random planes, about 1 from the origin; its faces are cut into
/// triangles, since their corners are in one plane to rounding only.
#[must_use]
pub fn between_planes(r: &mut Random, planes: usize) -> Mesh {
    loop {
        let (vertices, faces) = enclosed(r, planes);
        // Euler's formula for triangles: random planes need not enclose anything.
        if faces.len() + 4 == 2 * vertices.len() {
            return (vertices, faces);
        }
    }
}

/// What some random planes have in common, cut into triangles; open where they enclose nothing.
fn enclosed(r: &mut Random, planes: usize) -> Mesh {
    let normal = |r: &mut Random| loop {
        let v: [f64; 3] = r.array(1.0);
        let size = dot(v, v).sqrt();
        if (0.1..1.0).contains(&size) {
            return v.map(|x| x / size);
        }
    };
    let all: Vec<_> = (0..planes).map(|_| (normal(r), r.between(0.85, 1.15))).collect();
    let mut corners: Vec<([f64; 3], [usize; 3])> = Vec::new();
    for i in 0..planes {
        for j in 0..i {
            for k in 0..j {
                let of = [i, j, k].map(|p| all[p]);
                let Some(x) = meeting(of) else { continue };
                let within = |p: usize| [i, j, k].contains(&p) || dot(all[p].0, x) < all[p].1;
                if (0..planes).all(within) {
                    corners.push((x, [i, j, k]));
                }
            }
        }
    }
    let mut faces = Vec::new();
    for (plane, &(normal, _)) in all.iter().enumerate() {
        let mut on: Vec<usize> =
            (0..corners.len()).filter(|&c| corners[c].1.contains(&plane)).collect();
        let Some(&first) = on.first() else { continue };
        let start = corners[first].0;
        // By angle about a corner of the convex face.
        let across = |c: usize| {
            let offset = minus(corners[c].0, start);
            let size = dot(offset, offset).sqrt();
            offset.map(|x| x / size.max(f64::MIN_POSITIVE))
        };
        on.remove(0);
        on.sort_by(|&a, &b| {
            let turn = dot(normal, cross(across(a), across(b)));
            0.0_f64.total_cmp(&turn)
        });
        faces.extend(on.windows(2).map(|pair| vec![first, pair[0], pair[1]]));
    }
    (corners.into_iter().map(|(x, _)| x).collect(), faces)
}

/// Three planes whose normals span less than this volume meet nowhere near.
const PARALLEL: f64 = 1e-9;

/// Where three planes meet.
fn meeting([(a, d), (b, e), (c, f)]: [([f64; 3], f64); 3]) -> Option<[f64; 3]> {
    let volume = dot(a, cross(b, c));
    let [bc, ca, ab] = [cross(b, c), cross(c, a), cross(a, b)];
    let at = |i: usize| (d * bc[i] + e * ca[i] + f * ab[i]) / volume;
    (volume.abs() > PARALLEL).then(|| [at(0), at(1), at(2)])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn middle(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])]
}
