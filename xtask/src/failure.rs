//! Why a task did not finish.

use std::io;

/// Why a task did not finish.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub(crate) enum Failure {
    /// A file or folder of the repository could not be read.
    #[error("cannot read {path}: {source}")]
    Unreadable {
        /// The path, from the root of the repository.
        path: String,
        /// What the system said.
        source: io::Error,
    },
    /// A program could not be started.
    #[error("cannot start `{command}`: {source}")]
    NotStarted {
        /// The whole command.
        command: String,
        /// What the system said.
        source: io::Error,
    },
    /// `cargo metadata` refused the workspace.
    #[error("`cargo metadata` failed:\n{message}")]
    WorkspaceRefused {
        /// What cargo printed.
        message: String,
    },
    /// The answer of `cargo metadata` does not have the tables the checks read.
    #[error("cannot read the answer of `cargo metadata`: {0}")]
    WorkspaceUnknown(#[from] serde_json::Error),
    /// A step of `cargo xtask ci` failed.
    #[error("step `{step}` failed\n  mend: {mend}")]
    StepFailed {
        /// The step's name.
        step: &'static str,
        /// The command that mends it, or shows it alone.
        mend: &'static str,
    },
    /// The repository breaks its own rules; the findings have been printed.
    #[error("tidy has {count} findings\n  mend: as each finding says, then `cargo xtask tidy`")]
    Untidy {
        /// How many findings were printed.
        count: usize,
    },
    /// A number of the paper could not be computed.
    #[error("cannot recompute the paper: {0}")]
    Paper(crate::paper::PaperError),
    /// A number of the guide could not be computed.
    #[error("cannot compute the example of the guide: {0}")]
    Guide(clench::contact::ContactError),
    /// A page is not as it should be in a browser.
    #[error(transparent)]
    Browser(crate::browser::BrowserError),
    /// The library could not be compared with others, or they contradict it.
    #[error(transparent)]
    Peers(crate::peers::PeersError),
    /// A figure could not be drawn.
    #[error("cannot draw a figure: {0}")]
    Figure(clench_draw::DrawError),
    /// A file of the repository could not be written.
    #[error("cannot write {path}: {source}")]
    Unwritable {
        /// The path, from the root of the repository.
        path: String,
        /// What the system said.
        source: io::Error,
    },
    /// A made file is not the one that would be made now.
    #[error(
        "{path} is not what the code makes\n  mend: cargo xtask {task}, and look at the change"
    )]
    Stale {
        /// The path, from the root of the repository.
        path: String,
        /// The task that makes the file.
        task: &'static str,
    },
    /// Printed digits were not reproduced; the table has been printed.
    #[error("{missed} printed numbers of the paper are missed, see the table")]
    MissedDigits {
        /// How many.
        missed: usize,
    },
}
