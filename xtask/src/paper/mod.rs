//! `cargo xtask paper`: the numbers and the figures of Lin, Burdick and Rimon.
//!
//! Writes `docs/paper/`: a table of printed against computed numbers, Figures 1 to 5 and one of our
//! own as SVG and PNG. With `--check` it writes nothing and fails when what stands there is not
//! what it would write. Either way it fails when a printed digit is missed.

mod figures;
mod grasps;
mod table;
mod travel;
mod travel_chart;

pub(crate) use grasps::PaperError;

use crate::failure::Failure;
use crate::made::{Folder, Mode};

/// Where the table and the figures stand.
const FOLDER: &str = "docs/paper";

/// Recomputes the paper.
pub(crate) fn run(mode: Mode) -> Result<(), Failure> {
    let paper = grasps::Paper::compute().map_err(Failure::Paper)?;
    let rows = table::rows(&paper);
    let travel = travel::Travel::compute(&paper).map_err(Failure::Paper)?;
    let page = table::page(&rows) + &travel.section();
    print!("{page}");
    let folder = Folder::open(FOLDER, mode, "paper")?;
    folder.file("README.md", page.as_bytes())?;
    for (name, figure) in figures::all(&paper).map_err(Failure::Figure)? {
        folder.figure(name, &figure)?;
    }
    folder.figure("figure-6", &travel.figure(&paper).map_err(Failure::Figure)?)?;
    match rows.iter().filter(|row| !row.agrees()).count() {
        0 => Ok(()),
        missed => Err(Failure::MissedDigits { missed }),
    }
}
