//! What a placement on a solid is worth.

use clench_metrics::{EquivalentStiffness, Principal, Quality, WorstPoint};
use clench_screw::{Stiffness, Vector, Wrench};
use clench_shape::ExtremePoints;

use super::scene::Scene;
use super::tips::{Tip, Tips};
use super::vectors::{first, second};
use super::{Fingers, PUSHING};
use crate::Objective;
use crate::search::below;
use crate::shares::shares;

/// A finger at a place: the number of its patch, and a point of that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    pub(super) patch: usize,
    pub(super) point: Vector<3>,
}

/// What a placement is worth, in the scene's unit of stiffness.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(super) enum Worth {
    /// It holds nothing: the least share of the balanced preload that is nearest to pushing.
    Loose(f64),
    /// What is maximized, and what among ties.
    Held(f64, f64),
}

/// Rates placements of `fingers` in a scene.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rating<'a> {
    pub(super) scene: &'a Scene<'a>,
    pub(super) fingers: &'a Fingers,
}

impl Rating<'_> {
    /// What a placement is worth, if that is more than `floor`; `None` also where too many fingers
    /// are on one patch, or too near to each other.
    pub(super) fn above(&self, spots: &[Spot], floor: Worth) -> Option<Worth> {
        if self.is_crowded(spots) || self.is_tight(spots) {
            return None;
        }
        if let Worth::Held(..) = floor {
            let principal = self.principal(spots)?;
            // Some points of the body show what is worse than the floor at less cost.
            let Scene { coarse, extremes, .. } = self.scene;
            let looked = coarse.points().len() < extremes.points().len();
            if looked && self.worth(&principal, coarse)? <= floor {
                return None;
            }
            let worth = self.worth(&principal, extremes).filter(|worth| *worth > floor)?;
            return (self.least_share(spots)? >= self.least()).then_some(worth);
        }
        let share = self.least_share(spots)?;
        if share < self.least() {
            return Some(Worth::Loose(share)).filter(|worth| *worth > floor);
        }
        self.worth(&self.principal(spots)?, &self.scene.extremes)
    }

    /// The least share that counts as pushing.
    pub(super) fn least(&self) -> f64 {
        self.fingers.least_share.max(PUSHING)
    }

    fn is_crowded(&self, spots: &[Spot]) -> bool {
        let most = self.scene.most_on_patch;
        spots.iter().any(|spot| spots.iter().filter(|s| s.patch == spot.patch).count() > most)
    }

    /// Whether fingers are too near to each other, or to given contacts.
    fn is_tight(&self, spots: &[Spot]) -> bool {
        self.scene.tips.as_ref().is_some_and(|tips| {
            let placed: Vec<Tip> = spots.iter().map(|&spot| self.tip(tips, spot)).collect();
            tips.are_crowded(&placed)
        })
    }

    /// The ball of a finger at a spot.
    pub(super) fn tip(&self, tips: &Tips, spot: Spot) -> Tip {
        tips.at(&self.scene.patches[spot.patch], spot.patch, spot.point)
    }

    /// The least share of the preload, how well it is known taken off.
    fn least_share(&self, spots: &[Spot]) -> Option<f64> {
        let found = shares(&self.unit_wrenches(spots))?;
        Some(found.least - found.rounding)
    }

    /// All unit wrenches: of the fingers, then of the fixed contacts.
    pub(super) fn unit_wrenches(&self, spots: &[Spot]) -> Vec<Vector<6>> {
        let placed = spots.iter().map(|s| self.scene.patches[s.patch].unit_wrench(s.point));
        placed.chain(self.scene.fixed.iter().map(|&(wrench, _)| wrench)).collect()
    }

    /// The shares of all contacts: of the fingers, then of the fixed contacts.
    pub(super) fn shares(&self, spots: &[Spot]) -> Vec<f64> {
        let count = spots.len() + self.scene.fixed.len();
        shares(&self.unit_wrenches(spots)).map_or_else(|| vec![0.0; count], |found| found.all)
    }

    /// The principal parameters of the stiffness about the scene's center.
    pub(super) fn principal(&self, spots: &[Spot]) -> Option<Principal<3, 3>> {
        let patches = &self.scene.patches;
        let placed = spots.iter().map(|s| patches[s.patch].wrench(s.point));
        let fixed = self.scene.fixed.iter().map(|&(wrench, weight)| wrench * weight);
        Principal::of(Vector::ZERO, &stiffness(placed.chain(fixed))).ok()
    }

    /// What is maximized and what among ties, whether or not the forces balance; of fewer points of
    /// the body, no less.
    fn worth(&self, principal: &Principal<3, 3>, body: &ExtremePoints<3>) -> Option<Worth> {
        match self.fingers.objective {
            Objective::WorstPoint => {
                let worst = WorstPoint::of(principal, body).ok()?;
                Some(Worth::Held(worst.stiffness, worst.stiffness))
            }
            Objective::Rotation { least_translation } => {
                let translational = principal.translational().values[0];
                if translational < below(least_translation / self.scene.stiffness_unit) {
                    return None;
                }
                let softest = EquivalentStiffness::least(principal, body).ok()?;
                Some(Worth::Held(softest.value, translational))
            }
            Objective::Quality => {
                let quality = Quality::of(principal, body).ok()?;
                Some(Worth::Held(quality.value, quality.equivalent()))
            }
        }
    }
}

/// The stiffness of scaled wrenches, about the scene's center.
pub(super) fn stiffness(wrenches: impl Iterator<Item = Vector<6>>) -> Stiffness<3, 3> {
    wrenches.fold(Stiffness::ZERO, |sum, p| {
        sum + Stiffness::outer(&Wrench { force: first(p), torque: second(p) })
    })
}
