//! What can be wrong with the numbers a picture is asked to show.

use std::fmt;

/// The input a [`DrawError`] is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Place {
    /// The world bounds, or the page size, of a figure.
    Bounds,
    /// A corner of a polygon.
    Polygon,
    /// A point of a polyline.
    Polyline,
    /// The center (0) or an axis (1, 2) or the angles (3) of an arc.
    Arc,
    /// The center of a disc.
    Disc,
    /// The tail (0) or tip (1) of an arrow.
    Arrow,
    /// The point a text stands at, or one whose page position was asked for.
    Text,
    /// A length in page units: a radius, a line width, a text size.
    PageLength,
    /// A corner of the part's outline.
    Outline,
    /// A corner of the hole with this index.
    Hole(usize),
    /// The contact point of a finger.
    FingerPoint,
    /// The inward normal of a finger.
    FingerNormal,
    /// The radius of a finger.
    FingerRadius,
    /// The center of compliance.
    Center,
    /// The farthest vertex.
    FarthestVertex,
    /// The smallest enclosing circle: center (0), radius (1).
    EnclosingCircle,
    /// A corner of the shaded region with this index.
    Region(usize),
    /// An end of the auxiliary line with this index.
    AuxiliaryLine(usize),
    /// The point of a note.
    Note,
    /// The matrix of the upright ellipsoid; entries count row by row.
    Upright,
    /// The matrix of the slanted ellipsoid; entries count row by row.
    Slanted,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bounds => f.write_str("figure bounds"),
            Self::Polygon => f.write_str("polygon"),
            Self::Polyline => f.write_str("polyline"),
            Self::Arc => f.write_str("arc"),
            Self::Disc => f.write_str("disc"),
            Self::Arrow => f.write_str("arrow"),
            Self::Text => f.write_str("text"),
            Self::PageLength => f.write_str("page length"),
            Self::Outline => f.write_str("outline"),
            Self::Hole(hole) => write!(f, "hole {hole}"),
            Self::FingerPoint => f.write_str("finger point"),
            Self::FingerNormal => f.write_str("finger normal"),
            Self::FingerRadius => f.write_str("finger radius"),
            Self::Center => f.write_str("center of compliance"),
            Self::FarthestVertex => f.write_str("farthest vertex"),
            Self::EnclosingCircle => f.write_str("enclosing circle"),
            Self::Region(region) => write!(f, "region {region}"),
            Self::AuxiliaryLine(line) => write!(f, "auxiliary line {line}"),
            Self::Note => f.write_str("note"),
            Self::Upright => f.write_str("upright matrix"),
            Self::Slanted => f.write_str("slanted matrix"),
        }
    }
}

/// Why a picture cannot be drawn.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DrawError {
    /// A coordinate is NaN or infinite, or overflows when differences are formed.
    #[error("{place}: entry {index} is {value}, which is not finite")]
    NotFinite {
        /// What the number belongs to.
        place: Place,
        /// Which point, finger or matrix entry, from zero.
        index: usize,
        /// The number as given.
        value: f64,
    },
    /// A point lies so far from the figure's bounds that no page can show both.
    #[error("{place}: entry {index} is {distance} page units away from the page")]
    OffPage {
        /// What the point belongs to.
        place: Place,
        /// Which point, from zero.
        index: usize,
        /// Its largest page coordinate.
        distance: f64,
    },
    /// A polygon needs three corners, a polyline two points.
    #[error("{place}: {found} points, but {needed} are needed")]
    TooFewPoints {
        /// What the points belong to.
        place: Place,
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A size, radius or width is negative, or zero where that shows nothing.
    #[error("{place}: entry {index} is {value}, but a size is needed")]
    NotASize {
        /// What the size belongs to.
        place: Place,
        /// Which one, from zero.
        index: usize,
        /// The number as given.
        value: f64,
    },
    /// A finger's inward normal is not of unit length, to the accuracy of a drawing.
    #[error("the inward normal of finger {finger} has length {length} instead of 1")]
    NormalNotUnit {
        /// The finger's index, from zero.
        finger: usize,
        /// The length of its normal.
        length: f64,
    },
    /// A farthest vertex is given without the center it is farthest from.
    #[error("a farthest vertex is given without a center of compliance")]
    ReachWithoutCenter,
    /// The matrix of an energy is not symmetric, to the accuracy of a drawing.
    #[error("{place}: entries ({row}, {column}) and ({column}, {row}) differ by {difference}")]
    NotSymmetric {
        /// The upright or the slanted matrix.
        place: Place,
        /// Row of the entry above the diagonal.
        row: usize,
        /// Column of the entry above the diagonal.
        column: usize,
        /// What one entry has more than the other.
        difference: f64,
    },
    /// The energy is not positive definite, so its level set is not an ellipsoid.
    #[error("{place}: not positive definite, pivot {pivot} is {value}")]
    NotPositiveDefinite {
        /// The upright or the slanted matrix.
        place: Place,
        /// Which pivot of the elimination, from zero.
        pivot: usize,
        /// Its value.
        value: f64,
    },
    /// The matrix given as upright couples translation and rotation.
    #[error("the upright matrix is not block-diagonal: its coupling is {coupling} of its scale")]
    NotUpright {
        /// Coupling over the geometric mean of the diagonal blocks.
        coupling: f64,
    },
    /// The two matrices are not one energy in two frames: a length that no frame changes differs.
    #[error("the ellipsoids belong to different grasps: invariant lengths {upright} and {slanted}")]
    DifferentGrasps {
        /// The length in the upright ellipsoid.
        upright: f64,
        /// The same length in the slanted one.
        slanted: f64,
    },
    /// The raster would have no pixel, or more than the renderer can hold.
    #[error("scale {scale} does not give a raster between 1 and {limit} pixels a side")]
    RasterSize {
        /// The scale asked for.
        scale: f64,
        /// The longest side allowed.
        limit: u32,
    },
    /// The renderer refused text this crate wrote: a fault of this crate.
    #[error("the renderer refused the picture")]
    Render,
}
