//! Files of the repository that a task makes: written, or compared with what stands there.

use std::fs;
use std::path::{Path, PathBuf};

use clench_draw::Figure;

use crate::failure::Failure;
use crate::workspace::ROOT;

/// Pixels per unit of the page: sharp on a screen of twice the usual density.
const PNG_SCALE: f64 = 2.0;

/// What to do with what was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    /// Write it.
    Write,
    /// Compare it with what stands in the repository.
    Check,
}

/// A folder whose files one task makes.
#[derive(Debug)]
pub(crate) struct Folder {
    path: PathBuf,
    mode: Mode,
    /// The task that writes it.
    task: &'static str,
}

impl Folder {
    /// The folder at a path from the root of the repository; writing creates it.
    pub(crate) fn open(path: &str, mode: Mode, task: &'static str) -> Result<Self, Failure> {
        let path = PathBuf::from(ROOT).join(path);
        if mode == Mode::Write {
            fs::create_dir_all(&path).map_err(|source| unwritable(&path, source))?;
        }
        Ok(Self { path, mode, task })
    }

    /// Writes a file, or finds it there byte for byte.
    pub(crate) fn file(&self, name: &str, content: &[u8]) -> Result<(), Failure> {
        let path = self.path.join(name);
        match self.mode {
            Mode::Write => fs::write(&path, content).map_err(|source| unwritable(&path, source)),
            Mode::Check if fs::read(&path).is_ok_and(|found| found == content) => Ok(()),
            Mode::Check => Err(self.stale(&path)),
        }
    }

    /// Writes a figure as SVG and PNG, or finds both there.
    pub(crate) fn figure(&self, name: &str, figure: &Figure) -> Result<(), Failure> {
        self.file(&format!("{name}.svg"), figure.to_svg().as_bytes())?;
        let raster = format!("{name}.png");
        match self.mode {
            Mode::Write => self.file(&raster, &figure.to_png(PNG_SCALE).map_err(Failure::Figure)?),
            // Another processor may round a pixel otherwise; the SVG says what is drawn.
            Mode::Check if self.path.join(&raster).exists() => Ok(()),
            Mode::Check => Err(self.stale(&self.path.join(&raster))),
        }
    }

    fn stale(&self, path: &Path) -> Failure {
        Failure::Stale { path: shown(path), task: self.task }
    }
}

fn unwritable(path: &Path, source: std::io::Error) -> Failure {
    Failure::Unwritable { path: shown(path), source }
}

/// The path from the root of the repository.
fn shown(path: &Path) -> String {
    path.strip_prefix(ROOT).unwrap_or(path).display().to_string()
}

#[cfg(test)]
mod tests {
    use super::{Folder, Mode};

    #[test]
    fn a_file_that_differs_or_is_missing_is_stale_and_says_what_writes_it() {
        let folder = Folder::open("xtask", Mode::Check, "chore").unwrap();
        let manifest = include_bytes!("../Cargo.toml");
        assert!(folder.file("Cargo.toml", manifest).is_ok());
        for name in ["src/main.rs", "gone"] {
            let failure = folder.file(name, manifest).unwrap_err().to_string();
            let expected = format!(
                "xtask/{name} is not what the code makes\n  \
                 mend: cargo xtask chore, and look at the change"
            );
            assert_eq!(failure, expected);
        }
    }
}
