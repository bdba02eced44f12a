//! The walk-throughs of `docs/examples` hold: each command runs, each line of output is printed.
//!
//! A walk-through is a folder with a `README.md` and the files that it speaks of. All of its `sh`
//! blocks run from a copy of the folder; each line is a `clench` command, which may end in
//! `> FILE`, and has to find an answer without a word on the standard error. The lines of a `text`
//! block are output of the `sh` block before it, those of a `toml` block are in a file of the
//! folder; `...` stands for lines left out. A number in backticks is in the output or in a file.
//! Files that the commands write, such as pictures, are the same as in the folder if it has them.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fs;
use std::path::Path;

use crate::run::Folder;

const EXAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/examples");

/// The options that say where a command writes.
const WRITES: [&str; 2] = ["--svg", "--report"];

/// What stands for lines that are left out.
const LEFT_OUT: &str = "...";

#[test]
fn the_walk_throughs_hold() {
    let mut folders: Vec<_> = fs::read_dir(EXAMPLES).unwrap().map(|e| e.unwrap().path()).collect();
    folders.sort();
    assert!(!folders.is_empty(), "there are no walk-throughs");
    for kept in folders {
        let name = kept.file_name().unwrap().to_str().unwrap();
        let copy = Folder::new(&format!("example-{name}"));
        if let Err(stale) = holds(&kept, &copy) {
            panic!("docs/examples/{name}/README.md: {stale}");
        }
    }
}

/// Runs the page of the folder `kept` in `copy`, and says what is not as the page has it.
fn holds(kept: &Path, copy: &Folder) -> Result<(), String> {
    let page = fs::read_to_string(kept.join("README.md")).map_err(|e| e.to_string())?;
    let blocks = blocks(&page)?;
    let mut written = Vec::new();
    for block in blocks.iter().filter(|block| block.language == "sh") {
        written.extend(block.commands()?.into_iter().flat_map(|command| command.writes));
    }
    let files = copy_files(kept, copy, &written);
    let (mut printed, mut last) = (String::new(), String::new());
    for block in &blocks {
        match block.language {
            "sh" => last = run(block, copy)?,
            "text" => has_lines(&last, &block.lines)
                .map_err(|line| format!("`{line}` is not, or not there, in the output:\n{last}"))?,
            "toml" if files.iter().any(|file| has_lines(file, &block.lines).is_ok()) => {}
            "toml" => return Err(format!("no file has the lines of\n{}", block.lines.join("\n"))),
            other => return Err(format!("found a block of `{other}`, expected sh, text or toml")),
        }
        printed += &last;
    }
    if printed.is_empty() {
        return Err("nothing ran".to_owned());
    }
    has_numbers(&page, &(printed + &files.join("\n")))?;
    written.iter().try_for_each(|name| same(kept, copy, name))?;
    has_links(&page, kept, &written, &files)
}

/// A block of code.
struct Block<'a> {
    language: &'a str,
    lines: Vec<&'a str>,
}

/// A line of a shell.
struct Command {
    line: String,
    arguments: String,
    /// Where its output goes instead of to the page.
    into: Option<String>,
    /// The names of all files that it writes.
    writes: Vec<String>,
}

fn blocks(page: &str) -> Result<Vec<Block<'_>>, String> {
    let mut found = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        let Some(language) = line.strip_prefix("```") else { continue };
        let code: Vec<_> = lines.by_ref().take_while(|line| !line.starts_with("```")).collect();
        if code.iter().all(|line| line.trim().is_empty()) {
            return Err(format!("a block of `{language}` is empty"));
        }
        found.push(Block { language, lines: code });
    }
    Ok(found)
}

impl Block<'_> {
    /// The commands of a block for a shell, each in one line.
    fn commands(&self) -> Result<Vec<Command>, String> {
        let text = self.lines.join("\n").replace("\\\n", " ");
        text.lines().filter(|line| !line.trim().is_empty()).map(Command::new).collect()
    }
}

impl Command {
    fn new(line: &str) -> Result<Self, String> {
        let line = line.split_whitespace().collect::<Vec<_>>().join(" ");
        let (command, into) = match line.split_once(" > ") {
            Some((command, into)) => (command, Some(into.to_owned())),
            None => (line.as_str(), None),
        };
        let arguments = command.strip_prefix("clench ").map(str::to_owned);
        let arguments = arguments.ok_or_else(|| format!("`{line}` is no command of clench"))?;
        let words: Vec<&str> = arguments.split(' ').collect();
        let named = words.windows(2).filter(|pair| WRITES.contains(&pair[0]));
        let writes = named.map(|pair| pair[1].to_owned()).chain(into.clone()).collect();
        Ok(Self { line, arguments, into, writes })
    }
}

/// Copies the files of a walk-through but for its page and what its commands write, and returns
/// their texts.
fn copy_files(kept: &Path, copy: &Folder, written: &[String]) -> Vec<String> {
    let mut texts = Vec::new();
    for entry in fs::read_dir(kept).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if name != "README.md" && !written.contains(&name) {
            let content = fs::read(kept.join(&name)).unwrap();
            copy.write(&name, &content);
            texts.extend(String::from_utf8(content));
        }
    }
    texts
}

/// What the commands of a block print.
fn run(block: &Block<'_>, copy: &Folder) -> Result<String, String> {
    let mut printed = String::new();
    for Command { line, arguments, into, .. } in block.commands()? {
        let ran = copy.run(&arguments);
        if (ran.code, ran.err.as_str()) != (Some(0), "") {
            return Err(format!("`{line}` ended with {:?}: {}{}", ran.code, ran.err, ran.out));
        }
        match into {
            Some(name) => drop(copy.write(&name, ran.out)),
            None => printed += &ran.out,
        }
    }
    Ok(printed)
}

/// Whether `text` has these lines one after the other, but for those left out; or the first that
/// it lacks. Space at the ends of lines does not count.
fn has_lines<'a>(text: &str, lines: &[&'a str]) -> Result<(), &'a str> {
    let text: Vec<&str> = text.lines().map(str::trim_end).collect();
    let mut from = 0;
    for run in lines.split(|line| line.trim() == LEFT_OUT).filter(|run| !run.is_empty()) {
        let matches = |at: &usize| {
            text[*at..]
                .iter()
                .zip(run)
                .take_while(|(found, line)| **found == line.trim_end())
                .count()
        };
        let best = (from..text.len()).max_by_key(|at| (matches(at), text.len() - at));
        match best.map(|at| (at, matches(&at))) {
            Some((at, count)) if count == run.len() => from = at + count,
            Some((_, count)) => return Err(run[count]),
            None => return Err(run[0]),
        }
    }
    Ok(())
}

/// Whether each number in backticks is somewhere in `source`, perhaps with the other sign.
fn has_numbers(page: &str, source: &str) -> Result<(), String> {
    let words = |text: &str| -> Vec<String> {
        let split = text.split(|c: char| c.is_whitespace() || "()[]{},;:=`".contains(c));
        split.map(|word| word.trim_end_matches('.').to_owned()).collect()
    };
    let known = words(source);
    let prose = page.split("```").step_by(2);
    for code in prose.flat_map(|text| text.split('`').skip(1).step_by(2)) {
        for word in words(code).iter().filter(|word| word.parse::<f64>().is_ok()) {
            if !(known.contains(word) || known.contains(&format!("-{word}"))) {
                return Err(format!("`{word}` of `{code}` is in no output and in no file"));
            }
        }
    }
    Ok(())
}

/// Whether what a command wrote is what the folder has, if it has it.
fn same(kept: &Path, copy: &Folder, name: &str) -> Result<(), String> {
    let Ok(expected) = fs::read(kept.join(name)) else { return Ok(()) };
    if fs::read(copy.path(name)).unwrap() == expected {
        return Ok(());
    }
    Err(format!("{name} is stale; mend: cp {} {}", copy.path(name).display(), kept.display()))
}

/// Whether each link leads to a file, and each picture of the folder comes from a command or is
/// named by a file that is read.
fn has_links(page: &str, kept: &Path, written: &[String], files: &[String]) -> Result<(), String> {
    let targets = page.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
    for target in targets.filter(|target| !target.contains("://") && !target.is_empty()) {
        if !kept.join(target).exists() {
            return Err(format!("the link to {target} leads nowhere"));
        }
        let picture = [".svg", ".png"].iter().any(|ending| target.ends_with(ending));
        let known = written.iter().any(|name| name == target)
            || files.iter().any(|file| file.contains(target));
        if picture && !known {
            return Err(format!("no command draws {target}"));
        }
    }
    Ok(())
}

/// A square on four fingers, its walk-through, and the folders for it.
fn of_square(name: &str, page: &str) -> Result<(), String> {
    let kept = Folder::new(&format!("walk-{name}-kept"));
    let outline = "[[0, 0], [20, 0], [20, 20], [0, 20]]";
    kept.write("square.toml", crate::run::part(outline, "2000")).write("README.md", page);
    holds(&kept.path("."), &Folder::new(&format!("walk-{name}-copy")))
}

const COMMAND: &str =
    "```sh\nclench optimize square.toml --fingers 4 \\\n  --svg square.svg\n```\n";

#[test]
fn a_walk_through_of_what_the_command_says_holds() {
    let page = format!(
        "{COMMAND}\n```toml\n[part.planar]\n...\nstiffness = 2000\n```\n\
         ```text\n...\nunits     lengths in L, forces in F, angles in rad\n```\nOf `2000 F/L`.\n"
    );
    assert_eq!(of_square("holds", &page), Ok(()));
}

#[test]
fn a_walk_through_of_anything_else_does_not_hold() {
    let wrong = [
        ("none", "Text.", "nothing ran"),
        ("shell", "```sh\nls\n```\n", "`ls` is no command of clench"),
        ("language", "```json\n{}\n```\n", "found a block of `json`"),
        ("code", "```sh\nclench analyze square.toml\n```\n", "ended with Some(1)"),
        ("line", "```text\nangles in degrees\n```\n", "`angles in degrees` is not"),
        ("file", "```toml\nstiffness = 20\n```\n", "no file has the lines"),
        ("number", "It is `2001 F/L`.", "`2001` of `2001 F/L` is in no output"),
        ("link", "[files](elsewhere.md)", "elsewhere.md leads nowhere"),
        ("picture", "![all](README.md.svg)", "leads nowhere"),
    ];
    for (name, text, expected) in wrong {
        let page =
            if matches!(name, "none") { text.to_owned() } else { format!("{COMMAND}{text}") };
        let stale = of_square(name, &page).unwrap_err();
        assert!(stale.contains(expected), "{name}: {stale}");
    }
}

/// A picture that is kept is held against the one that is drawn.
#[test]
fn a_walk_through_with_another_picture_does_not_hold() {
    let kept = Folder::new("walk-stale-kept");
    let outline = "[[0, 0], [20, 0], [20, 20], [0, 20]]";
    kept.write("square.toml", crate::run::part(outline, "2000"));
    kept.write("README.md", format!("{COMMAND}![the square](square.svg)"));
    kept.write("square.svg", "<svg/>").write("other.svg", "<svg/>");
    let stale = holds(&kept.path("."), &Folder::new("walk-stale-copy")).unwrap_err();
    assert!(stale.starts_with("square.svg is stale"), "{stale}");
    kept.write("README.md", format!("{COMMAND}![another](other.svg)"));
    fs::remove_file(kept.path("square.svg")).unwrap();
    let undrawn = holds(&kept.path("."), &Folder::new("walk-undrawn-copy")).unwrap_err();
    assert_eq!(undrawn, "no command draws other.svg");
}
