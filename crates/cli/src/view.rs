//! The frame that a report is written in.

use clench::screw::{Axis, Frame, Mat, Vector, planar, spatial};

use crate::arguments::FrameArgument;
use crate::failure::Failure;

/// A frame seen from that of the file, and the numbers that say so.
#[derive(Clone, Debug)]
pub(crate) struct View<const N: usize, const M: usize> {
    frame: Frame<N, M>,
    numbers: Vec<f64>,
}

impl View<2, 1> {
    /// The frame of the command line, or that of the file.
    pub(crate) fn planar(argument: Option<&FrameArgument>) -> Result<Self, Failure> {
        let numbers = argument.map_or_else(|| vec![0.0; 3], |frame| frame.0.clone());
        match numbers[..] {
            [x, y, angle] => Ok(Self { frame: planar::Frame::new([x, y], angle), numbers }),
            _ => Err(Failure::PlanarFrame { found: numbers.len() }),
        }
    }
}

impl View<3, 3> {
    /// The frame of the command line, or that of the file.
    pub(crate) fn spatial(argument: Option<&FrameArgument>) -> Result<Self, Failure> {
        let numbers = argument.map_or_else(|| vec![0.0; 6], |frame| frame.0.clone());
        match numbers[..] {
            [x, y, z, rx, ry, rz] => {
                Ok(Self { frame: spatial::Frame::new([x, y, z], [rx, ry, rz]), numbers })
            }
            _ => Err(Failure::SpatialFrame { found: numbers.len() }),
        }
    }
}

impl<const N: usize, const M: usize> View<N, M> {
    /// The frame, seen from that of the file.
    pub(crate) fn frame(&self) -> &Frame<N, M> {
        &self.frame
    }

    /// Whether this is the frame of the file.
    pub(crate) fn is_of_file(&self) -> bool {
        self.numbers.iter().all(|number| number.abs() <= 0.0)
    }

    /// The same axes through the origin of the file's frame.
    pub(crate) fn turn(&self) -> Frame<N, M> {
        Frame::at(-self.frame.origin()) * self.frame
    }

    /// The coordinates of the origin.
    pub(crate) fn origin(&self) -> &[f64] {
        &self.numbers[..N]
    }

    /// The angle, or the rotation vector [rad].
    pub(crate) fn rotation(&self) -> &[f64] {
        &self.numbers[N..]
    }

    /// A point in this frame.
    pub(crate) fn point(&self, point: Vector<N>) -> Vec<f64> {
        components(self.frame.point_in_frame(point))
    }

    /// A direction along the axes of this frame.
    pub(crate) fn direction(&self, direction: Vector<N>) -> Vec<f64> {
        components(self.frame.direction_in_frame(direction))
    }

    /// The rotation, angular velocity or torque `turning` along the axes of this frame.
    pub(crate) fn turning(&self, turning: Vector<M>) -> Vec<f64> {
        components(self.frame.spin().transpose() * turning)
    }

    /// The axis in this frame: its direction, which has three numbers in the plane too, and its
    /// point nearest to the origin.
    pub(crate) fn axis(&self, axis: &Axis) -> (Vec<f64>, Vec<f64>) {
        let within = |v: Vector<3>| Vector::<N>::from_fn(|i| v[i]);
        let along = self.frame.direction_in_frame(within(axis.direction));
        // The z axis of the plane stays.
        let direction = (0..3).map(|i| plain(if i < N { along[i] } else { axis.direction[i] }));
        let point = self.frame.point_in_frame(within(axis.point));
        (direction.collect(), components(point - along * along.dot(point)))
    }
}

/// The rows of a matrix.
pub(crate) type Rows = Vec<Vec<f64>>;

/// The number, zero without a sign.
pub(crate) fn plain(value: f64) -> f64 {
    value + 0.0
}

/// The components of a vector.
pub(crate) fn components<const D: usize>(vector: Vector<D>) -> Vec<f64> {
    vector.to_array().map(plain).to_vec()
}

/// The rows of a matrix.
pub(crate) fn rows<const R: usize, const C: usize>(matrix: &Mat<R, C>) -> Rows {
    matrix.rows().iter().map(|row| row.iter().copied().map(plain).collect()).collect()
}
