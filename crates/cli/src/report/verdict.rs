//! Whether a grasp holds the part, and if not, why.

use clench::contact::Order;
use clench::metrics::MetricsError;
use clench::screw::{Cholesky, Twist, Vector};
use clench::stiffness::{BALANCED, Stability};
use serde::Serialize;

use super::analysis::NO_SHARE;
use super::measures::Axis;
use super::number::{INVISIBLE, spot};
use crate::analyze::Analysis;
use crate::wording::digits;

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
    Translation {
        direction: Vec<f64>,
    },
    Rotation {
        /// In the plane the point that stays, in space one of the axis.
        center: Vec<f64>,
        /// In space.
        #[serde(skip_serializing_if = "Option::is_none")]
        axis: Option<Vec<f64>>,
        /// In space: how far the part moves along the axis per radian.
        #[serde(skip_serializing_if = "Option::is_none")]
        pitch: Option<f64>,
    },
}

impl Verdict {
    /// The verdict on the grasp that was analyzed.
    pub(super) fn on<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> Self {
        let free_motion = analysis.metrics.as_ref().err().and_then(|e| free(analysis, e));
        let pulling_contacts = pulling(analysis);
        let mut warnings = warnings(analysis);
        let loose = loose(analysis, &pulling_contacts);
        let reason = unstable(analysis, free_motion.as_ref());
        // Loads that balance press the part on its fingers.
        let loaded = !analysis.grasp.loads().is_empty() && analysis.equilibrium.holds;
        let reason = match (reason, loose) {
            (None, Some(loose)) if loaded => {
                warnings.push(format!("only the loads keep the part on its fingers: {loose}"));
                None
            }
            (reason, loose) => reason.or(loose),
        };
        Self { reason, free_motion, pulling_contacts, warnings }
    }
}

fn free<const N: usize, const M: usize>(
    analysis: &Analysis<'_, N, M>,
    error: &MetricsError,
) -> Option<FreeMotion> {
    let components = |all: [f64; 3]| Vector::<N>::from_fn(|i| all[i]);
    match *error {
        MetricsError::TranslationNotHeld { direction, .. } => {
            let direction = analysis.view.direction(components(direction));
            Some(FreeMotion::Translation { direction })
        }
        MetricsError::RotationNotHeld { axis, center, .. } => {
            let center = components(center);
            let axis = Axis::of(&forceless(analysis, center, axis), center, &analysis.view);
            let in_space = N == 3;
            Some(FreeMotion::Rotation {
                center: axis.point,
                axis: in_space.then_some(axis.direction),
                pitch: in_space.then_some(axis.pitch),
            })
        }
        _ => None,
    }
}

/// The motion that turns about `axis` and needs no force, about `center`: the translation that
/// goes with it is that of a screw.
fn forceless<const N: usize, const M: usize>(
    analysis: &Analysis<'_, N, M>,
    center: Vector<N>,
    axis: [f64; 3],
) -> Twist<N, M> {
    let stiffness = analysis.grasp.stiffness(center, analysis.order);
    // The last axes: in the plane the rotation is about z.
    let angular = Vector::<M>::from_fn(|i| axis[i + 3 - M]);
    let held = Cholesky::new(&stiffness.translational);
    let linear = held.map_or(Vector::ZERO, |k| -k.solve(stiffness.coupling * angular));
    Twist { linear, angular }
}

fn pulling<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> Vec<usize> {
    let Some(best) = &analysis.preloads.best else { return Vec::new() };
    let pulls = |share: f64| share < -NO_SHARE;
    (0..best.shares.len()).filter(|&i| pulls(best.shares[i])).collect()
}

/// Why a part that its springs were glued to would move.
fn unstable<const N: usize, const M: usize>(
    analysis: &Analysis<'_, N, M>,
    free: Option<&FreeMotion>,
) -> Option<String> {
    match (free, &analysis.metrics) {
        (Some(motion), _) => return Some(free_to(analysis, &in_words(analysis, motion))),
        (None, Err(e)) => return Some(e.to_string()),
        (None, Ok(_)) => {}
    }
    let unstable = matches!(analysis.stability, Stability::Unstable | Stability::Marginal);
    (analysis.equilibrium.holds && unstable).then(|| {
        "the grasp is not stable: to first order the contacts hold the part, but the preload \
         pushes it away"
            .to_owned()
    })
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
    motion: &FreeMotion,
) -> String {
    let (size, length) = (analysis.size, &analysis.units.length);
    match motion {
        FreeMotion::Translation { direction } => format!("slide along {}", spot(direction, 1.0)),
        FreeMotion::Rotation { center, axis: None, .. } => {
            format!("turn about {} {length}", spot(center, size))
        }
        FreeMotion::Rotation { center, axis: Some(axis), pitch } => {
            let (axis, center) = (spot(axis, 1.0), spot(center, size));
            let turn = format!("turn about the axis along {axis} through {center} {length}");
            match pitch {
                Some(pitch) if pitch.abs() > INVISIBLE * size => {
                    format!("{turn}, moving {} {length} along it per rad", digits(*pitch))
                }
                _ => turn,
            }
        }
    }
}

/// The part is free to move; unless it only seems so, because the preloads that would hold it
/// have too few digits to balance.
fn free_to<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>, motion: &str) -> String {
    let by_preload = matches!(analysis.stability, Stability::SecondOrder);
    let first = analysis.order_chosen && matches!(analysis.order, Order::First);
    if !(by_preload && first) || analysis.equilibrium.holds {
        return format!("the grasp is not stable: the part is free to {motion}");
    }
    let left = analysis.equilibrium.relative_force.max(analysis.equilibrium.relative_torque);
    let forces = forces(analysis);
    format!(
        "to first order the part is free to {motion}; the {forces} would hold it, but are out of \
         balance by {left:.1e} of their total (at most {BALANCED:.1e} is allowed): give more \
         digits, or ask for --order second"
    )
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
    if margin.is_some_and(|t| (-NO_SHARE..=NO_SHARE).contains(&t)) {
        warnings.push(
            "the grasp is at the limit of what can hold: when the forces balance, a finger \
             barely presses"
                .to_owned(),
        );
    }
    warnings
}

/// What acts on the part at rest.
fn forces<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> &'static str {
    if analysis.grasp.loads().is_empty() { "preloads" } else { "preloads and loads" }
}
