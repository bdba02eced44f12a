//! Mesh files that are sound but for what they describe: far away, in pieces; and where errors are.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use clench_testkit::cases::{Value, list};

use crate::meshes::{Triangle, binary, obj, refused, text, triangles};
use crate::run::{Folder, Ran, assert_says};

fn moved(by: f32) -> Vec<Triangle> {
    triangles().iter().map(|triangle| triangle.map(|corner| corner.map(|x| x + by))).collect()
}

/// Coordinates of single precision near 2^p are 2^(p - 23) apart, as [IEEE 754] has it.
#[test]
fn meshes_too_far_from_the_origin_for_their_digits_are_refused() {
    for far in [32768.0, 1e7] {
        for content in [text(&moved(far)).into_bytes(), binary("far", &moved(far))] {
            let message = refused(&format!("far-{far}"), "cube.stl", content);
            let says = "in single precision, for a part of size ";
            assert_says(&message, &["has coordinates up to ", says, "nearer to the origin"]);
        }
    }
    // Steps of 2^-9 = 0.00195 are less than a thousandth of 2; those of 2^-8 beyond 32768 are not.
    let message = refused("far-steps", "cube.stl", binary("far", &moved(32768.0)));
    assert_says(&message, &["coordinates up to 32770, which are 0.00390625 apart", "of size 2:"]);
    let folder = Folder::new("mesh-far-enough");
    folder.write("cube.stl", binary("far", &moved(32765.0)));
    let ran = folder.run("optimize cube.stl --stiffness 1 --fingers 7 --nodes 1");
    assert!(matches!(ran.code, Some(0 | 3)), "{}", ran.err);
}

/// A second cube, beside the first one or within it and then seen from inside.
fn two(by: f32, scale: f32) -> Vec<Triangle> {
    let place = |corner: [f32; 3]| corner.map(|x| x * scale + by);
    let turned = |[a, b, c]: Triangle| if scale < 1.0 { [a, c, b] } else { [a, b, c] };
    let second = triangles().into_iter().map(|triangle| turned(triangle.map(place)));
    triangles().into_iter().chain(second).collect()
}

/// Two fingers on the first cube.
const GRASP: &str = "[part.spatial]\nmesh = \"two.stl\"\nstiffness = 1\n\
                     [[contacts]]\npoint = [0.5, 0.5, 0]\n[[contacts]]\npoint = [1.5, 0.5, 0]\n";

#[test]
fn solids_in_pieces_get_a_warning() {
    let folder = Folder::new("mesh-pieces");
    let said = "the solid is in 2 pieces that no face joins: they are taken as one rigid part";
    folder.write("two.stl", text(&two(5.0, 1.0))).write("grasp.toml", GRASP);
    let optimize = "optimize two.stl --stiffness 1 --fingers 7 --nodes 50 --roundness 0";
    let ran = folder.run(&format!("{optimize} --report page.html"));
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert_says(&ran.out, &[&format!("warning   {said}")]);
    assert_says(&std::fs::read_to_string(folder.path("page.html")).unwrap(), &[said]);
    let report = folder.run(&format!("{optimize} --format json"));
    assert_eq!(report.json()["warnings"][0].as_str(), Some(said));
    // The report is a grasp file all the same.
    folder.write("report.json", report.out);
    for file in ["report.json", "grasp.toml"] {
        let ran = folder.run(&format!("analyze {file} --format json"));
        assert!(matches!(ran.code, Some(0 | 3)), "{file}: {}", ran.err);
        let report = ran.json();
        assert_eq!(list(&report["warnings"])[0].as_str(), Some(said), "{file}");
        assert_says(&folder.run(&format!("analyze {file}")).out, &[&format!("warning   {said}")]);
    }
    // A cavity is no piece.
    folder.write("two.stl", text(&two(0.5, 0.5)));
    let report = folder.run(&format!("{optimize} --format json")).json();
    assert_eq!(report.get("warnings"), None);
    assert!(!folder.run("analyze grasp.toml").out.contains("pieces"));
}

fn place(ran: &Ran) -> [Value; 4] {
    let error: Value = serde_json::from_str(&ran.err).unwrap();
    ["file", "line", "column", "field"]
        .map(|key| error["error"].get(key).cloned().unwrap_or(Value::Null))
}

/// A file that is the part alone has its own lines, or none.
#[test]
fn errors_for_programs_have_the_line_of_the_file_that_they_name() {
    let folder = Folder::new("mesh-lines");
    let null = Value::Null;
    let nan = text(&triangles()).replacen("vertex 2", "vertex nan", 1);
    let line = |x: &str| format!("0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n{x}\n");
    for (name, content, at) in [
        ("nan.stl", nan.as_str(), Some(6)),
        ("open.stl", &text(&triangles()[1..]), None),
        ("zero.obj", &obj().replace("f 1 4 3 2", "f 1 0 3 2"), Some(9)),
        ("nan.dxf", &format!("{}20\n0\n11\n1\n21\n1\n0\nENDSEC\n0\nEOF\n", line("nan")), Some(8)),
        ("cut.dxf", &line("1"), Some(8)),
        ("path.svg", "<svg viewBox='0 0 9 9'>\n<path d='M0 x'/></svg>", Some(2)),
        ("tag.svg", "<svg viewBox='0 0 9 9'>\n\n<path></svg>", Some(3)),
        ("open.svg", "<svg viewBox='0 0 9 9'>\n<path d='M0 0 L9 0 L0 9'/></svg>", Some(2)),
        ("none.svg", "<svg viewBox='0 0 9 9'/>", None),
    ] {
        folder.write(name, content);
        let options = "--stiffness 1 --fingers 7 --units mm --format json";
        let ran = folder.run(&format!("optimize {name} {options}"));
        assert_eq!(ran.code, Some(1), "{name}");
        let at = at.map_or(Value::Null, Value::from);
        assert_eq!(place(&ran), [name.into(), at, null.clone(), null.clone()], "{}", ran.err);
    }
    // A part file that names it has the place of the name.
    folder.write("part.toml", "[part.spatial]\nmesh = \"nan.stl\"\nstiffness = 1\n");
    let ran = folder.run("optimize part.toml --fingers 7 --format json");
    let expected: [Value; 4] = ["part.toml".into(), 2.into(), 8.into(), "part.spatial.mesh".into()];
    assert_eq!(place(&ran), expected, "{}", ran.err);
    assert_says(&ran.err, &["nan.stl: line 6: found"]);
}
