//! The three-groove coupling of the walk-through, against what Slocum's sheet prints for it.
//!
//! A. H. Slocum, `Kinematic_Coupling_3Groove_Design.xls`, as of 2012-10-28: the copy "kinematic
//! coupling 2012.10.28" on vdocuments.us prints its inputs and these results. E = 2.04E+11 there
//! has three digits, which is 0.25 % of E and 0.08 % of a diameter, 0.16 % of an overlap.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::f64::consts::FRAC_1_SQRT_2;
use std::path::Path;

use clench_testkit::cases::Value;

use crate::run::Folder;

const EXAMPLE: &str =
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/examples/three-groove-coupling");

/// The reports at rest and while cutting.
fn reports(name: &str) -> [Value; 2] {
    let folder = Folder::new(name);
    for file in ["plate.obj", "coupling.toml", "cutting.toml"] {
        folder.write(file, std::fs::read(Path::new(EXAMPLE).join(file)).unwrap());
    }
    ["coupling.toml", "cutting.toml"].map(|file| folder.json(&format!("analyze {file}")))
}

fn each(report: &Value, key: &str) -> [f64; 6] {
    let contacts = report["contacts"].as_array().unwrap();
    std::array::from_fn(|i| contacts[i].pointer(key).unwrap().as_f64().unwrap())
}

fn near(found: f64, printed: f64, relative: f64) {
    assert!((found / printed - 1.0).abs() <= relative, "{found}, but printed is {printed}");
}

/// Slocum's fits to the axes of the ellipse, at the angle whose cosine is `cosine`.
fn fits(cosine: f64) -> [f64; 2] {
    let angle = cosine.acos();
    let falling = |size: f64, rate: f64| size * (-rate * angle).exp();
    let longer = falling(1.939, 5.26) + falling(1.78, 1.09) + 0.723 / angle + 0.221;
    let shorter = falling(35.228, 0.98) - falling(32.424, 1.0475) + 1.486 * angle - 2.634;
    [longer, shorter]
}

#[test]
fn the_contact_forces_are_those_of_statics() {
    let [rest, cutting] = reports("coupling-statics");
    // At rest half of 15 kN by cos 45 degrees on each flank.
    for force in each(&rest, "/preload") {
        near(force, 15e3 * FRAC_1_SQRT_2, 1e-8);
    }
    // The tilting moment M takes 2 M / 3 R off the first ball, which is on its line; the side force
    // shears the flanks of the others.
    let [side, down, height, radius] = [5209.0, 29544.0, 1320.8, 312.5];
    let lifted = 2.0 / 3.0 * side * height / radius;
    let first = (15e3 + down / 3.0 - lifted) * FRAC_1_SQRT_2;
    let other = (15e3 + down / 3.0 + lifted / 2.0) * FRAC_1_SQRT_2;
    let shear = side / 3.0_f64.sqrt() * FRAC_1_SQRT_2;
    let expected = [first, first, other - shear, other + shear, other + shear, other - shear];
    for (found, expected) in each(&cutting, "/preload").into_iter().zip(expected) {
        near(found, expected, 1e-8);
    }
}

/// A coupling of equal springs k: 3 k sin^2 across, 6 k cos^2 along, R^2 times that to turn.
#[test]
fn the_stiffness_is_that_of_six_springs() {
    let [rest, _] = reports("coupling-springs");
    let k = each(&rest, "/stiffness")[0];
    let entry = |i: usize| rest["stiffness_first_order"][i][i].as_f64().unwrap();
    let turn = 312.5 * 312.5;
    let expected = [1.5, 1.5, 3.0, 1.5 * turn, 1.5 * turn, 3.0 * turn];
    for (i, factor) in expected.into_iter().enumerate() {
        near(entry(i), factor * k, 1e-8);
    }
}

#[test]
fn the_largest_ellipse_is_that_of_the_sheet() {
    let [_, cutting] = reports("coupling-ellipse");
    let largest = each(&cutting, "/contact_ellipse/semi_axes/0").into_iter().fold(0.0, f64::max);
    // Printed as the largest ellipse's two diameters. The fits are off those of a circle, 1.
    let [longer, shorter] = fits(0.25 / 1e3);
    near(2.0 * largest * longer, 8.778, 8e-4);
    near(2.0 * largest * shorter, 8.761, 8e-4);
    near(2.0 * largest, 8.778, 4e-3);
    // Its stress ratio is 0.3 of the peak pressure to half the yield stress, 1.72E+09.
    let pressure = each(&cutting, "/contact_ellipse/peak_pressure").into_iter().fold(0.0, f64::max);
    near(0.3 * pressure / (1720.0 / 2.0), 0.22, 0.005 / 0.22);
}

/// The sheet moves a ball by the mean of what its two contacts give way; a rigid ball on two
/// flanks at 45 degrees moves by the sum, which is twice as far.
#[test]
fn the_displacements_of_the_sheet_are_means_of_those_of_the_contacts() {
    let [rest, cutting] = reports("coupling-displacements").map(|r| each(&r, "/overlap"));
    let deeper: [f64; 6] = std::array::from_fn(|i| cutting[i] - rest[i]);
    let mean = |values: &[f64]| FRAC_1_SQRT_2 * values.iter().sum::<f64>() / values.len() as f64;
    // Half a unit of the last printed digit.
    near(mean(&rest), 0.015, 0.0005 / 0.015);
    near(mean(&deeper), 0.0056, 0.000_05 / 0.0056);
    // Tilt by the balls' heights, 1.5 R apart; and the balls' own way across, two of three.
    let tilt = (mean(&deeper[2..]) - mean(&deeper[..2])) / (1.5 * 312.5);
    let across = FRAC_1_SQRT_2 * (deeper[3] - deeper[2]) / 2.0 * 3.0_f64.sqrt() / 3.0;
    // Three digits of E, the fit to the overlap, which is off by 0.13 %, and those printed.
    near(tilt * 1320.8 + across, 0.0393, 1.6e-3 + 1.3e-3 + 1.3e-3);
}
