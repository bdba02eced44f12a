//! Running the command in a folder of the test's own.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on fails")]

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use clench_testkit::cases::Value;

/// A folder for the files of one test, empty at the start.
pub(crate) struct Folder(PathBuf);

/// What the command printed, and its exit code.
pub(crate) struct Ran {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Folder {
    /// The folder of the test called `name`; no two tests may share one.
    pub(crate) fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) -> &Self {
        fs::write(self.path(name), content).unwrap();
        self
    }

    /// The names of the files in the folder, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let mut names: Vec<_> =
            entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// Runs `clench` in the folder; the arguments are separated by single spaces.
    pub(crate) fn run(&self, arguments: &str) -> Ran {
        let output = command(arguments.split(' ')).current_dir(&self.0).output().unwrap();
        Ran::new(&output)
    }

    /// Runs `clench` with `--format json`, which has to find an answer.
    pub(crate) fn json(&self, arguments: &str) -> Value {
        let ran = self.run(&format!("{arguments} --format json"));
        assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{arguments}");
        ran.json()
    }
}

impl Ran {
    pub(crate) fn new(output: &Output) -> Self {
        Self {
            code: output.status.code(),
            out: String::from_utf8(output.stdout.clone()).unwrap(),
            err: String::from_utf8(output.stderr.clone()).unwrap(),
        }
    }

    pub(crate) fn json(&self) -> Value {
        self.out.parse().unwrap_or_else(|e| panic!("{e}: {}", self.out))
    }
}

/// The command with these arguments.
pub(crate) fn command(arguments: impl IntoIterator<Item = impl AsRef<OsStr>>) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_clench"));
    command.args(arguments).env("NO_COLOR", "1");
    command
}

/// A part file with this outline and stiffness.
pub(crate) fn part(outline: &str, stiffness: &str) -> String {
    format!("[part.planar]\noutline = {outline}\nstiffness = {stiffness}\n")
}

/// The quadrilateral of LBR, examples 5.1 and 5.2.
pub(crate) const QUADRILATERAL: &str = "[[0, 0], [13, 0], [9, 8], [2, 6]]";

/// The quadrilateral with stiffness 1, and these contacts.
pub(crate) fn grasp(contacts: &[&str]) -> String {
    let contacts = contacts.iter().map(|contact| format!("[[contacts]]\n{contact}\n"));
    part(QUADRILATERAL, "1") + &contacts.collect::<String>()
}

/// The grasp of LBR, Figure 1.
pub(crate) fn figure_1() -> String {
    let contacts = [
        "point = [0, 0]\nedge = 0",
        "point = [13, 0]\nedge = 0",
        "point = [9, 8]\nedge = 1",
        "point = [2, 6]\nedge = 3",
    ];
    grasp(&contacts)
}

/// Asserts that a message has all these pieces.
pub(crate) fn assert_says(message: &str, pieces: &[&str]) {
    for piece in pieces {
        assert!(message.contains(piece), "`{piece}` is missing in: {message}");
    }
}
