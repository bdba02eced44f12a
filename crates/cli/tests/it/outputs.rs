//! What is written: pictures all or nothing, reports to whoever reads them.

use std::fs;
use std::io::Write;
use std::process::Stdio;

use crate::run::{Folder, QUADRILATERAL, Ran, command, figure_1, part};

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
fn a_picture_that_cannot_be_written_leaves_what_is_there_and_the_report() {
    let folder = quadrilateral("unwritable");
    folder.write("old.svg", "old");
    let mut locked = fs::metadata(folder.path("old.svg")).unwrap().permissions();
    locked.set_readonly(true);
    fs::set_permissions(folder.path("old.svg"), locked).unwrap();
    fs::create_dir(folder.path("folder.svg")).unwrap();
    for (path, piece) in [
        ("old.svg", "old.svg: cannot be written"),
        ("folder.svg", "folder.svg: cannot be written: is a directory"),
        ("none/picture.svg", "none/picture.svg: cannot be written"),
        ("part.toml", "part.toml: is the input file"),
    ] {
        let ran = folder.run(&format!("optimize part.toml --fingers 4 --svg {path}"));
        // A search may have taken long: its answer is not lost.
        let reported = ran.out.contains("Q = 1.68377");
        assert_eq!((ran.code, reported), (Some(1), path != "part.toml"), "{path}");
        assert!(ran.err.contains(piece), "{piece}: {}", ran.err);
    }
    assert_eq!(fs::read_to_string(folder.path("old.svg")).unwrap(), "old");
    assert_eq!(folder.names(), ["folder.svg", "old.svg", "part.toml"]);
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
