//! `cargo xtask browser`: the pages of `--report` in a browser without a screen.
//!
//! A step of its own beside the tests, since it needs Chromium and its driver.

mod checks;
mod driver;
mod error;
mod pages;

use std::fs;

use crate::failure::Failure;
use crate::workspace::ROOT;

pub(crate) use error::BrowserError;

/// Makes a page of each kind, opens it, and holds what is seen against what was computed.
pub(crate) fn run() -> Result<(), Failure> {
    checked().map_err(Failure::Browser)
}

fn checked() -> Result<(), BrowserError> {
    let folder = std::path::Path::new(ROOT).join("target/browser");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).map_err(|source| BrowserError::File { source })?;
    let driver = driver::Driver::start()?;
    let browser = driver.browser()?;
    for page in pages::all() {
        let made = page.make(&folder)?;
        checks::all(&browser, &page, &made)?;
        println!("{}: as it should be, {} kB", page.name, made.size / 1000);
    }
    browser.close()
}
