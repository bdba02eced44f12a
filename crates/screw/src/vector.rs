//! A fixed-size column of numbers.

use std::ops::{Add, AddAssign, Index, IndexMut, Mul, Neg, Sub};

/// A column of `N` numbers; unit and frame are those of the quantity that it stands for.
///
/// ```
/// use clench_screw::Vector;
/// let a = Vector::new([3.0, 4.0]);
/// assert_eq!(a.norm(), 5.0);
/// assert_eq!((a * 2.0 - a).dot(a), 25.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector<const N: usize>([f64; N]);

impl<const N: usize> Vector<N> {
    /// The zero vector.
    pub const ZERO: Self = Self([0.0; N]);

    /// The vector with the given components.
    #[must_use]
    pub const fn new(components: [f64; N]) -> Self {
        Self(components)
    }

    /// The vector whose component `i` is `component(i)`.
    #[must_use]
    pub fn from_fn(component: impl FnMut(usize) -> f64) -> Self {
        Self(std::array::from_fn(component))
    }

    /// The components as a plain array.
    #[must_use]
    pub const fn to_array(self) -> [f64; N] {
        self.0
    }

    /// The inner product with `other`.
    #[must_use]
    pub fn dot(self, other: Self) -> f64 {
        (0..N).map(|i| self.0[i] * other.0[i]).sum()
    }

    /// The square of the Euclidean length.
    #[must_use]
    pub fn norm_squared(self) -> f64 {
        self.dot(self)
    }

    /// The Euclidean length.
    #[must_use]
    pub fn norm(self) -> f64 {
        self.norm_squared().sqrt()
    }

    /// The Euclidean length, where squares could leave the range of numbers: divided by the largest
    /// component first.
    #[must_use]
    pub fn scaled_norm(self) -> f64 {
        let size = self.max_abs();
        if !(size > 0.0 && self.is_finite()) {
            return self.norm();
        }
        Self::from_fn(|i| self.0[i] / size).norm() * size
    }

    /// The vector at unit length; `None` for one that is zero or not finite.
    ///
    /// Divided by its largest component first, so that no square leaves the range of numbers.
    #[must_use]
    pub fn direction(self) -> Option<Self> {
        let size = self.max_abs();
        if !(size > 0.0 && self.is_finite()) {
            return None;
        }
        let scaled = Self::from_fn(|i| self.0[i] / size);
        Some(scaled * scaled.norm().recip())
    }

    /// The same vector in space, of which the plane is the slice z = 0: two components are a
    /// direction or point of the plane, one is a rotation or torque, about z.
    ///
    /// ```
    /// use clench_screw::Vector;
    /// assert_eq!(Vector::new([1.0, 2.0]).in_space(), Vector::new([1.0, 2.0, 0.0]));
    /// assert_eq!(Vector::new([3.0]).in_space(), Vector::new([0.0, 0.0, 3.0]));
    /// ```
    #[must_use]
    pub fn in_space(self) -> Vector<3> {
        const { assert!(N >= 1 && N <= 3, "the plane or space") }
        let first = if N == 1 { 2 } else { 0 };
        Vector::from_fn(|i| if (first..first + N).contains(&i) { self.0[i - first] } else { 0.0 })
    }

    /// The largest magnitude of a component; 0 when `N` is 0.
    #[must_use]
    pub fn max_abs(self) -> f64 {
        self.0.iter().fold(0.0, |largest, x| largest.max(x.abs()))
    }

    /// Whether each component is a finite number.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.0.iter().all(|x| x.is_finite())
    }
}

impl<const N: usize> From<[f64; N]> for Vector<N> {
    fn from(components: [f64; N]) -> Self {
        Self(components)
    }
}

impl<const N: usize> Index<usize> for Vector<N> {
    type Output = f64;
    fn index(&self, i: usize) -> &f64 {
        &self.0[i]
    }
}

impl<const N: usize> IndexMut<usize> for Vector<N> {
    fn index_mut(&mut self, i: usize) -> &mut f64 {
        &mut self.0[i]
    }
}

impl<const N: usize> Add for Vector<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::from_fn(|i| self.0[i] + other.0[i])
    }
}

impl<const N: usize> AddAssign for Vector<N> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const N: usize> Sub for Vector<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::from_fn(|i| self.0[i] - other.0[i])
    }
}

impl<const N: usize> Neg for Vector<N> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::from_fn(|i| -self.0[i])
    }
}

impl<const N: usize> Mul<f64> for Vector<N> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self::from_fn(|i| self.0[i] * factor)
    }
}
