//! What can be wrong with a part.

use clench::optimize::OptimizeError;
use clench::shape::{
    AccessError, EllipsoidError, LARGEST_COORDINATE, PolygonError, PolyhedronError,
    SMALLEST_COORDINATE,
};

use super::{DrawingFault, MeshFault};
use crate::input::PieceKind;
use crate::wording::{counted, digits};

/// Why a part was refused.
#[derive(Debug, thiserror::Error)]
pub(crate) enum PartFault {
    /// Neither a planar nor a spatial part.
    #[error(
        "found neither `planar` nor `spatial` in the part, expected one of them: `planar` with an \
         `outline` and a `stiffness`, for one"
    )]
    None,
    /// A planar and a spatial part.
    #[error("found both `planar` and `spatial` in the part, expected one of them")]
    Two,
    /// A planar part without a shape, or with two.
    #[error("found {found}, expected exactly one of `outline`, `drawing` and `ellipse`")]
    PlanarShape { found: &'static str },
    /// A spatial part without a shape, or with several.
    #[error(
        "found {found}, expected exactly one of `vertices` with `faces`, `mesh` and `ellipsoid`"
    )]
    SpatialShape { found: String },
    /// A center where there is no ellipse or ellipsoid.
    #[error("found a `center`, which only an `{smooth}` has")]
    Center { smooth: &'static str },
    /// An ellipsoid where fingers are to be placed.
    #[error(
        "found an `ellipsoid`, which has no faces: `optimize` places fingers on outlines and on \
         solids of plane faces"
    )]
    SmoothSolidOptimum,
    /// An ellipse where fingers are to be placed.
    #[error("found no `outline`, expected one: `optimize` places fingers on outlines only")]
    SmoothOptimum,
    /// Fingers are to be placed, but how stiff they are is not known.
    #[error("missing field `stiffness`, expected a positive number, or a list of one per {piece}")]
    NoStiffness { piece: PieceKind },
    /// Contacts for the part of another file, with a part that is not the same.
    #[error("found another part than that of {name}, expected the same, or none")]
    OtherPart { name: String },
    /// Too few points for an outline.
    #[error("found {}, expected at least 3", counted(*.count, "corner"))]
    TooFewCorners { count: usize },
    /// The outline is not valid.
    #[error(transparent)]
    Outline(PolygonError),
    /// A semi-axis is zero, negative, or out of the range of numbers.
    #[error(
        "semi-axis {axis} is {}, but has to be from {SMALLEST_COORDINATE:e} to \
         {LARGEST_COORDINATE:e}",
        digits(*.value)
    )]
    SemiAxis { axis: usize, value: f64 },
    /// The ellipse or ellipsoid is not valid.
    #[error(transparent)]
    Ellipsoid(EllipsoidError),
    /// The surface is not valid.
    #[error(transparent)]
    Polyhedron(PolyhedronError),
    /// The mesh file is no mesh of a solid.
    #[error("{name}: {fault}")]
    Mesh { name: String, fault: MeshFault },
    /// The drawing is no drawing of a part.
    #[error("{name}: {fault}")]
    Drawing { name: String, fault: Box<DrawingFault> },
    /// A layer of the drawing that is not there, or of which too little is said.
    #[error(transparent)]
    Layer(Box<DrawingFault>),
    /// What only drawings have.
    #[error("found {found}, which goes with a `drawing` only")]
    DrawingOnly { found: &'static str },
    /// The stiffnesses of edges or faces are not valid.
    #[error(transparent)]
    PieceStiffness(Box<OptimizeError>),
    /// A margin or a forbidden stretch is not valid.
    #[error(transparent)]
    Forbidden(Box<OptimizeError>),
    /// Where the tips of fingers may be is not valid.
    #[error(transparent)]
    Access(AccessError),
    /// Where fingers may be on a body without faces.
    #[error("found `{found}`, which only a solid with faces has")]
    FacesOnly { found: &'static str },
    /// A margin or a list of edges where there is no outline.
    #[error("found {found}, which only an `outline` has")]
    OutlineOnly { found: &'static str },
    /// A stiffness is zero or negative.
    #[error("the stiffness is {}, but has to be a positive finite number", digits(*.value))]
    Stiffness { value: f64 },
    /// A list of stiffnesses where there is nothing to count.
    #[error("found a list of stiffnesses, expected one number: {reason}")]
    StiffnessList { reason: &'static str },
    /// As many stiffnesses as something else.
    #[error("found {}, expected one for each of the {faces} faces", counted(*.found, "number"))]
    FaceStiffnesses { found: usize, faces: usize },
}

impl PartFault {
    pub(super) fn help(&self) -> Option<&'static str> {
        match self {
            Self::SmoothSolidOptimum | Self::SmoothOptimum => {
                Some("`clench analyze` reads every part, with contacts")
            }
            Self::None => Some("`clench --help` shows a file"),
            Self::Mesh { fault, .. } => fault.help(),
            Self::Drawing { fault, .. } => fault.help(),
            _ => None,
        }
    }
}
