//! The numbers of a grasp that holds the part: by hand, and against its stiffness.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use clench_testkit::cases::{Value, list, number, numbers};
use clench_testkit::{assert_all_close, assert_close};

use crate::fingers::CUBE;
use crate::run::{Folder, Ran, assert_says, command, figure_1};

/// A few hundred roundings.
const ROUNDING: f64 = 1e-13;

/// A cube of side 2 with two springs of 3 on each face, 1/2 off its middle in turns along y, z and
/// x: it is held alike about all axes, by 4 * 3 along each and 4 * 3 / 4 about each.
pub(crate) fn symmetric_cube(preload: f64) -> String {
    let points = [
        "[1, 0.5, 0]",
        "[1, 1.5, 0]",
        "[1, 0.5, 2]",
        "[1, 1.5, 2]",
        "[0, 1, 0.5]",
        "[0, 1, 1.5]",
        "[2, 1, 0.5]",
        "[2, 1, 1.5]",
        "[0.5, 0, 1]",
        "[1.5, 0, 1]",
        "[0.5, 2, 1]",
        "[1.5, 2, 1]",
    ];
    let contacts =
        points.map(|point| format!("[[contacts]]\npoint = {point}\npreload = {preload}\n"));
    format!("{CUBE}stiffness = 3\n{}", contacts.concat())
}

/// The report on an example of the repository, in that frame.
fn example(name: &str, frame: &str) -> Value {
    let output = command(["analyze", name, "--format", "json", "--frame", frame])
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../../parts"))
        .output();
    let ran = output.map(|output| Ran::new(&output)).unwrap();
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{name}");
    ran.json()
}

/// A vector of space, from one of the plane or of space.
fn in_space(value: &Value) -> [f64; 3] {
    let found = numbers(value);
    [0, 1, 2].map(|i| found.get(i).copied().unwrap_or(0.0))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

/// The six numbers along the axis of `principal`, with its moment about the origin; the three of
/// the plane for a planar part.
fn screw(principal: &Value, line_first: bool, size: usize) -> Vec<f64> {
    let [direction, point] = ["direction", "axis_point"].map(|key| in_space(&principal[key]));
    let (pitch, arm) = (number(&principal["pitch"]), cross(point, direction));
    let moment = [0, 1, 2].map(|i| arm[i] + pitch * direction[i]);
    let six = if line_first { [direction, moment] } else { [moment, direction] }.concat();
    if size == 3 { vec![six[0], six[1], six[5]] } else { six }
}

type Rows = Vec<Vec<f64>>;

fn rows(value: &Value) -> Rows {
    list(value).iter().map(numbers).collect()
}

fn column(rows: &Rows, j: usize) -> impl Iterator<Item = f64> {
    rows.iter().map(move |row| row[j])
}

fn times(matrix: &Rows, vector: &[f64]) -> Vec<f64> {
    let dot = |row: &Vec<f64>| row.iter().zip(vector).map(|(a, b)| a * b).sum();
    matrix.iter().map(dot).collect()
}

/// What follows from a stiffness follows from that of the report, in each frame.
#[test]
fn matrices_and_axes_belong_to_the_stiffness_of_the_report() {
    for (name, frame) in [
        ("quadrilateral-grasp.toml", "0,0,0"),
        ("quadrilateral-grasp.toml", "6.5,-1.75,0.8"),
        ("cube-grasp.toml", "0,0,0,0,0,0"),
        ("cube-grasp.toml", "20,-10,35,0.3,-0.9,1.2"),
        ("ellipsoid-grasp.toml", "5,4,-3,1,0.5,-0.2"),
    ] {
        let report = example(name, frame);
        let stiffness = rows(&report["stiffness"]);
        let scale = stiffness.iter().flatten().fold(0.0, |m: f64, v| m.max(v.abs()));
        let near = |found: &[f64], wanted: &[f64], what: &str| {
            for (found, wanted) in found.iter().zip(wanted) {
                assert_close(*found, *wanted, ROUNDING, scale, format!("{name} {frame}: {what}"));
            }
        };
        check_matrices(&report, &stiffness, near);
        check_axes(&report, &stiffness, near);
    }
}

/// `K [P_1; I] = [0; K_V]` and `K_11 C_W = I`.
fn check_matrices(report: &Value, stiffness: &Rows, near: impl Fn(&[f64], &[f64], &str)) {
    let [map, restricted, compliance] =
        ["twist_map", "restricted_stiffness", "translational_compliance"]
            .map(|key| rows(&report[key]));
    let (n, m) = (map.len(), restricted.len());
    let unit = |count: usize, j: usize| (0..count).map(move |i| f64::from(u8::from(i == j)));
    for j in 0..m {
        let twist: Vec<f64> = column(&map, j).chain(unit(m, j)).collect();
        let wrench: Vec<f64> = vec![0.0; n].into_iter().chain(column(&restricted, j)).collect();
        near(&times(stiffness, &twist), &wrench, "P_1 and K_V");
    }
    for j in 0..n {
        let slide: Vec<f64> = column(&compliance, j).chain(vec![0.0; m]).collect();
        let force = &times(stiffness, &slide)[..n];
        assert_all_close(force, &unit(n, j).collect::<Vec<_>>(), ROUNDING, "C_W");
    }
}

/// A couple turns the part about each axis of the one kind, a wrench along each of the other one
/// moves it and does not turn it.
fn check_axes(report: &Value, stiffness: &Rows, near: impl Fn(&[f64], &[f64], &str)) {
    let (size, n) = (stiffness.len(), list(&report["translational"]).len());
    let scaled = |vector: &[f64], principal: &Value| -> Vec<f64> {
        vector.iter().map(|v| v * number(&principal["value"])).collect()
    };
    for principal in list(&report["rotational"]) {
        let twist = screw(principal, false, size);
        let mut couple = scaled(&twist, principal);
        couple[..n].fill(0.0);
        near(&times(stiffness, &twist), &couple, "twist-compliant axis");
    }
    for principal in list(&report["translational"]) {
        let wrench = screw(principal, true, size);
        let mut slide = wrench.clone();
        slide[n..].fill(0.0);
        let wrench = scaled(&wrench, principal);
        near(&times(stiffness, &slide), &wrench, "wrench-compliant axis");
    }
}

#[test]
fn centers_are_points_of_the_frame() {
    // A half turn about the x axis through (20, -10, 35).
    let frame = format!("20,-10,35,{},0,0", std::f64::consts::PI);
    let frames = ["0,0,0,0,0,0", &frame];
    let [here, there] = frames.map(|frame| example("cube-grasp.toml", frame));
    for key in ["center", "loncaric_center_of_stiffness", "loncaric_center_of_compliance"] {
        let [x, y, z] = in_space(&here[key]);
        let moved = [x - 20.0, -y - 10.0, 35.0 - z];
        assert_all_close(&numbers(&there[key]), &moved, ROUNDING, key);
    }
    let s = numbers(&here["pitch_tensor"]);
    let turned = [s[0], -s[1], -s[2], -s[3], s[4], s[5], -s[6], s[7], s[8]];
    assert_all_close(&numbers(&there["pitch_tensor"]), &turned, ROUNDING, "pitch tensor");
    for report in [&here, &there] {
        assert_eq!(report["true_center_exists"], false);
        assert_eq!(report.get("center_of_compliance"), None);
        assert_eq!(report.get("reach"), None);
    }
    let key = "center_of_compliance_in_file_frame";
    assert_eq!(example("quadrilateral-grasp.toml", "0,0,0").get(key), None);
    let report = example("quadrilateral-grasp.toml", "1,2,3");
    assert_all_close(&numbers(&report[key]), &[80.0 / 13.0, 72.0 / 13.0], ROUNDING, key);
    for key in ["center", "true_center_exists", "pitch_tensor"] {
        assert_eq!(report.get(key), None, "{key}");
    }
}

#[test]
fn energy_ellipsoids_have_the_semi_axes_of_unit_energy() {
    let examples = [("quadrilateral-grasp.toml", "0,0,0"), ("cube-grasp.toml", "0,0,0,0,0,0")];
    for (name, frame) in examples {
        let report = example(name, frame);
        let ellipsoids = &report["energy_ellipsoids"];
        for (kind, part, of, semi_axis) in [
            ("displacement", "section", "translational", (|v| (2.0 / v).sqrt()) as fn(f64) -> f64),
            ("displacement", "projection", "rotational", |v| (2.0 / v).sqrt()),
            ("wrench", "section", "rotational", |v| (2.0 * v).sqrt()),
            ("wrench", "projection", "translational", |v| (2.0 * v).sqrt()),
        ] {
            let values = list(&report[of]).iter().map(|p| semi_axis(number(&p["value"])));
            let found = numbers(&ellipsoids[kind][part]);
            assert_all_close(&found, &values.collect::<Vec<_>>(), ROUNDING, kind);
        }
    }
}

/// Any axis is principal; about one across a diagonal of the cube two corners are sqrt(3) away.
#[test]
fn a_cube_held_alike_from_all_sides_is_degenerate() {
    let folder = Folder::new("measures-degenerate");
    folder.write("cube.toml", symmetric_cube(0.0));
    let report = folder.json("analyze cube.toml --frame 1,1,1,0.3,0.2,-0.4");
    assert_eq!((&report["degenerate"], &report["limited_by"]), (&true.into(), &"rotation".into()));
    for (key, wanted) in [
        ("sigma_min", 12.0),
        ("mu_eq", 1.0),
        ("quality", 1.0),
        ("quality_rotational", 1.0),
        ("worst_point_stiffness", (1.0 / 12.0 + 3.0 / 3.0_f64).recip()),
    ] {
        assert_close(number(&report[key]), wanted, ROUNDING, wanted, key);
    }
    let softest = in_space(&report["rotational"][0]["softest_direction"]);
    for rotation in list(&report["rotational"]) {
        assert_eq!(rotation["softest_direction"], report["rotational"][0]["softest_direction"]);
        let corner = in_space(&rotation["farthest_point"]);
        let across: f64 = softest.iter().zip(corner).map(|(a, b)| a * b).sum();
        assert_close(across, 0.0, ROUNDING, 1.0, "across the diagonal");
        for (key, wanted) in
            [("reach", 3.0_f64.sqrt()), ("deflection", 3.0_f64.sqrt()), ("equivalent", 1.0)]
        {
            assert_close(number(&rotation[key]), wanted, ROUNDING, wanted, key);
        }
    }
    assert_eq!(report["true_center_exists"], true);
    assert_eq!(report["center"], report["center_of_compliance"]);
    assert_close(in_space(&report["center"])[0], 0.0, ROUNDING, 1.0, "center");
    let text = folder.run("analyze cube.toml").out;
    assert_says(
        &text,
        &[
            "quality   Q = 1 F/L, limited by rotation",
            "center of compliance  (1, 1, 1) L",
            "repeated: translational stiffnesses are equal, and any direction between theirs",
            "degenerate: rotational stiffnesses are repeated, and the same about any axis between",
        ],
    );
    assert!(!text.contains("Loncaric"), "{text}");
    for key in ["translational", "rotational"] {
        assert!(list(&report[key]).iter().all(|principal| principal["repeated"] == true), "{key}");
    }
}

/// In the example the fingers along y are those along z.
#[test]
fn stiffnesses_that_are_repeated_are_marked() {
    let report = example("cube-grasp.toml", "0,0,0,0,0,0");
    let repeated = |key: &str| -> Vec<bool> {
        let principals = list(&report[key]).iter();
        principals.map(|principal| principal.get("repeated") == Some(&true.into())).collect()
    };
    assert_eq!(repeated("translational"), [true, true, false]);
    assert_eq!(repeated("rotational"), [false; 3]);
}

/// Their values are wider than the column of the numbers above.
#[test]
fn centers_of_space_stand_in_one_column_with_their_meanings() {
    let output = command(["analyze", "cube-grasp.toml"])
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../../parts"))
        .output();
    let text = output.map(|output| Ran::new(&output)).unwrap().out;
    let column = |label: &str, meaning: &str| {
        let line = text.lines().find(|line| line.starts_with(label));
        line.and_then(|line| line.find(meaning))
    };
    let columns = [
        column("canonical point ", "where force and rotation couple symmetrically"),
        column("Loncaric stiffness ", "where the coupling of K is symmetric"),
        column("Loncaric compliance ", "where the coupling of the inverse of K is symmetric"),
        column("sigma_min ", "least translational stiffness"),
        column("stability ", "stable to first order"),
    ];
    assert!(columns[0].is_some() && columns.iter().all(|c| *c == columns[0]), "{columns:?}");
}

/// See the file: 2 f (b^2 - c^2) (1 / c - 1 / b) about the longest axis, and the end of the middle
/// one moves most.
#[test]
fn smooth_parts_have_a_quality_and_no_corners() {
    let report = example("ellipsoid-grasp.toml", "0,0,0,0,0,0");
    let mu = 2.0 * 40.0 * (400.0 - 225.0) * (1.0 / 15.0 - 1.0 / 20.0);
    assert_close(number(&report["quality"]), mu / 400.0, ROUNDING, 1.0, "Q");
    let rotation = &report["rotational"][0];
    let farthest = in_space(&rotation["farthest_point"]);
    assert_all_close(&farthest.map(f64::abs), &[0.0, 20.0, 0.0], ROUNDING, "farthest");
    assert_eq!((rotation.get("farthest_corner"), report.get("worst_corner")), (None, None));
    assert_eq!(rotation.get("softest_direction"), None);
    for key in ["quality_rotational_at_least", "worst_point_stiffness_at_least"] {
        assert_eq!(report.get(key), None, "{key}");
    }

    let folder = Folder::new("measures-ellipse");
    let contacts = ["[5, 0]", "[-3, 0]", "[1, 2]", "[1, -2]"].map(|point| {
        format!("[[contacts]]\npoint = {point}\npreload = 0.1\nfinger = {{ curvature = 0 }}\n")
    });
    let part = "[part.planar]\nellipse = [4, 2]\ncenter = [1, 0]\nstiffness = 50\n";
    let load = "[[load_cases]]\nforce = [0, 1]\n";
    folder.write("grasp.toml", format!("{part}{}{load}", contacts.concat()));
    let report = folder.json("analyze grasp.toml --order second");
    let reach = &report["reach"];
    assert_close(number(&reach["distance"]), 4.0, ROUNDING, 4.0, "reach");
    assert_eq!((reach.get("corner"), report.get("worst_corner")), (None, None));
    assert_eq!(report["load_cases"][0]["largest"].get("corner"), None);
    let mu = number(&report["rotational"][0]["value"]);
    assert_close(number(&report["mu_eq"]), mu / 16.0, ROUNDING, 1.0, "mu_eq");
    assert_eq!(report["quality"], report["mu_eq"]);
    let text = folder.run("analyze grasp.toml").out;
    assert_says(&text, &["Q_pt", "force per deflection: at (", "the largest  ("]);
}

/// On what is nearly a ball so many directions tie that the search ends before its proof. Flat jaws
/// with the preload `f_i` at the ends of the semi-axes resist rotations about the first one by
/// `2 (b^2 - c^2) (f_c / c - f_b / b)`: as much as about the last one, so that Q is searched for
/// too.
#[test]
fn what_a_search_could_not_prove_is_said() {
    let [a, b, c] = [100.0, 99.99, 99.98].map(f64::sqrt);
    let jaw = |point: [f64; 3], along: &str, preload: f64| {
        let finger = format!("finger = {{ curvatures = [0, 0], direction = {along} }}");
        format!("[[contacts]]\npoint = {point:?}\npreload = {preload}\n{finger}\n")
    };
    let jaws = [1.0, -1.0].map(|side| {
        let first = jaw([side * a, 0.0, 0.0], "[0, 1, 0]", 1e3 * a);
        let second = jaw([0.0, side * b, 0.0], "[1, 0, 0]", 2e3 * b);
        first + &second + &jaw([0.0, 0.0, side * c], "[1, 0, 0]", 3e3 * c)
    });
    let part = format!("[part.spatial]\nellipsoid = [{a}, {b}, {c}]\nstiffness = 1e6\n");
    let folder = Folder::new("measures-ball");
    folder.write("ball.toml", part + &jaws.concat());
    let report = folder.json("analyze ball.toml");
    assert_eq!(report["degenerate"], true);
    for key in ["quality", "quality_rotational", "worst_point_stiffness"] {
        let [value, least] =
            [key.to_owned(), format!("{key}_at_least")].map(|k| number(&report[k]));
        assert!(least < value && least > 0.9 * value, "{key}: {least:e} {value:e}");
    }
    let text = folder.run("analyze ball.toml").out;
    assert_eq!(text.matches("; only ").count(), 3, "{text}");
}

/// The worst point of Figure 1 has 0.73 times the stiffness of its springs, whose inverse is more
/// than the largest number.
#[test]
fn numbers_out_of_range_are_no_answer() {
    let folder = Folder::new("measures-range");
    folder.write("grasp.toml", figure_1().replace("stiffness = 1\n", "stiffness = 7e-309\n"));
    let ran = folder.run("analyze grasp.toml --format json");
    assert_eq!(ran.code, Some(3), "{}", ran.err);
    assert_says(&ran.err, &["the body moves by inf and resists with ", "in the range of doubles"]);
    assert_eq!(ran.json().get("quality"), None);
}

#[test]
fn text_has_the_axes_of_both_kinds() {
    let folder = Folder::new("measures-text");
    folder.write("grasp.toml", figure_1());
    assert_says(
        &folder.run("analyze grasp.toml --frame 1,2,0").out,
        &[
            "Q_pt                  0.727037 F/L            worst point, least force per deflection",
            "at corner 1 at (12, -2) L, along (0.692572, 0.721349)",
            "center of compliance  (5.15385, 3.53846) L    in the file's frame (6.15385, 5.53846)",
            "translation  stiffness [F/L]  along                  through [L]",
            "rotation  stiffness [F L]  through [L]         reach [L]  mu_eq [F/L]  farthest",
            "mu        86.3692          (5.15385, 3.53846)  8.80593    1.1138       corner 1 at",
        ],
    );
}
