//! A placement that the search found, as a grasp.

use clench::contact::{Contact, ContactError, Geometry, Law, Order};
use clench::metrics::{EquivalentStiffness, MetricsError, Quality, WorstPoint};
use clench::optimize::Solution;
use clench::shape::Extent;
use clench::stiffness::{Grasp, GraspError};

use crate::held::principal;
use crate::input::schema;

/// A placement that the search found, and what the search does not say of it.
#[derive(Debug)]
pub(crate) struct Found<'a, const N: usize, const M: usize> {
    pub(crate) solution: &'a Solution<N, M>,
    /// Those that are given first.
    pub(crate) contacts: Vec<Held<N>>,
    /// The softest of all rotations that need no force.
    pub(crate) softest: EquivalentStiffness<N, M>,
    /// The worst point by the stiffness that was optimized.
    pub(crate) worst: WorstPoint<N>,
    /// The quality with all that preload and finger radius add; only with a preload.
    pub(crate) second_order: Option<Result<Quality<N, M>, MetricsError>>,
}

/// A contact of such a placement.
#[derive(Clone, Debug)]
pub(crate) struct Held<const N: usize> {
    /// None of a contact that is given on something smooth.
    pub(crate) on: Option<On>,
    /// Whether it was given rather than placed.
    pub(crate) fixed: bool,
    pub(crate) geometry: Geometry<N>,
    /// As the report has it.
    pub(crate) finger: schema::Finger,
    pub(crate) stiffness: f64,
    /// Of the preload, zero or more.
    pub(crate) share: f64,
}

/// What a contact is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum On {
    Edge(usize),
    Face(usize),
    Candidate(usize),
}

impl On {
    /// The number of an edge.
    pub(crate) const fn edge(self) -> Option<usize> {
        if let Self::Edge(edge) = self { Some(edge) } else { None }
    }

    /// The number of a face.
    pub(crate) const fn face(self) -> Option<usize> {
        if let Self::Face(face) = self { Some(face) } else { None }
    }

    /// The number of a candidate.
    pub(crate) const fn candidate(self) -> Option<usize> {
        if let Self::Candidate(candidate) = self { Some(candidate) } else { None }
    }
}

/// Why a placement that was found has no numbers.
#[derive(Debug, thiserror::Error)]
pub(crate) enum OutOfRange {
    /// The contact forces or the laws.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The stiffness of a contact.
    #[error(transparent)]
    Grasp(#[from] GraspError),
    /// The principal stiffnesses.
    #[error(transparent)]
    Metrics(#[from] MetricsError),
}

impl<'a, const N: usize, const M: usize> Found<'a, N, M> {
    /// What is to be said of `solution` on `body`, whose contacts share this preload.
    pub(super) fn new(
        solution: &'a Solution<N, M>,
        contacts: Vec<Held<N>>,
        body: Extent<'_, N>,
        preload: Option<f64>,
    ) -> Result<Self, OutOfRange> {
        let force = preload.unwrap_or(0.0);
        let springs = contacts.iter().map(|held| {
            Contact::new(held.geometry, Law::linear(held.stiffness)?, force * held.share)
        });
        let grasp = Grasp::new(springs.collect::<Result<_, _>>()?)?;
        let second_order = preload.map(|_| {
            principal(&grasp, Order::Second).and_then(|principal| Quality::of(&principal, body))
        });
        Ok(Self {
            softest: EquivalentStiffness::least(&solution.principal, body)?,
            worst: WorstPoint::of(&solution.principal, body)?,
            solution,
            contacts,
            second_order,
        })
    }
}

/// A round finger of this radius.
pub(super) fn round(radius: f64) -> schema::Finger {
    schema::Finger { radius: Some(crate::input::Finite(radius)), ..schema::Finger::default() }
}
