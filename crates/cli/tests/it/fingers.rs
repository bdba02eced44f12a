//! Fingers, their laws and loads: what follows from them.

use clench_testkit::cases::{Value, list, number, numbers};
use clench_testkit::{assert_all_close, assert_close};

use crate::run::{Folder, Ran, assert_says};

/// A few tens of roundings: laws, their inverses, and sums of a few contacts.
const ROUNDING: f64 = 1e-14;

pub(crate) const MILLIMETERS: &str = "units = { length = \"mm\", force = \"N\" }\n";
pub(crate) const SQUARE: &str = "[part.planar]\noutline = [[0, 0], [20, 0], [20, 20], [0, 20]]\n";
pub(crate) const ELLIPSE: &str = "[part.planar]\nellipse = [4, 2]\ncenter = [1, 0]\n";
pub(crate) const ELLIPSOID: &str = "[part.spatial]\nellipsoid = [4, 3, 2]\n";
pub(crate) const CUBE: &str = "[part.spatial]\n\
    vertices = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], \
                [0, 0, 2], [2, 0, 2], [2, 2, 2], [0, 2, 2]]\n\
    faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [2, 3, 7, 6], [0, 4, 7, 3], [1, 2, 6, 5]]\n";
pub(crate) const LINEAR: &str = "law = { kind = \"linear\", stiffness = 1 }";

/// Analyzes one contact.
pub(crate) fn one(name: &str, part: &str, contact: &str) -> Ran {
    let folder = Folder::new(&format!("finger-{name}"));
    folder.write("grasp.toml", format!("{part}[[contacts]]\n{contact}\n"));
    folder.run("analyze grasp.toml --format json")
}

/// The first contact of a report; one finger holds nothing.
fn contact(name: &str, part: &str, text: &str) -> Value {
    let ran = one(name, part, text);
    assert_eq!(ran.code, Some(3), "{name}: {}", ran.err);
    ran.json()["contacts"][0].clone()
}

#[test]
fn a_steel_ball_on_steel_has_the_law_that_is_computed_by_hand() {
    let law = "law = { kind = \"hertz\", finger = \"steel\", part = \"steel\" }";
    let text = format!("point = [1, 1, 0]\nfinger = {{ radius = 10 }}\npreload = 90\n{law}");
    let found = contact("ball", &format!("{MILLIMETERS}{CUBE}"), &text);
    // E* = 207000 / (2 * 0.91), and a^3 = 3 f R / (4 E*).
    let modulus: f64 = 207e3 / 1.82;
    let a = f64::cbrt(0.75 * 90.0 * 10.0 / modulus);
    let area = &found["contact_ellipse"];
    assert_all_close(&numbers(&area["semi_axes"]), &[a, a], ROUNDING, "semi-axes");
    let pressure = 1.5 * 90.0 / (std::f64::consts::PI * a * a);
    assert_close(number(&area["peak_pressure"]), pressure, ROUNDING, pressure, "pressure");
    assert_close(number(&found["overlap"]), a * a / 10.0, ROUNDING, 1e-3, "overlap");
    let slope = 2.0 * modulus * a;
    assert_close(number(&found["stiffness"]), slope, ROUNDING, slope, "slope");
    assert_eq!(list(&area["direction"]).len(), 3);
    // The same in inches and pounds, and by numbers.
    let imperial = format!("units = {{ length = \"in\", force = \"lbf\" }}\n{CUBE}");
    let given = contact("imperial", &imperial, &text);
    let modulus = 207e9 / 1.82 * 0.0254 * 0.0254 / (0.453_592_37 * 9.806_65);
    let a = f64::cbrt(0.75 * 90.0 * 10.0 / modulus);
    let area = numbers(&given["contact_ellipse"]["semi_axes"]);
    assert_all_close(&area, &[a, a], ROUNDING, "inches");
    let law = format!("law = {{ kind = \"hertz\", effective_modulus = {modulus} }}");
    let text = format!("point = [1, 1, 0]\nfinger = {{ radius = 10 }}\npreload = 90\n{law}");
    let by_modulus = contact("modulus", CUBE, &text);
    let area = numbers(&by_modulus["contact_ellipse"]["semi_axes"]);
    assert_all_close(&area, &[a, a], ROUNDING, "by the modulus");
}

/// Materials have their stiffness in every unit that a drawing may have.
#[test]
fn a_steel_ball_is_as_stiff_in_units_of_drawings() {
    let law = "law = { kind = \"hertz\", finger = \"steel\", part = \"steel\" }";
    let text = format!("point = [1, 1, 0]\nfinger = {{ radius = 10 }}\npreload = 90\n{law}");
    for (unit, meters) in [("dm", 0.1), ("mil", 25.4e-6), ("us-ft", 1200.0 / 3937.0)] {
        let units = format!("units = {{ length = \"{unit}\", force = \"N\" }}\n{CUBE}");
        let found = contact(&format!("steel-{unit}"), &units, &text);
        let modulus = 207e9 / 1.82 * meters * meters;
        let a = f64::cbrt(0.75 * 90.0 * 10.0 / modulus);
        let area = numbers(&found["contact_ellipse"]["semi_axes"]);
        assert_all_close(&area, &[a, a], ROUNDING, unit);
    }
}

#[test]
fn a_roller_across_an_ellipsoid_has_its_area_along_the_smaller_curvature() {
    // At the end of c the ellipsoid has the curvatures c / a^2 along x and c / b^2 along y.
    let finger = "finger = { curvatures = [1, 0], direction = [1, 0, 5] }";
    let law = "law = { kind = \"hertz\", effective_modulus = 1000 }\npreload = 1";
    let found = contact("roller", ELLIPSOID, &format!("point = [0, 0, 2]\n{finger}\n{law}"));
    let area = &found["contact_ellipse"];
    let direction = numbers(&area["direction"]);
    // Together 1.125 along x and 0.222 along y: longest along y.
    assert_close(direction[1].abs(), 1.0, ROUNDING, 1.0, "direction");
    let [a, b] = [0, 1].map(|i| number(&area["semi_axes"][i]));
    assert!(a > 2.0 * b, "{a} {b}");
    let pressure = 1.5 / (std::f64::consts::PI * a * b);
    assert_close(number(&area["peak_pressure"]), pressure, ROUNDING, pressure, "pressure");
}

#[test]
fn a_disc_on_an_edge_has_a_line_of_contact() {
    let law = "law = { kind = \"line\", thickness = 8, reference_depth = 20, finger = \"steel\", \
               part = { young = 70e3, poisson = 0.5 } }";
    let text = format!("point = [7, 0]\nfinger = {{ radius = 5 }}\npreload = 400\n{law}");
    let found = contact("line", &format!("{MILLIMETERS}{SQUARE}"), &text);
    // a^2 = 4 P R / (pi E*), an incompressible part included.
    let modulus = (0.91_f64 / 207e3 + 0.75 / 70e3).recip();
    let half = (4.0 * 50.0 * 5.0 / (std::f64::consts::PI * modulus)).sqrt();
    assert_close(number(&found["half_width"]), half, ROUNDING, half, "half width");
    assert_eq!(found.get("contact_ellipse"), None);
    let pressure = 2.0 * 50.0 / (std::f64::consts::PI * half);
    assert_close(number(&found["peak_pressure"]), pressure, ROUNDING, pressure, "pressure");
    let folder = Folder::new("line-text");
    folder.write("grasp.toml", format!("{MILLIMETERS}{SQUARE}[[contacts]]\n{text}\n"));
    let area = "contact  half the area's size [mm]  peak pressure [N/mm^2]\n0        0.0";
    assert_says(&folder.run("analyze grasp.toml").out, &[area]);
    let law = "law = { kind = \"hertz\", effective_modulus = 1e5, relative_radius = 5 }";
    let text = format!("point = [7, 0]\nfinger = {{ radius = 5 }}\npreload = 400\n{law}");
    let found = contact("round", &format!("{MILLIMETERS}{SQUARE}"), &text);
    let a = (0.75 * 400.0 * 5.0 / 1e5_f64).cbrt();
    let area = numbers(&found["contact_ellipse"]["semi_axes"]);
    assert_all_close(&area, &[a, a], ROUNDING, "semi-axes");
    assert_eq!(found["contact_ellipse"].get("direction"), None);
}

/// A finger by its center, and the same by its point and preload.
#[test]
fn centers_say_the_same_as_points_and_preloads() {
    let law = "law = { kind = \"power\", coefficient = 100, exponent = 1.5 }";
    for (name, part, center, point, radius, overlap) in [
        ("edge", SQUARE, "[7, -2.75]", "[7, 0]", 3.0, 0.25),
        ("inside", SQUARE, "[7, 0.25]", "[7, 0]", 0.5, 0.75),
        ("needle", SQUARE, "[7, 0.25]", "[7, 0]", 0.0, 0.25),
        ("touching", SQUARE, "[7, -3.0000001]", "[7, 0]", 3.0, 0.0),
        ("ellipse", ELLIPSE, "[1, 4.5]", "[1, 2]", 3.0, 0.5),
        ("face", CUBE, "[1, 0.75, 3.5]", "[1, 0.75, 2]", 2.0, 0.5),
        ("ellipsoid", ELLIPSOID, "[0, -4.5, 0]", "[0, -3, 0]", 2.0, 0.5),
    ] {
        let law = if overlap > 0.0 { law } else { LINEAR };
        let preload = if overlap > 0.0 { 100.0 * f64::powf(overlap, 1.5) } else { 0.0 };
        let finger = format!("finger = {{ radius = {radius} }}\n{law}");
        let by_center =
            contact(&format!("center-{name}"), part, &format!("center = {center}\n{finger}"));
        let text = format!("point = {point}\npreload = {preload}\n{finger}");
        let by_point = contact(&format!("point-{name}"), part, &text);
        for key in ["point", "inward_normal", "overlap", "stiffness", "preload"] {
            let (found, expected) = (numbers(&by_center[key]), numbers(&by_point[key]));
            assert_all_close(&found, &expected, ROUNDING, format!("{name}: {key}"));
        }
        for key in ["edge", "face"] {
            assert_eq!(by_center.get(key), by_point.get(key), "{name}");
        }
    }
}

#[test]
fn points_of_smooth_parts_are_moved_to_the_boundary() {
    let found = contact("snapped", ELLIPSE, &format!("point = [1.000002, 2.000002]\n{LINEAR}"));
    // The height of the ellipse above x = 1 + t is 2 - t^2 / 16.
    assert_close(number(&found["point"][1]), 2.0, 1e-11, 1.0, "point");
    let found =
        contact("normal", ELLIPSE, &format!("point = [5, 0]\ninward_normal = [-7, 0]\n{LINEAR}"));
    assert_eq!(numbers(&found["inward_normal"]), [-1.0, 0.0]);
    assert_eq!(found.get("edge"), None);
}

#[test]
fn loads_balance_preloads_and_have_a_stiffness_of_their_own() {
    let law = LINEAR.replace("= 1 ", "= 1000 ");
    let finger = |x: f64| format!("[[contacts]]\npoint = [{x}, 0]\npreload = 1\n{law}\n");
    let load = "[[loads]]\npoint = [10, 10]\nforce = [0, -2]\n";
    let folder = Folder::new("loads");
    folder.write("grasp.toml", format!("{SQUARE}{}{}{load}", finger(5.0), finger(15.0)));
    let report = folder.run("analyze grasp.toml --format json").json();
    assert_eq!(
        (&report["equilibrium"]["holds"], &report["order"]),
        (&true.into(), &"second".into())
    );
    // About the origin: a load at (10, 10) has c . F = -20; each finger's overlap of 0.001 gives
    // -f delta.
    let added = numbers(&report["stiffness_preload"]);
    assert_close(added[8], -20.002, ROUNDING, 20.0, "rotation");
    // The fingers' normals turn with the part, the load does not.
    assert_eq!(added[..4], [0.0, 0.0, 2.0, 0.0]);
    assert_eq!(numbers(&report["loads"][0]["force"]), [0.0, -2.0]);
    let text = folder.run("analyze grasp.toml").out;
    assert_says(&text, &["preloads and loads balance", "load  point [L]  force [F]"]);
    folder.write("half.toml", format!("{SQUARE}{}{load}", finger(5.0)));
    let half = folder.run("analyze half.toml");
    assert_says(
        &half.out,
        &["the preloads and loads do not balance", "of the total of all forces"],
    );
    for (name, load, pieces) in [
        ("nan", "point = [0, 0]\nforce = [0, nan]", ["loads[0].force[1]", "NaN", "finite"]),
        ("space", "point = [0, 0, 1]\nforce = [0, 1]", ["loads[0].point: ", "found 3", "[x, y]"]),
        ("field", "point = [0, 0]\nmass = 1", ["loads[0].mass", "unknown field", "`force`"]),
        (
            "missing",
            "point = [0, 0]",
            ["loads[0]: ", "missing field `force`", "two numbers [x, y]"],
        ),
        (
            "huge",
            "point = [1e200, 0]\nforce = [1e200, 0]",
            ["loads[0]: ", "load 0", "out of range"],
        ),
    ] {
        folder.write("grasp.toml", format!("{SQUARE}{}[[loads]]\n{load}\n", finger(5.0)));
        let ran = folder.run("analyze grasp.toml");
        assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{name}: {}", ran.err);
        assert_says(&ran.err, &pieces);
    }
}

/// A wedge that hangs in a notch, its weight below the point where the lines of action meet.
#[test]
fn what_only_loads_hold_is_an_answer_with_a_warning() {
    let part = "[part.planar]\noutline = [[0, 0], [10, 10], [-10, 10]]\nstiffness = 1e4\n";
    let fingers = "[[contacts]]\npoint = [4, 4]\npreload = 1\n\
                   [[contacts]]\npoint = [-4, 4]\npreload = 1\n";
    let folder = Folder::new("weighed-down");
    let loaded = |height: f64| {
        let weight = std::f64::consts::SQRT_2;
        let load = format!("[[loads]]\npoint = [0, {height}]\nforce = [0, -{weight}]\n");
        folder.write("grasp.toml", format!("{part}{fingers}{load}"));
        folder.run("analyze grasp.toml --format json")
    };
    let ran = loaded(2.0);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    let report = ran.json();
    let held = (&report["equilibrium"]["holds"], &report["force_closure"], &report["stability"]);
    assert_eq!(held, (&true.into(), &false.into(), &"second_order".into()));
    assert_says(&report["warnings"].to_string(), &["only the loads keep the part on its fingers"]);
    // Each edge is sqrt(32) from there, less the overlap of 1e-4, and the weight 6 below.
    let mu = 2.0 * (32.0_f64.sqrt() - 1e-4) + 6.0 * std::f64::consts::SQRT_2;
    let found = number(&report["rotational"][0]["value"]);
    // The center of compliance is off that point by what the preloads add, 1e-4 of its height.
    assert_close(found, mu, 1e-4, mu, "mu");
    let ran = loaded(40.0);
    assert_eq!((ran.code, &ran.json()["stability"]), (Some(3), &"unstable".into()));
}
