//! Draws sample pictures into the folder named on the command line.

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use clench_draw::{
    Circle, Color, EnergyEllipsoids, EnergySpace, Figure, Finger, GraspPicture, Layout, Mark,
    Region,
};

const QUADRILATERAL: [[f64; 2]; 4] = [[0.0, 0.0], [13.0, 0.0], [9.0, 8.0], [2.0, 6.0]];

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args().nth(1).ok_or("usage: samples FOLDER")?;
    let folder = Path::new(&folder);
    fs::create_dir_all(folder)?;
    let (origin, center) = (stiffness([0.0, 0.0]), stiffness([80.0 / 13.0, 72.0 / 13.0]));
    for (name, layout) in [("overlaid", Layout::Overlaid), ("side", Layout::SideBySide)] {
        let twist = EnergyEllipsoids {
            title: Some("Elastic energy ellipsoid of displacements".into()),
            layout,
            ..EnergyEllipsoids::new(EnergySpace::Twist, center, origin)
        };
        save(folder, &format!("figure-1-{name}"), &twist.figure()?)?;
        let wrench = EnergyEllipsoids {
            title: Some("Elastic energy ellipsoid of wrenches".into()),
            layout,
            ..EnergyEllipsoids::new(EnergySpace::Wrench, inverse(center), inverse(origin))
        };
        save(folder, &format!("figure-2-{name}"), &wrench.figure()?)?;
    }
    save(folder, "grasp-corners", &corners().figure()?)?;
    save(folder, "grasp-discs", &discs().figure()?)?;
    save(folder, "grasp-strips", &strips().figure()?)?;
    save(folder, "grasp-wide", &wide().figure()?)?;
    Ok(())
}

#[cfg(feature = "png")]
fn save(folder: &Path, name: &str, figure: &Figure) -> Result<(), Box<dyn Error>> {
    fs::write(folder.join(name).with_extension("png"), figure.to_png(2.0)?)?;
    fs::write(folder.join(name).with_extension("svg"), figure.to_svg())?;
    Ok(())
}

#[cfg(not(feature = "png"))]
fn save(folder: &Path, name: &str, figure: &Figure) -> Result<(), Box<dyn Error>> {
    fs::write(folder.join(name).with_extension("svg"), figure.to_svg())?;
    Ok(())
}

/// Contacts and inward normals of the paper's Figure 1.
fn contacts() -> [([f64; 2], [f64; 2]); 4] {
    let (s5, s10) = (5.0_f64.sqrt(), 10.0_f64.sqrt());
    [
        ([0.0, 0.0], [0.0, 1.0]),
        ([13.0, 0.0], [0.0, 1.0]),
        ([9.0, 8.0], [-2.0 / s5, -1.0 / s5]),
        ([2.0, 6.0], [3.0 / s10, -1.0 / s10]),
    ]
}

fn stiffness(origin: [f64; 2]) -> [[f64; 3]; 3] {
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

fn inverse(m: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let minor = |i: usize, j: usize| {
        let (a, b, c, d) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let det: f64 = (0..3).map(|j| m[0][j] * minor(0, j)).sum();
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| minor(j, i) / det))
}

fn corner_labels() -> Vec<String> {
    ["A", "B", "C", "D"].map(String::from).to_vec()
}

fn finger(label: &str, point: [f64; 2], inward_normal: [f64; 2], radius: f64) -> Finger {
    Finger { point, inward_normal, radius, label: label.into(), preload: String::new() }
}

fn corners() -> GraspPicture {
    let fingers = contacts().into_iter().enumerate();
    GraspPicture {
        title: Some("Four fingers on a quadrilateral".into()),
        outline: QUADRILATERAL.to_vec(),
        corner_labels: corner_labels(),
        fingers: fingers.map(|(i, (p, n))| finger(&(i + 1).to_string(), p, n, 0.0)).collect(),
        center: Some(Mark { point: [80.0 / 13.0, 72.0 / 13.0], label: "c".into() }),
        farthest_vertex: Some([13.0, 0.0]),
        caption: [
            "σ_{min} = 1.684",
            "μ = 86.4",
            "ρ_{max} = 8.81",
            "μ_{eq} = μ/ρ_{max}^{2} = 1.114",
            "Q = 1.114",
        ]
        .map(String::from)
        .to_vec(),
        ..GraspPicture::default()
    }
}

fn discs() -> GraspPicture {
    let (s5, s10, s53) = (5.0_f64.sqrt(), 10.0_f64.sqrt(), 53.0_f64.sqrt());
    let mut fingers = vec![
        finger("1", [3.0, 0.0], [0.0, 1.0], 0.9),
        finger("2", [11.0, 4.0], [-2.0 / s5, -1.0 / s5], 0.9),
        finger("3", [5.5, 7.0], [2.0 / s53, -7.0 / s53], 0.4),
        finger("4", [1.0, 3.0], [3.0 / s10, -1.0 / s10], 40.0),
    ];
    fingers[2].preload = "2.5 N".into();
    fingers[3].preload = "1.2 N".into();
    GraspPicture {
        outline: QUADRILATERAL.to_vec(),
        holes: vec![vec![[7.0, 2.0], [8.5, 2.0], [8.5, 3.2], [7.0, 3.2]]],
        corner_labels: corner_labels(),
        fingers,
        center: Some(Mark { point: [5.0, 3.6], label: "c".into() }),
        farthest_vertex: Some([13.0, 0.0]),
        enclosing_circle: Some(Circle { center: [6.5, 1.75], radius: 6.7315 }),
        caption: ["Q = 1.684 N/mm", "limited by translation"].map(String::from).to_vec(),
        ..GraspPicture::default()
    }
}

/// Three edges of the quadrilateral, the strips across them, and where the strips meet.
fn strips() -> GraspPicture {
    let colors = [Color::BLUE, Color::ORANGE, Color::GREEN];
    let strip = |(edge, color): (usize, Color)| {
        let (a, b) = (QUADRILATERAL[edge], QUADRILATERAL[edge + 1]);
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let across = [-(b[1] - a[1]) / length * 11.0, (b[0] - a[0]) / length * 11.0];
        let far = |p: [f64; 2]| [p[0] + across[0], p[1] + across[1]];
        Region { corners: vec![a, b, far(b), far(a)], color }
    };
    let (s5, s53) = (5.0_f64.sqrt(), 53.0_f64.sqrt());
    GraspPicture {
        title: Some("Strips of three edges".into()),
        outline: QUADRILATERAL.to_vec(),
        corner_labels: corner_labels(),
        regions: (0..3).zip(colors).map(strip).collect(),
        fingers: vec![
            finger("1", [6.5, 0.0], [0.0, 1.0], 0.0),
            finger("2", [11.1, 3.8], [-2.0 / s5, -1.0 / s5], 0.0),
            finger("3", [6.0, 50.0 / 7.0], [2.0 / s53, -7.0 / s53], 0.0),
        ],
        notes: vec![Mark { point: [5.2, 3.0], label: "S".into() }],
        ..GraspPicture::default()
    }
}

fn wide() -> GraspPicture {
    GraspPicture {
        title: Some("A long bar <&>".into()),
        outline: vec![[0.0, 0.0], [0.4, 0.0], [0.4, 0.05], [0.0, 0.05]],
        corner_labels: corner_labels(),
        fingers: vec![
            finger("1", [0.05, 0.0], [0.0, 1.0], 0.0),
            finger("2", [0.35, 0.0], [0.0, 1.0], 0.0),
            finger("3", [0.2, 0.05], [0.0, -1.0], 0.0),
            finger("4", [0.0, 0.025], [1.0, 0.0], 0.01),
        ],
        center: Some(Mark { point: [0.2, 0.025], label: "centre of compliance".into() }),
        caption: ["worst motion: turns about (200, 25) mm", "Q = 3.1·10^{5} N/m"]
            .map(String::from)
            .to_vec(),
        ..GraspPicture::default()
    }
}
