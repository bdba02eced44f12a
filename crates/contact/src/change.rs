//! How a contact's share of the stiffness changes with its place, its law and its preload.

use clench_screw::{Mat, Stiffness, Vector, Wrench, lever};

use crate::curvature::Radii;
use crate::moving::Moving;
use crate::tangent::Tangent;
use crate::{Contact, ContactError, Order};

/// What changes at a contact; all else about it stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change<const N: usize> {
    /// The finger moves along the boundary of the part, per unit by `along` (length).
    ///
    /// The normal turns as the part is curved, and the finger with it: a finger that is curved
    /// differently in each direction keeps the directions that it was given by. Law and preload
    /// stay, also those of Hertz' law, which belong to the curvatures where the finger is.
    Place {
        /// The velocity of the point; what of it is along the normal does not count.
        along: Vector<N>,
        /// How the part's shape operator changes on the way (1 / length^2 for an `along` of unit
        /// length): zero on a flat or round boundary, which turns with the normal alone.
        curvature_rate: Mat<N, N>,
    },
    /// All forces of the law grow in proportion, per unit to twice as much; the preload stays, so
    /// that the overlap shrinks. A linear law's slope grows as much, that of `f = c delta^p` as
    /// `c^(1/p)`.
    Stiffness,
    /// The preload grows, per unit of force, and the overlap with it.
    Preload,
}

impl<const N: usize> Change<N> {
    /// A finger that moves along a flat or round boundary, per unit by `along` (length).
    #[must_use]
    pub const fn along(along: Vector<N>) -> Self {
        Self::Place { along, curvature_rate: Mat::ZERO }
    }
}

/// The rates of all that a share of the stiffness is made of.
struct Rates<const N: usize> {
    point: Vector<N>,
    normal: Vector<N>,
    curvature: Mat<N, N>,
    depth: f64,
    slope: f64,
    preload: f64,
}

impl<const N: usize, const M: usize> Contact<N, M> {
    /// The derivative of [`Self::stiffness`] about `origin` by a `change`.
    ///
    /// `f'` and `f` are the slope and the force of the law, `g` and `H` gradient and Hessian of
    /// the overlap: `(f' g g^T + f H)' = (f')' g g^T + f' (g' g^T + g g'^T) + (f)' H + f H'`. The
    /// other contacts stay, and so do all preloads, which after a change need not balance: to
    /// second order the derivative of a grasp's stiffness belongs to the origin then.
    ///
    /// ```
    /// use clench_contact::{Change, Contact, Geometry, Law, Order};
    /// use clench_screw::Vector;
    /// // On an edge along x, at (2, 0): the lever arm x enters as 10 x^2.
    /// let place = Geometry::on_face(Vector::new([2.0, 0.0]), Vector::new([0.0, 1.0]), 0.0);
    /// let contact = Contact::<2, 1>::new(place, Law::linear(10.0)?, 0.0)?;
    /// let change = Change::along(Vector::new([1.0, 0.0]));
    /// let rate = contact.stiffness_rate(&change, Vector::ZERO, Order::First)?;
    /// assert_eq!((rate.rotational[0][0], rate.translational[1][1]), (2.0 * 10.0 * 2.0, 0.0));
    /// # Ok::<(), clench_contact::ContactError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ContactError::NoTangent`] for a finger on a pointed part, which has no boundary to move
    /// along; [`ContactError::NotFinite`] when a component of `along` is not a finite number.
    pub fn stiffness_rate(
        &self,
        change: &Change<N>,
        origin: Vector<N>,
        order: Order,
    ) -> Result<Stiffness<N, M>, ContactError> {
        let rates = self.rates(change)?;
        let gradient = self.overlap().gradient(origin);
        let turning = self.gradient_rate(&rates, origin);
        // a b^T + b a^T from squares, of which there is a rule already.
        let both = Stiffness::outer(&(gradient + turning));
        let apart = Stiffness::outer(&(gradient - turning));
        let mixed = (both + apart * -1.0) * 0.5;
        let first = Stiffness::outer(&gradient) * rates.slope + mixed * self.slope();
        if matches!(order, Order::First) {
            return Ok(first);
        }
        let hessian = self.overlap().hessian(origin) * rates.preload;
        Ok(first + hessian + self.hessian_rate(&rates, origin)? * self.preload())
    }

    fn rates(&self, change: &Change<N>) -> Result<Rates<N>, ContactError> {
        let still = Rates {
            point: Vector::ZERO,
            normal: Vector::ZERO,
            curvature: Mat::ZERO,
            depth: 0.0,
            slope: 0.0,
            preload: 0.0,
        };
        let (force, slope) = (self.preload(), self.slope());
        // Where there is no force, only laws of constant slope have a stiffness.
        let bend = if force > 0.0 { self.law().slope_rate(force) } else { 0.0 };
        Ok(match *change {
            Change::Place { along, curvature_rate } => {
                let (point, normal) = self.moved_along(along)?;
                Rates { point, normal, curvature: curvature_rate, ..still }
            }
            Change::Stiffness => {
                Rates { depth: -force / slope, slope: slope - force * bend, ..still }
            }
            Change::Preload => Rates { depth: slope.recip(), slope: bend, preload: 1.0, ..still },
        })
    }

    /// The velocity of the point in the tangent plane, and how the normal turns: `-L_B` of it.
    fn moved_along(&self, along: Vector<N>) -> Result<(Vector<N>, Vector<N>), ContactError> {
        if let Some(axis) = (0..N).find(|&axis| !along[axis].is_finite()) {
            let value = along[axis];
            return Err(ContactError::NotFinite { parameter: "move", axis, value });
        }
        let geometry = self.overlap().geometry();
        let tangent = Tangent::of(geometry.inward_normal);
        let part = Radii::new("part", &geometry.part, &tangent)?;
        if part.x <= 0.0 {
            return Err(ContactError::NoTangent);
        }
        let point = tangent.projector() * along;
        Ok((point, part.y * point * -part.x.recip()))
    }

    /// `-(n', b x n' + b' x n)`.
    fn gradient_rate(&self, rates: &Rates<N>, origin: Vector<N>) -> Wrench<N, M> {
        let turned = Wrench::of_force_at(-rates.normal, self.overlap().point() - origin);
        let moved = Wrench::of_force_at(-self.overlap().inward_normal(), rates.point);
        Wrench { force: turned.force, torque: turned.torque + moved.torque }
    }

    /// The rate of the overlap's Hessian: what [`crate::Overlap`] forms, by the product rule.
    fn hessian_rate(
        &self,
        rates: &Rates<N>,
        origin: Vector<N>,
    ) -> Result<Stiffness<N, M>, ContactError> {
        let overlap = self.overlap();
        let (geometry, n) = (overlap.geometry(), overlap.inward_normal());
        let tangent = Tangent::of(n);
        let [a, b] = geometry.radii(&tangent)?;
        let plane = Moving::projector(n, rates.normal);
        let finger = Moving { value: a.y, rate: geometry.finger.rate(&a, &plane, n, &Mat::ZERO) };
        let rate = geometry.part.rate(&b, &plane, n, &rates.curvature);
        let part = Moving { value: b.y, rate };
        let depth =
            Moving { value: Mat::IDENTITY * overlap.depth(), rate: Mat::IDENTITY * rates.depth };
        let x = plane * a.x - finger * depth;
        let whole = finger * b.x + part * x;
        let inverse = whole.inverse(tangent.inverse(&whole.value), &plane);
        let normal = Moving { value: lever::<N, M>(n), rate: lever(rates.normal) };
        let arm =
            Moving { value: lever::<N, M>(overlap.point() - origin), rate: lever(rates.point) };
        let slide = finger * inverse * part;
        let roll = finger * inverse * normal * b.x;
        let tilt = (normal.transpose() * (x * inverse * normal)).symmetric_part() * b.x;
        let sliding = slide * arm;
        let half = roll + (sliding - normal) * 0.5;
        Ok(Stiffness {
            translational: slide.rate * -1.0,
            coupling: (sliding + roll).rate,
            rotational: (tilt - (arm.transpose() * half).symmetric_part() * 2.0).rate,
        })
    }
}
