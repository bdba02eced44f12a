//! A solid turned so that it is seen along the third coordinate, at the size of a unit cube.

use clench_screw::Vector;

use crate::error::{DrawError, Input};
use crate::solid::{SolidFace, SolidPicture};
use crate::view::View;
use crate::world_map::{UNSEEN, finite};

/// A face whose normal has at most this towards the viewer is seen as a line, or from behind.
pub(crate) const EDGE_ON: f64 = UNSEEN;

/// From the units of the caller to a part of size 1 about the origin.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PartFrame {
    middle: [f64; 3],
    size: f64,
}

impl PartFrame {
    /// The middle and the longest side of the box around the faces.
    pub(crate) fn new(faces: &[SolidFace]) -> Result<Self, DrawError> {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for corner in faces.iter().flat_map(SolidFace::corners) {
            for i in 0..3 {
                low[i] = low[i].min(corner[i]);
                high[i] = high[i].max(corner[i]);
            }
        }
        let mut size = 0.0_f64;
        for i in 0..3 {
            size = size.max(finite(high[i] - low[i], Input::Extent, i)?);
        }
        if size <= 0.0 {
            return Err(DrawError::NotPositive { input: Input::Extent, value: size });
        }
        Ok(Self { middle: [0, 1, 2].map(|i| f64::midpoint(low[i], high[i])), size })
    }

    fn place(&self, point: [f64; 3]) -> Vector<3> {
        Vector::from_fn(|i| (point[i] - self.middle[i]) / self.size)
    }
}

/// A face as it is seen.
#[derive(Debug)]
pub(crate) struct SeenFace {
    pub(crate) normal: Vector<3>,
    pub(crate) triangles: Vec<[Vector<3>; 3]>,
}

impl SeenFace {
    /// Whether it is turned towards the viewer.
    pub(crate) fn is_front(&self) -> bool {
        self.normal[2] > EDGE_ON
    }
}

/// The faces in coordinates of the view: right, up and towards the viewer.
#[derive(Debug)]
pub(crate) struct Scene {
    frame: PartFrame,
    pub(crate) view: View,
    pub(crate) faces: Vec<SeenFace>,
}

impl Scene {
    /// The part of a picture as it is seen from a unit direction.
    pub(crate) fn new(picture: &SolidPicture, frame: PartFrame, eye: Vector<3>) -> Self {
        let mut scene = Self { frame, view: View::from_eye(eye), faces: Vec::new() };
        let seen = |face: &SolidFace| SeenFace {
            normal: scene.direction(face.outward_normal),
            triangles: face.triangles.iter().map(|t| t.map(|corner| scene.point(corner))).collect(),
        };
        scene.faces = picture.faces.iter().map(seen).collect();
        scene
    }

    /// Another part, seen in the same way.
    pub(crate) fn seen_as(picture: &SolidPicture, other: &Self) -> Self {
        Self::new(picture, other.frame, other.view.eye)
    }

    /// Where a point of the caller is.
    pub(crate) fn point(&self, point: [f64; 3]) -> Vector<3> {
        self.view.in_view(self.frame.place(point)).into()
    }

    /// A direction of the caller, at unit length.
    pub(crate) fn direction(&self, along: [f64; 3]) -> Vector<3> {
        let unit = Vector::new(along).direction().unwrap_or(Vector::ZERO);
        self.view.in_view(unit).into()
    }

    pub(crate) fn corners(&self) -> impl Iterator<Item = Vector<3>> + '_ {
        self.faces.iter().flat_map(|face| face.triangles.as_flattened()).copied()
    }
}

/// Where a point stands on the picture.
pub(crate) fn flat(point: Vector<3>) -> [f64; 2] {
    [point[0], point[1]]
}
