//! Mesh files: sound ones in every form, and hostile ones.

use clench_testkit::assert_all_close;
use clench_testkit::cases::{list, number, numbers};

use crate::run::{Folder, assert_says};

/// The corners of a cube of side 2.
const CORNERS: [[f32; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [2.0, 0.0, 0.0],
    [2.0, 2.0, 0.0],
    [0.0, 2.0, 0.0],
    [0.0, 0.0, 2.0],
    [2.0, 0.0, 2.0],
    [2.0, 2.0, 2.0],
    [0.0, 2.0, 2.0],
];

/// Its faces, counter-clockwise seen from outside.
const FACES: [[usize; 4]; 6] =
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [2, 3, 7, 6], [0, 4, 7, 3], [1, 2, 6, 5]];

/// The bytes of a binary file before its triangles, and of each.
const HEAD: usize = 84;
const TRIANGLE: usize = 50;

pub(crate) type Triangle = [[f32; 3]; 3];

pub(crate) fn triangles() -> Vec<Triangle> {
    let half = |[a, b, c]: [usize; 3]| [CORNERS[a], CORNERS[b], CORNERS[c]];
    FACES.iter().flat_map(|&[a, b, c, d]| [half([a, b, c]), half([a, c, d])]).collect()
}

pub(crate) fn text(triangles: &[Triangle]) -> String {
    let vertex = |[x, y, z]: [f32; 3]| format!("      vertex {x} {y} {z}\n");
    let facet = |corners: &Triangle| {
        let loops: String = corners.iter().map(|&corner| vertex(corner)).collect();
        format!("  facet normal 0 0 0\n    outer loop\n{loops}    endloop\n  endfacet\n")
    };
    format!("solid cube\n{}endsolid cube\n", triangles.iter().map(facet).collect::<String>())
}

pub(crate) fn binary(title: &str, triangles: &[Triangle]) -> Vec<u8> {
    let mut bytes = title.as_bytes().to_vec();
    bytes.resize(HEAD - 4, b' ');
    bytes.extend(u32::try_from(triangles.len()).unwrap_or(0).to_le_bytes());
    for corners in triangles {
        bytes.extend([0; 12]);
        bytes.extend(corners.as_flattened().iter().flat_map(|number| number.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

pub(crate) fn obj() -> String {
    let vertices = CORNERS.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n"));
    let faces = FACES.map(|face| face.map(|corner| (corner + 1).to_string()).join(" "));
    vertices.chain(faces.iter().map(|face| format!("f {face}\n"))).collect()
}

/// Four of the six locators of a cube, one of them on the seam of two triangles.
const CONTACTS: &str = "[[contacts]]\npoint = [0.5, 0.5, 0]\n[[contacts]]\npoint = [1.5, 0.5, 0]\n\
                        [[contacts]]\npoint = [0.5, 0, 1]\n[[contacts]]\npoint = [0, 1, 1.5]\n";

fn grasp(mesh: &str) -> String {
    format!("[part.spatial]\nmesh = \"{mesh}\"\nstiffness = 1\n{CONTACTS}")
}

fn analyzed(name: &str, file: &str, content: impl AsRef<[u8]>) -> clench_testkit::cases::Value {
    let folder = Folder::new(&format!("mesh-{name}"));
    folder.write(file, content).write("grasp.toml", grasp(file));
    let ran = folder.run("analyze grasp.toml --format json");
    // Four fingers do not hold a cube.
    assert_eq!(ran.code, Some(3), "{name}: {}", ran.err);
    ran.json()
}

#[test]
fn one_cube_in_every_form_is_the_same_part() {
    let expected = analyzed("text", "cube.stl", text(&triangles()));
    let faces: Vec<f64> = list(&expected["contacts"]).iter().map(|c| number(&c["face"])).collect();
    assert_eq!(faces, [0.0, 1.0, 5.0, 8.0]);
    let shouted = text(&triangles()).to_uppercase().replace('\n', "\r\n");
    let two = text(&triangles()[..6]) + &text(&triangles()[6..]).replace("cube", "");
    let unnamed = text(&triangles()).replace(" cube", "");
    for (name, content) in [
        ("binary", binary("a cube", &triangles())),
        ("binary-solid", binary("solid cube, binary all the same", &triangles())),
        ("shouted", shouted.into_bytes()),
        ("two-solids", two.into_bytes()),
        ("unnamed", unnamed.into_bytes()),
    ] {
        assert_eq!(analyzed(name, "CUBE.STL", content), expected, "{name}");
    }
}

#[test]
fn obj_files_may_have_everything_besides_the_shape() {
    let expected = analyzed("obj", "cube.obj", obj());
    let stiffness = numbers(&expected["stiffness"]);
    let stl = analyzed("obj-stl", "cube.stl", text(&triangles()));
    assert_all_close(&stiffness, &numbers(&stl["stiffness"]), 0.0, "stiffness");
    let relative = obj().lines().map(|line| relative(line) + "\n").collect::<String>();
    let textured = obj()
        .replace("f ", "usemtl steel\nf ")
        .replace(" 1 ", " 1/9223372036854775807/-9223372036854775808 ")
        .replace("v 0 0 0", "mtllib none.mtl\nvt 0 0\nvn 0 0 1\nv 0 0 0 1 0 0 # red");
    let objects = obj().replacen("f ", "o lower\nf ", 1).replace("f 5", "g upper\nl 1 2\nf 5");
    let continued = obj().replace("f 1 4", "f 1 \\\n4");
    for (name, content) in [
        ("relative", relative),
        ("textured", textured),
        ("objects", objects),
        ("continued", continued),
        ("scaled", obj().replace("v 2 0 0\n", "v 4 0 0 2\n")),
    ] {
        assert_eq!(analyzed(name, "cube.obj", content), expected, "{name}");
    }
}

/// A face by how far back its vertices are.
fn relative(line: &str) -> String {
    let Some(corners) = line.strip_prefix("f ") else { return line.to_owned() };
    let back = corners.split(' ').map(|corner| {
        corner.parse::<i32>().map_or_else(|_| corner.to_owned(), |n| (n - 9).to_string())
    });
    format!("f {}", back.collect::<Vec<_>>().join(" "))
}

#[test]
fn meshes_are_found_beside_the_file_that_names_them() {
    let folder = Folder::new("mesh-beside");
    folder.write("cube.obj", obj());
    std::fs::create_dir_all(folder.path("parts")).expect("the folder is new");
    folder.write("parts/grasp.toml", grasp("../cube.obj"));
    assert_eq!(folder.run("analyze parts/grasp.toml").code, Some(3));
}

/// The message about a mesh file.
pub(crate) fn refused(name: &str, file: &str, content: impl AsRef<[u8]>) -> String {
    let folder = Folder::new(&format!("mesh-hostile-{name}"));
    folder.write(file, content).write("grasp.toml", grasp(file));
    let ran = folder.run("analyze grasp.toml --format json");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{name}: {}", ran.err);
    assert_says(&ran.err, &["grasp.toml:2:8: part.spatial.mesh: ", file]);
    assert!(!ran.err.contains("panicked"), "{name}: {}", ran.err);
    ran.err
}

#[test]
fn stl_files_that_are_no_solid_are_refused() {
    let (sound, whole) = (triangles(), text(&triangles()));
    let bytes = binary("cube", &sound);
    let flipped: Vec<Triangle> = sound.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let mut flat = sound.clone();
    flat.push([CORNERS[0], [1.0, 0.0, 0.0], CORNERS[1]]);
    let mut none = sound.clone();
    none[3][1][2] = f32::NAN;
    let mut longer = bytes.clone();
    longer.push(0);
    let cut = whole.len() - "endsolid cube\n".len();
    for (name, content, pieces) in [
        ("empty", Vec::new(), ["is empty", "expected a mesh"]),
        ("spaces", b" \n ".to_vec(), ["is empty", ""]),
        ("garbage", b"\x00\xffnot a mesh".to_vec(), ["is no STL file", "`solid`"]),
        ("prose", b"once upon a time".to_vec(), ["is no STL file", "`solid`"]),
        ("cut", bytes[..HEAD + TRIANGLE + 7].to_vec(), ["has 141 bytes", "12 triangles"]),
        ("longer", longer, ["has 685 bytes", "has 684; is it cut off"]),
        (
            "cut-text",
            whole[..whole.len() / 2].into(),
            ["line 43: the file ends here", "`facet normal` and"],
        ),
        ("no-end", whole[..cut].into(), ["line 85: the file ends here", "or `endsolid`: is it"]),
        (
            "nan-text",
            whole.replacen("vertex 2", "vertex nan", 1).into(),
            ["line 6: found `vertex nan 2 0`", "`vertex` and three finite numbers"],
        ),
        (
            "word",
            whole.replacen("vertex 2", "vertex two", 1).into(),
            ["line 6: found `vertex two 2 0`", "`vertex` and three finite numbers"],
        ),
        (
            "quad",
            whole.replacen("endloop", "vertex 1 1 1", 1).into(),
            ["line 7: found `vertex 1 1 1`, expected `endloop`", "is a triangle"],
        ),
        (
            "nothing",
            b"solid none\nendsolid none\n".to_vec(),
            ["has no facets", "expected the closed surface"],
        ),
        (
            "nan",
            binary("cube", &none),
            ["facet 3, counted from 0, has a corner at (2, 2, NaN)", "expected finite numbers"],
        ),
        (
            "open",
            binary("cube", &sound[..11]),
            ["the surface is open", "; vertex 3 is at (2, 0, 0); vertex 5 is at (2, 0, 2)"],
        ),
        ("inside-out", binary("cube", &flipped), ["inside out", "reverse the corners"]),
        ("flat", binary("cube", &flat), ["face 12 has no area", "first use them"]),
    ] {
        assert_says(&refused(name, "cube.stl", content), &pieces);
    }
}

#[test]
fn obj_files_that_are_no_solid_are_refused() {
    let sound = obj();
    for (name, content, pieces) in [
        ("obj-empty", String::new(), ["is empty", ""]),
        (
            "obj-none",
            "# a comment\n".to_owned(),
            ["has no vertices, lines that begin with `v`", ""],
        ),
        ("obj-faceless", "v 0 0 0\n".to_owned(), ["has no faces, lines that begin with `f`", ""]),
        (
            "obj-index",
            sound.replace("f 1 4 3 2", "f 1 4 3 9"),
            ["line 9: found `9`, expected the number of a vertex", "1 to 8"],
        ),
        ("obj-zero", sound.replace("f 1 4 3 2", "f 0 4 3 2"), ["line 9: found `0`", "1 to 8"]),
        ("obj-back", sound.replace("f 1 4 3 2", "f -9 4 3 2"), ["line 9: found `-9`", "-1 to -8"]),
        (
            "obj-huge",
            sound.replace("f 1 4 3 2", "f 9223372036854775807 4 3 2"),
            ["line 9: found `9223372036854775807`", "1 to 8"],
        ),
        (
            "obj-word",
            sound.replace("f 1 4 3 2", "f one 4 3 2"),
            ["line 9: found `one`", "the number of a vertex"],
        ),
        (
            "obj-short",
            sound.replace("v 2 2 0", "v 2 2"),
            ["line 3: found `v 2 2`", "`v` and three finite"],
        ),
        (
            "obj-nan",
            sound.replace("v 2 2 0", "v 2 nan 0"),
            ["line 3: found `v 2 nan 0`", "`v` and three finite"],
        ),
        (
            "obj-inf",
            sound.replace("v 2 2 0", "v 2 1e999 0"),
            ["line 3: found `v 2 1e999 0`", "`v` and three finite"],
        ),
        (
            "obj-line",
            sound.replace("f 1 4 3 2", "f 1 4"),
            ["line 9: found `f 1 4`", "`f` and at least three"],
        ),
        (
            "obj-point",
            sound.replace("f 1 4 3 2", "f"),
            ["line 9: found `f`", "`f` and at least three"],
        ),
        (
            "obj-open",
            sound.replace("f 1 4 3 2\n", ""),
            ["the surface is open", "vertex 5 is at (2, 0, 0)"],
        ),
        ("obj-bent", sound.replace("v 2 2 2", "v 2 2 3"), ["is not flat", "split it"]),
        (
            "obj-weight",
            sound.replace("v 2 2 2", "v 2 2 2 0"),
            ["line 7: found `v 2 2 2 0`", "the fourth, which divides them, other than 0"],
        ),
    ] {
        assert_says(&refused(name, "cube.obj", content), &pieces);
    }
    let message = refused("obj-bytes", "cube.obj", b"v 0 0 \xff\n");
    assert_says(&message, &["byte 6 is not UTF-8"]);
}

#[test]
fn mesh_files_that_are_none_are_refused() {
    assert_says(
        &refused("step", "cube.step", "ISO-10303-21;"),
        &["not known by its ending", "STL"],
    );
    let folder = Folder::new("mesh-missing");
    folder.write("grasp.toml", grasp("none.stl"));
    let ran = folder.run("analyze grasp.toml");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""));
    assert_says(&ran.err, &["part.spatial.mesh: none.stl: cannot be read: No such file"]);
}
