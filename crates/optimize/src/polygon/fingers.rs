//! Four and more spring fingers: the question, and its best answers.

use std::ops::ControlFlow;

use super::Part;
use super::reason::nothing;
use super::scene::Scene;
use super::springs::{SpringSearch, Springs};
use super::tips;
use crate::search::{Floor, Leaders, Matter, choose, outcome, search};
use crate::{Effort, Objective, OptimizeError, Outcome, Progress, Solution};

/// The least number of spring fingers that can be placed: fewer do not hold a part to first order.
pub const FEWEST_FINGERS: usize = 4;

/// The largest number of spring fingers that can be placed.
pub const MOST_FINGERS: usize = 8;

/// What a placement may be better by that is not looked for, as a part of the best, among those on
/// edges whose best four fingers would be too near to each other across a corner.
pub const CROWDING_GAP: f64 = 1e-6;

/// Frictionless fingers, each a spring along its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fingers {
    /// How many, from [`FEWEST_FINGERS`] to [`MOST_FINGERS`].
    pub count: usize,
    /// What is maximized.
    pub objective: Objective,
    /// The radius of the fingers' tips (length); 0 for pointed fingers. It counts for their
    /// distance only: where they can touch is up to [`Part::accessible_to`].
    pub finger_radius: f64,
    /// The least gap between the tips of two fingers (length). Pointed fingers without a clearance
    /// may be at one place.
    pub clearance: f64,
    /// The least share of the total preload that each finger has when the forces balance; below
    /// one part in `count`. 0 takes in the limits where some fingers barely press.
    pub least_share: f64,
}

impl Fingers {
    /// `count` fingers of best quality, without conditions.
    #[must_use]
    pub const fn new(count: usize) -> Self {
        Self {
            count,
            objective: Objective::Quality,
            finger_radius: 0.0,
            clearance: 0.0,
            least_share: 0.0,
        }
    }

    /// The least distance of the centers of two tips (length).
    pub(super) fn least_distance(&self) -> f64 {
        2.0 * self.finger_radius + self.clearance
    }

    fn has_conditions(&self) -> bool {
        let translation = self.objective.least_translation() > 0.0;
        self.least_distance() > 0.0 || self.least_share > 0.0 || translation
    }

    fn checked(&self) -> Result<(), OptimizeError> {
        let Self { count, objective, finger_radius, clearance, least_share } = *self;
        if !(FEWEST_FINGERS..=MOST_FINGERS).contains(&count) {
            return Err(OptimizeError::FingerCount {
                found: count,
                fewest: FEWEST_FINGERS,
                most: MOST_FINGERS,
            });
        }
        tips::check(finger_radius, clearance)?;
        let limit = (count as f64).recip();
        if !(0.0..limit).contains(&least_share) {
            return Err(OptimizeError::LeastShare { value: least_share, limit });
        }
        objective.checked()
    }
}

/// The best placements of frictionless spring fingers on the edges of `part`.
///
/// Maximizes the objective to first order [LBR, eqs. 14 and 18], over all combinations of edges,
/// several fingers on one edge included, and all places on them, corners included as limits. How
/// it is found and proved is told in [`polygon`](crate::polygon). With four fingers the best
/// placement on a combination is found in closed form, except for the worst-point stiffness; with
/// more, and for that, the search closes in on it, and is better given a gap: the returned
/// placement is then as good as any, up to that. Where four fingers would be best too near to each
/// other across a corner, it closes in too, to [`CROWDING_GAP`].
///
/// Nodes are shared among the threads of the current rayon pool; the outcome is the same for any
/// number of them, unless a time is set. `watch` is called once a round, some milliseconds, and can
/// stop the search: what it returns then is the best so far, with a bound that holds.
///
/// # Errors
///
/// [`OptimizeError::FingerCount`], [`OptimizeError::FingerRadius`],
/// [`OptimizeError::Clearance`], [`OptimizeError::LeastShare`],
/// [`OptimizeError::LeastTranslation`], [`OptimizeError::Gap`];
/// [`OptimizeError::NormalsNeverBalance`], [`OptimizeError::TorquesNeverBalance`] or
/// [`OptimizeError::ConditionsNeverMet`] when so many frictionless fingers cannot hold the part so;
/// [`OptimizeError::NothingFound`] when the search was stopped before;
/// [`OptimizeError::NowhereToTouch`]; [`OptimizeError::TooThin`] and
/// [`OptimizeError::OutOfRange`] when the numbers of the best placement overflow.
pub fn fingers(
    part: &Part,
    fingers: &Fingers,
    effort: &Effort,
    watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Outcome<2, 1>, OptimizeError> {
    fingers.checked()?;
    effort.checked()?;
    match fingers.count {
        4 => best::<4>(part, fingers, effort, watch),
        5 => best::<5>(part, fingers, effort, watch),
        6 => best::<6>(part, fingers, effort, watch),
        7 => best::<7>(part, fingers, effort, watch),
        _ => best::<8>(part, fingers, effort, watch),
    }
}

fn best<const K: usize>(
    part: &Part,
    fingers: &Fingers,
    effort: &Effort,
    watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Outcome<2, 1>, OptimizeError> {
    let scene = Scene::checked(part)?;
    let springs = Springs { scene: &scene, fingers };
    let mut leaders = Leaders::new(effort.top.get());
    leaders.merge(springs.first::<K>());
    let searched = search(&SpringSearch::new(springs), leaders, effort, watch);
    let combinations = choose(scene.supports.len(), K, true);
    let conditions = fingers.has_conditions() || part.is_restricted();
    let matter = Matter { fingers: K, combinations };
    outcome(
        scene.stiffness_unit,
        matter,
        &searched,
        |candidate| springs.solution(candidate),
        || nothing(&scene, matter, conditions),
    )
}

/// The best placement of four fingers on the given edges, in any order; two may be equal.
///
/// `None` when four fingers on these edges cannot hold the part, or not as asked for.
///
/// # Errors
///
/// [`OptimizeError::FingerCount`] for another count than four, [`OptimizeError::NoClosedForm`] for
/// the worst-point stiffness and where fingers on two edges would be too near to each other,
/// [`OptimizeError::NoSuchEdge`], and those of [`fingers`] about the question.
pub fn four_fingers_on(
    part: &Part,
    edges: [usize; 4],
    fingers: &Fingers,
) -> Result<Option<Solution<2, 1>>, OptimizeError> {
    fingers.checked()?;
    if fingers.count != 4 {
        return Err(OptimizeError::FingerCount { found: fingers.count, fewest: 4, most: 4 });
    }
    if fingers.objective == Objective::WorstPoint {
        return Err(OptimizeError::NoClosedForm);
    }
    let edges = part.checked(edges)?;
    let scene = Scene::checked(part)?;
    let springs = Springs { scene: &scene, fingers };
    let mut best = Leaders::new(1);
    for stretches in scene.stretches_of(edges) {
        match springs.solve(stretches, &Floor::NONE) {
            Some(found) if springs.is_crowded(&found) => return Err(OptimizeError::NoClosedForm),
            found => best.merge(found),
        }
    }
    best.candidates().first().map(|candidate| springs.solution(candidate)).transpose()
}
