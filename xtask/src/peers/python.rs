//! Python with what the peers need, in a virtual environment of its own.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde::Serialize;
use serde::de::DeserializeOwned;

use super::PeersError;
use crate::workspace::ROOT;

/// Where the environment, the scripts and their questions stand, from the root of the repository.
const FOLDER: &str = "target/peers";

/// Marks the folder as one of made files, which backups and the rules of the repository skip.
const CACHE_TAG: (&str, &[u8]) = ("CACHEDIR.TAG", b"Signature: 8a477f597d28d172789f06886806bc55\n");

/// The Python that makes the environment.
const SYSTEM_PYTHON: &str = "python3";

/// The Python of the environment, from its folder.
const OWN_PYTHON: &str = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };

/// What the scripts import.
const PACKAGES: [&str; 2] = ["numpy==2.4.6", "pyscipopt==6.3.0"];

/// A script of this folder.
#[derive(Clone, Copy, Debug)]
pub(super) struct Script {
    /// Its name, without ending.
    pub(super) name: &'static str,
    /// All of it.
    pub(super) text: &'static str,
}

/// Python with the packages.
#[derive(Debug)]
pub(super) struct Python {
    folder: PathBuf,
    own: PathBuf,
}

impl Python {
    /// Makes the environment, or finds it as an earlier run has left it.
    pub(super) fn ready() -> Result<Self, PeersError> {
        let folder = PathBuf::from(ROOT).join(FOLDER);
        fs::create_dir_all(&folder).map_err(|source| unwritable(&folder, source))?;
        let environment = folder.join("venv");
        let python = Self { own: environment.join(OWN_PYTHON), folder };
        python.file(CACHE_TAG.0, CACHE_TAG.1)?;
        if python.has_packages() {
            return Ok(python);
        }
        let mut make = Command::new(SYSTEM_PYTHON);
        make.args(["-m", "venv", "--clear"]).arg(&environment);
        run(&mut make, "install Python's module venv")?;
        let mut install = Command::new(&python.own);
        install.args(["-m", "pip", "install", "--quiet"]).args(PACKAGES);
        run(&mut install, "mend what pip complains about, such as a missing network")?;
        Ok(python)
    }

    fn has_packages(&self) -> bool {
        let imports = format!("import {}", PACKAGES.join(", "));
        let quiet = || Stdio::null();
        let mut check = Command::new(&self.own);
        check.args(["-c", &imports]).stdout(quiet()).stderr(quiet());
        check.status().is_ok_and(|status| status.success())
    }

    /// What the script answers to the questions. It shows its progress on standard error.
    pub(super) fn ask<A: DeserializeOwned>(
        &self,
        script: Script,
        questions: &impl Serialize,
    ) -> Result<A, PeersError> {
        let unknown = |source| PeersError::Unknown { place: script.name, source };
        let text = serde_json::to_vec(questions).map_err(unknown)?;
        let program = self.file(&format!("{}.py", script.name), script.text.as_bytes())?;
        let questions = self.file(&format!("{}.json", script.name), &text)?;
        let mut command = Command::new(&self.own);
        command.arg(program).arg(questions).stderr(Stdio::inherit());
        let output = run(&mut command, "delete target/peers")?;
        serde_json::from_slice(&output.stdout).map_err(unknown)
    }

    fn file(&self, name: &str, content: &[u8]) -> Result<PathBuf, PeersError> {
        let path = self.folder.join(name);
        fs::write(&path, content).map_err(|source| unwritable(&path, source))?;
        Ok(path)
    }
}

fn run(command: &mut Command, mend: &'static str) -> Result<Output, PeersError> {
    let shown = format!("{command:?}").replace('"', "");
    let output = command
        .stderr(Stdio::inherit())
        .output()
        .map_err(|source| PeersError::NoPython { command: shown.clone(), source })?;
    if output.status.success() {
        Ok(output)
    } else {
        Err(PeersError::PythonFailed { command: shown, mend })
    }
}

fn unwritable(path: &Path, source: std::io::Error) -> PeersError {
    PeersError::Unwritable { path: path.display().to_string(), source }
}
