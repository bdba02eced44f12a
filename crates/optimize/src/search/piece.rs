//! A piece of the boundary, as a number.
#![allow(
    clippy::cast_possible_truncation,
    reason = "there are fewer than twice as many groups as stretches, which are in memory"
)]

/// The bits of a piece that tell the part of its stretch; the others tell the group.
const PART_BITS: u32 = 32;

/// Stretches are halved this many times at most.
const DEEPEST: u32 = PART_BITS - 1;

/// A group of stretches, of edges or of faces, with like wrenches, or a dyadic part of a single
/// one: 1 is the whole, `2 i` and `2 i + 1` are the halves of part `i`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Piece(u64);

impl Piece {
    /// The whole boundary.
    pub(crate) const BOUNDARY: Self = Self::whole(0);

    /// The whole of a group.
    pub(crate) const fn whole(group: u32) -> Self {
        Self((group as u64) << PART_BITS | 1)
    }

    pub(crate) const fn group(self) -> usize {
        (self.0 >> PART_BITS) as usize
    }

    pub(crate) const fn part(self) -> u64 {
        self.0 & ((1 << PART_BITS) - 1)
    }

    /// The halves of a part of a single stretch; `None` where there is nothing left to halve.
    pub(crate) fn halves(self) -> Option<[Self; 2]> {
        let (part, group) = (self.part(), self.0 - self.part());
        let halves = || [2 * part, 2 * part + 1].map(|half| Self(group + half));
        (part.ilog2() < DEEPEST).then(halves)
    }

    /// Where it begins and ends along its stretch, if it is of one, whose length is 1.
    pub(crate) fn along(self) -> (f64, f64) {
        let depth = self.part().ilog2();
        let size = (1_u64 << depth) as f64;
        let place = (self.part() - (1 << depth)) as f64;
        (place / size, (place + 1.0) / size)
    }
}
