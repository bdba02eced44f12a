//! Why a search could not be made, or found nothing.

use clench_metrics::MetricsError;
use clench_shape::LARGEST_COORDINATE;

use crate::Ended;

/// What is wrong with the question, or why it has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OptimizeError {
    /// The number of stiffnesses is not the number of edges, or of faces.
    #[error("found {found} stiffnesses, but there are {sides} edges or faces")]
    StiffnessCount {
        /// How many were given.
        found: usize,
        /// How many edges or faces there are.
        sides: usize,
    },
    /// A stiffness is not positive and finite.
    #[error(
        "the stiffness of edge or face {side} is {value}, but has to be a positive finite number"
    )]
    Stiffness {
        /// The edge or face, from 0.
        side: usize,
        /// What was found.
        value: f64,
    },
    /// The total preload of a three-finger grasp is not positive and finite.
    #[error(
        "the total preload is {value}, but has to be a positive finite number: \
         three fingers resist rotation by their preload alone"
    )]
    TotalPreload {
        /// What was found.
        value: f64,
    },
    /// The finger radius is negative, or larger than any part.
    #[error(
        "the finger radius is {value:?}, but has to be zero or positive, and \
         {LARGEST_COORDINATE:e} at most"
    )]
    FingerRadius {
        /// What was found.
        value: f64,
    },
    /// The clearance of fingers is negative or not finite.
    #[error("the clearance is {value}, but has to be a finite number, zero or positive")]
    Clearance {
        /// What was found.
        value: f64,
    },
    /// It cannot be told where fingers touch.
    #[error(transparent)]
    Access(#[from] clench_shape::AccessError),
    /// Nothing is left of the part's surface to touch.
    #[error(
        "nothing of the part can be touched by a finger tip of radius {radius}, at least {margin} \
         from where planes end, outside of {keep_outs} keep-outs{}",
        if *.on_plate { " over a hole of the plate" } else { "" }
    )]
    NothingAccessible {
        /// The radius of the tip (length).
        radius: f64,
        /// The least distance from the border of a facet (length).
        margin: f64,
        /// How many boxes it stays out of.
        keep_outs: usize,
        /// Whether it has to be over a hole of a plate.
        on_plate: bool,
    },
    /// Too few candidates are left whose tips have room.
    #[error(
        "the tips of {out} candidates meet something or are over no hole, which leaves {left}, \
         but {fingers} fingers need as many"
    )]
    CandidatesObstructed {
        /// How many have room.
        left: usize,
        /// How many have none.
        out: usize,
        /// How many fingers there are to place.
        fingers: usize,
    },
    /// An edge number is too large.
    #[error("edge {edge} does not exist: the outline has edges 0 to {last}")]
    NoSuchEdge {
        /// What was asked for.
        edge: usize,
        /// The last edge of the outline.
        last: usize,
    },
    /// The largest stiffness is too many times the smallest.
    #[error(
        "the stiffnesses go from {smallest:e} to {largest:e}: their ratio has to be below \
         {limit:e}, or the smaller ones are lost in the rounding of the larger ones"
    )]
    StiffnessSpread {
        /// The smallest.
        smallest: f64,
        /// The largest.
        largest: f64,
        /// [`crate::polygon::LARGEST_SPREAD`].
        limit: f64,
    },
    /// A placement was found whose stiffness has no principal parameters in the range of numbers.
    #[error(
        "the best placement on edges or faces {touched:?} is out of the range of numbers: {source}"
    )]
    OutOfRange {
        /// What its fingers touch.
        touched: Vec<usize>,
        /// What its stiffness lacks.
        source: MetricsError,
    },
    /// The number of spring fingers is not one that can be placed.
    #[error("{found} fingers cannot be placed: their number has to be from {fewest} to {most}")]
    FingerCount {
        /// What was asked for.
        found: usize,
        /// [`crate::polygon::FEWEST_FINGERS`].
        fewest: usize,
        /// [`crate::polygon::MOST_FINGERS`].
        most: usize,
    },
    /// On given edges the worst-point stiffness was asked for, or the best fingers would be too
    /// near to each other.
    #[error(
        "on given edges there is no closed form for the worst-point stiffness, nor where the best \
         fingers are too near to each other: search the whole part"
    )]
    NoClosedForm,
    /// The least share of the preload is negative, or more than all fingers can have.
    #[error("the least share of the preload is {value}, but has to be from 0 to below {limit}")]
    LeastShare {
        /// What was found.
        value: f64,
        /// One part in the number of fingers.
        limit: f64,
    },
    /// The least translational stiffness is negative or not finite.
    #[error(
        "the least translational stiffness is {value}, but has to be a finite number, zero or \
         positive"
    )]
    LeastTranslation {
        /// What was found.
        value: f64,
    },
    /// The margin at the ends of edges is negative or not finite.
    #[error("the margin is {value}, but has to be a finite number, zero or positive")]
    Margin {
        /// What was found.
        value: f64,
    },
    /// A stretch of an edge does not go forward.
    #[error("the stretch of edge {edge} goes from {from} to {to}, but has to end after its start")]
    Stretch {
        /// The edge.
        edge: usize,
        /// Where it begins.
        from: f64,
        /// Where it ends.
        to: f64,
    },
    /// The relative gap is negative or not finite.
    #[error("the gap is {value}, but has to be a finite number, zero or positive")]
    Gap {
        /// What was found.
        value: f64,
    },
    /// No stretch of any edge may be touched.
    #[error("no stretch of any edge may be touched, with all that fingers have to stay off")]
    NowhereToTouch,
    /// All normals are so nearly parallel that rounding hides whether the part can be held.
    #[error(
        "the edges are parallel up to {sine:e}, too little for a placement of {placed} \
         to be told from one that holds nothing",
        placed = counted(*.fingers as f64, "finger")
    )]
    TooThin {
        /// The number of fingers.
        fingers: usize,
        /// The largest sine of the angle between two normals, up to a factor of 2.
        sine: f64,
    },
    /// The normals of no combination positively span the plane.
    #[error(
        "no placement of {placed} holds the part: on no \
         combination of edges, of {combinations} in all, can the inward normals balance, so the \
         part can always be pushed away",
        placed = counted(*.fingers as f64, "frictionless finger")
    )]
    NormalsNeverBalance {
        /// The number of fingers.
        fingers: usize,
        /// The number of combinations of stretches.
        combinations: f64,
    },
    /// Where normals can balance, torques cannot.
    #[error(
        "no placement of {placed} holds the part: of {combinations} \
         combinations of edges some have normals that can balance, and on none of those do the \
         torques balance as well, so the part can always be turned away",
        placed = counted(*.fingers as f64, "frictionless finger")
    )]
    TorquesNeverBalance {
        /// The number of fingers.
        fingers: usize,
        /// The number of combinations of stretches.
        combinations: f64,
    },
    /// No placement holds the part and fulfills the conditions as well.
    #[error(
        "no placement of {placed}, on {all} of edges \
         or faces, both holds the part and fulfills the conditions on it",
        placed = counted(*.fingers as f64, "frictionless finger"),
        all = counted(*.combinations, "combination")
    )]
    ConditionsNeverMet {
        /// The number of fingers.
        fingers: usize,
        /// The number of combinations of stretches.
        combinations: f64,
    },
    /// The body's points have no hull in the range of numbers.
    #[error("the body's extreme points are out of the range of numbers")]
    Extent,
    /// Two faces in one plane have different stiffnesses.
    #[error(
        "faces {a} and {b} are in one plane and have different stiffnesses: a finger between \
         them would have either",
        a = faces[0],
        b = faces[1]
    )]
    UnlikeStiffness {
        /// The faces.
        faces: [usize; 2],
    },
    /// The point of a given contact or candidate is not finite.
    #[error("the point of {kind} {number} is {point:?}, but has to be finite")]
    TouchPoint {
        /// Which list it is in.
        kind: crate::polyhedron::TouchKind,
        /// Its number there, from 0.
        number: usize,
        /// What was found.
        point: [f64; 3],
    },
    /// The normal of a given contact or candidate is not a unit vector.
    #[error("the inward normal of {kind} {number} has the length {length}, but has to be 1")]
    TouchNormal {
        /// Which list it is in.
        kind: crate::polyhedron::TouchKind,
        /// Its number there, from 0.
        number: usize,
        /// What was found.
        length: f64,
    },
    /// The stiffness of a given contact or candidate is not positive and finite.
    #[error("the stiffness of {kind} {number} is {value}, but has to be a positive finite number")]
    TouchStiffness {
        /// Which list it is in.
        kind: crate::polyhedron::TouchKind,
        /// Its number there, from 0.
        number: usize,
        /// What was found.
        value: f64,
    },
    /// Fewer than seven frictionless contacts never hold a solid to first order.
    #[error(
        "{placed} fingers and {given} given contacts are {total}: it takes {fewest} frictionless \
         contacts to hold a solid",
        total = placed + given,
        fewest = crate::polyhedron::FEWEST_CONTACTS
    )]
    TooFewContacts {
        /// How many fingers were to be placed.
        placed: usize,
        /// How many contacts were given.
        given: usize,
    },
    /// More contacts than the shares of a preload are computed for.
    #[error("{found} contacts in all are too many: at most {most} can be balanced")]
    TooManyContacts {
        /// How many there would be.
        found: usize,
        /// [`crate::polyhedron::MOST_CONTACTS`].
        most: usize,
    },
    /// No finger may be on any face.
    #[error("at most 0 fingers on a face leave no place for any")]
    MostOnFace,
    /// There are fewer candidates than fingers.
    #[error(
        "found {given}, too few for {placed}",
        given = counted(*.found as f64, "candidate"),
        placed = counted(*.fingers as f64, "finger")
    )]
    TooFewCandidates {
        /// How many there are.
        found: usize,
        /// How many fingers were to be placed.
        fingers: usize,
    },
    /// The limit for levers below which a motion is free is negative, or 1 or more.
    #[error("the roundness is {value}, but has to be from 0 to below 1")]
    Roundness {
        /// What was found.
        value: f64,
    },
    /// No force on the surface has much of a lever on some motion, as on a round body.
    #[error(
        "one motion of the part counts as free: {motion}; without friction no contact has a lever \
         of more than {lever:.2e} of the part's reach on it, and {roundness} or less is none",
        motion = crate::polyhedron::described(motion)
    )]
    MotionStaysFree {
        /// The motion, in the frame of the part.
        motion: clench_screw::Screw,
        /// How many independent motions are free so.
        count: usize,
        /// The largest lever, as a part of the largest deflection.
        lever: f64,
        /// Up to which part levers count as none.
        roundness: f64,
    },
    /// All forces that contacts can have help one motion.
    #[error(
        "no placement of {placed} holds the part: it can always escape \
         along one motion, {motion}, which no force on it opposes",
        motion = crate::polyhedron::described(motion),
        placed = counted(*.fingers as f64, "frictionless finger")
    )]
    AlwaysEscapes {
        /// The number of fingers to be placed.
        fingers: usize,
        /// The motion, in the frame of the part.
        motion: clench_screw::Screw,
    },
    /// Each combination was excluded, none by one motion for all.
    #[error(
        "no placement of {placed} holds the part: on each of \
         {all} some motion stays free",
        placed = counted(*.fingers as f64, "frictionless finger"),
        all = counted(*.combinations, "combination")
    )]
    NeverHeld {
        /// The number of fingers to be placed.
        fingers: usize,
        /// The number of combinations.
        combinations: f64,
    },
    /// The search was stopped before it found a placement.
    #[error(
        "the search for {placed} was stopped before it found a placement; none is \
         better than {upper_bound:.4e}",
        placed = counted(*.fingers as f64, "finger")
    )]
    NothingFound {
        /// The number of fingers.
        fingers: usize,
        /// How it ended.
        ended: Ended,
        /// What no placement surpasses (force / length).
        upper_bound: f64,
    },
}

/// So many things: one, or several.
fn counted(count: f64, thing: &str) -> String {
    let plural = if (count - 1.0).abs() > 0.0 { "s" } else { "" };
    format!("{count} {thing}{plural}")
}
