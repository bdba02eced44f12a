//! What can be wrong with the numbers a picture is asked to show.

use std::fmt;

/// The input a [`DrawError`] is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Input {
    /// The width (0) or height (1) of the whole picture, in world units; of a solid its side
    /// along x (0), y (1) or z (2).
    Extent,
    /// A corner of the part's outline.
    Outline,
    /// A corner of the part's hole with this index.
    Hole(usize),
    /// The contact point of a finger.
    FingerPoint,
    /// The inward normal of a finger.
    FingerNormal,
    /// The radius of a finger.
    FingerRadius,
    /// The force of a finger.
    FingerForce,
    /// A principal direction.
    Direction,
    /// A corner of the part as a load has moved it, or the motion of a solid.
    Displaced,
    /// The point where a load acts.
    LoadPoint,
    /// The direction of a load.
    LoadDirection,
    /// The radius of a part's boundary.
    PartRadius,
    /// The overlap of a contact.
    Overlap,
    /// The half width of the area of contact.
    HalfWidth,
    /// The center of compliance.
    Center,
    /// The farthest corner.
    FarthestCorner,
    /// A corner of the shaded region with this index.
    Region(usize),
    /// A point of the way with this index.
    Way(usize),
    /// The point of a note.
    Note,
    /// A point of the upright ellipsoid.
    Upright,
    /// A point of the slanted ellipsoid.
    Slanted,
    /// The low end (0), the high end (1) or the width (2) of a chart's axis.
    AxisRange,
    /// A tick of a chart's axis.
    Tick,
    /// A point of the curve with this index.
    Curve(usize),
    /// A place of the band with this index.
    Band(usize),
    /// A span of the veil with this index.
    Veil(usize),
    /// A named point of a chart.
    ChartMark,
    /// A corner of the face with this index: those of its loops first, then of its triangles.
    Face(usize),
    /// The outward normal of a face.
    FaceNormal,
    /// The point of a screw axis.
    AxisPoint,
    /// The direction of a screw axis.
    AxisDirection,
    /// The point that gives way most.
    WorstPoint,
    /// The direction in which that point gives way.
    WorstDirection,
    /// The direction towards the viewer.
    View,
}

impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Extent => f.write_str("extent of the picture"),
            Self::Outline => f.write_str("outline"),
            Self::Hole(hole) => write!(f, "hole {hole}"),
            Self::FingerPoint => f.write_str("finger point"),
            Self::FingerNormal => f.write_str("finger normal"),
            Self::FingerRadius => f.write_str("finger radius"),
            Self::FingerForce => f.write_str("finger force"),
            Self::Direction => f.write_str("principal direction"),
            Self::Displaced => f.write_str("displaced part"),
            Self::LoadPoint => f.write_str("load point"),
            Self::LoadDirection => f.write_str("load direction"),
            Self::PartRadius => f.write_str("part radius"),
            Self::Overlap => f.write_str("overlap"),
            Self::HalfWidth => f.write_str("half width of the contact"),
            Self::Center => f.write_str("center of compliance"),
            Self::FarthestCorner => f.write_str("farthest corner"),
            Self::Region(region) => write!(f, "region {region}"),
            Self::Way(way) => write!(f, "way {way}"),
            Self::Note => f.write_str("note"),
            Self::Upright => f.write_str("upright ellipsoid"),
            Self::Slanted => f.write_str("slanted ellipsoid"),
            Self::AxisRange => f.write_str("range of an axis"),
            Self::Tick => f.write_str("tick"),
            Self::Curve(curve) => write!(f, "curve {curve}"),
            Self::Band(band) => write!(f, "band {band}"),
            Self::Veil(veil) => write!(f, "veil {veil}"),
            Self::ChartMark => f.write_str("mark"),
            Self::Face(face) => write!(f, "face {face}"),
            Self::FaceNormal => f.write_str("face normal"),
            Self::AxisPoint => f.write_str("axis point"),
            Self::AxisDirection => f.write_str("axis direction"),
            Self::WorstPoint => f.write_str("worst point"),
            Self::WorstDirection => f.write_str("worst direction"),
            Self::View => f.write_str("view"),
        }
    }
}

/// Why a picture cannot be drawn.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DrawError {
    /// A coordinate is NaN or infinite, or overflows when differences are formed.
    #[error("{input}: entry {index} is {value}, which is not finite")]
    NotFinite {
        /// What the number belongs to.
        input: Input,
        /// Which point or finger, from zero.
        index: usize,
        /// The number as given.
        value: f64,
    },
    /// A point lies so far from the figure's bounds that no page can show both.
    #[error("{input}: entry {index} is {distance} page units away from the page")]
    OffPage {
        /// What the point belongs to.
        input: Input,
        /// Which point, from zero.
        index: usize,
        /// Its largest page coordinate.
        distance: f64,
    },
    /// A polygon needs three corners, a line two points.
    #[error("{input}: {found} points, but {needed} are needed")]
    TooFewPoints {
        /// What the points belong to.
        input: Input,
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// The radius of a finger is negative.
    #[error("the radius of finger {finger} is {radius}, which is negative")]
    NegativeRadius {
        /// The finger's index, from zero.
        finger: usize,
        /// Its radius.
        radius: f64,
    },
    /// A length that has to be positive is not.
    #[error("{input} is {value}, which is not positive")]
    NotPositive {
        /// Which length.
        input: Input,
        /// The number as given.
        value: f64,
    },
    /// A hollow as narrow as the finger: they touch in more than one point.
    #[error("a finger of radius {finger} does not fit into a hollow of radius {hollow}")]
    TightHollow {
        /// The finger's radius.
        finger: f64,
        /// The radius of the hollow, positive.
        hollow: f64,
    },
    /// The overlap leaves no room to tell the radii.
    #[error("the overlap is {overlap}, more than half the smaller radius, {limit}")]
    OverlapTooDeep {
        /// The overlap.
        overlap: f64,
        /// Half the smaller radius.
        limit: f64,
    },
    /// The overlap is so slight that a picture to scale cannot show it: draw a larger one, and
    /// say so in the caption.
    #[error("half the lens of overlap is {ratio} times as wide as deep, more than {limit}")]
    LensTooFlat {
        /// Half the width of the lens over the overlap.
        ratio: f64,
        /// The largest ratio that is drawn.
        limit: f64,
    },
    /// The area of contact reaches beyond the lens of overlap.
    #[error("the half width of the contact is {half_width}, but that of the overlap is {limit}")]
    ContactBeyondLens {
        /// Half the width of the area of contact.
        half_width: f64,
        /// Half the width of the lens of overlap.
        limit: f64,
    },
    /// A finger's inward normal is not of unit length, to the accuracy of a drawing.
    #[error("the inward normal of finger {finger} has length {length} instead of 1")]
    NormalNotUnit {
        /// The finger's index, from zero.
        finger: usize,
        /// The length of its normal.
        length: f64,
    },
    /// A solid without a face.
    #[error("the solid has no face")]
    NoFaces,
    /// A face's outward normal is not of unit length, to the accuracy of a drawing.
    #[error("the outward normal of face {face} has length {length} instead of 1")]
    FaceNormalNotUnit {
        /// The face's index, from zero.
        face: usize,
        /// The length of its normal.
        length: f64,
    },
    /// A direction of length zero.
    #[error("{input}: entry {index} has length 0, which is no direction")]
    NoDirection {
        /// What the direction belongs to.
        input: Input,
        /// Which one, from zero.
        index: usize,
    },
    /// A farthest corner is given without the center it is farthest from.
    #[error("a farthest corner is given without a center of compliance")]
    ReachWithoutCenter,
    /// A point of an ellipsoid of twists rises where its section is horizontal, or the third
    /// point of one of wrenches has a force, to the accuracy of a drawing.
    #[error("{input}: coordinate {coordinate} of point {point} is {value} instead of 0")]
    NotTriangular {
        /// The upright or the slanted ellipsoid.
        input: Input,
        /// Which of its three points, from zero.
        point: usize,
        /// Which coordinate of the point, from zero.
        coordinate: usize,
        /// The coordinate.
        value: f64,
    },
    /// A point of an ellipsoid is so near to its middle that it shows as a line, or is flat.
    #[error("{input}: point {point} is too near to the middle, the ellipsoid is flat")]
    Flat {
        /// The upright or the slanted ellipsoid.
        input: Input,
        /// Which of its three points, from zero.
        point: usize,
    },
    /// The first two points of an ellipsoid do not lie over the axes of an ellipse.
    #[error("{input}: points 0 and 1 are not over semi-axes, the cosine between them is {cosine}")]
    NotSemiAxes {
        /// The upright or the slanted ellipsoid.
        input: Input,
        /// The cosine of the angle between their horizontal parts.
        cosine: f64,
    },
    /// The ellipsoid given as upright couples translation and rotation.
    #[error("the upright ellipsoid leans by {lean} of its size")]
    NotUpright {
        /// How far its top, or its widest section, is off over the half-width there.
        lean: f64,
    },
    /// The two ellipsoids are not one energy in two shifted frames: a length that no shift changes
    /// differs.
    #[error("the ellipsoids belong to different grasps: invariant lengths {upright} and {slanted}")]
    DifferentGrasps {
        /// The length in the upright ellipsoid.
        upright: f64,
        /// The same length in the slanted one.
        slanted: f64,
    },
    /// A chart's axis ends before this value.
    #[error("{input}: entry {index} at {value} is not between {low} and {high}")]
    OutOfRange {
        /// What the value belongs to.
        input: Input,
        /// Which point, tick or span, from zero.
        index: usize,
        /// The value as given.
        value: f64,
        /// The low end of the axis.
        low: f64,
        /// The high end of the axis.
        high: f64,
    },
    /// What goes from a lower value to a higher one does not.
    #[error("{input}: entry {index} goes from {low} to {high}, which is not above")]
    NotAscending {
        /// The axis, the band or the veil.
        input: Input,
        /// Which place or span, from zero.
        index: usize,
        /// The value that should be the lower one.
        low: f64,
        /// The value that should be the higher one.
        high: f64,
    },
    /// The raster would have no pixel, or more than the renderer can hold.
    #[error("scale {scale} does not give a raster between 1 and {limit} pixels a side")]
    RasterSize {
        /// The scale asked for.
        scale: f64,
        /// The longest side allowed.
        limit: u32,
    },
    /// The picture has more elements than the renderer takes, which is a million; as SVG text
    /// it has no such limit.
    #[error("the picture has too many elements for a raster")]
    TooManyElements,
}
