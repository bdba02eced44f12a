//! The examples of the documents run as they stand.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use clench_testkit::cases::Value;

use crate::run::Folder;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn document(path: &str) -> String {
    fs::read_to_string(Path::new(ROOT).join(path)).unwrap()
}

/// The contents of the code blocks of a language.
fn blocks<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    let fence = format!("```{language}\n");
    text.split(&fence).skip(1).map(|rest| rest.split("```").next().unwrap()).collect()
}

/// A folder with the example parts of the repository.
fn with_parts(name: &str) -> Folder {
    let folder = Folder::new(name);
    fs::create_dir(folder.path("parts")).unwrap();
    for entry in fs::read_dir(Path::new(ROOT).join("parts")).unwrap() {
        let entry = entry.unwrap();
        fs::copy(entry.path(), folder.path("parts").join(entry.file_name())).unwrap();
    }
    folder
}

#[test]
fn the_commands_of_the_readme_find_an_answer() {
    let readme = document("README.md");
    let folder = with_parts("readme");
    let mut ran = 0;
    for line in blocks(&readme, "sh").into_iter().flat_map(str::lines) {
        let arguments = line.strip_prefix("cargo run -- ").or(line.strip_prefix("clench "));
        if let Some(arguments) = arguments {
            let result = folder.run(arguments);
            assert_eq!((result.code, result.err.as_str()), (Some(0), ""), "{line}");
            ran += 1;
        }
    }
    assert_eq!(ran, 9);
    for (drawn, kept) in
        [("bracket.svg", "docs/bracket.svg"), ("clamps.svg", "docs/guide/clamps.svg")]
    {
        let drawn = fs::read_to_string(folder.path(drawn)).unwrap();
        let mend = "mend: the README's command, with this file after --svg";
        assert!(drawn == document(kept), "{kept} is stale; {mend}");
    }
}

#[test]
fn the_files_of_the_page_on_files_are_read() {
    let page = document("docs/files.md");
    let files = blocks(&page, "toml");
    assert_eq!(files.len(), 6);
    let folder = Folder::new("files-page");
    folder.write("plate.dxf", document("parts/plate.dxf"));
    folder.write("part.toml", files[0]);
    assert_eq!(folder.run("optimize part.toml --fingers 4").code, Some(0));
    folder.write("part.toml", files[1]);
    let drawn = folder.run("optimize part.toml --fingers 4");
    assert_eq!(drawn.code, Some(0), "{}", drawn.err);
    let command = "optimize plate.dxf --fingers 4 --stiffness 5e4 --units mm";
    assert!(page.replace('\n', " ").contains(command));
    assert_eq!(folder.run(command).code, Some(0));
    for (file, stable) in [
        (files[2], "stable to first order"),
        (files[5], "robustness: change of the measures"),
        (files[3], "by its preload"),
        (files[4], "contact 1 lifts off first"),
    ] {
        folder.write("grasp.toml", file);
        let grasp = folder.run("analyze grasp.toml");
        assert_eq!((grasp.code, grasp.err.as_str()), (Some(0), ""));
        assert!(grasp.out.contains(stable), "{}", grasp.out);
    }
    // The head of the last one is shown.
    let text = folder.run("analyze grasp.toml").out;
    assert!(text.contains(blocks(&page, "text")[0]), "{text}");
}

/// The pinched bar of the guide has the numbers of the text.
#[test]
fn the_file_of_the_guide_is_read_and_is_not_stable() {
    let page = document("docs/guide/stiffness.md");
    let files = blocks(&page, "toml");
    assert_eq!(files.len(), 1);
    let folder = Folder::new("guide");
    folder.write("grasp.toml", files[0]);
    let grasp = folder.run("analyze grasp.toml");
    assert_eq!(grasp.code, Some(3));
    for number in ["0.00277514", "27025.7", "-5.88331", "176.467", "pushed away along (0, 1, 0)"] {
        assert!(grasp.out.contains(number), "{number} in {}", grasp.out);
    }
}

/// The indented lines of the help after a line that starts with `title`, up to the next text.
fn indented<'a>(help: &'a str, title: &str) -> Vec<&'a str> {
    let lines = help.lines().skip_while(|line| !line.starts_with(title)).skip(1);
    lines.take_while(|line| line.is_empty() || line.starts_with("  ")).collect()
}

/// The grasp of the help, as it stands and with each of the alternatives in its comments.
#[test]
fn the_files_of_the_help_are_read() {
    let folder = Folder::new("help-files");
    let help = folder.run("analyze --help").out;
    let part = indented(&help, "A part file").join("\n");
    let grasp = indented(&help, "A grasp file");
    let (comments, given): (Vec<&str>, Vec<&str>) =
        grasp.into_iter().partition(|line| line.starts_with("  # "));
    let mut files = vec![given.join("\n")];
    // In the plane, a finger of two curvatures is none.
    for comment in comments.iter().filter(|line| !line.contains("curvatures")) {
        let other = comment.replacen("# ", "", 1);
        let field = |line: &str| line.split_whitespace().next().unwrap_or("").to_owned();
        let named = |name: &str| given.iter().position(|line| field(line) == name);
        let mut lines = given.clone();
        // An inward normal is instead of an edge.
        lines[named(&field(&other)).or(named("edge")).unwrap()] = &other;
        files.push(lines.join("\n"));
    }
    assert_eq!(files.len(), 5);
    for kind in ["linear", "power", "hertz", "line", "inward_normal"] {
        assert!(files.iter().any(|file| file.contains(kind)), "{kind}");
    }
    for file in files {
        folder.write("grasp.toml", format!("{part}\n{file}\n"));
        let ran = folder.run("analyze grasp.toml");
        // One finger does not hold the part.
        assert_eq!(ran.code, Some(3), "{file}: {}", ran.err);
        assert!(ran.out.contains("preloads and loads balance"), "{}", ran.out);
    }
}

/// Each key that the page lists is in the report, and the other way round.
#[test]
fn the_keys_of_the_reports_are_those_of_the_page() {
    let page = document("docs/files.md");
    let listed = |titles: &[&str]| -> BTreeSet<String> {
        let tables = titles.iter().map(|title| page.split(title).nth(1).unwrap());
        let rows = tables.flat_map(|table| table.split("\n\n").next().unwrap().lines().skip(2));
        let cells = rows.map(|row| row.split(" | ").next().unwrap());
        let names = cells.flat_map(|cell| cell.split('`').skip(1).step_by(2));
        names.map(str::to_owned).collect()
    };
    let keys = |report: &Value| -> BTreeSet<String> {
        report.as_object().unwrap().keys().cloned().collect()
    };
    let folder = with_parts("keys");
    let analyze = "| key of `analyze`";
    let planar = folder.json("analyze parts/quadrilateral-grasp.toml");
    assert_eq!(keys(&planar), listed(&[analyze, "| in the plane | value"]));
    let spatial = folder.json("analyze parts/cube-grasp.toml");
    let mut found = keys(&spatial);
    for of_load_cases in ["load_cases", "verdict", "needed_preloads"] {
        assert!(found.remove(of_load_cases), "{of_load_cases}");
    }
    assert_eq!(found, listed(&[analyze, "| in space | value"]));
    // The contacts lift off under more than the load.
    assert_eq!(keys(&spatial["load_cases"][0]), listed(&["| key of a load case"]));
    folder.write("off.toml", blocks(&page, "toml")[5]);
    let robustness = &folder.json("analyze off.toml")["robustness"];
    let mut found = keys(robustness);
    found.extend(keys(&robustness["quality"]));
    found.insert("missing".to_owned());
    assert_eq!(found, listed(&["| key of `robustness`"]));
    let optimum =
        folder.json("optimize parts/quadrilateral.toml --fingers 4 --preload 0.8 --top 2");
    let optimize = "| key of `optimize`";
    assert_eq!(keys(&optimum), listed(&[optimize, "| of an outline | value"]));
    let solid = folder.json(
        "optimize parts/bearing-block.toml --fix parts/locators-321.toml \
         --candidates parts/clamp-places.toml --fingers 2 --preload 1 --top 2",
    );
    assert_eq!(keys(&solid), listed(&[optimize, "| of a solid | value"]));
    let tips = folder.json(
        "optimize parts/bearing-block.toml --fix parts/locators-321.toml --fingers 3 --nodes 1 \
         --finger-radius 4 --clearance 1",
    );
    let more: BTreeSet<String> = keys(&tips).difference(&keys(&solid)).cloned().collect();
    assert_eq!(more, listed(&["| where fingers need room | value"]));
}
