//! What a displacement does to the contact forces.

use clench_contact::Contact;
use clench_screw::{Twist, Vector};

use crate::Grasp;

/// A change of overlap below this many units of rounding of what it is the difference of is none:
/// the displacement follows from a load by a few dozen products, and is multiplied once more.
const NO_CHANGE: f64 = 64.0 * f64::EPSILON;

/// The contact that a growing load takes off the part first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiftOff {
    /// The contact.
    pub contact: usize,
    /// How many times the load, from rest, until its force is used up; 0 for a contact without
    /// preload that the part moves away from.
    pub load_factor: f64,
}

impl<const N: usize, const M: usize> Grasp<N, M> {
    /// The change of each contact force by a small `displacement` of the body about `origin`
    /// (force): `f' grad(delta) . q`.
    ///
    /// Positive where the part is pressed on the finger. They balance that part of a load that the
    /// stiffness to first order takes up; preloads that turn with the contacts take the rest. What
    /// is nothing but rounding is 0.
    ///
    /// ```
    /// use clench_contact::{Contact, Geometry, Law};
    /// use clench_screw::Vector;
    /// use clench_stiffness::{Grasp, LiftOff};
    /// // A part between two pointed fingers at (-1, 0) and (1, 0), each with 10 and preload 2.
    /// let finger = |x: f64| {
    ///     let place = Geometry::on_face([x, 0.0].into(), [-x, 0.0].into(), 0.0);
    ///     Contact::<2, 1>::new(place, Law::linear(10.0)?, 2.0)
    /// };
    /// let grasp = Grasp::new(vec![finger(-1.0)?, finger(1.0)?])?;
    /// let right = clench_screw::Twist { linear: [0.05, 0.0].into(), angular: [0.0].into() };
    /// let changes = grasp.force_changes(Vector::ZERO, &right);
    /// assert_eq!(changes, [-0.5, 0.5]);
    /// // Four times as far, the left finger has lost its preload.
    /// let first = grasp.first_to_lift_off(&changes);
    /// assert_eq!(first, Some(LiftOff { contact: 0, load_factor: 4.0 }));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn force_changes(&self, origin: Vector<N>, displacement: &Twist<N, M>) -> Vec<f64> {
        let [shift, turn] = [displacement.linear.norm(), displacement.angular.norm()];
        let change = |contact: &Contact<N, M>| {
            let overlap = contact.overlap();
            let deeper = displacement.power(&overlap.gradient(origin));
            let terms = shift + turn * (overlap.point() - origin).norm();
            if deeper.abs() <= NO_CHANGE * terms { 0.0 } else { contact.slope() * deeper }
        };
        self.contacts().iter().map(change).collect()
    }

    /// The contact that lifts off first when the load grows that causes these
    /// [`force_changes`](Self::force_changes); the one with the lowest number of several. `None` if
    /// no contact loses force.
    ///
    /// As far as forces change in proportion to the load. A law that stiffens with the force, such
    /// as Hertz', holds on to larger loads; one that softens, a power below 1, lets go earlier.
    #[must_use]
    pub fn first_to_lift_off(&self, changes: &[f64]) -> Option<LiftOff> {
        let contacts = self.contacts().iter().zip(changes).enumerate();
        let losing = contacts.filter(|(_, (_, change))| **change < 0.0);
        let factors = losing.map(|(contact, (held, change))| LiftOff {
            contact,
            load_factor: held.preload() / -change,
        });
        factors.min_by(|a, b| a.load_factor.total_cmp(&b.load_factor))
    }
}
