//! Which triangles are near one another in the picture.

use clench_screw::Vector;

/// Half the side of the square that is divided: a part of size 1 about the origin is inside from
/// wherever it is seen, and what is not goes to the cells at the border.
const HALF_SIDE: f64 = 0.9;

/// The most cells on a side.
const MOST_CELLS: usize = 256;

/// A rectangle in the picture: lower left and upper right corner.
pub(crate) type Rectangle = [[f64; 2]; 2];

/// Square cells with the numbers of the rectangles that touch them.
#[derive(Debug)]
pub(crate) struct Grid {
    side: usize,
    cells: Vec<Vec<usize>>,
}

impl Grid {
    /// About as many cells as rectangles.
    pub(crate) fn new(rectangles: &[Rectangle]) -> Self {
        let side = rectangles.len().isqrt().clamp(1, MOST_CELLS);
        let mut grid = Self { side, cells: vec![Vec::new(); side * side] };
        for (index, rectangle) in rectangles.iter().enumerate() {
            for cell in grid.touched(rectangle) {
                grid.cells[cell].push(index);
            }
        }
        grid
    }

    /// The rectangles that may meet one, ascending.
    pub(crate) fn near(&self, rectangle: &Rectangle) -> Vec<usize> {
        let touched = self.touched(rectangle);
        let mut found: Vec<_> = touched.flat_map(|cell| &self.cells[cell]).copied().collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    fn touched(&self, [low, high]: &Rectangle) -> impl Iterator<Item = usize> + use<> {
        let side = self.side;
        let [columns, rows] = [0, 1].map(|i| self.line(low[i])..=self.line(high[i]));
        rows.flat_map(move |row| columns.clone().map(move |column| row * side + column))
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the cast holds the number between zero and what fits, and the minimum below side"
    )]
    fn line(&self, at: f64) -> usize {
        let share = (at + HALF_SIDE) / (2.0 * HALF_SIDE);
        ((share * self.side as f64) as usize).min(self.side - 1)
    }
}

/// The rectangle around points.
pub(crate) fn around(points: &[Vector<3>]) -> Rectangle {
    let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for point in points {
        for i in 0..2 {
            bounds[0][i] = bounds[0][i].min(point[i]);
            bounds[1][i] = bounds[1][i].max(point[i]);
        }
    }
    bounds
}
