//! What can be wrong with preloads that are to balance the rest.

use clench::stiffness::GraspError;

use crate::wording::digits;

/// Why balanced preloads were refused.
#[derive(Debug, thiserror::Error)]
pub(crate) enum BalanceFault {
    /// They can press against one another.
    #[error(
        "{balanced} preloads are `balanced`, but these contacts have {rank} independent lines: \
         they can press against one another, and balance does not say how hard"
    )]
    Undetermined { balanced: usize, rank: usize },
    /// Fingers only push.
    #[error("the forces balance only if {}, but fingers push", in_words(pulling, unit))]
    Pulling { pulling: Vec<Pull>, unit: String },
    /// The forces do not balance at all, or are out of range.
    #[error(transparent)]
    Library(GraspError),
}

/// A contact that would have to pull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pull {
    pub(crate) contact: usize,
    pub(crate) force: f64,
}

impl BalanceFault {
    pub(super) fn help(&self) -> Option<String> {
        match self {
            Self::Undetermined { balanced, rank } => Some(format!(
                "give {} of them as numbers, such as what a clamp presses with",
                balanced - rank
            )),
            Self::Pulling { .. } => {
                Some("press the part on these contacts, or put them elsewhere".to_owned())
            }
            Self::Library(GraspError::Unresisted { .. }) => {
                Some("the part slides or turns on these contacts without one more".to_owned())
            }
            Self::Library(_) => None,
        }
    }
}

impl From<GraspError> for BalanceFault {
    fn from(error: GraspError) -> Self {
        match error {
            GraspError::Undetermined { contacts, rank } => {
                Self::Undetermined { balanced: contacts, rank }
            }
            other => Self::Library(other),
        }
    }
}

fn in_words(pulling: &[Pull], unit: &str) -> String {
    let each: Vec<String> = pulling
        .iter()
        .map(|Pull { contact, force }| {
            format!("contact {contact} pulls with {} {unit}", digits(*force))
        })
        .collect();
    each.join(" and ")
}
