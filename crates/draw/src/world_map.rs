//! From world coordinates, y up, to the page, y down, with equal aspect.

use crate::error::{DrawError, Place};

/// No page coordinate may be larger: renderers count in f32, and nothing so far off is seen.
pub(crate) const PAGE_LIMIT: f64 = 1e6;

/// A span below this part of the coordinates is one rounding of them, and no size.
const NO_SPAN: f64 = f64::EPSILON;

/// A similarity that puts world bounds into the middle of a page rectangle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WorldMap {
    scale: f64,
    world: [f64; 2],
    page: [f64; 2],
}

impl WorldMap {
    /// Fits the box between two corners into a page of this size, whose corner is (0, 0).
    pub(crate) fn fit(bounds: [[f64; 2]; 2], size: [f64; 2]) -> Result<Self, DrawError> {
        let place = Place::Bounds;
        for (index, &value) in bounds.as_flattened().iter().enumerate() {
            finite(value, place, index)?;
        }
        for (index, &value) in size.iter().enumerate() {
            if !(value > 0.0 && value <= PAGE_LIMIT) {
                return Err(DrawError::NotASize { place, index, value });
            }
        }
        let mut scale = f64::INFINITY;
        for i in 0..2 {
            let span = (bounds[1][i] - bounds[0][i]).abs();
            finite(span, place, i)?;
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
            page: size.map(|side| side / 2.0),
        })
    }

    /// Page units per world unit.
    pub(crate) fn scale(&self) -> f64 {
        self.scale
    }

    pub(crate) fn to_page(
        self,
        point: [f64; 2],
        place: Place,
        index: usize,
    ) -> Result<[f64; 2], DrawError> {
        for value in point {
            finite(value, place, index)?;
        }
        let page = [
            self.page[0] + self.scale * (point[0] - self.world[0]),
            self.page[1] - self.scale * (point[1] - self.world[1]),
        ];
        on_page(page, place, index)
    }

    pub(crate) fn to_world(self, page: [f64; 2]) -> [f64; 2] {
        [
            self.world[0] + (page[0] - self.page[0]) / self.scale,
            self.world[1] - (page[1] - self.page[1]) / self.scale,
        ]
    }
}

/// The page position, or the error that says how far off it is.
pub(crate) fn on_page(page: [f64; 2], place: Place, index: usize) -> Result<[f64; 2], DrawError> {
    let distance = page[0].abs().max(page[1].abs());
    if distance <= PAGE_LIMIT {
        Ok(page)
    } else {
        Err(DrawError::OffPage { place, index, distance })
    }
}

/// The value, or the error that says where it stood.
pub(crate) fn finite(value: f64, place: Place, index: usize) -> Result<f64, DrawError> {
    if value.is_finite() { Ok(value) } else { Err(DrawError::NotFinite { place, index, value }) }
}
