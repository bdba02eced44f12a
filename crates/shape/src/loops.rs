//! The closed chains of corners that bound a planar part.

use std::ops::Range;

/// The outer loop of a part and those of its holes, as runs of its corners.
///
/// Corners are numbered through, and edge `e` starts at corner `e`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Loops(Vec<Range<usize>>);

impl Loops {
    /// Loops of so many corners each, one after the other.
    pub(crate) fn of_lengths(lengths: impl Iterator<Item = usize>) -> Self {
        let mut start = 0;
        let run = |length: usize| {
            let run = start..start + length;
            start = run.end;
            run
        };
        Self(lengths.map(run).collect())
    }

    /// The runs of corners, the outer loop first.
    pub(crate) fn runs(&self) -> &[Range<usize>] {
        &self.0
    }

    /// The corner after `corner`.
    pub(crate) fn after(&self, corner: usize) -> usize {
        let run = self.of(corner);
        if corner + 1 == run.end { run.start } else { corner + 1 }
    }

    /// The corner before `corner`.
    pub(crate) fn before(&self, corner: usize) -> usize {
        let run = self.of(corner);
        if corner == run.start { run.end - 1 } else { corner - 1 }
    }

    /// The loop that `corner` is on.
    fn of(&self, corner: usize) -> &Range<usize> {
        let place = self.0.partition_point(|run| run.end <= corner);
        &self.0[place]
    }
}
