//! Bad input: exit code 1, the place and what is wrong in the message, nothing written.

use crate::run::{Folder, QUADRILATERAL, Ran, assert_says, part};

/// Runs `optimize` on a bad file; returns the message.
fn refused(name: &str, file: &str, content: impl AsRef<[u8]>) -> String {
    let folder = Folder::new(&format!("hostile-{name}"));
    folder.write(file, content);
    let ran = folder.run(&format!("optimize {file} --fingers 4 --svg picture.svg"));
    assert_eq!(folder.names(), [file], "{name}");
    message(&ran, name)
}

fn message(ran: &Ran, name: &str) -> String {
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{name}: {}", ran.err);
    ran.err.clone()
}

#[test]
fn outlines_that_enclose_nothing() {
    for (name, outline, pieces) in [
        ("one-point", "[[0, 0]]", ["outline: ", "found 1 corner,", "at least 3"]),
        ("no-point", "[]", ["outline: ", "found 0 corners,", "at least 3"]),
        ("line", "[[0, 0], [1, 1], [2, 2]]", ["outline: ", "all 3 corners", "one line"]),
        ("repeated", "[[0, 0], [4, 0], [4, 0], [0, 3]]", ["outline[2]", "corners 1 and 2", "same"]),
        ("closed", "[[0, 0], [4, 0], [0, 3], [0, 0]]", ["outline[0]", "3 and 0", "by itself"]),
        (
            "touching",
            "[[0, 0], [4, 0], [2, 2], [4, 4], [0, 4], [2, 2]]",
            ["outline[5]", "corners 2 and 5", "touch itself"],
        ),
        ("crossing", "[[0, 0], [4, 4], [4, 0], [0, 3]]", ["outline[2]", "edges 0 and 2", "cross"]),
        ("huge", "[[0, 0], [1e200, 0], [0, 3]]", ["outline[1]", "1e200", "larger unit"]),
    ] {
        let message = refused(name, "part.toml", part(outline, "1"));
        assert_says(&message, &["part.toml:2:", "part.planar."]);
        assert_says(&message, &pieces);
    }
}

#[test]
fn numbers_that_are_none() {
    for (name, outline, pieces) in [
        ("nan", "[[0, 0], [nan, 0], [0, 3]]", ["part.toml:2:21: ", "outline[1][0]", "NaN"]),
        ("inf", "[[0, 0], [4, 0], [0, -inf]]", ["part.toml:2:32: ", "outline[2][1]", "-inf"]),
        ("overflow", "[[0, 0], [4, 1e999], [0, 3]]", ["part.toml:2:24: ", "outline[1][1]", "inf"]),
        (
            "text",
            "[[0, 0], [4, \"0\"], [0, 3]]",
            ["part.toml:2:24: ", "outline[1][1]", "text `0`, expected"],
        ),
        ("three", "[[0, 0], [4, 0, 0], [0, 3]]", ["part.toml:2:20: ", "outline[1]", "[x, y]"]),
        ("flat", "[0, 0, 4, 0, 0, 3]", ["part.toml:2:12: ", "outline[0]", "[x, y]"]),
        ("date", "2020-01-01", ["part.toml:2:11: ", "part.planar.outline", "date"]),
    ] {
        assert_says(&refused(name, "part.toml", part(outline, "1")), &pieces);
    }
    let outline = "[[0, 0], [4, 1e999], [0, 3]]";
    let json =
        format!("{{\"part\": {{\"planar\": {{\"outline\": {outline}, \"stiffness\": 1}}}}}}");
    let message = refused("json-overflow", "part.json", json);
    assert_says(&message, &["part.json:1:46: ", "part.planar.outline[1][1]", "finite number"]);
}

#[test]
fn stiffnesses_that_are_none() {
    for (name, stiffness, pieces) in [
        ("zero", "0", ["stiffness: ", "stiffness of edge or face 0 is 0", "positive"]),
        ("negative", "[1, 1, -2, 1]", ["stiffness[2]: ", "edge or face 2 is -2", "positive"]),
        ("few", "[1, 1, 1]", ["stiffness: ", "3 stiffnesses", "4 edges"]),
        ("many", "[1, 1, 1, 1, 1]", ["stiffness: ", "5 stiffnesses", "4 edges"]),
        ("infinite", "inf", ["stiffness: ", "inf", "finite number"]),
        ("not-a-number", "[1, nan, 1, 1]", ["stiffness[1]: ", "NaN", "finite number"]),
        ("word", "\"stiff\"", ["stiffness: ", "text `stiff`", "list of one per edge"]),
    ] {
        let message = refused(name, "part.toml", part(QUADRILATERAL, stiffness));
        assert_says(&message, &["part.toml:3:", "part.planar."]);
        assert_says(&message, &pieces);
    }
}

#[test]
fn fields_that_are_wrong() {
    let sound = part(QUADRILATERAL, "1");
    let cavities = format!("{sound}cavities = []\n");
    let typo = format!("colour = 1\n{sound}");
    for (name, content, pieces) in [
        (
            "cavities",
            cavities.as_str(),
            ["part.toml:4:1: ", "part.planar.cavities", "unknown field `cavities`"],
        ),
        ("typo", &typo, ["part.toml:1:1: ", "colour", "expected one of"]),
        (
            "no-part",
            "version = 1\n",
            ["part.toml:1:1", "missing field `part`, expected a table with `planar`", ""],
        ),
        ("bare", "[part]\n", ["part.toml:1:1: part: ", "`planar`", "expected"]),
        (
            "missing",
            "[part.planar]\noutline = []\n",
            ["part.planar: ", "`stiffness`, expected a positive number, or a list", "1:1"],
        ),
        ("version", "version = 2\n[part]\n", ["part.toml:1:11: version", "found", "expected 1"]),
        ("half", "version = 1.5\n[part]\n", ["part.toml:1:11: version", "1.5", "whole number"]),
        (
            "units",
            "units = { length = \"\" }\n[part]\n",
            ["units.length", "\"\"", "name of a unit"],
        ),
        (
            "unit",
            "units = { length = \"mm\" }\n[part]\n",
            ["1:9: units", "missing", "`force`, expected the name of a unit"],
        ),
        ("no-table", "part = 3.0\n", ["1:8: part: found a number,", "table with `planar`", ""]),
        ("list", "[[part]]\n", ["part: found a list,", "expected a table with `planar`", ""]),
        ("no-list", "contacts = 1\n[part]\n", ["contacts: found a number", "expected a list", ""]),
        ("flag", "[part]\nplanar = true\n", ["part.planar: found true,", "`outline`", "table"]),
        (
            "spatial",
            "[part.spatial]\nmesh = \"a\"\n",
            ["part.spatial.mesh: a: ", "not known by its ending", ".stl or .obj"],
        ),
        (
            "mesh",
            "[part.spatial]\nmesh = 1\n",
            ["part.toml:2:8: part.spatial.mesh: ", "found a number", "name of a file"],
        ),
        (
            "ellipse",
            "[part.planar]\nellipse = [2, 1]\n",
            ["part.planar: ", "found no `outline`", "places fingers on outlines only"],
        ),
        ("syntax", "[part.planar\n", ["part.toml:1:", "not valid TOML", ""]),
        ("empty", " \n", ["part.toml:1:1", "is empty", "expected a part"]),
    ] {
        assert_says(&refused(name, "part.toml", content), &pieces);
    }
}

/// The path of a misspelled field, however far out on its line it is, and little of the line.
#[test]
fn a_fault_far_out_on_a_line_is_shown_in_a_window() {
    let corners = vec!["[123456.5, 0]"; 15_000].join(", ");
    let start = format!("{{\"part\": {{\"planar\": {{\"outline\": [{corners}], ");
    assert!(start.len() > 200_000);
    for (name, rest) in [("json-long", "\"stifness\": 1}}}"), ("json-wide", "\"é\": \"ééé\"}}}")]
    {
        let message = refused(name, "part.json", format!("{start}{rest}"));
        let place = format!("part.json:1:{}: part.planar", start.len() + 2);
        assert_says(&message, &[&place, "unknown field", "…", "here"]);
        assert!(message.len() < 1000, "{}: {message}", message.len());
    }
    // The fault itself may be long.
    let long = format!("{{\"part\": {{\"planar\": [{corners}], \"more\": 1}}}}");
    let message = refused("json-long-list", "part.json", long);
    assert_says(&message, &["part.json:1:21: part.planar: found a list", "…"]);
    assert!(message.len() < 1000, "{}: {message}", message.len());
}

/// A plain file may not have what only the reports of `optimize` have.
#[test]
fn results_outside_of_a_report_are_refused() {
    let sound = part(QUADRILATERAL, "1");
    for (name, line, help) in [
        ("finger-radius", "finger_radius = 1", "finger = { radius = .. }"),
        ("total-preload", "total_preload = 1", "--preload"),
        ("fingers", "fingers = 4", "--fingers"),
        ("reach", "reach = 1", "expected one of"),
        ("certificate", "certificate = { proved = true }", "expected one of"),
    ] {
        let message = refused(name, "part.toml", format!("{line}\n{sound}"));
        assert_says(&message, &["part.toml:1:1: ", "unknown field", help]);
    }
    let contact = "[[contacts]]\npoint = [6.5, 0]\nshare = 0.5\n";
    let message = refused("share", "part.toml", sound + contact);
    assert_says(&message, &["part.toml:6:1: contacts[0].share", "unknown field `share`"]);
}

#[test]
fn json_that_is_none() {
    let deep = format!("{{\"part\": {}{}}}", "[".repeat(60), "]".repeat(60));
    for (name, content, pieces) in [
        ("json-syntax", "{\"part\":\n  {,}}", ["part.json:2:4: ", "not valid JSON", ""]),
        ("json-nan", "{\"part\": NaN}", ["part.json:1:10: ", "not valid JSON", ""]),
        ("json-open", "{\"part\": {", ["part.json:1:1", "not valid JSON", "EOF"]),
        ("json-twice", "{\"part\": 1, \"part\": 2}", ["part.json:1:14", "`part`", "twice"]),
        ("json-deep", &deep, ["part.json:1:", "nested", "32"]),
        ("json-empty", "", ["part.json:1:1", "is empty", ""]),
    ] {
        assert_says(&refused(name, "part.json", content), &pieces);
    }
}

#[test]
fn files_that_are_none() {
    let folder = Folder::new("no-files");
    let missing = message(&folder.run("optimize none.toml --fingers 4"), "missing");
    assert_says(&missing, &["none.toml: cannot be read", "No such file"]);
    let directory = message(&folder.run("optimize . --fingers 4"), "directory");
    assert_says(&directory, &[".: cannot be read", "directory", "expected a TOML or JSON file"]);
    let bytes = refused("bytes", "part.toml", b"part = \"\xff\"");
    assert_says(&bytes, &["part.toml: byte 8 is not UTF-8"]);
}

/// Devices and pipes have no size; no more is read of them than of the largest file.
#[test]
fn files_without_an_end_are_refused() {
    let folder = Folder::new("hostile-endless");
    let most = 1 << 25;
    let words = format!("has more than {most} bytes, the size of the largest file that is read");
    let large = std::fs::File::create(folder.path("large.toml")).unwrap();
    large.set_len(most + 1).unwrap();
    let mut lines = vec!["analyze large.toml", "optimize large.toml --fingers 4"];
    if cfg!(unix) {
        lines.push("analyze /dev/zero");
    }
    for line in lines {
        let ran = folder.run(line);
        assert_says(&message(&ran, line), &[&words]);
    }
    large.set_len(most).unwrap();
    assert!(!message(&folder.run("analyze large.toml"), "largest").contains(&words));
    let error = folder.run("analyze /dev/zero --format json").err;
    assert_says(&error, &["\"kind\":\"file\""]);
}

#[test]
fn wrong_usage_has_its_own_exit_code() {
    let folder = Folder::new("usage");
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    for (arguments, piece) in [
        ("optimize part.toml", "--fingers"),
        ("optimize part.toml --fingers 2", "found 2, expected from 3 to 8 on an outline"),
        ("optimize part.toml --fingers 9", "found 9, expected from 3 to 8 on an outline"),
        ("optimize part.toml --fingers four", "found four, expected from 3 to 8 on an outline"),
        ("optimize part.toml --fingers 0", "found 0, expected from 3 to 8 on an outline"),
        ("optimize part.toml --fingers 3", "--preload <F>"),
        ("optimize part.toml --fingers 3", "resist rotation by their preload alone"),
        ("optimize part.toml --fingers 4 --preload -1", "expected more than 0"),
        ("optimize part.toml --fingers 4 --preload nan", "expected a finite number"),
        ("optimize part.toml --fingers 4 --finger-radius -1", "expected 0 or more"),
        ("optimize part.toml --fingers 4 --top 0", "found 0, expected 1 or more"),
        ("optimize part.toml --fingers 4 --top x", "found x, expected 1 or more"),
        ("analyze part.toml --frame 1,2", "found 2 numbers, expected three"),
        ("analyze part.toml --frame 1,2,inf", "expected a finite number"),
        ("measure part.toml", "measure"),
    ] {
        let ran = folder.run(arguments);
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""), "{arguments}");
        assert_says(&ran.err, &[piece]);
    }
}
