//! From a search to its outcome.

use super::branch::Searched;
use super::leaders::Candidate;
use crate::{Certificate, Combinations, Ended, OptimizeError, Outcome, Solution};

/// What a search was about, beside its problem.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Matter {
    pub(crate) fingers: usize,
    /// How many combinations of stretches there are.
    pub(crate) combinations: f64,
}

/// The outcome of a search with stiffnesses in `unit`, with `confirm` turning leaders into
/// solutions, and `nothing` saying why none is there when all is proved.
///
/// # Errors
///
/// Why nothing was found; the errors of `confirm` for the best.
pub(crate) fn outcome<const N: usize, const M: usize, const K: usize, P>(
    unit: f64,
    matter: Matter,
    searched: &Searched<K, P>,
    confirm: impl Fn(&Candidate<K, P>) -> Result<Solution<N, M>, OptimizeError>,
    nothing: impl FnOnce() -> OptimizeError,
) -> Result<Outcome<N, M>, OptimizeError> {
    let upper_bound = searched.upper_bound * unit;
    let Some((first, rest)) = searched.leaders.candidates().split_first() else {
        let (fingers, ended) = (matter.fingers, searched.ended);
        return Err(match ended {
            Ended::Proved => nothing(),
            _ => OptimizeError::NothingFound { fingers, ended, upper_bound },
        });
    };
    let best = confirm(first)?;
    // A lesser combination whose stiffness is lost in rounding is no alternative.
    let others = rest.iter().filter_map(|candidate| confirm(candidate).ok()).collect();
    let (total, examined) = (matter.combinations, searched.solved);
    Ok(Outcome {
        // What excluded the others were the leaders' own numbers, before rounding.
        certificate: Certificate {
            upper_bound: upper_bound.max(best.objective),
            ended: searched.ended,
        },
        combinations: Combinations { total, examined, nodes: searched.nodes },
        best,
        others,
    })
}

/// How many sets of `fingers` of `stretches` things there are, repetition allowed or not.
pub(crate) fn choose(stretches: usize, fingers: usize, repetition: bool) -> f64 {
    let most = if repetition { stretches + fingers - 1 } else { stretches };
    // Each product of consecutive numbers is divisible by the factorial.
    let exact = (0..fingers).try_fold(1_u128, |product, i| {
        product.checked_mul(most.saturating_sub(i) as u128).map(|next| next / (i as u128 + 1))
    });
    let rounded =
        || (0..fingers).fold(1.0, |product, i| product * (most - i) as f64 / (i + 1) as f64);
    exact.map_or_else(rounded, |count| count as f64)
}
