//! Fingers on a solid: what is searched, bounded and rated.

use std::time::Instant;

use clench_screw::Screw;
use rayon::prelude::*;

use super::ascent::{Ascent, Climber};
use super::bound::{Contacts, Hint, Pieces, Relaxation, helped_twist};
use super::rating::{Rating, Spot, Worth};
use crate::search::{Bounded, Candidate, Floor, Piece, Problem, Settled};

/// Ascents to begin with, and how many of the best are swept.
const STARTS: u64 = 16;
const SWEPT: usize = 2;

/// One of so many probes is swept.
const PROBES_PER_SWEEP: u64 = 16;

/// Steps in which a motion that everything helps is looked for.
const ESCAPE_STEPS: usize = 1000;

/// The search for the best placement of fingers on a solid.
#[derive(Debug)]
pub(super) struct SpatialSearch<'a> {
    rating: Rating<'a>,
    pieces: &'a Pieces<'a>,
    relaxation: Relaxation<'a>,
}

impl<'a> SpatialSearch<'a> {
    pub(super) fn new(rating: Rating<'a>, pieces: &'a Pieces<'a>) -> Self {
        Self { rating, pieces, relaxation: Relaxation::new(rating, pieces) }
    }

    /// A motion that no force on the whole surface, and of no fixed contact, opposes.
    pub(super) fn escape(&self) -> Option<Screw> {
        let corners = [self.pieces.corners(Piece::BOUNDARY)];
        let contacts = Contacts {
            fingers: &corners,
            weights: &[1.0],
            fixed: &self.rating.scene.fixed,
            least_share: 0.0,
            longest: self.rating.scene.longest_wrench,
        };
        let twist = helped_twist(&contacts, ESCAPE_STEPS)?;
        Some(self.rating.scene.unscaled_twist(twist).screw())
    }

    /// Placements to begin with.
    pub(super) fn first<const K: usize>(
        &self,
        deadline: Option<Instant>,
    ) -> Vec<Candidate<K, [Spot; K]>> {
        let ascent = |seed| Ascent::new(self.rating, seed).until(deadline);
        let seeds: Vec<u64> = (0..STARTS).collect();
        let ascents = seeds.par_iter().map(|&seed| ascent(seed).by_chance());
        let mut found: Vec<Climber<K>> =
            ascents.collect::<Vec<_>>().into_iter().flatten().collect();
        found.sort_by(|a, b| b.0.partial_cmp(&a.0).unwrap_or(std::cmp::Ordering::Equal));
        let best: Vec<Climber<K>> = found.iter().take(SWEPT).copied().collect();
        let swept = best.par_iter().map(|&start| ascent(STARTS).swept(start));
        found.extend(swept.collect::<Vec<_>>());
        found.into_iter().filter_map(candidate).collect()
    }
}

impl<const K: usize> Problem<K> for SpatialSearch<'_> {
    type Place = [Spot; K];
    type Hint = Hint;

    /// About 250 megabytes for seven fingers.
    const MOST_OPEN: usize = 1 << 19;
    /// An ascent takes about as long.
    const NODES_PER_PROBE: u64 = 1000;

    fn halves(&self, piece: Piece) -> Option<[Piece; 2]> {
        self.pieces.halves(piece)
    }

    fn unit(&self) -> f64 {
        self.rating.scene.stiffness_unit
    }

    fn combination(&self, node: &[Piece; K]) -> Option<[usize; K]> {
        let mut patches = [0; K];
        for (patch, &piece) in patches.iter_mut().zip(node) {
            *patch = self.pieces.patch(piece)?;
        }
        patches.sort_unstable();
        Some(patches)
    }

    fn bound(
        &self,
        node: &[Piece; K],
        floor: &Floor,
        hint: Option<&Hint>,
    ) -> Option<Bounded<Hint>> {
        self.relaxation.bound(node, floor, hint)
    }

    fn probe(&self, node: &[Piece; K], number: u64) -> Option<Candidate<K, Self::Place>> {
        let mut ascent = Ascent::new(self.rating, STARTS + 1 + number);
        let spots = node.map(|piece| self.pieces.middle(piece));
        let near = self
            .rating
            .above(&spots, Worth::Loose(f64::NEG_INFINITY))
            .and_then(|worth| ascent.from((worth, spots)));
        let far = ascent.by_chance();
        let best = match (near, far) {
            (Some(near), Some(far)) => Some(if far.0 > near.0 { far } else { near }),
            (near, far) => near.or(far),
        }?;
        let sweeps = number.is_multiple_of(PROBES_PER_SWEEP);
        candidate(if sweeps { ascent.swept(best) } else { best })
    }

    fn settle(&self, node: &[Piece; K], floor: &Floor) -> Settled<K, Self::Place> {
        let spots = node.map(|piece| self.pieces.middle(piece));
        let floor_worth = match floor.quality {
            quality if quality > 0.0 => Worth::Held(quality, floor.second),
            _ => Worth::Loose(f64::NEG_INFINITY),
        };
        let found = self.rating.above(&spots, floor_worth);
        let found = found.and_then(|worth| candidate((worth, spots)));
        if node.iter().all(|&piece| self.pieces.is_point(piece)) {
            Settled::Solved { best: found, left: 0.0 }
        } else {
            Settled::Open(found)
        }
    }
}

/// A placement that holds, as a candidate.
fn candidate<const K: usize>((worth, mut place): Climber<K>) -> Option<Candidate<K, [Spot; K]>> {
    let Worth::Held(quality, second) = worth else { return None };
    let along = |p: &Spot, q: &Spot, i: usize| p.point[i].total_cmp(&q.point[i]);
    place.sort_by(|p, q| {
        let points = along(p, q, 0).then(along(p, q, 1)).then(along(p, q, 2));
        p.patch.cmp(&q.patch).then(points)
    });
    let stretches = place.map(|spot| spot.patch);
    Some(Candidate { stretches, quality, second, place })
}
