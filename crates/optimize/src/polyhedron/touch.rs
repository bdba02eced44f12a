//! A contact that is given, or that may be chosen.

use clench_screw::Vector;

use crate::OptimizeError;

/// The length of a unit normal may be off by this: what a file with seven digits rounds it to.
const UNIT: f64 = 1e-6;

/// A frictionless contact at a given place: a locator that is decided already, or a candidate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Where it touches the part (length).
    pub point: Vector<3>,
    /// The unit normal into the part.
    pub inward_normal: Vector<3>,
    /// The contact stiffness along the normal (force / length).
    pub stiffness: f64,
}

/// Which list a [`Touch`] is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TouchKind {
    /// The contacts that are given.
    Given,
    /// The candidates.
    Candidate,
}

impl std::fmt::Display for TouchKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Given => "given contact",
            Self::Candidate => "candidate",
        })
    }
}

impl Touch {
    /// Checks the touch with this number in its list.
    pub(super) fn checked(&self, kind: TouchKind, number: usize) -> Result<Self, OptimizeError> {
        let Self { point, inward_normal, stiffness } = *self;
        if !point.is_finite() {
            return Err(OptimizeError::TouchPoint { kind, number, point: point.to_array() });
        }
        let length = inward_normal.norm();
        let Some(normal) = inward_normal.direction().filter(|_| (length - 1.0).abs() <= UNIT)
        else {
            return Err(OptimizeError::TouchNormal { kind, number, length });
        };
        if !(stiffness > 0.0 && stiffness.is_finite()) {
            return Err(OptimizeError::TouchStiffness { kind, number, value: stiffness });
        }
        Ok(Self { inward_normal: normal, ..*self })
    }
}
