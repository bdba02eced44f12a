//! Why a page is not as it should be, or could not be looked at.

use std::io;

/// Why a page is not as it should be, or could not be looked at.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub(crate) enum BrowserError {
    /// The browser or its driver is not installed.
    #[error(
        "cannot start `{program}`: {source}\n  mend: install Chromium and its driver, on Debian \
         with: apt-get install chromium chromium-driver"
    )]
    Missing {
        /// The program.
        program: &'static str,
        /// What the system said.
        source: io::Error,
    },
    /// The driver did not say where it listens.
    #[error("chromedriver does not say on which port it listens")]
    NoPort,
    /// The driver could not be asked.
    #[error("chromedriver cannot be asked: {0}")]
    Unreachable(#[from] ureq::Error),
    /// The driver refused a command.
    #[error("chromedriver refused {command}: {message}")]
    Refused {
        /// The command.
        command: String,
        /// What it said.
        message: String,
    },
    /// A file of the step could not be written or read.
    #[error("cannot write the pages to look at: {source}")]
    File {
        /// What the system said.
        source: io::Error,
    },
    /// The command that makes a page failed.
    #[error("`clench {arguments}` failed:\n{message}")]
    NotMade {
        /// Its arguments.
        arguments: String,
        /// What it said.
        message: String,
    },
    /// A screenshot that is no picture.
    #[error("page {page}: the screenshot of {what} cannot be read")]
    Screenshot {
        /// The page.
        page: &'static str,
        /// The element.
        what: &'static str,
    },
    /// The console of the browser has a warning or an error.
    #[error("page {page}: the browser complains: {message}")]
    Complaint {
        /// The page.
        page: &'static str,
        /// What it said.
        message: String,
    },
    /// A page asked for something besides itself.
    #[error("page {page}: it asks for {url}")]
    Request {
        /// The page.
        page: &'static str,
        /// What it asked for.
        url: String,
    },
    /// A picture that shows nothing, or nothing else than before.
    #[error("page {page}: {what}: found {found}, expected {expected}")]
    Differs {
        /// The page.
        page: &'static str,
        /// What was looked at.
        what: String,
        /// What it is.
        found: String,
        /// What it should be.
        expected: String,
    },
}
