//! Many small changes at once: the worst of them, and the one that gains most.

use std::f64::consts::TAU;

use clench_screw::Stiffness;

use crate::Sensitivity;

/// Directions of a plane that a search begins with, where a measure has kinks.
const DIRECTIONS: usize = 64;

/// An angle this small ends a search: a rate errs by its square there.
const SMALLEST_ANGLE: f64 = 1e-8;

/// A loss below this part of the largest is the rounding of none.
const NOTHING: f64 = 1e-12;

/// What can change about a stiffness in one place, by the rates of the stiffness, per unit, about
/// [`Sensitivity::origin`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Freedom<const N: usize, const M: usize> {
    /// One number, such as a place along an edge, or a preload.
    Line(Stiffness<N, M>),
    /// A step in a plane of two perpendicular unit directions, such as a place on a face.
    Plane([Stiffness<N, M>; 2]),
}

/// A [`Freedom`] and the length of its longest step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variation<const N: usize, const M: usize> {
    /// What changes.
    pub freedom: Freedom<N, M>,
    /// By how much at most, either way, or in any direction (units of the freedom).
    pub tolerance: f64,
}

/// The unit step along which a measure grows or falls most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steepest {
    /// How much it grows per unit.
    pub rate: f64,
    /// The step: of unit length, the second component 0 on a line.
    pub step: [f64; 2],
}

/// The worst of many small changes.
#[derive(Clone, Debug, PartialEq)]
pub struct WorstCase {
    /// By how much the measure changes, at most 0, in proportion to the changes.
    pub change: f64,
    /// The step of each variation.
    pub steps: Vec<[f64; 2]>,
}

/// The change that gains most per unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gain {
    /// The number of the freedom.
    pub freedom: usize,
    /// Which way, and how much per unit.
    pub steepest: Steepest,
}

impl<const N: usize, const M: usize> Sensitivity<N, M> {
    /// What the measure loses at worst, when all `variations` happen at once, each within its
    /// tolerance: in proportion to them, `-sum of |dQ| t`.
    ///
    /// It is linear: what the squares of the tolerances do is not in it. Where several values tie
    /// it is the worst of theirs; of a repeated eigenvalue each variation is taken at its own
    /// worst, which is on the safe side.
    #[must_use]
    pub fn worst_case(&self, variations: &[Variation<N, M>]) -> WorstCase {
        let none = WorstCase { change: 0.0, steps: vec![[0.0, 0.0]; variations.len()] };
        let worse = |worst: WorstCase, next: WorstCase| {
            if next.change < worst.change { next } else { worst }
        };
        self.each().map(|one| one.worst_of_one(variations)).fold(none, worse)
    }

    /// That of one of the values that tie.
    fn worst_of_one(&self, variations: &[Variation<N, M>]) -> WorstCase {
        let worst = |Variation { freedom, tolerance }: &Variation<N, M>| {
            let Steepest { rate, step } = self.steepest(freedom, -1.0);
            // Along a line or plane on which the measure is at its least nothing is lost.
            let tolerance = if rate < 0.0 { *tolerance } else { 0.0 };
            (rate * tolerance, step.map(|s| s * tolerance))
        };
        let mut each: Vec<(f64, [f64; 2])> = variations.iter().map(worst).collect();
        let most = each.iter().map(|one| one.0).fold(0.0, f64::min);
        // What loses no more than rounding loses nothing.
        for one in each.iter_mut().filter(|one| one.0 >= NOTHING * most) {
            *one = (0.0, [0.0, 0.0]);
        }
        let (changes, steps): (Vec<f64>, _) = each.into_iter().unzip();
        WorstCase { change: changes.into_iter().sum(), steps }
    }

    /// The freedom along which the measure grows most per unit; `None` where it grows along none.
    ///
    /// All of them have to have the same unit. What stands in the way of a step, such as the end of
    /// an edge, is not known here.
    #[must_use]
    pub fn best_gain(&self, freedoms: &[Freedom<N, M>]) -> Option<Gain> {
        let gains = freedoms.iter().enumerate();
        let gains = gains.map(|(i, f)| Gain { freedom: i, steepest: self.steepest_rise(f) });
        gains
            .filter(|gain| gain.steepest.rate > 0.0)
            .max_by(|a, b| a.steepest.rate.total_cmp(&b.steepest.rate))
    }

    /// The unit step along which the measure grows most, or falls least.
    #[must_use]
    pub fn steepest_rise(&self, freedom: &Freedom<N, M>) -> Steepest {
        self.steepest(freedom, 1.0)
    }

    /// The unit step along which the measure falls most, or grows least.
    #[must_use]
    pub fn steepest_fall(&self, freedom: &Freedom<N, M>) -> Steepest {
        self.steepest(freedom, -1.0)
    }

    /// The step whose rate times `sign` is largest.
    fn steepest(&self, freedom: &Freedom<N, M>, sign: f64) -> Steepest {
        let at = |step: [f64; 2]| Steepest { rate: self.along_step(freedom, step), step };
        match freedom {
            Freedom::Line(_) => better(at([1.0, 0.0]), at([-1.0, 0.0]), sign),
            Freedom::Plane(_) if self.is_smooth() => {
                let slope = [[1.0, 0.0], [0.0, 1.0]].map(|step| self.along_step(freedom, step));
                let size = slope[0].hypot(slope[1]);
                let unit = if size > 0.0 { slope.map(|s| sign * s / size) } else { [1.0, 0.0] };
                Steepest { rate: sign * size, step: unit }
            }
            Freedom::Plane(_) => {
                let turned = |angle: f64| at([angle.cos(), angle.sin()]);
                searched(turned, sign)
            }
        }
    }

    fn along_step(&self, freedom: &Freedom<N, M>, [s, t]: [f64; 2]) -> f64 {
        match freedom {
            Freedom::Line(rate) => self.along(&(*rate * s)),
            Freedom::Plane([one, other]) => self.along(&(*one * s + *other * t)),
        }
    }
}

/// The best direction of a plane: of those that are better than both their neighbors, each moved on
/// by steps to both sides that are halved.
///
/// Along the circle a rate has kinks: a largest value may be at one, between two directions.
fn searched(turned: impl Fn(f64) -> Steepest, sign: f64) -> Steepest {
    let spacing = TAU / DIRECTIONS as f64;
    let all: Vec<Steepest> = (0..DIRECTIONS).map(|i| turned(i as f64 * spacing)).collect();
    let value = |i: usize| sign * all[i % DIRECTIONS].rate;
    let is_peak = |i: &usize| value(*i) >= value(i + 1) && value(*i) >= value(i + DIRECTIONS - 1);
    let peaks = (0..DIRECTIONS).filter(is_peak);
    let climbed = peaks.map(|i| climbed(&turned, i as f64 * spacing, 0.5 * spacing, sign));
    climbed.fold(all[0], |best, next| better(best, next, sign))
}

/// What steps of this width and less lead to.
fn climbed(turned: impl Fn(f64) -> Steepest, start: f64, width: f64, sign: f64) -> Steepest {
    let (mut angle, mut width, mut best) = (start, width, turned(start));
    while width > SMALLEST_ANGLE {
        let sides = [angle - width, angle + width];
        match sides.into_iter().find(|&side| sign * turned(side).rate > sign * best.rate) {
            Some(side) => (angle, best) = (side, turned(side)),
            None => width *= 0.5,
        }
    }
    best
}

fn better(one: Steepest, other: Steepest, sign: f64) -> Steepest {
    if sign * other.rate > sign * one.rate { other } else { one }
}
