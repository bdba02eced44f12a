//! From world coordinates, y up, to the page, y down, with equal aspect.

use crate::error::{DrawError, Input};
use crate::page_box::PageBox;

/// No page coordinate may be larger: renderers count in f32, and nothing so far off is seen.
const PAGE_LIMIT: f64 = 1e6;

/// A span below this part of the coordinates is one rounding of them, and no size.
const NO_SPAN: f64 = f64::EPSILON;

/// What a picture does not show, in parts of what it shows: half a page unit over a plot of
/// some 500.
pub(crate) const UNSEEN: f64 = 1e-3;

/// A similarity that puts world bounds into the middle of a page rectangle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WorldMap {
    scale: f64,
    world: [f64; 2],
    page: [f64; 2],
}

impl WorldMap {
    /// Page units, y up.
    pub(crate) const PAGE: Self = Self { scale: 1.0, world: [0.0; 2], page: [0.0; 2] };

    /// Fits the finite box between two corners into a page rectangle.
    pub(crate) fn fit(bounds: [[f64; 2]; 2], frame: PageBox) -> Result<Self, DrawError> {
        let (size, mut scale) = (frame.size(), f64::INFINITY);
        for i in 0..2 {
            let span = (bounds[1][i] - bounds[0][i]).abs();
            finite(span, Input::Extent, i)?;
            // Below one rounding of the coordinates, a span says nothing about the size.
            let rounding = NO_SPAN * bounds[0][i].abs().max(bounds[1][i].abs());
            if span > rounding {
                scale = scale.min(size[i] / span);
            }
        }
        Ok(Self {
            // Also where the span is so small that the scale overflows.
            scale: if scale.is_finite() { scale } else { 1.0 },
            world: [0, 1].map(|i| f64::midpoint(bounds[0][i], bounds[1][i])),
            page: [0, 1].map(|i| f64::midpoint(frame.min[i], frame.max[i])),
        })
    }

    /// Page units per world unit.
    pub(crate) fn scale(&self) -> f64 {
        self.scale
    }

    /// The page position, held within what a renderer can count; points of the caller are
    /// refused before by [`WorldMap::check`].
    #[expect(clippy::manual_clamp, reason = "clamp would let NaN through")]
    pub(crate) fn to_page(self, point: [f64; 2]) -> [f64; 2] {
        self.unlimited(point).map(|value| value.max(-PAGE_LIMIT).min(PAGE_LIMIT))
    }

    fn unlimited(self, point: [f64; 2]) -> [f64; 2] {
        [
            self.page[0] + self.scale * (point[0] - self.world[0]),
            self.page[1] - self.scale * (point[1] - self.world[1]),
        ]
    }

    pub(crate) fn to_world(self, page: [f64; 2]) -> [f64; 2] {
        [
            self.world[0] + (page[0] - self.page[0]) / self.scale,
            self.world[1] - (page[1] - self.page[1]) / self.scale,
        ]
    }

    /// The error that says how far off the page a point is, unless it is near enough.
    pub(crate) fn check(
        self,
        point: [f64; 2],
        input: Input,
        index: usize,
    ) -> Result<(), DrawError> {
        let page = self.unlimited(point);
        let distance = page[0].abs().max(page[1].abs());
        if distance <= PAGE_LIMIT {
            Ok(())
        } else {
            Err(DrawError::OffPage { input, index, distance })
        }
    }
}

/// The value, or the error that says where it stood.
pub(crate) fn finite(value: f64, input: Input, index: usize) -> Result<f64, DrawError> {
    if value.is_finite() { Ok(value) } else { Err(DrawError::NotFinite { input, index, value }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_without_extent_and_of_any_size_stay_on_the_page() {
        let boxes = [
            [[0.0, 0.0], [0.0, 0.0]],
            [[3.0, 5.0], [3.0, 5.0]],
            [[0.0, 0.0], [0.0, 1.0]],
            [[-1e-9, 0.0], [1e-9, 1e-9]],
            [[-1e9, 0.0], [1e9, 1e9]],
            // Seven roundings wide, far off; then less than one rounding.
            [[1e9, 1e9], [1e9 + 1e-6, 1e9]],
            [[1e9, 0.0], [1e9 + 1e-8, 0.0]],
            [[0.0, 0.0], [5e-324, 5e-324]],
            [[0.0, 0.0], [1e300, 1e300]],
        ];
        for bounds in boxes {
            let frame = PageBox { min: [0.0, 0.0], max: [100.0, 100.0] };
            let map = WorldMap::fit(bounds, frame).expect("finite bounds");
            let [x, y] = map.to_page(bounds[1]);
            assert!((-1.0..=101.0).contains(&x) && (-1.0..=101.0).contains(&y), "{bounds:?}");
        }
    }
}
