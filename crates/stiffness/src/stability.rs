//! Stability to first and second order.

use clench_contact::Order;
use clench_screw::Stiffness;
use faer::{Mat, Side};

use crate::Grasp;

/// Eigenvalues of the scaled stiffness below this many units of rounding of the largest, per
/// contact and row, count as zero.
///
/// Each entry sums one product per contact, and the eigenvalues of a symmetric matrix move by no
/// more than the norm of its error; 8 leaves room for the normals and lever arms, which are
/// rounded too.
const ZERO_EIGENVALUE: f64 = 8.0 * f64::EPSILON;

/// How a grasp returns after a small disturbance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// Stable, and the first-order terms alone would be too: springs at the contacts resist every
    /// motion.
    FirstOrder,
    /// Stable, but not by the first-order terms alone: it takes the preload.
    SecondOrder,
    /// Some displacement costs no energy to second order.
    Marginal,
    /// Some displacement releases energy.
    Unstable,
}

#[derive(Clone, Copy, PartialEq)]
enum Sign {
    Positive,
    Zero,
    Negative,
}

impl<const N: usize, const M: usize> Grasp<N, M> {
    /// The class of the grasp [LBR, section 2]: the signs of the eigenvalues of its stiffness,
    /// about the centroid and with torques divided by the grasp's length.
    ///
    /// The signs do not depend on units, and if contact forces and loads balance not on the frame;
    /// the eigenvalues do. Out of balance nothing is at rest and the class means little: see
    /// [`Grasp::equilibrium`]. A preload can always be so large that the class changes. That the
    /// fingers can only push is not looked at: see [`Grasp::preloads`].
    #[must_use]
    pub fn stability(&self) -> Stability {
        match (self.class(Order::Second), self.class(Order::First)) {
            (Sign::Positive, Sign::Positive) => Stability::FirstOrder,
            (Sign::Positive, _) => Stability::SecondOrder,
            (Sign::Zero, _) => Stability::Marginal,
            (Sign::Negative, _) => Stability::Unstable,
        }
    }

    /// The class that springs in place of the contacts would have: by the sign of `K_1` alone,
    /// which is never negative.
    #[must_use]
    pub fn first_order_stability(&self) -> Stability {
        match self.class(Order::First) {
            Sign::Positive => Stability::FirstOrder,
            Sign::Zero | Sign::Negative => Stability::Marginal,
        }
    }

    fn class(&self, order: Order) -> Sign {
        self.smallest_sign(&self.stiffness(self.centroid(), order))
    }

    fn smallest_sign(&self, stiffness: &Stiffness<N, M>) -> Sign {
        let length = self.torque_length();
        let unit = |i: usize| if i < N { 1.0 } else { length };
        let size = N + M;
        let entry = |i: usize, j: usize| stiffness.entry(i, j) / unit(i) / unit(j);
        let entries = (0..size).flat_map(|i| (0..size).map(move |j| (i, j)));
        let size_of_entries = entries.fold(0.0, |m: f64, (i, j)| m.max(entry(i, j).abs()));
        if size_of_entries <= 0.0 {
            return Sign::Zero;
        }
        // About 1, so that the iteration has all its digits for any stiffness.
        let scaled = Mat::from_fn(size, size, |i, j| entry(i, j) / size_of_entries);
        #[expect(clippy::expect_used, reason = "the entries are numbers of magnitude up to 1")]
        let values = scaled
            .self_adjoint_eigenvalues(Side::Lower)
            .expect("the eigenvalues of a finite symmetric matrix converge");
        let largest = values.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let zero = ZERO_EIGENVALUE * (self.contacts().len() * size) as f64 * largest;
        match values.iter().copied().fold(f64::INFINITY, f64::min) {
            smallest if smallest > zero => Sign::Positive,
            smallest if smallest >= -zero => Sign::Zero,
            _ => Sign::Negative,
        }
    }
}
