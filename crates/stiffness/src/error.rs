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
        /// The first contact whose share makes the sum infinite, from 0.
        contact: usize,
    },
    /// A dead load is not finite, or its torque exceeds the range of the numbers.
    #[error("load {load} is out of range: its point, force and torque have to be finite")]
    Load {
        /// The first such load, from 0.
        load: usize,
    },
    /// Contact forces and loads do not balance, but the answer needs that they do.
    #[error(
        "contact forces and loads do not balance: {force:.1e} of their total is left as a force, \
         {torque:.1e} of their total times their arms as a torque"
    )]
    Unbalanced {
        /// The residual force, relative to the total of the forces.
        force: f64,
        /// The residual torque about the centroid, relative to the forces times their arms.
        torque: f64,
    },
    /// A support is not finite, or has no normal.
    #[error("support {support} is out of range: its point has to be finite, and it needs a normal")]
    Support {
        /// The first such support, from 0.
        support: usize,
    },
    /// Contact forces that were to follow from equilibrium do not.
    #[error(
        "the forces of {contacts} contacts do not follow from balance, as only {rank} of them are \
         independent"
    )]
    Undetermined {
        /// How many contacts there are.
        contacts: usize,
        /// How many independent wrenches they have.
        rank: usize,
    },
    /// No contact forces balance the loads, not even pulling ones.
    #[error(
        "no forces of these contacts balance the rest: at best {force:.1e} of the total is left as \
         a force, {torque:.1e} of the total times its arms as a torque"
    )]
    Unresisted {
        /// The residual force, relative to the total of the forces.
        force: f64,
        /// The residual torque about the centroid, relative to the forces times their arms.
        torque: f64,
    },
    /// The linear program over the preloads could not be solved, though it is bounded.
    #[error(
        "whether the preloads of {contacts} contacts can balance was not decided: numerical trouble"
    )]
    Preloads {
        /// How many contacts there are.
        contacts: usize,
    },
    /// As many least forces as there are contacts are needed.
    #[error("found {found} least forces, expected one for each of {expected} contacts")]
    LeastForces {
        /// How many were given.
        found: usize,
        /// How many contacts there are.
        expected: usize,
    },
    /// A least force is negative or not finite.
    #[error("the least force of contact {contact} is {value}, but has to be finite, 0 or more")]
    LeastForce {
        /// The contact, from 0.
        contact: usize,
        /// What was found.
        value: f64,
    },
    /// The part of its preload that a contact keeps is negative, or 1 or more.
    #[error("the reserve is {value}, but has to be from 0 to below 1")]
    Reserve {
        /// What was found.
        value: f64,
    },
}
