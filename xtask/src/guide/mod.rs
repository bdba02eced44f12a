//! `cargo xtask guide`: the pictures of the guide, computed through the public crates.
//!
//! Writes `docs/guide/` as SVG and PNG. With `--check` it writes nothing and fails when what
//! stands there is not what it would write.

mod ball_on_bar;

use crate::failure::Failure;
use crate::made::{Folder, Mode};

/// Where the pictures stand.
const FOLDER: &str = "docs/guide";

/// Redraws the guide.
pub(crate) fn run(mode: Mode) -> Result<(), Failure> {
    let folder = Folder::open(FOLDER, mode, "guide")?;
    let example = ball_on_bar::Example::compute().map_err(Failure::Guide)?;
    folder.figure("contact", &example.figure().map_err(Failure::Figure)?)
}
