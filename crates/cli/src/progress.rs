//! A progress bar for searches that take their time.

use std::time::{Duration, Instant};

use clench::optimize::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget};

/// Whatever is faster needs no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// A bar on standard error, if that is a terminal; gone when the search ends.
#[derive(Debug)]
pub(crate) struct ProgressLine {
    started: Instant,
    bar: Option<ProgressBar>,
}

impl ProgressLine {
    /// The bar of a search that starts now.
    pub(crate) fn start() -> Self {
        Self { started: Instant::now(), bar: None }
    }

    /// Shows how far the search is.
    pub(crate) fn watch(&mut self, progress: &Progress) {
        if self.bar.is_none() && self.started.elapsed() < PATIENCE {
            return;
        }
        let target = ProgressDrawTarget::stderr;
        let bar = self
            .bar
            .get_or_insert_with(|| ProgressBar::with_draw_target(Some(progress.total), target()));
        bar.set_position(progress.settled);
    }
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
