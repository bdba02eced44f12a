//! Fingers that are springs, four or more: what is searched, bounded and solved.

use clench_screw::Vector;

use super::Fingers;
use super::ascent::{ascents, climb};
use super::bound::{Demand, Pieces, Relaxation};
use super::closed_form::Quadruple;
use super::crowded::Crowded;
use super::rating::{PUSHING, Rating, Spot, moments, rate, shares};
use super::scene::Scene;
use super::tips::{Keeping, Tips};
use crate::search::{Bounded, Candidate, Floor, Piece, Problem, Settled, above, below};
use crate::{Objective, OptimizeError, Placement, Solution};

/// A share below this is rounding of 0.
const NO_SHARE: f64 = 1e-12;

/// From the middle of a node a first step is this part of its largest piece.
const PROBE_PART: usize = 4;

/// Spring fingers on a part: what placements are worth, and which is best on four stretches.
#[derive(Clone, Copy, Debug)]
pub(super) struct Springs<'a> {
    pub(super) scene: &'a Scene<'a>,
    pub(super) fingers: &'a Fingers,
}

/// The scaled moments of the fingers.
pub(super) type Moments<const K: usize> = [f64; K];

impl Springs<'_> {
    /// Placements to begin with.
    pub(super) fn first<const K: usize>(&self) -> Vec<Candidate<K, Moments<K>>> {
        let rate = |spots: &[Spot; K], floor| self.rated_apart(spots, floor);
        let tops = ascents(self.scene.supports.len(), rate, !self.is_enumerable::<K>());
        tops.into_iter().filter_map(|(_, spots)| self.candidate(&spots)).collect()
    }

    /// Whether combinations of stretches are solved by enumeration.
    fn is_enumerable<const K: usize>(&self) -> bool {
        K == 4 && self.fingers.objective != Objective::WorstPoint
    }

    /// The least share that bounds count with. Combinations that are solved may have limits with a
    /// share of 0; where placements are rated, all have to push.
    fn least_share<const K: usize>(&self) -> f64 {
        let least = self.fingers.least_share;
        if self.is_enumerable::<K>() { least } else { least.max(PUSHING) }
    }

    /// Whether fingers of a candidate on two edges are too near to each other.
    pub(super) fn is_crowded<const K: usize>(&self, found: &Candidate<K, Moments<K>>) -> bool {
        let keeping = Keeping::asked(self.scene, self.fingers);
        let pair = keeping.and_then(|keeping| keeping.nearest_pair(&found.stretches, &found.place));
        pair.is_some()
    }

    /// The least `sigma_min` that is asked for, in the scene's unit.
    fn least_translation(&self) -> f64 {
        self.fingers.objective.least_translation() / self.scene.stiffness_unit
    }

    /// What is maximized, and what among ties.
    pub(super) fn objectives(&self, rating: &Rating) -> (f64, f64) {
        match self.fingers.objective {
            Objective::Rotation { .. } => (rating.equivalent, rating.sigma_min),
            Objective::WorstPoint => (rating.worst_point, rating.worst_point),
            Objective::Quality => (rating.sigma_min.min(rating.equivalent), rating.equivalent),
        }
    }

    /// The objectives of four fingers whose stretches, so `sigma_min`, are given.
    fn of_combination(&self, sigma_min: f64, equivalent: f64) -> (f64, f64) {
        self.objectives(&Rating { sigma_min, equivalent, worst_point: 0.0 })
    }

    /// What `mu_eq` has to exceed on four stretches with this `sigma_min` to exceed the floor;
    /// `None` if no `mu_eq` does.
    fn least_equivalent(&self, sigma_min: f64, floor: &Floor) -> Option<f64> {
        let (most, second) = self.of_combination(sigma_min, f64::INFINITY);
        let is_enough = sigma_min >= below(self.least_translation());
        // Where translation allows a tie and no more, the second objective decides.
        let least = if most <= above(floor.quality) { floor.second } else { floor.quality };
        (is_enough && floor.is_exceeded_by(most, second)).then_some(least)
    }

    /// A placement as a candidate, if it holds, fulfills what is asked for and has more than a
    /// quality of `floor`.
    fn rated<const K: usize>(
        &self,
        spots: &[Spot; K],
        floor: f64,
    ) -> Option<Candidate<K, Moments<K>>> {
        let mut spots = *spots;
        spots.sort_by_key(|spot| spot.stretch);
        let (stretches, place) = (spots.map(|spot| spot.stretch), moments(self.scene, &spots));
        let wanted = |rating: &Rating| self.objectives(rating).0 > floor;
        let rating = rate(self.scene, self.fingers, &stretches, &place, wanted)?;
        if rating.sigma_min < below(self.least_translation()) {
            return None;
        }
        let (quality, second) = self.objectives(&rating);
        (quality > floor).then_some(Candidate { stretches, quality, second, place })
    }

    /// The value of a placement, and where its fingers are, those that would be too near to each
    /// other apart.
    fn rated_apart<const K: usize>(
        &self,
        spots: &[Spot; K],
        floor: f64,
    ) -> Option<(f64, [Spot; K])> {
        let keeping = Keeping::asked(self.scene, self.fingers);
        let spots = keeping.map_or(*spots, |keeping| keeping.parted(spots));
        self.rated(&spots, floor).map(|found| (found.quality, spots))
    }

    /// The best that is known on the stretches of a placement.
    fn candidate<const K: usize>(&self, spots: &[Spot; K]) -> Option<Candidate<K, Moments<K>>> {
        if self.is_enumerable::<K>() {
            let mut stretches = spots.map(|spot| spot.stretch);
            stretches.sort_unstable();
            return match self.settled(stretches, &Floor::NONE) {
                Settled::Solved { best, .. } | Settled::Open(best) => best,
            };
        }
        self.rated(spots, 0.0)
    }

    /// The best placement on four stretches, ascending, if it exceeds `floor`.
    pub(super) fn solve<const K: usize>(
        &self,
        stretches: [usize; K],
        floor: &Floor,
    ) -> Option<Candidate<K, Moments<K>>> {
        let four: [usize; 4] = stretches.as_slice().try_into().ok()?;
        let sigma_min = self.scene.sigma_min(&four);
        let least = self.least_equivalent(sigma_min, floor)?;
        let quadruple = Quadruple::new(self.scene, four, self.fingers)?;
        if quadruple.bound() <= below(least) {
            return None;
        }
        let peak = quadruple.peak(below(least))?;
        let found = quadruple.moments(peak.d, peak.z);
        let place = std::array::from_fn(|i| found[i]);
        let (quality, second) = self.of_combination(sigma_min, peak.equivalent);
        let found = Candidate { stretches, quality, second, place };
        floor.is_exceeded_by(quality, second).then_some(found)
    }

    /// What becomes of four stretches, ascending: solved, where tips are too near to each other by
    /// dividing.
    fn settled<const K: usize>(
        &self,
        stretches: [usize; K],
        floor: &Floor,
    ) -> Settled<K, Moments<K>> {
        let solved = self.solve(stretches, floor);
        let whole = |best| Settled::Solved { best, left: 0.0 };
        let Some(crowded) = solved.as_ref().filter(|found| self.is_crowded(found)) else {
            return whole(solved);
        };
        let keeping = Keeping::asked(self.scene, self.fingers);
        let four: Option<[usize; 4]> = stretches.as_slice().try_into().ok();
        let Some((keeping, four)) = keeping.zip(four) else { return whole(None) };
        let sigma_min = self.scene.sigma_min(&four);
        let Some(least) = self.least_equivalent(sigma_min, floor) else { return whole(None) };
        let apart = Crowded { springs: *self, keeping, stretches: four }.best(below(least));
        let best = apart.best.and_then(|(equivalent, moments)| {
            let (quality, second) = self.of_combination(sigma_min, equivalent);
            let place = std::array::from_fn(|i| moments[i]);
            let found = Candidate { stretches, quality, second, place };
            floor.is_exceeded_by(quality, second).then_some(found)
        });
        let left = self.of_combination(sigma_min, apart.bound).0.min(crowded.quality);
        // What is no better than the best of these stretches is not left out.
        let found = best.as_ref().map_or(0.0, |best| best.quality);
        Settled::Solved { best, left: if left <= above(found) { 0.0 } else { left } }
    }

    /// The fingers of a candidate.
    pub(super) fn solution<const K: usize>(
        &self,
        candidate: &Candidate<K, Moments<K>>,
    ) -> Result<Solution<2, 1>, OptimizeError> {
        let supports = candidate.stretches.map(|s| &self.scene.supports[s]);
        let points: [Vector<2>; K] =
            std::array::from_fn(|i| supports[i].point(candidate.place[i], self.scene.center));
        let center = self.scene.center_of_compliance(&candidate.stretches, &candidate.place);
        let wrenches = std::array::from_fn(|i| {
            let [x, y] = supports[i].arm.to_array();
            let moment = candidate.place[i] - supports[i].arm.dot(center);
            Vector::new([x, y, moment / self.scene.radius]) * supports[i].weight.recip()
        });
        // No answer has wrenches that do not span their space.
        let shares = shares(&wrenches).map_or([0.0; K], |shares| shares.all);
        let placement = |i: usize| Placement {
            on: supports[i].edge,
            point: points[i],
            inward_normal: supports[i].normal,
            share: if shares[i] > NO_SHARE { shares[i] } else { 0.0 },
        };
        let mut placements: Vec<_> = (0..K).map(placement).collect();
        let outline = self.scene.part.outline();
        let along = |p: &Placement<2>| (p.point - outline.edges()[p.on].start()).norm_squared();
        placements.sort_by(|p, q| p.on.cmp(&q.on).then(along(p).total_cmp(&along(q))));
        let mut solution = Solution::of_first_order(self.scene.part, placements)?;
        solution.objective = match self.fingers.objective {
            Objective::Quality => solution.quality.value,
            Objective::Rotation { .. } => solution.quality.equivalent(),
            Objective::WorstPoint => solution.worst_point(self.scene.part)?.stiffness,
        };
        Ok(solution)
    }
}

/// The search for the best placement of spring fingers.
#[derive(Debug)]
pub(super) struct SpringSearch<'a> {
    springs: Springs<'a>,
    pub(super) pieces: Pieces<3>,
    /// If they have to keep a distance.
    tips: Option<Tips<'a>>,
}

impl<'a> SpringSearch<'a> {
    pub(super) fn new(springs: Springs<'a>) -> Self {
        let pieces = springs.scene.wrenches();
        let keeping = Keeping::asked(springs.scene, springs.fingers);
        let tips = keeping.map(|keeping| Tips::new(keeping, &pieces));
        Self { springs, pieces, tips }
    }
}

impl<const K: usize> Problem<K> for SpringSearch<'_> {
    type Place = Moments<K>;
    type Hint = ();

    /// About 50 megabytes for four fingers.
    const MOST_OPEN: usize = 1 << 20;
    const NODES_PER_PROBE: u64 = 0;

    fn halves(&self, piece: Piece) -> Option<[Piece; 2]> {
        self.pieces.halves(piece)
    }

    fn unit(&self) -> f64 {
        self.springs.scene.stiffness_unit
    }

    fn combination(&self, node: &[Piece; K]) -> Option<[usize; K]> {
        self.pieces.combination(node)
    }

    fn bound(&self, node: &[Piece; K], floor: &Floor, _: Option<&()>) -> Option<Bounded<()>> {
        let springs = &self.springs;
        if self.tips.as_ref().is_some_and(|tips| tips.are_crowded(node, &self.pieces)) {
            return None;
        }
        let relaxation = Relaxation {
            scene: springs.scene,
            pieces: &self.pieces,
            least_share: springs.least_share::<K>(),
            whole_stretches: springs.is_enumerable::<K>(),
            tips: self.tips.as_ref(),
        };
        let (bound, split) = match springs.fingers.objective {
            Objective::Quality => floor.bound(|demand| relaxation.verdict(node, demand)),
            Objective::Rotation { .. } => floor
                .rotation_bound(below(springs.least_translation()), |demand| {
                    relaxation.verdict(node, demand)
                }),
            Objective::WorstPoint => {
                let demand = Demand::worst_point(below(floor.quality));
                let verdict = relaxation.verdict(node, &demand)?;
                Some((demand.rotation + verdict.surplus, verdict.split))
            }
        }?;
        Some(Bounded { bound, split, hint: () })
    }

    fn probe(&self, node: &[Piece; K], _: u64) -> Option<Candidate<K, Self::Place>> {
        let springs = &self.springs;
        let stretches = node.iter().map(|&piece| self.pieces.stretches(piece).len()).max();
        let spots = node.map(|piece| self.pieces.middle(piece));
        let rate = |spots: &[Spot; K], floor| springs.rated_apart(spots, floor);
        let from = rate(&spots, 0.0).unwrap_or((0.0, spots));
        let fine = !springs.is_enumerable::<K>();
        let first_step = stretches.unwrap_or(1) / PROBE_PART;
        let (value, spots) = climb(springs.scene.supports.len(), &rate, from, first_step, fine);
        (value > 0.0).then(|| springs.candidate(&spots)).flatten()
    }

    fn settle(&self, node: &[Piece; K], floor: &Floor) -> Settled<K, Self::Place> {
        let springs = &self.springs;
        let Some(stretches) = self.pieces.combination(node) else { return Settled::Open(None) };
        if springs.is_enumerable::<K>() {
            return springs.settled(stretches, floor);
        }
        let spots = node.map(|piece| self.pieces.middle(piece));
        let apart = springs.rated_apart(&spots, below(floor.quality));
        let found = apart.and_then(|(_, spots)| springs.rated(&spots, 0.0));
        Settled::Open(found.filter(|found| floor.is_exceeded_by(found.quality, found.second)))
    }
}
