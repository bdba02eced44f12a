//! A body held by contacts: its energy and its stiffness.

use clench_contact::{Contact, Order};
use clench_screw::{Frame, Stiffness, Vector, Wrench};

use crate::GraspError;

/// A body held by at least one contact; the fingers stand still, the body moves.
///
/// Everything is written along the axes of the frame in which the contacts are given, about an
/// origin that the caller chooses.
#[derive(Clone, Debug, PartialEq)]
pub struct Grasp<const N: usize, const M: usize> {
    contacts: Vec<Contact<N, M>>,
    centroid: Vector<N>,
    length: f64,
}

impl<const N: usize, const M: usize> Grasp<N, M> {
    /// The grasp by `contacts`, in any order; several may coincide.
    ///
    /// # Errors
    ///
    /// [`GraspError::NoContacts`]; [`GraspError::OutOfRange`] when a contact's stiffness about the
    /// contacts' centroid is not a finite number.
    pub fn new(contacts: Vec<Contact<N, M>>) -> Result<Self, GraspError> {
        let count = contacts.len();
        if count == 0 {
            return Err(GraspError::NoContacts);
        }
        let share = (count as f64).recip();
        let centroid =
            contacts.iter().fold(Vector::ZERO, |sum, c| sum + c.overlap().point() * share);
        let finite = |c: &Contact<N, M>| c.stiffness(centroid, Order::Second).is_finite();
        if let Some(contact) = contacts.iter().position(|c| !finite(c)) {
            return Err(GraspError::OutOfRange { contact });
        }
        let distance = |c: &Contact<N, M>| (c.overlap().point() - centroid).norm();
        let length = contacts.iter().map(distance).fold(0.0, f64::max);
        Ok(Self { contacts, centroid, length })
    }

    /// The contacts, in the order given.
    #[must_use]
    pub fn contacts(&self) -> &[Contact<N, M>] {
        &self.contacts
    }

    /// The mean of the contact points: a near origin to begin with.
    #[must_use]
    pub const fn centroid(&self) -> Vector<N> {
        self.centroid
    }

    /// The length that makes torques comparable to forces: the largest distance of a contact from
    /// the centroid (length).
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// [`Self::length`], or 1 when it is 0: contacts that all coincide, of pointed fingers, have no
    /// torque to scale.
    pub(crate) fn torque_length(&self) -> f64 {
        if self.length > 0.0 { self.length } else { 1.0 }
    }

    /// The sum of the contact forces, `f_T`.
    #[must_use]
    pub fn total_preload(&self) -> f64 {
        self.contacts.iter().map(Contact::preload).sum()
    }

    /// The stiffness about `origin` [LBR, eq. 6].
    ///
    /// Form it about an origin near the body: see [`Stiffness`]. To second order it is the Hessian
    /// of the energy in the chart of the exponential map at `origin`, and changes frame by
    /// congruence only if the contact forces balance ([`Grasp::equilibrium`]).
    #[must_use]
    pub fn stiffness(&self, origin: Vector<N>, order: Order) -> Stiffness<N, M> {
        self.contacts.iter().fold(Stiffness::ZERO, |sum, c| sum + c.stiffness(origin, order))
    }

    /// The wrench of the contact forces on the body about `origin`: `-grad Pi` [LBR, eq. 5].
    #[must_use]
    pub fn net_wrench(&self, origin: Vector<N>) -> Wrench<N, M> {
        self.contacts.iter().fold(Wrench::ZERO, |sum, c| sum + c.unit_wrench(origin) * c.preload())
    }

    /// The elastic energy after the body has moved [LBR, eq. 4]; a finger that has come free
    /// stores none.
    ///
    /// `displacement` is the body's frame seen from where it is at rest, and may be finite as long
    /// as each finger stays on its face.
    #[must_use]
    pub fn potential_energy(&self, displacement: &Frame<N, M>) -> f64 {
        let energy =
            |c: &Contact<N, M>| c.law().energy(c.overlap().depth_after(displacement).max(0.0));
        self.contacts.iter().map(energy).sum()
    }
}
