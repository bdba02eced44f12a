//! Contacts: where they are, which edge they press on, and what is wrong with them.

use clench_testkit::assert_close;
use clench_testkit::cases::{list, number, numbers};

use crate::run::{Folder, grasp, part};

/// Runs `analyze` on a grasp with a bad contact number 1; the message has to have all `pieces`.
fn assert_refused(name: &str, contact: &str, pieces: &[&str]) {
    let folder = Folder::new(&format!("contact-{name}"));
    folder.write("grasp.toml", grasp(&["point = [6.5, 0]", contact]));
    let ran = folder.run("analyze grasp.toml");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{name}: {}", ran.err);
    for piece in pieces {
        assert!(ran.err.contains(piece), "{name}: `{piece}` is missing in: {}", ran.err);
    }
}

#[test]
fn contacts_off_their_edge_are_refused_with_their_place() {
    for (name, contact, pieces) in [
        (
            "off",
            "point = [6.5, -0.25]",
            ["grasp.toml:7:9: contacts[1].point", "contact 1", "found it 0.25 L", "edge 0"],
        ),
        (
            "far",
            "point = [6.123456789012, 0.123456789012]",
            ["contacts[1].point", "found it 0.123457 L away", "at most 6.7e-6 L", "edge 0"],
        ),
        ("inside", "point = [6.5, 0.5]", ["contacts[1].point", "contact 1", "0.5 L", "edge 0"]),
        (
            "corner",
            "point = [13, 0]",
            ["contacts[1].point", "contact 1", "edges 0 and 1", "expected an `edge`"],
        ),
        (
            "near-corner",
            "point = [0.0000001, 0]",
            ["contacts[1].point", "contact 1", "edges 0 and 3", "expected an `edge`"],
        ),
        (
            "other-edge",
            "point = [6.5, 0]\nedge = 1",
            ["contacts[1].point", "contact 1", "not on edge 1", "found it on edge 0"],
        ),
        (
            "no-edge",
            "point = [6.5, 0]\nedge = 4",
            ["grasp.toml:8:8: contacts[1].edge", "found edge 4", "expected", "0 to 3"],
        ),
        (
            "outward",
            "point = [6.5, 0]\ninward_normal = [0, -1]",
            ["grasp.toml:8:17: contacts[1].inward_normal", "[0, -1]", "[0, 1]", "edge 0"],
        ),
        (
            "no-direction",
            "point = [6.5, 0]\ninward_normal = [0, 0]",
            ["contacts[1].inward_normal", "[0, 0]", "expected", "edge 0"],
        ),
    ] {
        assert_refused(name, contact, &pieces);
    }
}

#[test]
fn bad_laws_and_fields_are_refused_with_their_place() {
    for (name, contact, pieces) in [
        (
            "law",
            "point = [6.5, 0]\nlaw = { kind = \"cubic\" }",
            [
                "grasp.toml:8:16: contacts[1].law.kind",
                "unknown variant `cubic`",
                "`linear`",
                "`power`",
            ],
        ),
        (
            "law-field",
            "point = [6.5, 0]\nlaw = { kind = \"linear\" }",
            [
                "grasp.toml:8:7: contacts[1].law",
                "missing field",
                "`stiffness`",
                "a positive number",
            ],
        ),
        (
            "soft",
            "point = [6.5, 0]\nlaw = { kind = \"linear\", stiffness = 0 }",
            ["contacts[1].law", "stiffness is 0", "positive", ""],
        ),
        (
            "power",
            "point = [6.5, 0]\nlaw = { kind = \"power\", coefficient = 1, exponent = 1.5 }",
            ["contacts[1].law", "slope is 0", "positive preload", ""],
        ),
        (
            "pull",
            "point = [6.5, 0]\npreload = -1",
            ["grasp.toml:8:11: contacts[1].preload", "preload is -1", "zero or positive", ""],
        ),
        (
            "radius",
            "point = [6.5, 0]\nfinger = { radius = -1 }",
            ["grasp.toml:8:10: contacts[1].finger", "sum to -1", "a hollow as narrow", ""],
        ),
        (
            "field",
            "point = [6.5, 0]\npreloud = 1",
            ["grasp.toml:8:1: contacts[1].preloud", "unknown field `preloud`", "`preload`", ""],
        ),
        (
            "nowhere",
            "preload = 1",
            [
                "grasp.toml:6:",
                "contacts[1]",
                "found no place",
                "exactly one of `point` and `center`",
            ],
        ),
    ] {
        assert_refused(name, contact, &pieces);
    }
}

#[test]
fn a_grasp_needs_contacts() {
    let folder = Folder::new("no-contacts");
    folder.write("part.toml", part("[[0, 0], [4, 0], [0, 3]]", "1"));
    let ran = folder.run("analyze part.toml");
    assert_eq!(ran.code, Some(1));
    assert!(ran.err.contains("part.toml:1:1: contacts: found no contacts"), "{}", ran.err);
    // There is no place to show.
    assert!(!ran.err.contains("─ here"), "{}", ran.err);
}

#[test]
fn a_normal_tells_the_edges_of_a_corner_apart() {
    let folder = Folder::new("corner-normal");
    let contacts = [
        "point = [0, 0]\ninward_normal = [0, 3]",
        "point = [13, 0]\ninward_normal = [0, 1]",
        "point = [9, 8]\ninward_normal = [-0.8944, -0.4472]",
        "point = [2, 6]\nedge = 3\ninward_normal = [0.94868, -0.31623]",
    ];
    folder.write("grasp.toml", grasp(&contacts));
    let report = folder.json("analyze grasp.toml");
    let edges: Vec<f64> = list(&report["contacts"]).iter().map(|c| number(&c["edge"])).collect();
    assert_eq!(edges, [0.0, 0.0, 1.0, 3.0]);
    // The rounded normals are not used: those of the edges are.
    let normal = numbers(&report["contacts"][2]["inward_normal"]);
    assert_close(normal[0], -2.0 / 5.0_f64.sqrt(), f64::EPSILON, 1.0, "normal");
}

#[test]
fn a_corner_within_a_straight_side_is_no_ambiguity() {
    let outline = "[[0, 0], [6.5, 0], [13, 0], [9, 8], [2, 6]]";
    let contacts = "[[contacts]]\npoint = [6.5, 0]\n[[contacts]]\npoint = [11, 4]\n\
                    [[contacts]]\npoint = [1.175, 3.525]\n";
    let folder = Folder::new("straight-corner");
    folder.write("grasp.toml", part(outline, "1") + contacts);
    let ran = folder.run("analyze grasp.toml --format json");
    assert_eq!(ran.json()["contacts"][0]["edge"], 0, "{}", ran.err);
    folder.write("grasp.toml", part(outline, "[1, 2, 1, 1, 1]") + contacts);
    let ran = folder.run("analyze grasp.toml");
    assert_eq!(ran.code, Some(1));
    assert!(ran.err.contains("where edges 0 and 1 meet"), "{}", ran.err);
}

#[test]
fn a_power_law_has_the_slope_of_its_preload() {
    let law = "law = { kind = \"power\", coefficient = 2, exponent = 1.5 }";
    let folder = Folder::new("power-law");
    folder.write("grasp.toml", grasp(&[&format!("point = [6.5, 0]\npreload = 16\n{law}")]));
    let report = folder.run("analyze grasp.toml --format json").json();
    // 2 * 4^(3/2) = 16, so the overlap is 4 and the slope 3 * 4^(1/2) = 6.
    assert_close(number(&report["contacts"][0]["stiffness"]), 6.0, 1e-15, 6.0, "slope");
}
