//! One axis of a chart: what it counts, from where to where, and the values written along it.

use crate::error::{DrawError, Input};
use crate::number::readable;
use crate::ticks::round_values;
use crate::world_map::finite;

/// A value written along an axis, with a thin line across the chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Tick {
    /// Where it stands.
    pub at: f64,
    /// What is written there; `_{…}` lowers and `^{…}` raises.
    pub label: String,
}

/// An axis of a [`Chart`](crate::Chart): its name, its range and its ticks.
#[derive(Debug, Clone, PartialEq)]
pub struct ChartAxis {
    label: String,
    low: f64,
    high: f64,
    ticks: Vec<Tick>,
}

impl ChartAxis {
    /// An axis from the first to the second of two values, with a few round values as ticks.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`] for the range or its width, [`DrawError::NotAscending`] if the
    /// second value is not above the first.
    pub fn new(label: impl Into<String>, range: [f64; 2]) -> Result<Self, DrawError> {
        let [low, high] = range;
        for (index, value) in [low, high, high - low].into_iter().enumerate() {
            finite(value, Input::AxisRange, index)?;
        }
        if low >= high {
            return Err(DrawError::NotAscending { input: Input::AxisRange, index: 0, low, high });
        }
        let ticks = round_values(low, high).into_iter();
        let ticks = ticks.map(|at| Tick { at, label: readable(at) }).collect();
        Ok(Self { label: label.into(), low, high, ticks })
    }

    /// The same axis with other ticks, such as named places.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`] or [`DrawError::OutOfRange`] for a tick.
    pub fn with_ticks(self, ticks: Vec<Tick>) -> Result<Self, DrawError> {
        for (index, tick) in ticks.iter().enumerate() {
            self.check(tick.at, Input::Tick, index)?;
        }
        Ok(Self { ticks, ..self })
    }

    pub(crate) fn label(&self) -> &str {
        &self.label
    }

    pub(crate) fn ticks(&self) -> &[Tick] {
        &self.ticks
    }

    /// Where a value stands, from 0 at the low end to 1 at the high one.
    pub(crate) fn share(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    /// Refuses a value that the axis does not show.
    pub(crate) fn check(&self, value: f64, input: Input, index: usize) -> Result<(), DrawError> {
        finite(value, input, index)?;
        let Self { low, high, .. } = *self;
        if (low..=high).contains(&value) {
            return Ok(());
        }
        Err(DrawError::OutOfRange { input, index, value, low, high })
    }
}
