//! A body held by contacts: its energy and its stiffness.

use clench_contact::{Contact, Order};
use clench_screw::{Frame, Stiffness, Vector, Wrench};

use crate::{DeadLoad, GraspError};

/// Contacts this close together, in units of rounding of their coordinates and per contact, are in
/// one place: their mean is a sum of rounded numbers.
const ONE_PLACE: f64 = 4.0 * f64::EPSILON;

/// A body held by at least one contact; the fingers stand still, the body moves. Dead loads such
/// as its weight may act on it besides.
///
/// Everything is written along the axes of the frame in which the contacts are given, about an
/// origin that the caller chooses.
#[derive(Clone, Debug, PartialEq)]
pub struct Grasp<const N: usize, const M: usize> {
    contacts: Vec<Contact<N, M>>,
    loads: Vec<DeadLoad<N>>,
    centroid: Vector<N>,
    length: f64,
}

impl<const N: usize, const M: usize> Grasp<N, M> {
    /// The grasp by `contacts`, in any order; several may coincide.
    ///
    /// # Errors
    ///
    /// [`GraspError::NoContacts`]; [`GraspError::OutOfRange`] when the stiffness about the
    /// contacts' centroid is not a finite number.
    pub fn new(contacts: Vec<Contact<N, M>>) -> Result<Self, GraspError> {
        let count = contacts.len();
        if count == 0 {
            return Err(GraspError::NoContacts);
        }
        let share = (count as f64).recip();
        let centroid =
            contacts.iter().fold(Vector::ZERO, |sum, c| sum + c.overlap().point() * share);
        let mut sum = Stiffness::ZERO;
        for (contact, c) in contacts.iter().enumerate() {
            sum += c.stiffness(centroid, Order::Second);
            if !sum.is_finite() {
                return Err(GraspError::OutOfRange { contact });
            }
        }
        let distance = |c: &Contact<N, M>| (c.overlap().point() - centroid).norm();
        let largest = contacts.iter().map(|c| c.overlap().point().max_abs()).fold(0.0, f64::max);
        let length = contacts.iter().map(distance).fold(0.0, f64::max);
        let length = if length > ONE_PLACE * count as f64 * largest { length } else { 0.0 };
        Ok(Self { contacts, loads: Vec::new(), centroid, length })
    }

    /// The same grasp with `loads` acting on the body.
    ///
    /// # Errors
    ///
    /// [`GraspError::Load`] when a load, or the sum of forces or torques about the centroid up to
    /// it, is not finite.
    pub fn with_loads(mut self, loads: Vec<DeadLoad<N>>) -> Result<Self, GraspError> {
        let mut sums = [0.0, 0.0];
        for (load, given) in loads.iter().enumerate() {
            let sizes = given.sizes(self.centroid);
            sums = [sums[0] + sizes[0], sums[1] + sizes[1]];
            let finite = given.point.is_finite() && given.force.is_finite();
            if !(finite && sums.iter().all(|sum| sum.is_finite())) {
                return Err(GraspError::Load { load });
            }
        }
        self.loads = loads;
        Ok(self)
    }

    /// The same grasp with only those contacts for which `keep` says so, by their numbers.
    ///
    /// # Errors
    ///
    /// [`GraspError::NoContacts`] when none is left.
    pub fn retain(&self, keep: impl Fn(usize) -> bool) -> Result<Self, GraspError> {
        let kept = self.contacts.iter().enumerate().filter(|&(i, _)| keep(i));
        let kept = kept.map(|(_, contact)| contact.clone()).collect();
        Self::new(kept)?.with_loads(self.loads.clone())
    }

    /// The contacts, in the order given.
    #[must_use]
    pub fn contacts(&self) -> &[Contact<N, M>] {
        &self.contacts
    }

    /// The dead loads, in the order given.
    #[must_use]
    pub fn loads(&self) -> &[DeadLoad<N>] {
        &self.loads
    }

    /// The mean of the contact points: a near origin to begin with.
    #[must_use]
    pub const fn centroid(&self) -> Vector<N> {
        self.centroid
    }

    /// The length that makes torques comparable to forces: the largest distance of a contact from
    /// the centroid (length); 0 if all are in one place.
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

    /// The stiffness about `origin` [LBR, eq. 6]: to first order `K_1`, to second order
    /// `K_1 + K_2`.
    ///
    /// Form it about an origin near the body: see [`Stiffness`]. To second order it is the Hessian
    /// of the energy, loads included, in the chart of the exponential map at `origin`, and changes
    /// frame by congruence only if contact forces and loads balance ([`Grasp::equilibrium`]).
    #[must_use]
    pub fn stiffness(&self, origin: Vector<N>, order: Order) -> Stiffness<N, M> {
        let contacts =
            self.contacts.iter().fold(Stiffness::ZERO, |sum, c| sum + c.stiffness(origin, order));
        match order {
            Order::First => contacts,
            Order::Second => contacts + self.load_stiffness(origin),
        }
    }

    /// `K_2` about `origin`: what preload, curvature and loads add to the first-order stiffness,
    /// `sum f D^2 delta` and the loads' share.
    #[must_use]
    pub fn preload_stiffness(&self, origin: Vector<N>) -> Stiffness<N, M> {
        let share = |c: &Contact<N, M>| c.overlap().hessian(origin) * c.preload();
        self.contacts.iter().fold(self.load_stiffness(origin), |sum, c| sum + share(c))
    }

    fn load_stiffness(&self, origin: Vector<N>) -> Stiffness<N, M> {
        self.loads.iter().fold(Stiffness::ZERO, |sum, load| sum + load.stiffness(origin))
    }

    /// The wrench on the body about `origin` of contact forces and loads: `-grad Pi`
    /// [LBR, eq. 5].
    #[must_use]
    pub fn net_wrench(&self, origin: Vector<N>) -> Wrench<N, M> {
        let contacts = self.contacts.iter().map(|c| c.unit_wrench(origin) * c.preload());
        let loads = self.loads.iter().map(|load| load.wrench(origin));
        contacts.chain(loads).fold(Wrench::ZERO, |sum, w| sum + w)
    }

    /// The energy after the body has moved [LBR, eq. 4]: what the contacts store, a finger that
    /// has come free nothing, and what the loads have gained.
    ///
    /// `displacement` is the body's frame seen from where it is at rest. For how far it may reach
    /// see [`Overlap::depth_after`](clench_contact::Overlap::depth_after).
    #[must_use]
    pub fn potential_energy(&self, displacement: &Frame<N, M>) -> f64 {
        let stored = |c: &Contact<N, M>| c.law().energy(c.overlap().depth_after(displacement));
        let contacts: f64 = self.contacts.iter().map(stored).sum();
        let loads: f64 = self.loads.iter().map(|load| load.energy_after(displacement)).sum();
        contacts + loads
    }
}
