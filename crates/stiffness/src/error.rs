//! What can be wrong with a grasp.

/// Why a grasp was refused, or a question about it has no answer.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GraspError {
    /// There is nothing that holds the body.
    #[error("a grasp needs at least one contact, found none")]
    NoContacts,
    /// The stiffness exceeds the range of the numbers.
    #[error(
        "contact {contact} is out of range: its stiffness overflows; \
         choose units in which lengths and forces are nearer to 1"
    )]
    OutOfRange {
        /// The first contact whose share is not finite, from 0.
        contact: usize,
    },
    /// The linear program over the preloads could not be solved, though it is bounded.
    #[error(
        "whether the preloads of {contacts} contacts can balance was not decided: numerical trouble"
    )]
    Preloads {
        /// How many contacts there are.
        contacts: usize,
    },
}
