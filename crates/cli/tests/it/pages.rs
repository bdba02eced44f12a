//! Pages for a browser: what is on them, that nothing of a file is taken for markup, and that they
//! are written all or nothing.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fs;

use crate::run::{Folder, QUADRILATERAL, assert_says, figure_1, part};

/// A square on four springs, with a load case.
const SQUARE: &str = "[part.planar]\noutline = [[0, 0], [20, 0], [20, 20], [0, 20]]\n\
    stiffness = 2000\n[[contacts]]\npoint = [7, 0]\npreload = 10\n[[contacts]]\n\
    point = [20, 13]\npreload = 10\n[[contacts]]\npoint = [13, 20]\npreload = 10\n[[contacts]]\n\
    point = [0, 7]\npreload = 10\n[[load_cases]]\nname = \"NAME\"\nforce = [-4, 1]\n\
    point = [20, 16]\ntorque = 15\ntolerance = 0.02\n[[points]]\nname = \"POINT\"\n\
    point = [12, 14]\n";

/// Markup, the ends of what a browser reads as text or as a script, and a comment's start.
const HOSTILE: &str = "</script></pre></title><script>alert('x')</script><!--<img src=x onerror=y>";

fn page(folder: &Folder, arguments: &str) -> String {
    let ran = folder.run(&format!("{arguments} --report page.html"));
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{arguments}");
    fs::read_to_string(folder.path("page.html")).unwrap()
}

/// Asserts that a page is whole and asks no host for anything.
fn assert_sound(page: &str) {
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</body></html>"));
    assert!(page.contains("content=\"default-src 'none';"), "{}", &page[..400]);
    // Names of namespaces are no addresses.
    let rest = page.replace("http://www.w3.org/2000/svg", "");
    let rest = rest.replace("http://www.w3.org/1999/xhtml", "");
    let scripts = rest.find("<script").unwrap_or(rest.len());
    for asking in ["http:", "https:", "@import", "<link", "<iframe", "<object"] {
        assert!(!rest.contains(asking), "{asking} is on the page");
    }
    for asking in ["src=", "url("] {
        assert!(!rest[..scripts].contains(asking), "{asking} is on the page");
    }
}

#[test]
fn a_placement_is_on_the_page_with_its_numbers_proof_and_inputs() {
    let folder = Folder::new("page-optimize");
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    let page = page(&folder, "optimize part.toml --fingers 4 --preload 2 --top 2");
    assert_sound(&page);
    assert_says(
        &page,
        &[
            "<h1>part.toml</h1>",
            "lengths in L, forces in F, angles in rad",
            "<i>Q</i> = 1.68377 F/L, limited by translation",
            "proved best",
            "no placement of four fingers on this outline does better",
            "<i>σ</i><sub>min</sub>",
            "on no other combination is a placement better than the last",
            "clench optimize part.toml --fingers 4 --preload 2 --top 2 --report page.html",
            "outline = [[0, 0], [13, 0], [9, 8], [2, 6]]",
        ],
    );
}

#[test]
fn a_grasp_is_on_the_page_with_its_load_cases() {
    let folder = Folder::new("page-analyze");
    let grasp = SQUARE.replace("NAME", "milling").replace("POINT", "bore");
    folder.write("grasp.toml", grasp);
    let page = page(&folder, "analyze grasp.toml");
    assert_sound(&page);
    // The numbers are those of the text report.
    let text = folder.run("analyze grasp.toml").out;
    for number in ["0.0104687", "1.64995", "361.999"] {
        assert!(text.contains(number) && page.contains(number), "{number}");
    }
    assert_says(
        &page,
        &[
            "load case 0 (milling)",
            "displacement drawn 200 times as large",
            "<td>bore</td>",
            "the part turns by",
        ],
    );
}

#[test]
fn robustness_is_on_the_page_if_it_is_asked_for() {
    let folder = Folder::new("page-robustness");
    folder.write("grasp.toml", SQUARE);
    let asked = page(&folder, "analyze grasp.toml --robustness");
    assert_says(&asked, &["<h2>Robustness</h2>"]);
    assert!(!page(&folder, "analyze grasp.toml").contains("<h2>Robustness</h2>"));
}

#[test]
fn nothing_of_a_file_is_taken_for_markup() {
    let folder = Folder::new("page-hostile");
    let quoted = HOSTILE.replace('"', "\\\"");
    let grasp = SQUARE.replace("NAME", &quoted).replace("POINT", &quoted);
    let units = format!("units = {{ length = \"{quoted}\", force = \"{quoted}\" }}\n");
    folder.write("grasp<img>.toml", units + "# " + HOSTILE + "\n" + &grasp);
    let page = page(&folder, "analyze grasp<img>.toml --frame 1,2,0.5");
    for markup in ["<img", "<script>alert", "</script></pre>", "<!--"] {
        assert!(!page.contains(markup), "{markup} is on the page");
    }
    assert_says(&page, &["<h1>grasp&lt;img&gt;.toml</h1>", "&lt;script&gt;alert("]);
}

/// A cube held by seven balls, with two load cases.
fn cube() -> String {
    let file =
        fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../parts/cube-grasp.toml"));
    file.unwrap()
}

#[test]
fn a_solid_has_a_view_that_turns_and_a_picture_for_print() {
    let folder = Folder::new("page-solid");
    folder.write("cube.toml", cube());
    let page = page(&folder, "analyze cube.toml");
    assert_sound(&page);
    let scene = page.split("<script id=\"scene\" type=\"application/json\">").nth(1).unwrap();
    let scene = scene.split("</script>").next().unwrap();
    let scene: clench_testkit::cases::Value = scene.parse().unwrap();
    // Eight corners, two triangles a side, and what holds them.
    let count = |key: &str| scene[key].as_array().unwrap().len();
    let counts = ["positions", "triangles", "fingers", "axes", "cases"].map(count);
    assert_eq!(counts, [24, 36, 7, 3, 2]);
    assert_says(&page, &["<canvas", "displacement drawn 2000 times as large", "<svg"]);
    assert!(page.matches("<svg").count() == 3, "one picture at rest and one of each load case");
}

#[test]
fn a_scene_is_not_broken_by_names() {
    let folder = Folder::new("page-hostile-solid");
    let units = format!("force = \"{HOSTILE}\"");
    let file =
        cube().replace("force = \"N\"", &units).replace("\"drilling\"", &format!("{HOSTILE:?}"));
    assert!(file.contains(HOSTILE));
    // Names of materials would need units of known size.
    let lines = file.lines().filter(|line| !line.starts_with("law"));
    let file = lines.collect::<Vec<_>>().join("\n");
    let file = file.replace("[part.spatial]", "[part.spatial]\nstiffness = 3e4");
    folder.write("cube.toml", file);
    let page = page(&folder, "analyze cube.toml");
    for markup in ["<img", "<script>alert", "</script></pre>", "<!--"] {
        assert!(!page.contains(markup), "{markup} is on the page");
    }
    // The scene and the two scripts of the page itself.
    assert_eq!((page.matches("<script").count(), page.matches("</script").count()), (3, 3));
}

#[test]
fn the_best_placements_have_small_pictures() {
    let folder = Folder::new("page-top");
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    let page = page(&folder, "optimize part.toml --fingers 4 --top 3");
    assert_eq!(page.matches("<svg").count(), 4);
    assert_says(&page, &["1: <i>Q</i> = 1.68377 F/L", "2: <i>Q</i>", "3: <i>Q</i>"]);
    // Well below 100 kB.
    assert!(page.len() < 50_000, "{}", page.len());
}

#[test]
fn the_same_input_gives_the_same_page() {
    let folder = Folder::new("page-repeat");
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    let pages = [(); 2].map(|()| page(&folder, "optimize part.toml --fingers 4 --preload 2"));
    assert!(pages[0] == pages[1]);
}

#[test]
fn a_page_is_written_where_there_is_something_to_show() {
    let folder = Folder::new("page-unanswered");
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    // Three contacts leave the part free to turn; the contacts are worth showing.
    let free = figure_1().rsplit_once("[[contacts]]").unwrap().0.to_owned();
    folder.write("free.toml", free);
    let ran = folder.run("analyze free.toml --report free.html");
    assert_eq!(ran.code, Some(3), "{}", ran.err);
    let page = fs::read_to_string(folder.path("free.html")).unwrap();
    assert_says(
        &page,
        &["no answer", "no preload of these contacts balances", "<h2>Contacts</h2>"],
    );
    let ran = folder.run("optimize part.toml --fingers 4 --least-share 0.24 --report none.html");
    assert_eq!(ran.code, Some(3), "{}", ran.err);
    let ran = folder.run("optimize part.toml --fingers 9 --report none.html");
    assert_eq!(ran.code, Some(2), "{}", ran.err);
    assert_eq!(folder.names(), ["free.html", "free.toml", "part.toml"]);
}

#[test]
fn a_page_overwrites_no_input_and_no_picture() {
    let folder = Folder::new("page-apart");
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    let ran = folder.run("optimize part.toml --fingers 4 --report ./part.toml");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""));
    assert_says(&ran.err, &["./part.toml: is the input file; expected another name"]);
    let ran = folder.run("optimize part.toml --fingers 4 --report one --svg one");
    assert_eq!(ran.code, Some(2));
    assert_says(&ran.err, &["--svg and --report have the same file, expected one each"]);
    let ran = folder.run("optimize part.toml --fingers 4 --report one --svg ./one");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""));
    assert_says(&ran.err, &["one: cannot be written"]);
    let ran = folder.run("optimize part.toml --fingers 4 --report none/page.html");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""));
    assert_says(&ran.err, &["none/page.html: cannot be written"]);
    assert_eq!(folder.names(), ["part.toml"]);
}
