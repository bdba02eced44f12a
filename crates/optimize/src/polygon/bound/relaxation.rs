//! Upper bounds over all placements of spring fingers on some pieces of the boundary.

use clench_screw::Vector;

use super::closure;
use super::cut::{Cut, best_weight, slack};
use super::demand::{Demand, Verdict};
use super::middle::Middle;
use super::pieces::Pieces;
use super::{ROUNDING, arm};
use crate::polygon::scene::Scene;
use crate::polygon::tips::Tips;
use crate::search::Piece;
use crate::search::boxes::value;

/// How often the test form is improved before a node is halved instead.
const SWEEPS: usize = 3;

/// A sweep that leaves more than this part of the excess is the last one.
const WORTHWHILE: f64 = 0.9;

/// The bounds; see [`super`] for their derivation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Relaxation<'a> {
    pub(crate) scene: &'a Scene<'a>,
    pub(crate) pieces: &'a Pieces<3>,
    /// No finger may have a smaller share of the preload.
    pub(crate) least_share: f64,
    /// Whether single stretches are left whole, since they are solved otherwise.
    pub(crate) whole_stretches: bool,
    /// The tips of the fingers, if they have to keep a distance.
    pub(crate) tips: Option<&'a Tips<'a>>,
}

impl Relaxation<'_> {
    /// How far the placements on a node can surpass `demand`; `None` when none meets it.
    pub(crate) fn verdict<const K: usize>(
        &self,
        node: &[Piece; K],
        demand: &Demand,
    ) -> Option<Verdict> {
        let middle = Middle::new(node.map(|piece| self.pieces.range(piece)), demand.translation);
        let translation = middle.largest_translation();
        if translation <= demand.translation.max(middle.no_translation()) {
            return None;
        }
        if closure::is_excluded(&middle, self.scene.radius, self.least_share) {
            return None;
        }
        let about_center =
            self.excess(&middle, demand, &Cut::about_center(self.scene, &middle, demand));
        if about_center <= 0.0 {
            return None;
        }
        let corner = self.scene.farthest(middle.about);
        let point = (demand.worst_point > 0.0)
            .then(|| {
                Cut::by_worst_point(self.scene, demand, &middle.ranges.map(|range| range.center))
            })
            .flatten();
        let mut cut =
            point.unwrap_or_else(|| Cut::by_rotation(self.scene, &middle, demand, corner));
        let mut excess = self.excess(&middle, demand, &cut);
        for sweep in 0..SWEEPS {
            if excess <= 0.0 {
                return None;
            }
            let before = excess;
            let (base, slopes) = cut.model(&middle);
            if let Some(other) = self.other_cut(&middle, demand, &cut, &slopes) {
                let (other_base, other_slopes) = other.model(&middle);
                let mut steps = other_slopes;
                for (step, slope) in steps.as_flattened_mut().iter_mut().zip(slopes.as_flattened())
                {
                    *step -= slope;
                }
                let part = best_weight(&slopes, &steps, other_base - base, 1.0);
                self.improve(&middle, demand, (&mut cut, &mut excess), |cut| {
                    cut.mixed(part, &other)
                });
            }
            if excess > 0.0 {
                let other = Cut::by_translation(&middle, demand);
                self.add(&middle, demand, (&mut cut, &mut excess), &other);
            }
            if excess > 0.0 && demand.worst_point > 0.0 {
                let other = Cut::by_rotation(self.scene, &middle, demand, corner);
                self.add(&middle, demand, (&mut cut, &mut excess), &other);
            }
            if excess > 0.0 && sweep == 0 {
                for other in closure::cuts(&middle, self.scene.radius, self.least_share) {
                    self.add(&middle, demand, (&mut cut, &mut excess), &other);
                }
                let apart = self.tips.map(|tips| tips.cuts(node, &middle, self.pieces));
                for other in apart.into_iter().flatten() {
                    self.add(&middle, demand, (&mut cut, &mut excess), &other);
                }
            }
            if excess >= WORTHWHILE * before {
                break;
            }
        }
        if excess <= 0.0 {
            return None;
        }
        let mut surplus = (excess / cut.gain).min(about_center / self.scene.radius_squared);
        if !demand.fixed_translation {
            surplus = surplus.min(translation - demand.translation);
        }
        Some(Verdict { surplus, split: self.split(&middle, demand, &cut) })
    }

    /// Adds the best multiple of `other`, if that lowers the excess.
    fn add<const K: usize>(
        &self,
        middle: &Middle<K>,
        demand: &Demand,
        (cut, excess): (&mut Cut<K>, &mut f64),
        other: &Cut<K>,
    ) {
        let (base, steps) = other.model(middle);
        let reach: f64 = steps.as_flattened().iter().map(|s| s.abs()).sum();
        // Fulfilled on the whole node: no multiple helps.
        if base >= reach {
            return;
        }
        let (_, slopes) = cut.model(middle);
        let largest: f64 = slopes.as_flattened().iter().map(|s| s.abs()).sum();
        let most = (largest + *excess) / (reach + base.abs());
        let weight = best_weight(&slopes, &steps, base, most);
        if weight > 0.0 {
            self.improve(middle, demand, (cut, excess), |cut| cut.plus(weight, other));
        }
    }

    fn improve<const K: usize>(
        &self,
        middle: &Middle<K>,
        demand: &Demand,
        (cut, excess): (&mut Cut<K>, &mut f64),
        change: impl FnOnce(&Cut<K>) -> Cut<K>,
    ) {
        let changed = change(cut);
        let less = self.excess(middle, demand, &changed);
        if less < *excess {
            (*cut, *excess) = (changed, less);
        }
    }

    /// The cut that the placement violates most, or nearly so, where the model of `cut` is largest.
    fn other_cut<const K: usize>(
        &self,
        middle: &Middle<K>,
        demand: &Demand,
        cut: &Cut<K>,
        slopes: &[[f64; 3]; K],
    ) -> Option<Cut<K>> {
        let largest: [Vector<3>; K] = std::array::from_fn(|i| {
            let range = &middle.ranges[i];
            let axes = range.axes.iter().zip(slopes[i]);
            axes.fold(range.center, |p, (axis, slope)| p + *axis * slope.signum())
        });
        if demand.worst_point > 0.0 {
            return Cut::by_worst_point(self.scene, demand, &largest);
        }
        // The center of compliance there, to first order.
        let about = middle.about;
        let change = (0..K).fold(Vector::ZERO, |sum, i| {
            let at = |p: Vector<3>| arm(p) * (p[2] - arm(p).dot(about));
            sum + at(largest[i]) - at(middle.ranges[i].center)
        });
        let corner = self.scene.farthest(about + middle.solve(change));
        (corner != cut.corner).then(|| Cut::by_rotation(self.scene, middle, demand, corner))
    }

    /// What the left side of `cut` exceeds its constant by, at most, over the node.
    fn excess<const K: usize>(&self, middle: &Middle<K>, demand: &Demand, cut: &Cut<K>) -> f64 {
        let mut sum = 0.0;
        for (w, linear) in middle.ranges.iter().zip(cut.linear) {
            sum += self.pieces.largest(w, &cut.form, linear);
        }
        sum - cut.constant + cut.slack + slack(middle, demand, cut) + ROUNDING * cut.size
    }

    /// The piece whose extent raises the bound most.
    fn split<const K: usize>(&self, middle: &Middle<K>, demand: &Demand, cut: &Cut<K>) -> usize {
        let slack = 2.0 * slack(middle, demand, cut) / middle.spread();
        // Over few stretches nothing need be as large as in the middle of their box.
        let mut most = (0, f64::NEG_INFINITY);
        for (i, w) in middle.ranges.iter().enumerate() {
            if self.whole_stretches && w.is_single() {
                continue;
            }
            let mut rise = self.pieces.largest(w, &cut.form, cut.linear[i])
                - value(&cut.form, cut.linear[i], w.center);
            if middle.spread() > 0.0 {
                rise += slack * (w.turn_radius + w.stiffness_spread);
            }
            if rise > most.1 {
                most = (i, rise);
            }
        }
        most.0
    }
}
