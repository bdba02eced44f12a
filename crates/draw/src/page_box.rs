//! A rectangle on the page, y downwards.

/// An axis-parallel rectangle in page units; empty until something is put in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PageBox {
    /// Left and top.
    pub(crate) min: [f64; 2],
    /// Right and bottom.
    pub(crate) max: [f64; 2],
}

impl PageBox {
    /// The rectangle that holds nothing.
    pub(crate) const EMPTY: Self = Self { min: [f64::INFINITY; 2], max: [f64::NEG_INFINITY; 2] };

    /// The rectangle with this center and size.
    pub(crate) fn centered(center: [f64; 2], size: [f64; 2]) -> Self {
        Self {
            min: [center[0] - size[0] / 2.0, center[1] - size[1] / 2.0],
            max: [center[0] + size[0] / 2.0, center[1] + size[1] / 2.0],
        }
    }

    /// Width and height; zero where empty.
    pub(crate) fn size(&self) -> [f64; 2] {
        [0, 1].map(|i| (self.max[i] - self.min[i]).max(0.0))
    }

    /// Grows to hold the square of this half-width around a point.
    pub(crate) fn include(&mut self, point: [f64; 2], margin: f64) {
        for i in 0..2 {
            self.min[i] = self.min[i].min(point[i] - margin);
            self.max[i] = self.max[i].max(point[i] + margin);
        }
    }

    /// The rectangle grown by this much on every side.
    pub(crate) fn grown(&self, margin: f64) -> Self {
        Self {
            min: self.min.map(|value| value - margin),
            max: self.max.map(|value| value + margin),
        }
    }

    /// The area shared with another rectangle.
    pub(crate) fn overlap(&self, other: &Self) -> f64 {
        let side = |i: usize| self.max[i].min(other.max[i]) - self.min[i].max(other.min[i]);
        side(0).max(0.0) * side(1).max(0.0)
    }

    /// The length of the segment's part inside, by clipping it against the four sides.
    pub(crate) fn inside_length(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        let mut span = [0.0_f64, 1.0_f64];
        for i in 0..2 {
            let run = to[i] - from[i];
            let (low, high) = (self.min[i] - from[i], self.max[i] - from[i]);
            if run == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return 0.0;
                }
                continue;
            }
            let (enter, leave) = if run > 0.0 { (low, high) } else { (high, low) };
            span = [span[0].max(enter / run), span[1].min(leave / run)];
        }
        (span[1] - span[0]).max(0.0) * (to[0] - from[0]).hypot(to[1] - from[1])
    }
}
