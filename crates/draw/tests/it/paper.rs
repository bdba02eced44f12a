//! The grasp of the paper's Figures 1 and 2.

use clench_draw::{
    Color, Direction, Displaced, EnergyEllipsoids, EnergySpace, Finger, GraspPicture, Load, Mark,
    Region, Way,
};

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

/// Three points of the ellipsoid that the first-order stiffness of unit springs has about an
/// origin.
///
/// By hand: K11 is `[[1.7, 0.1], [0.1, 2.3]]`, twice the identity and a tenth of
/// `[[-3, 1], [1, 3]]`, whose eigenvectors are `(1, 3 +- sqrt(10))`; and `mu = 5614 / 65`.
pub(crate) fn points(space: EnergySpace, origin: [f64; 2]) -> [[f64; 3]; 3] {
    let (root, mu) = (10.0_f64.sqrt(), 5614.0_f64 / 65.0);
    let length = 1.0_f64.hypot(3.0 + root);
    let (x, y) = (1.0 / length, (3.0 + root) / length);
    let axes = [(2.0 - root / 10.0, [-y, x]), (2.0 + root / 10.0, [x, y])];
    // The velocity of the origin when the part turns about the center.
    let [u, v] = [CENTER[1] - origin[1], origin[0] - CENTER[0]];
    match space {
        EnergySpace::Twist => {
            let [a, b] = axes.map(|(sigma, axis)| axis.map(|e| (2.0 / sigma).sqrt() * e));
            [[a[0], a[1], 0.0], [b[0], b[1], 0.0], [u, v, 1.0].map(|e| (2.0 / mu).sqrt() * e)]
        }
        EnergySpace::Wrench => {
            let over = |[x, y]: [f64; 2]| [x, y, -u * x - v * y];
            let [a, b] = axes.map(|(sigma, axis)| over(axis.map(|e| (2.0 * sigma).sqrt() * e)));
            [a, b, [0.0, 0.0, (2.0 * mu).sqrt()]]
        }
    }
}

pub(crate) fn ellipsoids(space: EnergySpace) -> EnergyEllipsoids {
    EnergyEllipsoids::new(space, points(space, CENTER), points(space, [0.0, 0.0]))
}

/// The grasp with every field of a picture in use, in a unit of this length.
pub(crate) fn grasp(unit: f64) -> GraspPicture {
    let scaled = |point: [f64; 2]| point.map(|value| value * unit);
    let fingers = contacts().into_iter().enumerate();
    GraspPicture {
        title: Some("Four fingers".into()),
        outline: OUTLINE.map(scaled).to_vec(),
        holes: Vec::new(),
        corner_labels: ["A", "B", "C", "D"].map(String::from).to_vec(),
        fingers: fingers
            .map(|(i, (point, inward_normal))| Finger {
                point: scaled(point),
                inward_normal,
                // Pointed, small, large, and too large to show.
                radius: [0.0, 0.3, 0.9, 50.0][i] * unit,
                label: format!("{}", i + 1),
                preload: if i == 2 { String::new() } else { "2.5 N".into() },
                force: i as f64,
            })
            .collect(),
        center: Some(Mark { point: scaled(CENTER), label: "c".into() }),
        farthest_corner: Some(scaled(OUTLINE[1])),
        regions: vec![Region {
            corners: [[3.0, 1.0], [5.0, 1.0], [4.0, 4.0]].map(scaled).to_vec(),
            color: Color::GREEN,
        }],
        ways: vec![Way {
            points: [[2.0, 1.0], [8.0, 1.5], [8.0, 3.0]].map(scaled).to_vec(),
            color: Color::ORANGE,
        }],
        directions: vec![Direction { along: [0.6, 0.8], label: "σ_{min}".into() }],
        displaced: Some(Displaced {
            shifts: [[0.0, 0.01], [0.0, 0.03], [-0.01, 0.02], [-0.01, 0.01]].map(scaled).to_vec(),
            exaggeration: 20.0,
        }),
        loads: vec![Load { point: scaled([9.0, 4.0]), along: [-1.0, 0.0], label: "3 N".into() }],
        notes: vec![Mark { point: scaled([10.0, 1.0]), label: "note".into() }],
        caption: vec!["σ_{min} = 1.684".into(), "Q = 1.114".into()],
    }
}
