//! Contacts, fingers and laws that are none: exit code 1, with the place and the reason.

use crate::fingers::{CUBE, ELLIPSE, ELLIPSOID, LINEAR, MILLIMETERS, SQUARE, one};
use crate::run::assert_says;

/// A finger that presses, and places for it.
const BALL: &str = "finger = { radius = 1 }\npreload = 1\n";
const FACE: &str = "point = [1, 1, 0]\n";
const EDGE: &str = "point = [7, 0]\n";

const STEEL: &str = "finger = \"steel\", part = \"steel\"";

fn hertz(fields: &str) -> String {
    format!("law = {{ kind = \"hertz\", {fields} }}")
}

fn line(fields: &str) -> String {
    format!("law = {{ kind = \"line\", thickness = 1, reference_depth = 9, {fields} }}")
}

fn in_millimeters(part: &str) -> String {
    MILLIMETERS.to_owned() + part
}

fn refused(name: &str, part: &str, contact: &str, pieces: &[&str]) {
    let ran = one(&format!("refused-{name}"), part, contact);
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{name}: {}", ran.err);
    assert_says(&ran.err, pieces);
}

#[test]
fn points_off_the_boundary_or_its_pieces_are_refused() {
    for (name, part, contact, pieces) in [
        (
            "inside",
            ELLIPSE,
            "point = [1, 1.5]",
            ["contacts[0].point", "0.5 L away", "inside the part"],
        ),
        ("outside", ELLIPSOID, "point = [0, 0, 3]", ["contacts[0].point", "1 L away", "outside"]),
        (
            "within",
            CUBE,
            "point = [1, 1, 0.25]",
            ["found it 0.25 L away from face 0", "inside", ""],
        ),
        (
            "beside",
            CUBE,
            "point = [1, 1, 2.5]",
            ["found it 0.5 L away from face 1", "outside", "at most"],
        ),
        ("vertex", CUBE, "point = [2, 2, 2]", ["where faces 1 and 3 meet", "a `face` or an", ""]),
        ("edge", CUBE, "point = [0, 1, 0]", ["where faces 0 and 4 meet", "contacts[0].point", ""]),
        ("face", CUBE, "point = [1, 1, 0]\nface = 1", ["not on face 1", "found it on face 0", ""]),
        ("no-face", CUBE, "point = [1, 1, 0]\nface = 6", ["found face 6", "0 to 5", "face: "]),
        (
            "solid-edge",
            CUBE,
            "point = [1, 1, 0]\nedge = 1",
            ["found `edge`", "of a solid", "`face`"],
        ),
        ("planar-face", SQUARE, "point = [7, 0]\nface = 0", ["found `face`", "of an outline", ""]),
        ("smooth-edge", ELLIPSE, "point = [1, 2]\nedge = 0", ["smooth part has no edges", "", ""]),
        (
            "normal",
            ELLIPSE,
            "point = [1, 2]\ninward_normal = [0, 1]",
            ["expected [0, -1]", "that of the boundary", ""],
        ),
    ] {
        refused(name, part, &format!("{contact}\n{LINEAR}"), &pieces);
    }
}

/// The square of such a distance is out of range.
#[test]
fn points_too_far_away_to_tell_how_far_are_refused() {
    let words = ["found it more than 1e154 L away from edge", "outside the part"];
    refused("far", SQUARE, "point = [1e300, 0]", &words);
}

#[test]
fn contradicting_places_are_refused() {
    for (name, part, contact, pieces) in [
        (
            "dimension",
            SQUARE,
            "point = [7, 0, 0]",
            ["contacts[0].point: ", "found 3 numbers", "[x, y]"],
        ),
        ("flat", CUBE, "point = [1, 1]", ["contacts[0].point: ", "found 2 numbers", "[x, y, z]"]),
        ("scalar", CUBE, "point = [1]", ["contacts[0].point: ", "a list of 1", "or three numbers"]),
        (
            "both",
            SQUARE,
            "point = [7, 0]\ncenter = [7, -1]",
            ["contacts[0].center", "found both", ""],
        ),
        (
            "preload",
            SQUARE,
            "center = [7, -1]\npreload = 1",
            ["contacts[0].preload", "beside a `center`", ""],
        ),
        (
            "apart",
            SQUARE,
            "center = [7, -3]\nfinger = { radius = 1 }",
            ["contacts[0].center", "apart from the part by 2 L", "3 L away"],
        ),
        (
            "corner",
            SQUARE,
            "center = [-1, -1]\nfinger = { radius = 2 }",
            ["contacts[0].center", "has no normal", "[0, 0]"],
        ),
        (
            "bore",
            SQUARE,
            "center = [7, -1]\nfinger = { radius = -2 }",
            ["contacts[0].finger", "not round", "zero or more"],
        ),
    ] {
        refused(name, part, &format!("{contact}\n{LINEAR}"), &pieces);
    }
    refused("no-law", SQUARE, "point = [7, 0]", &["contacts[0]: ", "no `law`", "no `stiffness`"]);
}

#[test]
fn fingers_of_the_plane_that_cannot_be_are_refused() {
    for (name, part, contact, pieces) in [
        (
            "straight",
            SQUARE,
            "point = [7, 0]\nfinger = { curvature = 0 }",
            ["contacts[0].finger", "flat on flat", ""],
        ),
        (
            "spatial",
            SQUARE,
            "point = [7, 0]\nfinger = { curvatures = [1, 1] }",
            ["found `curvatures`", "in the plane", ""],
        ),
        (
            "planar-direction",
            SQUARE,
            "point = [7, 0]\nfinger = { radius = 1, direction = [1, 0] }",
            ["`radius` and `direction`", "in the plane", ""],
        ),
        (
            "nan",
            SQUARE,
            "point = [7, 0]\nfinger = { curvature = nan }",
            ["contacts[0].finger.curvature", "NaN", "finite"],
        ),
        (
            "deep",
            ELLIPSE,
            "point = [5, 0]\npreload = 1.5\nfinger = { radius = 0.1 }",
            ["contacts[0].preload", "overlap is 1.5", "less than"],
        ),
    ] {
        refused(name, part, &format!("{contact}\n{LINEAR}"), &pieces);
    }
}

#[test]
fn fingers_of_space_that_cannot_be_are_refused() {
    for (name, part, contact, pieces) in [
        (
            "flat-flat",
            CUBE,
            "point = [1, 1, 0]\nfinger = { curvatures = [0, 1], direction = [1, 0, 0] }",
            ["contacts[0].finger", "sum to 0", "flat on flat"],
        ),
        (
            "narrow",
            ELLIPSOID,
            "point = [0, 0, 2]\nfinger = { radius = -3 }",
            ["contacts[0].finger", "narrow as itself", ""],
        ),
        (
            "saddle",
            ELLIPSOID,
            "point = [0, 0, 2]\nfinger = { curvatures = [1, -1], direction = [1, 0, 0] }",
            ["contacts[0].finger", "sum to -0.7", ""],
        ),
        (
            "along",
            ELLIPSOID,
            "point = [0, 0, 2]\nfinger = { curvatures = [1, 0], direction = [0, 0, 1] }",
            ["contacts[0].finger", "principal direction is along the normal", ""],
        ),
        (
            "undirected",
            ELLIPSOID,
            "point = [0, 0, 2]\nfinger = { curvatures = [1, 1] }",
            ["found no `direction`", "two `curvatures`", ""],
        ),
        (
            "three",
            ELLIPSOID,
            "point = [0, 0, 2]\nfinger = { curvatures = [1, 1, 1], direction = [1, 0, 0] }",
            ["found 3 of them", "two `curvatures`", ""],
        ),
        (
            "no-shape",
            ELLIPSOID,
            "point = [0, 0, 2]\nfinger = {}",
            ["contacts[0].finger", "found none", "in space"],
        ),
        (
            "two-shapes",
            ELLIPSOID,
            "point = [0, 0, 2]\nfinger = { radius = 1, curvature = 1 }",
            ["found `radius` and `curvature`", "in space", ""],
        ),
    ] {
        refused(name, part, &format!("{contact}\n{LINEAR}"), &pieces);
    }
}

#[test]
fn laws_that_are_no_tables_are_refused() {
    for (name, law, pieces) in [
        (
            "list",
            "law = [\"linear\", 1]",
            ["contacts[0].law: found a list", "a table with a `kind`"],
        ),
        ("number", "law = 7", ["contacts[0].law: found a number", "a table with a `kind`"]),
        ("no-kind", "law = { stiffness = 1 }", ["missing field `kind`", "`hertz` or `line`"]),
        ("kind", "law = { kind = 1 }", ["contacts[0].law.kind: found a number", "name of a kind"]),
    ] {
        refused(name, SQUARE, &format!("{EDGE}{law}"), &pieces);
    }
}

#[test]
fn contacts_that_hertz_does_not_know_are_refused() {
    for (name, part, contact, pieces) in [
        (
            "no-preload",
            CUBE.to_owned(),
            format!("{FACE}finger = {{ radius = 1 }}\n{}", hertz("effective_modulus = 1")),
            ["contacts[0].law", "slope is 0", "positive preload"],
        ),
        (
            "pointed",
            CUBE.to_owned(),
            format!("{FACE}preload = 1\n{}", hertz("effective_modulus = 1")),
            ["contacts[0].law", "has no `finger`, so it is pointed", "with a radius"],
        ),
        (
            "needle",
            CUBE.to_owned(),
            format!(
                "{FACE}preload = 1\nfinger = {{ radius = 0 }}\n{}",
                hertz("effective_modulus = 1")
            ),
            ["contacts[0].finger", "the finger is pointed", "give it a radius"],
        ),
        (
            "flat-hertz",
            CUBE.to_owned(),
            format!(
                "{FACE}preload = 1\nfinger = {{ curvatures = [1, 0], direction = [1, 0, 0] }}\n{}",
                hertz("effective_modulus = 1")
            ),
            ["contacts[0].finger", "touch along a line", "touch at a point"],
        ),
        (
            "planar-hertz",
            SQUARE.to_owned(),
            format!("{EDGE}{BALL}{}", hertz("effective_modulus = 1")),
            ["contacts[0].law", "touches along a line", "relative_radius"],
        ),
    ] {
        refused(&format!("law-{name}"), &part, &contact, &pieces);
    }
}

#[test]
fn materials_that_are_none_are_refused() {
    for (name, part, contact, pieces) in [
        (
            "half",
            in_millimeters(CUBE),
            format!("{FACE}{BALL}{}", hertz("finger = \"steel\"")),
            ["contacts[0].law", "found one material", "both"],
        ),
        (
            "none",
            in_millimeters(CUBE),
            format!("{FACE}{BALL}{}", hertz("relative_radius = 1")),
            ["contacts[0].law", "found neither", "`effective_modulus`"],
        ),
        (
            "twice",
            in_millimeters(CUBE),
            format!("{FACE}{BALL}{}", hertz("effective_modulus = 1, part = \"steel\"")),
            ["contacts[0].law", "and a material", ""],
        ),
        (
            "material",
            in_millimeters(CUBE),
            format!("{FACE}{BALL}{}", hertz("finger = \"steel\", part = \"unobtainium\"")),
            ["contacts[0].law.part", "found `unobtainium`, but no", "steel, stainless steel"],
        ),
        (
            "british",
            in_millimeters(CUBE),
            format!("{FACE}{BALL}{}", hertz("finger = \"aluminium 6061\", part = \"steel\"")),
            ["contacts[0].law.finger", "`aluminium 6061`", "did you mean `aluminum 6061`?"],
        ),
        (
            "units",
            CUBE.to_owned(),
            format!("{FACE}{BALL}{}", hertz(STEEL)),
            [
                "contacts[0].law.finger",
                "found length `L` and force `F`",
                "us-ft, us-in, us-yd, us-mi and the forces mN, N, kN, kgf, lbf",
            ],
        ),
    ] {
        refused(&format!("law-{name}"), &part, &contact, &pieces);
    }
}

#[test]
fn constants_that_no_material_has_are_refused() {
    for (name, part, contact, pieces) in [
        (
            "stiffless",
            CUBE.to_owned(),
            format!(
                "{FACE}{BALL}{}",
                hertz("finger = { young = 0, poisson = 0.3 }, part = { young = 1, poisson = 0.3 }")
            ),
            ["contacts[0].law.finger", "Young's modulus is 0", ""],
        ),
        (
            "poisson",
            CUBE.to_owned(),
            format!(
                "{FACE}{BALL}{}",
                hertz("finger = { young = 1, poisson = 0.3 }, part = { young = 1, poisson = 0.6 }")
            ),
            ["contacts[0].law.part", "Poisson's ratio is 0.6", "at most 1/2"],
        ),
        (
            "modulus",
            CUBE.to_owned(),
            format!("{FACE}{BALL}{}", hertz("effective_modulus = -1")),
            ["contacts[0].law", "effective modulus is -1", ""],
        ),
        (
            "relative",
            SQUARE.to_owned(),
            format!("{EDGE}{BALL}{}", hertz("effective_modulus = 1, relative_radius = 0")),
            ["contacts[0].law", "relative radius is 0", ""],
        ),
        (
            "word",
            CUBE.to_owned(),
            format!("{FACE}{BALL}{}", hertz("finger = 3, part = 3")),
            ["contacts[0].law", "found a number", "the name of a material"],
        ),
    ] {
        refused(&format!("law-{name}"), &part, &contact, &pieces);
    }
}

#[test]
fn lines_of_contact_that_are_none_are_refused() {
    for (name, part, contact, pieces) in [
        (
            "spatial-line",
            in_millimeters(CUBE),
            format!("{FACE}{BALL}{}", line(STEEL)),
            ["contacts[0].law", "found a face of a solid", "straight edge"],
        ),
        (
            "smooth-line",
            in_millimeters(ELLIPSE),
            format!("point = [5, 0]\n{BALL}{}", line(STEEL)),
            ["contacts[0].law", "found an ellipse", ""],
        ),
        (
            "no-disc",
            in_millimeters(SQUARE),
            format!("{EDGE}preload = 1\n{}", line(STEEL)),
            ["contacts[0].law", "no disc", ""],
        ),
        (
            "beyond",
            in_millimeters(SQUARE),
            format!("{EDGE}finger = {{ radius = 1 }}\npreload = 1e9\n{}", line(STEEL)),
            ["contacts[0].preload", "holds for less than", ""],
        ),
        (
            "missing",
            in_millimeters(SQUARE),
            format!("{EDGE}{BALL}{}", line("part = \"steel\"")),
            ["contacts[0].law", "missing field `finger`", "a material"],
        ),
    ] {
        refused(&format!("law-{name}"), &part, &contact, &pieces);
    }
}
