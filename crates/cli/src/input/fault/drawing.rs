//! What can be wrong with a drawing and what is said of it.

use clench::drawing::DrawingError;

use crate::input::units::lengths;
use crate::wording::{layer_name, quoted};

/// Why a drawing, or what a file says of it, was refused.
#[derive(Debug, thiserror::Error)]
pub(crate) enum DrawingFault {
    /// It is no drawing of a part.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
    /// The reader gave up in a way that it should not.
    #[error("the file cannot be read: its reader failed; is the file damaged?")]
    Panicked,
    /// A drawing without units, and none said elsewhere.
    #[error("the drawing does not name its unit of length")]
    NoUnit,
    /// A unit that the drawing's cannot be converted into.
    #[error(
        "the drawing is in {found}, which cannot be converted into {}: expected one of {}",
        quoted(.wanted), lengths()
    )]
    UnknownUnit { found: &'static str, wanted: String },
    /// Two stiffnesses for one layer.
    #[error(
        "found a stiffness for layer {} and one for layer {}, expected one: they are the same \
         layer, whose case does not count",
        quoted(&.layers[0]), quoted(&.layers[1])
    )]
    LayerTwice { layers: [String; 2] },
    /// A layer on which there is no edge.
    #[error("{} has no edge of the outline or a hole", layer_name(.layer))]
    NoEdgeOnLayer { layer: String },
    /// An edge without a stiffness.
    #[error("found no stiffness for {}, on which there are edges", layer_name(.layer))]
    NoStiffness { layer: String },
}

impl DrawingFault {
    /// The line of the drawing that it is about.
    pub(super) fn line(&self) -> Option<usize> {
        match self {
            Self::Drawing(error) => error.line(),
            _ => None,
        }
    }

    pub(super) fn help(&self) -> Option<&'static str> {
        match self {
            Self::Drawing(DrawingError::BinaryDxf | DrawingError::Dwg) => {
                Some("most programs that draw can save text DXF or SVG")
            }
            Self::Drawing(DrawingError::OpenEnd { .. } | DrawingError::Branch { .. }) => {
                Some("`layers`, or --layer, takes the curves of some layers only")
            }
            Self::NoUnit => Some("give `units` in the part file, or --units mm"),
            _ => None,
        }
    }
}
