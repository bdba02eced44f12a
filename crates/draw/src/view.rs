//! A direction to look from, in parallel projection.

use clench_screw::Vector;
use clench_screw::spatial::cross;

/// The sine of the angle to the vertical below which a view counts as one along it.
const ALONG_VERTICAL: f64 = 1e-6;

/// A direction to look from, at the origin, with the third coordinate up.
#[derive(Debug, Clone, Copy)]
pub(crate) struct View {
    pub(crate) right: Vector<3>,
    pub(crate) up: Vector<3>,
    /// From the scene to the eye.
    pub(crate) eye: Vector<3>,
}

impl View {
    /// The view from an azimuth about the vertical and an elevation, in degrees.
    pub(crate) fn from_angles(azimuth: f64, elevation: f64) -> Self {
        let (sin_a, cos_a) = azimuth.to_radians().sin_cos();
        let (sin_e, cos_e) = elevation.to_radians().sin_cos();
        let right = Vector::new([-sin_a, cos_a, 0.0]);
        let eye = Vector::new([cos_e * cos_a, cos_e * sin_a, sin_e]);
        Self { right, up: cross(eye, right), eye }
    }

    /// The view from a unit direction; along the vertical the first coordinate goes right.
    pub(crate) fn from_eye(eye: Vector<3>) -> Self {
        let level = eye[0].hypot(eye[1]);
        let right = if level > ALONG_VERTICAL {
            Vector::new([-eye[1] / level, eye[0] / level, 0.0])
        } else {
            Vector::new([1.0, 0.0, 0.0])
        };
        Self { right, up: cross(eye, right), eye }
    }

    pub(crate) fn project(&self, point: Vector<3>) -> [f64; 2] {
        [self.right.dot(point), self.up.dot(point)]
    }

    /// Right, up and towards the eye.
    pub(crate) fn in_view(&self, point: Vector<3>) -> [f64; 3] {
        [self.right.dot(point), self.up.dot(point), self.eye.dot(point)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[expect(clippy::float_cmp, reason = "every number here is exact in binary")]
    fn the_vertical_is_up_and_along_it_x_goes_right() {
        let view = View::from_eye([0.0, -1.0, 0.0].into());
        assert_eq!(view.in_view([1.0, 2.0, 3.0].into()), [1.0, 3.0, -2.0]);
        for side in [-1.0, 1.0] {
            let view = View::from_eye([0.0, 0.0, side].into());
            assert_eq!(view.in_view([1.0, 2.0, 3.0].into()), [1.0, 2.0 * side, 3.0 * side]);
        }
    }
}
