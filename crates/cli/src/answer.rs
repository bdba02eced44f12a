//! What a command finds out.

use clench_draw::GraspPicture;

/// The end of a command whose input was sound.
#[derive(Debug)]
pub(crate) struct Answer {
    /// The report, for standard output.
    pub(crate) report: String,
    /// The grasp, or the part alone; solids are not drawn.
    pub(crate) picture: Option<GraspPicture>,
    /// Why there is no quality, or why the fingers cannot hold the part.
    pub(crate) reason: Option<String>,
}
