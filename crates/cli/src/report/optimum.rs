//! The report on the best placements.

use std::num::NonZeroUsize;

use clench::optimize::{Combinations, Outcome};
use serde::{Serialize, Serializer};

use super::access::AccessReport;
use super::drawing::DrawingReport;
use super::number::UnitNames;
use super::quality::ReachReport;
use super::second_order::missing;
use super::words::{EndWord, LimitWord, ObjectiveWord};
use crate::input::{Finite, Whole, schema};
use crate::optimize::{Found, Held, On};
use crate::view::{components, plain};

/// What was asked, repeated in the report.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Question<'a> {
    pub(crate) version: u64,
    pub(crate) dimension: u8,
    pub(crate) units: &'a schema::Units,
    pub(crate) part: &'a schema::Part,
    /// Where the part is from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) drawing: Option<&'a DrawingReport>,
    pub(crate) fingers: usize,
    pub(crate) objective: ObjectiveWord,
    /// Only where rotation is the objective.
    pub(crate) least_translation: Option<f64>,
    pub(crate) total_preload: Option<f64>,
    pub(crate) finger_radius: f64,
    pub(crate) least_share: f64,
    /// How many of the placed fingers may be on one plane of a solid, and levers of which part of
    /// the reach count as none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) most_on_face: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) roundness: Option<f64>,
    /// How far off its plane a vertex of a solid may be (length).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) flatness: Option<f64>,
    /// The least gap between the tips of fingers on a solid, if one is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) clearance: Option<f64>,
    /// What a reader has to know of the question.
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    pub(crate) warnings: &'a [String],
    pub(crate) effort: EffortReport,
}

/// How far the search was to go.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct EffortReport {
    pub(crate) top: NonZeroUsize,
    pub(crate) gap: f64,
    /// In seconds.
    pub(crate) time: Option<f64>,
    pub(crate) nodes: Option<u64>,
}

/// The report when no placement holds the part.
#[derive(Debug, Serialize)]
pub(crate) struct UnansweredReport<'a> {
    #[serde(flatten)]
    pub(crate) question: &'a Question<'a>,
    pub(crate) reason: &'a str,
}

/// All that `optimize` reports.
#[derive(Debug, Serialize)]
pub(crate) struct OptimumReport<'a> {
    #[serde(flatten)]
    pub(crate) question: &'a Question<'a>,
    #[serde(flatten)]
    pub(crate) best: PlacementReport,
    pub(crate) certificate: CertificateReport,
    pub(crate) combinations: CombinationsReport,
    /// Where the tips of fingers have room, if that is not everywhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) accessible: Option<AccessReport>,
    /// The best combinations, the best of all included; only if more than one was asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) top: Vec<PlacementReport>,
}

/// The best placement on one combination of edges, faces or candidates.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct PlacementReport {
    pub(crate) quality: f64,
    pub(crate) sigma_min: f64,
    pub(crate) mu_eq: f64,
    pub(crate) limited_by: LimitWord,
    pub(crate) contacts: Vec<PlacedFinger>,
    #[serde(flatten)]
    pub(crate) in_plane: Option<OptimumInPlane>,
    #[serde(flatten)]
    pub(crate) in_space: Option<OptimumInSpace>,
    pub(crate) worst_point_stiffness: f64,
    pub(crate) worst_point: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) worst_corner: Option<usize>,
    /// The least share.
    pub(crate) preload_margin: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) quality_second_order: Option<f64>,
    /// Why there is none in spite of a preload.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) quality_second_order_missing: Option<String>,
}

/// What only placements on outlines have.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct OptimumInPlane {
    pub(crate) center_of_compliance: Vec<f64>,
    pub(crate) reach: ReachReport,
}

/// What only placements on solids have.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct OptimumInSpace {
    pub(crate) quality_rotational: f64,
    /// The point about which force and rotation couple symmetrically.
    pub(crate) center: Vec<f64>,
    /// Whether it is the center of compliance.
    pub(crate) true_center_exists: bool,
    pub(crate) worst_direction: Vec<f64>,
}

/// A finger at its place, in the words of the file schema.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct PlacedFinger {
    /// Whether it was given rather than placed.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(crate) fixed: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) edge: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) face: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) candidate: Option<usize>,
    pub(crate) point: Vec<f64>,
    pub(crate) inward_normal: Vec<f64>,
    pub(crate) law: schema::Law,
    pub(crate) preload: f64,
    pub(crate) share: f64,
    pub(crate) finger: schema::Finger,
    /// That of the law, for the text.
    #[serde(skip)]
    pub(crate) stiffness: f64,
}

/// What is known about the optimum.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct CertificateReport {
    pub(crate) proved: bool,
    pub(crate) ended: EndWord,
    pub(crate) upper_bound: f64,
    pub(crate) gap: f64,
}

/// What the search took.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct CombinationsReport {
    #[serde(serialize_with = "count")]
    pub(crate) total: f64,
    pub(crate) examined: u64,
    pub(crate) nodes: u64,
}

impl<'a> OptimumReport<'a> {
    /// The report on the placements that were found, the best one first.
    pub(crate) fn new<const N: usize, const M: usize>(
        question: &'a Question<'a>,
        outcome: &Outcome<N, M>,
        (best, others): (PlacementReport, Vec<PlacementReport>),
    ) -> Self {
        let all = std::iter::once(best.clone()).chain(others.iter().cloned());
        let top = if question.effort.top.get() > 1 { all.collect() } else { Vec::new() };
        let ended = EndWord::from(outcome.certificate.ended);
        let Combinations { total, examined, nodes } = outcome.combinations;
        Self {
            certificate: CertificateReport {
                proved: ended == EndWord::Proved,
                ended,
                upper_bound: outcome.certificate.upper_bound,
                gap: outcome.gap(),
            },
            question,
            best,
            combinations: CombinationsReport { total, examined, nodes },
            accessible: None,
            top,
        }
    }
}

impl PlacementReport {
    /// A placement on an outline.
    pub(crate) fn planar(question: &Question<'_>, found: &Found<'_, 2, 1>) -> Self {
        let farthest = found.solution.quality.softest_rotation().farthest;
        let in_plane = OptimumInPlane {
            center_of_compliance: components(found.solution.center()),
            reach: ReachReport {
                corner: farthest.corner,
                point: farthest.point.to_array().to_vec(),
                distance: farthest.value,
            },
        };
        Self { in_plane: Some(in_plane), ..Self::new(question, found) }
    }

    /// A placement on a solid.
    pub(crate) fn spatial(question: &Question<'_>, found: &Found<'_, 3, 3>) -> Self {
        let principal = &found.solution.principal;
        let in_space = OptimumInSpace {
            quality_rotational: found.softest.value,
            center: components(principal.center()),
            true_center_exists: principal.center_of_compliance().is_some(),
            worst_direction: components(found.worst.direction),
        };
        Self { in_space: Some(in_space), ..Self::new(question, found) }
    }

    /// All but what only plane or space have.
    fn new<const N: usize, const M: usize>(
        question: &Question<'_>,
        found: &Found<'_, N, M>,
    ) -> Self {
        let quality = &found.solution.quality;
        let contacts = found.contacts.iter().map(|held| PlacedFinger::new(question, held));
        let contacts: Vec<_> = contacts.collect();
        let second = found.second_order.as_ref();
        Self {
            quality: quality.value,
            sigma_min: quality.translational,
            mu_eq: quality.equivalent(),
            limited_by: quality.limited_by.into(),
            in_plane: None,
            in_space: None,
            worst_point_stiffness: found.worst.stiffness,
            worst_point: found.worst.point.to_array().to_vec(),
            worst_corner: found.worst.corner,
            preload_margin: contacts.iter().map(|c| c.share).fold(f64::INFINITY, f64::min),
            contacts,
            quality_second_order: second.and_then(|q| q.as_ref().ok()).map(|q| q.value),
            quality_second_order_missing: second
                .and_then(|q| q.as_ref().err())
                .map(|error| missing::<N>(error, UnitNames(question.units))),
        }
    }

    /// What was maximized.
    pub(crate) fn value(&self, objective: ObjectiveWord) -> f64 {
        match (objective, &self.in_space) {
            (ObjectiveWord::Quality, _) => self.quality,
            (ObjectiveWord::WorstPoint, _) => self.worst_point_stiffness,
            (ObjectiveWord::Rotation | ObjectiveWord::AnyRotation, Some(space)) => {
                space.quality_rotational
            }
            (ObjectiveWord::Rotation | ObjectiveWord::AnyRotation, None) => self.mu_eq,
        }
    }

    /// The fingers that were placed rather than given.
    pub(crate) fn placed(&self) -> impl Iterator<Item = &PlacedFinger> {
        self.contacts.iter().filter(|contact| !contact.fixed)
    }
}

impl PlacedFinger {
    fn new<const N: usize>(question: &Question<'_>, held: &Held<N>) -> Self {
        let on = |wanted: fn(On) -> Option<usize>| held.on.and_then(wanted);
        let share = plain(held.share);
        Self {
            fixed: held.fixed,
            edge: on(On::edge),
            face: on(On::face),
            candidate: on(On::candidate),
            point: components(held.geometry.point),
            inward_normal: components(held.geometry.inward_normal),
            law: schema::Law::Linear { stiffness: Finite(held.stiffness) },
            preload: question.total_preload.unwrap_or(0.0) * share,
            share,
            finger: held.finger.clone(),
            stiffness: held.stiffness,
        }
    }

    /// The number of the edge, the face or the candidate that it is on.
    pub(crate) fn number(&self) -> Option<usize> {
        self.edge.or(self.face).or(self.candidate)
    }
}

/// A count that is a whole number where a double has all of its digits.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "the form that serde asks for")]
fn count<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    match Whole::exactly(*value) {
        Some(count) => count.serialize(serializer),
        None => value.serialize(serializer),
    }
}
