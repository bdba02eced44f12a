//! Solids to draw: a cube, a bracket, a prism, a plate with a hole, and meshes.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use clench_draw::{SolidAxis, SolidFace, SolidFinger, SolidMark, SolidPicture, SolidWorst};

type Point = [f64; 3];

fn difference(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn unit(along: Point) -> Point {
    let length = along.iter().map(|side| side * side).sum::<f64>().sqrt();
    along.map(|side| side / length)
}

/// The unit normal of three corners, counter-clockwise seen from where it points.
fn normal([a, b, c]: [Point; 3]) -> Point {
    let (u, v) = (difference(b, a), difference(c, a));
    unit([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]])
}

/// A face with one loop, whose corners all see the first.
pub(crate) fn face(ring: &[Point]) -> SolidFace {
    let triangles: Vec<_> = ring[1..].windows(2).map(|w| [ring[0], w[0], w[1]]).collect();
    SolidFace { outward_normal: normal(triangles[0]), loops: vec![ring.to_vec()], triangles }
}

/// What a counter-clockwise outline sweeps from z = 0 up; its corners all see the first.
pub(crate) fn prism(outline: &[[f64; 2]], height: f64) -> Vec<SolidFace> {
    let at = |z: f64| outline.iter().map(|[x, y]| [*x, *y, z]).collect::<Vec<Point>>();
    let (bottom, top) = (at(0.0), at(height));
    let mut below = bottom.clone();
    below[1..].reverse();
    let mut faces = vec![face(&top), face(&below)];
    for i in 0..outline.len() {
        let j = (i + 1) % outline.len();
        faces.push(face(&[bottom[i], bottom[j], top[j], top[i]]));
    }
    faces
}

/// The cube from 0 to 1.
pub(crate) fn cube() -> Vec<SolidFace> {
    prism(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], 1.0)
}

/// An L lying on its side, swept along y: 4 wide and high, 1 thick, 2 deep.
pub(crate) fn bracket() -> Vec<SolidFace> {
    // From the inner corner all are seen.
    let outline = [[1.0, 1.0], [1.0, 4.0], [0.0, 4.0], [0.0, 0.0], [4.0, 0.0], [4.0, 1.0]];
    let mut faces = prism(&outline, 2.0);
    // (x, y, z) to (x, -z, y): a turn about x.
    let turn = |[x, y, z]: Point| [x, -z, y];
    for face in &mut faces {
        face.outward_normal = turn(face.outward_normal);
        face.loops.iter_mut().flatten().for_each(|at| *at = turn(*at));
        face.triangles.as_flattened_mut().iter_mut().for_each(|at| *at = turn(*at));
    }
    faces
}

/// A regular polygon of radius 1.
pub(crate) fn ring(sides: u32) -> Vec<[f64; 2]> {
    let angle = |i: u32| TAU * f64::from(i) / f64::from(sides);
    (0..sides).map(|i| [angle(i).cos(), angle(i).sin()]).collect()
}

pub(crate) fn hexagon() -> Vec<SolidFace> {
    prism(&ring(6), 2.2)
}

/// A plate 4 by 3 by 0.8 with a round hole of radius 0.9 of as many sides, a multiple of 4.
pub(crate) fn plate(sides: u32) -> Vec<SolidFace> {
    let outer = [[2.0, 1.5], [-2.0, 1.5], [-2.0, -1.5], [2.0, -1.5]];
    let hole = |i: u32| {
        let angle = TAU * f64::from(i % sides) / f64::from(sides);
        [0.9 * angle.cos(), 0.9 * angle.sin()]
    };
    let mut triangles = Vec::new();
    for (quarter, corner) in (0..4_u32).zip(outer) {
        let next = outer[(quarter as usize + 1) % 4];
        let (from, to) = (quarter * sides / 4, (quarter + 1) * sides / 4);
        for i in from..to {
            triangles.push([hole(i), corner, hole(i + 1)]);
        }
        triangles.push([hole(to), corner, next]);
    }
    let at = |[x, y]: [f64; 2], z: f64| [x, y, z];
    let mut faces = Vec::new();
    for (z, up) in [(0.8, true), (0.0, false)] {
        let mut rings =
            vec![outer.map(|p| at(p, z)).to_vec(), (0..sides).map(|i| at(hole(i), z)).collect()];
        let mut covering: Vec<_> = triangles.iter().map(|t| t.map(|p| at(p, z))).collect();
        if up {
            rings[1].reverse();
        } else {
            rings[0].reverse();
            for triangle in &mut covering {
                triangle.reverse();
            }
        }
        let outward_normal = [0.0, 0.0, if up { 1.0 } else { -1.0 }];
        faces.push(SolidFace { outward_normal, loops: rings, triangles: covering });
    }
    for i in 0..4 {
        let (a, b) = (outer[i], outer[(i + 1) % 4]);
        faces.push(face(&[at(a, 0.0), at(b, 0.0), at(b, 0.8), at(a, 0.8)]));
    }
    for i in 0..sides {
        let (a, b) = (hole(i), hole(i + 1));
        faces.push(face(&[at(b, 0.0), at(a, 0.0), at(a, 0.8), at(b, 0.8)]));
    }
    faces
}

/// An icosahedron whose triangles are cut into four so many times, on the unit sphere.
pub(crate) fn sphere(times: u32) -> Vec<SolidFace> {
    let g = f64::midpoint(1.0, 5.0_f64.sqrt());
    let mut corners: Vec<Point> = Vec::new();
    for (a, b) in [(1.0, g), (-1.0, g), (1.0, -g), (-1.0, -g)] {
        corners.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    }
    let near = |a: Point, b: Point| difference(a, b).iter().map(|d| d * d).sum::<f64>() < 4.1;
    let mut triangles = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                let [a, b, c] = [corners[i], corners[j], corners[k]];
                if near(a, b) && near(b, c) && near(a, c) {
                    let out = normal([a, b, c]).iter().zip(a).map(|(n, x)| n * x).sum::<f64>();
                    triangles.push(if out > 0.0 { [a, b, c] } else { [a, c, b] }.map(unit));
                }
            }
        }
    }
    for _ in 0..times {
        let mut halves: BTreeMap<[u64; 3], Point> = BTreeMap::new();
        let mut half = |a: Point, b: Point| {
            let sum = [0, 1, 2].map(|i| a[i] + b[i]);
            *halves.entry(sum.map(|x| (x + 0.0).to_bits())).or_insert_with(|| unit(sum))
        };
        triangles = triangles
            .into_iter()
            .flat_map(|[a, b, c]| {
                let [x, y, z] = [half(a, b), half(b, c), half(c, a)];
                [[a, x, z], [x, b, y], [z, y, c], [x, y, z]]
            })
            .collect();
    }
    triangles.iter().map(|t| face(t)).collect()
}

/// A torus of radii 2 and 0.8 with as many places around and across, as triangles.
pub(crate) fn torus(around: u32, across: u32) -> Vec<SolidFace> {
    let at = |i: u32, j: u32| {
        let (u, v) = (i % around, j % across);
        let (u, v) =
            (TAU * f64::from(u) / f64::from(around), TAU * f64::from(v) / f64::from(across));
        let r = 2.0 + 0.8 * v.cos();
        [r * u.cos(), r * u.sin(), 0.8 * v.sin()]
    };
    let mut faces = Vec::new();
    for i in 0..around {
        for j in 0..across {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            faces.push(face(&[a, b, c]));
            faces.push(face(&[a, c, d]));
        }
    }
    faces
}

pub(crate) fn finger(label: &str, point: Point, inward: Point) -> SolidFinger {
    SolidFinger { point, inward_normal: unit(inward), label: label.into(), fixed: false }
}

pub(crate) fn held_cube() -> SolidPicture {
    let fingers = [
        ([0.5, 0.0, 0.3], [0.0, 1.0, 0.0]),
        ([0.25, 0.3, 0.0], [0.0, 0.0, 1.0]),
        ([0.8, 0.3, 0.0], [0.0, 0.0, 1.0]),
        ([0.5, 0.8, 0.0], [0.0, 0.0, 1.0]),
        ([0.0, 0.5, 0.5], [1.0, 0.0, 0.0]),
        ([1.0, 0.4, 0.6], [-1.0, 0.0, 0.0]),
        ([0.4, 0.6, 1.0], [0.0, 0.0, -1.0]),
        ([0.6, 1.0, 0.6], [0.0, -1.0, 0.0]),
    ];
    let fingers = fingers.into_iter().enumerate().take(7).map(|(i, (point, inward))| SolidFinger {
        fixed: (1..4).contains(&i),
        ..finger(&format!("{}", i + 1), point, inward)
    });
    SolidPicture {
        title: Some("A cube".into()),
        faces: cube(),
        fingers: fingers.collect(),
        center: Some(SolidMark { point: [0.5; 3], label: "c".into() }),
        caption: vec!["σ_{min} = 1.684".into(), "Q = 1.114".into()],
        ..SolidPicture::default()
    }
}

pub(crate) fn held_bracket() -> SolidPicture {
    let fingers = [
        ([1.0, -3.0 / 2.0, 2.5], [-1.0, 0.0, 0.0]),
        ([2.5, -1.0, 1.0], [0.0, 0.0, -1.0]),
        ([0.0, -0.5, 3.2], [1.0, 0.0, 0.0]),
        ([0.0, -1.5, 1.0], [1.0, 0.0, 0.0]),
        ([3.2, -1.0, 0.0], [0.0, 0.0, 1.0]),
        ([0.5, -2.0, 2.0], [0.0, 1.0, 0.0]),
        ([2.0, 0.0, 0.5], [0.0, -1.0, 0.0]),
    ];
    let fingers = fingers.into_iter().enumerate().map(|(i, (point, inward))| SolidFinger {
        fixed: (2..5).contains(&i),
        ..finger(&format!("{}", i + 1), point, inward)
    });
    let axis = |label: &str, direction, emphasized| SolidAxis {
        point: [1.2, -1.0, 1.3],
        direction,
        label: label.into(),
        emphasized,
    };
    SolidPicture {
        title: Some("An L-bracket".into()),
        faces: bracket(),
        fingers: fingers.collect(),
        axes: vec![
            axis("μ_{1}", [0.2, 1.0, 0.1], true),
            axis("μ_{2}", [1.0, -0.25, 0.5], false),
            axis("μ_{3}", [-0.5, 0.0, 1.0], false),
        ],
        center: Some(SolidMark { point: [1.2, -1.0, 1.3], label: "c".into() }),
        worst_point: Some(SolidWorst {
            point: [4.0, -2.0, 1.0],
            direction: [0.3, 0.1, 1.0],
            label: "worst".into(),
        }),
        caption: vec!["Q = 1.114 N/mm".into(), "Q_{pt} = 0.6 N/mm".into()],
        ..SolidPicture::default()
    }
}

/// A mesh with fingers at points, pressing towards the origin or the tube's middle.
pub(crate) fn held_sphere(times: u32) -> SolidPicture {
    let signs = [-1.0, 1.0];
    let corners = signs.map(|x| signs.map(|y| signs.map(|z| [x, y, z])));
    let points = corners.as_flattened().as_flattened().iter().map(|&c| unit(c));
    let fingers = points
        .enumerate()
        .map(|(i, point)| finger(&format!("{}", i + 1), point, point.map(|x| -x)));
    SolidPicture { faces: sphere(times), fingers: fingers.collect(), ..SolidPicture::default() }
}

pub(crate) fn held_torus() -> SolidPicture {
    let fingers = (0..7_i32).map(|i| {
        let (u, v) = (f64::from(i) * 0.9, f64::from(i) * 2.2);
        let way = [v.cos() * u.cos(), v.cos() * u.sin(), v.sin()];
        let point = [2.0 * u.cos() + 0.8 * way[0], 2.0 * u.sin() + 0.8 * way[1], 0.8 * way[2]];
        finger(&format!("{}", i + 1), point, way.map(|x| -x))
    });
    SolidPicture { faces: torus(50, 20), fingers: fingers.collect(), ..SolidPicture::default() }
}

/// The same picture in a unit of this length.
pub(crate) fn scaled(picture: &SolidPicture, unit: f64) -> SolidPicture {
    let mut picture = picture.clone();
    let scale = |at: &mut Point| *at = at.map(|value| value * unit);
    for face in &mut picture.faces {
        face.loops.iter_mut().flatten().for_each(scale);
        face.triangles.as_flattened_mut().iter_mut().for_each(scale);
    }
    picture.fingers.iter_mut().map(|finger| &mut finger.point).for_each(scale);
    picture.axes.iter_mut().map(|axis| &mut axis.point).for_each(scale);
    picture.center.iter_mut().map(|center| &mut center.point).for_each(scale);
    picture.worst_point.iter_mut().map(|worst| &mut worst.point).for_each(scale);
    picture
}
