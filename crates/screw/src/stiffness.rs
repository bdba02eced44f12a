//! A symmetric form on twists, kept in blocks.

use std::ops::{Add, AddAssign, Mul};

use crate::{Frame, Mat, Twist, Wrench};

/// A symmetric form on twists, `[[K_11, K_12], [K_12^T, K_22]]` [LBR, eq. 8].
///
/// As the stiffness of a grasp it maps a small displacement to the external wrench that holds the
/// body there. Divided by a force it is the Hessian of an overlap. It is written about a frame's
/// origin and along its axes.
///
/// A stiffness that is formed `d` body lengths away from the body loses about `d^2` units of
/// rounding, and no change of frame brings them back: form it near the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffness<const N: usize, const M: usize> {
    /// `K_11`: force per displacement (force / length), symmetric.
    pub translational: Mat<N, N>,
    /// `K_12`: force per rotation (force).
    pub coupling: Mat<N, M>,
    /// `K_22`: torque per rotation (force * length), symmetric.
    pub rotational: Mat<M, M>,
}

impl<const N: usize, const M: usize> Stiffness<N, M> {
    /// No stiffness.
    pub const ZERO: Self =
        Self { translational: Mat::ZERO, coupling: Mat::ZERO, rotational: Mat::ZERO };

    /// The stiffness whose full `(N + M)` x `(N + M)` matrix has the entry `entry(i, j)` in row `i`
    /// and column `j`: translations first, then rotations.
    ///
    /// The matrix is symmetric: the lower left block is not asked for, and what asymmetry the
    /// blocks on the diagonal have, metrics leave out.
    ///
    /// ```
    /// use clench_screw::planar::Stiffness;
    /// let rows = [[1.7, 0.1, -8.8], [0.1, 2.3, 13.6], [-8.8, 13.6, 218.8]];
    /// let stiffness = Stiffness::from_fn(|i, j| rows[i][j]);
    /// assert_eq!((stiffness.coupling[1][0], stiffness.entry(2, 1)), (13.6, 13.6));
    /// ```
    #[must_use]
    pub fn from_fn(entry: impl Fn(usize, usize) -> f64) -> Self {
        Self {
            translational: Mat::from_fn(&entry),
            coupling: Mat::from_fn(|i, j| entry(i, N + j)),
            rotational: Mat::from_fn(|i, j| entry(N + i, N + j)),
        }
    }

    /// `w w^T`: the stiffness of one unit spring that pushes with the wrench `w`.
    #[must_use]
    pub fn outer(w: &Wrench<N, M>) -> Self {
        Self {
            translational: Mat::outer(w.force, w.force),
            coupling: Mat::outer(w.force, w.torque),
            rotational: Mat::outer(w.torque, w.torque),
        }
    }

    /// The wrench `K q`.
    #[must_use]
    pub fn apply(&self, q: &Twist<N, M>) -> Wrench<N, M> {
        Wrench {
            force: self.translational * q.linear + self.coupling * q.angular,
            torque: self.coupling.transpose() * q.linear + self.rotational * q.angular,
        }
    }

    /// `q^T K q`, twice the elastic energy of the displacement `q`.
    #[must_use]
    pub fn quadratic(&self, q: &Twist<N, M>) -> f64 {
        q.power(&self.apply(q))
    }

    /// The same stiffness, given in the parent of `frame`, written in `frame`: `T^T K T`
    /// [LBR, eq. 7].
    ///
    /// Holds for the Hessian of an energy only where its gradient is zero (equilibrium).
    #[must_use]
    pub fn in_frame(&self, frame: &Frame<N, M>) -> Self {
        let (a, s, l) = (frame.axes(), frame.spin(), frame.lever());
        // First the new origin along the old axes, then the axes.
        let coupling = self.coupling + self.translational * l;
        let half = l.transpose() * self.coupling;
        let rotational =
            self.rotational + half + half.transpose() + l.transpose() * (self.translational * l);
        Self {
            translational: a.transpose() * self.translational * *a,
            coupling: a.transpose() * coupling * *s,
            rotational: s.transpose() * rotational * *s,
        }
    }

    /// The same stiffness, given in `frame`, written in the parent of `frame`.
    #[must_use]
    pub fn to_parent(&self, frame: &Frame<N, M>) -> Self {
        self.in_frame(&frame.inverse())
    }

    /// Entry `(i, j)` of the full `(N + M)` x `(N + M)` matrix.
    ///
    /// # Panics
    ///
    /// When `i` or `j` is not below `N + M`.
    #[must_use]
    pub fn entry(&self, i: usize, j: usize) -> f64 {
        match (i < N, j < N) {
            (true, true) => self.translational[i][j],
            (true, false) => self.coupling[i][j - N],
            (false, true) => self.coupling[j][i - N],
            (false, false) => self.rotational[i - N][j - N],
        }
    }

    /// Whether each entry is a finite number.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.translational.is_finite() && self.coupling.is_finite() && self.rotational.is_finite()
    }
}

impl<const N: usize, const M: usize> Add for Stiffness<N, M> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            translational: self.translational + other.translational,
            coupling: self.coupling + other.coupling,
            rotational: self.rotational + other.rotational,
        }
    }
}

impl<const N: usize, const M: usize> AddAssign for Stiffness<N, M> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const N: usize, const M: usize> Mul<f64> for Stiffness<N, M> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self {
            translational: self.translational * factor,
            coupling: self.coupling * factor,
            rotational: self.rotational * factor,
        }
    }
}
