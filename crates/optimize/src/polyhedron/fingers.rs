//! Fingers on a solid: the question, and its best answers.

use std::ops::ControlFlow;
use std::time::Instant;

use clench_shape::{ExtremePoints, LARGEST_COORDINATE};

use super::bound::Pieces;
use super::rating::Rating;
use super::scene::Scene;
use super::search::SpatialSearch;
use super::touch::{Touch, TouchKind};
use super::{Part, part};
use crate::search::{Leaders, Matter, choose, outcome, search};
use crate::{Effort, Objective, OptimizeError, Outcome, Progress};

/// The least number of frictionless contacts that hold a solid to first order: one more than it has
/// motions.
pub const FEWEST_CONTACTS: usize = 7;

/// The largest number of contacts, placed and given: their shares of a preload are found by trying
/// all sets of six.
pub const MOST_CONTACTS: usize = 16;

/// The largest number of fingers that can be placed.
pub const MOST_FINGERS: usize = 12;

/// Motions on which forces have levers of no more than this part of the reach count as free, unless
/// something else is asked for: a regular prism of 32 sides is round, one of 24 is not.
pub const ROUNDNESS: f64 = 0.1;

/// A contact pushes if its share of the preload is at least this: far above the rounding of shares,
/// far below what anybody could adjust. Best placements are often limits where some contacts barely
/// push, and then have shares of just this, unless a larger least share is asked for.
pub const PUSHING: f64 = 1e-6;

/// The balls at the ends of fingers, and how near to each other they may be.
///
/// The centers of two balls, at least one of them a placed one, are no nearer to each other than
/// their radii and the clearance together. Where there is none of these, fingers may be at one
/// place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spacing {
    /// The radius of the balls of the fingers that are placed (length).
    pub radius: f64,
    /// The least gap between two balls (length).
    pub clearance: f64,
    /// The radii of the balls of given contacts, in their order (length); 0 of those left out.
    pub given: Vec<f64>,
    /// The radii of the balls of candidates, in their order (length); of those left out as of those
    /// that are placed.
    pub candidates: Vec<f64>,
}

impl Spacing {
    fn check(&self) -> Result<(), OptimizeError> {
        let is_radius = |x: f64| (0.0..=LARGEST_COORDINATE).contains(&x);
        let radii = self.given.iter().chain(&self.candidates).chain([&self.radius]);
        if let Some(&value) = radii.into_iter().find(|&&radius| !is_radius(radius)) {
            return Err(OptimizeError::FingerRadius { value });
        }
        if !(self.clearance >= 0.0 && self.clearance.is_finite()) {
            return Err(OptimizeError::Clearance { value: self.clearance });
        }
        Ok(())
    }
}

/// Frictionless fingers on a solid, each a spring along its normal.
#[derive(Clone, Debug, PartialEq)]
pub struct Fingers {
    /// How many are to be placed, from 1 to [`MOST_FINGERS`].
    pub count: usize,
    /// Contacts that are given, such as locators; with the placed ones [`FEWEST_CONTACTS`] or more,
    /// and [`MOST_CONTACTS`] at most.
    pub fixed: Vec<Touch>,
    /// What is maximized.
    pub objective: Objective,
    /// How many of the placed fingers may be on one facet: what is proved is about placements with
    /// no more. For the balance of forces more than three on one plane are as good as three, but
    /// they add stiffness. Of candidates each is chosen once.
    pub most_on_face: usize,
    /// The least share of the total preload that each contact has when the forces balance; below
    /// one part in the number of contacts. Of less than [`PUSHING`], that
    /// is asked for.
    pub least_share: f64,
    /// A motion counts as free if no force on the surface has a lever of more than this part of the
    /// part's reach on it, as for a mesh of a ball: from 0 to below 1.
    pub roundness: f64,
    /// How near to each other fingers may be.
    pub spacing: Spacing,
}

impl Fingers {
    /// `count` fingers of the best worst-point stiffness, without conditions: that objective is
    /// continuous, and its bounds are the tightest.
    #[must_use]
    pub fn new(count: usize) -> Self {
        Self {
            count,
            fixed: Vec::new(),
            objective: Objective::WorstPoint,
            most_on_face: 3,
            least_share: 0.0,
            roundness: ROUNDNESS,
            spacing: Spacing::default(),
        }
    }

    /// The question, with the normals of given contacts made unit vectors.
    fn checked(&self) -> Result<Self, OptimizeError> {
        let Self { count, least_share, roundness, .. } = *self;
        if !(1..=MOST_FINGERS).contains(&count) {
            return Err(OptimizeError::FingerCount { found: count, fewest: 1, most: MOST_FINGERS });
        }
        let (given, total) = (self.fixed.len(), count + self.fixed.len());
        if total < FEWEST_CONTACTS {
            return Err(OptimizeError::TooFewContacts { placed: count, given });
        }
        if total > MOST_CONTACTS {
            return Err(OptimizeError::TooManyContacts { found: total, most: MOST_CONTACTS });
        }
        if self.most_on_face == 0 {
            return Err(OptimizeError::MostOnFace);
        }
        let limit = (total as f64).recip();
        if !(0.0..limit).contains(&least_share) {
            return Err(OptimizeError::LeastShare { value: least_share, limit });
        }
        if !(0.0..1.0).contains(&roundness) {
            return Err(OptimizeError::Roundness { value: roundness });
        }
        self.objective.checked()?;
        self.spacing.check()?;
        let fixed = self
            .fixed
            .iter()
            .enumerate()
            .map(|(number, touch)| touch.checked(TouchKind::Given, number));
        Ok(Self { fixed: fixed.collect::<Result<_, _>>()?, ..self.clone() })
    }
}

impl Fingers {
    /// Why a search through all placements found none.
    fn nothing(&self, combinations: f64) -> OptimizeError {
        let fingers = self.count;
        if self.least_share > 0.0
            || self.objective.least_translation() > 0.0
            || self.checked_spacing().is_some()
        {
            OptimizeError::ConditionsNeverMet { fingers, combinations }
        } else {
            OptimizeError::NeverHeld { fingers, combinations }
        }
    }
}

/// The best placements of frictionless fingers on the facets of `part`.
///
/// Maximizes the objective to first order over all combinations of facets and all places on them
/// that are accessible, as [`Part::accessible_to`] says,
/// among the placements whose forces can balance with all contacts pushing. How bounds are found
/// is told in [`polyhedron`](crate::polyhedron). The search closes in on the best placement and is
/// better given a gap or a time: what it returns then is the best so far, with a bound that holds.
/// A placement's fingers are on the faces whose numbers it has.
///
/// Nodes are shared among the threads of the current rayon pool; the outcome is the same for any
/// number of them, unless a time is set. `watch` is called once a round and can stop the search.
///
/// # Errors
///
/// [`OptimizeError::FingerCount`], [`OptimizeError::TooFewContacts`],
/// [`OptimizeError::TooManyContacts`], [`OptimizeError::MostOnFace`],
/// [`OptimizeError::LeastShare`], [`OptimizeError::Roundness`],
/// [`OptimizeError::FingerRadius`], [`OptimizeError::Clearance`],
/// [`OptimizeError::LeastTranslation`], [`OptimizeError::Gap`], [`OptimizeError::TouchPoint`],
/// [`OptimizeError::TouchNormal`], [`OptimizeError::TouchStiffness`],
/// [`OptimizeError::StiffnessSpread`]; [`OptimizeError::MotionStaysFree`],
/// [`OptimizeError::AlwaysEscapes`], [`OptimizeError::NeverHeld`] or
/// [`OptimizeError::ConditionsNeverMet`] when so many frictionless fingers cannot hold the part so;
/// [`OptimizeError::NothingFound`] when the search was stopped before;
/// [`OptimizeError::OutOfRange`] when the numbers of the best placement overflow.
pub fn fingers(
    part: &Part,
    fingers: &Fingers,
    effort: &Effort,
    watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Outcome<3, 3>, OptimizeError> {
    let fingers = fingers.checked()?;
    effort.checked()?;
    let given = fingers.fixed.iter().map(|touch| touch.stiffness);
    part::check_spread(part.face_stiffness().iter().copied().chain(given))?;
    let scene = Scene::of_part(part, &fingers)?;
    Asked { scene: &scene, fingers: &fingers, effort }.answered(watch, &|spot| {
        let (point, facet) = (scene.unscaled(spot.point), &part.facets()[scene.facets[spot.patch]]);
        super::solution::face_at(part.solid(), facet, point)
    })
}

/// The best choice of frictionless fingers among `candidates` on a body, given by its extreme
/// points, as [`fingers`] chooses among all places. A placement's fingers have the numbers of
/// candidates.
///
/// # Errors
///
/// As [`fingers`]; [`OptimizeError::TooFewCandidates`].
pub fn fingers_among(
    body: &ExtremePoints<3>,
    candidates: &[Touch],
    fingers: &Fingers,
    effort: &Effort,
    watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Outcome<3, 3>, OptimizeError> {
    let fingers = fingers.checked()?;
    effort.checked()?;
    let (found, count) = (candidates.len(), fingers.count);
    if found < count {
        return Err(OptimizeError::TooFewCandidates { found, fingers: count });
    }
    let candidates = candidates
        .iter()
        .enumerate()
        .map(|(number, touch)| touch.checked(TouchKind::Candidate, number));
    let candidates = candidates.collect::<Result<Vec<_>, _>>()?;
    let all = candidates.iter().chain(&fingers.fixed).map(|touch| touch.stiffness);
    part::check_spread(all)?;
    let scene = Scene::of_candidates(body, &candidates, &fingers)?;
    Asked { scene: &scene, fingers: &fingers, effort }.answered(watch, &|spot| spot.patch)
}

/// A question that was checked.
#[derive(Clone, Copy, Debug)]
struct Asked<'a> {
    scene: &'a Scene<'a>,
    fingers: &'a Fingers,
    effort: &'a Effort,
}

/// Which number a finger's place has for the caller.
type Numbered<'a> = &'a dyn Fn(super::rating::Spot) -> usize;

impl Asked<'_> {
    fn answered(
        self,
        watch: impl FnMut(&Progress) -> ControlFlow<()>,
        number: Numbered<'_>,
    ) -> Result<Outcome<3, 3>, OptimizeError> {
        match self.fingers.count {
            1 => self.best::<1>(watch, number),
            2 => self.best::<2>(watch, number),
            3 => self.best::<3>(watch, number),
            4 => self.best::<4>(watch, number),
            5 => self.best::<5>(watch, number),
            6 => self.best::<6>(watch, number),
            7 => self.best::<7>(watch, number),
            8 => self.best::<8>(watch, number),
            9 => self.best::<9>(watch, number),
            10 => self.best::<10>(watch, number),
            11 => self.best::<11>(watch, number),
            _ => self.best::<12>(watch, number),
        }
    }

    fn best<const K: usize>(
        self,
        watch: impl FnMut(&Progress) -> ControlFlow<()>,
        number: Numbered<'_>,
    ) -> Result<Outcome<3, 3>, OptimizeError> {
        let Self { scene, fingers, effort } = self;
        let started = Instant::now();
        let rating = Rating { scene, fingers };
        let pieces = Pieces::new(scene);
        let problem = SpatialSearch::new(rating, &pieces);
        if let Some(motion) = problem.escape() {
            return Err(OptimizeError::AlwaysEscapes { fingers: K, motion });
        }
        let mut leaders = Leaders::new(effort.top.get());
        leaders.merge(problem.first::<K>(effort.time.map(|time| started + time)));
        let time = effort.time.map(|time| time.saturating_sub(started.elapsed()));
        let searched = search(&problem, leaders, &Effort { time, ..*effort }, watch);
        let repetition = scene.most_on_patch > 1;
        let combinations = choose(scene.patches.len(), K, repetition);
        let matter = Matter { fingers: K, combinations };
        outcome(
            scene.stiffness_unit,
            matter,
            &searched,
            |candidate| rating.solution(&candidate.place, number),
            || fingers.nothing(combinations),
        )
    }
}
