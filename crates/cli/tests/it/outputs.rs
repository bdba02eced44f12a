//! What is written: pictures all or nothing, reports to whoever reads them.

use std::fs;
use std::io::Write;
use std::process::Stdio;

use clench_testkit::cases::Value;

use crate::run::{Folder, QUADRILATERAL, Ran, command, figure_1, part};

/// A cube that no finger may touch.
const CUBE: &str = "[part.spatial]\nstiffness = 1\n\
    vertices = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [0, 0, 4], [4, 0, 4], [4, 4, 4], \
    [0, 4, 4]]\n\
    faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]\n\
    keep_out = [{ from = [-9, -9, -9], to = [9, 9, 9] }]\n";

fn quadrilateral(name: &str) -> Folder {
    let folder = Folder::new(name);
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    folder
}

#[test]
fn the_picture_shows_fingers_corners_and_numbers() {
    let folder = quadrilateral("picture");
    let ran = folder.run("optimize part.toml --fingers 4 --preload 2 --svg picture.svg");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let svg = fs::read_to_string(folder.path("picture.svg")).unwrap();
    assert!(svg.starts_with("<svg") || svg.starts_with("<?xml"), "{}", &svg[..80]);
    for piece in ["Q = 1.68377 F/L", "limited by translation", "to corner 0", "F3", ">2<"] {
        assert!(svg.contains(piece), "{piece} is missing");
    }
    assert_eq!(folder.names(), ["part.toml", "picture.svg"]);
    folder.write("grasp.toml", figure_1());
    let ran = folder.run("analyze grasp.toml --frame 1,2,3 --svg picture.svg");
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let svg = fs::read_to_string(folder.path("picture.svg")).unwrap();
    assert!(svg.contains("Q = 1.1138 F/L") && svg.contains("F2 at (9, 8) L, edge 1"));
}

#[test]
fn what_cannot_be_written_is_refused_before_the_search() {
    let folder = quadrilateral("unwritable");
    folder.write("old.svg", "old").write("locked.svg", "old");
    let mut locked = fs::metadata(folder.path("locked.svg")).unwrap().permissions();
    locked.set_readonly(true);
    fs::set_permissions(folder.path("locked.svg"), locked).unwrap();
    fs::create_dir(folder.path("folder.svg")).unwrap();
    for (path, piece) in [
        ("locked.svg", "locked.svg: cannot be written"),
        ("folder.svg", "folder.svg: cannot be written: is a directory"),
        ("none/page", "none/page: cannot be written: there is no folder none"),
        ("old.svg/page", "old.svg/page: cannot be written: there is no folder old.svg"),
        ("part.toml", "part.toml: is the input file"),
    ] {
        for [option, other] in [["--svg", "--report"], ["--report", "--svg"]] {
            let written = format!("{option} {path} {other} old.svg");
            let ran = folder.run(&format!("optimize part.toml --fingers 4 {written}"));
            assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{written}");
            assert!(ran.err.contains(piece), "{piece}: {}", ran.err);
        }
    }
    for name in ["old.svg", "locked.svg"] {
        assert_eq!(fs::read_to_string(folder.path(name)).unwrap(), "old");
    }
    assert_eq!(folder.names(), ["folder.svg", "locked.svg", "old.svg", "part.toml"]);
    let line = "optimize part.toml --fingers 4 --report none/page --format json";
    let error = folder.run(line).err.parse::<Value>().unwrap();
    assert_eq!(error["error"]["kind"].as_str(), Some("file"));
}

/// A search without an answer has nothing better to show than what is there.
#[test]
fn without_an_answer_pictures_and_pages_of_before_are_kept() {
    let folder = quadrilateral("kept-unanswered");
    let square = "[[0, 0], [4, 0], [4, 4], [0, 4]]";
    folder.write("square.toml", part(square, "1")).write("cube.toml", CUBE);
    folder.write("picture.svg", "old").write("page.html", "old");
    let written = "--svg picture.svg --report page.html";
    for question in ["square.toml --fingers 3 --preload 1", "cube.toml --fingers 7"] {
        let ran = folder.run(&format!("optimize {question} {written}"));
        assert_eq!((ran.code, ran.out.as_str()), (Some(3), ""), "{question}: {}", ran.err);
        for name in ["picture.svg", "page.html"] {
            assert_eq!(fs::read_to_string(folder.path(name)).unwrap(), "old", "{question}");
        }
    }
}

/// Standard output has the report.
#[test]
fn a_dash_is_no_file_to_write() {
    let folder = quadrilateral("dash-written");
    for option in ["--svg", "--report"] {
        let ran = folder.run(&format!("optimize part.toml --fingers 4 {option} -"));
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""), "{option}");
        let expected = "found `-`, expected the name of a file: standard output has the report";
        assert!(ran.err.contains(&format!("{option}: {expected}")), "{}", ran.err);
    }
    assert_eq!(folder.names(), ["part.toml"]);
    assert_eq!(folder.run("optimize part.toml --fingers 4 --svg ./-").code, Some(0));
    assert_eq!(folder.names(), ["-", "part.toml"]);
}

#[test]
fn bad_input_leaves_the_picture_of_before() {
    let folder = Folder::new("kept");
    folder.write("part.toml", "[part]\n").write("picture.svg", "old");
    let ran = folder.run("optimize part.toml --fingers 4 --svg picture.svg");
    assert_eq!(ran.code, Some(1));
    assert_eq!(fs::read_to_string(folder.path("picture.svg")).unwrap(), "old");
}

#[test]
fn a_reader_that_has_gone_is_no_failure() {
    let folder = quadrilateral("pipe");
    let mut child = command(["optimize", "part.toml", "--fingers", "4"])
        .current_dir(folder.path(""))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let ran = Ran::new(&child.wait_with_output().unwrap());
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
}

#[test]
fn a_dash_reads_standard_input() {
    let folder = quadrilateral("dash");
    let optimum = folder.run("optimize part.toml --fingers 4 --format json");
    let mut child = command(["analyze", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(optimum.out.as_bytes()).unwrap();
    let ran = Ran::new(&child.wait_with_output().unwrap());
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert!(ran.out.contains("standard input, 4 contacts"), "{}", ran.out);
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let folder = quadrilateral("repeat");
    let runs = [(); 3].map(|()| folder.run("optimize part.toml --fingers 4 --format json").out);
    assert!(runs[0] == runs[1] && runs[1] == runs[2]);
}

#[test]
fn help_shows_files_and_examples() {
    let folder = Folder::new("help");
    for arguments in ["--help", "analyze --help", "optimize --help"] {
        let ran = folder.run(arguments);
        assert_eq!(ran.code, Some(0));
        assert!(ran.out.contains("[part.planar]"), "{arguments}");
        assert!(ran.out.contains("shanks and clamps behind them are not checked"), "{arguments}");
        assert!(ran.out.contains("clench optimize bracket.toml --fingers 4"), "{arguments}");
    }
}

#[test]
fn an_ellipse_is_drawn_with_fingers_of_every_curvature() {
    let folder = Folder::new("ellipse-picture");
    let contacts = [
        ("[4, 0]", "radius = 1", 0.01),
        ("[-4, 0]", "radius = 0", 0.01),
        ("[0, 2]", "curvature = 0", 0.1),
        ("[0, -2]", "curvature = -0.1", 0.1),
    ]
    .map(|(point, finger, preload)| {
        let finger = format!("finger = {{ {finger} }}\npreload = {preload}");
        format!("[[contacts]]\npoint = {point}\n{finger}\n")
    });
    let part = "[part.planar]\nellipse = [4, 2]\nstiffness = 3\n";
    folder.write("grasp.toml", part.to_owned() + &contacts.concat());
    let ran = folder.run("analyze grasp.toml --svg picture.svg");
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    let svg = fs::read_to_string(folder.path("picture.svg")).unwrap();
    // There are no corners to number.
    for piece in ["F0 at (4, 0) L", "F3: 0.1 F", "Q = ", "σ"] {
        assert!(svg.contains(piece), "{piece} is missing");
    }
    assert!(!svg.contains("corner") && !svg.contains("edge"), "{svg}");
}
