//! A plate with holes that fingers stand in.

use clench_screw::Vector;

use crate::AccessError;

/// A modular plate: holes in a rectangular pattern along x and y, their axes along z.
///
/// A finger stands in a hole, and its tip can be moved sideways by the travel: its center is no
/// farther than that from the axis of some hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plate {
    pitch: [f64; 2],
    offset: [f64; 2],
    travel: f64,
}

impl Plate {
    /// The holes at `offset + [i pitch_x, j pitch_y]` for whole `i` and `j` (length).
    ///
    /// # Errors
    ///
    /// [`AccessError::PlatePitch`], [`AccessError::PlateOffset`], [`AccessError::PlateTravel`]: a
    /// travel of 0 leaves points and lines, which are for candidates.
    pub fn new(pitch: [f64; 2], offset: [f64; 2], travel: f64) -> Result<Self, AccessError> {
        let is_positive = |x: f64| x > 0.0 && x.is_finite();
        if let Some(&value) = pitch.iter().find(|&&x| !is_positive(x)) {
            return Err(AccessError::PlatePitch { value });
        }
        if let Some(&value) = offset.iter().find(|x| !x.is_finite()) {
            return Err(AccessError::PlateOffset { value });
        }
        if !is_positive(travel) {
            return Err(AccessError::PlateTravel { value: travel });
        }
        Ok(Self { pitch, offset, travel })
    }

    /// The distances of neighboring holes along x and y (length).
    #[must_use]
    pub const fn pitch(&self) -> [f64; 2] {
        self.pitch
    }

    /// The place of one hole (length).
    #[must_use]
    pub const fn offset(&self) -> [f64; 2] {
        self.offset
    }

    /// How far a center may be from a hole (length).
    #[must_use]
    pub const fn travel(&self) -> f64 {
        self.travel
    }

    /// How far a point is from the axis of the nearest hole (length).
    pub(crate) fn distance(&self, point: [f64; 2]) -> f64 {
        let along = |i: usize| {
            let holes = ((point[i] - self.offset[i]) / self.pitch[i]).round();
            point[i] - self.offset[i] - holes * self.pitch[i]
        };
        Vector::<2>::from_fn(along).norm()
    }
}
