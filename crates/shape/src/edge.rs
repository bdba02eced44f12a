//! One straight piece of an outline.

use clench_screw::{Vector, planar};

use crate::Winding;

/// A straight edge of an outline: a place for fingers to touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    start: Vector<2>,
    end: Vector<2>,
    direction: Vector<2>,
    inward_normal: Vector<2>,
    length: f64,
}

impl Edge {
    /// The edge between two distinct corners of an outline with the given winding.
    pub(crate) fn new(start: Vector<2>, end: Vector<2>, winding: Winding) -> Self {
        let along = end - start;
        let length = along.norm();
        let direction = Vector::new([along[0] / length, along[1] / length]);
        let left = planar::quarter_turn(direction);
        let inward_normal = match winding {
            Winding::CounterClockwise => left,
            Winding::Clockwise => -left,
        };
        Self { start, end, direction, inward_normal, length }
    }

    /// The first corner, in the order of the outline.
    #[must_use]
    pub fn start(&self) -> Vector<2> {
        self.start
    }

    /// The second corner.
    #[must_use]
    pub fn end(&self) -> Vector<2> {
        self.end
    }

    /// The unit vector from the start to the end.
    #[must_use]
    pub fn direction(&self) -> Vector<2> {
        self.direction
    }

    /// The unit normal that points into the part, whichever way its corners are numbered.
    #[must_use]
    pub fn inward_normal(&self) -> Vector<2> {
        self.inward_normal
    }

    /// The distance from the start to the end (length).
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The point of the edge's line at the distance `along` from the start (length).
    ///
    /// Measured from the nearer end, so that 0 and the length give exactly the two corners.
    ///
    /// ```
    /// let part = clench_shape::Polygon::new(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]])?;
    /// // The hypotenuse from (4, 0) to (0, 3) has length 5.
    /// let middle = part.edges()[1].point_at(2.5);
    /// assert!((middle - [2.0, 1.5].into()).norm() < 1e-15);
    /// # Ok::<(), clench_shape::PolygonError>(())
    /// ```
    #[must_use]
    pub fn point_at(&self, along: f64) -> Vector<2> {
        let rest = self.length - along;
        if along < rest {
            self.start + self.direction * along
        } else {
            self.end - self.direction * rest
        }
    }
}
