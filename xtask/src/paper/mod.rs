//! `cargo xtask paper`: the numbers and the figures of Lin, Burdick and Rimon.
//!
//! Writes `docs/paper/`: a table of printed against computed numbers, and Figures 1 to 5 as SVG
//! and PNG. With `--check` it writes nothing and fails when what stands there is not what it
//! would write. Either way it fails when a printed digit is missed.

mod figures;
mod grasps;
mod table;

pub(crate) use grasps::PaperError;

use std::fs;
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::workspace::ROOT;

/// Where the table and the figures stand.
const FOLDER: &str = "docs/paper";

/// Pixels per unit of the page: sharp on a screen of twice the usual density.
const PNG_SCALE: f64 = 2.0;

/// What to do with the results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    /// Write them.
    Write,
    /// Compare them with what stands in the repository.
    Check,
}

/// Recomputes the paper.
pub(crate) fn run(mode: Mode) -> Result<(), Failure> {
    let paper = grasps::Paper::compute().map_err(Failure::Paper)?;
    let rows = table::rows(&paper);
    let page = table::page(&rows);
    print!("{page}");
    let folder = PathBuf::from(ROOT).join(FOLDER);
    if mode == Mode::Write {
        fs::create_dir_all(&folder).map_err(|source| unwritable(&folder, source))?;
    }
    settle(mode, &folder.join("README.md"), page.as_bytes())?;
    for (name, figure) in figures::all(&paper).map_err(Failure::Figure)? {
        settle(mode, &folder.join(format!("{name}.svg")), figure.to_svg().as_bytes())?;
        let picture = folder.join(format!("{name}.png"));
        match mode {
            Mode::Write => {
                let bytes = figure.to_png(PNG_SCALE).map_err(Failure::Figure)?;
                settle(mode, &picture, &bytes)?;
            }
            // Another processor may round a pixel otherwise; the SVG says what is drawn.
            Mode::Check if !picture.exists() => {
                return Err(Failure::Stale { path: shown(&picture) });
            }
            Mode::Check => {}
        }
    }
    match rows.iter().filter(|row| !row.agrees()).count() {
        0 => Ok(()),
        missed => Err(Failure::MissedDigits { missed }),
    }
}

/// Writes `content` to `path`, or finds it there.
fn settle(mode: Mode, path: &Path, content: &[u8]) -> Result<(), Failure> {
    match mode {
        Mode::Write => fs::write(path, content).map_err(|source| unwritable(path, source)),
        Mode::Check if fs::read(path).is_ok_and(|found| found == content) => Ok(()),
        Mode::Check => Err(Failure::Stale { path: shown(path) }),
    }
}

fn unwritable(path: &Path, source: std::io::Error) -> Failure {
    Failure::Unwritable { path: shown(path), source }
}

/// The path from the root of the repository.
fn shown(path: &Path) -> String {
    path.strip_prefix(ROOT).unwrap_or(path).display().to_string()
}
