//! The report on the best placements.

use std::num::NonZeroUsize;

use clench::optimize::polygon::Part;
use clench::optimize::{Combinations, Outcome, Placement};
use serde::{Serialize, Serializer};

use super::quality::ReachReport;
use super::words::{EndWord, LimitWord, ObjectiveWord};
use crate::input::{Finite, Whole, schema};
use crate::optimize::Found;
use crate::view::plain;

/// What was asked, repeated in the report.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Question<'a> {
    pub(crate) version: u64,
    pub(crate) dimension: u8,
    pub(crate) units: &'a schema::Units,
    pub(crate) part: &'a schema::Part,
    pub(crate) fingers: usize,
    pub(crate) objective: ObjectiveWord,
    /// Only where rotation is the objective.
    pub(crate) least_translation: Option<f64>,
    pub(crate) total_preload: Option<f64>,
    pub(crate) finger_radius: f64,
    /// Not of three fingers.
    pub(crate) least_distance: Option<f64>,
    pub(crate) least_share: f64,
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
    /// The best combinations, the best of all included; only if more than one was asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) top: Vec<PlacementReport>,
}

/// The best placement on one combination of edges.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct PlacementReport {
    pub(crate) quality: f64,
    pub(crate) sigma_min: f64,
    pub(crate) mu_eq: f64,
    pub(crate) limited_by: LimitWord,
    pub(crate) contacts: Vec<PlacedFinger>,
    pub(crate) center_of_compliance: [f64; 2],
    pub(crate) reach: ReachReport,
    pub(crate) worst_point_stiffness: f64,
    pub(crate) worst_point: [f64; 2],
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

/// A finger at its place, in the words of the file schema.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct PlacedFinger {
    pub(crate) edge: usize,
    pub(crate) point: [f64; 2],
    pub(crate) inward_normal: [f64; 2],
    pub(crate) law: schema::Law,
    pub(crate) preload: f64,
    pub(crate) share: f64,
    pub(crate) finger: schema::Finger,
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
    /// The report on the best placement and the others.
    pub(crate) fn new(
        question: &'a Question<'a>,
        part: &Part,
        outcome: &Outcome<2, 1>,
        (best, others): (&Found<'_>, &[Found<'_>]),
    ) -> Self {
        let placement = |found: &Found<'_>| PlacementReport::new(question, part, found);
        let best = placement(best);
        let all = std::iter::once(best.clone()).chain(others.iter().map(placement));
        let top = if others.is_empty() { Vec::new() } else { all.collect() };
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
            top,
        }
    }
}

impl PlacementReport {
    fn new(question: &Question<'_>, part: &Part, found: &Found<'_>) -> Self {
        let solution = found.solution;
        let quality = solution.quality;
        let farthest = quality.softest_rotation().farthest;
        let contact = |p: &Placement<2>| PlacedFinger::new(question, part, p);
        let contacts: Vec<_> = solution.placements.iter().map(contact).collect();
        let second = found.second_order.as_ref();
        Self {
            quality: quality.value,
            sigma_min: quality.translational,
            mu_eq: quality.equivalent(),
            limited_by: quality.limited_by.into(),
            center_of_compliance: solution.center().to_array().map(plain),
            reach: ReachReport {
                corner: farthest.corner,
                point: farthest.point.to_array().to_vec(),
                distance: farthest.value,
            },
            worst_point_stiffness: found.worst.stiffness,
            worst_point: found.worst.point.to_array(),
            worst_corner: found.worst.corner,
            preload_margin: contacts.iter().map(|c| c.share).fold(f64::INFINITY, f64::min),
            contacts,
            quality_second_order: second.and_then(|q| q.as_ref().ok()).map(|q| q.value),
            quality_second_order_missing: second
                .and_then(|q| q.as_ref().err())
                .map(ToString::to_string),
        }
    }

    /// What was maximized.
    pub(crate) fn value(&self, objective: ObjectiveWord) -> f64 {
        match objective {
            ObjectiveWord::Quality => self.quality,
            ObjectiveWord::WorstPoint => self.worst_point_stiffness,
            ObjectiveWord::Rotation => self.mu_eq,
        }
    }

    /// The edges that the fingers touch.
    pub(crate) fn edges(&self) -> Vec<usize> {
        self.contacts.iter().map(|contact| contact.edge).collect()
    }
}

impl PlacedFinger {
    fn new(question: &Question<'_>, part: &Part, placement: &Placement<2>) -> Self {
        let stiffness = Finite(part.edge_stiffness()[placement.on]);
        let share = plain(placement.share.max(0.0));
        Self {
            edge: placement.on,
            point: placement.point.to_array().map(plain),
            inward_normal: placement.inward_normal.to_array().map(plain),
            law: schema::Law::Linear { stiffness },
            preload: question.total_preload.unwrap_or(0.0) * share,
            share,
            finger: schema::Finger {
                radius: Some(Finite(question.finger_radius)),
                ..schema::Finger::default()
            },
        }
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
