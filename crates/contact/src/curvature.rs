//! How the boundary of a body is curved where it touches.

use clench_screw::{Mat, Vector};

use crate::ContactError;
use crate::moving::Moving;
use crate::tangent::Tangent;

/// A principal direction within this angle of the normal (rad) leaves fewer than half of its digits
/// in the tangent plane.
const ALONG_NORMAL: f64 = 1.490_116_119_384_765_6e-8;

/// The boundary of a finger or a part at the contact, to second order.
///
/// Radii and curvatures are positive for convex bodies, negative for hollow ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curvature<const N: usize>(Form<N>);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Form<const N: usize> {
    Round(f64),
    Principal { curvatures: [f64; 2], along: Vector<N> },
    Tensor(Mat<N, N>),
}

impl<const N: usize> Curvature<N> {
    /// A plane face, or a straight edge.
    pub const FLAT: Self = Self(Form::Round(f64::INFINITY));

    /// A tip without extent: the point of a needle, or the corner of a part.
    pub const POINTED: Self = Self(Form::Round(0.0));

    /// A sphere or a disc of radius `radius` (length); 0 is pointed, infinity flat, and negative
    /// the inside of a bore.
    #[must_use]
    pub const fn round(radius: f64) -> Self {
        Self(Form::Round(radius))
    }

    /// The symmetric shape operator `L` (1 / length) along the axes of the frame; what it does
    /// along the normal does not count.
    #[must_use]
    pub const fn of_shape_operator(operator: Mat<N, N>) -> Self {
        Self(Form::Tensor(operator))
    }

    /// The radius of a round, pointed (0) or flat (infinite) boundary (length).
    #[must_use]
    pub const fn radius(&self) -> Option<f64> {
        match self.0 {
            Form::Round(radius) => Some(radius),
            _ => None,
        }
    }
}

impl<const N: usize> Curvature<N> {
    /// The rate of `y` of these `radii`, as the normal turns and `plane` with it, and the shape
    /// operator changes at the rate `operator` besides.
    pub(crate) fn rate(
        &self,
        radii: &Radii<N>,
        plane: &Moving<N, N>,
        normal: Vector<N>,
        operator: &Mat<N, N>,
    ) -> Mat<N, N> {
        let turned = match self.0 {
            Form::Round(_) if radii.y.max_abs() <= 0.0 => Mat::ZERO,
            Form::Round(r) => plane.rate * 1.0_f64.copysign(r + 0.0),
            Form::Principal { curvatures: [first, second], along } => {
                // f = P a / |P a|; for an `along` of any size.
                let along = along.direction().unwrap_or(normal);
                let across = plane.value * along;
                let size = across.norm().recip();
                let f = across * size;
                let moved = plane.rate * along * size;
                let turning = Mat::outer(moved - f * f.dot(moved), f);
                plane.rate * second + (turning + turning.transpose()) * (first - second)
            }
            Form::Tensor(tensor) => {
                let half = plane.rate * tensor.symmetric_part() * plane.value;
                half + half.transpose()
            }
        };
        turned + plane.value * operator.symmetric_part() * plane.value * radii.x
    }
}

impl Curvature<3> {
    /// The principal curvatures (1 / length): the first in the direction `along` as seen in the
    /// tangent plane, the second across it. A curvature of 0 is a straight line: `[k, 0]` is a
    /// cylinder of radius `1 / k` whose axis is across `along`.
    #[must_use]
    pub const fn principal_curvatures(curvatures: [f64; 2], along: Vector<3>) -> Self {
        Self(Form::Principal { curvatures, along })
    }

    /// The same by the principal radii (length), which may be infinite.
    #[must_use]
    pub const fn principal_radii([first, second]: [f64; 2], along: Vector<3>) -> Self {
        Self::principal_curvatures([first.recip(), second.recip()], along)
    }
}

/// The radii of curvature `S = x Y^-1` as a pair without infinities: `x >= 0` a number, `Y`
/// symmetric in the tangent plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Radii<const N: usize> {
    pub(crate) x: f64,
    pub(crate) y: Mat<N, N>,
}

impl<const N: usize> Radii<N> {
    /// The radii of `body` (named for errors) at a contact with the given tangent plane.
    pub(crate) fn new(
        body: &'static str,
        curvature: &Curvature<N>,
        tangent: &Tangent<N>,
    ) -> Result<Self, ContactError> {
        let plane = tangent.projector();
        match curvature.0 {
            Form::Round(r) if r.is_nan() || r == f64::NEG_INFINITY => {
                Err(ContactError::RadiusNotANumber { body, value: r })
            }
            Form::Round(r) if r.is_infinite() => Ok(Self { x: 1.0, y: Mat::ZERO }),
            Form::Round(r) => Ok(Self { x: r.abs(), y: plane * 1.0_f64.copysign(r + 0.0) }),
            Form::Principal { curvatures, along } => {
                if let Some(value) = curvatures.into_iter().find(|k| !k.is_finite()) {
                    return Err(ContactError::PrincipalCurvature { body, value });
                }
                // Projected twice: the first time leaves the rounding of what it takes away.
                let first = along
                    .direction()
                    .map(|along| plane * along)
                    .filter(|across| across.norm() > ALONG_NORMAL)
                    .and_then(|across| (plane * across).direction())
                    .ok_or(ContactError::NoPrincipalDirection { body })?;
                let first = Mat::outer(first, first);
                Ok(Self { x: 1.0, y: first * curvatures[0] + (plane - first) * curvatures[1] })
            }
            Form::Tensor(operator) if operator.is_finite() => {
                Ok(Self { x: 1.0, y: plane * operator.symmetric_part() * plane })
            }
            Form::Tensor(_) => Err(ContactError::ShapeOperator { body }),
        }
    }
}
