//! Whether a grasp holds the part, and if not, why.

use clench::contact::Order;
use clench::metrics::MetricsError;
use clench::screw::Vector;
use clench::stiffness::{BALANCED, Stability};
use serde::Serialize;

use super::analysis::NO_SHARE;
use super::axes::AxisReport;
use super::number::{INVISIBLE, spot};
use crate::analyze::Analysis;
use crate::held::NotHeld;
use crate::view::plain;
use crate::wording::{counted, digits, rough_digits};

/// A stiffness is negative, and not the rounding of zero, if it is below minus this part of the
/// number that it is compared to: the sums of products that may leave so much are the same on both
/// sides of zero, and [`MetricsError`] allows for as much above it.
const NEGATIVE: f64 = 64.0 * f64::EPSILON;

/// What the numbers mean for the part.
#[derive(Debug)]
pub(super) struct Verdict {
    /// Why the fingers cannot hold the part.
    pub(super) reason: Option<String>,
    /// The motion that the stiffness does not resist.
    pub(super) free_motion: Option<FreeMotion>,
    /// The contacts that would have to pull for the forces to balance, even in the best case.
    pub(super) pulling_contacts: Vec<usize>,
    /// What a reader has to know before trusting the numbers.
    pub(super) warnings: Vec<String>,
}

/// What the fingers do not resist.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub(crate) enum FreeMotion {
    Translation { direction: Vec<f64> },
    Rotation(AxisReport),
}

/// A motion that the fingers do not resist, and whether it takes place by itself.
#[derive(Clone, Debug)]
struct Escape {
    motion: FreeMotion,
    drive: Drive,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Drive {
    /// The motion costs no energy.
    None,
    /// It releases some.
    Pushed,
}

impl Verdict {
    /// The verdict on the grasp that was analyzed.
    pub(super) fn on<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> Self {
        let escape = escape(analysis);
        let pulling_contacts = pulling(analysis);
        let mut warnings = warnings(analysis);
        let loose = loose(analysis, &pulling_contacts);
        let held = analysis.metrics.is_ok();
        let reason = unstable(analysis, escape.as_ref().filter(|_| !held));
        let reason = reason.or_else(|| loose.clone().filter(|_| !analysis.loaded));
        let reason = reason.or_else(|| slack(analysis));
        if analysis.loaded && !analysis.preloads.force_closure && reason.is_none() {
            let loose = loose.map_or(String::new(), |loose| format!(": {loose}"));
            warnings.push(format!("only the loads keep the part on its fingers{loose}"));
        }
        let free_motion = escape.map(|escape| escape.motion);
        Self { reason, free_motion, pulling_contacts, warnings }
    }
}

fn escape<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> Option<Escape> {
    match (&analysis.metrics, &analysis.slack) {
        (Err(not_held), _) => escape_of(analysis, not_held),
        (Ok(_), Some(slack)) => escape_of(analysis, &slack.not_held),
        (Ok(_), None) => None,
    }
}

fn escape_of<const N: usize, const M: usize>(
    analysis: &Analysis<'_, N, M>,
    not_held: &NotHeld,
) -> Option<Escape> {
    let NotHeld::One(error) = not_held else { return None };
    // Where lines of action meet, both numbers of an error may be rounding, and the class decides,
    // which compares with all that the contacts resist; unless it is that about another point.
    let class = analysis.classes.to_order(analysis.order);
    let negative = class == Stability::Unstable || out_of_balance(analysis);
    let drive = |value: f64, scale: f64| {
        let pushed = negative && value < -NEGATIVE * scale;
        if pushed { Drive::Pushed } else { Drive::None }
    };
    match *error {
        MetricsError::TranslationNotHeld { direction, value, largest } => {
            let direction = analysis.view.direction(Vector::from_fn(|i| direction[i]));
            let motion = FreeMotion::Translation { direction };
            Some(Escape { motion, drive: drive(value, largest) })
        }
        MetricsError::RotationNotHeld { axis, value, scale } => {
            let (direction, axis_point) = analysis.view.axis(&axis);
            let pitch = plain(axis.pitch);
            let motion = FreeMotion::Rotation(AxisReport { direction, axis_point, pitch });
            Some(Escape { motion, drive: drive(value, scale) })
        }
        _ => None,
    }
}

fn pulling<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> Vec<usize> {
    let Some(best) = &analysis.preloads.best else { return Vec::new() };
    let pulls = |share: f64| share < -NO_SHARE;
    (0..best.shares.len()).filter(|&i| pulls(best.shares[i])).collect()
}

/// Why a part that its springs were glued to would move.
fn unstable<const N: usize, const M: usize>(
    analysis: &Analysis<'_, N, M>,
    escape: Option<&Escape>,
) -> Option<String> {
    let class = analysis.classes.grasp;
    let moves = match (&analysis.metrics, escape) {
        (_, Some(escape)) => format!("the part {}", in_words(analysis, escape)),
        (Err(NotHeld::One(error)), None) => return Some(error.to_string()),
        (Err(NotHeld::Some), None) => releases(class).to_owned(),
        // What holds to first order may be pushed away all the same.
        (Ok(_), None) => match class {
            Stability::FirstOrder | Stability::SecondOrder => return None,
            _ if !analysis.equilibrium.holds => return None,
            _ => releases(class).to_owned(),
        },
    };
    let forces = forces(analysis);
    if analysis.order == Order::First && class == Stability::SecondOrder {
        let held = by_preload(analysis);
        return Some(format!("to first order {moves}{held}"));
    }
    if out_of_balance(analysis) {
        return Some(format!(
            "the {forces} do not balance, and to second order the stiffness is not positive about \
             every point: {moves}"
        ));
    }
    let springs_hold = analysis.classes.springs == Stability::FirstOrder;
    if springs_hold && (analysis.metrics.is_ok() || analysis.order == Order::Second) {
        let effect = if class == Stability::Unstable { "push it away" } else { "leave it free" };
        return Some(format!(
            "the grasp is not stable: to first order the contacts hold the part, but the {forces} \
             {effect}: {moves}"
        ));
    }
    Some(format!("the grasp is not stable: {moves}"))
}

/// Why a part comes loose from fingers that nothing presses on it.
fn slack<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> Option<String> {
    let slack = analysis.slack.as_ref()?;
    let names: Vec<_> = slack.contacts.iter().map(usize::to_string).collect();
    let names = names.join(", contact ");
    let why = if slack.at_rest { "nothing presses" } else { "no preload can press" };
    let without = match escape_of(analysis, &slack.not_held) {
        Some(escape) => format!("the part {}", in_words(analysis, &escape)),
        None => "the part is not held".to_owned(),
    };
    Some(format!(
        "{why} contact {names} on the part, a finger can only push, and without that {without}"
    ))
}

/// Whether the stiffness of the report depends on the point about which it is formed.
fn out_of_balance<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> bool {
    analysis.order == Order::Second && !analysis.equilibrium.holds
}

/// What is known of the energy when no motion is.
const fn releases(class: Stability) -> &'static str {
    match class {
        Stability::Unstable => "some motion releases energy",
        _ => "some motion costs no energy",
    }
}

/// What holds a part that is free to first order only.
fn by_preload<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> String {
    let forces = forces(analysis);
    if analysis.equilibrium.holds {
        return format!("; the {forces} hold it to second order");
    }
    if !analysis.order_chosen {
        return String::new();
    }
    let left = analysis.equilibrium.relative_force.max(analysis.equilibrium.relative_torque);
    let (left, allowed) = (rough_digits(left), rough_digits(BALANCED));
    format!(
        "; the {forces} would hold it, but are out of balance by {left} of their total (at most \
         {allowed} is allowed): give more digits, or ask for --order second"
    )
}

/// Why a part could be pulled out, though its springs alone would hold it.
fn loose<const N: usize, const M: usize>(
    analysis: &Analysis<'_, N, M>,
    pulling: &[usize],
) -> Option<String> {
    let shares = analysis.preloads.best.as_ref().map(|best| &best.shares);
    match (shares, pulling) {
        (None, _) => Some(
            "fingers can only push, and no preload of these contacts balances: \
             the part can be pulled out"
                .to_owned(),
        ),
        (Some(_), []) => None,
        (Some(shares), pulling) => {
            let names = pulling.iter().map(|&i| format!("{i} ({})", digits(shares[i])));
            Some(format!(
                "fingers can only push, but for the forces to balance contact {} would have to \
                 pull (its share of the preload in brackets)",
                names.collect::<Vec<_>>().join(", contact ")
            ))
        }
    }
}

fn in_words<const N: usize, const M: usize>(
    analysis: &Analysis<'_, N, M>,
    escape: &Escape,
) -> String {
    let (size, length) = (analysis.size, &analysis.units.length);
    let [slides, turns] = match escape.drive {
        Drive::None => ["is free to slide", "is free to turn"],
        Drive::Pushed => ["is pushed away", "turns away"],
    };
    match &escape.motion {
        FreeMotion::Translation { direction } => format!("{slides} along {}", spot(direction, 1.0)),
        FreeMotion::Rotation(axis) if N == 2 => {
            format!("{turns} about {} {length}", spot(&axis.axis_point, size))
        }
        FreeMotion::Rotation(AxisReport { direction, axis_point, pitch }) => {
            let (along, through) = (spot(direction, 1.0), spot(axis_point, size));
            let turns = format!("{turns} about the axis along {along} through {through} {length}");
            if pitch.abs() <= INVISIBLE * size {
                return turns;
            }
            format!("{turns}, moving {} {length} along it per rad", digits(*pitch))
        }
    }
}

fn warnings<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> Vec<String> {
    let mut warnings = Vec::new();
    if !analysis.equilibrium.holds {
        let (text, order) = (format!("the {} do not balance", forces(analysis)), analysis.order);
        warnings.push(match order {
            Order::Second => format!(
                "{text}, so the stiffness to second order and what follows from it depend on the \
                 frame"
            ),
            Order::First if analysis.order_chosen => {
                format!("{text}, so the stiffness is given to first order only")
            }
            Order::First => text,
        });
    }
    let margin = analysis.preloads.best.as_ref().map(|best| best.margin);
    if !analysis.loaded && margin.is_some_and(|t| (-NO_SHARE..=NO_SHARE).contains(&t)) {
        warnings.push(
            "the grasp is at the limit of what can hold: when the forces balance, a finger \
             barely presses"
                .to_owned(),
        );
    }
    if analysis.metrics.is_err() && analysis.unanswered > 0 {
        let cases = counted(analysis.unanswered, "load case");
        warnings.push(format!("{cases} not answered: a part that is not held has no displacement"));
    }
    warnings
}

/// What acts on the part at rest.
fn forces<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> &'static str {
    if analysis.grasp.loads().is_empty() { "preloads" } else { "preloads and loads" }
}
