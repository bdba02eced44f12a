//! The search itself: nodes are opened best bound first, in rounds.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::ops::ControlFlow;
use std::time::Instant;

use rayon::prelude::*;

use super::floor::{Floor, above, below};
use super::leaders::{Candidate, Leaders};
use super::piece::Piece;
use crate::{Effort, Ended, Progress};

/// A round takes this part of the open nodes, within these limits: few in a small search, where
/// the next round knows better, and enough to share among threads in a large one.
const ROUND_PART: usize = 4;
const SMALLEST_ROUND: usize = 32;
const LARGEST_ROUND: usize = 2048;

/// A thread takes at least this many nodes at a time, and fewer than a few of these are not shared:
/// to wake threads takes some ten microseconds, a node about one.
const SMALLEST_SHARE: usize = 32;

/// What is searched for.
pub(crate) trait Problem<const K: usize>: Sync {
    /// Where the fingers of a candidate are.
    type Place: Copy + Send + Sync;

    /// What bounding a node found out that helps with its halves.
    type Hint: Clone + Send + Sync;

    /// With more open nodes than this, they are opened in the order last in, first out, which
    /// bounds their number by rounds times depth.
    const MOST_OPEN: usize;

    /// A probe is made once in so many nodes, and no more than one in a round.
    const NODES_PER_PROBE: u64;

    /// The two halves of a piece; `None` where there is nothing left to halve.
    fn halves(&self, piece: Piece) -> Option<[Piece; 2]>;

    /// What qualities are multiplied by to be stiffnesses (force / length).
    fn unit(&self) -> f64;

    /// The combination that a node is on, ascending, if its pieces are on one stretch each.
    fn combination(&self, node: &[Piece; K]) -> Option<[usize; K]>;

    /// The bound of `node`; `None` when no placement on it exceeds `floor`. The hint is that of the
    /// node that it is a half of.
    fn bound(
        &self,
        node: &[Piece; K],
        floor: &Floor,
        hint: Option<&Self::Hint>,
    ) -> Option<Bounded<Self::Hint>>;

    /// A good placement, if one is found: near the middle of `node`, or from a start of its own for
    /// each number.
    fn probe(&self, node: &[Piece; K], number: u64) -> Option<Candidate<K, Self::Place>>;

    /// Looks for a placement on `node`; what is found need not be on it.
    fn settle(&self, node: &[Piece; K], floor: &Floor) -> Settled<K, Self::Place>;
}

/// What is known of a node.
#[derive(Clone, Debug)]
pub(crate) struct Bounded<H> {
    /// What no placement on it surpasses.
    pub(crate) bound: f64,
    /// The finger whose piece to halve.
    pub(crate) split: usize,
    pub(crate) hint: H,
}

/// What became of a node.
pub(crate) enum Settled<const K: usize, P> {
    /// Its best placement that exceeds the floor, if there is one.
    Solved {
        best: Option<Candidate<K, P>>,
        /// None that was left out is better.
        left: f64,
    },
    /// It has to be halved further; some placement that exceeds the floor, if one was seen.
    Open(Option<Candidate<K, P>>),
}

/// Pieces that the fingers are on, ascending.
#[derive(Clone, Debug)]
struct Node<const K: usize, H> {
    bounded: Bounded<H>,
    pieces: [Piece; K],
}

/// By bound, then by pieces: never by arrival.
impl<const K: usize, H> Ord for Node<K, H> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bounded
            .bound
            .total_cmp(&other.bounded.bound)
            .then_with(|| other.pieces.cmp(&self.pieces))
    }
}

impl<const K: usize, H> PartialOrd for Node<K, H> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const K: usize, H> PartialEq for Node<K, H> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<const K: usize, H> Eq for Node<K, H> {}

/// How a search ended.
#[derive(Clone, Debug)]
pub(crate) struct Searched<const K: usize, P> {
    pub(crate) leaders: Leaders<K, P>,
    pub(crate) ended: Ended,
    /// No placement has a larger quality.
    pub(crate) upper_bound: f64,
    pub(crate) nodes: u64,
    pub(crate) solved: u64,
}

/// What a thread found in its share of a round.
struct Share<const K: usize, P: Problem<K>> {
    open: Vec<Node<K, P::Hint>>,
    candidates: Vec<Candidate<K, P::Place>>,
    /// The largest bound of what was left out though it may exceed the floor.
    dropped: f64,
    nodes: u64,
    solved: u64,
}

impl<const K: usize, P: Problem<K>> Share<K, P> {
    const fn new() -> Self {
        Self { open: Vec::new(), candidates: Vec::new(), dropped: 0.0, nodes: 0, solved: 0 }
    }

    fn join(mut self, other: Self) -> Self {
        self.open.extend(other.open);
        self.candidates.extend(other.candidates);
        Self {
            dropped: self.dropped.max(other.dropped),
            nodes: self.nodes + other.nodes,
            solved: self.solved + other.solved,
            ..self
        }
    }
}

/// Searches from `leaders` on.
///
/// The nodes of a round are bounded against the floor of the rounds before, so nothing that is
/// found depends on the threads.
pub(crate) fn search<const K: usize, P: Problem<K>>(
    problem: &P,
    mut leaders: Leaders<K, P::Place>,
    effort: &Effort,
    mut watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Searched<K, P::Place> {
    let unit = problem.unit();
    let started = Instant::now();
    let mut open = Open::<K, P::Hint>::new(P::MOST_OPEN);
    let (mut probes, mut nodes, mut solved, mut dropped) = (0, 0, 0, 0.0_f64);
    let ended = loop {
        let round = Round { problem, leaders: &leaders, floor: leaders.floor(), gap: effort.gap };
        let mut found = Share::<K, P>::new();
        let mut probed = None;
        if nodes == 0 {
            round.visit([Piece::BOUNDARY; K], None, &mut found);
        } else {
            let chosen = open.round();
            let first = chosen.first().map(|node| node.pieces);
            let due = nodes >= probes * P::NODES_PER_PROBE;
            let first = first.filter(|_| due);
            let number = probes;
            probes += u64::from(due);
            let probe = || first.and_then(|first| problem.probe(&first, number));
            (found, probed) = if chosen.len() < 4 * SMALLEST_SHARE {
                (round.open_some(&chosen), probe())
            } else {
                rayon::join(|| round.open_all(&chosen), probe)
            };
        }
        nodes += found.nodes;
        solved += found.solved;
        dropped = dropped.max(found.dropped);
        leaders.merge(found.candidates.into_iter().chain(probed));
        open.extend(found.open);
        let best = leaders.best();
        let upper_bound = open.largest().max(dropped).max(best.unwrap_or(0.0));
        if open.is_empty() {
            // What was left out is no better than the last of those that were asked for.
            let proved = dropped <= above(leaders.floor().quality);
            break if proved { Ended::Proved } else { Ended::Gap };
        }
        let seconds = started.elapsed();
        let flow = watch(&Progress {
            best: best.map(|best| best * unit),
            upper_bound: upper_bound * unit,
            nodes,
            open: open.len(),
            elapsed: seconds,
        });
        if flow.is_break() {
            break Ended::Cancelled;
        }
        if effort.time.is_some_and(|time| seconds >= time) {
            break Ended::Time;
        }
        if effort.nodes.is_some_and(|most| nodes >= most) {
            break Ended::Nodes;
        }
    };
    let upper_bound = open.largest().max(dropped).max(leaders.best().unwrap_or(0.0));
    Searched { leaders, ended, upper_bound, nodes, solved }
}

/// What the nodes of a round are held against.
struct Round<'a, const K: usize, P: Problem<K>> {
    problem: &'a P,
    leaders: &'a Leaders<K, P::Place>,
    floor: Floor,
    gap: f64,
}

impl<const K: usize, P: Problem<K>> Round<'_, K, P> {
    /// Divides nodes, on all threads.
    fn open_all(&self, nodes: &[Node<K, P::Hint>]) -> Share<K, P> {
        let shares = nodes.par_chunks(SMALLEST_SHARE).map(|nodes| self.open_some(nodes));
        shares.reduce(Share::new, Share::join)
    }

    /// Divides nodes.
    fn open_some(&self, nodes: &[Node<K, P::Hint>]) -> Share<K, P> {
        let mut share = Share::new();
        for node in nodes {
            let bound = node.bounded.bound;
            if bound > self.threshold(&self.floor) {
                self.halve(node, &mut share);
            } else {
                share.dropped = share.dropped.max(bound);
            }
        }
        share
    }

    /// Bounds the nodes that halving a piece of `node` makes.
    fn halve(&self, node: &Node<K, P::Hint>, share: &mut Share<K, P>) {
        let piece = node.pieces[node.bounded.split];
        let Some([left, right]) = self.problem.halves(piece) else {
            share.dropped = share.dropped.max(node.bounded.bound);
            return;
        };
        // Fingers are exchangeable: of those on this piece, the first ones go to the left half.
        let count = node.pieces.iter().filter(|&&p| p == piece).count();
        for lefts in 0..=count {
            let mut pieces = node.pieces;
            for (place, p) in pieces.iter_mut().filter(|p| **p == piece).enumerate() {
                *p = if place < lefts { left } else { right };
            }
            pieces.sort_unstable();
            self.visit(pieces, Some(&node.bounded), share);
        }
    }

    /// Bounds a node, a half of one that is bounded already, and looks for a placement on it.
    fn visit(&self, pieces: [Piece; K], whole: Option<&Bounded<P::Hint>>, share: &mut Share<K, P>) {
        share.nodes += 1;
        let floor = self.floor_of(&pieces);
        let hint = whole.map(|whole| &whole.hint);
        let Some(mut bounded) = self.problem.bound(&pieces, &floor, hint) else { return };
        let limit = whole.map_or(f64::INFINITY, |whole| whole.bound);
        bounded.bound = bounded.bound.min(limit);
        if bounded.bound <= self.threshold(&floor) {
            share.dropped = share.dropped.max(bounded.bound);
            return;
        }
        match self.problem.settle(&pieces, &floor) {
            Settled::Solved { best, left } => {
                share.solved += 1;
                share.dropped = share.dropped.max(left);
                share.candidates.extend(best);
            }
            Settled::Open(candidate) => {
                share.candidates.extend(candidate);
                share.open.push(Node { bounded, pieces });
            }
        }
    }

    /// What a placement on a node has to exceed: the last of the leaders, or the one on the same
    /// combination.
    fn floor_of(&self, pieces: &[Piece; K]) -> Floor {
        let combination = self.problem.combination(pieces);
        combination.and_then(|stretches| self.leaders.on(stretches)).unwrap_or(self.floor)
    }

    /// What a bound has to exceed for its node to be opened.
    fn threshold(&self, floor: &Floor) -> f64 {
        below(floor.quality) * (1.0 + self.gap)
    }
}

/// The open nodes.
struct Open<const K: usize, H> {
    heap: BinaryHeap<Node<K, H>>,
    /// Those that the heap has no room for, opened first.
    stack: Vec<Node<K, H>>,
    /// How many the heap has room for.
    most: usize,
}

impl<const K: usize, H> Open<K, H> {
    const fn new(most: usize) -> Self {
        Self { heap: BinaryHeap::new(), stack: Vec::new(), most }
    }

    fn len(&self) -> usize {
        self.heap.len() + self.stack.len()
    }

    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn largest(&self) -> f64 {
        let stack = self.stack.iter().map(|n| n.bounded.bound).max_by(f64::total_cmp);
        self.heap.peek().map_or(0.0, |n| n.bounded.bound).max(stack.unwrap_or(0.0))
    }

    fn extend(&mut self, mut nodes: Vec<Node<K, H>>) {
        if self.heap.len() + nodes.len() <= self.most {
            self.heap.extend(nodes);
        } else {
            nodes.sort_unstable();
            self.stack.extend(nodes);
        }
    }

    /// The nodes to open next.
    fn round(&mut self) -> Vec<Node<K, H>> {
        let count = (self.len() / ROUND_PART).clamp(SMALLEST_ROUND, LARGEST_ROUND);
        if self.stack.is_empty() {
            return (0..count).map_while(|_| self.heap.pop()).collect();
        }
        let rest = self.stack.len().saturating_sub(count);
        self.stack.split_off(rest)
    }
}
