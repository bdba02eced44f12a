//! What a command finds out.

use std::path::PathBuf;

use crate::picture::Picture;

/// The end of a command whose input was sound.
#[derive(Debug)]
pub(crate) struct Answer {
    /// The report, for standard output.
    pub(crate) report: String,
    /// The report for a browser, if it was asked for and there is something to show.
    pub(crate) page: Option<String>,
    /// The grasp, if there is one: without fingers nothing replaces a picture of before.
    pub(crate) picture: Option<Picture>,
    /// The files that were read besides those of the command line.
    pub(crate) besides: Vec<PathBuf>,
    /// Why there is no quality, or why the fingers cannot hold the part.
    pub(crate) reason: Option<String>,
    /// Why load cases fail that had to pass.
    pub(crate) failed_check: Option<String>,
}
