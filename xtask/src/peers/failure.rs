//! Why nothing could be compared, or what the comparison showed.

use std::io;

use clench::optimize::OptimizeError;
use clench::shape::PolygonError;

/// Why nothing could be compared, or what the comparison showed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub(crate) enum PeersError {
    /// The run in a release build failed; it has said why.
    #[error("the comparison failed, see above\n  mend: as it says, then cargo xtask peers")]
    Anew,
    /// Python did not start.
    #[error(
        "cannot start `{command}`: {source}\n  \
         mend: install Python 3 with its module venv, then cargo xtask peers"
    )]
    NoPython {
        /// The whole command.
        command: String,
        /// What the system said.
        source: io::Error,
    },
    /// Python failed; it has said why.
    #[error("`{command}` failed\n  mend: {mend}, then cargo xtask peers")]
    PythonFailed {
        /// The whole command.
        command: String,
        /// What to run or to do.
        mend: &'static str,
    },
    /// A file could not be written.
    #[error("cannot write {path}: {source}")]
    Unwritable {
        /// The path.
        path: String,
        /// What the system said.
        source: io::Error,
    },
    /// The reference cases could not be read.
    #[error("cannot read {path}: {source}")]
    Unreadable {
        /// The path, from the root of the repository.
        path: &'static str,
        /// What the system said.
        source: io::Error,
    },
    /// The reference cases, or what a script printed, were not what is expected.
    #[error("cannot read what stands in {place}: {source}")]
    Unknown {
        /// The file or the script.
        place: &'static str,
        /// What is wrong.
        source: serde_json::Error,
    },
    /// A script answered another number of questions.
    #[error("{script} answered {found} of {asked} questions")]
    AnswerCount {
        /// The script.
        script: &'static str,
        /// How many answers.
        found: usize,
        /// How many questions.
        asked: usize,
    },
    /// An outline was refused.
    #[error(transparent)]
    Outline(#[from] PolygonError),
    /// A search found nothing.
    #[error(transparent)]
    Optimize(#[from] OptimizeError),
    /// A reference combination holds nothing.
    #[error("no placement on the edges {edges:?} of part {part} holds it")]
    Combination {
        /// The part, by its number in the file.
        part: usize,
        /// The edges.
        edges: [usize; 4],
    },
    /// The tables show contradictions; they have been printed.
    #[error("{count} rows contradict the library, see the tables")]
    Contradicted {
        /// How many.
        count: usize,
    },
}
