//! The report on preloads that keep every contact on the part.

use clench::stiffness::{Basis, Needed, NeededPreloads};
use serde::Serialize;

use super::load_case::LoadCaseReport;
use crate::analyze::Analysis;
use crate::view::plain;

/// Preloads under which no contact lifts off, whatever load case acts.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct NeededReport {
    /// The part of its preload that each contact keeps at least.
    pub(crate) reserve: f64,
    /// With the least total.
    pub(crate) least: RemedyReport,
    /// The present ones, all times one factor.
    pub(crate) scaled: RemedyReport,
}

/// One such set of preloads, or why there is none.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub(crate) enum RemedyReport {
    Found(FoundPreloads),
    None { reason: String },
}

/// Preloads under which no contact lifts off.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct FoundPreloads {
    /// How many times the present ones they are.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) factor: Option<f64>,
    pub(crate) total: f64,
    /// In the order of the contacts.
    pub(crate) preloads: Vec<f64>,
    /// The least force of each contact under any load case.
    pub(crate) least_forces: Vec<f64>,
    /// Of each load case, in the order of the contacts.
    pub(crate) contact_forces: Vec<Vec<f64>>,
    pub(crate) basis: BasisWord,
}

/// With which preloads the changes of contact forces were found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum BasisWord {
    Needed,
    Present,
}

impl NeededReport {
    /// The report of `analysis`, whose load cases are `cases`; none if nothing is needed.
    pub(super) fn new<const N: usize, const M: usize>(
        analysis: &Analysis<'_, N, M>,
        cases: &[LoadCaseReport],
    ) -> Option<Self> {
        let needed = analysis.needed.as_ref()?;
        let of = |found: &NeededPreloads| RemedyReport::new(analysis, cases, found);
        let factor = |needed: &Needed| {
            let total: f64 = needed.preloads.iter().sum();
            plain(total / analysis.grasp.total_preload())
        };
        let mut scaled = of(&needed.scaled);
        if let (RemedyReport::Found(report), NeededPreloads::Found(found)) =
            (&mut scaled, &needed.scaled)
        {
            report.factor = Some(factor(found)).filter(|factor| factor.is_finite());
        }
        Some(Self { reserve: needed.reserve, least: of(&needed.least), scaled })
    }
}

impl RemedyReport {
    fn new<const N: usize, const M: usize>(
        analysis: &Analysis<'_, N, M>,
        cases: &[LoadCaseReport],
        found: &NeededPreloads,
    ) -> Self {
        let reason = match found {
            NeededPreloads::Found(needed) => return Self::Found(FoundPreloads::new(needed)),
            NeededPreloads::Unreachable { contacts } => {
                let lose = losing(contacts, cases);
                if analysis.grasp.loads().is_empty() {
                    format!("{lose}, and no preloads that balance press it: no force closure")
                } else {
                    format!("{lose}, and no preloads that balance the loads press it so much")
                }
            }
            NeededPreloads::LoadsNotBalanced => {
                "no preloads of fingers that only push balance the loads".to_owned()
            }
            NeededPreloads::NoPreload { contacts } => {
                format!("{}, and has no preload to scale", losing(contacts, cases))
            }
            NeededPreloads::NoLeast { contacts } => {
                let names: Vec<String> = contacts.iter().map(ToString::to_string).collect();
                format!(
                    "those with the least total leave none for {} {}, without stiffness then; any \
                     preload there will do, but none is the least",
                    if contacts.len() == 1 { "contact" } else { "contacts" },
                    names.join(", "),
                )
            }
            NeededPreloads::NotByScaling if analysis.grasp.loads().is_empty() => {
                "the present preloads do not balance".to_owned()
            }
            NeededPreloads::NotByScaling => {
                "the loads need these preloads: others in the same ratio would not balance them"
                    .to_owned()
            }
            NeededPreloads::NoChanges => "the changes of contact forces are not known".to_owned(),
        };
        Self::None { reason }
    }
}

impl FoundPreloads {
    fn new(needed: &Needed) -> Self {
        let Needed { preloads, changes, basis } = needed;
        let force = |case: &Vec<f64>| -> Vec<f64> {
            preloads.iter().zip(case).map(|(preload, change)| plain(preload + change)).collect()
        };
        let contact_forces: Vec<Vec<f64>> = changes.iter().map(force).collect();
        let least = |i: usize| contact_forces.iter().map(|of| of[i]).fold(preloads[i], f64::min);
        Self {
            factor: None,
            total: preloads.iter().sum(),
            least_forces: (0..preloads.len()).map(least).collect(),
            preloads: preloads.clone(),
            contact_forces,
            basis: match basis {
                Basis::Needed => BasisWord::Needed,
                Basis::Present => BasisWord::Present,
            },
        }
    }
}

/// That the first of `contacts` loses force, and under which load case most.
fn losing(contacts: &[usize], cases: &[LoadCaseReport]) -> String {
    let Some(&contact) = contacts.first() else { return "a contact loses force".to_owned() };
    let change = |case: &LoadCaseReport| case.contact_forces[contact].change;
    let most = cases.iter().enumerate().min_by(|(_, a), (_, b)| change(a).total_cmp(&change(b)));
    let under =
        most.map_or_else(String::new, |(number, case)| format!(" under {}", case.title(number)));
    format!("contact {contact} loses force{under}")
}
