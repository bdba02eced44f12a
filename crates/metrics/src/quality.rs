//! The quality measure of LBR section 4.

use clench_shape::Extent;

use crate::{EquivalentStiffness, MetricsError, Principal};

/// Principal stiffnesses whose gap is at most this part of the largest count as one, repeated, and
/// so does a chain of such gaps.
///
/// Their directions are good to the rounding of the stiffness divided by the gap: at this gap to
/// seven digits in a stiffness formed near the body, and to three in one that is given in a frame a
/// hundred body lengths away.
pub const REPEATED: f64 = 1e-9;

/// Which stiffness is the smallest, rotations made comparable by the body's deflection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitedBy {
    /// `sigma_min`.
    Translation,
    /// The least `mu_eq`.
    Rotation,
}

/// The frame-invariant quality of a grasp [LBR, eqs. 13 to 16].
///
/// [LBR, eq. 16] takes the directions of the principal rotations, which are not determined where
/// stiffnesses repeat, as in each cube held alike from all sides. The least equivalent stiffness
/// of all rotations among the repeated ones is taken instead, which no frame alters. Even so Q
/// jumps where two stiffnesses come to be equal; [`EquivalentStiffness::least`] (`Q_V`) and
/// [`crate::WorstPoint`] (`Q_pt`) do not.
///
/// `min(sigma_min, Q_V) / 2 <= Q_pt <= min(sigma_min, Q_V) <= Q`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality<const N: usize, const M: usize> {
    /// `Q = min(sigma_min, mu_eq)` (force / length): the worst characteristic stiffness.
    pub value: f64,
    /// Which of them it is.
    pub limited_by: LimitedBy,
    /// `sigma_min`, the smallest principal translational stiffness (force / length).
    pub translational: f64,
    /// `mu_eq` of each principal rotation, in their order; those of repeated ones are the same.
    pub rotations: [EquivalentStiffness<N, M>; M],
    /// Whether some principal rotational stiffness is repeated, so that [LBR, eq. 16] could give
    /// other values.
    pub degenerate: bool,
}

impl<const N: usize, const M: usize> Quality<N, M> {
    /// The quality of a grasp of `body`, both given in one frame.
    ///
    /// ```
    /// use clench_metrics::{LimitedBy, Principal, Quality};
    /// use clench_screw::{Mat, Vector, spatial::Stiffness};
    /// use clench_shape::ExtremePoints;
    /// // A cube of side 2, held at its center: 3 against translations, 4 against rotations.
    /// let corner = |i: i32| [0, 1, 2].map(|axis| f64::from(i >> axis & 1) * 2.0 - 1.0);
    /// let cube = ExtremePoints::new(&[0, 1, 2, 3, 4, 5, 6, 7].map(corner))?;
    /// let stiffness = Stiffness {
    ///     translational: Mat::IDENTITY * 3.0,
    ///     coupling: Mat::ZERO,
    ///     rotational: Mat::IDENTITY * 4.0,
    /// };
    /// let principal = Principal::of(Vector::ZERO, &stiffness)?;
    /// let quality = Quality::of(&principal, &cube)?;
    /// // Any axis is principal. About a diagonal of a face corners are at the distance sqrt(3).
    /// assert!(quality.degenerate);
    /// assert_eq!(quality.limited_by, LimitedBy::Rotation);
    /// assert!((quality.value - 4.0 / 3.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`MetricsError::OutOfRange`] when sizes are so unlike that numbers overflow.
    pub fn of<'a>(
        principal: &Principal<N, M>,
        body: impl Into<Extent<'a, N>>,
    ) -> Result<Self, MetricsError> {
        let (body, mu) = (body.into(), &principal.rotational().values);
        let end_of = |first: usize| {
            let repeated = |next: &usize| mu[*next] - mu[*next - 1] <= REPEATED * mu[M - 1];
            first + 1 + (first + 1..M).take_while(repeated).count()
        };
        let among = |first| EquivalentStiffness::among(principal, first, end_of(first), body);
        let mut rotations = [among(0)?; M];
        let mut first = end_of(0);
        while first < M {
            let end = end_of(first);
            rotations[first..end].fill(among(first)?);
            first = end;
        }
        let degenerate = rotations.iter().any(|rotation| rotation.multiplicity > 1);
        let translational = principal.translational().values[0];
        let (value, limited_by) = (translational, LimitedBy::Translation);
        let quality = Self { value, limited_by, translational, rotations, degenerate };
        let equivalent = quality.equivalent();
        if translational <= equivalent {
            return Ok(quality);
        }
        Ok(Self { value: equivalent, limited_by: LimitedBy::Rotation, ..quality })
    }

    /// A proved lower bound of the quality: its value, but on an ellipsoid with repeated rotational
    /// stiffnesses what a search could prove (force / length).
    #[must_use]
    pub fn at_least(&self) -> f64 {
        self.rotations.iter().fold(self.translational, |least, r| least.min(r.at_least))
    }

    /// The least equivalent stiffness (force / length).
    #[must_use]
    pub fn equivalent(&self) -> f64 {
        self.softest_rotation().value
    }

    /// The principal rotation with the least equivalent stiffness, the first of several.
    #[must_use]
    pub fn softest_rotation(&self) -> &EquivalentStiffness<N, M> {
        let softer = |best: usize, i: usize| {
            if self.rotations[i].value < self.rotations[best].value { i } else { best }
        };
        &self.rotations[(1..M).fold(0, softer)]
    }
}
