//! A solid with the fingers that hold it, seen in space.

mod choose;
mod displaced;
mod drawing;
mod edges;
mod finger;
mod grid;
mod hiding;
mod marks;
mod order;
mod scene;
mod triad;

use clench_screw::Vector;

use crate::error::{DrawError, Input};
use crate::figure::Figure;
use crate::solid::scene::PartFrame;
use crate::world_map::{UNSEEN, finite};

pub use displaced::{SolidDisplaced, SolidLoad};

/// A solid with the fingers that hold it, as plain numbers, drawn by [`SolidPicture::figure`].
///
/// The projection is parallel, with z up on the page. Nearer faces cover farther ones; edges
/// and fingers behind them are pale and dashed. An edge between faces whose normals differ by
/// less than 20 degrees is not drawn unless the outline runs along it, so that a fine mesh
/// looks smooth. Lengths may be in any unit: only their ratios are seen.
///
/// A part of more than 5000 triangles shows no hidden edges. The cost of a mesh is about in
/// proportion to its triangles.
///
/// ```
/// use clench_draw::{SolidFace, SolidFinger, SolidPicture};
///
/// // A tetrahedron with the corners 0, x, y and z; its last face has a slanted normal.
/// let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let third = 1.0_f64 / 3.0;
/// let face = |ring: [usize; 3], outward_normal| {
///     let triangle = ring.map(|i| corners[i]);
///     SolidFace { outward_normal, loops: vec![triangle.to_vec()], triangles: vec![triangle] }
/// };
/// let picture = SolidPicture {
///     faces: vec![
///         face([0, 2, 1], [0.0, 0.0, -1.0]),
///         face([0, 1, 3], [0.0, -1.0, 0.0]),
///         face([0, 3, 2], [-1.0, 0.0, 0.0]),
///         face([1, 2, 3], [third.sqrt(); 3]),
///     ],
///     fingers: vec![SolidFinger {
///         point: [third; 3],
///         inward_normal: [-third.sqrt(); 3],
///         label: "1".into(),
///         ..SolidFinger::default()
///     }],
///     ..SolidPicture::default()
/// };
/// assert!(picture.figure()?.to_svg().contains(">1</text>"));
/// # Ok::<(), clench_draw::DrawError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolidPicture {
    /// The heading.
    pub title: Option<String>,
    /// The faces, which together close the solid.
    pub faces: Vec<SolidFace>,
    /// The fingers.
    pub fingers: Vec<SolidFinger>,
    /// Screw axes: dash-dotted lines through the part and a bit beyond it.
    pub axes: Vec<SolidAxis>,
    /// The center of compliance, or the canonical point.
    pub center: Option<SolidMark>,
    /// The point that gives way most.
    pub worst_point: Option<SolidWorst>,
    /// The part as a load has moved it.
    pub displaced: Option<SolidDisplaced>,
    /// Forces from outside.
    pub loads: Vec<SolidLoad>,
    /// From the part towards the viewer, of any length; chosen by the picture if left out, so
    /// that many faces and fingers are in sight and none is seen along itself.
    pub view: Option<[f64; 3]>,
    /// Lines of text beside the part, or below one that is wide.
    pub caption: Vec<String>,
}

/// A plane face of a solid.
///
/// Neighbors have the same corners along their common edge, bit for bit: that is how edges know
/// their two faces. An edge without a neighbor is drawn as a sharp one.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolidFace {
    /// The unit normal that points out of the solid.
    pub outward_normal: [f64; 3],
    /// The closed loops of corners around the face and its holes, three corners or more each.
    pub loops: Vec<Vec<[f64; 3]>>,
    /// Triangles that cover the face, counter-clockwise seen from outside; one or more.
    pub triangles: Vec<[[f64; 3]; 3]>,
}

/// A finger, touching from outside with a pointed tip.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolidFinger {
    /// Where it touches.
    pub point: [f64; 3],
    /// The unit normal that points into the part.
    pub inward_normal: [f64; 3],
    /// Its name; `_{…}` lowers and `^{…}` raises. Empty for none.
    pub label: String,
    /// Whether it is fixed, a locator: drawn with a square foot, in another color.
    pub fixed: bool,
}

/// A screw axis.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolidAxis {
    /// Any point of the axis.
    pub point: [f64; 3],
    /// Its direction, of any length but zero.
    pub direction: [f64; 3],
    /// Its name; empty for none.
    pub label: String,
    /// Whether it stands out, as that of the softest rotation: stronger, with a turning arrow.
    pub emphasized: bool,
}

/// A named point in space.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolidMark {
    /// Where it is.
    pub point: [f64; 3],
    /// Its name; empty for none.
    pub label: String,
}

/// The point that gives way most.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SolidWorst {
    /// Where it is.
    pub point: [f64; 3],
    /// The direction of the deflection, of any length but zero: drawn as a double arrow.
    pub direction: [f64; 3],
    /// Its name; empty for none.
    pub label: String,
}

impl SolidPicture {
    /// Draws the picture.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`], [`DrawError::NoFaces`], [`DrawError::TooFewPoints`],
    /// [`DrawError::FaceNormalNotUnit`], [`DrawError::NormalNotUnit`] or
    /// [`DrawError::NoDirection`] for what the fields hold, [`DrawError::NotPositive`] for a part
    /// that is one point, [`DrawError::OffPage`] for what lies absurdly far from the part.
    pub fn figure(&self) -> Result<Figure, DrawError> {
        self.check()?;
        drawing::draw(self)
    }

    /// The unit direction towards the viewer that the picture has, or chooses.
    ///
    /// # Errors
    /// Those of [`Self::figure`], but [`DrawError::OffPage`].
    pub fn seen_from(&self) -> Result<[f64; 3], DrawError> {
        self.check()?;
        Ok(choose::eye(self, PartFrame::new(&self.faces)?).to_array())
    }

    fn check(&self) -> Result<(), DrawError> {
        if self.faces.is_empty() {
            return Err(DrawError::NoFaces);
        }
        self.faces.iter().enumerate().try_for_each(|(index, face)| face.check(index))?;
        self.fingers.iter().enumerate().try_for_each(|(index, finger)| finger.check(index))?;
        for (index, axis) in self.axes.iter().enumerate() {
            all_finite(axis.point, Input::AxisPoint, index)?;
            direction(axis.direction, Input::AxisDirection, index)?;
        }
        self.displaced.iter().try_for_each(SolidDisplaced::check)?;
        self.loads.iter().enumerate().try_for_each(|(index, load)| load.check(index))?;
        if let Some(center) = &self.center {
            all_finite(center.point, Input::Center, 0)?;
        }
        if let Some(worst) = &self.worst_point {
            all_finite(worst.point, Input::WorstPoint, 0)?;
            direction(worst.direction, Input::WorstDirection, 0)?;
        }
        self.view.map_or(Ok(()), |view| direction(view, Input::View, 0))
    }
}

impl SolidFace {
    fn check(&self, face: usize) -> Result<(), DrawError> {
        all_finite(self.outward_normal, Input::FaceNormal, face)?;
        let length = Vector::new(self.outward_normal).scaled_norm();
        if (length - 1.0).abs() > UNSEEN {
            return Err(DrawError::FaceNormalNotUnit { face, length });
        }
        let input = Input::Face(face);
        let corners = self.triangles.as_flattened().len();
        let shortest = self.loops.iter().map(Vec::len).min().unwrap_or(0);
        for found in [shortest, corners] {
            if found < 3 {
                return Err(DrawError::TooFewPoints { input, found, needed: 3 });
            }
        }
        self.corners().enumerate().try_for_each(|(index, at)| all_finite(at, input, index))
    }

    /// The corners of the loops, then of the triangles.
    fn corners(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        self.loops.iter().flatten().chain(self.triangles.as_flattened()).copied()
    }
}

impl SolidFinger {
    fn check(&self, index: usize) -> Result<(), DrawError> {
        all_finite(self.point, Input::FingerPoint, index)?;
        all_finite(self.inward_normal, Input::FingerNormal, index)?;
        let length = Vector::new(self.inward_normal).scaled_norm();
        if (length - 1.0).abs() > UNSEEN {
            return Err(DrawError::NormalNotUnit { finger: index, length });
        }
        Ok(())
    }
}

fn all_finite(values: [f64; 3], input: Input, index: usize) -> Result<(), DrawError> {
    values.into_iter().try_for_each(|value| finite(value, input, index).map(|_| ()))
}

fn direction(along: [f64; 3], input: Input, index: usize) -> Result<(), DrawError> {
    all_finite(along, input, index)?;
    if Vector::new(along).direction().is_none() {
        return Err(DrawError::NoDirection { input, index });
    }
    Ok(())
}
