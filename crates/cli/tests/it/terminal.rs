//! The command beside its reports: completions, help, and errors for programs.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::collections::BTreeSet;
use std::process::Command;

use clench_testkit::cases::{Value, list};

use crate::run::{Folder, QUADRILATERAL, Ran, assert_says, part};

/// The options of a help.
fn listed(help: &str) -> BTreeSet<String> {
    let lines = help.lines().filter(|line| line.trim_start().starts_with("--"));
    lines.filter_map(|line| line.split_whitespace().next().map(str::to_owned)).collect()
}

#[test]
fn completions_are_scripts_that_name_all_options() {
    let folder = Folder::new("completions");
    let wanted: BTreeSet<String> = ["analyze", "optimize"]
        .into_iter()
        .flat_map(|command| listed(&folder.run(&format!("{command} -h")).out))
        .collect();
    assert!(wanted.contains("--check") && wanted.contains("--least-share"), "{wanted:?}");
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let ran = folder.run(&format!("completions {shell}"));
        assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{shell}");
        let missing = wanted.iter().filter(|option| match shell {
            "fish" => !ran.out.contains(&format!("-l {}", &option[2..])),
            _ => !ran.out.contains(option.as_str()),
        });
        assert_eq!(missing.count(), 0, "{shell}: {}", ran.out);
        folder.write(shell, &ran.out);
    }
    if let Ok(status) = Command::new("bash").arg("-n").arg(folder.path("bash")).status() {
        assert!(status.success());
    }
    let unknown = folder.run("completions tcsh");
    assert_eq!(unknown.code, Some(2));
    assert_says(&unknown.err, &["tcsh", "bash", "powershell"]);
}

#[test]
fn long_help_has_examples_of_its_own_command_and_short_help_none() {
    let folder = Folder::new("help");
    for (command, other) in [("analyze", "optimize"), ("optimize", "analyze")] {
        let long = folder.run(&format!("{command} --help")).out;
        assert_says(&long, &[&format!("Examples of {command}:\n  clench {command} ")]);
        assert!(!long.contains(&format!("Examples of {other}")));
        let short = folder.run(&format!("{command} -h")).out;
        assert!(!short.contains("Examples") && short.lines().count() < 60, "{short}");
        assert_says(&short, &["More with --help."]);
    }
    let all = folder.run("--help").out;
    assert_says(&all, &["Examples of analyze:", "Examples of optimize:", "of completions:"]);
    let optimize = folder.run("optimize --help").out;
    assert_says(&optimize, &["a bound that no other placement surpasses", "worst-point stiffness"]);
}

/// The one object on standard error.
fn error(ran: &Ran) -> Value {
    assert_eq!(ran.err.lines().count(), 1, "{}", ran.err);
    let complaint: Value = ran.err.parse().unwrap();
    assert_eq!(complaint.as_object().unwrap().len(), 1);
    complaint["error"].clone()
}

#[test]
fn errors_are_objects_with_their_place_where_reports_are_json() {
    let folder = Folder::new("json-errors");
    folder.write("bad.toml", "[part.planar]\noutline = [[0, 0], [4, 0], [4, \"x\"]]\n");
    folder.write("bad.json", "{\"part\": {\"planar\":\n {\"outline\": 7}}}");
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    let field = "part.planar.outline[2][1]";
    for (arguments, wanted) in [
        (
            "analyze bad.toml",
            format!("input bad.toml 2 {} {field} 1", "outline = [[0, 0], [4, 0], [4, \"".len()),
        ),
        ("optimize bad.json --fingers 4", "input bad.json 2 14 part.planar.outline 1".to_owned()),
        ("analyze none.toml", "file none.toml null null null 1".to_owned()),
        ("optimize part.toml --fingers 3", "usage null null null null 2".to_owned()),
        ("optimize part.toml", "usage null null null null 2".to_owned()),
        ("analyze part.toml --order third", "usage null null null null 2".to_owned()),
    ] {
        let ran = folder.run(&format!("{arguments} --format json"));
        assert_eq!(ran.out, "", "{arguments}");
        let error = error(&ran);
        let words = ["kind", "file", "line", "column", "field", "exit_code"].map(|key| {
            let value = error.get(key).cloned().unwrap_or(Value::Null);
            value.as_str().map_or_else(|| value.to_string(), str::to_owned)
        });
        assert_eq!(words.join(" "), wanted, "{arguments}");
        assert_eq!(Some(&Value::from(ran.code.unwrap())), error.get("exit_code"));
        let message = error["message"].as_str().unwrap();
        assert!(message.len() > 10 && !message.starts_with("error"), "{message}");
        // What a person reads has the same words.
        let text = folder.run(arguments).err;
        assert_says(&text, &[message.lines().next().unwrap()]);
    }
    let ran = folder.run("analyze none.toml --format=json --order third");
    assert_eq!(error(&ran)["kind"], "usage");
    // Help is no error, and goes where help goes.
    let help = folder.run("analyze --format json -h");
    assert_eq!((help.code, help.err.as_str()), (Some(0), ""));
}

/// The report is whole, and the reason besides.
#[test]
fn what_has_no_answer_or_fails_a_check_is_an_object_too() {
    let folder = Folder::new("json-unanswered");
    let square = "part.planar = { outline = [[0, 0], [4, 0], [4, 4], [0, 4]], stiffness = 10 }\n";
    folder.write("loose.toml", format!("{square}[[contacts]]\npoint = [2, 0]\n"));
    let ran = folder.run("analyze loose.toml --format json");
    let error_of = error(&ran);
    assert_eq!((ran.code, &error_of["kind"]), (Some(3), &"no_answer".into()));
    assert_eq!(error_of["message"], ran.json()["reason"]);
    let contacts = ["[1, 0]", "[4, 3]", "[3, 4]", "[0, 1]"];
    let contacts = contacts.map(|point| format!("[[contacts]]\npoint = {point}\npreload = 5\n"));
    let case = "[[load_cases]]\nforce = [1, 0]\ntolerance = 0.01\n";
    folder.write("held.toml", format!("{square}{}{case}", contacts.concat()));
    let ran = folder.run("analyze held.toml --check --format json");
    let error = error(&ran);
    assert_eq!((ran.code, &error["kind"]), (Some(3), &"check_failed".into()));
    assert_says(&error["message"].to_string(), &["load case 0: the part moves by"]);
    assert_eq!(ran.json()["verdict"]["passes"], false);
}

#[test]
fn one_standard_input_is_for_one_file() {
    let folder = Folder::new("two-inputs");
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    for (arguments, names) in [
        ("part.toml --fix - --candidates -", "--fix and --candidates are all `-`"),
        ("- --fix - --candidates -", "the part and --fix and --candidates are all `-`"),
        ("- --candidates -", "the part and --candidates are all `-`"),
    ] {
        let ran = folder.run(&format!("optimize {arguments} --fingers 2"));
        assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
        assert_says(&ran.err, &[names, "there is one standard input"]);
    }
}

/// A triangle has one combination of three edges.
#[test]
fn the_best_of_one_combination_is_a_list_of_one() {
    let folder = Folder::new("top-of-one");
    folder.write("part.toml", part("[[0, 0], [9, 0], [2, 7]]", "1"));
    let question = "optimize part.toml --fingers 3 --preload 1";
    let report = folder.json(&format!("{question} --top 3"));
    let top = list(&report["top"]);
    assert_eq!((top.len(), &top[0]["quality"]), (1, &report["quality"]));
    assert_eq!(folder.json(question).get("top"), None);
}

#[test]
fn one_finger_is_one_finger() {
    let folder = Folder::new("one-finger");
    folder.write(
        "block.toml",
        "[part.spatial]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n\
         faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]\nstiffness = 1\n",
    );
    let one = "[[contacts]]\npoint = [0.2, 0.2, 0]\nface = 0\n";
    folder.write("fix.toml", one.repeat(6));
    let ran = folder.run("optimize block.toml --fix fix.toml --fingers 1 --nodes 10");
    assert_eq!(ran.code, Some(3), "{}", ran.err);
    assert_says(&ran.err, &["no placement of 1 frictionless finger holds the part"]);
}
