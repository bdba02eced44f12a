//! Matrices that change: a value with its rate, and the rules of products.

use std::ops::{Add, Mul, Sub};

use clench_screw::{Mat, Vector};

/// A matrix and its rate of change.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moving<const R: usize, const C: usize> {
    pub(crate) value: Mat<R, C>,
    pub(crate) rate: Mat<R, C>,
}

impl<const R: usize, const C: usize> Moving<R, C> {
    pub(crate) fn transpose(&self) -> Moving<C, R> {
        Moving { value: self.value.transpose(), rate: self.rate.transpose() }
    }
}

impl<const N: usize> Moving<N, N> {
    /// `I - n n^T` of a unit normal that turns at the rate `turning`, across itself.
    pub(crate) fn projector(normal: Vector<N>, turning: Vector<N>) -> Self {
        let across = Mat::outer(turning, normal);
        Self {
            value: Mat::IDENTITY - Mat::outer(normal, normal),
            rate: (across + across.transpose()) * -1.0,
        }
    }

    pub(crate) fn symmetric_part(&self) -> Self {
        Self { value: self.value.symmetric_part(), rate: self.rate.symmetric_part() }
    }

    /// The inverse in the tangent plane, of which `inverse` is the value and `plane` the projector:
    /// `W^+ = (W + Q)^-1 - Q` with `Q = n n^T`.
    pub(crate) fn inverse(&self, inverse: Mat<N, N>, plane: &Self) -> Self {
        let whole = inverse + (Mat::IDENTITY - plane.value);
        let rate = whole * (plane.rate - self.rate) * whole + plane.rate;
        Self { value: inverse, rate }
    }
}

impl<const R: usize, const C: usize> Add for Moving<R, C> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, rate: self.rate + other.rate }
    }
}

impl<const R: usize, const C: usize> Sub for Moving<R, C> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, rate: self.rate - other.rate }
    }
}

impl<const R: usize, const C: usize> Mul<f64> for Moving<R, C> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { value: self.value * factor, rate: self.rate * factor }
    }
}

impl<const R: usize, const K: usize, const C: usize> Mul<Moving<K, C>> for Moving<R, K> {
    type Output = Moving<R, C>;
    fn mul(self, other: Moving<K, C>) -> Moving<R, C> {
        Moving {
            value: self.value * other.value,
            rate: self.rate * other.value + self.value * other.rate,
        }
    }
}
