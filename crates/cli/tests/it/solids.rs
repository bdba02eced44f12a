//! Grasps of solids by hand, and what is wrong with solids that are none.

use clench_testkit::cases::{list, number, numbers};
use clench_testkit::{assert_all_close, assert_close};

use crate::run::{Folder, Ran, assert_says};

/// A dozen products of small whole numbers.
const ROUNDING: f64 = 1e-15;

/// A cube of side 2 with its corner at the origin.
const VERTICES: &str = "[[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], \
                        [0, 0, 2], [2, 0, 2], [2, 2, 2], [0, 2, 2]]";
const FACES: &str = "[[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [2, 3, 7, 6], [0, 4, 7, 3], \
                     [1, 2, 6, 5]]";

/// Three fingers below, two in front, one on the left.
const LOCATORS: [&str; 6] = [
    "point = [0.5, 0.5, 0]",
    "point = [1.5, 0.5, 0]",
    "point = [1, 1.5, 0]",
    "point = [0.5, 0, 1]",
    "point = [1.5, 0, 1]",
    "point = [0, 1, 1]",
];

fn solid(vertices: &str, faces: &str) -> String {
    format!("[part.spatial]\nvertices = {vertices}\nfaces = {faces}\nstiffness = 3\n")
}

fn with_contacts(part: &str, contacts: &[&str]) -> String {
    let contacts = contacts.iter().map(|contact| format!("[[contacts]]\n{contact}\n"));
    part.to_owned() + &contacts.collect::<String>()
}

fn cube(name: &str, contacts: &[&str], arguments: &str) -> (Folder, Ran) {
    let folder = Folder::new(name);
    folder.write("cube.toml", with_contacts(&solid(VERTICES, FACES), contacts));
    let ran = folder.run(&format!("analyze cube.toml --format json{arguments}"));
    (folder, ran)
}

/// The rows (n, p x n) of the six locators, summed by hand.
fn located() -> Vec<f64> {
    let unit = [
        [1.0, 0.0, 0.0, 0.0, 1.0, -1.0],
        [0.0, 2.0, 0.0, -2.0, 0.0, 2.0],
        [0.0, 0.0, 3.0, 2.5, -3.0, 0.0],
        [0.0, -2.0, 2.5, 4.75, -2.5, -2.0],
        [1.0, 0.0, -3.0, -2.5, 4.5, -1.0],
        [-1.0, 2.0, 0.0, -2.0, -1.0, 3.5],
    ];
    unit.as_flattened().iter().map(|entry| 3.0 * entry).collect()
}

#[test]
fn six_locators_have_the_stiffness_that_is_computed_by_hand() {
    let (_, ran) = cube("locators", &LOCATORS, "");
    // They locate the cube, but nothing presses it on them.
    assert_eq!(ran.code, Some(3), "{}", ran.err);
    assert!(ran.err.contains("no preload of these contacts balances"), "{}", ran.err);
    let report = ran.json();
    assert_all_close(&numbers(&report["stiffness"]), &located(), ROUNDING, "stiffness");
    assert_eq!(report["stiffness"], report["stiffness_first_order"]);
    assert_eq!((&report["dimension"], &report["stability"]), (&3.into(), &"first_order".into()));
    let faces: Vec<f64> = list(&report["contacts"]).iter().map(|c| number(&c["face"])).collect();
    assert_eq!(faces, [0.0, 0.0, 0.0, 2.0, 2.0, 4.0]);
    let sigma: Vec<f64> =
        list(&report["translational"]).iter().map(|p| number(&p["value"])).collect();
    assert_all_close(&sigma, &[3.0, 6.0, 9.0], ROUNDING, "sigma");
    assert_eq!(list(&report["rotational"]).len(), 3);
    assert_eq!(
        (&report["limited_by"], &report["sigma_min"]),
        (&"rotation".into(), &sigma[0].into())
    );
    // Two turns of 1.5, and a corner at the distance sqrt(3) from an axis between theirs.
    assert_close(number(&report["quality"]), 0.5, ROUNDING, 1.0, "Q");
    assert_eq!(numbers(&report["frame"]["rotation_vector"]), [0.0; 3]);
}

#[test]
fn a_frame_of_space_changes_coordinates_and_no_invariants() {
    let (_, here) = cube("frame-here", &LOCATORS, "");
    // A quarter turn about z, about (1, 2, 3).
    let (_, there) = cube("frame-there", &LOCATORS, " --frame 1,2,3,0,0,1.5707963267948966");
    let (here, there) = (here.json(), there.json());
    for key in ["translational", "rotational"] {
        for (a, b) in list(&here[key]).iter().zip(list(&there[key])) {
            assert_eq!(a["value"], b["value"], "{key}");
        }
    }
    let [x, y, z] = [0, 1, 2].map(|i| number(&here["center"][i]));
    let center = [y - 2.0, 1.0 - x, z - 3.0];
    assert_all_close(&numbers(&there["center"]), &center, 4.0 * f64::EPSILON, "center");
    // Each axis is given by its point nearest to the origin.
    for principal in list(&there["rotational"]) {
        let (along, point) = (numbers(&principal["direction"]), numbers(&principal["axis_point"]));
        let across = along.iter().zip(&point).map(|(a, b)| a * b).sum();
        assert_close(across, 0.0, ROUNDING, 1.0, "nearest");
    }
    // The new x is the old y, the new y the old -x.
    let k = numbers(&there["stiffness"]);
    assert_all_close(&[k[0], k[7], k[14]], &[6.0, 3.0, 9.0], ROUNDING, "translational block");
    // Two fingers along the old y, 2 below the new origin.
    assert_all_close(&k[3..6], &[0.0, -12.0, 0.0], 2.0 * ROUNDING, "force along the old y");
    let normal = numbers(&there["contacts"][3]["inward_normal"]);
    assert_all_close(&normal, &[1.0, 0.0, 0.0], ROUNDING, "normal");
}

#[test]
fn a_free_turn_has_its_axis() {
    let locators = [LOCATORS[0], LOCATORS[1], LOCATORS[2], LOCATORS[3], LOCATORS[5]];
    let (_, ran) = cube("free-turn", &locators, "");
    assert_eq!(ran.code, Some(3));
    assert!(ran.err.contains("free to turn about the axis along (0, 0, "), "{}", ran.err);
    let motion = &ran.json()["free_motion"];
    assert_eq!(motion["kind"], "rotation");
    let (axis, point) = (numbers(&motion["direction"]), numbers(&motion["axis_point"]));
    assert_all_close(&[axis[0], axis[1], axis[2].abs()], &[0.0, 0.0, 1.0], 1e-14, "axis");
    // Where the lines of action of the two fingers at the sides meet.
    assert_all_close(&point, &[0.5, 1.0, 0.0], 1e-14, "a point of the axis");
    assert_close(number(&motion["pitch"]), 0.0, 1e-14, 1.0, "pitch");

    let (_, ran) = cube("free-slide", &LOCATORS[..5], "");
    assert!(ran.err.contains("free to slide along ("), "{}", ran.err);
    let direction = numbers(&ran.json()["free_motion"]["direction"]);
    assert_close(direction[0].abs(), 1.0, ROUNDING, 1.0, "along x");
}

/// Jaws resist a turn in the plane of two axes by f (b^2 - a^2) / a each, see the file.
#[test]
fn flat_jaws_hold_an_ellipsoid_by_its_curvature() {
    let folder = Folder::new("jaws");
    let jaw = |point: [f64; 3], along: &str| {
        format!(
            "[[contacts]]\npoint = {point:?}\npreload = 40\n\
             finger = {{ curvatures = [0, 0], direction = {along} }}\n"
        )
    };
    let (x, y, z) = ("[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]");
    let jaws = [
        jaw([30.0, 0.0, 0.0], y),
        jaw([-30.0, 0.0, 0.0], z),
        jaw([0.0, 20.0, 0.0], x),
        jaw([0.0, -20.0, 0.0], z),
        jaw([0.0, 0.0, 15.0], x),
        jaw([0.0, 0.0, -15.0], "[1, 1, 1]"),
    ];
    let part = "[part.spatial]\nellipsoid = [30, 20, 15]\nstiffness = 1e9\n";
    folder.write("jaws.toml", part.to_owned() + &jaws.concat());
    let report = folder.json("analyze jaws.toml");
    let added = numbers(&report["stiffness_preload"]);
    let turn = |a: f64, b: f64| 2.0 * 40.0 * (b * b - a * a) * (a.recip() - b.recip());
    for (row, expected) in [(3, turn(20.0, 15.0)), (4, turn(30.0, 15.0)), (5, turn(30.0, 20.0))] {
        // The overlap, 4e-8, is neglected in the formula.
        assert_close(added[7 * row], expected, 1e-7, expected, format!("row {row}"));
    }
    assert_eq!(
        (&report["order"], &report["stability"]),
        (&"second".into(), &"second_order".into())
    );
    assert_eq!(report["contacts"][0].get("face"), None);
}

#[test]
fn frames_have_to_fit_the_part() {
    let (folder, ran) = cube("usage-3", &LOCATORS, " --frame 1,2,0.5");
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    assert_says(&ran.err, &["--frame has 3 numbers, expected six", "x,y,z,rx,ry,rz"]);
    folder.write(
        "ellipse.toml",
        "[part.planar]\nellipse = [2, 1]\nstiffness = 1\n[[contacts]]\npoint = [2, 0]\n",
    );
    let ran = folder.run("analyze ellipse.toml --frame 1,2,3,0,0,1");
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    assert_says(&ran.err, &["--frame has 6 numbers, expected three", "x,y,angle"]);
}

#[test]
fn text_names_the_rows_and_columns_of_space() {
    let (folder, _) = cube("spatial-text", &LOCATORS, "");
    let text = folder.run("analyze cube.toml --frame 0,0,0,0.5,0,0").out;
    for piece in [
        "turned by the rotation vector (0.5, 0, 0) rad",
        "contact  face  point [L]",
        "rot z [rad]",
        "torque x [F L]",
        "rotation  stiffness [F L]  along ",
        "mu_min    1.5  ",
        "mu_max    2  ",
        "where force and rotation couple symmetrically",
    ] {
        assert!(text.contains(piece), "{piece} is missing in: {text}");
    }
}

/// The message about a spatial part.
fn refused(name: &str, part: &str) -> String {
    let folder = Folder::new(&format!("solid-{name}"));
    folder.write("part.toml", with_contacts(part, &["point = [0, 0, 0]"]));
    let ran = folder.run("analyze part.toml");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{name}: {}", ran.err);
    ran.err
}

#[test]
fn surfaces_of_nothing_are_refused_with_their_place() {
    let face = |number: usize, corners: &str| {
        let mut faces: Vec<String> =
            FACES.trim_matches(['[', ']']).split("], [").map(|f| format!("[{f}]")).collect();
        faces[number] = corners.to_owned();
        format!("[{}]", faces.join(", "))
    };
    let inside_out = "[[1, 2, 3, 0], [7, 6, 5, 4], [4, 5, 1, 0], [6, 7, 3, 2], [3, 7, 4, 0], \
                      [5, 6, 2, 1]]";
    let open = FACES.replace(", [1, 2, 6, 5]", "");
    let line = VERTICES.replace("[2, 2, 2]", "[2, 0, 2]");
    let bent = VERTICES.replace("[2, 2, 2]", "[2, 2, 2.5]");
    let infinite = VERTICES.replace("[2, 2, 2]", "[2, 2, nan]");
    for (name, vertices, faces, pieces) in [
        (
            "inside-out",
            VERTICES,
            inside_out,
            ["part.spatial.faces[0]: ", "inside out", "clockwise"],
        ),
        (
            "open",
            VERTICES,
            &open,
            ["part.spatial.faces[0]", "surface is open", "from vertex 2 to 1"],
        ),
        ("flipped", VERTICES, &face(1, "[7, 6, 5, 4]"), ["faces[", "both run from vertex", ""]),
        ("number", VERTICES, &face(5, "[1, 2, 6, 8]"), ["faces[5]", "names vertex 8", "only 8"]),
        ("two", VERTICES, &face(5, "[1, 2]"), ["faces[5]", "has 2 corners", "at least 3"]),
        ("twice", VERTICES, &face(5, "[1, 2, 2]"), ["faces[5]", "vertex 2", "more than once"]),
        ("half", VERTICES, &face(5, "[1, 2, 6, 0.5]"), ["faces[5][3]", "0.5", "whole number"]),
        ("none", VERTICES, "[]", ["part.spatial.faces: ", "found 0 faces", "at least 4"]),
        ("equal", &line, FACES, ["vertices[6]", "vertices 5 and 6 are the same point", ""]),
        ("bent", &bent, FACES, ["faces[1]", "not flat", "vertex"]),
        ("nan", &infinite, FACES, ["vertices[6][2]", "NaN", "finite number"]),
    ] {
        let message = refused(name, &solid(vertices, faces));
        assert_says(&message, &["part.toml:"]);
        assert_says(&message, &pieces);
    }
    let flat = "[[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 0, 1]]";
    let faces = "[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]";
    assert_says(&refused("no-area", &solid(flat, faces)), &["faces[0]", "face 0 has no area"]);
}

#[test]
fn parts_of_no_shape_or_several_are_refused() {
    let sound = solid(VERTICES, FACES);
    let list = sound.replace("stiffness = 3", "stiffness = [3, 3, 3]");
    let zero = sound.replace("stiffness = 3", "stiffness = [3, 3, 0, 3, 3, 3]");
    let both = format!("{sound}\n[part.planar]\nellipse = [2, 1]\n");
    for (name, part, pieces) in [
        (
            "zero-axis",
            "[part.spatial]\nellipsoid = [3, 0, 1]\n",
            ["ellipsoid[1]", "semi-axis 1 is 0, but has to be from 1e-"],
        ),
        (
            "two-axes",
            "[part.spatial]\nellipsoid = [3, 1]\n",
            ["part.spatial.ellipsoid: ", "three numbers"],
        ),
        ("no-shape", "[part.spatial]\nstiffness = 1\n", ["part.spatial: found no shape", "`mesh`"]),
        (
            "no-faces",
            "[part.spatial]\nvertices = []\n",
            ["found `vertices`, expected", "with `faces`"],
        ),
        (
            "two-shapes",
            "[part.spatial]\nmesh = \"a.stl\"\nellipsoid = [1, 1, 1]\n",
            ["found `mesh` and `ellipsoid`", "exactly one"],
        ),
        (
            "center",
            "[part.spatial]\ncenter = [0, 0, 0]\nmesh = \"a.stl\"\n",
            ["part.spatial.center: ", "which only an `ellipsoid` has"],
        ),
        (
            "few",
            &list,
            ["part.spatial.stiffness: ", "3 numbers, expected one for each of the 6 faces"],
        ),
        ("soft", &zero, ["part.spatial.stiffness[2]: ", "is 0, but has to be a positive"]),
        (
            "smooth-list",
            "[part.spatial]\nellipsoid = [1, 1, 1]\nstiffness = [1, 1]\n",
            ["part.spatial.stiffness: ", "an ellipsoid has no faces"],
        ),
        ("both", &both, ["part: ", "found both `planar` and `spatial`"]),
        (
            "plane-none",
            "[part.planar]\nstiffness = 1\n",
            ["part.planar: found no shape", "`ellipse`"],
        ),
        (
            "plane-both",
            "[part.planar]\noutline = []\nellipse = [1, 2]\n",
            ["part.planar: found both", "`outline`"],
        ),
        (
            "plane-center",
            "[part.planar]\noutline = [[0, 0], [1, 0], [0, 1]]\ncenter = [0, 0]\n",
            ["part.planar.center: ", "only an `ellipse` has"],
        ),
        (
            "negative",
            "[part.planar]\nellipse = [1, -2]\n",
            ["ellipse[1]", "semi-axis 1 is -2, but has to be"],
        ),
    ] {
        assert_says(&refused(name, part), &pieces);
    }
}

/// Two fingers at one place are as stiff as one of twice the stiffness.
#[test]
fn contacts_may_coincide() {
    let doubled: Vec<&str> = LOCATORS.iter().flat_map(|locator| [*locator; 2]).collect();
    let (_, ran) = cube("doubled", &doubled, "");
    let expected: Vec<f64> = located().iter().map(|entry| 2.0 * entry).collect();
    assert_all_close(&numbers(&ran.json()["stiffness"]), &expected, ROUNDING, "stiffness");
}

#[test]
fn sizes_from_tiny_to_huge_are_all_the_same() {
    let grasp = |size: f64| {
        let contact = |axis: usize, sign: f64| {
            let mut point = [0.0; 3];
            point[axis] = sign * [3.0, 2.0, 1.5][axis] * size;
            format!(
                "[[contacts]]\npoint = {point:?}\npreload = 40\nfinger = {{ radius = {} }}\n\
                 law = {{ kind = \"linear\", stiffness = {} }}\n",
                50.0 * size,
                1e6 / size
            )
        };
        let contacts = (0..6).map(|i| contact(i / 2, if i % 2 == 0 { 1.0 } else { -1.0 }));
        let axes = [3.0, 2.0, 1.5].map(|axis| axis * size);
        format!("[part.spatial]\nellipsoid = {axes:?}\n") + &contacts.collect::<String>()
    };
    let folder = Folder::new("sizes");
    let analyzed = |size: f64| {
        folder.write("grasp.toml", grasp(size));
        let report = folder.json("analyze grasp.toml --order second");
        ["translational", "rotational"]
            .map(|key| list(&report[key]).iter().map(|p| number(&p["value"])).collect::<Vec<f64>>())
    };
    let [sigma, mu] = analyzed(1.0);
    for size in [1e-9, 1e9] {
        let [scaled_sigma, scaled_mu] = analyzed(size);
        let expected: Vec<f64> = sigma.iter().map(|value| value / size).collect();
        assert_all_close(&scaled_sigma, &expected, 1e-13, format!("sigma at {size:e}"));
        // Forces stay, so that torques grow with the size.
        let expected: Vec<f64> = mu.iter().map(|value| value * size).collect();
        assert_all_close(&scaled_mu, &expected, 1e-12, format!("mu at {size:e}"));
    }
}
