//! Whether a grasp holds the part, and if not, why.

use clench::contact::Order;
use clench::metrics::MetricsError;
use clench::stiffness::BALANCED;
use clench::stiffness::Stability;

use super::analysis::{FreeMotion, NO_SHARE, direction, point};
use super::number::spot;
use crate::analyze::Analysis;
use crate::wording::digits;

/// The motion that the stiffness does not resist.
pub(super) fn free(analysis: &Analysis<'_>, error: &MetricsError) -> Option<FreeMotion> {
    match *error {
        MetricsError::TranslationNotHeld { direction: [x, y, _], .. } => {
            let direction = direction(analysis, [x, y].into());
            Some(FreeMotion::Translation { direction })
        }
        MetricsError::RotationNotHeld { center: [x, y, _], .. } => {
            Some(FreeMotion::Rotation { center: point(analysis, [x, y].into()) })
        }
        _ => None,
    }
}

/// The contacts that would have to pull for the forces to balance, even in the best case.
pub(super) fn pulling(analysis: &Analysis<'_>) -> Vec<usize> {
    let Some(best) = &analysis.preloads.best else { return Vec::new() };
    let pulls = |share: f64| share < -NO_SHARE;
    (0..best.shares.len()).filter(|&i| pulls(best.shares[i])).collect()
}

/// Why there is no quality, or why the fingers cannot hold the part.
pub(super) fn reason(
    analysis: &Analysis<'_>,
    free: Option<&FreeMotion>,
    pulling: &[usize],
    size: f64,
) -> Option<String> {
    match (free, &analysis.metrics) {
        (Some(motion), _) => {
            let motion = match motion {
                FreeMotion::Translation { direction } => {
                    format!("slide along {}", spot(*direction, 1.0))
                }
                FreeMotion::Rotation { center } => {
                    format!("turn about {} {}", spot(*center, size), analysis.units.length)
                }
            };
            return Some(free_to(analysis, &motion));
        }
        (None, Err(e)) => return Some(e.to_string()),
        (None, Ok(_)) => {}
    }
    if analysis.equilibrium.holds
        && matches!(analysis.stability, Stability::Unstable | Stability::Marginal)
    {
        return Some(
            "the grasp is not stable: to first order the contacts hold the part, but the \
             preload pushes it away"
                .to_owned(),
        );
    }
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

/// The part is free to move; unless it only seems so, because the preloads that would hold it
/// have too few digits to balance.
fn free_to(analysis: &Analysis<'_>, motion: &str) -> String {
    let by_preload = matches!(analysis.stability, Stability::SecondOrder);
    let first = analysis.order_chosen && matches!(analysis.order, Order::First);
    if !(by_preload && first) || analysis.equilibrium.holds {
        return format!("the grasp is not stable: the part is free to {motion}");
    }
    let left = analysis.equilibrium.relative_force.max(analysis.equilibrium.relative_torque);
    format!(
        "to first order the part is free to {motion}; the preloads would hold it, but are out of \
         balance by {left:.1e} of their total (at most {BALANCED:.1e} is allowed): give more \
         digits, or ask for --order second"
    )
}

/// What a reader has to know before trusting the numbers.
pub(super) fn warnings(analysis: &Analysis<'_>) -> Vec<String> {
    let mut warnings = Vec::new();
    if !analysis.equilibrium.holds {
        let (text, order) = ("the preloads do not balance", analysis.order);
        warnings.push(match order {
            Order::Second => format!(
                "{text}, so the stiffness to second order and what follows from it depend on the \
                 frame"
            ),
            Order::First if analysis.order_chosen => {
                format!("{text}, so the stiffness is given to first order only")
            }
            Order::First => text.to_owned(),
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
