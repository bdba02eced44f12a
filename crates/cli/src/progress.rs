//! A line for searches that take their time.

use std::time::{Duration, Instant};

use clench::optimize::Progress;
use indicatif::{ProgressBar, ProgressStyle};

use crate::wording::{digits, rough_digits};

/// Whatever is faster needs no line.
const PATIENCE: Duration = Duration::from_secs(1);

/// The line does not change more often than this.
const PACE: Duration = Duration::from_millis(200);

/// A line on standard error, if that is a terminal; gone when the search ends.
#[derive(Debug)]
pub(crate) struct ProgressLine {
    /// The unit of what is maximized.
    unit: String,
    spinner: Option<ProgressBar>,
    written: Instant,
}

impl ProgressLine {
    /// The line of a search that starts now.
    pub(crate) fn start(unit: String) -> Self {
        Self { unit, spinner: None, written: Instant::now() }
    }

    /// Shows how far the search is.
    pub(crate) fn show(&mut self, progress: &Progress) {
        if progress.elapsed < PATIENCE {
            return;
        }
        if self.spinner.is_some() && self.written.elapsed() < PACE {
            return;
        }
        self.written = Instant::now();
        let message = message(progress, &self.unit);
        let spinner = self.spinner.get_or_insert_with(|| {
            let spinner = ProgressBar::new_spinner();
            // Without the template, the spinner has one of its own.
            match ProgressStyle::with_template("{spinner} {wide_msg}") {
                Ok(style) => spinner.with_style(style),
                Err(_) => spinner,
            }
        });
        spinner.set_message(message);
        spinner.tick();
    }
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        if let Some(spinner) = &self.spinner {
            spinner.finish_and_clear();
        }
    }
}

/// The state of a search in one line; what a narrow terminal cuts off is last.
fn message(progress: &Progress, unit: &str) -> String {
    let bound = digits(progress.upper_bound);
    let known = match progress.best {
        Some(best) => {
            let gap = rough_digits((progress.upper_bound / best - 1.0).max(0.0));
            format!("best {}, bound {bound} {unit}, gap {gap}", digits(best))
        }
        None => format!("nothing found yet, bound {bound} {unit}"),
    };
    let (nodes, open, seconds) = (progress.nodes, progress.open, progress.elapsed.as_secs());
    format!("{seconds} s: {known}; {nodes} nodes, {open} open")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_has_the_best_the_bound_and_the_effort() {
        let elapsed = Duration::from_millis(2900);
        let progress = Progress { best: None, upper_bound: 2.5, nodes: 70, open: 9, elapsed };
        let nothing = "2 s: nothing found yet, bound 2.5 N/mm; 70 nodes, 9 open";
        assert_eq!(message(&progress, "N/mm"), nothing);
        let found = "2 s: best 2, bound 2.5 N/mm, gap 0.25; 70 nodes, 9 open";
        assert_eq!(message(&Progress { best: Some(2.0), ..progress }, "N/mm"), found);
    }
}
