//! The grasp of the paper's Figures 1 and 2.

use clench_draw::{Color, EnergyEllipsoids, EnergySpace, Finger, GraspPicture, Mark, Region};
use clench_screw::Cholesky;

pub(crate) const OUTLINE: [[f64; 2]; 4] = [[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]];
pub(crate) const CENTER: [f64; 2] = [80.0 / 13.0, 72.0 / 13.0];

/// Contacts and inward normals: on AB at A and at B, on BC at C, on DA at D.
pub(crate) fn contacts() -> [([f64; 2], [f64; 2]); 4] {
    let (s5, s10) = (5.0_f64.sqrt(), 10.0_f64.sqrt());
    [
        (OUTLINE[0], [0.0, 1.0]),
        (OUTLINE[1], [0.0, 1.0]),
        (OUTLINE[2], [-2.0 / s5, -1.0 / s5]),
        (OUTLINE[3], [3.0 / s10, -1.0 / s10]),
    ]
}

/// The first-order stiffness of unit springs about an origin.
pub(crate) fn stiffness(origin: [f64; 2]) -> [[f64; 3]; 3] {
    let mut sum = [[0.0; 3]; 3];
    for (point, [x, y]) in contacts() {
        let row = [x, y, (point[0] - origin[0]) * y - (point[1] - origin[1]) * x];
        for i in 0..3 {
            for j in 0..3 {
                sum[i][j] += row[i] * row[j];
            }
        }
    }
    sum
}

fn inverse(matrix: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    *Cholesky::new(&matrix.into()).expect("four springs hold the part").inverse().rows()
}

pub(crate) fn ellipsoids(space: EnergySpace) -> EnergyEllipsoids {
    let (upright, slanted) = (stiffness(CENTER), stiffness([0.0, 0.0]));
    match space {
        EnergySpace::Twist => EnergyEllipsoids::new(space, upright, slanted),
        EnergySpace::Wrench => EnergyEllipsoids::new(space, inverse(upright), inverse(slanted)),
    }
}

/// The grasp with every field of a picture in use, in a unit of this length.
pub(crate) fn grasp(unit: f64) -> GraspPicture {
    let scaled = |point: [f64; 2]| point.map(|value| value * unit);
    let fingers = contacts().into_iter().enumerate();
    GraspPicture {
        title: Some("Four fingers".into()),
        outline: OUTLINE.map(scaled).to_vec(),
        corner_labels: ["A", "B", "C", "D"].map(String::from).to_vec(),
        fingers: fingers
            .map(|(i, (point, inward_normal))| Finger {
                point: scaled(point),
                inward_normal,
                // Pointed, small, large, and too large to show.
                radius: [0.0, 0.3, 0.9, 50.0][i] * unit,
                label: format!("{}", i + 1),
                preload: if i == 2 { String::new() } else { "2.5 N".into() },
            })
            .collect(),
        center: Some(Mark { point: scaled(CENTER), label: "c".into() }),
        farthest_corner: Some(scaled(OUTLINE[1])),
        regions: vec![Region {
            corners: [[3.0, 1.0], [5.0, 1.0], [4.0, 4.0]].map(scaled).to_vec(),
            color: Color::GREEN,
        }],
        notes: vec![Mark { point: scaled([10.0, 1.0]), label: "note".into() }],
        caption: vec!["σ_{min} = 1.684".into(), "Q = 1.114".into()],
    }
}
