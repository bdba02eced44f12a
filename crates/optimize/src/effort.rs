//! How much a search may cost, and how it ended.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::time::Duration;

use crate::{OptimizeError, Progress};

/// What a search is asked for, and when it may stop before all is proved.
///
/// ```
/// use clench_optimize::Effort;
/// let effort = Effort { gap: 1e-3, nodes: Some(1_000_000), ..Effort::default() };
/// assert!(effort.time.is_none() && effort.top.get() == 1);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// How many of the best combinations to return.
    pub top: NonZeroUsize,
    /// The search may stop when no placement can be better than what is returned by more than this
    /// part of it; 0 to prove that none is better at all.
    pub gap: f64,
    /// It stops after this time, looked at once a round, some milliseconds.
    pub time: Option<Duration>,
    /// It stops after bounding this many nodes, looked at once a round. Unlike with a time, the
    /// outcome is always the same.
    pub nodes: Option<u64>,
}

impl Default for Effort {
    /// The one best combination, with a full proof, however long that takes.
    fn default() -> Self {
        Self { top: NonZeroUsize::MIN, gap: 0.0, time: None, nodes: None }
    }
}

impl Effort {
    pub(crate) fn checked(&self) -> Result<(), OptimizeError> {
        if self.gap >= 0.0 && self.gap.is_finite() {
            Ok(())
        } else {
            Err(OptimizeError::Gap { value: self.gap })
        }
    }
}

/// Watches a search without looking: it goes on until it ends by itself.
///
/// What to hand to a search that nobody waits for, in place of a closure that shows the progress,
/// or breaks to stop it.
pub const fn unwatched(_: &Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Why a search ended. Whichever it was, its upper bound holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// No placement is better than the best one, up to rounding, and none on other combinations
    /// is better than the last that is returned.
    Proved,
    /// What is left cannot be better than what is returned by more than the relative gap.
    Gap,
    /// The time was over.
    Time,
    /// The nodes were used up.
    Nodes,
    /// The caller stopped it.
    Cancelled,
}
