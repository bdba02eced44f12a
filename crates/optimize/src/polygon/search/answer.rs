//! From a search to its outcome.

use super::branch::Searched;
use super::leaders::Candidate;
use crate::polygon::scene::Scene;
use crate::{Certificate, Combinations, Ended, OptimizeError, Outcome, Solution};

/// Where all normals are parallel up to this, `sigma_min`, of the order of its square, is lost in
/// the rounding of the stiffnesses.
const THIN: f64 = 1e-6;

/// What a search was about, beside its problem.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Matter {
    pub(crate) fingers: usize,
    /// How many combinations of stretches there are.
    pub(crate) combinations: f64,
    /// Whether placements had to fulfill conditions beside holding the part.
    pub(crate) conditions: bool,
}

/// The outcome, with `confirm` turning leaders into solutions.
///
/// # Errors
///
/// Why nothing was found; the errors of `confirm` for the best.
pub(crate) fn outcome<const K: usize, P>(
    scene: &Scene,
    matter: Matter,
    searched: &Searched<K, P>,
    confirm: impl Fn(&Candidate<K, P>) -> Result<Solution, OptimizeError>,
) -> Result<Outcome, OptimizeError> {
    let upper_bound = searched.upper_bound * scene.stiffness_unit;
    let Some((first, rest)) = searched.leaders.candidates().split_first() else {
        return Err(nothing(scene, matter, searched.ended, upper_bound));
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

fn nothing(scene: &Scene, matter: Matter, ended: Ended, upper_bound: f64) -> OptimizeError {
    let Matter { fingers, combinations, conditions } = matter;
    if ended != Ended::Proved {
        return OptimizeError::NothingFound { fingers, ended, upper_bound };
    }
    let sine = scene.largest_sine();
    if sine > 0.0 && sine <= THIN {
        OptimizeError::TooThin { fingers, sine }
    } else if conditions {
        OptimizeError::ConditionsNeverMet { fingers, combinations }
    } else if !scene.normals_balance(fingers) {
        OptimizeError::NormalsNeverBalance { fingers, combinations }
    } else {
        OptimizeError::TorquesNeverBalance { fingers, combinations }
    }
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
